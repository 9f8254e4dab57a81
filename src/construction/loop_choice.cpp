// SPDX-License-Identifier: MIT
// The search for a loop: a grid over the whole range, local refinement, enclosures at the end.
#include "hodograph/construction/loop_choice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/construction/detail/closed_loop_kernel.hpp"
#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/nearest_point.hpp"
#include "hodograph/path/torsion.hpp"

namespace hodograph {

namespace {

using Vector = Vector3<double>;
constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is searched: arctan ξ, ψ, roll.
using Place = std::array<double, 3>;

/// Feasible loops first, then the smaller value.
struct Score {
  double excess = infinity;  // by how much the loop leaves its box, over the length
  double value = infinity;

  bool operator<(const Score& other) const {
    return excess != other.excess ? excess < other.excess : value < other.value;
  }
};

/// Bernstein values at fixed parameters.
template <std::size_t n>
struct Samples {
  std::vector<double> at;
  std::vector<std::array<double, n + 1>> weights;

  explicit Samples(std::size_t count) {
    for (std::size_t i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(count);
      at.push_back(t);
      std::array<double, n + 1> row{};
      for (std::size_t k = 0; k <= n; ++k) {
        row[k] = static_cast<double>(binomial(n, k)) * std::pow(t, static_cast<double>(k)) *
                 std::pow(1.0 - t, static_cast<double>(n - k));
      }
      weights.push_back(row);
    }
  }
  template <class V>
  V value(const std::array<V, n + 1>& c, std::size_t i) const {
    V sum = weights[i][0] * c[0];
    for (std::size_t k = 1; k <= n; ++k) sum = sum + weights[i][k] * c[k];
    return sum;
  }
};

/// The largest of samples, with a parabola through it and its neighbours.
double peak_of(const std::vector<double>& f) {
  const auto i = static_cast<std::size_t>(std::max_element(f.begin(), f.end()) - f.begin());
  if (i == 0 || i + 1 == f.size()) return f[i];
  const double bend = f[i - 1] - 2.0 * f[i] + f[i + 1], slope = 0.5 * (f[i + 1] - f[i - 1]);
  return bend < 0.0 ? f[i] - 0.5 * slope * slope / bend : f[i];
}

/// One placement and wish in units of the length, with its start as origin.
class Problem {
 public:
  Problem(const LoopPlacement& placement, const LoopWish& wish)
      : wish_(wish), frame_(placement.frame), fine_(128), points_(96) {
    const double unit = 1.0 / placement.length;
    const auto relative = [&](const Vector& p) { return unit * (p - placement.start); };
    if (wish.within) {
      low_ = relative(wish.within->low);
      high_ = relative(wish.within->high);
      // The samples' peaks are a little lower than the true ones: those are checked at the end.
      constexpr double margin = 0x1.0p-17;
      for (std::size_t j = 0; j < 3; ++j) {
        low_[j] = std::min(0.0, low_[j] + margin);
        high_[j] = std::max(0.0, high_[j] - margin);
      }
    }
    target_ = relative(wish.point);
    extents_ = unit * wish.extents;
  }

  Score score(const Place& place) {
    ++evaluations_;
    const auto member = member_at(place);
    Score result{0.0, 0.0};
    const bool boxed = wish_.within.has_value();
    if (boxed || wish_.purpose == LoopPurpose::extents) {
      std::array<Extent, 3> box = box_of(member, place[2]);
      double excess = 0.0, difference = 0.0;
      for (std::size_t j = 0; j < 3; ++j) {
        if (boxed) excess = std::max({excess, low_[j] - box[j].low, box[j].high - high_[j]});
        difference = std::max(difference, std::abs(box[j].high - box[j].low - extents_[j]));
      }
      result.excess = excess;
      if (excess > 0.0) return result;
      if (wish_.purpose == LoopPurpose::extents) result.value = difference;
    }
    switch (wish_.purpose) {
      case LoopPurpose::least_energy:
        result.value = energy(member);
        break;
      case LoopPurpose::least_torsion_range:
        result.value = torsion_range(member);
        break;
      case LoopPurpose::near_point:
        result.value = std::sqrt(nearest(member, place[2]).second);
        // Many loops pass through the point: a little energy decides among them.
        if (wish_.free_roll) result.value += energy_share * energy(member);
        break;
      case LoopPurpose::extents:
        break;
    }
    return result;
  }

