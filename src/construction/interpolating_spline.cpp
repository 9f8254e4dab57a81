// SPDX-License-Identifier: MIT
#include "hodograph/construction/interpolating_spline.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hodograph/construction/detail/banded_matrix.hpp"
#include "hodograph/construction/detail/points_on_knots.hpp"

namespace hodograph {
namespace {

using Points = std::vector<Vector3<double>>;

/// The p + 1 B-splines of degree p that do not vanish on [knots[span], knots[span + 1]), at t:
/// element k belongs to the control point span - p + k (Cox and de Boor).
template <std::size_t p>
std::array<double, p + 1> basis(const std::vector<double>& knots, std::size_t span, double t) {
  std::array<double, p + 1> values{};
  values[0] = 1.0;
  for (std::size_t degree = 1; degree <= p; ++degree) {
    double carried = 0.0;
    for (std::size_t k = 0; k < degree; ++k) {
      const double right = knots[span + k + 1], left = knots[span + 1 + k - degree];
      const double share = values[k] / (right - left);
      values[k] = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    values[degree] = carried;
  }
  return values;
}

/// The polynomial of the spline on [knots[span], knots[span + 1]] in Bernstein form: its
/// coefficients are the values of its polar form at the two ends, each taken i and p - i times.
template <std::size_t p>
BernsteinPolynomial<Vector3<double>, p> piece(const std::vector<double>& knots, std::size_t span,
                                              const Vector3<double>* control) {
  BernsteinPolynomial<Vector3<double>, p> result;
  for (std::size_t i = 0; i <= p; ++i) {
    std::array<Vector3<double>, p + 1> point;
    std::copy_n(control, p + 1, point.begin());
    for (std::size_t r = 1; r <= p; ++r) {
      const double t = r <= i ? knots[span + 1] : knots[span];
      for (std::size_t k = 0; k + r <= p; ++k) {
        const double left = knots[span - p + k + r], right = knots[span + k + 1];
        const double share = (t - left) / (right - left);
        point[k] = (1.0 - share) * point[k] + share * point[k + 1];
      }
    }
    result[i] = point[0];
  }
  return result;
}

Fault uneven_fault() {
  return {FaultCode::no_convergence,
          "the sample parameters are too uneven for a spline in double precision; drop samples "
          "that nearly coincide, or choose parameters closer to the distance travelled",
          std::nullopt,
          "parameters",
          std::nullopt,
          std::nullopt};
}

template <std::size_t p>
std::optional<Fault> sample_fault(std::span<const double> t,
                                  std::span<const Vector3<double>> points, SplineEnds ends) {
  if (auto fault = construction_detail::size_fault(points.size(), t.size(), "parameters")) {
    return fault;
  }
  const std::size_t least = ends == SplineEnds::periodic ? p + 2 : p + 1;
  if (points.size() < least) {
    return Fault{FaultCode::too_few,
                 "a spline of degree " + std::to_string(p) + " needs at least " +
                     std::to_string(least) + " samples; got " + std::to_string(points.size()),
                 std::nullopt,
                 "samples",
                 static_cast<double>(points.size()),
                 static_cast<double>(least)};
  }
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i]) || !is_finite(points[i])) {
      return Fault{FaultCode::not_finite,
                   "sample " + std::to_string(i) + " is not finite",
                   i,
                   "sample",
                   std::nullopt,
                   std::nullopt};
    }
    if (i > 0 && !(t[i - 1] < t[i])) {
      return Fault{FaultCode::not_increasing,
                   "sample parameters must increase strictly; sample " + std::to_string(i) +
                       " is at " + to_text(t[i]) + " after " + to_text(t[i - 1]),
                   i,
                   "parameter",
                   t[i],
                   t[i - 1]};
    }
  }
  if (ends == SplineEnds::periodic) {
    double extent = 0.0;
    for (const auto& q : points) extent = std::max(extent, largest_component(q - points[0]));
    const double gap = largest_component(points.back() - points.front());
    const double allowed = std::sqrt(epsilon<double>()) * extent;
    if (!(gap <= allowed)) {
      return Fault{FaultCode::not_continuous,
                   "a periodic curve must end where it began; the last sample is " + to_text(gap) +
                       " from the first, at most " + to_text(allowed) +
                       " is allowed (repeat the first sample at the end of the period)",
                   points.size() - 1,
                   "gap",
                   gap,
                   allowed};
    }
  }
  return std::nullopt;
}

