// SPDX-License-Identifier: MIT
// Contact of tubular families with profiles in any plane and in space: cases
// whose first contact is known, the same surface written in other coordinates,
// and random ones against contacts found by Newton's method.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/surface/sweep_contact.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

using Vectors = DynamicPolynomial<Vector3<double>>;
using Quaternions = DynamicPolynomial<Quaternion<double>>;
using Scalars = DynamicPolynomial<double>;
using Points = std::vector<Vector3<double>>;

const Quaternion<double> one{1.0, 0.0, 0.0, 0.0};

Profile curve(const Points& points, bool closed = false) {
  return Profile::in_space({{0.0, 1.0, points, std::vector<double>(points.size(), 1.0)}}, closed)
      .value();
}

Sweep family(const Profile& profile, const Points& position,
             const std::vector<Quaternion<double>>& rotation = {one},
             const std::vector<double>& scale = {1.0}) {
  return {Motion::polynomial(Vectors(position), Quaternions(rotation), Scalars(scale)).value(),
          profile};
}

/// The rotation by `angle` about k, as a polynomial of degree 2 from no
/// rotation.
std::vector<Quaternion<double>> about_k(double angle) {
  const Quaternion<double> half{std::cos(0.25 * angle), 0.0, 0.0, std::sin(0.25 * angle)};
  return {one, half, half * half};  // (1 - u + u h)²
}

/// A cubic that crosses itself seen from above, symmetric; rising by `rise`.
Points crossing(double rise) {
  return {
      {-1.0, 0.0, 0.0}, {2.0, 2.0, rise / 3.0}, {-2.0, 2.0, 2.0 * rise / 3.0}, {1.0, 0.0, rise}};
}
/// What part of the rise lies between the two branches where it crosses: with s
/// = t - 1/2, x = 14 s³ - 3/2 s, 0 at s = ± √(3/28).
const double part_between = 2.0 * std::sqrt(3.0 / 28.0);

TEST(SurfaceContact, KnowsTheFirstContactOfATranslatedCurve) {
  for (const double rise : {0.01, 1.0, 30.0}) {
    const Profile profile = curve(crossing(rise));
    const double gap = part_between * rise;
    EXPECT_TRUE(contact_of(family(profile, {{0, 0, 0}, {0, 0, 0.999 * gap}})).free) << rise;
    EXPECT_TRUE(contact_of(family(profile, {{0, 0, 0}, {0, 0, -0.999 * gap}})).free) << rise;
    const SweepContact contact = contact_of(family(profile, {{0, 0, 0}, {0, 0, 1.001 * gap}}));
    EXPECT_FALSE(contact.free) << rise;
    EXPECT_GT(contact.pairs, 0U);
    EXPECT_FALSE(contact_of(family(profile, {{0, 0, 0}, {0, 0, -1.001 * gap}})).free) << rise;
  }
}

TEST(SurfaceContact, KnowsTheFirstContactOfATurnedCurve) {
  // About k, an arc out of any plane, no two points of which have one height.
  const Profile rising =
      curve({{1.0, 0.0, 0.0}, {2.0, 1.0, 0.3}, {1.5, 2.0, 1.2}, {0.8, 2.5, 2.0}});
  constexpr double turn = 2.0 * std::numbers::pi;
  EXPECT_TRUE(contact_of(family(rising, {{0, 0, 0}}, about_k(0.5 * turn))).free);
  EXPECT_TRUE(contact_of(family(rising, {{0, 0, 0}}, about_k(0.995 * turn))).free);
  EXPECT_FALSE(contact_of(family(rising, {{0, 0, 0}}, about_k(1.005 * turn))).free);
  // A screw that rises by more than the arc's height in a turn: free beyond the
  // turn.
  EXPECT_TRUE(contact_of(family(rising, {{0, 0, 0}, {0, 0, 4.0}}, about_k(1.2 * turn))).free);
  // Two points of the parabola in the cylinder's wall, at one height, pass one
  // another after the angle between them.
  const Profile arch = curve({{1.0, -1.0, 0.0}, {1.0, 0.0, 2.0}, {1.0, 1.0, 0.0}});
  EXPECT_TRUE(contact_of(family(curve({{1.0, -1.0, 0.0}, {1.0, 0.0, 2.0}, {1.0, 1.0, 1.0}}),
                                {{0, 0, 0}, {5.0, 0, 0}}))
                  .free);
  EXPECT_FALSE(contact_of(family(arch, {{0, 0, 0}}, about_k(0.51 * std::numbers::pi))).free);
}

