// SPDX-License-Identifier: MIT
// The axis of a helical path, from the coefficients of its hodograph; its plan, from those of its
// preimage.
#include "hodograph/path/helix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hodograph {

Vector3<double> unit_axis(const Vector3<double>& axis) {
  const int exponent = path_detail::exponent_of(largest_component(axis));
  const Vector3<double> sized{std::ldexp(axis.x, -exponent), std::ldexp(axis.y, -exponent),
                              std::ldexp(axis.z, -exponent)};
  return (1.0 / norm(sized)) * sized;
}

Quaternion<double> turn_upright(const Vector3<double>& axis) {
  const Vector3<double> a = unit_axis(axis);
  const Vector3<double> level{axis.x, axis.y, 0.0};
  if (largest_component(level) == 0.0) {
    return a.z < 0.0 ? Quaternion<double>{0.0, 1.0, 0.0, 0.0}
                     : Quaternion<double>{1.0, 0.0, 0.0, 0.0};
  }
  // cos and sin of half the angle β between a and k, from cos β and sin β.
  const double sine = std::hypot(a.x, a.y);
  const double up = a.z < 0.0 ? sine / (1.0 - a.z) : 1.0 + a.z, side = a.z < 0.0 ? 1.0 : sine;
  const double size = std::hypot(up, side);
  const Vector3<double> along = unit_axis(level);
  return {up / size, (side / size) * along.y, -(side / size) * along.x, 0.0};
}