/// Knots of the open spline: the samples without the (p - 1)/2 next to each end, ends p + 1 fold.
template <std::size_t p>
std::vector<double> open_knots(std::span<const double> t) {
  constexpr std::size_t skipped = (p - 1) / 2;
  std::vector<double> knots(p + 1, t.front());
  for (std::size_t i = 1 + skipped; i + 1 + skipped < t.size(); ++i) knots.push_back(t[i]);
  knots.insert(knots.end(), p + 1, t.back());
  return knots;
}

/// Control points of the open spline; nothing when the system breaks down.
template <std::size_t p>
std::optional<Points> open_control(const std::vector<double>& knots, std::span<const double> t,
                                   std::span<const Vector3<double>> points) {
  spline_detail::BandedMatrix matrix(points.size(), p);
  std::size_t span = p;
  for (std::size_t i = 0; i < t.size(); ++i) {
    while (span + p + 2 < knots.size() && knots[span + 1] <= t[i]) ++span;
    const auto values = basis<p>(knots, span, t[i]);
    for (std::size_t k = 0; k <= p; ++k) {
      if (values[k] != 0.0) matrix.at(i, span - p + k) = values[k];
    }
  }
  if (!matrix.factor()) return std::nullopt;
  Points control(points.begin(), points.end());
  matrix.solve(control);
  return control;
}

/// Knots of the periodic spline: the samples of three periods' worth around the one given.
template <std::size_t p>
std::vector<double> periodic_knots(std::span<const double> t) {
  const std::size_t intervals = t.size() - 1;
  const double period = t.back() - t.front();
  std::vector<double> knots;
  for (std::size_t i = 0; i < p; ++i) knots.push_back(t[intervals - p + i] - period);
  knots.insert(knots.end(), t.begin(), t.end());
  for (std::size_t i = 1; i <= p; ++i) knots.push_back(t[i] + period);
  return knots;
}

