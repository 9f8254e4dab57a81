// SPDX-License-Identifier: MIT
// hermite.hpp: the door (checks, scaling, faults) around the kernel.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "hodograph/construction/detail/hermite_batch.hpp"
#include "hodograph/construction/detail/hermite_kernel.hpp"
#include "hodograph/construction/detail/points_on_knots.hpp"
#include "hodograph/construction/hermite.hpp"
#if defined(__GNUC__)
#include "hodograph/foundation/pack.hpp"
#endif

namespace hodograph {
namespace hermite_detail {

struct BothEnds {};

/// The power of two c with c² max|p'| in [1/2, 2), or 2^511 where the speeds are subnormal (c²
/// would overflow): preimages are computed from data scaled by c² and divided by c, so that no
/// square overflows or vanishes.
inline double prescale(double largest_speed) {
  if (!(largest_speed > 0) || !std::isfinite(largest_speed)) return 1.0;
  int exponent = 0;
  std::frexp(largest_speed, &exponent);
  constexpr int least = 2 * (std::numeric_limits<double>::min_exponent / 2);
  return std::ldexp(1.0, -(std::max(exponent, least) / 2));
}

template <std::size_t m, class S>
std::optional<Fault> point_fault(const HermitePoint<m, S>& point, std::size_t index) {
  for (std::size_t r = 0; r <= m; ++r) {
    if (!is_finite(point[r])) {
      return Fault{FaultCode::not_finite,
                   (r == 0 ? std::string("the position") : "derivative " + std::to_string(r)) +
                       " of point " + std::to_string(index) + " is not finite",
                   index,
                   r == 0 ? "position" : "derivative",
                   std::nullopt,
                   std::nullopt};
    }
  }
  if (!(S(0) < largest_component(point[1]))) {
    return Fault{FaultCode::zero_speed,
                 "the velocity of point " + std::to_string(index) +
                     " is zero: a PH curve has no direction there; give it a speed or split the "
                     "data at the stop",
                 index,
                 "velocity",
                 0.0,
                 std::nullopt};
  }
  return std::nullopt;
}

inline Fault range_fault(std::size_t index) {
  return {FaultCode::no_interpolant,
          "segment " + std::to_string(index) +
              ": its numbers are too large, or differ too much in size, to be multiplied: a speed "
              "is too small beside its derivatives, or the parameter step does not suit the points",
          index,
          "range",
          std::nullopt,
          std::nullopt};
}

/// Judges a finished segment: its numbers, its fibre, and how far it wanders from its data.
template <std::size_t m, class S>
std::optional<Fault> segment_fault(const Segment<S, m>& segment, const HermitePoint<m, S>& begin,
                                   const HermitePoint<m, S>& end, const S& h, double scale,
                                   std::size_t index) {
  using std::sqrt;
  using R = real_of_t<S>;
  const R angle = accuracy::opposite_fibre_angle<S>();
  const S square(scale * scale);
  S size = largest_component((S(1) / h) * (end[0] - begin[0]));
  S weight = S(1);
  for (std::size_t r = 1; r <= m; ++r) {
    size = size + weight * (largest_component(begin[r]) + largest_component(end[r]));
    weight = weight * h / S(static_cast<double>(r + 1));
  }
  size = square * size;
  S control_speed(0);  // first of what the ends alone decide
  for (std::size_t i = 0; i <= 2 * m; ++i) {
    const auto& a = segment.preimage[i];
    if (i != m) control_speed += dot(a, a);
  }
  // Where a square overflowed or was lost, the roll is no rotation: it would spoil the end.
  using std::abs;
  const S roll_size =
      segment.roll.cosine * segment.roll.cosine + segment.roll.sine * segment.roll.sine;
  const bool rotation = value_of(abs(S(roll_size - S(1)))) <= accuracy::unit_error<S>();
  // Products of the two ends' numbers must keep their digits: 2^511 is the root of double's range.
  constexpr double most_ratio = 0x1p511;
  const S slow = select(largest_component(begin[1]) < largest_component(end[1]),
                        largest_component(begin[1]), largest_component(end[1]));
  if (!is_finite(control_speed) || !is_finite(size) || !rotation ||
      !(size < S(most_ratio) * (square * slow))) {
    return range_fault(index);
  }
  if (!(value_of(segment.closeness) > angle * angle)) {
    // The fibre's direction is normalised by a square of what control_speed sums.
    if (!is_finite(S(control_speed * control_speed)) || !is_finite(S(size * size))) {
      return range_fault(index);
    }
    const double closeness = to_double(segment.closeness);
    return Fault{FaultCode::no_interpolant,
                 "segment " + std::to_string(index) +
                     ": the displacement asks the curve to turn back on itself (its middle "
                     "fibre is opposite to its neighbours); use shorter segments",
                 index,
                 "closeness",
                 closeness > 0.0 ? closeness : 0.0,  // not a number where no fibre exists at all
                 to_double(R(angle * angle))};
  }
  control_speed += dot(segment.preimage[m], segment.preimage[m]);
  if (!is_finite(control_speed)) return range_fault(index);
  control_speed = control_speed * ratio<S>(1, 2 * static_cast<std::int64_t>(m) + 1);
  if (!(value_of(control_speed) < accuracy::wild_interpolant<S>() * value_of(size))) {
    return Fault{FaultCode::no_interpolant,
                 "segment " + std::to_string(index) + ": the interpolant would wander " +
                     to_text(to_double(S(control_speed / size))) +
                     " times as far as its data reach; a speed is too small beside its "
                     "derivatives, or the parameter steps do not suit the points",
                 index,
                 "wandering",
                 to_double(S(control_speed / size)),
                 to_double(accuracy::wild_interpolant<S>())};
  }
  return std::nullopt;
}

/// The preimage of a segment in the data's own scale, after a constant roll.
template <class S, std::size_t n>
BernsteinPolynomial<Quaternion<S>, n> restored(
    const BernsteinPolynomial<Quaternion<S>, n>& preimage, const Roll<S>& roll, double scale) {
  const S factor(1.0 / scale);
  return preimage.mapped([&](const Quaternion<S>& a) { return factor * (a * roll); });
}

/// How far the stored curve's end is from the given displacement.
template <class S>
struct EndMiss {
  Vector3<S> miss;
  S size;  // its largest component
};
template <std::size_t n, class S>
EndMiss<S> end_miss(const SpatialPhCurve<n, S>& curve, const Vector3<S>& displacement) {
  const Vector3<S> miss = displacement - curve.integral().back().displacement;
  return {miss, largest_component(miss)};
}

/// Whether a miss is at most accuracy::settled_end of the curve's largest displacement coefficient;
/// most often the last one is large enough to tell.
template <std::size_t n, class S>
bool is_settled(const SpatialPhCurve<n, S>& curve, const EndMiss<S>& miss) {
  const S share(accuracy::settled_end<S>());
  const auto& integral = curve.integral().coefficients();
  if (miss.size <= share * largest_component(integral.back().displacement)) return true;
  S scale(0);
  for (const auto& c : integral) {
    const S component = largest_component(c.displacement);
    scale = select(scale < component, component, scale);
  }
  return !(share * scale < miss.size);
}

/// Settles the middle coefficient of a new curve on the stored numbers: the position polynomial is
/// summed from rounded products, so the end it reaches may miss the datum by more than it need.
/// While it is not settled, the middle coefficient takes a Newton step, 2h A_p ⋆ dA = miss; the
/// best of at most four is kept. A Fault where the curve's numbers overflow.
template <std::size_t n, class S>
std::optional<Fault> settle(SpatialPhCurve<n, S>& curve, const Vector3<S>& displacement,
                            std::size_t index) {
  constexpr int most_steps = 4;
  constexpr std::size_t m = n / 2;
  if (!is_finite(curve.end()) || !is_finite(curve.arc_length())) return range_fault(index);
  EndMiss<S> best = end_miss(curve, displacement);
  if (is_settled(curve, best)) return std::nullopt;
  const auto& t = tables<S, m>();
  const S h = curve.parameter_step();
  auto preimage = curve.preimage();
  EndMiss<S> miss = best;
  for (int step = 0; step < most_steps && !is_settled(curve, best); ++step) {
    Quaternion<S> moment{};
    for (std::size_t i = 0; i <= n; ++i) moment = moment + S(t.full_moment[i]) * preimage[i];
    preimage[m] += solve_linear((S(0.5) / h) * miss.miss, moment, S(1) / dot(moment, moment), S(0));
    const SpatialPhCurve<n, S> next(curve.start(), preimage, h);
    miss = end_miss(next, displacement);
    if (miss.size < best.size) {
      best = miss;
      curve = next;
    }
  }
  return std::nullopt;
}

/// The curve of a finished segment with the given ends, its preimage brought back to the data's own
/// scale.
template <std::size_t m, class S>
Result<SpatialPhCurve<2 * m, S>> settled_curve(const HermitePoint<m, S>& begin,
                                               const HermitePoint<m, S>& end, const S& h,
                                               const Segment<S, m>& segment, double scale) {
  Result<SpatialPhCurve<2 * m, S>> curve(std::in_place, begin[0], S(1.0 / scale) * segment.preimage,
                                         h);
  if (auto fault = settle(*curve, end[0] - begin[0], 0)) curve = *std::move(fault);
  return curve;
}

/// A quaternion U with U i U* along v_b + v_e: the reference of the standard form. Along the chord
/// where that sum vanishes against the speeds (errata: half circle) or is opposite to one of them,
/// so that no member of that fibre is nearest to U; nothing where the chord does not help either.
template <class S>
std::optional<Quaternion<S>> reference_quaternion(const Vector3<S>& velocity_begin,
                                                  const Vector3<S>& velocity_end,
                                                  const Vector3<S>& chord) {
  using std::sqrt;
  const auto over = [](const Vector3<S>& v, const S& size) {  // 1/size might overflow
    return Vector3<S>{v.x / size, v.y / size, v.z / size};
  };
  const auto unit = [&](const Vector3<S>& v) {
    const Vector3<S> w = over(v, largest_component(v));
    return (S(1) / sqrt(dot(w, w))) * w;
  };
  const Vector3<S> begin = unit(velocity_begin), end = unit(velocity_end);
  // 1 + cos of the angle between two directions, twice the closeness of their fibres, must be more
  // than its rounding (at most 8 ε) by the closeness that is asked for elsewhere.
  const auto serves = [&](const Vector3<S>& direction) {
    using R = real_of_t<S>;
    const R angle = accuracy::opposite_fibre_angle<S>();
    const R least = R(2) * angle * angle + R(8) * epsilon<S>();
    return value_of(S(1) + dot(begin, direction)) > least &&
           value_of(S(1) + dot(end, direction)) > least;
  };
  const S speeds =
      S(0.5) * largest_component(velocity_begin) + S(0.5) * largest_component(velocity_end);
  const Vector3<S> sum = over(velocity_begin, speeds) + over(velocity_end, speeds);
  if (value_of(largest_component(sum)) > accuracy::opposite_fibre_angle<S>()) {
    const Vector3<S> direction = unit(sum);
    if (serves(direction)) return fibre(direction);
  }
  if (!(S(0) < largest_component(chord))) return std::nullopt;
  const Vector3<S> direction = unit(chord);
  if (!serves(direction)) return std::nullopt;
  return fibre(direction);
}

inline Fault no_reference_fault(std::size_t index) {
  return {FaultCode::no_interpolant,
          "segment " + std::to_string(index) +
              ": the end velocities are opposite and the displacement gives no other direction, so "
              "there is no standard form; use order_ten or shorter segments",
          index,
          "velocity",
          std::nullopt,
          std::nullopt};
}

/// The twist that gives the Bernstein coefficients of the local preimage (√h A) the τ of Lemma 1:
/// <A^(j), A i> = n!/(n-j)! h^-j Σ_{i=1..j} (-1)^{j-i} C(j,i) (-τ_i), over h for the local scale.
/// side is +1 at the start and -1 at the end.
template <class S, std::size_t m>
struct GivenTau {
  const std::array<S, (m > 1 ? m - 1 : 1)>& tau;
  S h;
  double side;
  S operator()(const EndJet<S, m>&, std::size_t r) const {
    S sum(0), factor(1);
    for (std::size_t i = 1; i <= r; ++i) {
      const double sign = (r - i) % 2 == 0 ? -1.0 : 1.0;
      sum = sum + S(sign * static_cast<double>(binomial(r, i))) * tau[i - 1];
      factor = factor * S(side * static_cast<double>(2 * m - i + 1)) / h;
    }
    return factor * sum / h;
  }
};

template <std::size_t m, class S>
std::array<Vector3<S>, m> scaled_derivatives(const HermitePoint<m, S>& point, double scale) {
  std::array<Vector3<S>, m> result;
  for (std::size_t r = 0; r < m; ++r) result[r] = S(scale * scale) * point[r + 1];
  return result;
}

template <std::size_t m, class S>
std::optional<Fault> ends_fault(const HermitePoint<m, S>& begin, const HermitePoint<m, S>& end,
                                const S& h) {
  if (auto fault = construction_detail::step_fault(h)) return fault;
  if (auto fault = point_fault<m, S>(begin, 0)) return fault;
  return point_fault<m, S>(end, 1);
}

template <std::size_t m, class S>
double prescale_of(std::span<const HermitePoint<m, S>> points) {
  double largest = 0;
  for (const auto& point : points) {
    largest = std::max(largest, to_double(largest_component(point[1])));
  }
  return prescale(largest);
}
template <std::size_t m, class S>
double prescale_of(const HermitePoint<m, S>& begin, const HermitePoint<m, S>& end) {
  return prescale(
      std::max(to_double(largest_component(begin[1])), to_double(largest_component(end[1]))));
}

/// The segment between two end jets; a Fault where it does not exist.
template <std::size_t m, class S>
std::optional<Fault> make_segment(const HermitePoint<m, S>& begin, const HermitePoint<m, S>& end,
                                  const EndJet<S, m>& start_jet, const EndJet<S, m>& end_jet,
                                  const S& h, double scale, HermiteChoice choice, std::size_t index,
                                  Segment<S, m>& segment) {
  const Vector3<S> mean_velocity = (S(scale * scale) / h) * (end[0] - begin[0]);
  if (choice == HermiteChoice::order_ten) {
    segment = twist_free_segment<S, m>(start_jet, end_jet, h, mean_velocity);
  } else {
    const auto reference = reference_quaternion(begin[1], end[1], end[0] - begin[0]);
    if (!reference) return no_reference_fault(index);
    segment = reference_segment<S, m>(start_jet, end_jet, h, mean_velocity, *reference, {}, {}, {});
  }
  return segment_fault<m, S>(segment, begin, end, h, scale, index);
}

/// The end jet at a point whose data are fit for it.
template <std::size_t m, class S>
EndJet<S, m> jet_at(const Vector3<S>* derivatives, HermiteChoice choice) {
  return choice == HermiteChoice::order_ten ? end_jet<m, S>(derivatives, RotationMinimising{})
                                            : end_jet<m, S>(derivatives, ZeroTau{});
}
template <std::size_t m, class S>
EndJet<S, m> checked_jet(const HermitePoint<m, S>& point, double scale, HermiteChoice choice) {
  return jet_at<m, S>(scaled_derivatives<m, S>(point, scale).data(), choice);
}

/// The jets at both ends; for double the two go through the arithmetic side by side.
template <class S, std::size_t m>
struct EndJets {
  EndJet<S, m> start, end;
};
template <std::size_t m, class S>
EndJets<S, m> checked_jets(const HermitePoint<m, S>& begin, const HermitePoint<m, S>& end,
                           double scale, HermiteChoice choice) {
#if defined(__GNUC__)  // GCC and Clang: vector extensions
  if constexpr (std::is_same_v<S, double>) {
    using Both = Pack<2, BothEnds>;
    const Both square(scale * scale);
    std::array<Vector3<Both>, m> derivatives;
    for (std::size_t r = 0; r < m; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        derivatives[r][c] = square * Both(Both::Lanes{begin[r + 1][c], end[r + 1][c]});
      }
    }
    const EndJet<Both, m> both = jet_at<m, Both>(derivatives.data(), choice);
    EndJets<S, m> result;
    for (std::size_t r = 0; r < m; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        result.start[r][c] = both[r][c][0];
        result.end[r][c] = both[r][c][1];
      }
    }
    return result;
  }
#endif
  return {checked_jet<m, S>(begin, scale, choice), checked_jet<m, S>(end, scale, choice)};
}