namespace path_detail {
namespace {

constexpr double helix_rounding = accuracy::join_error<double>();

/// The columns of an m by 3 matrix made orthogonal by rotations (one-sided Jacobi): the columns of
/// `turn` are the right singular vectors, the norms of the columns the singular values.
void orthogonalise(std::vector<Vector3<double>>& rows, std::array<Vector3<double>, 3>& turn) {
  turn = {Vector3<double>{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  constexpr int most_sweeps = 32;  // quadratic convergence: six or seven are needed
  bool rotated = true;
  for (int sweep = 0; sweep < most_sweeps && rotated; ++sweep) {
    rotated = false;
    for (std::size_t p = 0; p < 2; ++p) {
      for (std::size_t q = p + 1; q < 3; ++q) {
        double pp = 0.0, qq = 0.0, pq = 0.0;
        for (const auto& row : rows) {
          pp += row[p] * row[p];
          qq += row[q] * row[q];
          pq += row[p] * row[q];
        }
        if (!(std::abs(pq) > epsilon<double>() * std::sqrt(pp) * std::sqrt(qq))) continue;
        rotated = true;
        const double zeta = (qq - pp) / (2.0 * pq);
        const double t = std::copysign(1.0, zeta) / (std::abs(zeta) + std::hypot(1.0, zeta));
        const double c = 1.0 / std::hypot(1.0, t), s = c * t;
        for (auto& row : rows) {
          const double x = row[p], y = row[q];
          row[p] = c * x - s * y;
          row[q] = s * x + c * y;
        }
        const Vector3<double> u = turn[p], v = turn[q];
        turn[p] = c * u - s * v;
        turn[q] = s * u + c * v;
      }
    }
  }
}

/// The sines of the segments about an axis, and the largest residual.
double residual_of(std::span<const std::array<double, 4>> rows, std::size_t rows_a_segment,
                   const Vector3<double>& axis, std::vector<double>& sines) {
  sines.clear();
  double worst = 0.0;
  for (std::size_t begin = 0; begin < rows.size(); begin += rows_a_segment) {
    const auto segment = rows.subspan(begin, rows_a_segment);
    double square = 0.0, product = 0.0;
    for (const auto& row : segment) {
      square += row[3] * row[3];
      product += row[3] * (axis.x * row[0] + axis.y * row[1] + axis.z * row[2]);
    }
    const double sine = square > 0.0 ? product / square : 0.0;
    for (const auto& row : segment) {
      const double along = axis.x * row[0] + axis.y * row[1] + axis.z * row[2];
      worst = std::max(worst, std::abs(along - sine * row[3]));
    }
    sines.push_back(std::clamp(sine, -1.0, 1.0));
  }
  return worst;
}

Vector3<double> in_upper_half(const Vector3<double>& axis) {
  for (const std::size_t i : {2U, 1U, 0U}) {
    if (std::abs(axis[i]) > helix_rounding) return axis[i] < 0.0 ? -axis : axis;
  }
  return axis;
}

/// The axis for rows (x, y, z, σ), `rows_a_segment` for every segment, each segment's in units of
/// its largest |A_i|²; `sines` is filled with one sin θ a segment.
HelixFit fit_axis(std::span<const std::array<double, 4>> rows, std::size_t rows_a_segment,
                  std::vector<double>& sines) {
  // What is left of r' when the multiple of σ that fits best is taken off, segment by segment.
  std::vector<Vector3<double>> left;
  left.reserve(rows.size());
  for (std::size_t begin = 0; begin < rows.size(); begin += rows_a_segment) {
    const auto segment = rows.subspan(begin, rows_a_segment);
    double square = 0.0;
    Vector3<double> product{};
    for (const auto& row : segment) {
      square += row[3] * row[3];
      product += row[3] * Vector3<double>{row[0], row[1], row[2]};
    }
    const Vector3<double> mean = square > 0.0 ? (1.0 / square) * product : Vector3<double>{};
    for (const auto& row : segment) {
      left.push_back(Vector3<double>{row[0], row[1], row[2]} - row[3] * mean);
    }
  }
  std::array<Vector3<double>, 3> turn;
  orthogonalise(left, turn);
  std::array<double, 3> size{};
  HelixFit fit;
  std::size_t least = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    for (const auto& row : left) size[j] = std::max(size[j], std::abs(row[j]));
    if (size[j] < size[least]) least = j;
    if (size[j] <= helix_rounding) ++fit.freedom;
  }
  fit.axis = in_upper_half(turn[least]);
  fit.residual = residual_of(rows, rows_a_segment, fit.axis, sines);
  const Vector3<double> up{0.0, 0.0, 1.0};
  std::vector<double> about_up;
  const double residual = residual_of(rows, rows_a_segment, up, about_up);
  if (residual <= helix_rounding) {
    fit.axis = up;
    fit.residual = residual;
    fit.freedom = std::max<std::size_t>(fit.freedom, 1);
    sines = std::move(about_up);
  }
  return fit;
}

std::vector<HelixStretch> stretches_of(std::span<const double> sines) {
  std::vector<HelixStretch> stretches;
  for (std::size_t k = 0; k < sines.size(); ++k) {
    const bool same =
        !stretches.empty() && std::abs(sines[k] - stretches.back().sine) <= 2.0 * helix_rounding;
    if (same) {
      stretches.back().last = k;
    } else {
      stretches.push_back({k, k, sines[k], {}});
    }
  }
  return stretches;
}

/// The coefficients of one segment's preimage, in units of a power of two.
std::vector<Quaternion<double>> preimage_of(const PathNumbers& path, std::size_t segment) {
  const std::size_t count = path.preimage_degree + 1;
  std::vector<Quaternion<double>> a(count);
  double size = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double* numbers = path.preimages.data() + (segment * count + i) * 4;
    a[i] = {numbers[0], numbers[1], numbers[2], numbers[3]};
    size = std::max(size, largest_component(a[i]));
  }
  const int exponent = exponent_of(size);
  for (auto& q : a) {
    for (std::size_t j = 0; j < 4; ++j) q[j] = std::ldexp(q[j], -exponent);
  }
  return a;
}

/// The Bernstein coefficients of form(A, A).
template <class V, class A, class Form>
std::vector<V> squared(const std::vector<A>& a, const Form& form) {
  const std::size_t n = a.size() - 1;
  std::vector<V> result(2 * n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= n; ++j) {
      using S = typename A::Scalar;
      const S weight = S(static_cast<double>(binomial(n, i) * binomial(n, j))) /
                       S(static_cast<double>(binomial(2 * n, i + j)));
      result[i + j] = result[i + j] + weight * form(a[i], a[j]);
    }
  }
  return result;
}

using EnclosedPreimage = std::vector<Quaternion<Enclosure>>;

/// The two halves of a polynomial, by de Casteljau's scheme.
std::pair<EnclosedPreimage, EnclosedPreimage> halves(EnclosedPreimage a) {
  const Enclosure half(0.5);
  EnclosedPreimage left, right(a.size());
  for (std::size_t last = a.size(); last-- > 0;) {
    left.push_back(a[0]);
    right[last] = a[last];
    for (std::size_t i = 0; i < last; ++i) a[i] = half * (a[i] + a[i + 1]);
  }
  return {std::move(left), std::move(right)};
}

/// Encloses along/speed by its coefficients, on halves where that helps.
Enclosure enclosed_sine(const EnclosedPreimage& a, const Vector3<Enclosure>& axis, int depth) {
  constexpr double most_variation = 256.0;  // of σ within a piece
  constexpr int deepest = 24;
  const auto speed =
      squared<Enclosure>(a, [](const auto& x, const auto& y) { return speed_form(x, y); });
  double least = speed[0].lower(), most = 0.0;
  for (const Enclosure& s : speed) {
    least = std::min(least, s.lower());
    most = std::max(most, s.upper());
  }
  const bool even = most <= most_variation * least;
  if (!even && depth < deepest) {
    const auto [left, right] = halves(a);
    return Enclosure::hull(enclosed_sine(left, axis, depth + 1),
                           enclosed_sine(right, axis, depth + 1));
  }
  if (!(least > 0.0)) return Enclosure::whole_line();
  const auto hodograph = squared<Vector3<Enclosure>>(
      a, [](const auto& x, const auto& y) { return hodograph_form(x, y); });
  // min v_i/g_i ≤ v/g ≤ max v_i/g_i where all g_i > 0.
  std::optional<Enclosure> range;
  for (std::size_t i = 0; i < speed.size(); ++i) {
    const Enclosure value = dot(axis, hodograph[i]) / speed[i];
    range = range ? Enclosure::hull(*range, value) : value;
  }
  return *range;
}

}  // namespace