  /// Newton's steps to a loop through the point, where there is one near.
  Place through_point(Place place, const std::array<bool, 3>& is_free) {
    auto [t, square] = nearest(member_at(place), place[2]);
    for (int step = 0; step < 24 && square > 0.0; ++step) {
      // Columns of the Jacobian: of t and of every number that may change.
      constexpr double h = 0x1.0p-18;  // near the cube root of ε, for central differences
      std::array<Vector, 4> column{};
      const Vector r = position(member_at(place), place[2], t) - target_;
      column[3] = (0.5 / h) * (position(member_at(place), place[2], t + h) -
                               position(member_at(place), place[2], t - h));
      for (std::size_t j = 0; j < 3; ++j) {
        if (!is_free[j]) continue;
        Place a = place, b = place;
        a[j] -= h;
        b[j] += h;
        column[j] = (0.5 / h) * (position(member_at(b), b[2], t) - position(member_at(a), a[2], t));
      }
      // The shortest step that makes r vanish: J* (J J*)^-1 r, slightly damped.
      std::array<Vector, 3> m{};
      double trace = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          for (const Vector& c : column) m[i][k] += c[i] * c[k];
        }
        trace += m[i][i];
      }
      for (std::size_t i = 0; i < 3; ++i) m[i][i] += damping * trace;
      const double determinant = dot(m[0], cross(m[1], m[2]));
      if (!(determinant > 0.0)) break;
      const Vector y = (1.0 / determinant) * (r.x * cross(m[1], m[2]) + r.y * cross(m[2], m[0]) +
                                              r.z * cross(m[0], m[1]));
      bool better = false;
      for (double share = 1.0; share > least_share && !better; share *= 0.5) {
        Place next = place;
        for (std::size_t j = 0; j < 3; ++j) next[j] -= share * dot(column[j], y);
        const double limit = std::atan(wish_.largest_xi);
        next[0] = std::clamp(next[0], -limit, limit);
        next[1] = std::remainder(next[1], 2.0 * pi);
        const double next_t = std::clamp(t - share * dot(column[3], y), 0.0, 1.0);
        const Vector d = position(member_at(next), next[2], next_t) - target_;
        if (dot(d, d) < square) {
          place = next;
          t = next_t;
          square = dot(d, d);
          better = true;
        }
      }
      if (!better) break;
    }
    return place;
  }

  double distance(const Place& place) {
    return std::sqrt(nearest(member_at(place), place[2]).second);
  }
  LoopShape shape_at(const Place& place) const {
    return {wish_.xi ? *wish_.xi : std::tan(place[0]),
            wish_.psi ? *wish_.psi : std::clamp(place[1], -pi, pi)};
  }
  std::size_t evaluations() const { return evaluations_; }

 private:
  using Member = loop_detail::Member<double>;

  // The energy of a loop is 40 to some hundred: less than a hundredth of the length is given away
  // for it, and through_point takes that back.
  static constexpr double energy_share = 0x1.0p-16;
  // Far above the roundings of the matrix, far below what would slow Newton's steps down.
  static constexpr double damping = 0x1.0p-44;
  // A step that does not help after eight halvings is not downhill.
  static constexpr double least_share = 0x1.0p-8;
  struct Extent {
    double low = 0.0, high = 0.0;
  };

  Member member_at(const Place& place) const {
    const LoopShape shape = shape_at(place);
    const bool flat = std::abs(shape.psi) == pi;
    return {shape.xi, 1.0, flat ? -1.0 : std::cos(shape.psi), flat ? 0.0 : std::sin(shape.psi)};
  }