/// The segments of a path in order, computed in batches where that is faster.
template <std::size_t m, class S>
class SegmentSequence {
 public:
  SegmentSequence(std::span<const S> knots, std::span<const HermitePoint<m, S>> points,
                  double scale, HermiteChoice choice)
      : knots_(knots), points_(points), scale_(scale), choice_(choice) {}

  /// Makes segment k; to be asked in order, for knots that increase up to k + 1.
  std::optional<Fault> make(std::size_t k) {
    if constexpr (batched) {
      if (choice_ == HermiteChoice::order_ten) return from_batch(k);
    }
    const EndJet<S, m> start = k == 0 ? jet(0) : next_;
    next_ = jet(k + 1);
    current_ = 0;
    return make_segment<m, S>(points_[k], points_[k + 1], start, next_, knots_[k + 1] - knots_[k],
                              scale_, choice_, k, segments_[0]);
  }
  /// The segment made last.
  const Segment<S, m>& segment() const { return segments_[current_]; }

 private:
  static constexpr bool batched = std::is_same_v<S, double> && m == 4;

  EndJet<S, m> jet(std::size_t k) const { return checked_jet<m, S>(points_[k], scale_, choice_); }

  std::optional<Fault> from_batch(std::size_t k) {
    if (k >= batch_end_) {
      std::array<double, longest_batch> steps;
      std::size_t count = 0;
      while (count < longest_batch && k + count + 1 < points_.size()) {
        steps[count] = knots_[k + count + 1] - knots_[k + count];
        ++count;
      }
      twist_free_segments(points_.data() + k, steps.data(), scale_ * scale_, count,
                          segments_.data());
      batch_begin_ = k;
      batch_end_ = k + count;
    }
    current_ = k - batch_begin_;
    return segment_fault<m, S>(segment(), points_[k], points_[k + 1], knots_[k + 1] - knots_[k],
                               scale_, k);
  }

