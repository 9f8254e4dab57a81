// SPDX-License-Identifier: MIT
#include "planar_spline_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace hodograph::planar_spline_detail {
namespace {

template <class S>
struct BasicRow {
  Complex<S> value;                   ///< F
  Complex<S> lower, diagonal, upper;  ///< ∂F/∂z_{i-1}, ∂F/∂z_i, ∂F/∂z_{i+1}
  S size;                             ///< |a|² + |b|² + |z|², to judge F by
};
using Row = BasicRow<double>;

struct EvenWeights {
  double operator[](std::size_t) const { return 0.5; }
};

/// F is a quadratic form less the target: the form is half of Σ (variable times derivative).
template <class S>
[[gnu::always_inline]] inline BasicRow<S> inner_row(const Complex<S>& a, const Complex<S>& z,
                                                    const Complex<S>& b, const S& before,
                                                    const S& after, const Complex<S>& target) {
  const S one(1.0), half(0.5), three(3.0), six(6.0);
  const Complex<S> by_a = six * a + three * z + b;
  const Complex<S> by_z = S(4.0) * z + three * (a + b);
  const Complex<S> by_b = six * b + three * z + a;
  return {half * (a * by_a + z * by_z + b * by_b) - target, before * by_a,
          by_z + (one - before) * by_a + after * by_b, (one - after) * by_b,
          dot(a, a) + dot(b, b) + dot(z, z)};
}

/// The row of a straight end whose other node has the value b = own z + (1 - own) neighbour;
/// `lower` is left empty and `upper` belongs to the neighbour.
Row end_row(const Number& z, const Number& b, double own, const Number& target) {
  const Number by_z = 40.0 * z - 10.0 * b;
  const Number by_b = 10.0 * (b - z);
  const Number a = 2.0 * z - b;
  return {0.5 * (z * by_z + b * by_b) - target, Number{}, by_z + own * by_b, (1.0 - own) * by_b,
          squared(a) + squared(b) + squared(z)};
}

/// The rows at z.
template <class Weights>
struct RowMaker {
  const SplineProblem& problem;
  Weights weight;
  const Number* z;

  std::size_t last() const { return problem.size() - 1; }
  /// The preimage at a node: between the spans node - 1 and node, one of them perhaps outside.
  Number node(std::size_t k) const {
    const std::size_t size = problem.size();
    const bool periodic = problem.first == SplineEnd::periodic;
    const double g = weight[k];
    const Number x = k > 0 ? z[k - 1] : periodic ? problem.closure * z[size - 1] : problem.before;
    const Number y = k < size ? z[k] : periodic ? problem.closure * z[0] : problem.after;
    return g * x + (1.0 - g) * y;
  }
  /// At a node between two spans of the problem.
  [[gnu::always_inline]] Number inner_node(std::size_t k) const {
    const double g = weight[k];
    return g * z[k - 1] + (1.0 - g) * z[k];
  }
  /// A row with two neighbours, from the nodes around it.
  [[gnu::always_inline]] Row between(const Number& a, std::size_t i, const Number& b) const {
    return inner_row(a, z[i], b, weight[i], weight[i + 1], problem.target[i]);
  }
  /// Any row.
  Row row(std::size_t i) const {
    const bool left = i > 0 || problem.first != SplineEnd::straight;
    const bool right = i < last() || problem.last != SplineEnd::straight;
    if (left && right) return between(node(i), i, node(i + 1));
    if (right) return end_row(z[i], node(i + 1), weight[i + 1], problem.target[i]);
    if (left) {
      Row row = end_row(z[i], node(i), 1.0 - weight[i], problem.target[i]);
      std::swap(row.lower, row.upper);
      return row;
    }
    return {15.0 * (z[i] * z[i]) - problem.target[i], {}, 30.0 * z[i], {}, 3.0 * squared(z[i])};
  }
};

/// Calls visit(i, row) for the rows in order.
template <class Weights, class Visit>
[[gnu::always_inline]] inline void for_each_row(const RowMaker<Weights>& rows, const Visit& visit) {
  const std::size_t last = rows.last();
  visit(std::size_t{0}, rows.row(0));
  if (last == 0) return;
  Number a = rows.inner_node(1);
  for (std::size_t i = 1; i < last; ++i) {
    const Number b = rows.inner_node(i + 1);
    visit(i, rows.between(a, i, b));
    a = b;
  }
  visit(last, rows.row(last));
}

/// Calls use(rows) with the rows of a problem at z.
template <class Use>
[[gnu::always_inline]] inline void with_rows(const SplineProblem& problem, const Number* z,
                                             const Use& use) {
  if (problem.weight.empty()) {
    use(RowMaker<EvenWeights>{problem, {}, z});
  } else {
    use(RowMaker<const double*>{problem, problem.weight.data(), z});
  }
}

template <class Visit>
[[gnu::always_inline]] inline void for_each_row(const SplineProblem& problem,
                                                const std::vector<Number>& z, const Visit& visit) {
  with_rows(problem, z.data(), [&](const auto& rows) { for_each_row(rows, visit); });
}

/// Collects the misfit; the worst row is found without a division.
struct Collector {
  const double* importance;
  double merit = 0.0, worst = 0.0, worst_size = 1.0;
  std::size_t row = 0;

