// SPDX-License-Identifier: MIT
#include "surface_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "exact_piece.hpp"
#include "plane_between.hpp"

namespace hodograph::surface_detail {
namespace {

using Vectors = DynamicPolynomial<Vector3<double>>;
using Scalars = DynamicPolynomial<double>;

/// Rounding, of the numbers' size: coefficients carry some hundred ε.
constexpr double margin = 0x1.0p-40;
constexpr std::size_t most_pairs = 200'000;
constexpr int deepest = 14;
constexpr double infinity = std::numeric_limits<double>::infinity();

double largest(const std::vector<Vector3<double>>& points) {
  double size = 0.0;
  for (const auto& p : points) size = std::max(size, largest_component(p));
  return size;
}
double largest(const std::vector<double>& numbers) {
  double size = 0.0;
  for (const double c : numbers) size = std::max(size, std::abs(c));
  return size;
}

/// Points whose convex hull holds f/g on [0, 1]. Domain: g has positive coefficients.
std::vector<Vector3<double>> quotient_hull(const Vectors& f, const Scalars& g) {
  const std::size_t degree = std::max(f.degree(), g.degree());
  const Vectors top = f.elevated(degree);
  const Scalars bottom = g.elevated(degree);
  std::vector<Vector3<double>> hull;
  for (std::size_t i = 0; i <= degree; ++i) hull.push_back((1.0 / bottom[i]) * top[i]);
  return hull;
}

bool is_positive(const Scalars& f) {
  return std::all_of(f.coefficients().begin(), f.coefficients().end(),
                     [](double c) { return c > 0.0; });
}

/// A whole piece of the motion: S = shift + (top + Σ e_j p_j)/W, S_v = (onward + Σ change_j
/// p_j)/W².
struct MotionRoot {
  double begin = 0.0, end = 1.0;  ///< in ξ
  Vector3<double> shift{};        ///< from the start of the first piece
  Scalars weight, square;         ///< W, W²
  Vectors top, onward;            ///< W (c - start), W² c'
  std::array<Vectors, 3> e, change;
  double from = 0.0, to = 1.0;  ///< the part of the piece
  // Sizes, of what the rounding of derivatives is relative to.
  double onward_size = 0.0, change_size = 0.0;
};

/// A whole piece of the profile: p = top/weight, p' = rate/square.
struct ProfileRoot {
  Vectors top, rate;
  Scalars weight, square;
  double from = 0.0, to = 1.0;
  double rate_size = 0.0;
};

/// A stretch along v: coefficients of a common degree, quotients taken.
struct Row {
  bool usable = false;
  double begin = 0.0;
  std::vector<Vector3<double>> at, onward;
  std::array<std::vector<Vector3<double>>, 3> e, change;
  /// Of the numbers that these were made of: c, λR, c' and (λR)'.
  double at_size = 0.0, turn_size = 0.0, onward_size = 0.0, change_size = 0.0;
};

/// A stretch along u.
struct Column {
  bool usable = false;
  std::vector<Vector3<double>> at, rate;
  double at_size = 0.0, rate_size = 0.0;
};

struct Box {
  Vector3<double> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  double size = 0.0;  ///< of the numbers that its corners were made of
  static Box everywhere() {
    return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}, 0.0};
  }
};

/// A patch: points whose convex hulls hold S, S_v and S_u.
struct Patch {
  bool usable = false;
  std::vector<Vector3<double>> at, along_v, along_u;
  Box box = Box::everywhere();
  Vector3<double> middle{}, mean_v{}, mean_u{};
  double size_v = 0.0, size_u = 0.0;
};

Vectors crossed(const Vectors& f, const Scalars& g, const Vectors& f_rate, const Scalars& g_rate) {
  return scaled_product(g, f_rate) + -1.0 * scaled_product(g_rate, f);
}

std::vector<MotionRoot> motion_roots(const Motion& motion) {
  std::vector<MotionRoot> roots;
  for (const MotionPiece& piece : motion.pieces()) {
    const ExactPiece exact = exact_piece(piece);
    MotionRoot root;
    root.begin = piece.begin;
    root.end = piece.end;
    root.shift = piece.start - motion.pieces().front().start;
    root.weight = exact.weight;
    root.square = scaled_product(exact.weight, exact.weight);
    root.top = scaled_product(exact.weight, piece.displacement);
    const Vectors velocity = piece.displacement.derivative();
    root.onward = scaled_product(root.square, velocity);
    const Scalars weight_rate = exact.weight.derivative();
    root.e = {exact.e1, exact.e2, exact.e3};
    root.onward_size = largest(root.square.coefficients()) * largest(velocity.coefficients());
    for (std::size_t j = 0; j < 3; ++j) {
      const Vectors rate = root.e[j].derivative();
      root.change[j] = crossed(root.e[j], exact.weight, rate, weight_rate);
      root.change_size += largest(rate.coefficients()) * largest(exact.weight.coefficients()) +
                          largest(root.e[j].coefficients()) * largest(weight_rate.coefficients());
    }
    roots.push_back(std::move(root));
  }
  return roots;
}

