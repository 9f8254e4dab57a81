// SPDX-License-Identifier: MIT
// Signed area: known regions, invariances, and enclosures against exact sums in 50 digits.
#include "hodograph/path/signed_area.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph {
namespace {

using test::Random;
using Real = boost::multiprecision::cpp_bin_float_50;

/// The area of the stored segments in 50 digits, with their gaps closed.
template <std::size_t n>
Real exact_area(const PlanarPath<n>& path) {
  Real sum(0);
  Vector2<Real> origin{}, end{};
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& stored = path.segment(k);
    const Vector2<Real> start = test::converted<Real>(stored.start());
    if (k == 0) origin = end = start;
    const PhCurve<Complex<Real>, n> curve(
        start, stored.preimage().mapped([](const auto& w) { return test::converted<Real>(w); }),
        Real(stored.parameter_step()));
    const auto cross = [](const Vector2<Real>& a, const Vector2<Real>& b) {
      return Real(a.x * b.y - a.y * b.x);
    };
    sum += cross(end - origin, start - end);
    BernsteinPolynomial<Vector2<Real>, 2 * n + 1> r = curve.displacement();
    for (std::size_t i = 0; i <= 2 * n + 1; ++i) r[i] = r[i] + (start - origin);
    sum += product(r, r.derivative(), cross).integral();
    end = curve.end();
  }
  return Real(sum / 2);
}

TEST(SignedArea, OfARingIsThatOfItsDisc) {
  // 64 arcs of w = e^(iφ/2): a curve close to a circle of length 2π·(nearly 1).
  const auto ring = test::ring(64);
  const double area = signed_area(ring);
  const double length = ring.arc_length();
  const double pi = 3.141592653589793;
  EXPECT_LT(area, length * length / (4 * pi));  // the isoperimetric inequality
  EXPECT_GT(area, 0.999 * length * length / (4 * pi));
  EXPECT_TRUE(signed_area_enclosure(ring).contains(area));
}

TEST(SignedArea, OfAParabolaAndItsChord) {
  // w = 1 + i u: x = u - u³/3, y = u². ½ ∫ (x y' - y x') = ½ (2/3 - 2/15 - 1/3 + 1/5) = 1/5; the
  // chord from (2/3, 1) back to the start adds nothing.
  const auto path =
      test::path_of(BernsteinPolynomial<Complex<double>, 1>({Complex<double>{1, 0}, {1, 1}}));
  EXPECT_CLOSE(signed_area(path), 0.2, 4, 1.0);
  EXPECT_TRUE(signed_area_enclosure(path).contains(0.2));
  const auto line = test::path_of(BernsteinPolynomial<Complex<double>, 0>({Complex<double>{1, 1}}));
  EXPECT_EQ(signed_area(line), 0.0);
}

template <std::size_t n>
void judge(const PlanarPath<n>& path) {
  const Enclosure area = signed_area_enclosure(path);
  const Real truth = exact_area(path);
  EXPECT_LE(Real(area.lower()), truth);
  EXPECT_GE(Real(area.upper()), truth);
  double reach = 0.0;
  for (const auto& curve : path.segments()) {
    reach = std::max(reach, largest_component(curve.start() - path.segment(0).start()));
  }
  const double size = (reach + path.arc_length()) * path.arc_length();
  EXPECT_LE(area.width(), 256 * std::numeric_limits<double>::epsilon() * size);
  EXPECT_CLOSE(signed_area(path), truth, 64, size);
}

TEST(SignedArea, EnclosuresHold) {
  Random random("signed area: enclosures");
  for (int i = 0; i < 50; ++i) {
    judge(test::random_path<PlanarPath<1>>(random, 7));
    judge(test::random_path<PlanarPath<2>>(random, 1));
    judge(test::random_path<PlanarPath<2>>(random, 30));
    judge(test::random_path<PlanarPath<4>>(random, 3));
  }
}

TEST(SignedArea, DoesNotDependOnTheOrigin) {
  Random random("signed area: origin");
  const auto path = test::random_path<PlanarPath<2>>(random, 5);
  const Vector2<double> far{0x1.0p+30, -0x1.0p+31};
  std::vector<PlanarPhCurve<2>> moved;
  for (const auto& c : path.segments()) {
    moved.emplace_back(c.start() + far, c.preimage(), c.parameter_step());
  }
  const auto away = PlanarPath<2>::create(path.knots(), moved, false).value();
  // Only the starts are rounded, to an ulp of the distance.
  const double size = path.arc_length();
  EXPECT_CLOSE(signed_area(away), signed_area(path), 64, size * (size + 0x1.0p+31));
}

}  // namespace
}  // namespace hodograph
