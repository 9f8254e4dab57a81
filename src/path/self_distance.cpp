// SPDX-License-Identifier: MIT
// The distance of a path to itself: best-first subdivision of pairs of pieces, in one degree that
// is known when the program runs.
#include "hodograph/path/self_distance.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace hodograph::path_detail {

namespace {

using Index = std::uint32_t;
using Vector = Vector3<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A piece of a segment, or several segments in a row.
struct Node {
  double begin, end;            // arc length
  Vector low, high;             // box
  Index left = 0, right = 0;    // children; 0: none yet
  Index segment = 0, rows = 0;  // of a piece: where its control points begin
  double u0 = 0.0, u1 = 1.0;    // of a piece
  std::uint8_t depth = 0;
  bool is_group = false;
};

struct Pair {
  double lower;
  Index a, b;
  // Smallest bound first; indices make the order complete.
  bool operator<(const Pair& other) const {
    if (lower != other.lower) return lower > other.lower;
    return a != other.a ? a > other.a : b > other.b;
  }
};

/// The direction from a point of segment a0 a1 to the nearest of b0 b1, nearly.
Vector between(const Vector& a0, const Vector& a1, const Vector& b0, const Vector& b1,
               double& along_a, double& along_b) {
  const Vector d = a1 - a0, e = b1 - b0, r = a0 - b0;
  const double dd = dot(d, d), ee = dot(e, e), de = dot(d, e), dr = dot(d, r), er = dot(e, r);
  const double determinant = dd * ee - de * de;
  double s = determinant > 0.0 ? std::clamp((de * er - dr * ee) / determinant, 0.0, 1.0) : 0.0;
  double t = ee > 0.0 ? (de * s + er) / ee : 0.0;
  if (!(t >= 0.0 && t <= 1.0)) {
    t = t > 1.0 ? 1.0 : 0.0;
    s = dd > 0.0 ? std::clamp((de * t - dr) / dd, 0.0, 1.0) : 0.0;
  }
  along_a = s;
  along_b = t;
  return (b0 + t * e) - (a0 + s * d);
}

class Search {
 public:
  Search(const Strand& strand, double separation, double cutoff, const RangeGoal& goal)
      : strand_(strand), goal_(goal), rows_(strand.degree + 1) {
    // Everything in units of 2^exponent, so that no square overflows or vanishes.
    double size = strand.error;
    for (const double c : strand.control) size = std::max(size, std::abs(c));
    exponent_ = exponent_of(size);
    control_.reserve(strand.control.size() * 4);
    for (const double c : strand.control) control_.push_back(std::ldexp(c, -exponent_));
    error_ = std::ldexp(strand.error, -exponent_) + std::numeric_limits<double>::min();
    length_ = control_.back();
    separation_ = std::ldexp(separation, -exponent_);
    const double deepest_error =
        error_ + epsilon<double>() * static_cast<double>(strand.degree * (deepest + 4) + 1);
    slack_ = 4.0 * deepest_error;
    noise_ = 4.0 * deepest_error;
    most_ = std::ldexp(cutoff, -exponent_);
  }

  std::optional<SelfDistance> run() {
    if (!(separation_ <= (strand_.closed ? 0.5 : 1.0) * length_ + slack_)) return std::nullopt;
    const Index root = build(0, strand_.segment_count());
    consider(root, root, 0.0);
    double settled = infinity;
    std::size_t subdivided = 0;
    while (!open_.empty()) {
      const Pair top = open_.front();
      if (top.lower >= enough() || subdivided >= goal_.subdivisions) break;
      std::pop_heap(open_.begin(), open_.end());
      open_.pop_back();
      if (!divide(top)) settled = std::min(settled, top.lower);
      ++subdivided;
    }
    const double lower =
        std::min({settled, excluded_, open_.empty() ? infinity : open_.front().lower});
    if (!(lower < infinity) && !found_) return std::nullopt;
    return answer(std::max(0.0, std::min(lower, most_)));
  }

 private:
  static constexpr std::uint8_t deepest = 50;