std::vector<ProfileRoot> profile_roots(const Profile& profile, double factor) {
  std::vector<ProfileRoot> roots;
  for (const SpatialRationalBezier& curve : profile.pieces()) {
    std::vector<Vector3<double>> weighted;
    for (std::size_t i = 0; i <= curve.degree(); ++i) {
      weighted.push_back((curve.weights[i] * factor) * curve.control_points[i]);
    }
    ProfileRoot root;
    const bool polynomial = std::all_of(curve.weights.begin(), curve.weights.end(),
                                        [&](double w) { return w == curve.weights[0]; });
    root.top = Vectors(weighted);
    root.weight = polynomial ? Scalars{curve.weights[0]} : Scalars(curve.weights);
    root.square = scaled_product(root.weight, root.weight);
    const Vectors rate = root.top.derivative();
    const Scalars weight_rate = root.weight.derivative();
    root.rate = crossed(root.top, root.weight, rate, weight_rate);
    root.rate_size = largest(rate.coefficients()) * largest(root.weight.coefficients()) +
                     largest(weighted) * largest(weight_rate.coefficients());
    roots.push_back(std::move(root));
  }
  return roots;
}

/// Each root cut into 2^k equal parts.
template <class Root>
std::vector<Root> cut(const std::vector<Root>& roots, int k) {
  const int parts = 1 << k;
  std::vector<Root> result;
  for (const Root& root : roots) {
    for (int i = 0; i < parts; ++i) {
      Root part = root;
      part.from = static_cast<double>(i) / parts;
      part.to = static_cast<double>(i + 1) / parts;
      result.push_back(std::move(part));
    }
  }
  return result;
}

/// The lengths of the surface along v and u, roughly: only the shape of the patches hangs on it.
std::array<double, 2> extent_of(const Sweep& sweep, double factor) {
  constexpr int steps = 4;
  double length = 0.0, width = 0.0;
  for (std::size_t k = 0; k < sweep.motion.pieces().size(); ++k) {
    for (int i = 0; i < steps; ++i) {
      const MotionState state = sweep.motion.at(k, (i + 0.5) / steps);
      length += (norm(state.velocity) +
                 (state.scale * norm(state.body_rate) + std::abs(state.scale_rate)) * factor *
                     sweep.profile.reach()) /
                steps;
    }
  }
  for (const auto& curve : sweep.profile.pieces()) {
    for (std::size_t i = 1; i <= curve.degree(); ++i) {
      width += factor * sweep.motion.largest_scale() *
               norm(curve.control_points[i] - curve.control_points[i - 1]);
    }
  }
  return {length, width};
}

class SurfaceSearch {
 public:
  SurfaceSearch(const Sweep& sweep, double factor)
      : closed_v_(sweep.motion.is_closed()), closed_u_(sweep.profile.is_closed()) {
    row_roots_ = motion_roots(sweep.motion);
    column_roots_ = profile_roots(sweep.profile, factor);
    // At least four parts where it closes, so that neighbours are on one side only; and patches
    // about as long as they are wide.
    constexpr int least = 2, most = 6;
    int along = closed_v_ ? least : 0, round = closed_u_ ? least : 0;
    const auto [length, width] = extent_of(sweep, factor);
    double ratio = (length / static_cast<double>(row_roots_.size() << along)) /
                   (width / static_cast<double>(column_roots_.size() << round));
    constexpr double half = 0.5;
    for (; ratio > 2.0 && along < most; ratio *= half) ++along;
    for (; ratio < half && round < most; ratio *= 2.0) ++round;
    row_roots_ = cut(row_roots_, along);
    column_roots_ = cut(column_roots_, round);
    while ((row_roots_.size() >> groups_) > 0 || (column_roots_.size() >> groups_) > 0) ++groups_;
  }

