// SPDX-License-Identifier: MIT
#include "hodograph/orbit/orbit_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "motion_checks.hpp"
#include "series_step.hpp"

namespace hodograph {
namespace {

/// Half a revolution is refused where it takes more series than this (a near-rectilinear halo
/// orbit takes about 30): 14 MiB, reached only by orbits all but colliding with a primary.
constexpr std::size_t most_series = 20'000;

constexpr std::size_t derivative_count = 5;

}  // namespace

struct OrbitCurve::Series {
  /// One series: on [start, start + step] position Σ_k coefficients[k] u^k, u = (t - start) / step.
  struct Piece {
    long double step{};
    std::array<Vector3<double>, series_order + 1> coefficients{};
  };
  PeriodicOrbit orbit;
  std::vector<long double> starts;  // of the pieces, increasing from 0
  std::vector<Piece> pieces;

  /// Position and derivatives with respect to time, for 0 ≤ t ≤ period / 2.
  MotionJet<double, derivative_count> evaluate_half(long double t) const {
    const auto after = std::upper_bound(starts.begin() + 1, starts.end(), t);
    const auto index = static_cast<std::size_t>(after - starts.begin()) - 1;
    const Piece& piece = pieces[index];
    const double u = static_cast<double>((t - starts[index]) / piece.step);
    // Horner's scheme for the value and, one behind the other, the derivatives over r!.
    MotionJet<double, derivative_count> jet{};
    for (std::size_t k = series_order + 1; k-- > 0;) {
      const Vector3<double>& c = piece.coefficients[k];
      for (std::size_t r = derivative_count - 1; r > 0; --r) {
        jet[r].x = jet[r].x * u + jet[r - 1].x;
        jet[r].y = jet[r].y * u + jet[r - 1].y;
        jet[r].z = jet[r].z * u + jet[r - 1].z;
      }
      jet[0].x = jet[0].x * u + c.x;
      jet[0].y = jet[0].y * u + c.y;
      jet[0].z = jet[0].z * u + c.z;
    }
    const double rate = static_cast<double>(1.0L / piece.step);
    double factor = 1.0;
    for (std::size_t r = 1; r < derivative_count; ++r) {
      factor *= static_cast<double>(r) * rate;
      jet[r] = factor * jet[r];
    }
    return jet;
  }