  Quaternion<double> frame_at(double roll) const {
    return frame_ * Roll<double>{std::cos(0.5 * roll), std::sin(0.5 * roll)};
  }
  Vector position(const Member& member, double roll, double t) const {
    const BernsteinPolynomial<Vector, 7> curve(loop_detail::canonical_control_points(member));
    return sandwich(frame_at(roll), curve.value(t));
  }

  std::array<Vector, 8> control_points(const Member& member, double roll) const {
    auto p = loop_detail::canonical_control_points(member);
    const auto frame = scaled_frame(frame_at(roll));
    for (Vector& v : p) v = v.x * frame.e1 + v.y * frame.e2 + v.z * frame.e3;
    return p;
  }

  std::array<Extent, 3> box_of(const Member& member, double roll) {
    const auto p = control_points(member, roll);
    std::array<Extent, 3> box;
    for (std::size_t j = 0; j < 3; ++j) {
      std::array<double, 8> c;
      for (std::size_t k = 0; k < 8; ++k) c[k] = p[k][j];
      scratch_.clear();
      for (std::size_t i = 0; i < points_.at.size(); ++i) scratch_.push_back(points_.value(c, i));
      box[j].high = peak_of(scratch_);
      for (double& x : scratch_) x = -x;
      box[j].low = -peak_of(scratch_);
    }
    return box;
  }

  /// The parameter nearest to the target and the square of the distance.
  std::pair<double, double> nearest(const Member& member, double roll) {
    const auto p = control_points(member, roll);
    double least = infinity, at = 0.0;
    for (std::size_t i = 0; i < points_.at.size(); ++i) {
      const Vector d = points_.value(p, i) - target_;
      if (const double square = dot(d, d); square < least) {
        least = square;
        at = points_.at[i];
      }
    }
    const BernsteinPolynomial<Vector, 7> curve(p);
    for (int step = 0; step < 6; ++step) {  // Newton on the derivative of the square
      const auto jet = curve.jet<2>(at);
      const Vector d = jet[0] - target_;
      const double slope = dot(d, jet[1]), bend = dot(jet[1], jet[1]) + dot(d, jet[2]);
      const double next = std::clamp(bend > 0.0 ? at - slope / bend : at, 0.0, 1.0);
      const Vector e = curve.value(next) - target_;
      if (!(dot(e, e) < least)) break;
      least = dot(e, e);
      at = next;
    }
    return {at, least};
  }

  /// ∫ κ² ds by the midpoint rule in a parameter that slows down at the ends, where limit members
  /// stand still.
  double energy(const Member& member) const {
    const auto a = loop_detail::canonical_preimage(member);
    const auto rate = path_detail::turning_polynomial(a);
    double sum = 0.0;
    constexpr std::size_t count = 96;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
      const double t = x * x * (3.0 - 2.0 * x), weight = 6.0 * x * (1.0 - x);
      const auto value = a.value(t);
      const auto v = rate.value(t);
      const double speed = dot(value, value);
      sum += weight * (v.y * v.y + v.z * v.z) / (speed * speed * speed);
    }
    return 36.0 * sum / static_cast<double>(count);
  }

  double torsion_range(const Member& member) {
    const auto a = loop_detail::canonical_preimage(member);
    scratch_.clear();
    for (std::size_t i = 0; i < fine_.at.size(); ++i) {
      scratch_.push_back(torsion(a.jet<2>(fine_.at[i])).value_or(0.0));
    }
    double range = peak_of(scratch_);
    for (double& x : scratch_) x = -x;
    return range + peak_of(scratch_);
  }

  const LoopWish& wish_;
  Quaternion<double> frame_;
  Samples<3> fine_;
  Samples<7> points_;
  Vector low_{}, high_{}, target_{}, extents_{};
  std::vector<double> scratch_;
  std::size_t evaluations_ = 0;
};

