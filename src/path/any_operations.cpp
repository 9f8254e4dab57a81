// SPDX-License-Identifier: MIT
#include "hodograph/path/any_operations.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "hodograph/path/operations.hpp"

namespace hodograph {

namespace {

template <class P>
inline constexpr std::size_t dimension_of = P::Point::dimension;

/// The path in its static type as a path of any.
template <class P>
Result<AnyPath> any(Result<P> made) {
  if (!made) return made.fault();
  return AnyPath(*std::move(made));
}

Fault of_other_dimension(std::string sentence, std::size_t dimension) {
  return {FaultCode::unsupported,         std::move(sentence), std::nullopt, "dimension",
          static_cast<double>(dimension), std::nullopt};
}

/// The same path in the next degree.
AnyPath elevated_by_one(const AnyPath& path) {
  return path.visit([]<class P>(const P& p) -> AnyPath {
    if constexpr (P::preimage_degree < maximum_dynamic_degree) {
      return with_preimage_degree<P::preimage_degree + 1>(p).value();
    } else {
      return AnyPath(p);
    }
  });
}

/// A vector of the path's dimension, or the fault that its size does not fit.
template <class Point>
Result<Point> vector_of(std::span<const double> numbers, const char* name) {
  if (numbers.size() != Point::dimension) {
    return Fault{FaultCode::mismatched_size,
                 "the " + std::string(name) + " of a reflection has " +
                     std::to_string(Point::dimension) +
                     " numbers, as the path has dimensions; got " + std::to_string(numbers.size()),
                 std::nullopt,
                 name,
                 static_cast<double>(numbers.size()),
                 static_cast<double>(Point::dimension)};
  }
  Point point{};
  for (std::size_t i = 0; i < numbers.size(); ++i) point[i] = numbers[i];
  return point;
}

}  // namespace

Result<AnyPath> reversed(const AnyPath& path) {
  return path.visit([](const auto& p) { return any(reversed(p)); });
}

Result<AnyPath> subpath(const AnyPath& path, double xi_a, double xi_b) {
  return path.visit([&](const auto& p) { return any(subpath(p, xi_a, xi_b)); });
}

Result<AnyPath> joined(const AnyPath& a, const AnyPath& b) {
  if (a.dimension() != b.dimension()) {
    return of_other_dimension(
        "one path is planar and the other spatial; lift the planar one before joining them",
        b.dimension());
  }
  const std::size_t degree = std::max(a.preimage_degree(), b.preimage_degree());
  const AnyPath first = with_preimage_degree(a, degree).value();
  const AnyPath second = with_preimage_degree(b, degree).value();
  return first.visit([&]<class P>(const P& p) { return any(joined(p, *second.get_if<P>())); });
}

Result<AnyPath> with_closure(const AnyPath& path, bool closed) {
  return path.visit([&](const auto& p) { return any(with_closure(p, closed)); });
}

Result<AnyPath> reparametrised(const AnyPath& path, double begin, double end) {
  return path.visit([&](const auto& p) { return any(reparametrised(p, begin, end)); });
}

Result<AnyPath> with_preimage_degree(const AnyPath& path, std::size_t m) {
  const std::size_t n = path.preimage_degree();
  if (m < n || m > maximum_dynamic_degree) {
    return Fault{FaultCode::outside_domain,
                 "the preimage degree of this path can be " + std::to_string(n) + " to " +
                     std::to_string(maximum_dynamic_degree) + "; got " + std::to_string(m),
                 std::nullopt,
                 "preimage_degree",
                 static_cast<double>(m),
                 static_cast<double>(m < n ? n : maximum_dynamic_degree)};
  }
  AnyPath raised = path;
  while (raised.preimage_degree() < m) raised = elevated_by_one(raised);
  return raised;
}

Result<AnyPath> moved(const AnyPath& path, const Quaternion<double>& rotation,
                      const Vector3<double>& translation) {
  return path.visit([&]<class P>(const P& p) -> Result<AnyPath> {
    if constexpr (dimension_of<P> == 3) {
      return any(moved(p, rotation, translation));
    } else {
      return of_other_dimension(
          "a planar path turns by an angle, not by a quaternion; lift it to turn it in space", 2);
    }
  });
}

Result<AnyPath> moved(const AnyPath& path, double angle, const Vector2<double>& translation) {
  return path.visit([&]<class P>(const P& p) -> Result<AnyPath> {
    if constexpr (dimension_of<P> == 2) {
      return any(moved(p, angle, translation));
    } else {
      return of_other_dimension("a spatial path turns by a unit quaternion, not by an angle", 3);
    }
  });
}

Result<AnyPath> scaled(const AnyPath& path, double c) {
  return path.visit([&](const auto& p) { return any(scaled(p, c)); });
}

Result<AnyPath> reflected(const AnyPath& path, std::span<const double> normal,
                          std::span<const double> point) {
  return path.visit([&]<class P>(const P& p) -> Result<AnyPath> {
    const auto nu = vector_of<typename P::Point>(normal, "normal");
    if (!nu) return nu.fault();
    const auto at = vector_of<typename P::Point>(point, "point");
    if (!at) return at.fault();
    return any(reflected(p, *nu, *at));
  });
}

Result<AnyPath> lifted(const AnyPath& path) {
  return path.visit([]<class P>(const P& p) -> Result<AnyPath> {
    if constexpr (dimension_of<P> == 2) {
      return any(lifted(p));
    } else {
      return of_other_dimension("the path is in space already; only a planar one is lifted", 3);
    }
  });
}

}  // namespace hodograph