  /// The same for 0 ≤ t ≤ period: r(period - t) = diag(1, -1, 1) r(t).
  MotionJet<double, derivative_count> evaluate(long double t) const {
    if (t + t <= orbit.period) return evaluate_half(t);
    MotionJet<double, derivative_count> jet = evaluate_half(orbit.period - t);
    for (std::size_t r = 0; r < derivative_count; ++r) {
      if (r % 2 == 0) {
        jet[r].y = -jet[r].y;
      } else {
        jet[r].x = -jet[r].x;
        jet[r].z = -jet[r].z;
      }
    }
    return jet;
  }
};

Result<OrbitCurve> OrbitCurve::make(const PeriodicOrbit& orbit, OrbitFrame frame,
                                    OrbitParameter parameter, std::size_t revolutions) {
  const PropagationOptions options{};
  if (auto fault = motion_checks::check_start(orbit.system, orbit.initial, options)) {
    return std::move(*fault);
  }
  if (!(orbit.period > 0.0L) || !is_finite(orbit.period)) {
    return Fault{FaultCode::outside_domain,
                 "the orbit's period is " + motion_checks::text(orbit.period) +
                     "; it must be positive and finite",
                 {},
                 "period",
                 static_cast<double>(orbit.period),
                 0.0};
  }
  if (revolutions == 0) {
    return Fault{FaultCode::outside_domain,
                 "the number of revolutions is 0; it must be at least 1",
                 {},
                 "revolutions",
                 0.0,
                 1.0};
  }
  const auto check_crossing = [](const OrbitState<long double>& s,
                                 const char* where) -> std::optional<Fault> {
    const long double miss =
        std::max(std::max(std::abs(s.position.y), std::abs(s.velocity.x)), std::abs(s.velocity.z));
    if (miss <= crossing_tolerance) return std::nullopt;
    return Fault{FaultCode::not_continuous,
                 std::string("the orbit misses a perpendicular crossing of y = 0 ") + where +
                     " by " + motion_checks::text(miss) + "; at most " +
                     motion_checks::text(crossing_tolerance) +
                     " is allowed (correct_symmetric_orbit gives such an orbit)",
                 {},
                 "crossing",
                 static_cast<double>(miss),
                 static_cast<double>(crossing_tolerance)};
  };
  if (auto fault = check_crossing(orbit.initial, "at its start")) return std::move(*fault);

  auto series = std::make_shared<Series>();
  series->orbit = orbit;
  const long double half = 0.5L * orbit.period;
  OrbitState<long double> state = orbit.initial;
  for (long double time = 0.0L; time < half;) {
    if (series->pieces.size() == most_series) {
      return motion_checks::too_many_steps(time, half, {.max_steps = most_series});
    }
    const long double larger = norm(offset_from_larger(orbit.system, state.position));
    const long double smaller = norm(offset_from_smaller(orbit.system, state.position));
    for (const auto& [primary, distance] : {std::pair{motion_checks::Primary::larger, larger},
                                            std::pair{motion_checks::Primary::smaller, smaller}}) {
      if (auto fault = motion_checks::check_distance(primary, distance, time, options)) {
        return std::move(*fault);
      }
    }
    const MotionSeries motion = motion_series<series_order>(orbit.system, state);
    const long double step = std::min(series_step(motion, std::min(larger, smaller)), half - time);
    if (!(time + step > time)) return motion_checks::stalled(time, half);
    Series::Piece piece;
    piece.step = step;
    long double power = 1.0L;
    for (std::size_t k = 0; k <= series_order; ++k) {
      for (std::size_t i = 0; i < 3; ++i) {
        piece.coefficients[k][i] = static_cast<double>(motion[i][k] * power);
      }
      power *= step;
    }
    series->starts.push_back(time);
    series->pieces.push_back(piece);
    state = sum_series(motion, step);
    // The last piece ends at half the period, whatever rounding its end is subject to.
    time = step == half - time ? half : time + step;
  }
  if (auto fault = check_crossing(state, "half a period later")) return std::move(*fault);

  OrbitCurve curve;
  curve.frame_ = frame;
  curve.parameter_ = parameter;
  curve.revolutions_ = revolutions;
  curve.end_ = static_cast<double>(static_cast<long double>(revolutions) *
                                   (parameter == OrbitParameter::time ? orbit.period : 1.0L));
  curve.series_ = std::move(series);
  return curve;
}

std::array<Vector3<double>, 5> OrbitCurve::operator()(double xi) const {
  assert(std::isfinite(xi));
  const long double period = series_->orbit.period;
  const bool is_time = parameter_ == OrbitParameter::time;
  const long double time = is_time ? static_cast<long double>(xi) : xi * period;
  long double phase = 0.0L;  // time since the last passage of the initial state
  if (is_time) {
    phase = time >= 0.0L && time < period ? time : std::fmod(time, period);
    if (phase < 0.0L) phase += period;
  } else {
    phase = (static_cast<long double>(xi) - std::floor(static_cast<long double>(xi))) * period;
  }
  MotionJet<double, derivative_count> jet = series_->evaluate(phase);
  if (frame_ == OrbitFrame::earth_centred_inertial) {
    jet = to_earth_centred_inertial(series_->orbit.system, jet, static_cast<double>(std::cos(time)),
                                    static_cast<double>(std::sin(time)));
  }
  if (!is_time) {
    double factor = 1.0;
    for (std::size_t r = 1; r < derivative_count; ++r) {
      factor *= static_cast<double>(period);
      jet[r] = factor * jet[r];
    }
  }
  return jet;
}

const PeriodicOrbit& OrbitCurve::orbit() const { return series_->orbit; }

std::size_t OrbitCurve::series_count() const { return series_->pieces.size(); }

}  // namespace hodograph
