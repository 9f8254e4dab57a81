// SPDX-License-Identifier: MIT
// Best-first subdivision for the extremes of quotients of Bernstein polynomials.
#include "hodograph/bernstein/range.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "enclosure_row.hpp"

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

/// A piece this often halved is within an ulp of a point: splitting it further gains nothing.
constexpr int greatest_depth = 54;

/// A bound is all noise when its distance from a value that is attained is at most this many widths
/// of that value's enclosure: the width is the noise of the coefficients there.
constexpr double noise_factor = 2.0;

/// What is known of the values on a piece: all lie in `all`; those at its ends in `first` and
/// `last`.
struct Bounds {
  Enclosure all, first, last;
};

/// The rows of a quotient on a piece of [0, 1]: the components of v, then g.
class Piece {
 public:
  /// Scaled by powers of two so that products of coefficients neither overflow nor vanish.
  explicit Piece(const BernsteinQuotient& q) : dimension_(q.dimension()) {
    int exponent = 0;
    std::vector<Enclosure> all;
    for (std::size_t j = 0; j < dimension_; ++j) {
      all.insert(all.end(), q.row(j).begin(), q.row(j).end());
    }
    exponent = add(all, q.degree() + 1);
    if (q.has_denominator()) {
      const auto g = q.row(dimension_);
      exponent -= add(std::vector<Enclosure>(g.begin(), g.end()), q.degree() + 1);
    }
    exponent_ = exponent;
    factor_ = q.factor();
  }

  Bounds bounds(RangeMeasure measure) const {
    const std::size_t last = rows_[0].degree();
    Bounds bounds = measure == RangeMeasure::value
                        ? Bounds{value_bound(), value_at(0), value_at(last)}
                        : Bounds{norm_bound(), norm_at(0), norm_at(last)};
    for (Enclosure* e : {&bounds.all, &bounds.first, &bounds.last}) *e = finished(*e);
    if (measure == RangeMeasure::norm) {
      for (Enclosure* e : {&bounds.all, &bounds.first, &bounds.last}) {
        *e = {std::max(e->lower(), 0.0), e->upper()};
      }
    }
    return bounds;
  }

  /// Becomes the right half and returns the left.
  Piece split_off_left_half() {
    Piece left(*this, 0);
    for (EnclosureRow& row : rows_) left.rows_.push_back(row.split_off_left_half());
    return left;
  }

 private:
  Piece(const Piece& other, int)
      : dimension_(other.dimension_), exponent_(other.exponent_), factor_(other.factor_) {}

  /// Adds rows scaled to a largest size between 1/2 and 1, and returns the exponent taken out.
  int add(std::vector<Enclosure> all, std::size_t size) {
    bool bounded = true;
    for (const Enclosure& x : all) bounded = bounded && x.is_bounded();
    bounded_ = bounded_ && bounded;
    const int exponent = bounded ? largest_exponent(all) : 0;
    for (Enclosure& x : all) x = bounded ? scaled(x, -exponent) : Enclosure(0.0);
    for (std::size_t i = 0; i < all.size(); i += size) {
      rows_.push_back(EnclosureRow(std::span<const Enclosure>(all).subspan(i, size)));
    }
    return exponent;
  }

  bool has_denominator() const { return rows_.size() > dimension_; }
  bool denominator_is_positive(std::size_t i) const {
    return !has_denominator() || rows_.back().lower(i) > 0.0;
  }
  Enclosure over_denominator(const Enclosure& x, std::size_t i) const {
    return has_denominator() ? x / rows_.back()[i] : x;
  }

  Enclosure value_at(std::size_t i) const {
    return denominator_is_positive(i) ? over_denominator(rows_[0][i], i) : Enclosure::whole_line();
  }
  Enclosure norm_at(std::size_t i) const {
    if (!denominator_is_positive(i)) return {0.0, infinity};
    if (dimension_ == 1) return over_denominator(abs(rows_[0][i]), i);
    Enclosure sum(0.0);
    for (std::size_t j = 0; j < dimension_; ++j) sum += square(rows_[j][i]);
    return over_denominator(sqrt(sum), i);
  }

  Enclosure value_bound() const {
    Enclosure bound = value_at(0);
    for (std::size_t i = 1; i < rows_[0].size(); ++i) bound = Enclosure::hull(bound, value_at(i));
    return bound;
  }
  Enclosure norm_bound() const {
    double upper = 0.0;
    for (std::size_t i = 0; i < rows_[0].size(); ++i) upper = std::max(upper, norm_at(i).upper());
    // The direction of the middle coefficient serves for the lower bound.
    std::vector<double> d(dimension_);
    Enclosure length(0.0);
    const std::size_t middle = rows_[0].degree() / 2;
    double size = 0.0;
    for (std::size_t j = 0; j < dimension_; ++j) {
      d[j] = rows_[j][middle].middle();
      size = std::max(size, std::abs(d[j]));
    }
    if (!(size > 0.0)) return {0.0, upper};
    for (double& x : d) {
      x /= size;
      length += square(Enclosure(x));
    }
    length = sqrt(length);
    double lower = infinity;
    for (std::size_t i = 0; i < rows_[0].size() && lower > 0.0; ++i) {
      if (!denominator_is_positive(i)) return {0.0, upper};
      Enclosure along(0.0);
      for (std::size_t j = 0; j < dimension_; ++j) along += Enclosure(d[j]) * rows_[j][i];
      lower = std::min(lower, over_denominator(along, i).lower());
    }
    return {std::max(0.0, (Enclosure(std::min(lower, largest)) / length).lower()), upper};
  }

