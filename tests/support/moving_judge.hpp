// SPDX-License-Identifier: MIT
// Timed motions in 50 digits, and the least distance of two of them, found by dense sampling and
// golden sections: the judge of certified separations.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "hodograph/path/path.hpp"
#include "hodograph/path/timing_law.hpp"
#include "hodograph/planning/swarm/timed_motion.hpp"

namespace hodograph::test {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

/// r(s(t)) of the stored numbers, in 50 digits.
class WideMotion {
 public:
  template <class A, std::size_t n>
  WideMotion(const Path<A, n>& path, TimingLaw law, Presence presence = {})
      : law_(std::move(law)), presence_(presence) {
    using WideA = std::conditional_t<A::dimension == 2, Complex<Wide>, Quaternion<Wide>>;
    struct Segments {
      std::vector<PhCurve<WideA, n>> curves;
      std::vector<Wide> begins;
    };
    auto segments = std::make_shared<Segments>();
    Wide sum = 0;
    for (const auto& curve : path.segments()) {
      BernsteinPolynomial<WideA, n> preimage;
      for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t j = 0; j < A::dimension; ++j)
          preimage[i][j] = Wide(curve.preimage()[i][j]);
      }
      point_t<WideA> start;
      for (std::size_t j = 0; j < point_t<A>::dimension; ++j) start[j] = Wide(curve.start()[j]);
      segments->curves.emplace_back(start, preimage, Wide(curve.parameter_step()));
      segments->begins.push_back(sum);
      sum += segments->curves.back().arc_length();
    }
    length_ = sum;
    point_ = [segments](const Wide& s) {
      std::size_t k = segments->curves.size() - 1;
      while (k > 0 && s < segments->begins[k]) --k;
      const auto& curve = segments->curves[k];
      const Wide target = s - segments->begins[k];
      Wide low = 0, high = 1, u = Wide(0.5);
      const Wide enough("1e-45");  // not a tolerance: of 50 digits
      for (int step = 0; step < 400 && high - low > enough; ++step) {
        const Wide rest = target - curve.arc_length(u);
        (rest > 0 ? low : high) = u;
        const Wide slope = curve.parameter_step() * curve.speed(u);
        const Wide trial = slope > 0 ? Wide(u + rest / slope) : Wide(-1);
        if (trial == u) break;
        u = low < trial && trial < high && step < 60 ? trial : Wide((low + high) / 2);
        if (rest == 0) break;
      }
      const auto p = curve.position(u);
      Vector3<Wide> result{p[0], p[1], Wide(0)};
      if constexpr (point_t<WideA>::dimension == 3) result.z = p[2];
      return result;
    };
  }

  Vector3<Wide> position(const Wide& t) const {
    Wide s = arc_length(t - Wide(law_.start_time()));
    return point_(std::min(length_, std::max(Wide(0), s)));
  }
  const TimingLaw& law() const { return law_; }
  const Presence& presence() const { return presence_; }

 private:
  /// The law as its pieces define it.
  Wide arc_length(const Wide& local) const {
    const auto& pieces = law_.pieces();
    if (local <= 0) return 0;
    if (local >= Wide(law_.duration())) return length_;
    std::size_t i = pieces.size() - 1;
    while (i > 0 && local < Wide(pieces[i].begin)) --i;
    const Wide u =
        std::min(Wide(1), Wide((local - Wide(pieces[i].begin)) / Wide(pieces[i].duration)));
    const Wide both = Wide(pieces[i].first) + Wide(pieces[i].second);
    return Wide(pieces[i].arc_length) + 2 * u * (1 - u) * Wide(pieces[i].first) + u * u * both;
  }

  TimingLaw law_;
  Presence presence_;
  Wide length_;
  std::function<Vector3<Wide>(const Wide&)> point_;
};

struct WideMinimum {
  Wide distance, time;
};

inline Wide wide_distance(const WideMotion& a, const WideMotion& b, const Wide& t,
                          const Wide& vertical_scale) {
  Vector3<Wide> d = a.position(t) - b.position(t);
  d.z = vertical_scale * d.z;
  return sqrt(dot(d, d));
}

/// The least distance on [begin, end]: the best of the local minima next to the `deepest` best of
/// `samples` samples (taken by `coarse`, a quick distance function in double).
inline WideMinimum least_wide_distance(const WideMotion& a, const WideMotion& b, double begin,
                                       double end, const Wide& vertical_scale,
                                       const std::function<double(double)>& coarse,
                                       int samples = 1000, std::size_t deepest = 3) {
  std::vector<std::pair<double, int>> order;
  std::vector<double> value(static_cast<std::size_t>(samples) + 1);
  const auto time = [&](int k) { return std::min(end, begin + (end - begin) * k / samples); };
  for (int k = 0; k <= samples; ++k) value[static_cast<std::size_t>(k)] = coarse(time(k));
  for (int k = 0; k <= samples; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool low =
        (k == 0 || value[i] <= value[i - 1]) && (k == samples || value[i] <= value[i + 1]);
    if (low) order.push_back({value[i], k});
  }
  std::sort(order.begin(), order.end());
  if (order.size() > deepest) order.resize(deepest);
  WideMinimum best{Wide(1e300), Wide(begin)};
  const auto note = [&](const Wide& t) {
    const Wide d = wide_distance(a, b, t, vertical_scale);
    if (d < best.distance) best = {d, t};
    return d;
  };
  note(Wide(begin));
  note(Wide(end));
  const Wide golden = (sqrt(Wide(5)) - 1) / 2;
  for (const auto& [unused, k] : order) {
    Wide low = Wide(time(std::max(k - 1, 0))), high = Wide(time(std::min(k + 1, samples)));
    Wide left = high - golden * (high - low), right = low + golden * (high - low);
    Wide at_left = note(left), at_right = note(right);
    for (int step = 0; step < 90; ++step) {
      if (at_left < at_right) {
        high = right;
        right = left;
        at_right = at_left;
        left = high - golden * (high - low);
        at_left = note(left);
      } else {
        low = left;
        left = right;
        at_left = at_right;
        right = low + golden * (high - low);
        at_right = note(right);
      }
    }
  }
  return best;
}

}  // namespace hodograph::test
