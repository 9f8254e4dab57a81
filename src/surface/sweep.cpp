// SPDX-License-Identifier: MIT
#include "hodograph/surface/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "exact_piece.hpp"
#include "hodograph/surface/sweep_contact.hpp"
#include "sweep_ring.hpp"

namespace hodograph {
namespace {

using surface_detail::exact_piece;
using surface_detail::ExactPiece;
using surface_detail::restricted;

/// Calls visit(part, exact) for the pieces, halved until their weights are positive.
template <class Visit>
std::optional<Fault> for_each_exact_piece(const Motion& motion, const Visit& visit) {
  if (motion.roll() != nullptr) {
    return Fault{FaultCode::unsupported,
                 "the frame's roll is not rational, and so is the surface; a rational one needs "
                 "the frame erf, closing, or periodic",
                 std::nullopt,
                 "frame",
                 std::nullopt,
                 std::nullopt};
  }
  constexpr int deepest = 24;
  struct Part {
    MotionPiece piece;
    int depth;
  };
  for (std::size_t k = 0; k < motion.pieces().size(); ++k) {
    std::vector<Part> open{{motion.pieces()[k], 0}};
    while (!open.empty()) {
      const Part part = std::move(open.back());
      open.pop_back();
      const ExactPiece exact = exact_piece(part.piece);
      const auto& weights = exact.weight.coefficients();
      if (std::all_of(weights.begin(), weights.end(), [](double w) { return w > 0.0; })) {
        visit(part.piece, exact);
        continue;
      }
      if (part.depth == deepest) {
        return Fault{FaultCode::zero_speed,
                     "the speed comes to zero at xi = " + to_text(part.piece.begin) +
                         ", where a sweep has no frame",
                     k,
                     "speed",
                     0.0,
                     std::nullopt};
      }
      open.push_back({restricted(part.piece, 0.5, 1.0), part.depth + 1});
      open.push_back({restricted(part.piece, 0.0, 0.5), part.depth + 1});
    }
  }
  return std::nullopt;
}

RationalPatch patch_of(const MotionPiece& part, const ExactPiece& exact,
                       const SpatialRationalBezier& curve) {
  const std::size_t degree = std::max(exact.center.degree(), exact.e1.degree());
  const auto center = exact.center.elevated(degree);
  const auto e1 = exact.e1.elevated(degree), e2 = exact.e2.elevated(degree),
             e3 = exact.e3.elevated(degree);
  const auto weight = exact.weight.elevated(degree);
  RationalPatch patch;
  patch.degree_v = degree;
  patch.degree_u = curve.degree();
  patch.begin_v = part.begin;
  patch.end_v = part.end;
  patch.begin_u = curve.begin;
  patch.end_u = curve.end;
  for (std::size_t i = 0; i <= degree; ++i) {
    for (std::size_t j = 0; j <= curve.degree(); ++j) {
      const Vector3<double>& p = curve.control_points[j];
      const Vector3<double> turned = p.x * e1[i] + p.y * e2[i] + p.z * e3[i];
      patch.weighted.push_back(curve.weights[j] * (center[i] + turned));
      patch.weights.push_back(curve.weights[j] * weight[i]);
    }
  }
  return patch;
}

}  // namespace

SurfacePoint point_of(const Sweep& sweep, std::size_t piece, double v, std::size_t smooth_piece,
                      double w) {
  const surface_detail::Ring ring(sweep.motion.at(piece, v));
  const auto p = sweep.profile.at(smooth_piece, w);
  return {ring.position(p.position), ring.normal(p.position, p.derivative)};
}

Result<std::vector<RationalPatch>> rational_patches(const Sweep& sweep) {
  std::vector<RationalPatch> patches;
  const auto fault =
      for_each_exact_piece(sweep.motion, [&](const MotionPiece& part, const ExactPiece& exact) {
        for (const auto& curve : sweep.profile.pieces()) {
          patches.push_back(patch_of(part, exact, curve));
        }
      });
  if (fault) return *fault;
  return patches;
}

Result<std::vector<SpatialRationalBezier>> offset_track(const Motion& motion,
                                                        const Vector3<double>& point) {
  const auto not_finite = [&](const std::string& sentence) {
    return Fault{FaultCode::not_finite, sentence,    std::nullopt, "point",
                 std::nullopt,          std::nullopt};
  };
  if (!is_finite(point)) return not_finite("the point of the track is not finite");
  std::vector<SpatialRationalBezier> curves;
  bool finite = true;
  const auto fault =
      for_each_exact_piece(motion, [&](const MotionPiece& part, const ExactPiece& exact) {
        const RationalPatch patch = patch_of(part, exact, {0.0, 1.0, {point, point}, {1.0, 1.0}});
        SpatialRationalBezier curve{part.begin, part.end, {}, {}};
        for (std::size_t i = 0; i <= patch.degree_v; ++i) {
          const double weight = patch.weights[patch.index(i, 0)];
          curve.weights.push_back(weight);
          curve.control_points.push_back((1.0 / weight) * patch.weighted[patch.index(i, 0)]);
          finite = finite && is_finite(curve.control_points.back());
        }
        curves.push_back(std::move(curve));
      });
  if (fault) return *fault;
  if (!finite) return not_finite("the track leaves the range of numbers; the point is too far");
  return curves;
}

SweepFold fold_of(const Sweep& sweep) {
  const Motion& motion = sweep.motion;
  if (!motion.is_adapted() || !sweep.profile.is_planar()) {
    return {SweepFold::Kind::undecided, motion.pieces().front().begin};
  }
  constexpr int deepest = 40;
  constexpr std::size_t most_parts = 200'000;  // a second's work
  struct Part {
    double a, b;
    int depth;
  };
  std::size_t parts = 0;
  std::optional<double> open_question;
  for (std::size_t k = 0; k < motion.pieces().size(); ++k) {
    const MotionPiece& piece = motion.pieces()[k];
    std::vector<Part> open{{0.0, 1.0, 0}};
    while (!open.empty()) {
      const Part part = open.back();
      open.pop_back();
      ++parts;
      const MotionBounds bounds = motion.bounds(k, part.a, part.b);
      double inward = 0.0;  // ≥ -λ (χ₂ p₂ - χ₃ p₁)
      if (motion.roll() == nullptr && !sweep.profile.circle_radius()) {
        for (const auto& curve : sweep.profile.pieces()) {
          for (const auto& p : curve.control_points) {
            const Enclosure turn =
                bounds.across_2 * Enclosure(p.z) - bounds.across_3 * Enclosure(p.y);
            inward = std::max(inward, -turn.lower());
          }
        }
      } else {
        inward = (sqrt(square(bounds.across_2) + square(bounds.across_3)) *
                  Enclosure(sweep.profile.reach()))
                     .upper();
      }
      if ((Enclosure(bounds.scale) * Enclosure(inward)).upper() < bounds.least_advance) continue;
      // A point where it does not advance settles it.
      const double v = 0.5 * (part.a + part.b);
      const MotionState state = motion.at(k, v);
      const double speed = norm(state.velocity);
      const double slack = (bounds.frame_rounding + bounds.rounding / speed) *
                           (speed + state.scale * norm(state.body_rate) * sweep.profile.reach());
      const auto folds = [&](const Vector3<double>& p) {
        return speed + state.scale * (state.body_rate.y * p.z - state.body_rate.z * p.y) < -slack;
      };
      // On a circle the most inward point is in the direction of the normal.
      const double across = std::hypot(state.body_rate.y, state.body_rate.z);
      bool certain = sweep.profile.circle_radius() && across > 0.0 &&
                     folds((*sweep.profile.circle_radius() / across) *
                           Vector3<double>{0.0, state.body_rate.z, -state.body_rate.y});
      for (const ProfileInterval& interval : sweep.profile.intervals()) {
        certain = certain || folds(sweep.profile.at(interval.piece, interval.begin).position) ||
                  folds(sweep.profile.at(interval.piece, interval.end).position);
      }
      if (certain) return {SweepFold::Kind::certain, piece.begin + v * (piece.end - piece.begin)};
      if (part.depth == deepest || parts > most_parts) {
        open_question = piece.begin + v * (piece.end - piece.begin);
        continue;
      }
      open.push_back({v, part.b, part.depth + 1});
      open.push_back({part.a, v, part.depth + 1});
    }
  }
  if (open_question) return {SweepFold::Kind::undecided, *open_question};
  return {};
}

double outer_radius(const Sweep& sweep) {
  return (Enclosure(sweep.motion.largest_scale()) * Enclosure(sweep.profile.reach())).upper();
}

bool is_certainly_free(const Sweep& sweep, const TubeRadius& tube) {
  return sweep.motion.is_adapted() && sweep.profile.is_planar() &&
         outer_radius(sweep) <= tube.radius.lower();
}

std::optional<Fault> contact_fault(const Sweep& sweep, const TubeRadius& tube) {
  const double outer = sweep.profile.circle_radius()
                           ? sweep.motion.largest_scale() * *sweep.profile.circle_radius()
                           : outer_radius(sweep);
  const double allowed = tube.radius.lower();
  if (sweep.profile.circle_radius()) {
    if (outer <= allowed || contact_of(sweep).free) return std::nullopt;
    std::string why;
    switch (tube.limit) {
      case TubeLimit::curvature:
        why = "it folds where the path is most curved";
        break;
      case TubeLimit::distance:
        why = tube.distance ? "it touches itself at xi = " + to_text(tube.distance->xi[0]) +
                                  " and " + to_text(tube.distance->xi[1])
                            : "it touches itself";
        break;
      case TubeLimit::corner:
        why = "the path has a corner at knot " + std::to_string(tube.knot);
        break;
      case TubeLimit::standstill:
        why = "the path may stand still";
        break;
    }
    return Fault{FaultCode::outside_domain,
                 "a tube of radius " + to_text(outer) + " meets itself: " + why +
                     "; a radius of at most " + to_text(allowed) + " does not",
                 std::nullopt,
                 "radius",
                 outer,
                 allowed};
  }
  if (is_certainly_free(sweep, tube)) return std::nullopt;
  const SweepFold fold = fold_of(sweep);
  if (fold.kind != SweepFold::Kind::certain) return std::nullopt;
  const double factor = largest_free_factor(sweep, tube, 1.0);
  return Fault{FaultCode::outside_domain,
               "the sweep folds at xi = " + to_text(fold.xi) +
                   ", where the path is too curved for the profile; " +
                   (factor > 0.0 ? "this one " + to_text(factor) + " times as large"
                                 : "a profile within " + to_text(allowed) + " of the path") +
                   " does not meet itself",
               std::nullopt,
               "profile",
               outer,
               allowed};
}

}  // namespace hodograph