TEST(SurfaceContact, KnowsTheFirstContactOfAScaledCurve) {
  // The curve seen from the origin crosses itself: the branches are on one ray
  // at distances of ratio 1 + rise·part/height, when lifted by `height`.
  constexpr double height = 10.0, rise = 2.0;
  Points points;
  for (const Vector3<double>& p : crossing(0.0)) points.push_back({p.x, p.y, height});
  // Scaled along its length from 1 to 1 + rise/height: degree 4.
  Points lifted(5);
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = 0.25;
    lifted[i] = lifted[i] + (1.0 - static_cast<double>(i) * share) * points[i];
    lifted[i + 1] =
        lifted[i + 1] + static_cast<double>(i + 1) * share * (1.0 + rise / height) * points[i];
  }
  const double s = std::sqrt(3.0 / 28.0);
  const double ratio = (1.0 + (0.5 + s) * rise / height) / (1.0 + (0.5 - s) * rise / height);
  const auto grown = [&](double factor) {
    return family(curve(lifted), {{0, 0, 0}}, {one}, {1.0, factor});
  };
  EXPECT_TRUE(contact_of(grown(1.0 + 0.99 * (ratio - 1.0))).free);
  EXPECT_FALSE(contact_of(grown(1.0 + 1.01 * (ratio - 1.0))).free);
}