  const double* row_at(std::size_t row) const { return control_.data() + 4 * row; }
  Vector point(Index row) const {
    const double* c = row_at(row);
    return {c[0], c[1], c[2]};
  }
  double length_at(Index row) const { return row_at(row)[3]; }
  Index last_row(const Node& node) const { return node.rows + static_cast<Index>(rows_) - 1; }
  /// Of a coordinate: stored coefficients, and half an ulp of at most 1 in each of `degree` means a
  /// level.
  double error_of(const Node& node) const {
    return error_ + 0.5 * epsilon<double>() * static_cast<double>(node.depth * strand_.degree + 1);
  }

  /// Below this nothing needs to be looked at any more.
  double enough() const {
    return most_ < infinity ? most_ - std::max(goal_.relative_width * most_, noise_) : infinity;
  }

  Index build(std::size_t first, std::size_t last) {
    if (last - first == 1) {
      Node node;
      node.segment = static_cast<Index>(first);
      node.rows = static_cast<Index>(first * rows_);
      return add_piece(node);
    }
    const std::size_t middle = (first + last) / 2;
    const Index left = build(first, middle), right = build(middle, last);
    const Node &a = nodes_[left], &b = nodes_[right];
    Node node{a.begin, b.end, a.low, a.high, left, right};
    for (std::size_t j = 0; j < 3; ++j) {
      node.low[j] = std::min(a.low[j], b.low[j]);
      node.high[j] = std::max(a.high[j], b.high[j]);
    }
    node.is_group = true;
    nodes_.push_back(node);
    return static_cast<Index>(nodes_.size() - 1);
  }

  Index add_piece(Node node) {
    node.begin = length_at(node.rows);
    node.end = length_at(last_row(node));
    node.low = node.high = point(node.rows);
    for (Index i = 1; i < rows_; ++i) {
      const Vector p = point(node.rows + i);
      for (std::size_t j = 0; j < 3; ++j) {
        node.low[j] = std::min(node.low[j], p[j]);
        node.high[j] = std::max(node.high[j], p[j]);
      }
    }
    nodes_.push_back(node);
    return static_cast<Index>(nodes_.size() - 1);
  }

  /// Both halves of a piece, by de Casteljau. False where it is too small to divide.
  bool split(Index i) {
    if (nodes_[i].left != 0) return true;
    const Node node = nodes_[i];
    const double middle = 0.5 * (node.u0 + node.u1);
    if (node.depth >= deepest || !(node.u0 < middle && middle < node.u1)) return false;
    const std::size_t n = rows_, at = control_.size();
    control_.resize(at + 8 * n);
    double* left = control_.data() + at;
    double* right = left + 4 * n;
    std::copy_n(control_.data() + 4 * static_cast<std::size_t>(node.rows), 4 * n, right);
    for (std::size_t r = 0; r < n; ++r) {
      std::copy_n(right, 4, left + 4 * r);
      for (std::size_t k = 0; k < 4 * (n - 1 - r); ++k) right[k] = 0.5 * (right[k] + right[k + 4]);
    }
    Node half;
    half.segment = node.segment;
    half.depth = static_cast<std::uint8_t>(node.depth + 1);
    half.rows = static_cast<Index>(at / 4);
    half.u0 = node.u0;
    half.u1 = middle;
    const Index first = add_piece(half);
    half.rows += static_cast<Index>(n);
    half.u0 = middle;
    half.u1 = node.u1;
    const Index second = add_piece(half);
    nodes_[i].left = first;
    nodes_[i].right = second;
    return true;
  }

  /// How far apart along the path two points are.
  double apart(double s, double t) const {
    const double d = std::abs(t - s);
    return strand_.closed ? std::min(d, length_ - d) : d;
  }
  /// How far apart two points of these nodes are at most; a is not behind b.
  double most_apart(const Node& a, const Node& b) const {
    const double most = b.end - a.begin, least = std::max(0.0, b.begin - a.end);
    if (!strand_.closed) return most;
    const double half = 0.5 * length_;
    if (most <= half) return most;
    return least < half ? half : length_ - least;
  }

  bool divide(const Pair& pair) {
    const Index a = pair.a, b = pair.b;
    const auto children = [&](Index i) { return nodes_[i].is_group || split(i); };
    if (a == b) {
      if (!children(a)) return false;
      const Index left = nodes_[a].left, right = nodes_[a].right;
      consider(left, left, pair.lower);
      consider(left, right, pair.lower);
      consider(right, right, pair.lower);
      return true;
    }
    const auto size = [&](Index i) { return nodes_[i].end - nodes_[i].begin; };
    const bool first = size(a) >= size(b);
    if (first ? children(a) : children(b)) {
      const Index i = first ? a : b;
      for (const Index child : {nodes_[i].left, nodes_[i].right}) {
        first ? consider(child, b, pair.lower) : consider(a, child, pair.lower);
      }
      return true;
    }
    return false;
  }

