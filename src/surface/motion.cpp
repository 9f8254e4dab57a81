// SPDX-License-Identifier: MIT
#include "hodograph/surface/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "enclosed_polynomial.hpp"
#include "hodograph/bernstein/range.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "spatial_pieces.hpp"

namespace hodograph {
namespace {

using namespace surface_detail;

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest_coefficient(const DynamicPolynomial<Quaternion<double>>& f) {
  double size = 0.0;
  for (const auto& c : f.coefficients()) size = std::max(size, largest_component(c));
  return size;
}

/// How the preimage turns from an end to a start: as path_detail::preimage_turn.
struct Turn {
  Complex<double> roll{1.0, 0.0};  // after.front() * (roll as w + x i) points along before.back()
  double across = 0.0, along = 1.0, allowed = 0.0;
  bool is_break() const { return !(across <= allowed * along); }
};

Turn turn_between(const DynamicPolynomial<Quaternion<double>>& before,
                  const DynamicPolynomial<Quaternion<double>>& after) {
  const double end = largest_component(before.back());
  const double begin = largest_component(after.front());
  const auto q = conjugate((1.0 / begin) * after.front()) * ((1.0 / end) * before.back());
  Turn turn;
  turn.along = std::hypot(q.w, q.x);
  turn.across = std::hypot(q.y, q.z);
  if (turn.along > 0.0) turn.roll = {q.w / turn.along, q.x / turn.along};
  turn.allowed = accuracy::join_error<double>() *
                 (largest_coefficient(before) / end + largest_coefficient(after) / begin);
  return turn;
}

Fault break_fault(const Turn& turn, std::size_t knot) {
  const double angle = 2.0 * std::atan2(turn.across, turn.along);
  return {FaultCode::not_continuous,
          "the path has a corner of " + to_text(angle) + " rad at knot " + std::to_string(knot) +
              ", where a sweep would tear; round it first",
          knot,
          "tangent",
          angle,
          2.0 * turn.allowed};
}

Fault still_fault(std::size_t knot) {
  return {FaultCode::zero_speed,
          "the path stands still at knot " + std::to_string(knot) + ": no frame exists there",
          knot,
          "speed",
          0.0,
          std::nullopt};
}

DynamicPolynomial<Quaternion<double>> rolled(const DynamicPolynomial<Quaternion<double>>& preimage,
                                             const DynamicPolynomial<Complex<double>>& q) {
  return product(preimage, q, [](const Quaternion<double>& a, const Complex<double>& b) {
    return a * Quaternion<double>{b.re, b.im, 0.0, 0.0};
  });
}
DynamicPolynomial<Quaternion<double>> rolled(const DynamicPolynomial<Quaternion<double>>& preimage,
                                             const Complex<double>& q) {
  if (q == Complex<double>{1.0, 0.0}) return preimage;
  return rolled(preimage, DynamicPolynomial<Complex<double>>{q});
}

std::vector<MotionPiece> pieces_of(const AnyPath& path) {
  std::vector<MotionPiece> pieces;
  for (auto& piece : surface_detail::spatial_pieces(path.numbers())) {
    pieces.push_back({piece.begin, piece.end, piece.start, std::move(piece.displacement),
                      std::move(piece.preimage), DynamicPolynomial<double>{1.0}});
  }
  return pieces;
}

/// The speed at the ends of a piece is more than 0.
std::optional<Fault> still_at_knots(const std::vector<MotionPiece>& pieces) {
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& preimage = pieces[k].preimage;
    if (!(largest_component(preimage.front()) > 0.0)) return still_fault(k);
    if (!(largest_component(preimage.back()) > 0.0)) return still_fault(k + 1);
  }
  return std::nullopt;
}

/// Undoes the rolls by which the frame steps at inner knots.
std::optional<Fault> align(std::vector<MotionPiece>& pieces) {
  if (auto fault = still_at_knots(pieces)) return fault;
  for (std::size_t k = 1; k < pieces.size(); ++k) {
    const Turn turn = turn_between(pieces[k - 1].preimage, pieces[k].preimage);
    if (turn.is_break()) return break_fault(turn, k);
    // A step within rounding is none: B stays the path's own preimage, up to its sign.
    const bool none = std::abs(turn.roll.im) <= turn.allowed;
    pieces[k].preimage =
        rolled(pieces[k].preimage,
               none ? Complex<double>{turn.roll.re < 0.0 ? -1.0 : 1.0, 0.0} : turn.roll);
  }
  return std::nullopt;
}

/// Half the roll that is left over round a closed path, in (-π/2, π/2]. Domain: aligned.
Result<double> half_leftover(const std::vector<MotionPiece>& pieces) {
  const Turn turn = turn_between(pieces.back().preimage, pieces.front().preimage);
  if (turn.is_break()) return break_fault(turn, 0);
  double c = turn.roll.re, s = turn.roll.im;
  if (c < 0.0) {
    c = -c;
    s = -s;
  }
  return std::abs(s) <= turn.allowed ? 0.0 : std::atan2(s, c);
}

double length_of(const MotionPiece& piece) {
  double sum = 0.0;
  const auto speed =
      product(piece.preimage, piece.preimage,
              [](const Quaternion<double>& a, const Quaternion<double>& b) { return dot(a, b); });
  for (const double s : speed.coefficients()) sum += s;
  return sum / static_cast<double>(speed.degree() + 1) * (piece.end - piece.begin);
}

/// Takes the leftover roll away, in parts proportional to arc length.
void close(std::vector<MotionPiece>& pieces, double half_roll) {
  if (half_roll == 0.0) return;
  double total = 0.0, passed = 0.0;
  for (const auto& piece : pieces) total += length_of(piece);
  for (auto& piece : pieces) {
    const double before = -half_roll * (passed / total);
    passed += length_of(piece);
    const double after = -half_roll * (passed / total);
    piece.preimage = rolled(piece.preimage,
                            DynamicPolynomial<Complex<double>>{{std::cos(before), std::sin(before)},
                                                               {std::cos(after), std::sin(after)}});
  }
}

Fault scale_fault(double value) {
  return {FaultCode::outside_domain,
          "the scale comes down to " + to_text(value) + "; it must be positive everywhere",
          std::nullopt,
          "scale",
          value,
          0.0};
}

}  // namespace