/// Control points of the periodic spline, the first p repeated at the end. Unknown i is centred
/// on sample i; the last `border` unknowns are eliminated by a small dense system, the rest banded.
template <std::size_t p>
std::optional<Points> periodic_control(const std::vector<double>& knots, std::span<const double> t,
                                       std::span<const Vector3<double>> points) {
  constexpr std::size_t half = (p - 1) / 2;  // at a knot, unknowns i - half ... i + half
  constexpr std::size_t border = p - 1;
  const std::size_t size = t.size() - 1, inner = size - border;
  // Row i in cyclic columns i - half ... i + half.
  const auto row = [&](std::size_t i) { return basis<p>(knots, p + i, t[i]); };
  spline_detail::BandedMatrix matrix(inner, p);
  std::vector<std::vector<double>> right(inner, std::vector<double>(border));
  std::vector<std::vector<double>> below(border, std::vector<double>(inner));
  std::array<std::array<double, border>, border> corner{};
  for (std::size_t i = 0; i < size; ++i) {
    const auto values = row(i);
    for (std::size_t k = 0; k < p; ++k) {
      const std::size_t j = (i + k + size - half) % size;
      if (i < inner && j < inner) {
        if (!matrix.inside(i, j)) return std::nullopt;
        matrix.at(i, j) = values[k];
      } else if (i < inner) {
        right[i][j - inner] = values[k];
      } else if (j < inner) {
        below[i - inner][j] = values[k];
      } else {
        corner[i - inner][j - inner] = values[k];
      }
    }
  }
  if (!matrix.factor()) return std::nullopt;
  Points x(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(inner));
  matrix.solve(x);
  // Columns B⁻¹ right, then the Schur complement corner - below B⁻¹ right, solved with pivoting.
  std::vector<std::vector<double>> columns(border, std::vector<double>(inner));
  for (std::size_t j = 0; j < border; ++j) {
    for (std::size_t i = 0; i < inner; ++i) columns[j][i] = right[i][j];
    matrix.solve(columns[j]);
  }
  std::array<Vector3<double>, border> y;
  for (std::size_t r = 0; r < border; ++r) {
    y[r] = points[inner + r];
    for (std::size_t i = 0; i < inner; ++i) {
      if (below[r][i] == 0.0) continue;
      y[r] -= below[r][i] * x[i];
      for (std::size_t j = 0; j < border; ++j) corner[r][j] -= below[r][i] * columns[j][i];
    }
  }
  for (std::size_t k = 0; k < border; ++k) {
    std::size_t pivot = k;
    for (std::size_t r = k + 1; r < border; ++r) {
      if (std::abs(corner[r][k]) > std::abs(corner[pivot][k])) pivot = r;
    }
    std::swap(corner[k], corner[pivot]);
    std::swap(y[k], y[pivot]);
    if (corner[k][k] == 0.0) return std::nullopt;
    for (std::size_t r = k + 1; r < border; ++r) {
      const double factor = corner[r][k] / corner[k][k];
      for (std::size_t j = k; j < border; ++j) corner[r][j] -= factor * corner[k][j];
      y[r] -= factor * y[k];
    }
  }
  for (std::size_t k = border; k-- > 0;) {
    for (std::size_t j = k + 1; j < border; ++j) y[k] -= corner[k][j] * y[j];
    y[k] = (1.0 / corner[k][k]) * y[k];
  }
  Points unknown(size);
  for (std::size_t i = 0; i < inner; ++i) {
    unknown[i] = x[i];
    for (std::size_t j = 0; j < border; ++j) unknown[i] -= columns[j][i] * y[j];
  }
  for (std::size_t r = 0; r < border; ++r) unknown[inner + r] = y[r];
  // Control point c belongs to unknown c - half (cyclically): span p + i uses i ... i + p.
  Points control(size + p);
  for (std::size_t c = 0; c < control.size(); ++c) {
    control[c] = unknown[(c + size - half) % size];
  }
  return control;
}

}  // namespace

template <std::size_t p>
Result<InterpolatingSpline<p>> InterpolatingSpline<p>::through(
    std::span<const double> parameters, std::span<const Vector3<double>> points, SplineEnds ends) {
  if (auto fault = sample_fault<p>(parameters, points, ends)) return *fault;
  InterpolatingSpline spline;
  spline.periodic_ = ends == SplineEnds::periodic;
  const auto knots = spline.periodic_ ? periodic_knots<p>(parameters) : open_knots<p>(parameters);
  const auto control = spline.periodic_ ? periodic_control<p>(knots, parameters, points)
                                        : open_control<p>(knots, parameters, points);
  if (!control) return uneven_fault();
  for (std::size_t span = p; span + p + 1 < knots.size(); ++span) {
    spline.breakpoints_.push_back(knots[span]);
    spline.pieces_.push_back(piece<p>(knots, span, control->data() + (span - p)));
    for (const auto& c : spline.pieces_.back().coefficients()) {
      if (!is_finite(c)) return uneven_fault();
    }
  }
  spline.breakpoints_.push_back(parameters.back());
  spline.index_ = IntervalIndex<double>(spline.breakpoints_);
  return spline;
}

template <std::size_t p>
HermitePoint<4> InterpolatingSpline<p>::operator()(double t) const {
  if (!(begin() <= t && t <= end())) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the spline parameter " + to_text(t) + " is outside [" + to_text(begin()) +
                          ", " + to_text(end()) + "]",
                      std::nullopt, "parameter", t, t < begin() ? begin() : end()});
  }
  const std::size_t k = index_.find(breakpoints_, t);
  const double h = breakpoints_[k + 1] - breakpoints_[k];
  const double u = (t - breakpoints_[k]) / h;
  auto derivatives = pieces_[k].template jet<4>(u < 1.0 ? u : 1.0);
  double scale = 1.0;
  for (std::size_t r = 1; r <= 4; ++r) {
    scale /= h;
    derivatives[r] = scale * derivatives[r];
  }
  return derivatives;
}

template class InterpolatingSpline<5>;
template class InterpolatingSpline<7>;

}  // namespace hodograph