  [[gnu::always_inline]] void take(std::size_t i, const Row& r) {
    const double square = squared(r.value), size = r.size * r.size;
    merit += importance[i] * square;
    // Not a number counts as worse than everything.
    if (!(square * worst_size <= worst * size)) {
      worst = square;
      worst_size = size;
      row = i;
    }
  }
  void take(const Collector& other) {
    merit += other.merit;
    if (!(other.worst * worst_size <= worst * other.worst_size)) {
      worst = other.worst;
      worst_size = other.worst_size;
      row = other.row;
    }
  }
  Misfit misfit() const {
    const double ratio = std::sqrt(worst / worst_size);
    return {merit, ratio == ratio ? ratio : std::numeric_limits<double>::infinity(), row};
  }
};

/// An entry of the border smaller than this times the largest possible has no effect on a double.
constexpr double negligible_square = 0x1p-240;  // not a tolerance: far below ε², to be safe

/// Gaussian elimination from one end towards the middle, without exchanges; `border` is the column
/// of the last unknown of a periodic problem, which dies out on the way.
struct Chain {
  Collector collector;
  Number ratio{}, step{}, border{};
  bool border_active = false;
  std::size_t border_rows = 0;  ///< how many rows have an entry in that column

  /// The next row: `lower` belongs to the unknown eliminated last, `upper` to the next one.
  [[gnu::always_inline]] void take(const Row& row, const Number& lower, const Number& upper,
                                   std::size_t i, Number* ratios, Number* steps, Number* borders,
                                   const Number& entry = {}) {
    collector.take(i, row);
    const Number pivot = row.diagonal - lower * ratio;
    const Number inverse = reciprocal(pivot);
    ratio = upper * inverse;
    step = (-row.value - lower * step) * inverse;
    ratios[i] = ratio;
    steps[i] = step;
    if (border_active) {
      border = (entry - lower * border) * inverse;
      borders[i] = border;
      ++border_rows;
      if (squared(border) < negligible_square) border_active = false;
    }
  }
};

#if defined(__GNUC__)  // GCC and Clang: vector extensions

/// Two doubles in one register, each with the arithmetic of its own.
struct Lanes {
  typedef double Numbers __attribute__((vector_size(16)));
  Numbers value{};

  Lanes() = default;
  explicit Lanes(double x) : value{x, x} {}
  explicit Lanes(Numbers x) : value(x) {}
  Lanes(double first, double second) : value{first, second} {}

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.value + b.value); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.value - b.value); }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.value); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.value * b.value); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return Lanes(a.value / b.value); }
};
using TwoNumbers = Complex<Lanes>;

inline TwoNumbers pack(const Number& first, const Number& second) {
  return {{first.re, second.re}, {first.im, second.im}};
}
inline Number first_of(const TwoNumbers& a) { return {a.re.value[0], a.im.value[0]}; }
inline Number second_of(const TwoNumbers& a) { return {a.re.value[1], a.im.value[1]}; }