  SweepContact run() {
    SweepContact answer;
    constexpr int most_groups = 14;
    if (groups_ > most_groups) return answer;
    std::vector<Pair> open{{-groups_, {0, 0}, {0, 0}}};
    while (!open.empty()) {
      const Pair pair = open.back();
      open.pop_back();
      if (is_apart_or_regular(pair)) continue;
      if (++answer.pairs > most_pairs || pair.depth >= deepest) {
        const int depth = std::max(0, pair.depth);
        const auto begin_of = [&](Index i) { return row(depth, i << (depth - pair.depth)).begin; };
        answer.xi[0] = begin_of(std::min(pair.first.v, pair.second.v));
        answer.xi[1] = begin_of(std::max(pair.first.v, pair.second.v));
        return answer;
      }
      push_children(open, pair);
    }
    answer.free = true;
    return answer;
  }

 private:
  using Index = std::int64_t;
  struct Place {
    Index v = 0, u = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  /// Two patches of a depth: below 0 groups of 2^-depth by 2^-depth roots, 0 the roots, above their
  /// parts.
  struct Pair {
    int depth;
    Place first, second;
  };

  static Index count(std::size_t roots, int depth) {
    const auto n = static_cast<Index>(roots);
    return depth >= 0 ? n << depth : ((n - 1) >> -depth) + 1;
  }

  void push_children(std::vector<Pair>& open, const Pair& pair) const {
    const int depth = pair.depth + 1;
    const Index rows = count(row_roots_.size(), depth),
                columns = count(column_roots_.size(), depth);
    const auto child = [](const Place& p, Index k) {
      return Place{2 * p.v + (k >> 1), 2 * p.u + (k & 1)};
    };
    for (Index i = 0; i < 4; ++i) {
      const Place a = child(pair.first, i);
      if (a.v >= rows || a.u >= columns) continue;
      for (Index j = pair.first == pair.second ? i : 0; j < 4; ++j) {
        const Place b = child(pair.second, j);
        if (b.v < rows && b.u < columns) open.push_back({depth, a, b});
      }
    }
  }

  static bool touching(Index a, Index b, Index n, bool closed) {
    const Index step = std::abs(a - b);
    return step <= 1 || (closed && step == n - 1);
  }

  bool is_apart_or_regular(const Pair& pair) {
    if (pair.depth < 0) {
      return boxes_apart(box(pair.depth, pair.first), box(pair.depth, pair.second));
    }
    constexpr std::size_t most_kept = 4096;
    if (patches_.size() > most_kept) {
      patches_.clear();
      rows_.clear();
      columns_.clear();
    }
    const Index rows = count(row_roots_.size(), pair.depth);
    const Index columns = count(column_roots_.size(), pair.depth);
    if (!touching(pair.first.v, pair.second.v, rows, closed_v_) ||
        !touching(pair.first.u, pair.second.u, columns, closed_u_)) {
      return apart(patch(pair.depth, pair.first), patch(pair.depth, pair.second));
    }
    std::vector<const Patch*> block{&patch(pair.depth, pair.first)};
    if (pair.first.v != pair.second.v) {
      block.push_back(&patch(pair.depth, {pair.second.v, pair.first.u}));
    }
    if (pair.first.u != pair.second.u) {
      block.push_back(&patch(pair.depth, {pair.first.v, pair.second.u}));
    }
    if (block.size() == 3) block.push_back(&patch(pair.depth, pair.second));
    return is_regular(block);
  }

  static bool boxes_apart(const Box& a, const Box& b) {
    const double off = margin * std::max(a.size, b.size);
    for (std::size_t i = 0; i < 3; ++i) {
      if (a.high[i] + off < b.low[i] || b.high[i] + off < a.low[i]) return true;
    }
    return false;
  }

  static bool apart(const Patch& a, const Patch& b) {
    if (!a.usable || !b.usable) return false;
    if (boxes_apart(a.box, b.box)) return true;
    const double off = margin * std::max(a.box.size, b.box.size);
    const Vector3<double> n = cross(a.mean_v, a.mean_u), m = cross(b.mean_v, b.mean_u);
    for (const Vector3<double>& direction :
         {b.middle - a.middle, a.mean_v, a.mean_u, b.mean_v, b.mean_u, n, m, cross(n, m)}) {
      if (plane_between(a.at, b.at, direction, off)) return true;
    }
    return false;
  }

