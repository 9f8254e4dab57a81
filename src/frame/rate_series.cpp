// SPDX-License-Identifier: MIT
#include "rate_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <utility>
#include <vector>

namespace hodograph::frame_detail {
namespace {

/// What the series need for polynomials of one degree, [coefficient][...]: Bernstein coefficients
/// on [0, 1] to Chebyshev coefficients in x = 2u - 1, and to values at the nodes.
template <std::size_t nodes>
struct Tables {
  std::size_t size;
  std::vector<double> chebyshev, values;
  double error;  ///< of an entry

  explicit Tables(std::size_t degree)
      : size(degree + 1), chebyshev(size * size), values(size * nodes) {
    using Wide = long double;
    const Wide pi = std::numbers::pi_v<Wide>;
    std::vector<Wide> bernstein(size), entries(size * size, Wide(0));
    const auto fill = [&](Wide half_cosine) {
      const Wide u = half_cosine * half_cosine;
      bernstein.assign(size, Wide(0));
      bernstein[0] = Wide(1);
      for (std::size_t m = 1; m < size; ++m) {
        for (std::size_t i = m; i > 0; --i) {
          bernstein[i] = u * bernstein[i - 1] + (Wide(1) - u) * bernstein[i];
        }
        bernstein[0] *= Wide(1) - u;
      }
    };
    for (std::size_t j = 0; j < size; ++j) {
      const Wide angle = pi * (static_cast<Wide>(j) + Wide(0.5)) / static_cast<Wide>(size);
      fill(std::cos(angle / 2));
      for (std::size_t k = 0; k < size; ++k) {
        const Wide weight = (k == 0 ? Wide(1) : Wide(2)) * std::cos(static_cast<Wide>(k) * angle) /
                            static_cast<Wide>(size);
        for (std::size_t i = 0; i < size; ++i) entries[i * size + k] += weight * bernstein[i];
      }
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      chebyshev[i] = static_cast<double>(entries[i]);
    }
    for (std::size_t j = 0; j < nodes; ++j) {
      fill(std::cos(pi * (static_cast<Wide>(j) + Wide(0.5)) / static_cast<Wide>(2 * nodes)));
      for (std::size_t i = 0; i < size; ++i) {
        values[i * nodes + j] = static_cast<double>(bernstein[i]);
      }
    }
    // An entry is a mean of `size` products of numbers up to 2: its error is below this many
    // roundings of the wide type, and rounding it to double takes half an ulp of at most 2.
    error = 8.0 * static_cast<double>(size + 4) *
                static_cast<double>(std::numeric_limits<Wide>::epsilon()) +
            std::numeric_limits<double>::epsilon();
  }
};

constexpr std::size_t most_degree = 128;

template <std::size_t nodes>
const Tables<nodes>& tables(std::size_t degree) {
  static std::array<std::once_flag, most_degree + 1> made;
  static std::array<std::unique_ptr<const Tables<nodes>>, most_degree + 1> store;
  std::call_once(made[degree],
                 [degree] { store[degree] = std::make_unique<Tables<nodes>>(degree); });
  return *store[degree];
}

/// The interpolant's Chebyshev coefficients from the sums and differences of the values at x and
/// -x: [j][k], for even coefficients 2k and odd ones 2k + 1.
template <std::size_t nodes>
struct Transform {
  static_assert(nodes % 2 == 0);
  static constexpr std::size_t half_nodes = nodes / 2;
  std::array<std::array<double, half_nodes>, half_nodes> even{}, odd{};
  Transform() {
    for (std::size_t j = 0; j < half_nodes; ++j) {
      const double angle =
          std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(nodes);
      for (std::size_t k = 0; k < half_nodes; ++k) {
        const double weight = 2.0 / static_cast<double>(nodes);
        even[j][k] = (k == 0 ? 0.5 : 1.0) * weight * std::cos(static_cast<double>(2 * k) * angle);
        odd[j][k] = weight * std::cos(static_cast<double>(2 * k + 1) * angle);
      }
    }
  }
};

template <std::size_t nodes>
std::array<double, nodes> interpolant(const std::array<double, nodes>& sample) {
  static const Transform<nodes> transform;
  constexpr std::size_t half_nodes = nodes / 2;
  std::array<double, half_nodes> even{}, odd{};
  for (std::size_t j = 0; j < half_nodes; ++j) {
    const double sum = sample[j] + sample[nodes - 1 - j];
    const double difference = sample[j] - sample[nodes - 1 - j];
    for (std::size_t k = 0; k < half_nodes; ++k) {
      even[k] += sum * transform.even[j][k];
      odd[k] += difference * transform.odd[j][k];
    }
  }
  std::array<double, nodes> c{};
  for (std::size_t k = 0; k < half_nodes; ++k) {
    c[2 * k] = even[k];
    c[2 * k + 1] = odd[k];
  }
  return c;
}

template <class S, std::size_t nodes>
void chebyshev_coefficients(const Tables<nodes>& t, const S* bernstein, S* result) {
  for (std::size_t k = 0; k < t.size; ++k) result[k] = S(0.0);
  for (std::size_t i = 0; i < t.size; ++i) {
    const double* row = &t.chebyshev[i * t.size];
    for (std::size_t k = 0; k < t.size; ++k) {
      result[k] = result[k] + about<S>(row[k], t.error) * bernstein[i];
    }
  }
}

template <class S, std::size_t nodes>
std::array<double, nodes> values_at_nodes(const Tables<nodes>& t, const S* bernstein) {
  std::array<double, nodes> result{};
  for (std::size_t i = 0; i < t.size; ++i) {
    const double c = middle(bernstein[i]);
    const double* row = &t.values[i * nodes];
    for (std::size_t j = 0; j < nodes; ++j) result[j] += c * row[j];
  }
  return result;
}

template <class S, std::size_t nodes>
class Expansion {
 public:
  Expansion(const Fraction<S>& fraction, const std::function<bool(const RateSeries&)>& take,
            double tolerance)
      : tolerance_(std::max(tolerance, negligible)),
        top_(tables<nodes>(fraction.numerator.size() - 1)),
        bottom_(tables<nodes>(fraction.denominator.size() - 1)),
        take_(take),
        rows_((deepest + 2) * (top_.size + bottom_.size)),
        p_(top_.size),
        q_(bottom_.size),
        backwards_(bottom_.size),
        sums_(nodes + bottom_.size - 1),
        differences_(nodes + bottom_.size - 1),
        residual_(std::max(top_.size, nodes + bottom_.size - 1)) {
    if constexpr (std::same_as<S, double>) {
      for (const double c : fraction.denominator) floor_ = std::max(floor_, std::abs(c));
      floor_ *= 8.0 * epsilon<double>();
    }
    std::copy(fraction.numerator.begin(), fraction.numerator.end(), numerator(0));
    std::copy(fraction.denominator.begin(), fraction.denominator.end(), denominator(0));
  }