/// Both chains at once, rows i from the front and j from the back as long as i < j, in the two
/// lanes of every register; for chains whose border has died out. Leaves the indices of the next
/// rows.
template <class Rows>
void take_in_lanes(const Rows& rows, Chain& front, Chain& back, std::size_t& i, std::size_t& j,
                   Number* ratios, Number* steps) {
  const Number* const z = rows.z;
  const Number* const target = rows.problem.target.data();
  const double* const importance = rows.problem.importance.data();
  const Lanes one(1.0);
  TwoNumbers ratio = pack(front.ratio, back.ratio), step = pack(front.step, back.step);
  // Seen from the back a row is mirrored: near is the side of what is eliminated already.
  TwoNumbers near = pack(rows.inner_node(i), rows.inner_node(j + 1)), here = pack(z[i], z[j]);
  Lanes merit, worst(front.collector.worst, back.collector.worst),
      worst_size(front.collector.worst_size, back.collector.worst_size);
  auto places = worst.value < worst.value;  // lanes of integers
  places[0] = static_cast<std::int64_t>(front.collector.row);
  places[1] = static_cast<std::int64_t>(back.collector.row);
  auto place = places;
  for (; i + 1 < j; ++i, --j) {
    const TwoNumbers next = pack(z[i + 1], z[j - 1]);
    const Lanes before(rows.weight[i], 1.0 - rows.weight[j + 1]);
    const Lanes after(rows.weight[i + 1], 1.0 - rows.weight[j]);
    const TwoNumbers far = after * here + (one - after) * next;
    const auto row = inner_row(near, here, far, before, after, pack(target[i], target[j]));
    const TwoNumbers pivot = row.diagonal - row.lower * ratio;
    const Lanes scale = one / dot(pivot, pivot);
    const TwoNumbers inverse{pivot.re * scale, -(pivot.im * scale)};
    ratio = row.upper * inverse;
    step = (-row.value - row.lower * step) * inverse;
    ratios[i] = first_of(ratio);
    ratios[j] = second_of(ratio);
    steps[i] = first_of(step);
    steps[j] = second_of(step);

    const Lanes square = dot(row.value, row.value), size = row.size * row.size;
    merit = merit + Lanes(importance[i], importance[j]) * square;
    const auto kept = (square * worst_size).value <= (worst * size).value;
    places[0] = static_cast<std::int64_t>(i);
    places[1] = static_cast<std::int64_t>(j);
    worst = Lanes(kept ? worst.value : square.value);
    worst_size = Lanes(kept ? worst_size.value : size.value);
    place = kept ? place : places;
    near = far;
    here = next;
  }
  const auto hand_back = [&](Chain& chain, const Number& last_ratio, const Number& last_step,
                             int lane) {
    chain.ratio = last_ratio;
    chain.step = last_step;
    chain.collector.merit += merit.value[lane];
    chain.collector.worst = worst.value[lane];
    chain.collector.worst_size = worst_size.value[lane];
    chain.collector.row = static_cast<std::size_t>(place[lane]);
  };
  hand_back(front, first_of(ratio), first_of(step), 0);
  hand_back(back, second_of(ratio), second_of(step), 1);
}

#endif

/// One step of Gaussian elimination with row exchanges between two neighbouring rows: columns
/// i, i + 1, i + 2 and two right sides.
using WideRow = std::array<Number, 5>;

}  // namespace

void SplineProblem::weigh_rows() {
  // A row counts relative to the chords near it; the bound keeps the numbers finite.
  constexpr double smallest = std::numeric_limits<double>::min();
  importance.resize(size());
  double previous = size() > 0 ? squared(target[0]) : 0.0, here = previous;
  for (std::size_t i = 0; i < size(); ++i) {
    const double next = i + 1 < size() ? squared(target[i + 1]) : here;
    importance[i] = 1.0 / std::max({previous, here, next, smallest});
    previous = here;
    here = next;
  }
}

SpanCoefficients coefficients(const SplineProblem& problem, const std::vector<Number>& z,
                              std::size_t i) {
  SpanCoefficients span{z[i], z[i], z[i]};
  with_rows(problem, z.data(), [&](const auto& rows) {
    const bool left = i > 0 || problem.first != SplineEnd::straight;
    const bool right = i + 1 < z.size() || problem.last != SplineEnd::straight;
    if (left) span.a = rows.node(i);
    if (right) span.b = rows.node(i + 1);
    if (left && !right) span.b = 2.0 * span.z - span.a;
    if (right && !left) span.a = 2.0 * span.z - span.b;
  });
  return span;
}

SplineSystem::SplineSystem(const SplineProblem& problem)
    : problem_(problem), step_(problem.size()), ratio_(problem.size()) {
  if (problem.first == SplineEnd::periodic) border_.resize(problem.size());
}

Misfit SplineSystem::measure(const std::vector<Number>& z) const {
  Collector collector{problem_.importance.data()};
  for_each_row(problem_, z, [&](std::size_t i, const Row& row) { collector.take(i, row); });
  return collector.misfit();
}