/// The search itself.
class Search {
 public:
  Search(Problem& problem, const LoopWish& wish) : problem_(problem), wish_(wish) {
    is_free_ = {!wish.xi, !wish.psi, wish.free_roll};
    limit_ = std::atan(wish.largest_xi);
    steps_ = {is_free_[0] ? limit_ / half_rows : 0.0, is_free_[1] ? 2.0 * pi / columns : 0.0,
              is_free_[2] ? 2.0 * pi / rolls : 0.0};
  }

  const Place& steps() const { return steps_; }
  const std::array<bool, 3>& is_free() const { return is_free_; }

  struct Found {
    Place place;
    Score score;
  };

  Found run() {
    std::vector<Found> cells = grid();
    std::stable_sort(cells.begin(), cells.end(),
                     [](const Found& a, const Found& b) { return a.score < b.score; });
    std::vector<Found> starts;
    for (const Found& cell : cells) {
      if (starts.size() == most_starts) break;
      const bool beside = std::any_of(starts.begin(), starts.end(), [&](const Found& other) {
        return is_beside(cell.place, other.place);
      });
      if (!beside) starts.push_back(cell);
    }
    // All starts roughly, then the best one closely.
    Found best = refined(starts.front(), rough);
    for (std::size_t i = 1; i < starts.size(); ++i) {
      const Found next = refined(starts[i], rough);
      if (is_clearly_less(next.score, best.score)) best = next;
    }
    return snapped(refined(snapped(best), close));
  }

 private:
  static constexpr int half_rows = 16, columns = 64, rolls = 24;
  static constexpr std::size_t most_starts = 12;
  /// Steps of the refinement end at these shares of the grid's; a smooth minimum is flat to
  /// rounding within the second.
  static constexpr int most_trials = 2000;
  static constexpr double rough = 0x1.0p-7, close = 0x1.0p-28;  // 2^-28 of 0.1: half the digits

  /// From the middle of the range outwards, so that of equal loops the plainer one is first.
  std::vector<Found> grid() {
    std::vector<Found> cells;
    for (int i = 0; i <= (is_free_[0] ? 2 * half_rows : 0); ++i) {
      const int row = i % 2 == 1 ? (i + 1) / 2 : -(i / 2);
      for (int k = 0; k < (is_free_[1] ? columns : 1); ++k) {
        const int column = k % 2 == 1 ? -(columns / 2 - (k + 1) / 2) : columns / 2 - k / 2;
        for (int r = 0; r < (is_free_[2] ? rolls : 1); ++r) {
          const Place place{steps_[0] * row, column == columns / 2 ? pi : steps_[1] * column,
                            steps_[2] * r};
          cells.push_back({place, problem_.score(place)});
        }
      }
    }
    return cells;
  }

