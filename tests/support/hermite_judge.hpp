// SPDX-License-Identifier: MIT
// The judge of Hermite interpolation: an accepted curve must meet its data, and a refusal must be
// right, by arithmetic wider than the one that refused.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

#include "hodograph/construction/hermite.hpp"
#include "hodograph/curve/preimage_jet.hpp"
#include "tests/support/hermite_data.hpp"
#include "tests/support/paths.hpp"

namespace hodograph::test {

/// What became of one set.
struct Verdict {
  bool accepted = false;
  FaultCode code{};       ///< why it was refused
  std::string quantity;   ///< what of the fault
  std::string complaint;  ///< empty: rightly so
  double worst = 0.0;     ///< accepted: the largest miss over what is allowed
};

/// What the kernel says of a set in a wider scalar, without limits.
template <class T>
struct Opinion {
  bool has_reference = true;
  T closeness{}, wandering{};
  T smallest_speed{};
  T largest{};  ///< of the data per unit ξ, of what h makes of them, and of the end preimages' jets
};

template <std::size_t m, class T>
Opinion<T> opinion_of(const HermiteSet<m>& set, HermiteChoice choice) {
  using namespace hermite_detail;
  const auto wide = converted_set<T, m>(set);
  // The displacement as the construction sees it, rounded.
  const Vector3<double> rounded = set.end[0] - set.begin[0];
  const Vector3<T> displacement = converted<T>(rounded);
  Opinion<T> opinion;
  const auto start = checked_jet<m, T>(wide.begin, 1.0, choice);
  const auto end = checked_jet<m, T>(wide.end, 1.0, choice);
  const Vector3<T> mean_velocity = (T(1) / wide.h) * displacement;
  Segment<T, m> segment;
  if (choice == HermiteChoice::order_ten) {
    segment = twist_free_segment<T, m>(start, end, wide.h, mean_velocity);
  } else {
    const auto reference = reference_quaternion(wide.begin[1], wide.end[1], displacement);
    if (!reference) {
      opinion.has_reference = false;
      return opinion;
    }
    segment = reference_segment<T, m>(start, end, wide.h, mean_velocity, *reference, {}, {}, {});
  }
  opinion.closeness = segment.closeness;
  T control_speed(0);
  for (const auto& a : segment.preimage.coefficients()) control_speed += dot(a, a);
  T size = largest_component(mean_velocity), weight(1);
  for (std::size_t r = 1; r <= m; ++r) {
    size += weight * (largest_component(wide.begin[r]) + largest_component(wide.end[r]));
    weight = weight * wide.h / T(static_cast<double>(r + 1));
  }
  opinion.wandering = control_speed / (T(static_cast<double>(2 * m + 1)) * size);
  opinion.largest = wide.h < T(1) ? size : T(wide.h * size);
  opinion.smallest_speed =
      std::min<T>(largest_component(wide.begin[1]), largest_component(wide.end[1]));
  for (const auto* jet : {&start, &end}) {
    for (const auto& a : *jet) {
      if (opinion.largest < largest_component(a)) opinion.largest = largest_component(a);
    }
  }
  return opinion;
}

/// Judges the curve of a set: every number finite; position and derivatives 1 to m at both ends
/// within accuracy::continuity_error (over h^r) of the data, evaluated in long double from the
/// stored preimage.
template <std::size_t m>
void judge_accepted(const HermiteSet<m>& set, const SpatialPhCurve<2 * m>& curve,
                    Verdict& verdict) {
  using L = long double;
  std::ostringstream complaint;
  bool finite = is_finite(curve.start()) && is_finite(curve.arc_length());
  L size = 0;
  for (const auto& c : curve.displacement().coefficients()) {
    finite = finite && is_finite(c);
    size = std::max<L>(size, largest_component(c));
  }
  for (const auto& a : curve.preimage().coefficients()) finite = finite && is_finite(a);
  if (!finite) {
    verdict.complaint = "accepted with numbers that are not finite";
    return;
  }
  if (!(curve.start() == set.begin[0])) complaint << "does not start where it should; ";
  const L coordinate = std::max<L>(size, largest_component(set.end[0]));
  // A rounding of A moves the end by ε of the displacement: half is left to four components each.
  const L allowed_end = 2 * accuracy::continuity_error<double>(4 * m + 1, 0) * coordinate;
  const L miss_end = largest_component(curve.end() - set.end[0]);
  const auto note = [&](const char* what, std::size_t r, L miss, L allowed) {
    if (miss == 0) return;
    verdict.worst = std::max(verdict.worst, static_cast<double>(miss / allowed));
    if (!(miss <= allowed)) {
      complaint << "accepted, but " << what << " derivative " << r << " missed by " << miss
                << ", allowed " << allowed << "; ";
    }
  };
  note("end", 0, miss_end, allowed_end);
  const auto preimage =
      curve.preimage().mapped([](const Quaternion<double>& a) { return converted<L>(a); });
  const L h = set.h;
  for (const bool at_end : {false, true}) {
    auto jet = preimage.template jet<m - 1>(at_end ? L(1) : L(0));
    const auto hodograph = hodograph_derivatives(jet);  // with respect to u, but for one h
    L power = 1;
    for (std::size_t r = 1; r <= m; ++r) {
      const Vector3<L> datum = converted<L>((at_end ? set.end : set.begin)[r]);
      const L miss = h * largest_component(hodograph[r - 1] - (power * datum));
      note(at_end ? "end" : "start", r, miss,
           accuracy::continuity_error<double>(4 * m + 1, r) * size);
      power *= h;
    }
  }
  verdict.complaint = complaint.str();
}

/// A refusal for reason of the fibre is right where the exact closeness is below this many times
/// the limit, one for wandering where the exact figure is above this share of its limit: what is
/// lost when the rounded numbers decide.
inline constexpr double near_closeness_limit = 4.0;
inline constexpr double near_wandering_limit = 0.5;

/// The square root of the largest double: beyond it products overflow.
inline constexpr double largest_square = 0x1p511;

/// Whether neither v_b + v_e nor the chord gives the standard form a direction: the first vanishes
/// against the speeds or both are opposite to a velocity, to the angle √ε, doubled.
template <std::size_t m>
bool lacks_reference(const HermiteSet<m>& set) {
  using L = long double;
  const auto unit = [](const Vector3<L>& v) {
    const L size = largest_component(v);
    const Vector3<L> w{v.x / size, v.y / size, v.z / size};
    return (L(1) / norm(w)) * w;
  };
  const Vector3<L> begin = converted<L>(set.begin[1]), end = converted<L>(set.end[1]);
  const Vector3<L> chord = converted<L>(set.end[0] - set.begin[0]), sum = begin + end;
  const auto fails = [&](const Vector3<L>& direction) {
    if (largest_component(direction) == 0 || !is_finite(direction)) return true;
    const L opposite = 32.0L * epsilon<double>();
    return 1 + dot(unit(begin), unit(direction)) <= opposite ||
           1 + dot(unit(end), unit(direction)) <= opposite;
  };
  const L speeds = largest_component(begin) + largest_component(end);
  const bool noise = largest_component(sum) <= 2 * std::sqrt(epsilon<double>()) * speeds;
  return (noise || fails(sum)) && fails(chord);
}

template <std::size_t m, class T>
bool rightly_refused(const HermiteSet<m>& set, HermiteChoice choice, const std::string& quantity,
                     std::string& reason) {
  if (quantity == "velocity") return lacks_reference(set);
  const Opinion<T> opinion = opinion_of<m, T>(set, choice);
  std::ostringstream text;
  text << "closeness " << opinion.closeness << ", wandering " << opinion.wandering;
  reason = text.str();
  if (!opinion.has_reference) return false;
  // Not: true also for a NaN, which arises where the fibre does not exist at all.
  const bool turned = !(T(near_closeness_limit * epsilon<double>()) < opinion.closeness);
  const bool wanders =
      !(opinion.wandering < T(near_wandering_limit * accuracy::wild_interpolant<double>()));
  // The numbers leave the range within which they can be multiplied, or differ by more than it.
  const bool leaves = !(opinion.largest < T(largest_square)) ||
                      !(opinion.largest < T(largest_square) * opinion.smallest_speed) || wanders;
  // Where the interpolant would wander anyway, rounding decides of its middle fibre.
  return quantity == "closeness"   ? turned || wanders
         : quantity == "wandering" ? wanders
         : quantity == "range"     ? leaves
                                   : false;
}

template <std::size_t m>
void judge_refused(const HermiteSet<m>& set, HermiteChoice choice, const Fault& fault,
                   Verdict& verdict) {
  using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>,
                                             boost::multiprecision::et_off>;
  verdict.code = fault.code;
  verdict.quantity = fault.quantity;
  bool finite = true, still = false;
  for (const auto* point : {&set.begin, &set.end}) {
    for (const auto& v : *point) finite = finite && is_finite(v);
    still = still || largest_component((*point)[1]) == 0.0;
  }
  bool right =
      !fault.sentence.empty() && !(fault.value && std::isnan(*fault.value) && std::isfinite(set.h));
  std::string reason;
  switch (fault.code) {
    case FaultCode::not_finite:
      right = right && !finite;
      break;
    case FaultCode::zero_speed:
      right = right && still;
      break;
    case FaultCode::outside_domain:
      right = right && !(0 < set.h && std::isfinite(set.h));
      break;
    case FaultCode::no_interpolant:
      right = right && (rightly_refused<m, long double>(set, choice, fault.quantity, reason) ||
                        rightly_refused<m, Wide>(set, choice, fault.quantity, reason));
      break;
    default:
      right = false;
  }
  if (!right) {
    verdict.complaint = "wrongly refused: " + fault.sentence + " (in truth " + reason + ")";
  }
}

template <std::size_t m>
Verdict judged(const HermiteSet<m>& set, HermiteChoice choice) {
  Verdict verdict;
  const auto curve = hermite_curve<m, double>(set.begin, set.end, set.h, choice);
  if (curve) {
    verdict.accepted = true;
    judge_accepted<m>(set, *curve, verdict);
  } else {
    judge_refused<m>(set, choice, curve.fault(), verdict);
  }
  return verdict;
}

/// A set in full, to reproduce it.
template <std::size_t m>
std::string text_of(const HermiteSet<m>& set) {
  std::ostringstream text;
  text.precision(17);
  for (const auto* point : {&set.begin, &set.end}) {
    text << (point == &set.begin ? "begin" : "end");
    for (const auto& v : *point) text << " {" << v.x << ", " << v.y << ", " << v.z << "}";
    text << "; ";
  }
  text << "h = " << set.h;
  return text.str();
}

}  // namespace hodograph::test
