// SPDX-License-Identifier: MIT
// A path as the models of control/ take it, that can also be asked at 40 digits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "hodograph/control/reference_path.hpp"
#include "hodograph/curve/ph_curve.hpp"
#include "tests/support/derivative_judge.hpp"

namespace hodograph::test {

/// Doubles and differentiating scalars go to the ReferencePath; 40 digits to curves of 40 digits
/// with the same preimages. By arc length ξ is found by Newton's method.
template <class A, std::size_t n>
class ExactReference : public ReferencePath<A> {
 public:
  using WideAlgebra = std::conditional_t<A::dimension == 2, Complex<Wide>, Quaternion<Wide>>;
  using WideCurve = PhCurve<WideAlgebra, n>;

  explicit ExactReference(const AnyPath& path, ProgressBy by = ProgressBy::xi)
      : ReferencePath<A>(ReferencePath<A>::of(path, by).value()) {
    const PathNumbers numbers = path.numbers();
    constexpr std::size_t dimension = point_t<A>::dimension;
    Wide length = 0;
    for (std::size_t s = 0; s + 1 < numbers.knots.size(); ++s) {
      BernsteinPolynomial<WideAlgebra, n> preimage;
      for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t k = 0; k < A::dimension; ++k) {
          preimage[i][k] = numbers.preimages[(s * (n + 1) + i) * A::dimension + k];
        }
      }
      point_t<WideAlgebra> start{};
      for (std::size_t k = 0; k < dimension; ++k) start[k] = numbers.starts[s * dimension + k];
      const Wide knot = numbers.knots[s];
      curves_.emplace_back(start, preimage, Wide(numbers.knots[s + 1]) - knot);
      begins_.push_back(by == ProgressBy::xi ? knot : length);
      length += curves_.back().arc_length();
    }
  }

  template <class S>
  ReferenceValue<A, S> on(const S& progress) const {
    if constexpr (std::is_same_v<S, Wide>) {
      const auto after = std::upper_bound(begins_.begin() + 1, begins_.end(), progress);
      const auto s = static_cast<std::size_t>(after - begins_.begin()) - 1;
      const WideCurve& curve = curves_[s];
      const bool by_xi = this->progress_by() == ProgressBy::xi;
      Wide u = (progress - begins_[s]) / (by_xi ? curve.parameter_step() : curve.arc_length());
      if (!by_xi) {
        constexpr int steps = 8;  // quadratic: 40 digits, and more, from one
        for (int step = 0; step < steps; ++step) {
          u += (progress - begins_[s] - curve.arc_length(u)) /
               (curve.parameter_step() * curve.speed(u));
        }
      }
      const auto jet = curve.template preimage_jet<1>(u);
      const Wide sigma = curve.speed(u);
      return {curve.position(u), euler_rodrigues_frame(jet),
              by_xi ? body_rate_per_xi(jet)[0] : body_rate_per_arc_length(jet)[0],
              by_xi ? sigma : Wide(1)};
    } else {
      return ReferencePath<A>::on(progress);
    }
  }

 private:
  std::vector<WideCurve> curves_;
  std::vector<Wide> begins_;
};

}  // namespace hodograph::test