bool MotionBounds::is_bounded() const {
  return std::isfinite(acceleration) && std::isfinite(rate) && std::isfinite(rate_change) &&
         std::isfinite(frame_rounding);
}

std::optional<Fault> Motion::set_scale(const std::vector<double>& scale) {
  if (scale.empty()) {
    return Fault{FaultCode::outside_domain,
                 "the scale has no coefficient; it needs one at least",
                 std::nullopt,
                 "scale",
                 std::nullopt,
                 std::nullopt};
  }
  constexpr std::size_t most_coefficients = 26;  // degree 25, the most that CAD takes
  if (scale.size() > most_coefficients) {
    return Fault{FaultCode::outside_domain,
                 "the scale has " + std::to_string(scale.size()) + " coefficients; at most " +
                     std::to_string(most_coefficients) + " are allowed",
                 std::nullopt,
                 "scale",
                 static_cast<double>(scale.size()),
                 static_cast<double>(most_coefficients)};
  }
  for (const double s : scale) {
    if (!std::isfinite(s)) {
      return Fault{FaultCode::not_finite, "a coefficient of the scale is not finite",
                   std::nullopt,          "scale",
                   std::nullopt,          std::nullopt};
    }
  }
  const DynamicPolynomial<double> whole(scale);
  const double begin = pieces_.front().begin, length = pieces_.back().end - begin;
  for (auto& piece : pieces_) {
    piece.scale = whole.degree() == 0
                      ? whole
                      : whole.restricted((piece.begin - begin) / length,
                                         std::min(1.0, (piece.end - begin) / length));
  }
  if (closed_ && scale.front() != scale.back()) {
    return Fault{FaultCode::outside_domain,
                 "the scale of a closed sweep begins with " + to_text(scale.front()) +
                     " and ends with " + to_text(scale.back()) + "; they must be equal",
                 std::nullopt,
                 "scale",
                 scale.back(),
                 scale.front()};
  }
  // The range of the scale: halved until its coefficients are positive or a value is not.
  struct Part {
    DynamicPolynomial<double> f;
    int depth;
  };
  constexpr int deepest = 40;
  std::vector<Part> open{{whole, 0}};
  largest_scale_ = 0.0;
  least_scale_ = infinity;
  while (!open.empty()) {
    const Part part = std::move(open.back());
    open.pop_back();
    const auto [low, high] =
        std::minmax_element(part.f.coefficients().begin(), part.f.coefficients().end());
    for (const double end : {part.f.front(), part.f.back()}) {
      if (!(end > 0.0)) return scale_fault(end);
    }
    constexpr double narrow = 0.9;  // of the smallest to the largest coefficient: near enough
    if (*low > 0.0 && (*low >= narrow * *high || part.depth >= deepest)) {
      const double slack = whole.degree() == 0 ? 0.0 : accuracy::join_error<double>();
      largest_scale_ = std::max(largest_scale_, *high * (1.0 + slack));
      least_scale_ = std::min(least_scale_, *low * (1.0 - slack));
      continue;
    }
    if (part.depth >= deepest) return scale_fault(*low);
    open.push_back({part.f.restricted(0.0, 0.5), part.depth + 1});
    open.push_back({part.f.restricted(0.5, 1.0), part.depth + 1});
  }
  return std::nullopt;
}