std::optional<Fault> axis_fault(const Vector3<double>& axis) {
  if (!is_finite(axis)) {
    return Fault{FaultCode::not_finite, "the helix axis is not finite",
                 std::nullopt,          "axis",
                 std::nullopt,          std::nullopt};
  }
  if (largest_component(axis) == 0.0) {
    return Fault{FaultCode::outside_domain,
                 "the helix axis is zero; give it a vector with a length",
                 std::nullopt,
                 "axis",
                 0.0,
                 std::nullopt};
  }
  return std::nullopt;
}

// With U A = α + β j (α, β complex in 1 and k), the decomposition says α = W λ, β = W μ with one
// polynomial W and constants λ, μ: a matrix of rank one. Then w = κ W with κ² = λ² - μ², and
// λ/κ = c cos η - i d sin η, μ/κ = d cos η - i c sin η, η half of the roll.
Result<PlanFit> fit_plan(std::span<const Quaternion<double>> upright,
                         std::span<Complex<double>> plan) {
  using C = Complex<double>;
  const auto alpha = [&](std::size_t i) { return C{upright[i].w, upright[i].z}; };
  const auto beta = [&](std::size_t i) { return C{upright[i].y, -upright[i].x}; };
  double aa = 0.0, bb = 0.0;
  C ab{};  // Σ conj(α) β
  for (std::size_t i = 0; i < upright.size(); ++i) {
    aa += dot(alpha(i), alpha(i));
    bb += dot(beta(i), beta(i));
    ab += conjugate(alpha(i)) * beta(i);
  }
  // The dominant right singular vector (conj λ, conj μ) of [α β]: the larger of the two columns of
  // the projection onto it, each to full accuracy for a matrix of rank one.
  C lambda = aa >= bb ? C{aa, 0.0} : conjugate(ab);
  C mu = aa >= bb ? ab : C{bb, 0.0};
  const double size = std::sqrt(dot(lambda, lambda) + dot(mu, mu));
  if (!(size > 0.0)) {
    return Fault{FaultCode::outside_domain,
                 "a curve that stands still has no direction",
                 std::nullopt,
                 "speed",
                 0.0,
                 std::nullopt};
  }
  lambda = (1.0 / size) * lambda;
  mu = (1.0 / size) * mu;
  PlanFit fit;
  double largest = 0.0;
  for (std::size_t i = 0; i < upright.size(); ++i) {
    plan[i] = alpha(i) * conjugate(lambda) + beta(i) * conjugate(mu);
    const C a = alpha(i) - plan[i] * lambda, b = beta(i) - plan[i] * mu;
    fit.residual = std::max(fit.residual, std::sqrt(dot(a, a) + dot(b, b)));
    largest = std::max(largest, dot(upright[i], upright[i]));
  }
  fit.residual /= std::sqrt(largest);
  fit.sine = std::clamp(-2.0 * (lambda.re * mu.re + lambda.im * mu.im), -1.0, 1.0);
  if (!(fit.residual <= helix_rounding)) {
    return Fault{FaultCode::unsupported,
                 "the preimage is not that of a helix in reduced form about this axis: it deviates "
                 "by " +
                     to_text(fit.residual) + " of its size, where " + to_text(helix_rounding) +
                     " is rounding",
                 std::nullopt,
                 "residual",
                 fit.residual,
                 helix_rounding};
  }
  const C square = (lambda - mu) * (lambda + mu);
  fit.cosine = std::sqrt(dot(square, square));
  if (!(fit.cosine > helix_rounding)) {
    return Fault{FaultCode::outside_domain,
                 "the curve runs along the axis: seen from there it has no plan",
                 std::nullopt,
                 "cosine of the climb angle",
                 fit.cosine,
                 helix_rounding};
  }
  // √square, the root with the larger part first.
  const double main = std::sqrt(0.5 * (fit.cosine + std::abs(square.re)));
  const double other = 0.5 * std::abs(square.im) / main;
  const bool backward = square.re < 0.0;
  const C kappa{backward ? other : main, std::copysign(backward ? main : other, square.im)};
  for (C& w : plan) w = kappa * w;
  const C over = (1.0 / fit.cosine) * conjugate(kappa);  // 1/κ
  const double half = std::atan2(-(mu * over).im, (lambda * over).re);
  fit.roll = 2.0 * half;
  return fit;
}

}  // namespace path_detail

