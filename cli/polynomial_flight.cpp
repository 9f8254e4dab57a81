// SPDX-License-Identifier: MIT
#include "cli/polynomial_flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/point_state.hpp"
#include "cli/sample_plan.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double rounded_up = 1.0 + 0x1.0p-40;  // not a tolerance: far more than the roundings
constexpr std::size_t most_pieces = 20'000;
constexpr std::size_t most_samples = 32'768;  // a piece that would need more is halved

using Vector = Vector3<double>;

/// Place, velocity, acceleration and jerk.
using MotionJet = std::array<Vector, 4>;

/// A stretch of time on one segment of the path and one piece of the law.
struct Stretch {
  double begin, end;
  std::size_t segment, law_piece;
};

class Flattener {
 public:
  Flattener(const AnyPath& path, const TimedMotion& motion, double tolerance)
      : path_(path), motion_(motion), tolerance_(tolerance) {}

  /// Adds the pieces of a stretch. Throws Error.
  void add(const Stretch& stretch, PolynomialFlight& flight) {
    const double middle = 0.5 * (stretch.begin + stretch.end);
    const bool divisible = stretch.begin < middle && middle < stretch.end;
    const PolynomialPiece piece = interpolant(stretch);
    const double error = error_of(piece, stretch, divisible);
    if (error <= tolerance_) {
      flight.error = std::max(flight.error, error);
      flight.pieces.push_back(piece);
      return;
    }
    if (!divisible || error < 4.0 * rounding() || flight.pieces.size() >= most_pieces) {
      throw Error(Fault{FaultCode::tolerance_not_reached,
                        std::to_string(flight.pieces.size()) +
                            " polynomials of degree seven follow the motion up to time " +
                            to_text(stretch.begin) + ", where the next is " +
                            (std::isfinite(error) ? to_text(error) + " off" : "not bounded") +
                            "; " + to_text(tolerance_) + " is asked for",
                        std::nullopt, "tolerance", error, tolerance_});
    }
    add({stretch.begin, middle, stretch.segment, stretch.law_piece}, flight);
    add({middle, stretch.end, stretch.segment, stretch.law_piece}, flight);
  }

 private:
  /// What rounding of places and times adds: of the time at which a stretch ends that has been
  /// merged with what is shorter than 64 ε of the times, too.
  double rounding() const {
    const TimingLaw& law = motion_.law();
    const double time = std::max(std::abs(law.start_time()), std::abs(law.end_time()));
    return motion_.position_error() + 256.0 * eps * law.most_speed() * (time + law.duration());
  }

  MotionJet jet(double t, const Stretch& stretch) const {
    const auto& piece = motion_.law().pieces()[stretch.law_piece];
    const double u =
        std::clamp((t - motion_.law().start_time() - piece.begin) / piece.duration, 0.0, 1.0);
    const double v = 2.0 * (piece.first * (1.0 - u) + piece.second * u) / piece.duration;
    const double a = 2.0 * (piece.second - piece.first) / (piece.duration * piece.duration);
    const double s = std::clamp(motion_.law().arc_length_at(t), 0.0, path_.arc_length());
    const double first = path_.knots()[stretch.segment];
    const double last = std::nextafter(path_.knots()[stretch.segment + 1],
                                       -std::numeric_limits<double>::infinity());
    const double xi = std::clamp(parameter_at(path_, s), first, std::max(first, last));
    const PointState state = state_at(path_, xi);
    // σ ξ' = v, and its derivatives.
    const double sigma = state.speed[0];
    const double x1 = v / sigma, x2 = (a - state.speed[1] * x1 * x1) / sigma;
    const double x3 = -(state.speed[2] * x1 * x1 * x1 + 3.0 * state.speed[1] * x1 * x2) / sigma;
    if (!(std::isfinite(x1) && std::isfinite(x2) && std::isfinite(x3))) {
      throw Error(Fault{
          FaultCode::outside_domain,
          "the path stands still at xi = " + to_text(xi) + "; its motion has no polynomials there",
          std::nullopt, "speed", sigma, 0.0});
    }
    const auto derivative = [&](std::size_t order) {
      const auto& p = state.position[order];
      return Vector{p[0], p[1], p.size() > 2 ? p[2] : 0.0};
    };
    const Vector d1 = derivative(1), d2 = derivative(2), d3 = derivative(3);
    return {motion_.position(t), x1 * d1, x1 * x1 * d2 + x2 * d1,
            x1 * x1 * x1 * d3 + (3.0 * x1 * x2) * d2 + x3 * d1};
  }

