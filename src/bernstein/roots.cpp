// SPDX-License-Identifier: MIT
// Isolation of real roots: subdivision, monotonicity, interval Newton, and a second look at joins.
#include "hodograph/bernstein/roots.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "enclosure_row.hpp"

namespace hodograph {
namespace {

/// Midpoints of midpoints of [0, 1] are exact doubles down to this depth, and pieces this small are
/// within a few ulps of a point.
constexpr int greatest_depth = 50;

/// Pieces examined, per coefficient: a simple root takes at most 2 · greatest_depth of them, a
/// double root as many on each side; clusters of higher multiplicity are wide and take fewer.
constexpr std::size_t pieces_per_coefficient = 256;

/// A piece is all noise when no coefficient exceeds its width by this factor: half of the digits of
/// the smallest part of the values that subdivision could still tell from zero.
constexpr double noise_factor = 4.0;

int sign_of(const Enclosure& x) { return x.lower() > 0.0 ? 1 : x.upper() < 0.0 ? -1 : 0; }

/// +1 (-1) where the coefficients certainly increase (decrease) strictly, and the polynomial with
/// them; 0 otherwise.
int direction_of(const EnclosureRow& row) {
  bool up = row.size() > 1, down = up;
  for (std::size_t i = 0; i + 1 < row.size() && (up || down); ++i) {
    up = up && row.upper(i) < row.lower(i + 1);
    down = down && row.upper(i + 1) < row.lower(i);
  }
  return up ? 1 : down ? -1 : 0;
}

/// A root of the polynomial with the middle coefficients, approximately: where a bisection of [0,
/// 1] ends. Nothing depends on its accuracy but the number of Newton steps.
double approximate_root(const EnclosureRow& row, int direction) {
  double low = 0.0, high = 1.0;
  constexpr int bisections = 8;  // Newton's steps square the error from here on
  for (int step = 0; step < bisections; ++step) {
    const double u = 0.5 * low + 0.5 * high;
    (direction * row.approximate_value(u) < 0.0 ? low : high) = u;
  }
  return 0.5 * low + 0.5 * high;
}

/// The part of [0, 1] that holds the root of a strictly monotone polynomial, if it has one there,
/// by interval Newton steps: f(m) = f'(t) (m - root) for some t between, so that root ∈ m -
/// f(m)/f'([X]). Returns nothing where the polynomial certainly has no root in [0, 1].
std::optional<Enclosure> newton_refined(const EnclosureRow& row, int direction) {
  const EnclosureRow derivative = row.derivative();
  Enclosure where(0.0, 1.0), slope = derivative.hull();
  double m = approximate_root(row, direction);
  // Six steps where convergence is quadratic from the start; a root next to 0 is approached by a
  // factor of an ulp a step, over at most 2^-1074.
  constexpr int most_steps = 40;
  for (int step = 0; step < most_steps && sign_of(slope) != 0; ++step) {
    const Enclosure next = Enclosure(m) - row.value(m) / slope;
    const double low = std::max(where.lower(), next.lower());
    const double high = std::min(where.upper(), next.upper());
    if (!(low <= high)) return std::nullopt;
    const double before = where.upper() - where.lower();
    where = {low, high};
    // At the middle a known sign halves the interval. (The first step is not at the middle, and may
    // cut off less where the slope comes close to zero on the piece.)
    if (step > 0 && high - low > 0.5 * before) break;
    m = where.middle();
    const Enclosure here = derivative.value(where);
    const double least = std::max(slope.lower(), here.lower());
    const double most = std::min(slope.upper(), here.upper());
    if (least <= most) slope = {least, most};
  }
  return where;
}

/// f on [0, 1] and what has been found of its roots.
class Isolation {
 public:
  explicit Isolation(EnclosureRow row) : whole_(std::move(row)) {}

  std::vector<IsolatedRoot> run() {
    subdivide();
    join_neighbours();
    decide_clusters();
    note_signs();
    return std::move(found_);
  }