  /// Whether the surface is injective on the block.
  static bool is_regular(const std::vector<const Patch*>& block) {
    Vector3<double> v{}, u{};
    double size_v = 0.0, size_u = 0.0;
    for (const Patch* p : block) {
      if (!p->usable) return false;
      v = v + p->mean_v;
      u = u + p->mean_u;
      size_v = std::max(size_v, p->size_v);
      size_u = std::max(size_u, p->size_u);
    }
    // a across u and b across v, so that the matrix is about diagonal; in the middle between those
    // of the patches, so that the surface may bend at their edge.
    const auto unit = [](const Vector3<double>& d) { return (1.0 / largest_component(d)) * d; };
    const auto across = [&](const Vector3<double>& direction, const Vector3<double>& other) {
      const Vector3<double> d = unit(direction), o = unit(other);
      return unit(d - (dot(d, o) / dot(o, o)) * o);
    };
    Vector3<double> a{}, b{};
    for (const Patch* p : block) {
      a = a + across(p->mean_v, u);
      b = b + across(p->mean_u, v);
    }
    if (!is_finite(a) || !is_finite(b)) return false;
    constexpr double components = 4.0;
    const double off_v = components * margin * size_v, off_u = components * margin * size_u;
    const double size_a = norm(a), size_b = norm(b);
    double a_v = infinity, a_u = 0.0, b_v = 0.0, b_u = infinity;
    for (const Patch* p : block) {
      for (const auto& d : p->along_v) {
        a_v = std::min(a_v, dot(a, d));
        b_v = std::max(b_v, std::abs(dot(b, d)));
      }
      for (const auto& d : p->along_u) {
        a_u = std::max(a_u, std::abs(dot(a, d)));
        b_u = std::min(b_u, dot(b, d));
      }
    }
    a_v -= size_a * off_v;
    a_u += size_a * off_u;
    b_v += size_b * off_v;
    b_u -= size_b * off_u;
    return a_v > 0.0 && b_u > 0.0 && a_v > (1.0 + margin) * a_u * (b_v / b_u);
  }

  Row& row(int depth, Index i) {
    const auto [place, fresh] = rows_.try_emplace(key(depth, i));
    Row& row = place->second;
    if (!fresh) return row;
    const MotionRoot& root = row_roots_[static_cast<std::size_t>(i >> depth)];
    const auto [from, to] = part_of(root.from, root.to, depth, i);
    row.begin = root.begin + from * (root.end - root.begin);
    const auto weight = root.weight.restricted(from, to);
    const auto square = root.square.restricted(from, to);
    if (!is_positive(weight) || !is_positive(square)) return row;
    const double step = to - from, least = *std::min_element(square.coefficients().begin(),
                                                             square.coefficients().end());
    // What is added up by the coefficients' index has one degree.
    const std::size_t degree =
        std::max({root.top.degree(), root.e[0].degree(), root.weight.degree()});
    const std::size_t rate_degree =
        std::max({root.onward.degree(), root.change[0].degree(), root.square.degree()});
    const auto bottom = weight.elevated(degree);
    const auto rate_bottom = square.elevated(rate_degree);
    row.at = quotient_hull(root.top.restricted(from, to).elevated(degree), bottom);
    for (auto& p : row.at) p = root.shift + p;
    row.onward =
        quotient_hull(step * root.onward.restricted(from, to).elevated(rate_degree), rate_bottom);
    for (std::size_t j = 0; j < 3; ++j) {
      row.e[j] = quotient_hull(root.e[j].restricted(from, to).elevated(degree), bottom);
      row.change[j] = quotient_hull(
          step * root.change[j].restricted(from, to).elevated(rate_degree), rate_bottom);
    }
    const double least_weight =
        *std::min_element(weight.coefficients().begin(), weight.coefficients().end());
    row.at_size = largest_component(root.shift) + largest(root.top.coefficients()) / least_weight;
    for (const Vectors& e : root.e) row.turn_size += largest(e.coefficients()) / least_weight;
    row.onward_size = step * root.onward_size / least;
    row.change_size = step * root.change_size / least;
    row.usable = true;
    return row;
  }

  Column& column(int depth, Index i) {
    const auto [place, fresh] = columns_.try_emplace(key(depth, i));
    Column& column = place->second;
    if (!fresh) return column;
    const ProfileRoot& root = column_roots_[static_cast<std::size_t>(i >> depth)];
    const auto [from, to] = part_of(root.from, root.to, depth, i);
    const auto weight = root.weight.restricted(from, to);
    const auto square = root.square.restricted(from, to);
    if (!is_positive(weight) || !is_positive(square)) return column;
    const double step = to - from, least = *std::min_element(square.coefficients().begin(),
                                                             square.coefficients().end());
    column.at = quotient_hull(root.top.restricted(from, to), weight);
    column.rate = quotient_hull(step * root.rate.restricted(from, to), square);
    column.at_size = largest(root.top.coefficients()) /
                     *std::min_element(weight.coefficients().begin(), weight.coefficients().end());
    column.rate_size = step * root.rate_size / least;
    column.usable = true;
    return column;
  }