  bool run() { return piece(0.0, 1.0, 0); }

 private:
  /// A piece this deep (2^-40 long) is taken as it is: its error counts by its length.
  static constexpr std::size_t deepest = 40;
  static constexpr std::size_t most_pieces = 16384;

  S* numerator(std::size_t depth) { return &rows_[depth * (top_.size + bottom_.size)]; }
  S* denominator(std::size_t depth) { return numerator(depth) + top_.size; }

  /// Takes the polynomials at this depth; what is there afterwards does not matter.
  bool piece(double begin, double end, std::size_t depth) {
    const bool last = depth == deepest || ++pieces_ >= most_pieces;
    RateSeries series;
    series.begin = begin;
    series.end = end;
    if (expanded(series, numerator(depth), denominator(depth), last)) {
      if (take_(series) || last) return true;
    }
    if (last) return false;
    // The left half goes one deeper, the right half stays until its turn.
    split(numerator(depth), numerator(depth + 1), top_.size);
    split(denominator(depth), denominator(depth + 1), bottom_.size);
    const double half = 0.5 * (begin + end);
    if (!piece(begin, half, depth + 1)) return false;
    std::copy(numerator(depth), numerator(depth) + top_.size + bottom_.size, numerator(depth + 1));
    return piece(half, end, depth + 1);
  }