  PolynomialPiece interpolant(const Stretch& stretch) const {
    const MotionJet from = jet(stretch.begin, stretch), to = jet(stretch.end, stretch);
    PolynomialPiece piece;
    piece.duration = stretch.end - stretch.begin;
    const double h = piece.duration;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // In u = t/h: the cubic of the begin, and what is left at the end in u^4 ... u^7.
      const double c0 = from[0][axis], c1 = h * from[1][axis], c2 = h * h * from[2][axis] / 2.0,
                   c3 = h * h * h * from[3][axis] / 6.0;
      const double d0 = to[0][axis] - (c0 + c1 + c2 + c3);
      const double d1 = h * to[1][axis] - (c1 + 2.0 * c2 + 3.0 * c3);
      const double d2 = h * h * to[2][axis] - (2.0 * c2 + 6.0 * c3);
      const double d3 = h * h * h * to[3][axis] - 6.0 * c3;
      std::array<double, 8>& c = piece.coefficients[axis];
      c = {c0,
           c1,
           c2,
           c3,
           35.0 * d0 - 15.0 * d1 + 2.5 * d2 - d3 / 6.0,
           -84.0 * d0 + 39.0 * d1 - 7.0 * d2 + d3 / 2.0,
           70.0 * d0 - 34.0 * d1 + 6.5 * d2 - d3 / 2.0,
           -20.0 * d0 + 10.0 * d1 - 2.0 * d2 + d3 / 6.0};
      double power = 1.0;
      for (double& coefficient : c) {
        coefficient /= power;
        power *= h;
      }
    }
    return piece;
  }

  /// Of the parts of the segment that the stretch may touch.
  double most_curvature(const Stretch& stretch) const {
    const CurvatureParts& parts = motion_.places().parts();
    const double slack = motion_.law().arc_length_error() + 4.0 * parts.arc_length_error;
    const double first = motion_.law().arc_length_at(stretch.begin) - slack;
    const double last = motion_.law().arc_length_at(stretch.end) + slack;
    double most = 0.0;
    const std::size_t begin = stretch.segment * parts.per_segment;
    for (std::size_t i = begin; i < begin + parts.per_segment; ++i) {
      if (parts.arc_lengths[i + 1] < first || parts.arc_lengths[i] > last) continue;
      most = std::max(most, parts.most_curvature[i]);
    }
    return most;
  }

  double distance_at(const PolynomialPiece& piece, const Stretch& stretch, double t) const {
    Vector point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& c = piece.coefficients[axis];
      for (std::size_t k = 8; k-- > 0;) point[axis] = point[axis] * t + c[k];
    }
    return norm(point - motion_.position(stretch.begin + t));
  }

  /// The bound; infinite where a piece is too long for it and may be halved.
  double error_of(const PolynomialPiece& piece, const Stretch& stretch, bool divisible) const {
    const double h = piece.duration;
    Vector size{}, bend{};  // of the coefficients, and of the second derivative
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double power = 1.0;
      for (std::size_t k = 0; k < 8; ++k) {
        const double term = std::abs(piece.coefficients[axis][k]) * power;
        size[axis] += term;
        if (k >= 2) bend[axis] += static_cast<double>(k * (k - 1)) * term / (h * h);
        power *= h;
      }
    }
    const auto& law = motion_.law().pieces()[stretch.law_piece];
    const double v = 2.0 * std::max(law.first, law.second) / law.duration;
    const double a = motion_.law().acceleration_bound(stretch.law_piece);
    const double curvature = most_curvature(stretch);
    // The bound of what lies between samples should be a quarter of the tolerance.
    const double smooth = a + norm(bend), turning = curvature * v * v;
    const double count =
        std::ceil(h * std::min(std::sqrt((turning + smooth) / (2.0 * tolerance_)),
                               std::max(4.0 * v / tolerance_, std::sqrt(smooth / tolerance_))));
    if (!(count <= static_cast<double>(most_samples)) && divisible) {
      return std::numeric_limits<double>::infinity();
    }
    const auto samples =
        static_cast<std::size_t>(std::clamp(count, 8.0, static_cast<double>(most_samples)));
    // Most pieces that are too long show it at a few places.
    constexpr int looks = 16;
    double largest = 0.0;
    for (int i = 1; i < looks && divisible; ++i) {
      largest =
          std::max(largest, distance_at(piece, stretch, h * (static_cast<double>(i) / looks)));
      if (largest > tolerance_) return largest;
    }
    for (std::size_t i = 0; i <= samples; ++i) {
      const double t = h * (static_cast<double>(i) / static_cast<double>(samples));
      largest = std::max(largest, distance_at(piece, stretch, t));
      if (largest > tolerance_ && divisible) break;
    }
    const double gap = h / static_cast<double>(samples);
    constexpr double operations = 32.0;  // of Horner's scheme, twice what is needed
    const double between =
        std::min(turning * gap * gap / 8.0, v * gap / 2.0) + smooth * gap * gap / 8.0;
    return (largest + between + operations * eps * norm(size) + rounding()) * rounded_up;
  }

  const AnyPath& path_;
  const TimedMotion& motion_;
  double tolerance_;
};