  std::span<const S> knots_;
  std::span<const HermitePoint<m, S>> points_;
  double scale_;
  HermiteChoice choice_;
  EndJet<S, m> next_{};
  std::size_t batch_begin_ = 0, batch_end_ = 0, current_ = 0;
  std::array<Segment<S, m>, (batched ? longest_batch : 1)> segments_;
};

}  // namespace hermite_detail

template <std::size_t m, class S>
Result<SpatialPhCurve<2 * m, S>> hermite_curve(const HermitePoint<m, S>& begin,
                                               const HermitePoint<m, S>& end, const S& h,
                                               HermiteChoice choice) {
  using namespace hermite_detail;
  if (auto fault = ends_fault<m, S>(begin, end, h)) return *fault;
  const double scale = prescale_of<m, S>(begin, end);
  const auto jets = checked_jets<m, S>(begin, end, scale, choice);
  Segment<S, m> segment;
  if (auto fault =
          make_segment<m, S>(begin, end, jets.start, jets.end, h, scale, choice, 0, segment)) {
    return *std::move(fault);
  }
  return settled_curve<m, S>(begin, end, h, segment, scale);
}

template <std::size_t m, class S>
Result<SpatialPhCurve<2 * m, S>> hermite_curve(const HermitePoint<m, S>& begin,
                                               const HermitePoint<m, S>& end, const S& h,
                                               const HermiteParameters<m, S>& parameters) {
  using namespace hermite_detail;
  using std::cos;
  using std::sin;
  if (auto fault = ends_fault<m, S>(begin, end, h)) return *fault;
  const double scale = prescale_of<m, S>(begin, end);
  const auto scaled_tau = [&](auto tau) {  // τ scales with the square of the preimage
    for (auto& t : tau) t = S(scale * scale) * t;
    return tau;
  };
  const auto tau_begin = scaled_tau(parameters.tau_begin);
  const auto tau_end = scaled_tau(parameters.tau_end);
  const auto from_begin = scaled_derivatives<m, S>(begin, scale);
  const auto from_end = scaled_derivatives<m, S>(end, scale);
  const auto start_jet = end_jet<m, S>(from_begin.data(), GivenTau<S, m>{tau_begin, h, 1.0});
  const auto far_jet = end_jet<m, S>(from_end.data(), GivenTau<S, m>{tau_end, h, -1.0});
  const auto reference = reference_quaternion(begin[1], end[1], end[0] - begin[0]);
  if (!reference) return no_reference_fault(0);
  const auto turn = [](const S& angle) { return Roll<S>{cos(angle), sin(angle)}; };
  const Vector3<S> mean_velocity = (S(scale * scale) / h) * (end[0] - begin[0]);
  const auto segment = reference_segment<S, m>(
      start_jet, far_jet, h, mean_velocity, *reference, turn(parameters.theta_begin),
      turn(parameters.theta_middle), turn(parameters.theta_end));
  if (auto fault = segment_fault<m, S>(segment, begin, end, h, scale, 0)) return *fault;
  return settled_curve<m, S>(begin, end, h, segment, scale);
}

