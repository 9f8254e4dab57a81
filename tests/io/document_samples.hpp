// SPDX-License-Identifier: MIT
// Path documents for the tests of this folder.
#pragma once

#include <utility>
#include <vector>

#include "hodograph/io/document.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// A spatial document of two segments in which every member is present that there is in space.
inline PathDocument full_document(Random& random) {
  const auto path = random_path<SpatialPath<2>>(random, 2, 1);
  PathDocument document{path};
  document.name = "loop \"A\"\n\xce\xbe";
  document.length_unit = "LU";
  document.parameter_unit = "TU";
  document.roll = LinearRoll<double>{path.xi_begin(), 0.25, -0.125};
  document.provenance = {"hodograph", "orbit.csv", "C1 Hermite", "order ten", 0.5};
  document.promises.continuity = ContinuityOrders{2, 1, 1, 0};
  document.promises.error = ErrorPromise{Enclosure(0.25, 0.375), true, "orbit.csv"};
  document.promises.arc_length = Enclosure(3.0, 3.5);
  document.promises.smallest_speed = Enclosure(0.5, 0.625);
  document.promises.largest_speed = Enclosure(2.0, 2.5);
  document.promises.curvature_bound = 7.5;
  document.promises.end = Vector3<double>{1.0, 2.0, -0.5};
  document.promises.largest_curvature = Enclosure(7.0, 7.25);
  document.promises.helix =
      HelixPromise{{0.0, 0.6, 0.8}, {{0, Enclosure(-0.5, 0.25)}, {1, Enclosure(1.0 / 3.0)}}};
  return document;
}

/// A planar document with the members that there are in the plane alone.
inline PathDocument planar_document(Random& random) {
  PathDocument document{random_path<PlanarPath<2>>(random, 2, 1)};
  document.promises.end = Vector3<double>{1.0, -1e300, 0.0};
  document.promises.largest_curvature = Enclosure(1.0 / 3.0, 0.4);
  document.promises.clearance =
      ClearancePromise{"world.geojson",
                       2.5,
                       {{3, Enclosure(0.1, 0.25)}, {4000000000U, Enclosure(0.0)}},
                       Enclosure(7.0, 8.0)};
  return document;
}

}  // namespace hodograph::test
