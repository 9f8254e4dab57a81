// SPDX-License-Identifier: MIT
// The arithmetic of Hermite interpolation by spatial PH curves, without a branch: it runs on any
// scalar, lanes included. Whoever calls it has checked the data and judges the outcome.
//
// Notation: X ⋆ Y = vec(X i Y*); Q = cos + i sin acts on the right and rolls a preimage. The
// preimage is A = Ã + δ B_m^n: Ã, of degree N = 2m - 1, is the two-point Taylor interpolant of the
// end preimages, and δ is the one quaternion left to meet the end point.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/algebra/paired_quaternion.hpp"
#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/construction/detail/hermite_tables.hpp"
#include "hodograph/construction/hermite_data.hpp"
#include "hodograph/curve/detail/integrand_form.hpp"
#include "hodograph/curve/preimage_jet.hpp"

// The trip counts are small compile-time constants: unrolled, the tables become immediate operands.
#define HODOGRAPH_UNROLL _Pragma("GCC unroll 16")

namespace hodograph::hermite_detail {

template <class S, std::size_t m>
using EndJet = std::array<Quaternion<S>, m>;

/// A quaternion X with X i X* = v: the pure one half-way between i and v where v_x ≥ 0, and the one
/// from -i, times j, where v_x < 0, so that no direction is ill conditioned. Domain: v ≠ 0.
template <class S>
Quaternion<S> fibre(const Vector3<S>& v) {
  using std::abs;
  using std::sqrt;
  const S speed = sqrt(dot(v, v));
  // With c = (|v| + |v_x|)/2: (0, √c, v_y/(2√c), v_z/(2√c)); for v_x < 0 the same for (-v_x, ...),
  // negated in i and multiplied by j on the right.
  const S root = sqrt(S(0.5) * (speed + abs(v.x)));
  const S scale = S(0.5) / root;
  const S y = scale * v.y, z = scale * v.z;
  const auto backward = v.x < S(0);
  // (0, -root, y, z) j = (-y, -z, 0, -root).
  return {select(backward, -y, S(0)), select(backward, -z, root), select(backward, S(0), y),
          select(backward, -root, z)};
}

/// X with X ⋆ B = a and <X, B i> = t (Lemma 1 of PHODCOS with τ = -t): X = (t - a) B i/|B|².
template <class S>
Quaternion<S> solve_linear(const Vector3<S>& a, const Quaternion<S>& b, const S& reciprocal_norm,
                           const S& t) {
  const Quaternion<S> numerator = Quaternion<S>{t, -a.x, -a.y, -a.z} * times_i(b);
  return reciprocal_norm * numerator;
}

/// A, A', ..., A^(m-1) at an end from r', ..., r^(m) there, with <A^(r), A i> = twist(jet, r) for
/// r = 1, ..., m - 1; twist sees the derivatives below r. Source: the r-th derivative of
/// r' = A ⋆ A is 2 A ⋆ A^(r) plus known terms.
template <std::size_t m, class S, class Twist>
EndJet<S, m> end_jet(const Vector3<S>* derivatives, const Twist& twist) {
  EndJet<S, m> jet{};
  jet[0] = fibre(derivatives[0]);
  const S reciprocal_norm = S(1) / dot(jet[0], jet[0]);
  HODOGRAPH_UNROLL
  for (std::size_t r = 1; r < m; ++r) {
    Vector3<S> a = derivatives[r];
    HODOGRAPH_UNROLL
    for (std::size_t j = 1; 2 * j <= r; ++j) {
      const auto pairs = static_cast<double>((2 * j == r ? 1 : 2) * binomial(r, j));
      a = a - S(pairs) * hodograph_form(jet[j], jet[r - j]);
    }
    jet[r] = solve_linear(S(0.5) * a, jet[0], reciprocal_norm, twist(jet, r));
  }
  return jet;
}

/// The rule of order_ten: every derivative of the twist <A', A i> that the data reach vanishes.
struct RotationMinimising {
  template <class S, std::size_t m>
  S operator()(const EndJet<S, m>& jet, std::size_t r) const {
    // d^k/dξ^k <A', A i> = Σ_j (C(k,j) - C(k,j-1)) <A^(r-j), A^(j) i>, k = r - 1.
    S twist(0);
    HODOGRAPH_UNROLL
    for (std::size_t j = 1; 2 * j < r; ++j) {
      const auto weight = static_cast<double>(binomial(r - 1, j) - binomial(r - 1, j - 1));
      twist = twist - S(weight) * twist_form(jet[j], jet[r - j]);
    }
    return twist;
  }
};

/// The rule of order_six: every τ is zero.
struct ZeroTau {
  template <class S, std::size_t m>
  S operator()(const EndJet<S, m>&, std::size_t) const {
    return S(0);
  }
};

/// The quaternions of the segment's own arithmetic, and a row of them: a jet, or the coefficients
/// of one half counted from their end.
template <class S>
using Paired = PairedQuaternion<pair_of_t<S>>;
template <class S, std::size_t m>
using Row = std::array<Paired<S>, m>;

/// The jet with its derivative j times h^j; h is negative at the far end, where coefficients count
/// from the end.
template <class S, std::size_t m>
Row<S, m> scaled_jet(const EndJet<S, m>& jet, const S& h) {
  Row<S, m> result;
  result[0] = Paired<S>(jet[0]);
  S power = h;
  HODOGRAPH_UNROLL
  for (std::size_t j = 1; j < m; ++j) {
    result[j] = power * Paired<S>(jet[j]);
    power = power * h;
  }
  return result;
}

/// Coefficient i of degree N or n of the polynomial with the given scaled jet.
template <class S, std::size_t m>
Row<S, m> end_coefficients(const Row<S, m>& scaled, const Matrix<real_of_t<S>, m>& weights) {
  Row<S, m> result;
  HODOGRAPH_UNROLL
  for (std::size_t i = 0; i < m; ++i) {
    result[i] = scaled[0];
    HODOGRAPH_UNROLL
    for (std::size_t j = 1; j <= i; ++j) result[i] = result[i] + S(weights[i][j]) * scaled[j];
  }
  return result;
}

template <class S, std::size_t m>
Row<S, m> rolled(Row<S, m> row, const Roll<S>& roll) {
  HODOGRAPH_UNROLL
  for (std::size_t i = 0; i < m; ++i) row[i] = row[i] * roll;
  return row;
}

/// Σ x_i row_i of constants x, from `first` on.
template <class S, std::size_t m>
Paired<S> combination(const std::array<real_of_t<S>, m>& x, const Row<S, m>& row,
                      std::size_t first = 0) {
  Paired<S> sum = S(x[first]) * row[first];
  HODOGRAPH_UNROLL
  for (std::size_t i = first + 1; i < m; ++i) sum = sum + S(x[i]) * row[i];
  return sum;
}

/// Ã in its two halves: the coefficients of degree N from the start, and from the end backwards,
/// with their moments ∫ ... B_m^n.
template <class S, std::size_t m>
struct Halves {
  Row<S, m> start, end;
  Paired<S> start_moment = combination<S, m>(tables<S, m>().moment, start);
  Paired<S> end_moment = combination<S, m>(tables<S, m>().moment, end);

