// SPDX-License-Identifier: MIT
// A program outside the tree: a path of one segment, made, measured, and one refused.
#include <cstdio>

#include "hodograph/path/path.hpp"

int main() {
  using Curve = hodograph::SpatialPhCurve<1>;
  using Path = hodograph::Path<hodograph::Quaternion<double>, 1>;
  const Curve turn({0, 0, 0}, Curve::Preimage({{{1, 0, 0, 0}, {1, 0, 0, 3}}}), 1);
  const auto path = Path::create({0, 1}, {turn}, false).value();
  std::printf("%g %g %g\n", path.position(1.0).x, path.position(1.0).y, path.arc_length());
  std::printf("%s\n", Path::create({0, 0}, {turn}, false).fault().sentence.c_str());
}
