// SPDX-License-Identifier: MIT
// Random Hermite data: harmless, next to every degenerate case, and hostile.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/construction/derivative_curve.hpp"
#include "hodograph/construction/hermite.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// The data of one segment.
template <std::size_t m, class S = double>
struct HermiteSet {
  HermitePoint<m, S> begin{}, end{};
  S h{1};
};

/// What a set is drawn from.
enum class DataKind {
  tame,           ///< a smooth random curve over a part of it that turns by about a radian
  generic,        ///< every number uniform in [-1, 1], velocities of size 1
  opposite,       ///< v_b + v_e nearly or exactly zero
  against_chord,  ///< v_b nearly or exactly a negative multiple of v_b + v_e
  turning_back,   ///< near the right-hand side of (17a) opposite to its fibre; straight lines
  slow,           ///< a speed that nearly vanishes beside its derivatives
  planar,         ///< in a coordinate plane, exactly
  far,            ///< far from the origin, or ends that coincide
  scaled,         ///< tame, times a power of two from 2^-498 to 2^498 (1e±150), any step
  hostile,        ///< some numbers replaced by hostile ones
  not_finite,     ///< one number infinite or not a number, or a step that is not positive
};
inline constexpr int data_kinds = 11;

inline std::string name_of(DataKind kind) {
  constexpr const char* names[] = {"tame",         "generic", "opposite",  "against chord",
                                   "turning back", "slow",    "planar",    "far",
                                   "scaled",       "hostile", "not finite"};
  return names[static_cast<std::size_t>(kind)];
}

/// A random smooth curve, a sum of waves: Σ_k c_k sin(w_k ξ + φ_k) + a drift, as exact derivatives.
class RandomCurve {
 public:
  explicit RandomCurve(Random& random, double drift = 1.0) {
    for (auto& wave : waves_) {
      wave = {random.vector3(0.4), random.uniform(0.3, 2.0), random.uniform(-3.0, 3.0)};
    }
    drift_ = (drift * random.uniform(1.0, 2.0)) * random.unit_vector3();
  }
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::sin;
    Vector3<S> sum{S(drift_.x) * xi, S(drift_.y) * xi, S(drift_.z) * xi};
    for (const auto& wave : waves_) {
      const S value = sin(S(wave.rate) * xi + S(wave.phase));
      sum += value * Vector3<S>{S(wave.size.x), S(wave.size.y), S(wave.size.z)};
    }
    return sum;
  }

 private:
  struct Wave {
    Vector3<double> size;
    double rate, phase;
  };
  std::array<Wave, 4> waves_{};
  Vector3<double> drift_{};
};

template <std::size_t m>
HermiteSet<m> tame_set(Random& random) {
  const RandomCurve curve(random);
  const double xi = random.uniform(-2.0, 2.0), h = random.uniform(0.1, 1.0);
  return {derivatives_of<m, double>(curve, xi), derivatives_of<m, double>(curve, xi + h), h};
}

template <std::size_t m>
HermiteSet<m> generic_set(Random& random) {
  HermiteSet<m> set;
  for (auto* point : {&set.begin, &set.end}) {
    for (auto& v : *point) v = random.vector3(1.0);
    (*point)[1] = random.uniform(0.25, 1.0) * random.unit_vector3();
  }
  return set;
}

/// The constant-speed displacement below which a straight line has no interpolant, over the speed:
/// the Δp at which the right-hand side of (17a) vanishes.
inline constexpr double line_limit = 0.448753;