 private:
  struct Piece {
    double a, b;
    int depth;
    EnclosureRow row;
  };

  void subdivide() {
    std::vector<Piece> open;
    open.push_back({0.0, 1.0, 0, whole_});
    std::size_t budget = pieces_per_coefficient * whole_.size();
    while (!open.empty()) {
      Piece piece = std::move(open.back());
      open.pop_back();
      if (examine(piece)) continue;
      if (piece.depth == greatest_depth || budget == 0) {
        found_.push_back({Enclosure(piece.a, piece.b), RootKind::cluster, 0, 0});
        continue;
      }
      --budget;
      const double middle = 0.5 * (piece.a + piece.b);
      Piece left{piece.a, middle, piece.depth + 1, piece.row.split_off_left_half()};
      open.push_back({middle, piece.b, piece.depth + 1, std::move(piece.row)});
      open.push_back(std::move(left));
    }
  }

  /// Settles a piece where that is possible without subdividing it.
  bool examine(const Piece& piece) {
    const EnclosureRow& row = piece.row;
    bool positive = false, negative = false, undecided = false;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int sign = sign_of(row[i]);
      positive = positive || sign > 0;
      negative = negative || sign < 0;
      undecided = undecided || sign == 0;
    }
    if (!undecided && positive != negative) return true;
    if (!positive && !negative) {
      found_.push_back({Enclosure(piece.a, piece.b), RootKind::cluster, 0, 0});
      return true;
    }
    if (const int direction = direction_of(row); direction != 0) {
      add_monotone(piece.a, piece.b, row, direction);
      return true;
    }
    if (row.hull().magnitude() <= noise_factor * row.noise()) {
      found_.push_back({Enclosure(piece.a, piece.b), RootKind::cluster, 0, 0});
      return true;
    }
    return false;
  }

  /// Adds what a strictly monotone piece on [a, b] holds: nothing, a simple root, or (where the
  /// sign at an end is not known) perhaps one.
  void add_monotone(double a, double b, const EnclosureRow& row, int direction) {
    const Enclosure first = row[0], last = row[row.degree()];
    // An exact zero: only at the ends of [0, 1], where coefficients are those given.
    if (first.is_zero() || last.is_zero()) {
      const double end = first.is_zero() ? a : b;
      found_.push_back({Enclosure(end), RootKind::simple, -direction, direction});
      return;
    }
    const int before = sign_of(first), after = sign_of(last);
    if (before * after > 0) return;
    const std::optional<Enclosure> where = newton_refined(row, direction);
    if (!where) return;
    const bool certain = before * after < 0;
    found_.push_back({part(a, b, *where), certain ? RootKind::simple : RootKind::cluster,
                      certain ? -direction : 0, certain ? direction : 0});
  }

  /// a + (b - a) t, kept inside [a, b].
  static Enclosure part(double a, double b, const Enclosure& t) {
    const Enclosure x = Enclosure(a) + (Enclosure(b) - Enclosure(a)) * t;
    return {t.lower() == 0.0 ? a : std::clamp(x.lower(), a, b),
            t.upper() == 1.0 ? b : std::clamp(x.upper(), a, b)};
  }

  /// Makes the intervals disjoint: those that touch become one cluster.
  void join_neighbours() {
    std::vector<IsolatedRoot> joined;
    for (const IsolatedRoot& root : found_) {
      if (joined.empty() || joined.back().u.upper() < root.u.lower()) {
        joined.push_back(root);
      } else {
        joined.back() = {Enclosure::hull(joined.back().u, root.u), RootKind::cluster, 0, 0};
      }
    }
    found_ = std::move(joined);
  }

  /// Looks again at every cluster on a wider interval that it has to itself: a root at which pieces
  /// met is simple there.
  void decide_clusters() {
    std::vector<IsolatedRoot> decided;
    for (std::size_t k = 0; k < found_.size(); ++k) {
      const double low = decided.empty() ? 0.0 : above(decided.back().u.upper());
      const double high = k + 1 < found_.size() ? below(found_[k + 1].u.lower()) : 1.0;
      if (found_[k].kind == RootKind::cluster) {
        decide(found_[k], low, high, decided);
      } else {
        decided.push_back(found_[k]);
      }
    }
    found_ = std::move(decided);
  }