/// The stretches of a motion, in order.
std::vector<Stretch> stretches_of(const AnyPath& path, const TimedMotion& motion) {
  const TimingLaw& law = motion.law();
  std::vector<double> times = {law.start_time(), law.end_time()};
  for (const auto& piece : law.pieces()) times.push_back(law.start_time() + piece.begin);
  std::vector<double> knots;
  for (const double s : path.knot_arc_lengths()) {
    knots.push_back(law.time_at(std::min(s, law.length())));
    times.push_back(knots.back());
  }
  std::sort(times.begin(), times.end());
  // What is shorter is rounding.
  const double shortest =
      64.0 * eps * std::max({std::abs(law.start_time()), std::abs(law.end_time()), law.duration()});
  std::vector<Stretch> stretches;
  double begin = law.start_time();
  for (const double end : times) {
    const bool last = end >= law.end_time();
    if (!(end - begin > shortest) || end > law.end_time()) continue;
    const double middle = 0.5 * (begin + end);
    const auto after = std::upper_bound(knots.begin(), knots.end(), middle);
    const auto segment = static_cast<std::size_t>(std::max<std::ptrdiff_t>(
        0, std::min<std::ptrdiff_t>(after - knots.begin() - 1,
                                    static_cast<std::ptrdiff_t>(path.segment_count()) - 1)));
    stretches.push_back({begin, end, segment, law.piece_at(middle - law.start_time())});
    begin = end;
    if (last) break;
  }
  if (!stretches.empty()) stretches.back().end = law.end_time();
  return stretches;
}

}  // namespace

Result<PolynomialFlight> polynomial_flight(const AnyPath& path, const TimedMotion& motion,
                                           double begin, double tolerance) {
  if (!(tolerance > 0.0 && std::isfinite(tolerance))) {
    return Fault{FaultCode::outside_domain,
                 "the tolerance of the polynomials must be positive; got " + to_text(tolerance),
                 std::nullopt,
                 "tolerance",
                 tolerance,
                 0.0};
  }
  // Their rounding alone: each piece is computed within so many ε of its coordinates.
  double far = 0.0;
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double time = motion.start_time() * (1.0 - share) + motion.end_time() * share;
    far = std::max(far, norm(motion.position(time)));
  }
  constexpr double roundings = 32.0;
  if (const double least = roundings * eps * far; !(tolerance > least)) {
    return Fault{FaultCode::tolerance_not_reached,
                 "the tolerance of the polynomials is " + to_text(tolerance) +
                     ", within the rounding of their coordinates; it must be above " +
                     to_text(least),
                 std::nullopt,
                 "tolerance",
                 tolerance,
                 least};
  }
  try {
    PolynomialFlight flight;
    if (motion.start_time() > begin) {
      PolynomialPiece hold;
      hold.duration = motion.start_time() - begin;
      const Vector place = motion.position(motion.start_time());
      for (std::size_t axis = 0; axis < 3; ++axis) hold.coefficients[axis][0] = place[axis];
      flight.pieces.push_back(hold);
    }
    Flattener flattener(path, motion, tolerance);
    for (const Stretch& stretch : stretches_of(path, motion)) flattener.add(stretch, flight);
    // Every duration is rounded, and so is the time at which a piece begins.
    flight.error = (flight.error + motion.law().most_speed() * eps *
                                       static_cast<double>(flight.pieces.size()) *
                                       (motion.end_time() - begin)) *
                   rounded_up;
    return flight;
  } catch (const Error& error) {
    return error.fault();
  }
}

std::string crazyswarm_csv(const PolynomialFlight& flight) {
  std::vector<std::string> names = {"duration"};
  for (const char* const axis : {"x", "y", "z", "yaw"}) {
    for (int k = 0; k < 8; ++k) names.push_back(std::string(axis) + "^" + std::to_string(k));
  }
  std::string text;
  append_csv_header(text, names);
  for (const PolynomialPiece& piece : flight.pieces) {
    std::vector<double> row = {piece.duration};
    for (const auto& axis : piece.coefficients) row.insert(row.end(), axis.begin(), axis.end());
    row.resize(names.size(), 0.0);
    append_csv_row(text, row);
  }
  return text;
}

}  // namespace hodograph::cli