std::vector<Number> SplineSystem::values(const std::vector<Number>& z) const {
  std::vector<Number> result(z.size());
  for_each_row(problem_, z, [&](std::size_t i, const Row& row) { result[i] = row.value; });
  return result;
}

std::vector<double> SplineSystem::misfits(const std::vector<Number>& z) const {
  std::vector<double> result(z.size());
  for_each_row(problem_, z, [&](std::size_t i, const Row& row) {
    result[i] = std::hypot(row.value.re, row.value.im) / row.size;
  });
  return result;
}

Misfit SplineSystem::newton_step(const std::vector<Number>& z, std::vector<Number>& moved) {
  Misfit misfit;
  with_rows(problem_, z.data(), [&](const auto& rows) { misfit = eliminate(rows, moved); });
  return misfit;
}

template <class Rows>
Misfit SplineSystem::eliminate(const Rows& rows, std::vector<Number>& moved) {
  const bool periodic = problem_.first == SplineEnd::periodic;
  const std::size_t size = problem_.size();
  const std::size_t count = periodic ? size - 1 : size;  // rows of the tridiagonal part
  const std::size_t half = count / 2;                    // from the front; the rest from the back
  Number* const step = step_.data();
  Number* const ratio = ratio_.data();
  Number* const border = border_.data();
  const Number* const z = rows.z;
  const double* const importance = problem_.importance.data();
  Chain front{Collector{importance}}, back{Collector{importance}};
  front.border_active = back.border_active = periodic;

  // The two chains of divisions run side by side.
  {
    const std::size_t i = count - 1;
    const Row row = rows.row(i);
    const Row first = half > 0 ? rows.row(0) : Row{};
    Number entry = periodic ? row.upper : Number{};
    if (periodic && half == 0) entry += problem_.closure * row.lower;
    back.take(row, Number{}, half == 0 ? Number{} : row.lower, i, ratio, step, border, entry);
    if (half > 0) {
      front.take(first, Number{}, first.upper, 0, ratio, step, border,
                 periodic ? problem_.closure * first.lower : Number{});
    }
  }
  if (half > 0) {
    std::size_t i = 1, j = count - 2;  // the next rows
    const auto from_front = [&] {
      const Row row = rows.between(rows.inner_node(i), i, rows.inner_node(i + 1));
      front.take(row, row.lower, row.upper, i, ratio, step, border);
      ++i;
    };
    const auto from_back = [&] {
      const Row row = rows.between(rows.inner_node(j), j, rows.inner_node(j + 1));
      back.take(row, row.upper, row.lower, j, ratio, step, border);
      --j;
    };
    while (i < half) {
#if defined(__GNUC__)
      if (!front.border_active && !back.border_active && i + 1 < j) {
        take_in_lanes(rows, front, back, i, j, ratio, step);
        continue;
      }
#endif
      from_front();
      from_back();
    }
    if (count % 2 == 1) from_back();
  }

  // Where they meet: x + front.ratio y = front.step, y + back.ratio x = back.step.
  const Number inverse = reciprocal(Number{1.0, 0.0} - back.ratio * front.ratio);
  Number y = half > 0 ? (back.step - back.ratio * front.step) * inverse : back.step;
  Number x = front.step - front.ratio * y;
  step[half] = y;
  moved[half] = z[half] + y;
  if (half > 0) {
    step[half - 1] = x;
    moved[half - 1] = z[half - 1] + x;
  }
  const auto outward = [&](std::size_t j) {
    y = step[j] - ratio[j] * y;
    step[j] = y;
    moved[j] = z[j] + y;
  };
  for (std::size_t i = 2; i <= half; ++i) {
    const std::size_t k = half - i;
    x = step[k] - ratio[k] * x;
    step[k] = x;
    moved[k] = z[k] + x;
    outward(half + i - 1);
  }
  for (std::size_t j = std::max<std::size_t>(1, 2 * half); j < count; ++j) outward(j);

  Collector collector = front.collector;
  collector.take(back.collector);
  if (!periodic) return collector.misfit();

  // The border's column in the same way, as far as it has not died out.
  if (front.border_rows == half || back.border_rows == count - half) {
    if (front.border_rows < half) front.border = Number{};
    if (back.border_rows < count - half) back.border = Number{};
    std::fill(border + front.border_rows, border + (count - back.border_rows), Number{});
    front.border_rows = half;
    back.border_rows = count - half;
    border[half] = half > 0 ? (back.border - back.ratio * front.border) * inverse : back.border;
    if (half > 0) border[half - 1] = front.border - front.ratio * border[half];
  }
  for (std::size_t k = front.border_rows; k-- > 0;) {
    if (k + 1 < front.border_rows) border[k] -= ratio[k] * border[k + 1];
  }
  const std::size_t back_begin = count - back.border_rows;
  for (std::size_t j = back_begin + 1; j < count; ++j) border[j] -= ratio[j] * border[j - 1];

  const Row bottom = rows.row(size - 1);
  collector.take(size - 1, bottom);
  const Number upper = problem_.closure * bottom.upper;
  const Number pivot = bottom.diagonal - bottom.lower * border[count - 1] - upper * border[0];
  const Number last =
      (-bottom.value - bottom.lower * step[count - 1] - upper * step[0]) * reciprocal(pivot);
  const auto correct = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      step[i] -= border[i] * last;
      moved[i] = z[i] + step[i];
    }
  };
  correct(0, front.border_rows);
  correct(back_begin, count);
  step[count] = last;
  moved[count] = z[count] + last;
  return collector.misfit();
}