  void decide(const IsolatedRoot& cluster, double low, double high,
              std::vector<IsolatedRoot>& decided) const {
    const double x = cluster.u.lower(), y = cluster.u.upper();
    constexpr double ulp = std::numeric_limits<double>::epsilon();
    double margin = std::max(y - x, noise_factor * ulp * y);
    constexpr int most_growths = 24;  // by a factor of four each: from an ulp to 1/16
    for (int growth = 0; growth < most_growths; ++growth, margin *= 4.0) {
      const double a = std::max(low, x - margin), b = std::min(high, y + margin);
      const EnclosureRow row = whole_.restricted(a, b);
      const int direction = direction_of(row);
      if (direction != 0) {
        const int before = sign_of(row[0]), after = sign_of(row[row.degree()]);
        if (before * after > 0) return;  // no root
        if (before * after < 0) {
          if (const auto where = newton_refined(row, direction)) {
            decided.push_back({part(a, b, *where), RootKind::simple, -direction, direction});
          }
          return;
        }
      }
      if (a == low && b == high) break;
    }
    decided.push_back(cluster);
  }

  /// The sign beside a cluster is the sign half-way to its neighbour: there is no root between.
  void note_signs() {
    for (std::size_t k = 0; k < found_.size(); ++k) {
      if (found_[k].kind == RootKind::simple) continue;
      const double previous = k > 0 ? found_[k - 1].u.upper() : 0.0;
      const double next = k + 1 < found_.size() ? found_[k + 1].u.lower() : 1.0;
      found_[k].sign_before = sign_between(previous, found_[k].u.lower(), k > 0, true);
      found_[k].sign_after = sign_between(found_[k].u.upper(), next, true, k + 1 < found_.size());
      if (found_[k].sign_before == 0 && k > 0) found_[k].sign_before = found_[k - 1].sign_after;
    }
  }
  /// The sign on the interval between two roots, or between a root and an end of [0, 1].
  int sign_between(double a, double b, bool root_at_a, bool root_at_b) const {
    if (!(a < b)) return 0;
    if (!root_at_a) return sign_of(whole_[0]);
    if (!root_at_b) return sign_of(whole_[whole_.degree()]);
    return sign_of(whole_.value(0.5 * (a + b)));
  }

  static double above(double x) { return std::nextafter(x, 2.0); }
  static double below(double x) { return std::nextafter(x, -1.0); }

  EnclosureRow whole_;
  std::vector<IsolatedRoot> found_;
};

}  // namespace

Result<std::vector<IsolatedRoot>> isolated_roots(std::span<const Enclosure> coefficients) {
  if (coefficients.empty()) {
    return Fault{FaultCode::too_few,
                 "a polynomial needs at least one coefficient; got none",
                 std::nullopt,
                 "coefficients",
                 0.0,
                 1.0};
  }
  bool zero = true;
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (!coefficients[i].is_bounded()) {
      return Fault{FaultCode::not_finite,
                   "coefficient " + std::to_string(i) +
                       " of the polynomial is infinite or not a number; roots need finite ones",
                   i,
                   "coefficient",
                   std::nullopt,
                   std::nullopt};
    }
    zero = zero && coefficients[i].is_zero();
  }
  if (zero) {
    return Fault{
        FaultCode::outside_domain,
        "the polynomial is zero everywhere: every point of [0, 1] is a root; isolated roots "
        "need a coefficient that is not 0",
        std::nullopt,
        "coefficients",
        0.0,
        std::nullopt};
  }
  const int exponent = -largest_exponent(coefficients);
  EnclosureRow row(coefficients.size());
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    row.set(i, scaled(coefficients[i], exponent));
  return Isolation(std::move(row)).run();
}

}  // namespace hodograph
