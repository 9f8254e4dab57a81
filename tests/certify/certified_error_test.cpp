// SPDX-License-Identifier: MIT
// Certified errors contain the true ones: on smooth curves, at rounding level, on awkward knots and
// against callables that have no certificate.
#include "hodograph/certify/certified_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/curves.hpp"
#include "tests/support/random.hpp"
#include "tests/support/true_error.hpp"

namespace hodograph {
namespace {

using test::Curve23;
using test::even_knots;
using test::fitted_path;
using test::Helix;
using test::Random;
using test::TorusKnot;
using test::true_segment_error;
using test::Viviani;
using test::Wide;

/// Uses every elementary function of Taylor arithmetic; analytic for ξ > -1/2.
struct Medley {
  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::atan;
    using std::atan2;
    using std::log;
    using std::sqrt;
    using std::tanh;
    const S shifted = xi + S(1);
    return {log(shifted) + tanh(xi), sqrt(shifted) * atan(xi),
            atan2(shifted, xi + S(2)) + S(1) / (shifted * shifted)};
  }
};

/// What a fit is judged by.
struct Judged {
  Enclosure error;
  Wide truth;
};

/// Certifies a path, and checks the bound of every segment (or of every `stride`th) against the
/// truth and against computed positions.
template <class Gamma, std::size_t n>
Judged judge(const Gamma& gamma, const SpatialPath<n>& path, int samples = 24,
             std::size_t stride = 1) {
  Random rng("certified error, computed positions");
  const std::vector<ErrorBound> errors = segment_errors(gamma, path);
  const ErrorBound total = certified_error(gamma, path);
  EXPECT_TRUE(total.certified);
  Wide largest(0);
  for (std::size_t k = 0; k < path.segment_count(); k += stride) {
    const double begin = path.knots()[k], end = path.knots()[k + 1];
    const Wide truth = true_segment_error(gamma, path.segment(k), begin, end, samples);
    EXPECT_TRUE(errors[k].certified);
    EXPECT_LE(truth, Wide(errors[k].error.upper())) << "segment " << k;
    // The witness: the distance at at_xi really is at least the lower end.
    const Wide witness = test::true_distance(gamma, test::widened_curve(path.segment(k)),
                                             Wide(begin), Wide(errors[k].at_xi));
    EXPECT_GE(witness, Wide(errors[k].error.lower())) << "segment " << k;
    EXPECT_LE(errors[k].error.upper(), total.error.upper());
    for (int i = 0; i < 8; ++i) {
      const double xi = rng.uniform(begin, end);
      const auto at = path.locate(xi);
      const Vector3<double> position = path.position(xi);
      const Wide seen = norm(gamma(Wide(xi)) - test::widened(position));
      EXPECT_LE(seen, Wide(errors[at.segment].error.upper())) << "computed at " << xi;
    }
    if (largest < truth) largest = truth;
  }
  EXPECT_LE(largest, Wide(total.error.upper()));
  return {total.error, largest};
}

TEST(CertifiedError, Curve23IsSharp) {
  // The measured errors of the two choices; the bound exceeds them by at most what the search is
  // allowed (1/64), one halving's remainder (1/32) and a little for rounding at 128 segments.
  constexpr double sharp = 1.06;
  for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
    for (const int segments : {1, 2, 4, 8, 16, 32, 64, 128}) {
      const auto path = fitted_path<4>(Curve23{}, even_knots(0.0, 1.0, segments), choice);
      const Judged judged = judge(Curve23{}, path);
      EXPECT_LE(judged.error.upper(), sharp * static_cast<double>(judged.truth))
          << segments << " segments";
      EXPECT_GE(judged.error.lower() * sharp, static_cast<double>(judged.truth))
          << segments << " segments";
    }
  }
}

TEST(CertifiedError, OtherCurves) {
  for (const int segments : {2, 7, 20}) {
    judge(Helix{}, fitted_path<4>(Helix{}, even_knots(-3.0, 9.0, 2 * segments)));
    judge(TorusKnot{}, fitted_path<4>(TorusKnot{}, even_knots(0.0, 6.25, 6 * segments)));
    judge(Viviani{}, fitted_path<4>(Viviani{}, even_knots(-6.0, 6.5, 4 * segments)));
    judge(Medley{}, fitted_path<4>(Medley{}, even_knots(-0.25, 3.0, segments)));
  }
}