  /// Bounds a pair of nodes, a not behind b, and keeps it if it may matter.
  void consider(Index a, Index b, double at_least) {
    if (most_apart(nodes_[a], nodes_[b]) < separation_ - slack_) return;
    ++evaluations_;
    double lower = at_least;
    if (a != b) lower = std::max(lower, bound(nodes_[a], nodes_[b]));
    if (lower < most_) lower = std::max(lower, cone_bound(nodes_[a], nodes_[b]));
    if (lower >= most_) {
      excluded_ = std::min(excluded_, lower);
      return;
    }
    open_.push_back({lower, a, b});
    std::push_heap(open_.begin(), open_.end());
  }

  /// Where a and b are one piece or meet, and every difference of their control points is within an
  /// angle φ < π/2 of one direction, so is the hodograph, and a chord is at least cos φ times the
  /// arc length that it spans.
  double cone_bound(const Node& a, const Node& b) const {
    if (a.is_group || b.is_group || a.end != b.begin) {
      if (&a != &b || a.is_group) return 0.0;
    }
    const Vector along = point(last_row(b)) - point(a.rows);
    const double size = std::sqrt(dot(along, along));
    // A difference much larger than its error keeps its direction within the ratio of the two.
    constexpr double clear = 1024.0;
    const double error = 4.0 * (error_of(a) + error_of(b));
    double cosine = size > clear * error ? 1.0 : 0.0;
    const auto narrow = [&](const Node& node) {
      for (Index i = 0; i + 1 < rows_ && cosine > 0.0; ++i) {
        const Vector d = point(node.rows + i + 1) - point(node.rows + i);
        const double length = std::sqrt(dot(d, d));
        const double share = length > clear * error ? dot(d, along) / (length * size) : 0.0;
        cosine = std::min(cosine, share - 4.0 * (error / size + error / std::max(length, error)));
      }
    };
    narrow(a);
    if (&a != &b) narrow(b);
    return cosine > 0.0 ? shortened(cosine * (separation_ - slack_)) : 0.0;
  }

  double bound(const Node& a, const Node& b) {
    const double error = error_of(a) + error_of(b);
    if (a.is_group || b.is_group) {
      double square = 0.0;
      for (std::size_t j = 0; j < 3; ++j) {
        const double gap = std::max({0.0, b.low[j] - a.high[j], a.low[j] - b.high[j]}) - error;
        if (gap > 0.0) square += gap * gap;
      }
      return shortened(std::sqrt(square));
    }
    double along_a = 0.0, along_b = 0.0;
    const Index last_a = last_row(a), last_b = last_row(b);
    const Vector n =
        between(point(a.rows), point(last_a), point(b.rows), point(last_b), along_a, along_b);
    const double size = std::sqrt(dot(n, n));
    if (size < most_) {
      try_pair(a, along_a, b, along_b);
      for (const double t : {0.0, 1.0}) {
        for (const double v : {0.0, 1.0}) try_pair(a, t, b, v);
      }
    }
    if (!(size > error)) return 0.0;
    double reach_a = -infinity, reach_b = infinity;
    for (Index i = 0; i < rows_; ++i) {
      reach_a = std::max(reach_a, dot(n, point(a.rows + i)));
      reach_b = std::min(reach_b, dot(n, point(b.rows + i)));
    }
    // The products round by at most 3 ε |n| · size 1 in each reach; an error of each coordinate
    // moves a reach by at most √3 of it.
    const double gap = (reach_b - reach_a) / size - 8.0 * epsilon<double>() - 2.0 * error;
    return std::max(0.0, shortened(gap));
  }
  /// Rounded down by more than a square, its root and a quotient round.
  static double shortened(double x) { return x - 8.0 * epsilon<double>() * std::abs(x); }