  bool is_beside(const Place& a, const Place& b) const {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!is_free_[j]) continue;
      double apart = std::abs(a[j] - b[j]);
      if (j > 0) apart = std::min(apart, 2.0 * pi - apart);
      if (apart > 1.5 * steps_[j]) return false;
    }
    return true;
  }

  /// Less by more than the rounding of scores: ties keep the earlier one.
  static bool is_clearly_less(const Score& a, const Score& b) {
    if (a.excess != b.excess) return a.excess < b.excess;
    constexpr double rounding = 0x1.0p-36;  // of scores that are maxima of some hundred samples
    return a.value < b.value * (1.0 - rounding);
  }

  Place moved(const Place& from, const Place& by) const {
    Place place = from;
    for (std::size_t j = 0; j < 3; ++j) {
      if (is_free_[j]) place[j] += by[j];
    }
    place[0] = std::clamp(place[0], -limit_, limit_);
    for (std::size_t j = 1; j <= 2; ++j) place[j] = std::remainder(place[j], 2.0 * pi);
    return place;
  }

  /// Downhill by trial: along the axes and in directions of a fixed sequence, with steps that
  /// shrink where nothing is better. Needs no slope, and follows the edges that maxima have.
  Found refined(Found at, double smallest) {
    double size = 0.5;
    std::uint64_t state = 1;
    const auto next = [&state] {  // uniform in [-1, 1]
      state = state * 6364136223846793005ULL + 1442695040888963407ULL;
      return std::ldexp(static_cast<double>(state >> 11), -52) - 1.0;
    };
    for (int trials = 0; size > smallest && trials < most_trials;) {
      bool better = false;
      for (int k = 0; k < 14 && !better; ++k, ++trials) {
        Place by{};
        if (k < 6) {
          if (!is_free_[static_cast<std::size_t>(k / 2)]) continue;
          by[static_cast<std::size_t>(k / 2)] = k % 2 == 0 ? 1.0 : -1.0;
        } else {
          for (double& x : by) x = next();
        }
        for (std::size_t j = 0; j < 3; ++j) by[j] *= size * steps_[j];
        const Place place = moved(at.place, by);
        const Score score = problem_.score(place);
        if (score < at.score) {
          at = {place, score};
          better = true;
        }
      }
      size *= better ? 1.5 : 0.5;
    }
    return at;
  }

  /// The same with ξ = 0 and ψ = 0 or π where that is as good.
  Found snapped(Found at) {
    constexpr double near = 0x1.0p-12;      // where the refinement of a flat minimum ends
    constexpr double rounding = 0x1.0p-30;  // scores as good as another
    const auto consider = [&](std::size_t j, double special) {
      double apart = std::abs(at.place[j] - special);
      if (j > 0) apart = std::min(apart, 2.0 * pi - apart);
      if (!is_free_[j] || apart > near) return;
      Place place = at.place;
      place[j] = special;
      const Score score = problem_.score(place);
      if (score.excess <= at.score.excess &&
          score.value <= at.score.value * (1.0 + rounding) + rounding) {
        at = {place, score};
      }
    };
    consider(0, 0.0);
    consider(1, pi);
    consider(1, 0.0);
    consider(2, 0.0);
    return at;
  }

  Problem& problem_;
  const LoopWish& wish_;
  std::array<bool, 3> is_free_;
  double limit_ = 0.0;
  Place steps_{};
};

Fault refused(FaultCode code, const std::string& sentence, const char* quantity,
              std::optional<double> value = std::nullopt,
              std::optional<double> bound = std::nullopt) {
  return {code, sentence, std::nullopt, quantity, value, bound};
}

std::optional<Fault> wish_fault(const LoopPlacement& placement, const LoopWish& wish) {
  if (!(std::isfinite(wish.largest_xi) && wish.largest_xi > 0.0)) {
    return refused(
        FaultCode::outside_domain,
        "the largest xi of the search must be positive and finite; got " + to_text(wish.largest_xi),
        "largest_xi");
  }
  if (wish.xi && !std::isfinite(*wish.xi)) {
    return refused(FaultCode::not_finite,
                   "a xi that is held must be a finite number; limit members stand still at their "
                   "start and are not searched",
                   "xi");
  }
  if (wish.purpose == LoopPurpose::near_point && !is_finite(wish.point)) {
    return refused(FaultCode::not_finite,
                   "the point to pass near has a coordinate that is not a finite number", "point");
  }
  if (wish.purpose == LoopPurpose::near_point &&
      !std::isfinite(dot(wish.point - placement.start, wish.point - placement.start))) {
    return refused(FaultCode::outside_domain,
                   "the point to pass near is too far from the start: the square of its distance "
                   "must be a finite number",
                   "point");
  }
  if (wish.purpose == LoopPurpose::extents) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!(std::isfinite(wish.extents[j]) && wish.extents[j] >= 0.0)) {
        return refused(FaultCode::outside_domain,
                       "the sides wanted of the box must be finite and not negative; got " +
                           to_text(wish.extents[j]),
                       "extents");
      }
    }
  }
  if (wish.within) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double low = wish.within->low[j], high = wish.within->high[j];
      if (!(std::isfinite(low) && std::isfinite(high))) {
        return refused(FaultCode::not_finite, "the box has a corner that is not finite", "within");
      }
      const double at = placement.start[j];
      if (!(low <= at && at <= high)) {
        return refused(FaultCode::outside_domain,
                       "the loop's start is outside its box: coordinate " + std::to_string(j) +
                           " is " + to_text(at) + ", the box is [" + to_text(low) + ", " +
                           to_text(high) + "]",
                       "within", at, at < low ? low : high);
      }
    }
  }
  return std::nullopt;
}