  static void split(S* f, S* left, std::size_t size) {
    const S half(0.5);
    for (std::size_t r = size; r > 0; --r) {
      left[size - r] = f[0];
      for (std::size_t i = 0; i + 1 < r; ++i) f[i] = half * (f[i] + f[i + 1]);
    }
  }

  bool expanded(RateSeries& series, const S* numerator, const S* denominator, bool last) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bottom_.size; ++i) least = std::min(least, lower(denominator[i]));
    if (!(least > floor_)) return false;
    auto sample = values_at_nodes(top_, numerator);
    const auto below = values_at_nodes(bottom_, denominator);
    for (std::size_t j = 0; j < nodes; ++j) sample[j] /= below[j];
    const std::array<double, nodes> c = interpolant(sample);
    std::copy(c.begin(), c.end(), series.c.begin());
    double series_size = 0.0;
    for (const double x : c) series_size += std::abs(x);
    const double terms = static_cast<double>(2 * (nodes + bottom_.size) + 8);
    // The last coefficients tell a series that has not converged.
    if (!last &&
        !(std::abs(c[nodes - 1]) + std::abs(c[nodes - 2]) <=
          16.0 * terms * epsilon<double>() * series_size) &&
        (series.end - series.begin) * series_size > negligible &&
        std::abs(c[nodes - 1]) + std::abs(c[nodes - 2]) > tolerance_) {
      return false;
    }

    chebyshev_coefficients(bottom_, denominator, q_.data());
    double numerator_size = 0.0, denominator_size = 0.0;
    for (std::size_t i = 0; i < top_.size; ++i) {
      numerator_size = std::max(numerator_size, magnitude(numerator[i]));
    }
    for (const S& x : q_) denominator_size += magnitude(x);
    const double rounding =
        terms * epsilon<double>() * (series_size * denominator_size + numerator_size);
    double found = 0.0, improvable = 0.0;
    if (std::same_as<S, double> && bottom_.size <= 2 * nodes && top_.size <= nodes) {
      improvable = remainder(c);
      found = improvable + rounding + floor_ * series_size;
    } else {
      chebyshev_coefficients(top_, numerator, p_.data());
      residual(c);
      for (const S& x : residual_) {
        found += magnitude(x);
        improvable += std::abs(middle(x));  // shorter pieces do not make enclosures narrower
      }
      if constexpr (std::same_as<S, double>) found += rounding + floor_ * series_size;
    }
    constexpr double margin = 1.0 + 64.0 * std::numeric_limits<double>::epsilon();
    series.error = margin * found / least;
    if (!std::isfinite(series.error)) return false;
    return last || improvable <= rounding ||
           (series.end - series.begin) * series.error <= negligible || series.error <= tolerance_;
  }

  /// A bound of |P - p Q| where deg P < N and deg Q < 2N, N the number of nodes. At the nodes, the
  /// zeros of T_N, p is P/Q: so P - p Q = T_N Σ_{j<2N} s_j T_j, |P - p Q| ≤ Σ |s_j|. Since
  /// T_N T_j = (T_(N+j) + T_|N-j|)/2, its coefficients of T_N and T_(N+j) are s_0 and s_j/2; only
  /// p Q has such, from T_i T_l = (T_(i+l) + T_|i-l|)/2.
  double remainder(const std::array<double, nodes>& c) const {
    double total = 0.0;
    for (std::size_t k = nodes; k < nodes + bottom_.size - 1; ++k) {
      double twice = 0.0;
      for (std::size_t l = k + 1 - nodes; l < bottom_.size && l <= k; ++l) {
        twice += c[k - l] * middle(q_[l]);
      }
      for (std::size_t l = k; l < bottom_.size; ++l) twice += c[l - k] * middle(q_[l]);
      total += (k == nodes ? 0.5 : 1.0) * std::abs(twice);
    }
    return total;
  }