template <std::size_t m, class S>
Result<SpatialPath<2 * m, S>> hermite_path(std::vector<S> knots,
                                           std::span<const HermitePoint<m, S>> points,
                                           HermiteChoice choice, bool closed) {
  using namespace hermite_detail;
  using std::sqrt;
  if (auto fault = construction_detail::points_on_knots_fault<S>(points.size(), knots)) {
    return *std::move(fault);
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (auto fault = point_fault<m, S>(points[k], k)) return *fault;
  }
  const double scale = prescale_of<m, S>(points);
  std::vector<SpatialPhCurve<2 * m, S>> segments;
  segments.reserve(points.size() - 1);
  SegmentSequence<m, S> sequence(knots, points, scale, choice);
  Roll<S> roll;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const S h = knots[k + 1] - knots[k];
    if (auto fault = sequence.make(k)) return *std::move(fault);
    const Segment<S, m>& segment = sequence.segment();
    segments.emplace_back(points[k][0], restored(segment.preimage, roll, scale), h);
    if (auto fault = settle(segments.back(), points[k + 1][0] - points[k][0], k)) return *fault;
    const Roll<S>& q = segment.roll;
    roll = {roll.cosine * q.cosine - roll.sine * q.sine,
            roll.cosine * q.sine + roll.sine * q.cosine};
    const S size = sqrt(roll.cosine * roll.cosine + roll.sine * roll.sine);
    roll = {roll.cosine / size, roll.sine / size};
  }
  return SpatialPath<2 * m, S>::create(std::move(knots), std::move(segments), closed);
}

}  // namespace hodograph
