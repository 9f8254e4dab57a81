// SPDX-License-Identifier: MIT
#include "hodograph/construction/any_lift.hpp"

#include <string>

#include "hodograph/construction/lift.hpp"
#include "hodograph/path/helix.hpp"

namespace hodograph {

namespace {

Fault of_other_dimension(const char* sentence, std::size_t dimension) {
  return {FaultCode::unsupported,         sentence,    std::nullopt, "dimension",
          static_cast<double>(dimension), std::nullopt};
}

template <std::size_t n>
Result<HelicalPlan> plan_of(const SpatialPhCurve<n>& curve, const Vector3<double>& axis) {
  const auto found = helical_decomposition(curve, axis);
  if (!found) return found.fault();
  const auto& plan = found->plan.coefficients();
  return HelicalPlan{
      found->axis, found->sine,    found->cosine, found->upright, {plan.begin(), plan.end()},
      found->roll, found->residual};
}

}  // namespace

Result<AnyPath> lifted(const AnyPath& plan, double altitude, std::span<const double> slopes) {
  return plan.visit([&]<class P>(const P& p) -> Result<AnyPath> {
    if constexpr (P::Point::dimension == 2) {
      auto made = lifted(p, altitude, slopes);
      if (!made) return made.fault();
      return AnyPath(*std::move(made));
    } else {
      return of_other_dimension("the path is in space already; only a planar one is lifted", 3);
    }
  });
}

Result<HelicalPlan> helical_decomposition(const AnyPath& path, std::size_t segment,
                                          const Vector3<double>& axis) {
  if (segment >= path.segment_count()) {
    return Fault{FaultCode::outside_domain,
                 "the path has " + std::to_string(path.segment_count()) +
                     " segments, counted from 0; got " + std::to_string(segment),
                 std::nullopt,
                 "segment",
                 static_cast<double>(segment),
                 static_cast<double>(path.segment_count() - 1)};
  }
  return path.visit([&]<class P>(const P& p) -> Result<HelicalPlan> {
    if constexpr (P::Point::dimension == 3) {
      return plan_of(p.segment(segment), axis);
    } else {
      return of_other_dimension("a helix is a path in space; this one is planar", 2);
    }
  });
}

}  // namespace hodograph