  /// A bound of the scaled quotient in terms of the quotient itself.
  Enclosure finished(const Enclosure& x) const {
    if (!bounded_) return Enclosure::whole_line();
    const auto end = [this](double value) {
      const Enclosure result = scaled(Enclosure(std::clamp(value, -largest, largest)), exponent_);
      return factor_ == Enclosure(1.0) ? result : result * factor_;
    };
    return {x.lower() == -infinity ? -infinity : end(x.lower()).lower(),
            x.upper() == infinity ? infinity : end(x.upper()).upper()};
  }

  std::size_t dimension_;
  int exponent_ = 0;
  bool bounded_ = true;
  Enclosure factor_;
  std::vector<EnclosureRow> rows_;
};

/// The search for a maximum; the minimum is the maximum of the negative.
class Search {
 public:
  using Source = std::function<BernsteinQuotient(std::size_t)>;

  Search(const Source& source, RangeMeasure measure, const RangeGoal& goal, bool negative)
      : source_(source), measure_(measure), goal_(goal), negative_(negative) {}

  /// Takes notice of a whole item, whose pieces are made again when it is split.
  void add(std::size_t item, const Bounds& bounds) { push({item, 0, false, 0.0, {}}, bounds); }

  Enclosure run() {
    for (std::size_t splits = 0; splits < goal_.subdivisions && !heap_.empty(); ++splits) {
      std::pop_heap(heap_.begin(), heap_.end());
      Candidate candidate = std::move(heap_.back());
      heap_.pop_back();
      const double gap = candidate.bound - attained_;
      const double size = std::max(std::abs(candidate.bound), std::abs(attained_));
      if (candidate.bound <= attained_ || candidate.final ||
          (gap <= goal_.relative_width * size && gap < infinity)) {
        return finished(candidate.bound);
      }
      std::vector<Piece> pieces = std::move(candidate.piece);
      if (pieces.empty()) pieces.push_back(Piece(source_(candidate.item)));
      Piece left = pieces[0].split_off_left_half();
      for (Piece* half : {&left, &pieces[0]}) {
        const Bounds bounds = half->bounds(measure_);
        push({candidate.item, candidate.depth + 1, false, candidate.bound, {}}, bounds, half);
      }
    }
    return finished(heap_.empty() ? attained_ : heap_.front().bound);
  }

 private:
  struct Candidate {
    std::size_t item;
    int depth;
    bool final;                ///< splitting it would gain nothing
    double bound;              ///< no value on the piece exceeds it
    std::vector<Piece> piece;  ///< none or one
    friend bool operator<(const Candidate& a, const Candidate& b) { return a.bound < b.bound; }
  };

  void push(Candidate candidate, const Bounds& bounds, Piece* piece = nullptr) {
    const double parent_bound = candidate.depth > 0 ? candidate.bound : infinity;
    const Enclosure first = oriented(bounds.first), last = oriented(bounds.last);
    attained_ = std::max(attained_, std::max(first.lower(), last.lower()));
    candidate.bound = std::min(parent_bound, oriented(bounds.all).upper());
    if (candidate.bound < attained_) return;
    const Enclosure& higher = first.upper() < last.upper() ? last : first;
    const double noise = higher.upper() - higher.lower();
    candidate.final =
        candidate.depth >= greatest_depth ||
        (candidate.bound < infinity && candidate.bound - higher.upper() <= noise_factor * noise);
    if (piece != nullptr && !candidate.final) candidate.piece.push_back(std::move(*piece));
    heap_.push_back(std::move(candidate));
    std::push_heap(heap_.begin(), heap_.end());
  }

  Enclosure oriented(const Enclosure& x) const { return negative_ ? -x : x; }
  Enclosure finished(double bound) const {
    return oriented(Enclosure(attained_, std::max(bound, attained_)));
  }

  const Source& source_;
  RangeMeasure measure_;
  RangeGoal goal_;
  bool negative_;
  double attained_ = -infinity;
  std::vector<Candidate> heap_;
};

}  // namespace

Extremes extremes(std::size_t count, const std::function<BernsteinQuotient(std::size_t)>& quotient,
                  RangeMeasure measure, const RangeGoal& goal) {
  Search largest_value(quotient, measure, goal, false),
      smallest_value(quotient, measure, goal, true);
  for (std::size_t item = 0; item < count; ++item) {
    const Bounds bounds = Piece(quotient(item)).bounds(measure);
    largest_value.add(item, bounds);
    smallest_value.add(item, bounds);
  }
  return {smallest_value.run(), largest_value.run()};
}

}  // namespace hodograph