std::optional<Fault> Motion::check_frames() const {
  const std::size_t joints = closed_ ? pieces_.size() : pieces_.size() - 1;
  for (std::size_t k = 0; k < joints; ++k) {
    const std::size_t next = (k + 1) % pieces_.size();
    const Turn turn = turn_between(pieces_[k].preimage, pieces_[next].preimage);
    if (turn.is_break()) return break_fault(turn, next);
    // The step of the roll from the end of one piece to the start of the next.
    double step = -2.0 * std::atan2(turn.roll.im, turn.roll.re);
    if (roll_) step += roll_->angle_at_begin(next) - roll_->angle_at_end(k);
    step = std::remainder(step, 2.0 * std::acos(-1.0));
    const double allowed = 4.0 * turn.allowed + accuracy::join_error<double>() +
                           (roll_ ? 2.0 * roll_->error_bound() : 0.0);
    if (std::abs(step) > allowed) {
      return Fault{FaultCode::not_continuous,
                   std::string("the frame ") +
                       (next == 0 ? "returns to the start of the closed path turned by "
                                  : "jumps at knot " + std::to_string(next) + " by ") +
                       to_text(std::abs(step)) +
                       " rad about the tangent; choose a frame that does not (closing)",
                   next,
                   "roll",
                   std::abs(step),
                   allowed};
    }
  }
  return std::nullopt;
}

Result<Motion> Motion::along(const AnyPath& path, MotionFrame frame,
                             const std::vector<double>& scale) {
  Motion motion;
  motion.pieces_ = pieces_of(path);
  motion.closed_ = path.is_closed();
  if (auto fault = align(motion.pieces_)) return *fault;
  if (motion.closed_ && frame == MotionFrame::closing) {
    const auto half = half_leftover(motion.pieces_);
    if (!half) return half.fault();
    close(motion.pieces_, *half);
  }
  if (auto fault = motion.set_scale(scale)) return *fault;
  if (auto fault = motion.check_frames()) return *fault;
  return motion;
}