TEST(CertifiedError, LowerDegrees) {
  judge(TorusKnot{}, fitted_path<1>(TorusKnot{}, even_knots(0.0, 6.25, 40)));
  judge(TorusKnot{}, fitted_path<2>(TorusKnot{}, even_knots(0.0, 6.25, 40)));
}

TEST(CertifiedError, AtRoundingLevel) {
  for (const int segments : {256, 1000, 4000}) {
    const auto path = fitted_path<4>(Curve23{}, even_knots(0.0, 1.0, segments));
    const Judged judged = judge(Curve23{}, path, 4, static_cast<std::size_t>(segments / 100));
    // A few roundings of a number near 3, not thousands of them.
    constexpr double roundings = 16.0;
    EXPECT_LE(judged.error.upper(), roundings * epsilon<double>());
  }
}

TEST(CertifiedError, AwkwardKnots) {
  Random rng("certified error, awkward knots");
  for (int repeat = 0; repeat < 12; ++repeat) {
    // Steps that are not representable sums: ξ_k + h misses ξ_{k+1}.
    std::vector<double> knots{rng.uniform(-1.0, 0.0)};
    while (knots.back() < 1.0) {
      knots.push_back(knots.back() +
                      std::ldexp(rng.uniform(1.0, 2.0), -static_cast<int>(rng.integer(2, 5))));
    }
    judge(Curve23{}, fitted_path<4>(Curve23{}, knots));
  }
  judge(Helix{}, fitted_path<4>(Helix{}, even_knots(1e6, 1e6 + 4.0, 9)));
}

/// γ = p + a known perturbation: p evaluated by Taylor arithmetic from the stored preimage.
template <std::size_t n>
struct Perturbed {
  SpatialPhCurve<n> curve;
  double xi_begin;
  double size;

  template <class S>
  Vector3<S> operator()(const S& xi) const {
    using std::sin;
    const S u = (xi - S(xi_begin)) / S(curve.parameter_step());
    const PhCurve<Quaternion<S>, n> same(lifted<S>(curve.start()),
                                         curve.preimage().mapped([](const Quaternion<double>& a) {
                                           return Quaternion<S>{S(a.w), S(a.x), S(a.y), S(a.z)};
                                         }),
                                         S(curve.parameter_step()));
    const Vector3<S> p = same.position(u);
    return {p.x + S(size) * sin(S(5) * u), p.y, p.z};
  }
  template <class S>
  static Vector3<S> lifted(const Vector3<double>& v) {
    return {S(v.x), S(v.y), S(v.z)};
  }
};

template <std::size_t n>
SpatialPhCurve<n> random_curve(Random& rng, double step) {
  BernsteinPolynomial<Quaternion<double>, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) preimage[i] = rng.quaternion(1.0);
  return {rng.vector3(10.0), preimage, step};
}

TEST(CertifiedError, KnownPerturbations) {
  Random rng("certified error, known perturbations");
  for (const double size : {0.5, std::ldexp(1.0, -20), std::ldexp(1.0, -40), 0.0}) {
    const double xi_begin = rng.uniform(-2.0, 2.0), h = std::ldexp(1.0, -3);
    const Perturbed<8> gamma{random_curve<8>(rng, h), xi_begin, size};
    const ErrorBound bound = segment_error(gamma, gamma.curve, xi_begin, xi_begin + h);
    ASSERT_TRUE(bound.certified);
    EXPECT_LE(bound.error.lower(), size);
    EXPECT_GE(bound.error.upper(), size);  // sin(5u) takes the value 1
    const double allowed = position_error(gamma.curve);
    // Twice the allowance for positions, and as much again for the search.
    EXPECT_LE(bound.error.upper(), size * (1.0 + 1.0 / 16.0) + 4.0 * allowed);
  }
}