  /// The same with the end half rolled.
  Halves end_rolled(const Roll<S>& roll) const {
    return {start, rolled<S, m>(end, roll), start_moment, end_moment * roll};
  }
};

/// ∫ <F', F i> of one half F alone, before the components are summed.
template <class S, std::size_t m>
Paired<S> own_twist(const Row<S, m>& half) {
  const auto& t = tables<S, m>();
  // Σ_{i<j} self_ij <f_j i, f_i>
  auto sum = componentwise(combination<S, m>(t.self[0], half, 1).swapped(), half[0]);
  HODOGRAPH_UNROLL
  for (std::size_t i = 1; i + 1 < m; ++i) {
    sum = sum + componentwise(combination<S, m>(t.self[i], half, i + 1).swapped(), half[i]);
  }
  return sum;
}

/// The roll that turns the end half so that the mean twist ∫ <Ã', Ã i> vanishes (beyond the papers:
/// the choice of order ten). excess is how far |c| exceeds what a roll can balance, over that;
/// not positive when the mean twist vanishes.
template <class S>
struct TwistFreeRoll {
  Roll<S> roll;
  S excess;
};
template <class S, std::size_t m>
TwistFreeRoll<S> twist_free_roll(const Halves<S, m>& tilde) {
  using std::abs;
  using std::sqrt;
  const auto& t = tables<S, m>();
  // ∫<Ã', Ã i> = c + C cos θ - D sin θ with C = 2 ∫<S', E i>, D = 2 ∫<S', E>.
  S c(0);
  if constexpr (m > 1) {
    c = twist_sum(own_twist<S, m>(tilde.start) - own_twist<S, m>(tilde.end));
  }
  Paired<S> opposite = combination<S, m>(t.cross[0], tilde.end);
  Paired<S> cosine_products = componentwise(opposite.swapped(), tilde.start[0]);
  Paired<S> sine_products = componentwise(opposite, tilde.start[0]);
  HODOGRAPH_UNROLL
  for (std::size_t i = 1; i < m; ++i) {
    opposite = combination<S, m>(t.cross[i], tilde.end);
    cosine_products = cosine_products + componentwise(opposite.swapped(), tilde.start[i]);
    sine_products = sine_products + componentwise(opposite, tilde.start[i]);
  }
  const S cosine_part = S(2) * twist_sum(cosine_products);
  const S sine_part = S(2) * dot_sum(sine_products);
  const S size = sqrt(cosine_part * cosine_part + sine_part * sine_part);
  // C cos θ - D sin θ = size cos(θ + φ): cos(θ + φ) = -c/size, two roots.
  const auto vanishes = !(S(0) < size);
  const S reciprocal = S(1) / select(vanishes, S(1), size);
  const S ratio_c = -c * reciprocal;
  const S k = select(S(1) < ratio_c, S(1), select(ratio_c < S(-1), S(-1), ratio_c));
  const S root = sqrt(select(S(1) - k * k < S(0), S(0), S(1) - k * k));
  const S cosine = cosine_part * reciprocal, sine = sine_part * reciprocal;
  const Roll<S> first{k * cosine + root * sine, root * cosine - k * sine};
  const Roll<S> second{k * cosine - root * sine, -(root * cosine) - k * sine};
  // The roll that brings the moments closer: <start, end (x + y i)> = x <start, end> + ...
  const S along = dot_sum(componentwise(tilde.start_moment, tilde.end_moment));
  const S across = twist_sum(componentwise(tilde.end_moment.swapped(), tilde.start_moment));
  const auto prefer_second =
      first.cosine * along + first.sine * across < second.cosine * along + second.sine * across;
  const Roll<S> chosen{select(prefer_second, second.cosine, first.cosine),
                       select(prefer_second, second.sine, first.sine)};
  // One step back onto the circle: the rounding of cosine² + sine² - 1 is halved away.
  const S correction =
      S(1.5) - S(0.5) * (chosen.cosine * chosen.cosine + chosen.sine * chosen.sine);
  return {{select(vanishes, S(1), chosen.cosine * correction),
           select(vanishes, S(0), chosen.sine * correction)},
          abs(ratio_c) - S(1)};
}

/// The member of a fibre {X : X i X* = a} nearest to Y, up to its length: the orthogonal projection
/// (Y - â Y i)/2 onto the plane of the fibre. closeness is |projection|²/|Y|², in [0, 1]; 0 when a
/// is opposite to Y ⋆ Y and every member is equally near.
template <class S>
struct NearestInFibre {
  Paired<S> member;
  S closeness;
};
template <class S>
NearestInFibre<S> nearest_in_fibre(const Vector3<S>& a, const Paired<S>& y) {
  using std::sqrt;
  using P = pair_of_t<S>;
  const S size = sqrt(dot(a, a));
  const Vector3<S> direction = (S(1) / size) * a;
  const auto project = [&](const Paired<S>& q) {  // (q - direction q i)/2
    const P x = P::both(direction.x), y_part = P::both(direction.y), z = P::both(direction.z);
    const P front = P::minus_plus(x * q.front + y_part * q.back.swapped(), z * q.back);
    const P back = P::minus_plus(y_part * q.front.swapped() - x * q.back, z * q.front);
    return S(0.5) * (q + Paired<S>(front, back));
  };
  Paired<S> projected = project(y);
  const S length = dot_sum(componentwise(projected, projected));
  // A second projection removes what cancellation in the first left outside the plane.
  projected = project(projected);
  const S scale = sqrt(size / dot_sum(componentwise(projected, projected)));
  return {scale * projected, length / dot_sum(componentwise(y, y))};
}

/// ∫ Ã ⋆ Ã, as 2m squares.
template <class S, std::size_t m>
Vector3<S> integral_of_square(const Halves<S, m>& tilde) {
  const auto& t = tables<S, m>();
  Row<S, m> sums, differences;
  HODOGRAPH_UNROLL
  for (std::size_t i = 0; i < m; ++i) {
    sums[i] = tilde.start[i] + tilde.end[i];
    differences[i] = tilde.start[i] - tilde.end[i];
  }
  // Row k of the factors begins with a one at place k.
  const auto square = [](const std::array<real_of_t<S>, m>& x, const Row<S, m>& row,
                         std::size_t k) {
    Paired<S> sum = row[k];
    HODOGRAPH_UNROLL
    for (std::size_t j = k + 1; j < m; ++j) sum = sum + S(x[j]) * row[j];
    return curve_detail::integrand_square(sum);
  };
  curve_detail::QuaternionIntegrand<pair_of_t<S>> integral;
  HODOGRAPH_UNROLL
  for (std::size_t k = 0; k < m; ++k) {
    integral =
        integral + (S(t.sum_weights[k]) * square(t.sum_rows[k], sums, k) +
                    S(t.difference_weights[k]) * square(t.difference_rows[k], differences, k));
  }
  return integral.value().value().displacement;
}

/// The middle quaternion δ of A = Ã + δ B_m^n that makes ∫ A ⋆ A = mean_velocity: complete the
/// square in A_p = ∫ A B_m^n and take the member of its fibre nearest to `reference`, or to
/// Ã_p = ∫ Ã B_m^n where there is none.
template <class S>
struct MiddleCoefficient {
  Paired<S> delta;
  S closeness;
};
template <class S, std::size_t m>
MiddleCoefficient<S> middle_coefficient(const Halves<S, m>& tilde, const Vector3<S>& mean_velocity,
                                        const Paired<S>* reference) {
  const Paired<S> moment = tilde.start_moment + tilde.end_moment;
  const S gram(tables<S, m>().middle());
  const Vector3<S> target = gram * (mean_velocity - integral_of_square(tilde)) +
                            curve_detail::integrand_square(moment).value().value().displacement;
  const auto nearest = nearest_in_fibre(target, reference ? *reference : moment);
  return {(S(1) / gram) * (nearest.member - moment), nearest.closeness};
}

/// A segment: its preimage in global scaling, the roll Q of its end against the shared jet there,
/// and how well conditioned the choice was.
template <class S, std::size_t m>
struct Segment {
  BernsteinPolynomial<Quaternion<S>, 2 * m> preimage;
  Roll<S> roll;
  S excess, closeness;
};

/// Puts the segment together from its scaled end jets, the roll of its end and δ.
template <class S, std::size_t m>
BernsteinPolynomial<Quaternion<S>, 2 * m> assemble(const Row<S, m>& start, const Row<S, m>& end,
                                                   const Roll<S>& roll, const Halves<S, m>& tilde,
                                                   const Paired<S>& delta) {
  const auto& t = tables<S, m>();
  BernsteinPolynomial<Quaternion<S>, 2 * m> preimage;
  const Row<S, m> head = end_coefficients<S, m>(start, t.high);
  const Row<S, m> tail = rolled<S, m>(end_coefficients<S, m>(end, t.high), roll);
  HODOGRAPH_UNROLL
  for (std::size_t i = 0; i < m; ++i) {
    preimage[i] = head[i].value();
    preimage[2 * m - i] = tail[i].value();
  }
  preimage[m] = (S(0.5) * (tilde.start[m - 1] + tilde.end[m - 1]) + delta).value();
  return preimage;
}

/// The segment of order_ten from the jets at its ends (RotationMinimising), the step h and the
/// mean velocity Δp/h.
template <class S, std::size_t m>
Segment<S, m> twist_free_segment(const EndJet<S, m>& start, const EndJet<S, m>& end, const S& h,
                                 const Vector3<S>& mean_velocity) {
  const auto& t = tables<S, m>();
  const Row<S, m> head = scaled_jet<S, m>(start, h), tail = scaled_jet<S, m>(end, -h);
  const Halves<S, m> unrolled{end_coefficients<S, m>(head, t.low),
                              end_coefficients<S, m>(tail, t.low)};
  const auto twist_free = twist_free_roll<S, m>(unrolled);
  const Halves<S, m> tilde = unrolled.end_rolled(twist_free.roll);
  const auto middle = middle_coefficient<S, m>(tilde, mean_velocity, nullptr);
  return {assemble<S, m>(head, tail, twist_free.roll, tilde, middle.delta), twist_free.roll,
          twist_free.excess, middle.closeness};
}

/// The roll Q that takes the member X of a fibre to the one nearest to Y: the projection of Y on
/// X and X i.
template <class S>
Roll<S> roll_towards(const Quaternion<S>& x, const Quaternion<S>& y) {
  using std::sqrt;
  const S c = dot(x, y), s = dot(times_i(x), y);
  const S size = sqrt(c * c + s * s);
  return {c / size, s / size};
}

/// The segment with the fibres of A_0, A_n and A_p nearest to one reference quaternion U, U i U*
/// along the reference direction of the standard form, each then turned by its own angle.
template <class S, std::size_t m>
Segment<S, m> reference_segment(const EndJet<S, m>& start, const EndJet<S, m>& end, const S& h,
                                const Vector3<S>& mean_velocity, const Quaternion<S>& reference,
                                const Roll<S>& turn_start, const Roll<S>& turn_middle,
                                const Roll<S>& turn_end) {
  const auto compose = [](const Roll<S>& a, const Roll<S>& b) {
    return Roll<S>{a.cosine * b.cosine - a.sine * b.sine, a.cosine * b.sine + a.sine * b.cosine};
  };
  const auto inverse = [](const Roll<S>& a) { return Roll<S>{a.cosine, -a.sine}; };
  // Everything is turned back by the start's own roll, so that the start jet stays as it is.
  const Roll<S> back = inverse(compose(roll_towards(start[0], reference), turn_start));
  const Roll<S> roll = compose(compose(roll_towards(end[0], reference), turn_end), back);
  const auto& t = tables<S, m>();
  const Row<S, m> head = scaled_jet<S, m>(start, h), tail = scaled_jet<S, m>(end, -h);
  const auto tilde =
      Halves<S, m>{end_coefficients<S, m>(head, t.low), end_coefficients<S, m>(tail, t.low)}
          .end_rolled(roll);
  const Paired<S> middle_reference(reference * compose(turn_middle, back));
  const auto middle = middle_coefficient<S, m>(tilde, mean_velocity, &middle_reference);
  return {assemble<S, m>(head, tail, roll, tilde, middle.delta), roll, S(-1), middle.closeness};
}

}  // namespace hodograph::hermite_detail

#undef HODOGRAPH_UNROLL