Result<Motion> Motion::along(const AnyPath& path, const FrameRoll& roll,
                             const std::vector<double>& scale) {
  Motion motion;
  motion.pieces_ = pieces_of(path);
  motion.closed_ = path.is_closed();
  if (roll.segment_count() != motion.pieces_.size()) {
    return Fault{FaultCode::mismatched_size,
                 "the roll has " + std::to_string(roll.segment_count()) +
                     " segments and the path " + std::to_string(motion.pieces_.size()) +
                     "; it must be a roll of that path",
                 std::nullopt,
                 "roll",
                 static_cast<double>(roll.segment_count()),
                 static_cast<double>(motion.pieces_.size())};
  }
  if (!roll.inflections().empty()) {
    const double xi = roll.inflections().front().xi;
    return Fault{FaultCode::not_continuous,
                 "the Frenet frame turns over at the inflection xi = " + to_text(xi) +
                     "; choose a frame that does not (rotation-minimising, erf)",
                 std::nullopt,
                 "roll",
                 xi,
                 std::nullopt};
  }
  if (auto fault = still_at_knots(motion.pieces_)) return *fault;
  if (roll.kind() == RollKind::periodic) {
    // q = 1 - τ + γ τ e^(-iψ), τ in [0, 1] over the whole path.
    const double begin = motion.pieces_.front().begin;
    const double length = motion.pieces_.back().end - begin;
    const Complex<double> last{roll.gamma() * std::cos(roll.psi()),
                               -(roll.gamma() * std::sin(roll.psi()))};
    const auto q = [&](double xi) {
      const double tau = std::min(1.0, (xi - begin) / length);
      return Complex<double>{(1.0 - tau) + tau * last.re, tau * last.im};
    };
    for (auto& piece : motion.pieces_) {
      piece.preimage =
          rolled(piece.preimage, DynamicPolynomial<Complex<double>>{q(piece.begin), q(piece.end)});
    }
    if (auto fault = still_at_knots(motion.pieces_)) return *fault;
  } else if (roll.kind() != RollKind::none) {
    motion.roll_ = std::make_shared<const FrameRoll>(roll);
  }
  if (auto fault = motion.set_scale(scale)) return *fault;
  if (auto fault = motion.check_frames()) return *fault;
  return motion;
}

double Motion::roll_angle(std::size_t k, double v) const {
  if (v == 0.0) return roll_->angle_at_begin(k);
  if (v == 1.0) return roll_->angle_at_end(k);
  const MotionPiece& piece = pieces_[k];
  return roll_->angle(std::min(piece.begin + v * (piece.end - piece.begin),
                               std::nextafter(piece.end, piece.begin)));
}

double Motion::roll_rate(std::size_t k, double v) const {
  const MotionPiece& piece = pieces_[k];
  const double xi =
      std::min(piece.begin + v * (piece.end - piece.begin), std::nextafter(piece.end, piece.begin));
  return (piece.end - piece.begin) * roll_->derivatives<1>(xi)[1];
}

AnyPath in_space(const AnyPath& path) {
  if (path.dimension() == 3) return path;
  const PathNumbers plane = path.numbers();
  PathNumbers space;
  space.preimage_degree = plane.preimage_degree;
  space.closed = plane.closed;
  space.knots = plane.knots;
  for (std::size_t i = 0; i < plane.starts.size(); i += 2) {
    space.starts.insert(space.starts.end(), {plane.starts[i], plane.starts[i + 1], 0.0});
  }
  for (std::size_t i = 0; i < plane.preimages.size(); i += 2) {
    space.preimages.insert(space.preimages.end(),
                           {plane.preimages[i], 0.0, 0.0, plane.preimages[i + 1]});
  }
  return AnyPath::create(space).value();  // the same numbers
}

Result<Motion> Motion::polynomial(const DynamicPolynomial<Vector3<double>>& position,
                                  DynamicPolynomial<Quaternion<double>> rotation,
                                  const DynamicPolynomial<double>& scale) {
  for (const auto& c : position.coefficients()) {
    if (!is_finite(c)) {
      return Fault{FaultCode::not_finite, "a coefficient of the position is not finite",
                   std::nullopt,          "position",
                   std::nullopt,          std::nullopt};
    }
  }
  for (const auto& q : rotation.coefficients()) {
    if (!is_finite(q)) {
      return Fault{FaultCode::not_finite, "a coefficient of the rotation is not finite",
                   std::nullopt,          "rotation",
                   std::nullopt,          std::nullopt};
    }
  }
  Motion motion;
  motion.adapted_ = false;
  const Vector3<double> start = position.front();
  motion.pieces_.push_back({0.0, 1.0, start,
                            position.mapped([&](const Vector3<double>& c) { return c - start; }),
                            std::move(rotation), DynamicPolynomial<double>{1.0}});
  if (!(largest_component(motion.pieces_[0].preimage.front()) > 0.0) ||
      !(largest_component(motion.pieces_[0].preimage.back()) > 0.0)) {
    return Fault{FaultCode::zero_speed,
                 "the quaternion of the rotation vanishes at an end; it must not vanish",
                 std::nullopt,
                 "rotation",
                 0.0,
                 std::nullopt};
  }
  if (auto fault = motion.set_scale(scale.coefficients())) return *fault;
  return motion;
}

