// SPDX-License-Identifier: MIT
#include "rate_series.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace hodograph::frame_detail {
namespace {

constexpr std::size_t nodes = series_degree + 1;

/// cos(π k (j + 1/2)/nodes) at [k][j].
const std::array<std::array<double, nodes>, nodes>& cosines() {
  static const auto table = [] {
    std::array<std::array<double, nodes>, nodes> result{};
    for (std::size_t k = 0; k < nodes; ++k) {
      for (std::size_t j = 0; j < nodes; ++j) {
        result[k][j] = std::cos(std::numbers::pi * static_cast<double>(k) *
                                (static_cast<double>(j) + 0.5) / static_cast<double>(nodes));
      }
    }
    return result;
  }();
  return table;
}

/// From Bernstein coefficients on [0, 1] to Chebyshev coefficients in x = 2u - 1.
template <class S>
class ChebyshevBasis {
 public:
  explicit ChebyshevBasis(std::size_t degree) : size_(degree + 1), matrix_(size_ * size_) {
    using Wide = long double;
    const Wide pi = std::numbers::pi_v<Wide>;
    std::vector<Wide> bernstein(size_);
    std::vector<Wide> entries(size_ * size_, Wide(0));
    for (std::size_t j = 0; j < size_; ++j) {
      const Wide angle = pi * (static_cast<Wide>(j) + Wide(0.5)) / static_cast<Wide>(size_);
      const Wide half = std::cos(angle / 2), u = half * half;
      bernstein.assign(size_, Wide(0));
      bernstein[0] = Wide(1);
      for (std::size_t m = 1; m < size_; ++m) {
        for (std::size_t i = m; i > 0; --i) {
          bernstein[i] = u * bernstein[i - 1] + (Wide(1) - u) * bernstein[i];
        }
        bernstein[0] *= Wide(1) - u;
      }
      for (std::size_t k = 0; k < size_; ++k) {
        const Wide weight = (k == 0 ? Wide(1) : Wide(2)) * std::cos(static_cast<Wide>(k) * angle) /
                            static_cast<Wide>(size_);
        for (std::size_t i = 0; i < size_; ++i) entries[k * size_ + i] += weight * bernstein[i];
      }
    }
    // An entry is a mean of size_ products of numbers up to 2: its error is below this many
    // roundings of the wide type, and rounding it to double takes half an ulp of at most 2.
    const double error = 8.0 * static_cast<double>(size_ + 4) *
                             static_cast<double>(std::numeric_limits<Wide>::epsilon()) +
                         std::numeric_limits<double>::epsilon();
    for (std::size_t i = 0; i < entries.size(); ++i) {
      matrix_[i] = about<S>(static_cast<double>(entries[i]), error);
    }
  }
  Row<S> coefficients(const Row<S>& bernstein) const {
    Row<S> result(size_);
    for (std::size_t k = 0; k < size_; ++k) {
      S total(0.0);
      for (std::size_t i = 0; i < size_; ++i) total = total + matrix_[k * size_ + i] * bernstein[i];
      result[k] = total;
    }
    return result;
  }

 private:
  std::size_t size_;
  std::vector<S> matrix_;
};

template <class S>
double clenshaw(const Row<S>& c, double x) {
  double b = 0.0, before = 0.0;
  for (std::size_t k = c.size(); k-- > 1;) {
    const double next = middle(c[k]) + (2.0 * x) * b - before;
    before = b;
    b = next;
  }
  return middle(c[0]) + x * b - before;
}

template <class S>
double total_size(const Row<S>& c) {
  double total = 0.0;
  for (const S& x : c) total += magnitude(x);
  return total;
}

template <class S>
class Expansion {
 public:
  explicit Expansion(const Fraction<S>& fraction)
      : numerator_(fraction.numerator.size() - 1), denominator_(fraction.denominator.size() - 1) {}

  struct Attempt {
    RateSeries series;
    bool positive = false;  ///< the denominator, certainly
    bool accurate = false;
  };