/// How far a loop leaves its box, for certain at most.
double certain_excess(const SpatialPath<3>& path, const LoopBox& within, const RangeGoal& goal) {
  const auto box = bounding_box(path, goal);
  double excess = 0.0;
  for (std::size_t j = 0; j < 3; ++j) {
    excess = std::max(
        {excess, within.low[j] - box[j].minimum.lower(), box[j].maximum.upper() - within.high[j]});
  }
  return excess;
}

Result<Enclosure> certified_value(const SpatialPath<3>& path, const LoopWish& wish,
                                  const RangeGoal& goal) {
  switch (wish.purpose) {
    case LoopPurpose::least_energy:
      return bending_energy_enclosure(path);
    case LoopPurpose::least_torsion_range: {
      const Extremes tau = torsion_extremes(path, goal);
      const Enclosure range = tau.maximum - tau.minimum;
      return Enclosure(std::max(0.0, range.lower()), range.upper());
    }
    case LoopPurpose::near_point: {
      const auto nearest = nearest_point(path, wish.point);
      if (!nearest) return nearest.fault();
      return nearest->distance;
    }
    case LoopPurpose::extents: {
      const auto box = bounding_box(path, goal);
      Enclosure worst(0.0);
      for (std::size_t j = 0; j < 3; ++j) {
        const Enclosure side = box[j].maximum - box[j].minimum;
        const Enclosure off = abs(side - Enclosure(wish.extents[j]));
        worst = {std::max(worst.lower(), off.lower()), std::max(worst.upper(), off.upper())};
      }
      return worst;
    }
  }
  return Enclosure(0.0);
}

}  // namespace

Result<ChosenLoop> choose_loop(const LoopPlacement& placement, const LoopWish& wish) {
  // The door of closed_loop looks at the placement and at what is held.
  const auto first = closed_loop({wish.xi.value_or(0.0), wish.psi.value_or(pi)}, placement);
  if (!first) return first.fault();
  if (auto fault = wish_fault(placement, wish)) return *std::move(fault);
  Problem problem(placement, wish);
  Search search(problem, wish);
  auto found = search.run();
  if (wish.purpose == LoopPurpose::near_point) {
    const Place through = problem.through_point(found.place, search.is_free());
    const Score score = problem.score(through);
    if (score.excess <= found.score.excess &&
        problem.distance(through) < problem.distance(found.place)) {
      found = {through, score};
    }
  }
  const LoopShape shape = problem.shape_at(found.place);
  LoopPlacement turned = placement;
  const double roll = found.place[2];
  if (roll != 0.0) {
    turned.frame = placement.frame * Roll<double>{std::cos(0.5 * roll), std::sin(0.5 * roll)};
  }
  auto path = closed_loop(shape, turned);
  if (!path) return path.fault();
  constexpr RangeGoal goal{0x1.0p-20};  // a millionth: what the header says
  if (wish.within) {
    const double excess = certain_excess(*path, *wish.within, goal);
    if (found.score.excess > 0.0 || excess > 0.0) {
      const double out = std::max(excess, found.score.excess * placement.length);
      return refused(FaultCode::no_interpolant,
                     "no loop of length " + to_text(placement.length) +
                         " from there was found within the box; the best one (xi " +
                         to_text(shape.xi) + ", psi " + to_text(shape.psi) + ") sticks out by " +
                         to_text(out) + ". Give it a larger box, less length or another direction",
                     "within", out, 0.0);
    }
  }
  const auto value = certified_value(*path, wish, goal);
  if (!value) return value.fault();
  return ChosenLoop{shape, roll, *std::move(path), *value, search.steps(), problem.evaluations()};
}

}  // namespace hodograph