TEST(SurfaceContact, DependsOnNeitherPlaneNorPlaceNorUnit) {
  Random random("planes of tubular families");
  const Points square{{0.0, 1.5, -0.5}, {0.0, 2.5, -0.5}, {0.0, 2.5, 0.5}, {0.0, 1.5, 0.5}};
  for (int i = 0; i < 24; ++i) {
    // The square carried about k and along k, in coordinates turned by any
    // rotation.
    const double angle = random.uniform(0.3, 1.8 * std::numbers::pi);
    const double radius_shift = i % 2 == 0 ? 0.0 : -2.1;  // over the axis: meets itself
    Quaternion<double> q{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                         random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    q = (1.0 / std::sqrt(dot(q, q))) * q;
    const double unit = std::pow(10.0, random.uniform(-8.0, 8.0));
    const Vector3<double> away =
        (i % 3 == 0 ? 1e4 * unit : 0.0) * Vector3<double>{random.uniform(-1.0, 1.0),
                                                          random.uniform(-1.0, 1.0),
                                                          random.uniform(-1.0, 1.0)};
    std::vector<SpatialRationalBezier> sides;
    for (std::size_t k = 0; k < 4; ++k) {
      // Turned by q, so that B q* carries the same points.
      const auto at = [&](const Vector3<double>& p) {
        const Vector3<double> moved{p.y + radius_shift, p.x, p.z};  // in the plane of x and z
        return unit *
               vector_part(q * Quaternion<double>{0.0, moved.x, moved.y, moved.z} * conjugate(q));
      };
      sides.push_back({0.0, 1.0, {at(square[k]), at(square[(k + 1) % 4])}, {1.0, 1.0}});
    }
    std::vector<Quaternion<double>> rotation;
    for (const auto& r : about_k(angle)) rotation.push_back(r * conjugate(q));
    const Sweep sweep = family(Profile::in_space(sides, true).value(), {away}, rotation);
    EXPECT_EQ(contact_of(sweep).free, i % 2 == 0) << i << " angle " << angle;
  }
}

TEST(SurfaceContact, NeverExcludesWhatIsNoSurface) {
  const Profile arc = curve({{0, 0, 0}, {1, 1, 0.5}, {2, 0, 1.5}, {3, 1, 1}});
  // Not moved; moved along its own chord, tangent to it somewhere; back to
  // where it was; turned about a point of itself; with a corner that turns
  // back.
  EXPECT_FALSE(contact_of(family(arc, {{0, 0, 0}})).free);
  EXPECT_FALSE(contact_of(family(arc, {{0, 0, 0}, {0, 0, 1}, {0, 0, 0}})).free);
  EXPECT_FALSE(contact_of(family(arc, {{0, 0, 0}}, about_k(1.0))).free);
  const Profile flat = curve({{1, 0, 0}, {2, 1, 0}, {3, -1, 0}, {4, 0, 0}});
  EXPECT_FALSE(contact_of(family(flat, {{0, 0, 0}, {1, 0, 0}})).free);
  const Profile back = curve({{1, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  EXPECT_FALSE(contact_of(family(back, {{0, 0, 0}, {0, 1, 0}})).free);
  // A plane profile that crosses itself, moved across its plane: so does the
  // surface.
  EXPECT_FALSE(contact_of(family(curve(crossing(0.0)), {{0, 0, 0}, {0, 0, 1}})).free);
  // Numbers at the ends of what doubles hold.
  for (const int exponent : {-300, -160, -80, 80, 160, 300}) {
    const double unit = std::pow(10.0, exponent);
    const Profile scaled = curve({{0, 0, 0}, {unit, unit, 0.5 * unit}, {2 * unit, 0, unit}});
    EXPECT_FALSE(contact_of(family(scaled, {{0, 0, 0}})).free) << unit;
    if (std::abs(exponent) > 170) continue;
    EXPECT_TRUE(contact_of(family(scaled, {{0, 0, 0}, {0, 0, 3 * unit}})).free) << unit;
  }
}

/// A surface S(v, w) given by a sweep of one motion piece and one profile
/// piece.
struct Jet {
  Vector3<double> at, along_v, along_w;
};
Jet jet_of(const Sweep& sweep, double v, double w) {
  const MotionState s = sweep.motion.at(0, v);
  const auto p = sweep.profile.at(0, w);
  const auto turned = [&](const Vector3<double>& x) {
    return x.x * s.frame.e1 + x.y * s.frame.e2 + x.z * s.frame.e3;
  };
  const Vector3<double> arm = s.scale_rate * p.position + s.scale * cross(s.body_rate, p.position);
  return {s.position + s.scale * turned(p.position), s.velocity + turned(arm),
          s.scale * turned(p.derivative)};
}

/// Two parameters at least `apart` from each other with one point of the
/// surface, by Newton's method of least steps from pairs of a grid; nothing
/// where none is found.
std::optional<std::array<double, 4>> contact_found(const Sweep& sweep, double apart) {
  constexpr int steps = 16, rounds = 10;
  constexpr std::size_t most_tries = 40;
  struct Sample {
    double v, w;
    Vector3<double> at;
  };
  std::vector<Sample> samples;
  double cell = 0.0;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const double v = static_cast<double>(i) / steps, w = static_cast<double>(j) / steps;
      const Jet jet = jet_of(sweep, v, w);
      samples.push_back({v, w, jet.at});
      cell = std::max({cell, norm(jet.along_v) / steps, norm(jet.along_w) / steps});
    }
  }
  struct Near {
    double distance;
    std::array<double, 4> q;
  };
  std::vector<Near> near;
  for (const Sample& a : samples) {
    for (const Sample& b : samples) {
      constexpr double cells = 3.0;
      if (&b <= &a || std::abs(a.v - b.v) + std::abs(a.w - b.w) < cells / steps) continue;
      const double distance = norm(b.at - a.at);
      if (distance < cell) near.push_back({distance, {a.v, a.w, b.v, b.w}});
    }
  }
  std::sort(near.begin(), near.end(),
            [](const Near& a, const Near& b) { return a.distance < b.distance; });
  if (near.size() > most_tries) near.resize(most_tries);
  {
    for (Near& start : near) {
      std::array<double, 4>& q = start.q;
      for (int k = 0; k < rounds; ++k) {
        const Jet x = jet_of(sweep, q[0], q[1]), y = jet_of(sweep, q[2], q[3]);
        const Vector3<double> off = y.at - x.at;
        const bool inside =
            std::all_of(q.begin(), q.end(), [](double c) { return c >= 0.0 && c <= 1.0; });
        const double size = norm(x.at) + norm(y.at) + cell;
        if (inside && std::abs(q[0] - q[2]) + std::abs(q[1] - q[3]) > apart &&
            norm(off) <= 64.0 * epsilon<double>() * size) {
          return q;
        }
        // J J^T y = -off, step J^T y, by Cramer's rule.
        const std::array<Vector3<double>, 4> j{-x.along_v, -x.along_w, y.along_v, y.along_w};
        std::array<Vector3<double>, 3> m{};
        for (const auto& c : j) {
          for (std::size_t r = 0; r < 3; ++r) m[r] = m[r] + c[r] * c;
        }
        const double det = dot(m[0], cross(m[1], m[2]));
        if (!(std::abs(det) > 0.0)) break;
        const Vector3<double> right = -off;
        const Vector3<double> z =
            (1.0 / det) * (right.x * cross(m[1], m[2]) + right.y * cross(m[2], m[0]) +
                           right.z * cross(m[0], m[1]));
        for (std::size_t c = 0; c < 4; ++c) {
          q[c] = std::clamp(q[c] + dot(j[c], z), -0.2, 1.2);
        }
      }
    }
  }
  return std::nullopt;
}

TEST(SurfaceContact, NoContactIsFoundWhereItIsExcluded) {
  Random random("contact of tubular families");
  std::size_t excluded = 0, found = 0;
  const std::size_t count = cases<std::size_t>(48);
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const auto vector = [&](double size) {
      return size * Vector3<double>{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0),
                                    random.uniform(-1.0, 1.0)};
    };
    Points points{vector(1.0)}, position{Vector3<double>{}};
    for (int k = 0; k < 3; ++k) points.push_back(points.back() + vector(0.7));
    const double reach = random.uniform(0.2, 3.0);
    for (int k = 0; k < 2; ++k) position.push_back(position.back() + vector(reach));
    std::vector<Quaternion<double>> rotation{one};
    for (int k = 0; k < 2; ++k) {
      rotation.push_back(
          {1.0, random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)});
    }
    const Sweep sweep = family(curve(points), position, rotation, {1.0, random.uniform(0.5, 2.0)});
    const bool free = contact_of(sweep).free;
    const auto contact = contact_found(sweep, 0.02);
    EXPECT_FALSE(free && contact) << "at v " << (*contact)[0] << " and " << (*contact)[2];
    excluded += free ? 1 : 0;
    found += contact ? 1 : 0;
  }
  // Nearly all are one or the other.
  EXPECT_GE(excluded + found, count * 9 / 10);
  EXPECT_GE(excluded, count / 8);
  EXPECT_GE(found, count / 8);
}

TEST(SurfaceContact, DecidesTheFamiliesOfLoops) {
  // A loop out of any plane, carried on by less and by more than keeps it from
  // itself.
  const AnyPath loop(closed_loop({1.0, 2.0}).value());
  const Profile profile = Profile::in_space(loop).value();
  EXPECT_TRUE(profile.is_closed());
  constexpr double nearly = 1.0 / 8192.0;  // of the loop's size: far from any contact
  for (const Vector3<double>& way :
       {Vector3<double>{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}) {
    bool before = true;
    for (const double by : {nearly, 0.01, 0.1, 1.0}) {
      const SweepContact contact = contact_of(family(profile, {{0, 0, 0}, by * way}));
      EXPECT_TRUE(before || !contact.free);  // a part of a family free of contact is free of it
      before = contact.free;
    }
  }
  EXPECT_TRUE(contact_of(family(profile, {{0, 0, 0}, {0.0, 0.0, nearly}})).free);
  EXPECT_FALSE(contact_of(family(profile, {{0, 0, 0}, {0.0, 0.0, 0.0}})).free);
}

}  // namespace
}  // namespace hodograph::test