template <std::size_t m>
HermiteSet<m> random_set(Random& random, DataKind kind) {
  HermiteSet<m> set = random.chance(0.5) ? tame_set<m>(random) : generic_set<m>(random);
  const auto either = [&](const Vector3<double>& v) {
    return random.chance(0.3) ? v : random.nearly(v);
  };
  switch (kind) {
    case DataKind::tame:
      return tame_set<m>(random);
    case DataKind::generic:
      return generic_set<m>(random);
    case DataKind::opposite:
      set.end[1] = either(-set.begin[1]);
      if (random.chance(0.2)) set.end[0] = either(set.begin[0]);
      return set;
    case DataKind::against_chord:
      // v_e = c v_b with c < -1: the sum points against v_b.
      set.end[1] = either(-random.uniform(1.5, 4.0) * set.begin[1]);
      return set;
    case DataKind::turning_back: {
      const Vector3<double> v = set.begin[1];
      if (random.chance(0.6)) {
        const double share = random.chance(0.5) ? random.nearly(line_limit) : random.uniform(-1, 1);
        for (auto* point : {&set.begin, &set.end}) {
          (*point)[1] = random.chance(0.5) ? v : random.nearly(v);
          for (std::size_t r = 2; r <= m; ++r) {
            const double size = random.chance(0.5) ? 0.0 : random.spread(-40, 0);
            (*point)[r] = random.chance(0.7) ? size * v : random.vector3(std::abs(size));
          }
        }
        set.end[0] = set.begin[0] + (share * set.h) * v;
      } else {
        set.end[0] = set.begin[0] + random.spread(-8, 4) * random.unit_vector3();
      }
      return set;
    }
    case DataKind::slow: {
      auto& point = random.chance(0.5) ? set.begin : set.end;
      point[1] = std::abs(random.spread(-60, 0)) * random.unit_vector3();
      return set;
    }
    case DataKind::planar: {
      const std::size_t axis = random.index(3);
      for (auto* point : {&set.begin, &set.end}) {
        for (auto& v : *point) v[axis] = 0.0;
        if (largest_component((*point)[1]) == 0.0) (*point)[1][(axis + 1) % 3] = 1.0;
      }
      return set;
    }
    case DataKind::far: {
      const Vector3<double> offset = random.spread(0, 60) * random.unit_vector3();
      set.begin[0] += offset;
      set.end[0] = random.chance(0.2) ? set.begin[0] : set.end[0] + offset;
      return set;
    }
    case DataKind::scaled: {
      const double length = std::ldexp(1.0, static_cast<int>(random.integer(-498, 498)));
      const double step =
          std::ldexp(random.uniform(1.0, 2.0), static_cast<int>(random.integer(-30, 30)));
      const double stretch = step / set.h;
      for (auto* point : {&set.begin, &set.end}) {
        double scale = length;
        for (auto& v : *point) {
          v = scale * v;
          scale /= stretch;
        }
      }
      set.h = step;
      return set;
    }
    case DataKind::hostile: {
      for (auto count = random.integer(1, 8); count > 0; --count) {
        auto& point = random.chance(0.5) ? set.begin : set.end;
        point[random.index(m + 1)][random.index(3)] = random.hostile();
      }
      if (random.chance(0.1)) set.h = std::abs(random.hostile());
      return set;
    }
    case DataKind::not_finite: {
      const double bad = random.chance(0.5)
                             ? std::numeric_limits<double>::quiet_NaN()
                             : random.sign() * std::numeric_limits<double>::infinity();
      if (random.chance(0.2)) {
        set.h = random.chance(0.5) ? bad : -std::abs(random.hostile());
      } else if (random.chance(0.2)) {
        (random.chance(0.5) ? set.begin : set.end)[1] = {0.0, -0.0, 0.0};
      } else {
        auto& point = random.chance(0.5) ? set.begin : set.end;
        point[random.index(m + 1)][random.index(3)] = bad;
      }
      return set;
    }
  }
  return set;
}

/// The same data in another scalar that holds double exactly.
template <class T, std::size_t m>
HermitePoint<m, T> converted_point(const HermitePoint<m>& point) {
  HermitePoint<m, T> result;
  for (std::size_t r = 0; r <= m; ++r) {
    result[r] = {T(point[r].x), T(point[r].y), T(point[r].z)};
  }
  return result;
}
template <class T, std::size_t m>
HermiteSet<m, T> converted_set(const HermiteSet<m>& set) {
  return {converted_point<T, m>(set.begin), converted_point<T, m>(set.end), T(set.h)};
}

}  // namespace hodograph::test