HelixFit recognised_helix(const PathNumbers& path) {
  const std::size_t segments = path.knots.size() - 1, n = path.preimage_degree;
  std::vector<std::array<double, 4>> rows;
  rows.reserve(segments * (2 * n + 1));
  for (std::size_t k = 0; k < segments; ++k) {
    const auto a = path_detail::preimage_of(path, k);
    double most = 0.0;
    for (const auto& q : a) most = std::max(most, dot(q, q));
    const double unit = most > 0.0 ? 1.0 / most : 1.0;
    const auto hodograph = path_detail::squared<Vector3<double>>(
        a, [](const auto& x, const auto& y) { return hodograph_form(x, y); });
    const auto speed = path_detail::squared<double>(
        a, [](const auto& x, const auto& y) { return speed_form(x, y); });
    for (std::size_t i = 0; i <= 2 * n; ++i) {
      rows.push_back(
          {unit * hodograph[i].x, unit * hodograph[i].y, unit * hodograph[i].z, unit * speed[i]});
    }
  }
  std::vector<double> sines;
  HelixFit fit = path_detail::fit_axis(rows, 2 * n + 1, sines);
  fit.stretches = path_detail::stretches_of(sines);
  for (HelixStretch& stretch : fit.stretches) {
    stretch.sine_range = sine_range(path, fit.axis, stretch.first, stretch.last);
  }
  return fit;
}

Enclosure sine_range(const PathNumbers& path, const Vector3<double>& axis, std::size_t first,
                     std::size_t last) {
  const Vector3<Enclosure> enclosed_axis = path_detail::enclosed(axis);
  std::optional<Enclosure> range;
  for (std::size_t k = first; k <= last; ++k) {
    path_detail::EnclosedPreimage a;
    for (const auto& q : path_detail::preimage_of(path, k)) a.push_back(path_detail::enclosed(q));
    const Enclosure here = path_detail::enclosed_sine(a, enclosed_axis, 0);
    range = range ? Enclosure::hull(*range, here) : here;
  }
  return *range;
}

}  // namespace hodograph
