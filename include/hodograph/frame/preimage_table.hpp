// SPDX-License-Identifier: MIT
// The preimage of a spatial path as plain numbers, whatever its degree: what rolls are made from.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The preimage of a spatial path where it lies, as PreimageTable holds it: a view of what must
/// outlive it. row(path, k) gives the degree + 1 coefficients of segment k.
struct PreimageRows {
  std::size_t degree = 0;
  bool closed = false;
  std::span<const double> knots;
  const void* path = nullptr;
  const Quaternion<double>* (*row)(const void* path, std::size_t segment) = nullptr;
};

/// Knots ξ_0 < ... < ξ_N and the Bernstein coefficients of A on each segment, one segment after the
/// other, in the global scaling (r' = A i A* with ' = d/dξ). Made from a path, implicitly, so that
/// whatever takes one takes a path.
struct PreimageTable {
  std::size_t degree = 0;
  bool closed = false;
  std::vector<double> knots;
  std::vector<Quaternion<double>> coefficients;  ///< (degree + 1) a segment

  template <std::size_t n>
  PreimageTable(const SpatialPath<n>& path)
      : degree(n), closed(path.is_closed()), knots(path.knots()) {
    static_assert(n <= maximum_dynamic_degree);
    coefficients.reserve(path.segment_count() * (n + 1));
    for (const auto& curve : path.segments()) {
      for (const auto& a : curve.preimage().coefficients()) coefficients.push_back(a);
    }
  }
  explicit PreimageTable(const PreimageRows& rows);
  /// The same from a path whose type is known when the program runs. Faults: unsupported (a path
  /// in the plane: there is no roll).
  static Result<PreimageTable> of(const AnyPath& path);

  std::size_t segment_count() const { return knots.size() - 1; }
  /// h of segment k.
  double step(std::size_t k) const { return knots[k + 1] - knots[k]; }

 private:
  PreimageTable() = default;
};

}  // namespace hodograph
