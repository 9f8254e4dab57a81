// SPDX-License-Identifier: MIT
#include "simple_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "hodograph/foundation/accuracy.hpp"

namespace hodograph::surface_detail {
namespace {

/// A run of whole pieces, or a part of one piece.
struct Part {
  std::size_t first = 0, last = 0;  // pieces [first, last)
  double a = 0.0, b = 1.0;          // of the one piece
  int depth = 0;
  std::vector<Vector2<double>> points{};  // the control polygon
  Vector2<double> low{}, high{};
  DynamicPolynomial<Vector2<double>> weighted{};  // of the one piece
  DynamicPolynomial<double> weight{};

  bool is_run() const { return last - first > 1; }
};

class Search {
 public:
  Search(std::span<const RationalBezier> pieces, bool closed) : pieces_(pieces), closed_(closed) {
    double size = 0.0;
    for (const auto& piece : pieces) {
      for (const auto& p : piece.control_points) size = std::max(size, largest_component(p));
    }
    slack_ = accuracy::join_error<double>() * size;
  }

  std::optional<Vector2<double>> run() {
    check_alone(run_of(0, pieces_.size()));
    return contact_;
  }

 private:
  // Far more than a simple curve takes whose strands are not within rounding of each other.
  static constexpr int deepest = 44;
  static constexpr std::size_t most_steps = 4'000'000;

  Part run_of(std::size_t first, std::size_t last) const {
    Part part;
    part.first = first;
    part.last = last;
    if (!part.is_run()) {
      part.weighted = pieces_[first].weighted();
      part.weight = pieces_[first].weight();
    }
    for (std::size_t k = first; k < last; ++k) {
      const auto& points = pieces_[k].control_points;
      part.points.insert(part.points.end(), points.begin(), points.end());
    }
    set_box(part);
    return part;
  }

  static void set_box(Part& part) {
    part.low = part.high = part.points[0];
    for (const auto& p : part.points) {
      part.low = {std::min(part.low.x, p.x), std::min(part.low.y, p.y)};
      part.high = {std::max(part.high.x, p.x), std::max(part.high.y, p.y)};
    }
  }

  std::pair<Part, Part> halves(const Part& part) const {
    if (part.is_run()) {
      const std::size_t middle = part.first + (part.last - part.first) / 2;
      return {run_of(part.first, middle), run_of(middle, part.last)};
    }
    const auto half = [&part](double from, double to) {
      Part result;
      result.first = part.first;
      result.last = part.last;
      result.a = part.a + from * (part.b - part.a);
      result.b = part.a + to * (part.b - part.a);
      result.depth = part.depth + 1;
      result.weighted = part.weighted.restricted(from, to);
      result.weight = part.weight.restricted(from, to);
      for (std::size_t i = 0; i <= result.weight.degree(); ++i) {
        result.points.push_back((1.0 / result.weight[i]) * result.weighted[i]);
      }
      set_box(result);
      return result;
    };
    return {half(0.0, 0.5), half(0.5, 1.0)};
  }

  /// Whether q starts where p ends.
  bool follows(const Part& p, const Part& q) const {
    if (p.b == 1.0 && q.a == 0.0) {
      return p.last == q.first || (closed_ && p.last == pieces_.size() && q.first == 0);
    }
    return p.last == q.last && p.first == q.first && p.b == q.a;
  }

  static Vector2<double> direction(const Part& part) {
    const Vector2<double> chord = part.points.back() - part.points.front();
    const double size = norm(chord);
    return size > 0.0 ? (1.0 / size) * chord : Vector2<double>{};
  }
  bool advances(const Part& part, const Vector2<double>& along) const {
    for (std::size_t i = 0; i + 1 < part.points.size(); ++i) {
      const Vector2<double> step = part.points[i + 1] - part.points[i];
      if (step == Vector2<double>{}) continue;
      if (!(dot(step, along) > slack_ * largest_component(along))) return false;
    }
    return part.points.back() != part.points.front();
  }

  bool out_of_patience(const Part& p, const Part& q) {
    if (contact_) return true;
    if ((!p.is_run() && p.depth > deepest) || (!q.is_run() && q.depth > deepest) ||
        ++steps_ > most_steps) {
      contact_ = 0.5 * (p.points[0] + q.points[0]);
      return true;
    }
    return false;
  }

  void check_alone(const Part& part) {
    if (out_of_patience(part, part) || advances(part, direction(part))) return;
    const auto [p, q] = halves(part);
    check_alone(p);
    check_alone(q);
    check_pair(p, q);
  }

  void check_pair(const Part& p, const Part& q) {
    if (out_of_patience(p, q)) return;
    const bool forward = follows(p, q), backward = follows(q, p);
    if (!forward && !backward) {
      if (p.high.x + slack_ < q.low.x || q.high.x + slack_ < p.low.x ||
          p.high.y + slack_ < q.low.y || q.high.y + slack_ < p.low.y) {
        return;
      }
    } else if (forward != backward) {
      const Vector2<double> along = direction(p) + direction(q);
      if (advances(p, along) && advances(q, along)) return;
    }
    const double size_p = norm(p.high - p.low), size_q = norm(q.high - q.low);
    const bool both = forward || backward;
    if (both || (size_q <= size_p && (p.is_run() || size_p > 0.0))) {
      const auto [p1, p2] = halves(p);
      if (both) {
        const auto [q1, q2] = halves(q);
        for (const Part* x : {&p1, &p2}) {
          for (const Part* y : {&q1, &q2}) check_pair(*x, *y);
        }
        return;
      }
      check_pair(p1, q);
      check_pair(p2, q);
      return;
    }
    const auto [q1, q2] = halves(q);
    check_pair(p, q1);
    check_pair(p, q2);
  }

  std::span<const RationalBezier> pieces_;
  bool closed_;
  double slack_ = 0.0;
  std::size_t steps_ = 0;
  std::optional<Vector2<double>> contact_;
};

}  // namespace

std::optional<Vector2<double>> self_contact(std::span<const RationalBezier> pieces, bool closed) {
  return Search(pieces, closed).run();
}

}  // namespace hodograph::surface_detail
