// SPDX-License-Identifier: MIT
#include "hodograph/control/reference_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/foundation/accuracy.hpp"
#include "path_coefficients.hpp"
#include "reference_jet.hpp"

namespace hodograph {
namespace {

// For every power k: the factor of the Bernstein coefficient i in that of x^k, x = 2u - 1; row k.
//   B_i^n = C(n, i) (1 + x)^i (1 - x)^(n - i) / 2^n
std::vector<long double> powers_from_bernstein(std::size_t n) {
  std::vector<long double> factors((n + 1) * (n + 1), 0.0L);
  for (std::size_t i = 0; i <= n; ++i) {
    std::vector<long double> product{static_cast<long double>(binomial(n, i)) *
                                     std::ldexp(1.0L, -static_cast<int>(n))};
    for (std::size_t j = 0; j < n; ++j) {
      const long double sign = j < i ? 1.0L : -1.0L;
      product.push_back(0.0L);
      for (std::size_t k = product.size() - 1; k > 0; --k) product[k] += sign * product[k - 1];
    }
    for (std::size_t k = 0; k <= n; ++k) factors[k * (n + 1) + i] = product[k];
  }
  return factors;
}

// Coefficient k of powers, of the Bernstein coefficients c(0), ..., c(n).
template <class Coefficient>
double power_coefficient(const std::vector<long double>& factors, std::size_t n, std::size_t k,
                         const Coefficient& c) {
  long double sum = 0.0L;
  for (std::size_t i = 0; i <= n; ++i) {
    sum += factors[k * (n + 1) + i] * static_cast<long double>(c(i));
  }
  return static_cast<double>(sum);
}

template <class A>
constexpr std::size_t components = A::dimension;

// Whether the preimage at the end is that at the start, or its negative: then the frame closes.
template <class A>
bool frame_closes(const PathNumbers& numbers) {
  if (components<A> == 2) return true;
  const std::size_t last = numbers.preimages.size() - components<A>;
  double size = 0.0, same = 0.0, opposite = 0.0;
  for (std::size_t i = 0; i < components<A>; ++i) {
    const double a = numbers.preimages[i], b = numbers.preimages[last + i];
    size = std::max({size, std::abs(a), std::abs(b)});
    same = std::max(same, std::abs(a - b));
    opposite = std::max(opposite, std::abs(a + b));
  }
  return std::min(same, opposite) <= accuracy::join_error<double>() * size;
}

/// Which segment a number lies in, between the marks of the segments' ends; outside them the first
/// or the last. Looked for from `near` on, a few segments.
std::size_t segment_of(double progress, const std::vector<double>& marks, std::size_t near) {
  const std::size_t last = marks.size() - 2;
  if (near == 0 || marks[near] <= progress) {
    constexpr std::size_t few = 4;
    for (std::size_t k = near; k <= std::min(last, near + few); ++k) {
      if (progress < marks[k + 1]) return k;
    }
  }
  const auto after = std::upper_bound(marks.begin() + 1, marks.end() - 1, progress);
  return static_cast<std::size_t>(after - marks.begin()) - 1;
}

}  // namespace

using control_detail::row;

template <class A>
Result<ReferencePath<A>> ReferencePath<A>::of(const AnyPath& path, ProgressBy progress) {
  constexpr std::size_t dimension = point_t<A>::dimension;
  if (path.dimension() != dimension) {
    return Fault{FaultCode::unsupported,
                 std::string("a path ") + (dimension == 2 ? "in the plane" : "in space") +
                     " is needed; this one is " + (dimension == 2 ? "in space" : "in the plane"),
                 std::nullopt,
                 "dimension",
                 static_cast<double>(path.dimension()),
                 static_cast<double>(dimension)};
  }
  const PathNumbers numbers = path.numbers();
  const std::vector<double> integrals = control_detail::integral_coefficients(path);
  ReferencePath result;
  const std::size_t n = result.degree_ = numbers.preimage_degree;
  result.knots_ = numbers.knots;
  result.progress_by_ = progress;
  result.begins_ = progress == ProgressBy::xi ? numbers.knots : path.knot_arc_lengths();
  result.periodic_ = numbers.closed && frame_closes<A>(numbers);
  const std::size_t segments = path.segment_count(), m = 2 * n + 1;
  const auto of_preimage = powers_from_bernstein(n), of_position = powers_from_bernstein(m);
  for (std::size_t s = 0; s < segments; ++s) {
    result.inverses_.push_back(2.0 / (numbers.knots[s + 1] - numbers.knots[s]));
    const double* const preimage = numbers.preimages.data() + s * (n + 1) * components<A>;
    const double* const integral = integrals.data() + s * (m + 1) * (dimension + 1);
    for (std::size_t k = 0; k <= n; ++k) {
      std::array<double, row> a{};
      for (std::size_t i = 0; i < components<A>; ++i) {
        a[i] = power_coefficient(of_preimage, n, k,
                                 [&](std::size_t j) { return preimage[j * components<A> + i]; });
      }
      result.preimages_.insert(result.preimages_.end(), a.begin(), a.end());
    }
    for (std::size_t k = 0; k <= m; ++k) {
      std::array<double, row> p{};
      for (std::size_t i = 0; i <= dimension; ++i) {
        p[i] = power_coefficient(of_position, m, k,
                                 [&](std::size_t j) { return integral[j * (dimension + 1) + i]; });
        if (k == 0 && i < dimension) p[i] += numbers.starts[s * dimension + i];
      }
      result.integrals_.insert(result.integrals_.end(), p.begin(), p.end());
    }
  }
  return result;
}

template <class A>
double ReferencePath<A>::periods(double progress, const std::vector<double>& marks) const {
  if (!periodic_ || (marks.front() <= progress && progress <= marks.back())) return 0.0;
  return std::floor((progress - marks.front()) / (marks.back() - marks.front()));
}

template <class A>
double ReferencePath<A>::length_at(std::size_t segment, double x, double* slope) const {
  const std::size_t m = 2 * degree_ + 1;
  const double* const c =
      integrals_.data() + segment * (m + 1) * row + point_t<A>::dimension;  // of the first length
  double value = c[m * row], derivative = 0.0;
  for (std::size_t k = m; k-- > 0;) {
    derivative = x * derivative + value;
    value = x * value + c[k * row];
  }
  if (slope != nullptr) *slope = derivative;
  return value;
}

template <class A>
auto ReferencePath<A>::locate(double progress, std::size_t near) const -> Place {
  progress -= periods(progress, begins_) * (begins_.back() - begins_.front());
  const std::size_t segment = segment_of(progress, begins_, near);
  const double inverse = inverses_[segment], into = progress - begins_[segment];
  if (progress_by_ == ProgressBy::xi) return {segment, into * inverse - 1.0, inverse};
  // From the evenly fast place; the speed of a segment is bounded, so a few steps settle. What lies
  // far beyond the ends is left to the first steps' straight lines.
  constexpr int most_steps = 30;
  constexpr double settled = 4.0 * std::numeric_limits<double>::epsilon();
  double x = 2.0 * into / (begins_[segment + 1] - begins_[segment]) - 1.0;
  for (int step = 0; step < most_steps; ++step) {
    double slope = 0.0;
    const double move = (into - length_at(segment, x, &slope)) / slope;
    if (!(std::abs(move) <= 2.0)) break;
    x += move;
    if (std::abs(move) <= settled) break;
  }
  return {segment, x, inverse};
}

template <class A>
double ReferencePath<A>::xi_of(double progress) const {
  if (progress_by_ == ProgressBy::xi) return progress;
  const Place at = locate(progress);
  return knots_[at.segment] + (1.0 + at.x) / at.inverse +
         periods(progress, begins_) * (knots_.back() - knots_.front());
}

template <class A>
double ReferencePath<A>::progress_of(double xi) const {
  if (progress_by_ == ProgressBy::xi) return xi;
  const double laps = periods(xi, knots_);
  const double within = xi - laps * (knots_.back() - knots_.front());
  const std::size_t segment = segment_of(within, knots_, 0);
  const double x = 2.0 * (within - knots_[segment]) / (knots_[segment + 1] - knots_[segment]) - 1.0;
  return begins_[segment] + length_at(segment, x, nullptr) +
         laps * (begins_.back() - begins_.front());
}

template <class A>
template <std::size_t K>
PreimageJet<A, K> ReferencePath<A>::preimage_jet(const Place& at) const {
  const double* const c = preimages_.data() + at.segment * (degree_ + 1) * row;
  const auto coefficient = [c](std::size_t k) {
    A a;
    for (std::size_t i = 0; i < A::dimension; ++i) a[i] = c[k * row + i];
    return a;
  };
  PreimageJet<A, K> jet{};
  jet[0] = coefficient(degree_);
  for (std::size_t k = degree_; k-- > 0;) {  // Horner's rule, for the Taylor coefficients
    for (std::size_t r = K; r > 0; --r) jet[r] = at.x * jet[r] + jet[r - 1];
    jet[0] = at.x * jet[0] + coefficient(k);
  }
  double scale = at.inverse;
  for (std::size_t r = 1; r <= K; ++r) {
    if (r > 1) scale *= static_cast<double>(r) * at.inverse;
    jet[r] = scale * jet[r];
  }
  return jet;
}

template <class A>
point_t<A> ReferencePath<A>::position(const Place& at) const {
  const std::size_t m = 2 * degree_ + 1;
  const double* const c = integrals_.data() + at.segment * (m + 1) * row;
  point_t<A> p;
  for (std::size_t i = 0; i < p.dimension; ++i) p[i] = c[m * row + i];
  for (std::size_t k = m; k-- > 0;) {
    for (std::size_t i = 0; i < p.dimension; ++i) p[i] = at.x * p[i] + c[k * row + i];
  }
  return p;
}

template <class A>
ReferenceJet<A> ReferencePath<A>::at(double progress) const {
  const Place place = locate(progress);
  return control_detail::reference_jet(preimage_jet<3>(place), position(place), progress_by_);
}

template <class A>
ReferenceValue<A, double> ReferencePath<A>::value(double progress) const {
  const Place place = locate(progress);
  const PreimageJet<A, 1> jet = preimage_jet<1>(place);
  const double sigma = speed_form(jet[0], jet[0]);
  if (progress_by_ == ProgressBy::xi) {
    return {position(place), euler_rodrigues_frame(jet), body_rate_per_xi(jet)[0], sigma};
  }
  return {position(place), euler_rodrigues_frame(jet), body_rate_per_arc_length(jet)[0], 1.0};
}

template class ReferencePath<Complex<double>>;
template class ReferencePath<Quaternion<double>>;

}  // namespace hodograph