  /// The point of a piece at a share of its parameter, with its arc length, by de Casteljau.
  std::array<double, 4> at(const Node& node, double t) {
    const std::size_t n = rows_;
    if (t == 0.0 || t == 1.0) {
      const double* row = row_at(t == 0.0 ? node.rows : last_row(node));
      return {row[0], row[1], row[2], row[3]};
    }
    scratch_.assign(control_.begin() + static_cast<std::ptrdiff_t>(4 * node.rows),
                    control_.begin() + static_cast<std::ptrdiff_t>(4 * (node.rows + n)));
    for (std::size_t r = 1; r < n; ++r) {
      for (std::size_t k = 0; k < 4 * (n - r); ++k) {
        scratch_[k] += t * (scratch_[k + 4] - scratch_[k]);
      }
    }
    return {scratch_[0], scratch_[1], scratch_[2], scratch_[3]};
  }

  /// A pair of points as a witness, where it is far enough apart along the path.
  void try_pair(const Node& a, double t, const Node& b, double v) {
    const auto p = at(a, t), q = at(b, v);
    if (!(apart(p[3], q[3]) >= separation_ - slack_)) return;
    const Vector d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    // de Casteljau at t rounds three times a step, at most 1 each.
    const double error =
        error_of(a) + error_of(b) + 4.0 * epsilon<double>() * static_cast<double>(strand_.degree);
    const double size = std::sqrt(dot(d, d)) * (1.0 + 8.0 * epsilon<double>()) + 2.0 * error;
    if (size >= most_) return;
    most_ = size;
    found_ = true;
    xi_[0] = xi_of(a, t);
    xi_[1] = xi_of(b, v);
  }
  double xi_of(const Node& node, double t) const {
    const double low = strand_.knots[node.segment], high = strand_.knots[node.segment + 1];
    const double u = node.u0 + t * (node.u1 - node.u0);
    return std::clamp(low + u * (high - low), low, high);
  }

  SelfDistance answer(double lower) const {
    const Enclosure unit = power_of_two(exponent_);
    SelfDistance result;
    const Enclosure from = Enclosure(lower) * unit;
    const double to = found_ ? (Enclosure(most_) * unit).upper() : infinity;
    result.distance = {std::max(0.0, from.lower()), to};
    result.separation = std::ldexp(separation_, exponent_);
    result.xi[0] = std::min(xi_[0], xi_[1]);
    result.xi[1] = std::max(xi_[0], xi_[1]);
    result.evaluations = evaluations_;
    return result;
  }

  const Strand& strand_;
  const RangeGoal goal_;
  const std::size_t rows_;
  int exponent_ = 0;
  double error_ = 0.0, length_ = 0.0, separation_ = 0.0, slack_ = 0.0, noise_ = 0.0;
  double most_ = infinity;      // the least distance found, or the cutoff
  double excluded_ = infinity;  // the least bound of what was set aside
  bool found_ = false;
  double xi_[2] = {0.0, 0.0};
  std::size_t evaluations_ = 0;
  std::vector<double> control_, scratch_;
  std::vector<Node> nodes_;
  std::vector<Pair> open_;
};

}  // namespace

std::optional<SelfDistance> search_self_distance(const Strand& strand, double separation,
                                                 double cutoff, const RangeGoal& goal) {
  return Search(strand, separation, cutoff, goal).run();
}

std::optional<Fault> separation_fault(double separation) {
  if (std::isfinite(separation) && separation > 0.0) return std::nullopt;
  const bool finite = std::isfinite(separation);
  return Fault{
      finite ? FaultCode::outside_domain : FaultCode::not_finite,
      "the separation along the path must be positive and finite; got " + to_text(separation),
      std::nullopt,
      "separation",
      finite ? std::optional<double>(separation) : std::nullopt,
      0.0};
}

Fault no_such_parts(double separation, double length, bool closed) {
  const double most = closed ? 0.5 * length : length;
  return {FaultCode::outside_domain,
          "no two points of the path are " + to_text(separation) + " apart along it; at most " +
              to_text(most) + (closed ? ", half of its length" : ", its length"),
          std::nullopt,
          "separation",
          separation,
          most};
}

}  // namespace hodograph::path_detail

namespace hodograph {

const char* name_of(TubeLimit limit) {
  switch (limit) {
    case TubeLimit::curvature:
      return "curvature";
    case TubeLimit::distance:
      return "distance";
    case TubeLimit::corner:
      return "corner";
    case TubeLimit::standstill:
      break;
  }
  return "standstill";
}

}  // namespace hodograph