  /// P - p Q in Chebyshev form.
  void residual(const std::array<double, nodes>& c) {
    // 2 T_i T_j = T_(i+j) + T_|i-j|: sums at i + j, and, with q backwards, at i - j + bottom.
    const std::size_t bottom = bottom_.size - 1;
    std::reverse_copy(q_.begin(), q_.end(), backwards_.begin());
    std::fill(sums_.begin(), sums_.end(), S(0.0));
    std::fill(differences_.begin(), differences_.end(), S(0.0));
    for (std::size_t i = 0; i < nodes; ++i) {
      const S half(0.5 * c[i]);
      S* sum = &sums_[i];
      S* difference = &differences_[i];
      for (std::size_t j = 0; j <= bottom; ++j) {
        sum[j] = sum[j] + half * q_[j];
        difference[j] = difference[j] + half * backwards_[j];
      }
    }
    std::fill(residual_.begin(), residual_.end(), S(0.0));
    for (std::size_t k = 0; k < top_.size; ++k) residual_[k] = p_[k];
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      residual_[k] = residual_[k] - sums_[k];
      const std::size_t folded = k < bottom ? bottom - k : k - bottom;
      residual_[folded] = residual_[folded] - differences_[k];
    }
  }

  /// Of a radian.
  static constexpr double negligible = std::numeric_limits<double>::epsilon() / 16.0;

  /// Eight roundings of the largest coefficient of a denominator in doubles, which its coefficients
  /// may be off: below, nothing is known of its sign.
  double floor_ = 0.0;
  double tolerance_;
  const Tables<nodes>& top_;
  const Tables<nodes>& bottom_;
  const std::function<bool(const RateSeries&)>& take_;
  std::vector<S> rows_, p_, q_, backwards_, sums_, differences_, residual_;
  std::size_t pieces_ = 0;
};

/// ∫_{-1}^{1} T_k, k even.
double moment(std::size_t k) {
  const auto even = static_cast<double>(k);
  return 2.0 / (1.0 - even * even);
}

}  // namespace

double integral(const RateSeries& piece) {
  double total = 0.0;
  for (std::size_t k = series_degree - 1; k >= 2; k -= 2) total += piece.c[k] * moment(k);
  return 0.5 * (piece.end - piece.begin) * (total + 2.0 * piece.c[0]);
}

Enclosure enclosed_integral(const RateSeries& piece) {
  Enclosure total(0.0);
  for (std::size_t k = 0; k <= series_degree; k += 2) {
    const auto even = static_cast<double>(k);
    total = total + Enclosure(piece.c[k]) * (Enclosure(2.0) / Enclosure(1.0 - even * even));
  }
  const Enclosure error(-piece.error, piece.error);
  return (Enclosure(piece.end) - Enclosure(piece.begin)) * (Enclosure(0.5) * total + error);
}

bool expand(const Fraction<double>& fraction, const std::function<bool(const RateSeries&)>& take,
            double tolerance) {
  constexpr std::size_t few = short_series_degree + 1;
  // Where the remainder has a short form; longer polynomials gain nothing.
  if (tolerance >= short_series_tolerance && fraction.numerator.size() <= few &&
      fraction.denominator.size() <= 2 * few) {
    return Expansion<double, few>(fraction, take, tolerance).run();
  }
  return Expansion<double, series_degree + 1>(fraction, take, tolerance).run();
}
bool expand(const Fraction<Enclosure>& fraction,
            const std::function<bool(const RateSeries&)>& take) {
  return Expansion<Enclosure, series_degree + 1>(fraction, take, 0.0).run();
}

}  // namespace hodograph::frame_detail