TEST(CertifiedError, ScalesWithTheCurve) {
  // 1e±150: squares of lengths are at the ends of the range of double.
  for (const int exponent : {-498, 498}) {
    const double scale = std::ldexp(1.0, exponent);
    const auto gamma = [scale](const auto& xi) {
      using S = std::remove_cvref_t<decltype(xi)>;
      return S(scale) * Curve23{}(xi);
    };
    const auto path = fitted_path<4>(gamma, even_knots(0.0, 1.0, 16));
    const auto unscaled = fitted_path<4>(Curve23{}, even_knots(0.0, 1.0, 16));
    const ErrorBound bound = certified_error(gamma, path);
    const ErrorBound reference = certified_error(Curve23{}, unscaled);
    ASSERT_TRUE(bound.certified);
    EXPECT_LE(bound.error.lower(), scale * reference.error.upper());
    EXPECT_GE(bound.error.upper(), scale * reference.error.lower());
    EXPECT_LE(bound.error.upper(), scale * reference.error.upper() * (1.0 + 1.0 / 16.0));
  }
}

TEST(CertifiedError, InThePlane) {
  using Curve = PlanarPhCurve<2>;
  const Curve curve({0.5, 2.0},
                    BernsteinPolynomial<Complex<double>, 2>({{{1, 0.5}, {1, 1}, {0.5, 1}}}), 0.75);
  const auto gamma = [](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    using std::sin;
    return Vector2<S>{S(0.5) + sin(xi), S(2) + xi};
  };
  const ErrorBound bound = segment_error(gamma, curve, 1.0, 1.75);
  ASSERT_TRUE(bound.certified);
  const Wide truth = true_segment_error(gamma, curve, 1.0, 1.75, 64);
  EXPECT_LE(truth, Wide(bound.error.upper()));
  EXPECT_GE(truth, Wide(bound.error.lower()));
}

// ---- callables without a certificate
// ---------------------------------------------------------------

template <class Gamma>
ErrorBound against_line(const Gamma& gamma) {
  // The line (ξ, 0, 0) on [0, 1].
  const SpatialPhCurve<8> line(
      {0, 0, 0},
      [] {
        BernsteinPolynomial<Quaternion<double>, 8> one;
        for (std::size_t i = 0; i <= 8; ++i) one[i] = {1, 0, 0, 0};
        return one;
      }(),
      1.0);
  return segment_error(gamma, line, 0.0, 1.0);
}

void expect_refused(const ErrorBound& bound) {
  EXPECT_FALSE(bound.certified);
  EXPECT_TRUE(std::isinf(bound.error.upper()));
  EXPECT_GE(bound.error.lower(), 0.0);
  EXPECT_TRUE(std::isfinite(bound.error.lower()));
}

TEST(CertifiedError, RefusesWhatIsNotAnalytic) {
  const auto with_height = [](auto height) {
    return [height](const auto& xi) {
      using S = std::remove_cvref_t<decltype(xi)>;
      return Vector3<S>{xi, S(0), height(xi)};
    };
  };
  using std::sqrt;
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return S(1) / (xi - S(0.3));
  })));
  expect_refused(against_line(with_height([](const auto& xi) { return sqrt(xi); })));
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return abs(xi - S(0.7));
  })));
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return xi < S(0.3) ? S(0) : S(1);
  })));
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return atan2(xi - S(0.4), S(-1));  // jumps by 2π
  })));
  expect_refused(against_line(with_height([](const auto& xi) { return log(xi); })));
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return asin(S(2) * xi - S(1));
  })));
  expect_refused(against_line(with_height([](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return tan(S(4) * xi);
  })));
}

TEST(CertifiedError, CertifiesBranchesDecidedEverywhere) {
  // The branch is never taken on [0, 1], however the interval is divided.
  const auto gamma = [](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return S(2) < xi ? Vector3<S>{S(7), S(7), S(7)} : Vector3<S>{xi, S(0), S(0.125) * xi * xi};
  };
  const ErrorBound bound = against_line(gamma);
  EXPECT_TRUE(bound.certified);
  EXPECT_TRUE(bound.error.contains(0.125));
}

}  // namespace
}  // namespace hodograph