  Attempt attempt(const Fraction<S>& f, double begin, double end) const {
    Attempt result;
    result.series.begin = begin;
    result.series.end = end;
    double least = std::numeric_limits<double>::infinity();
    for (const S& c : f.denominator) least = std::min(least, lower(c));
    result.positive = least > 0.0;
    if (!result.positive) return result;

    const Row<S> p = numerator_.coefficients(f.numerator);
    const Row<S> q = denominator_.coefficients(f.denominator);
    std::array<double, nodes> sample{};
    for (std::size_t j = 0; j < nodes; ++j) {
      const double x = cosines()[1][j];
      sample[j] = clenshaw(p, x) / clenshaw(q, x);
    }
    auto& c = result.series.c;
    for (std::size_t k = 0; k < nodes; ++k) {
      double total = 0.0;
      for (std::size_t j = 0; j < nodes; ++j) total += sample[j] * cosines()[k][j];
      c[k] = total * (k == 0 ? 1.0 : 2.0) / static_cast<double>(nodes);
    }

    // 2 T_i T_j = T_(i+j) + T_|i-j|.
    Row<S> residual(std::max(p.size(), nodes + q.size() - 1), S(0.0));
    for (std::size_t k = 0; k < p.size(); ++k) residual[k] = p[k];
    double series_size = 0.0;
    for (std::size_t i = 0; i < nodes; ++i) {
      series_size += std::abs(c[i]);
      const S half(0.5 * c[i]);
      for (std::size_t j = 0; j < q.size(); ++j) {
        const S term = half * q[j];
        residual[i + j] = residual[i + j] - term;
        residual[i > j ? i - j : j - i] = residual[i > j ? i - j : j - i] - term;
      }
    }
    constexpr bool rigorous = std::same_as<S, Enclosure>;
    const double terms = static_cast<double>(2 * (nodes + q.size()) + 8);
    const double rounding =
        terms * epsilon<double>() * (series_size * total_size(q) + total_size(p));
    const double found = total_size(residual);
    // What shorter pieces would make better: of enclosures, the middles.
    double improvable = 0.0;
    for (const S& x : residual) improvable += std::abs(middle(x));
    constexpr double margin = 1.0 + 64.0 * std::numeric_limits<double>::epsilon();
    result.series.error = margin * (rigorous ? found : found + rounding) / least;
    const double negligible = std::numeric_limits<double>::epsilon() / 16.0;
    result.accurate = std::isfinite(result.series.error) &&
                      (improvable <= rounding || (end - begin) * result.series.error <= negligible);
    return result;
  }

 private:
  ChebyshevBasis<S> numerator_, denominator_;
};

template <class S>
bool expand_all(const Fraction<S>& fraction, const std::function<bool(const RateSeries&)>& take) {
  struct Part {
    double begin, end;
    Fraction<S> fraction;
  };
  // A piece this short is taken as it is: its error counts by its length.
  constexpr double shortest = 0x1.0p-40;
  constexpr std::size_t most_pieces = 16384;
  const Expansion<S> expansion(fraction);
  std::vector<Part> stack;
  stack.push_back({0.0, 1.0, fraction});
  for (std::size_t pieces = 0; !stack.empty(); ++pieces) {
    Part part = std::move(stack.back());
    stack.pop_back();
    const auto attempt = expansion.attempt(part.fraction, part.begin, part.end);
    const bool last = part.end - part.begin <= shortest || pieces >= most_pieces;
    if (attempt.positive && std::isfinite(attempt.series.error) && (attempt.accurate || last) &&
        (take(attempt.series) || last)) {
      continue;
    }
    if (last) return false;
    const double half = 0.5 * (part.begin + part.end);
    auto numerators = halves(std::move(part.fraction.numerator));
    auto denominators = halves(std::move(part.fraction.denominator));
    stack.push_back(
        {half, part.end, {std::move(numerators.second), std::move(denominators.second)}});
    stack.push_back(
        {part.begin, half, {std::move(numerators.first), std::move(denominators.first)}});
  }
  return true;
}

/// ∫_{-1}^{1} T_k, k even.
double moment(std::size_t k) {
  const auto even = static_cast<double>(k);
  return 2.0 / (1.0 - even * even);
}

}  // namespace

double integral(const RateSeries& piece) {
  double total = 0.0;
  for (std::size_t k = nodes + nodes % 2; k >= 2; k -= 2) {
    if (k < nodes) total += piece.c[k] * moment(k);
  }
  return 0.5 * (piece.end - piece.begin) * (total + 2.0 * piece.c[0]);
}

Enclosure enclosed_integral(const RateSeries& piece) {
  Enclosure total(0.0);
  for (std::size_t k = 0; k < nodes; k += 2) {
    const auto even = static_cast<double>(k);
    total = total + Enclosure(piece.c[k]) * (Enclosure(2.0) / Enclosure(1.0 - even * even));
  }
  const Enclosure error(-piece.error, piece.error);
  return (Enclosure(piece.end) - Enclosure(piece.begin)) * (Enclosure(0.5) * total + error);
}

bool expand(const Fraction<double>& fraction, const std::function<bool(const RateSeries&)>& take) {
  return expand_all(fraction, take);
}
bool expand(const Fraction<Enclosure>& fraction,
            const std::function<bool(const RateSeries&)>& take) {
  return expand_all(fraction, take);
}

}  // namespace hodograph::frame_detail