void SplineSystem::pivoted_step(const std::vector<Number>& z) {
  std::vector<Number> right = values(z);
  for (Number& x : right) x = -x;
  pivoted_solve(z, right);
}

void SplineSystem::pivoted_solve(const std::vector<Number>& z, const std::vector<Number>& right) {
  const std::size_t size = z.size();
  const bool periodic = problem_.first == SplineEnd::periodic;
  const std::size_t count = periodic ? size - 1 : size;  // of tridiagonal rows
  // Per row: columns i, i + 1, i + 2, the right side, and the border's column.
  std::vector<WideRow> rows(count);
  WideRow next{};  // the row not yet exchanged, columns i, i + 1
  Row bottom{};
  Number next_lower{};
  const auto eliminate = [&](std::size_t i, WideRow& above, const Number& lower, WideRow& below) {
    // `above` holds columns i - 1, i, i + 1; `below` columns i, i + 1 and `lower` in column i - 1.
    WideRow shifted{lower, below[0], below[1], below[3], below[4]};
    if (squared(shifted[0]) > squared(above[0])) std::swap(shifted, above);
    const Number factor = squared(above[0]) > 0.0 ? shifted[0] * reciprocal(above[0]) : Number{};
    below = {shifted[1] - factor * above[1], shifted[2] - factor * above[2], Number{},
             shifted[3] - factor * above[3], shifted[4] - factor * above[4]};
    rows[i - 1] = above;
  };
  for_each_row(problem_, z, [&](std::size_t i, const Row& row) {
    if (i == count) {
      bottom = row;
      return;
    }
    WideRow wide{row.diagonal, i + 1 < count ? row.upper : Number{}, Number{}, right[i], Number{}};
    if (periodic && i == 0) wide[4] += problem_.closure * row.lower;
    if (periodic && i + 1 == count) wide[4] += row.upper;
    next_lower = row.lower;
    if (i > 0) {
      // `next` is the reduced row i - 1 in columns i - 1, i (and i + 1 after an exchange).
      WideRow above{next[0], next[1], next[2], next[3], next[4]};
      eliminate(i, above, next_lower, wide);
    }
    next = wide;
  });
  rows[count - 1] = next;
  std::vector<Number> column(periodic ? count : 0);
  for (std::size_t i = count; i-- > 0;) {
    const Number inverse = reciprocal(rows[i][0]);
    const auto back = [&](std::size_t entry, const std::vector<Number>& found) {
      Number x = rows[i][entry];
      if (i + 1 < count) x -= rows[i][1] * found[i + 1];
      if (i + 2 < count) x -= rows[i][2] * found[i + 2];
      return x * inverse;
    };
    step_[i] = back(3, step_);
    if (periodic) column[i] = back(4, column);
  }
  if (periodic) {
    const Number upper = problem_.closure * bottom.upper;
    const Number pivot = bottom.diagonal - bottom.lower * column[count - 1] - upper * column[0];
    const Number x =
        (right[count] - bottom.lower * step_[count - 1] - upper * step_[0]) * reciprocal(pivot);
    for (std::size_t i = 0; i < count; ++i) step_[i] -= column[i] * x;
    step_[count] = x;
  }
}

}  // namespace hodograph::planar_spline_detail