  Patch& patch(int depth, const Place& at) {
    constexpr int bits = 30;
    const auto [place, fresh] =
        patches_.try_emplace((key(depth, at.v) << bits) | static_cast<std::uint64_t>(at.u));
    Patch& patch = place->second;
    if (!fresh) return patch;
    const Row& row = this->row(depth, at.v);
    const Column& column = this->column(depth, at.u);
    if (!row.usable || !column.usable) return patch;
    const auto turned = [](const std::array<std::vector<Vector3<double>>, 3>& e, std::size_t i,
                           const Vector3<double>& p) {
      return p.x * e[0][i] + p.y * e[1][i] + p.z * e[2][i];
    };
    patch.usable = true;
    patch.box = Box{};
    for (std::size_t i = 0; i < row.at.size(); ++i) {
      for (const auto& p : column.at) patch.at.push_back(row.at[i] + turned(row.e, i, p));
      for (const auto& p : column.rate) patch.along_u.push_back(turned(row.e, i, p));
    }
    for (std::size_t i = 0; i < row.onward.size(); ++i) {
      for (const auto& p : column.at) {
        patch.along_v.push_back(row.onward[i] + turned(row.change, i, p));
      }
    }
    const auto mean = [&](const std::vector<Vector3<double>>& points) {
      Vector3<double> sum{};
      for (const auto& p : points) sum = sum + p;
      const Vector3<double> m = (1.0 / static_cast<double>(points.size())) * sum;
      patch.usable = patch.usable && is_finite(m);
      return m;
    };
    patch.middle = mean(patch.at);
    patch.mean_v = mean(patch.along_v);
    patch.mean_u = mean(patch.along_u);
    for (const auto& p : patch.at) {
      for (std::size_t i = 0; i < 3; ++i) {
        patch.box.low[i] = std::min(patch.box.low[i], p[i]);
        patch.box.high[i] = std::max(patch.box.high[i], p[i]);
      }
    }
    patch.box.size = row.at_size + row.turn_size * column.at_size;
    patch.size_v = row.onward_size + row.change_size * column.at_size;
    patch.size_u = row.turn_size * column.rate_size;
    if (!patch.usable) patch.box = Box::everywhere();
    return patch;
  }

  /// The box of a group of roots.
  const Box& box(int depth, const Place& at) {
    if (depth == 0) return patch(0, at).box;
    constexpr int bits = 30;
    const auto [place, fresh] =
        boxes_.try_emplace((key(-depth, at.v) << bits) | static_cast<std::uint64_t>(at.u));
    if (!fresh) return place->second;
    Box sum;
    std::vector<Pair> children;
    push_children(children, {depth, at, at});
    for (const Pair& child : children) {
      if (!(child.first == child.second)) continue;
      const Box& part = box(depth + 1, child.first);
      for (std::size_t i = 0; i < 3; ++i) {
        sum.low[i] = std::min(sum.low[i], part.low[i]);
        sum.high[i] = std::max(sum.high[i], part.high[i]);
      }
      sum.size = std::max(sum.size, part.size);
    }
    return boxes_[(key(-depth, at.v) << bits) | static_cast<std::uint64_t>(at.u)] = sum;
  }

  static std::uint64_t key(int depth, Index i) {
    constexpr int bits = 30;
    return (static_cast<std::uint64_t>(depth) << bits) | static_cast<std::uint64_t>(i);
  }
  /// The part of a piece that is part i of a depth.
  static std::array<double, 2> part_of(double from, double to, int depth, Index i) {
    const Index parts = Index{1} << depth, k = i & (parts - 1);
    const double width = (to - from) / static_cast<double>(parts);  // exact: powers of two
    return {from + width * static_cast<double>(k), from + width * static_cast<double>(k + 1)};
  }

  bool closed_v_, closed_u_;
  int groups_ = 0;
  std::vector<MotionRoot> row_roots_;
  std::vector<ProfileRoot> column_roots_;
  std::unordered_map<std::uint64_t, Row> rows_;
  std::unordered_map<std::uint64_t, Column> columns_;
  std::unordered_map<std::uint64_t, Patch> patches_;
  std::unordered_map<std::uint64_t, Box> boxes_;
};

}  // namespace

SweepContact surface_contact(const Sweep& sweep, double factor) {
  if (sweep.motion.roll() != nullptr) return {};
  return SurfaceSearch(sweep, factor).run();
}

}  // namespace hodograph::surface_detail
