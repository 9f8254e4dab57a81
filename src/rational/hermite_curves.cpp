// SPDX-License-Identifier: MIT
// The linear conditions of Hermite data, solved over the rationals.
#include "hodograph/rational/hermite_curves.hpp"

#include <cassert>
#include <string>
#include <utility>

#include "hodograph/rational/text.hpp"
#include "linear_algebra.hpp"

namespace hodograph {

namespace {

bool is_zero(const RationalVector& v) { return v == RationalVector{}; }

std::optional<Fault> data_fault(const SolutionSpace& space, const RationalHermiteData& data) {
  if (data.end <= data.begin) {
    return Fault{FaultCode::not_increasing,
                 "the interval [" + to_text(data.begin) + ", " + to_text(data.end) +
                     "] is empty; right would be begin < end",
                 std::nullopt,
                 "begin",
                 data.begin.to_double(),
                 data.end.to_double()};
  }
  for (const RealRoot& pole : real_roots(space.alpha())) {
    if (pole.compare(data.begin) < 0 || pole.compare(data.end) > 0) continue;
    return Fault{FaultCode::outside_domain,
                 "alpha has a root at t = " +
                     (pole.is_rational() ? to_text(pole.lower()) : to_text(pole.to_double())) +
                     ", within [" + to_text(data.begin) + ", " + to_text(data.end) +
                     "]; right would be an alpha whose roots lie outside it",
                 std::nullopt, "alpha", pole.to_double()};
  }
  const auto derivatives = {&data.begin_derivative, &data.end_derivative};
  std::size_t index = 0;
  for (const auto* derivative : derivatives) {
    if (derivative->has_value()) {
      const RationalVector& v = **derivative;
      const Rational& t = index == 0 ? data.begin : data.end;
      if (is_zero(v)) {
        return Fault{FaultCode::zero_speed,
                     "the derivative at t = " + to_text(t) +
                         " is 0; a curve without cusps has "
                         "speed there",
                     index, "derivative", 0.0};
      }
      const RationalVector f = value(space.indicatrix(), t);
      if (!is_zero(cross(v, f)) || dot(v, f).sign() <= 0) {
        return Fault{FaultCode::outside_domain,
                     "the derivative " + to_text(v) + " at t = " + to_text(t) +
                         " does not have the direction " + to_text(f) +
                         " that A gives there; right would be a positive multiple of it",
                     index, "derivative"};
      }
    }
    ++index;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Rational> equidistant(const Rational& begin, const Rational& end, std::size_t count) {
  assert(count >= 2);
  std::vector<Rational> nodes;
  const Rational step = (end - begin) / Rational(static_cast<std::int64_t>(count - 1));
  for (std::size_t k = 0; k < count; ++k) {
    nodes.push_back(begin + Rational(static_cast<std::int64_t>(k)) * step);
  }
  return nodes;
}

Rational taxicab_length(const RationalVector& v) {
  Rational sum;
  for (std::size_t c = 0; c < 3; ++c) sum += v[c].sign() < 0 ? -v[c] : v[c];
  return sum;
}

Result<HermiteCurves> HermiteCurves::create(const SolutionSpace& space, RationalHermiteData data) {
  if (auto fault = data_fault(space, data)) return *fault;
  HermiteCurves curves(space);
  curves.denominator_ = space.alpha() * space.radical();
  curves.denominator_sign_ = curves.denominator_.value(data.begin).sign();
  curves.norm_ = norm_polynomial(space.preimage());

  const VectorPolynomial& f = space.indicatrix();
  const std::size_t unknowns = space.dimension() - space.constant_dimension();
  const RationalPolynomial minus_two(-2);
  for (std::size_t i = 0; i < unknowns; ++i) {
    const VectorPolynomial& b = space.basis()[i];
    // λ = -2 μ / α², and h = λ α rad α.
    curves.solutions_.push_back(minus_two * b);
    curves.numerators_.push_back((minus_two * mu_of(b, space.alpha(), f) * space.radical()) /
                                 space.alpha());
  }

  // One row an equation: the end points, then the derivatives.
  const RationalVector chord = data.end_point - data.begin_point;
  const Rational at_begin = Rational(1) / space.alpha().value(data.begin);
  const Rational at_end = Rational(1) / space.alpha().value(data.end);
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<Rational> row;
    for (const VectorPolynomial& r : curves.solutions_) {
      row.push_back(at_end * r[c].value(data.end) - at_begin * r[c].value(data.begin));
    }
    row.push_back(chord[c]);
    curves.system_.push_back(std::move(row));
  }
  const auto derivative_row = [&](const RationalVector& v, const Rational& t) {
    const RationalVector there = value(f, t);
    const Rational scale = Rational(1) / curves.denominator_.value(t);
    std::vector<Rational> row;
    for (const RationalPolynomial& h : curves.numerators_) row.push_back(scale * h.value(t));
    row.push_back(dot(v, there) / dot(there, there));
    curves.system_.push_back(std::move(row));
  };
  if (data.begin_derivative) derivative_row(*data.begin_derivative, data.begin);
  if (data.end_derivative) derivative_row(*data.end_derivative, data.end);
  curves.equations_ = curves.system_.size();
  curves.data_ = std::move(data);

  auto solution = rational_detail::affine_solution(curves.system_, unknowns);
  curves.contradiction_ = std::move(solution.contradiction);
  if (!curves.solvable()) return curves;
  curves.particular_ = std::move(solution.particular);
  curves.directions_ = std::move(solution.directions);
  const auto combined = [&](const std::vector<Rational>& c) {
    RationalPolynomial h;
    for (std::size_t i = 0; i < unknowns; ++i) {
      if (!c[i].is_zero()) h += RationalPolynomial(c[i]) * curves.numerators_[i];
    }
    return h;
  };
  curves.particular_numerator_ = combined(curves.particular_);
  for (const auto& c : curves.directions_) curves.direction_numerators_.push_back(combined(c));
  return curves;
}

std::vector<Rational> HermiteCurves::coefficients(std::span<const Rational> x) const {
  assert(solvable() && x.size() == freedom());
  std::vector<Rational> c = particular_;
  for (std::size_t k = 0; k < x.size(); ++k) {
    for (std::size_t i = 0; i < c.size(); ++i) c[i] += x[k] * directions_[k][i];
  }
  return c;
}

RationalPolynomial HermiteCurves::lambda_numerator(std::span<const Rational> x) const {
  assert(solvable() && x.size() == freedom());
  RationalPolynomial h = particular_numerator_;
  for (std::size_t k = 0; k < x.size(); ++k) {
    h += RationalPolynomial(x[k]) * direction_numerators_[k];
  }
  return h;
}

RationalFunction HermiteCurves::lambda(std::span<const Rational> x) const {
  return {lambda_numerator(x), denominator_};
}
RationalFunction HermiteCurves::speed(std::span<const Rational> x) const {
  return {lambda_numerator(x) * norm_, denominator_};
}

std::vector<Rational> HermiteCurves::speeds(const Rational& t) const {
  assert(solvable());
  const Rational scale = norm_.value(t) / denominator_.value(t);
  std::vector<Rational> result = {scale * particular_numerator_.value(t)};
  for (const RationalPolynomial& h : direction_numerators_) result.push_back(scale * h.value(t));
  return result;
}

bool HermiteCurves::is_cusp_free(std::span<const Rational> x) const {
  const RationalPolynomial h = RationalPolynomial(denominator_sign_) * lambda_numerator(x);
  return !h.is_zero() && is_positive(h, data_.begin, data_.end);
}

RationalPhCurve HermiteCurves::curve(std::span<const Rational> x) const {
  const std::vector<Rational> c = coefficients(x);
  VectorPolynomial sum;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (!c[i].is_zero()) sum = sum + RationalPolynomial(c[i]) * solutions_[i];
  }
  const VectorFunction moving(sum, space_.alpha());
  const RationalVector shift = data_.begin_point - moving.value(data_.begin);
  const VectorFunction position =
      moving + VectorFunction({shift.x, shift.y, shift.z}, RationalPolynomial(1));
  return *RationalPhCurve::create(space_.preimage(), position);
}

std::vector<Rational> HermiteCurves::nearest_to_speed(const Rational& target,
                                                      std::span<const Rational> nodes) const {
  // Normal equations: Σ_t σ_j(t) (σ_0(t) + Σ_k x_k σ_k(t) - target) = 0.
  const std::size_t count = freedom();
  if (count == 0) return {};
  std::vector<std::vector<Rational>> normal(count, std::vector<Rational>(count + 1));
  for (const Rational& t : nodes) {
    const std::vector<Rational> s = speeds(t);
    for (std::size_t j = 0; j < count; ++j) {
      for (std::size_t k = 0; k < count; ++k) normal[j][k] += s[j + 1] * s[k + 1];
      normal[j][count] += s[j + 1] * (target - s[0]);
    }
  }
  return rational_detail::affine_solution(normal, count).particular;
}

}  // namespace hodograph