MotionState Motion::at(std::size_t k, double v) const {
  const MotionPiece& piece = pieces_[k];
  MotionState state;
  state.position = piece.start + piece.displacement.value(v);
  state.velocity = piece.displacement.derivative().value(v);
  const std::array<Quaternion<double>, 2> jet{piece.preimage.value(v),
                                              piece.preimage.derivative().value(v)};
  state.frame = euler_rodrigues_frame(jet);
  state.body_rate = body_rate_per_xi(jet)[0];
  state.scale = piece.scale.value(v);
  state.scale_rate = piece.scale.derivative().value(v);
  if (roll_) {
    const double theta = roll_angle(k, v);
    state.frame = hodograph::rolled(state.frame, theta);
    const double rate =
        roll_->kind() == RollKind::rotation_minimising ? -state.body_rate.x : roll_rate(k, v);
    state.body_rate = rolled_rate(state.body_rate, theta, rate);
  }
  return state;
}

MotionBounds Motion::bounds(std::size_t k, double a, double b) const {
  const MotionPiece& piece = pieces_[k];
  const Enclosure from(a), to(b);
  MotionBounds bounds;

  const auto velocity = enclosed(piece.displacement).restricted(from, to).derivative();
  bounds.acceleration = largest(velocity.derivative());
  const auto& middle = velocity[velocity.degree() / 2];
  Vector3<double> along{middle.x.middle(), middle.y.middle(), middle.z.middle()};
  if (const double size = largest_component(along); size > 0.0) {
    along = (1.0 / size) * along;
    const auto advance = velocity.mapped([&](const Vector3<Enclosure>& d) {
      return Enclosure(along.x) * d.x + Enclosure(along.y) * d.y + Enclosure(along.z) * d.z;
    });
    const double length = surface_detail::size_bound(enclosed(along));
    bounds.least_advance = std::max(0.0, Enclosure::down(least(advance) / length));
  }

  const auto scale = enclosed(piece.scale).restricted(from, to);
  bounds.scale = largest(scale);
  bounds.least_scale = least(scale);
  bounds.scale_rate = largest(scale.derivative());
  bounds.scale_change = largest(scale.derivative().derivative());

  // χ = V/σ with V = 2 vec(B* B'), σ = |B|².
  const auto preimage = enclosed(piece.preimage).restricted(from, to);
  const auto sigma = product(
      preimage, preimage,
      [](const Quaternion<Enclosure>& p, const Quaternion<Enclosure>& q) { return dot(p, q); });
  const double low = least(sigma);
  if (!(low > 0.0)) {
    bounds.rate = bounds.rate_change = bounds.frame_rounding = infinity;
    bounds.across_2 = bounds.across_3 = Enclosure::whole_line();
    return bounds;
  }
  const auto v = product(preimage, preimage.derivative(),
                         [](const Quaternion<Enclosure>& p, const Quaternion<Enclosure>& q) {
                           return Enclosure(2.0) * body_rate_form(p, q);
                         })
                     .elevated(sigma.degree());
  // |v| and |v'| along the tangent and across it, over σ; χ' = v'/σ - v σ'/σ².
  double tangential = 0.0, across = 0.0, whole = 0.0;
  for (std::size_t i = 0; i <= sigma.degree(); ++i) {
    const Enclosure c2 = v[i].y / sigma[i], c3 = v[i].z / sigma[i], c1 = v[i].x / sigma[i];
    bounds.across_2 = i == 0 ? c2 : Enclosure::hull(bounds.across_2, c2);
    bounds.across_3 = i == 0 ? c3 : Enclosure::hull(bounds.across_3, c3);
    tangential = std::max(tangential, c1.magnitude());
    across = std::max(across, sqrt(square(c2) + square(c3)).upper());
    whole = std::max(whole, sqrt(square(c1) + square(c2) + square(c3)).upper());
  }
  double tangential_change = 0.0, across_change = 0.0;
  const auto v_rate = v.derivative();
  for (const auto& c : v_rate.coefficients()) {
    tangential_change = std::max(tangential_change, c.x.magnitude());
    across_change = std::max(across_change, sqrt(square(c.y) + square(c.z)).upper());
  }
  const double relative = quotient_up(largest(sigma.derivative()), low);  // |σ'|/σ
  tangential_change = sum_up(quotient_up(tangential_change, low), product_up(tangential, relative));
  across_change = sum_up(quotient_up(across_change, low), product_up(across, relative));

  const auto hypotenuse = [](double p, double q) {
    return sqrt(square(Enclosure(p)) + square(Enclosure(q))).upper();
  };
  // With the roll: χ₁ + θ' and its derivative, and |θ'|.
  double theta_rate = 0.0;
  if (roll_ && roll_->kind() == RollKind::rotation_minimising) {
    theta_rate = tangential;
    tangential = tangential_change = 0.0;
  } else if (roll_ && roll_->kind() == RollKind::least_twist) {
    const double step = Enclosure::up((piece.end - piece.begin) * Enclosure::up(b - a));
    const double twist = product_up(std::abs(roll_->twist_rate()), step);
    const double total = product_up(twist, largest(sigma));
    theta_rate = sum_up(tangential, total);
    tangential = total;
    tangential_change = product_up(twist, largest(sigma.derivative()));
  } else if (roll_) {
    double theta_change = 0.0;
    if (roll_->kind() == RollKind::linear) {
      const double step = Enclosure::up((piece.end - piece.begin) * Enclosure::up(b - a));
      theta_rate = product_up(std::abs(roll_->linear_rate()), step);
    } else {
      // Frenet: θ' = N/Q, N = v₃ v₂' - v₂ v₃' up to sign, Q = v₂² + v₃².
      const auto turn =
          product(v, v_rate, [](const Vector3<Enclosure>& p, const Vector3<Enclosure>& q) {
            return p.z * q.y - p.y * q.z;
          });
      const auto square =
          product(v, v, [](const Vector3<Enclosure>& p, const Vector3<Enclosure>& q) {
            return p.y * q.y + p.z * q.z;
          });
      const double smallest = least(square);
      if (!(smallest > 0.0)) {
        bounds.rate = bounds.rate_change = infinity;
        return bounds;
      }
      theta_rate = quotient_up(largest(turn), smallest);
      theta_change =
          sum_up(quotient_up(largest(turn.derivative()), smallest),
                 product_up(theta_rate, quotient_up(largest(square.derivative()), smallest)));
    }
    tangential = sum_up(tangential, theta_rate);
    tangential_change = sum_up(tangential_change, theta_change);
  }
  if (roll_) {
    bounds.rate = hypotenuse(tangential, across);
    bounds.rate_change =
        hypotenuse(tangential_change, sum_up(across_change, product_up(theta_rate, across)));
  } else {
    bounds.rate = whole;
    bounds.rate_change = hypotenuse(tangential_change, across_change);
  }

  // Computed values. Position: the polynomial's and one sum. Frame: a form of B of relative error
  // twice that of B, over σ; the roll adds a few.
  double far = 0.0;
  for (const auto& d : piece.displacement.coefficients()) far = std::max(far, largest_component(d));
  const double unit = epsilon<double>();
  bounds.rounding = 2.0 * (accuracy::evaluation_error<double>(piece.displacement.degree()) * far +
                           unit * (largest_component(piece.start) + far));
  const double size = largest_coefficient(piece.preimage);
  bounds.frame_rounding = 16.0 * (accuracy::evaluation_error<double>(piece.preimage.degree()) *
                                      size * quotient_up(1.0, std::sqrt(low)) +
                                  unit) +
                          (roll_ ? roll_->error_bound() : 0.0);
  return bounds;
}

}  // namespace hodograph
