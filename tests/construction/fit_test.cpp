// SPDX-License-Identifier: MIT
// fit(): any curve to a tolerance, with the error that is reported, and the curves that are
// refused.
#include "hodograph/construction/fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "hodograph/construction/fit_spline.hpp"
#include "hodograph/frame/continuity.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

constexpr double eps = epsilon<double>();
constexpr double pi = std::numbers::pi;

// Tolerances that are asked for, for curves of size about 1: any would do.
constexpr double coarse = 0x1p-10, medium = 0x1p-20, fine = 0x1p-30, finer = 0x1p-40;
// Below the rounding of any coordinate of size 1, 2^-53.
constexpr double below_rounding = 0x1p-60;

/// The largest distance at `samples` places in every segment, in long double, from the stored
/// coefficients: a lower bound of the true error.
template <class Gamma>
double sampled_error(const Gamma& gamma, const SpatialPath<8>& path, int samples = 40) {
  using L = long double;
  L worst = 0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& segment = path.segment(k);
    const auto displacement = segment.displacement().mapped([](const Vector3<double>& v) {
      return Vector3<L>{v.x, v.y, v.z};
    });
    const Vector3<L> start{segment.start().x, segment.start().y, segment.start().z};
    for (int i = 0; i <= samples; ++i) {
      const L u = static_cast<L>(i) / samples;
      const L xi = path.knots()[k] + u * static_cast<L>(segment.parameter_step());
      worst = std::max(worst, norm(gamma(xi) - (start + displacement.value(u))));
    }
  }
  return static_cast<double>(worst);
}

FitOptions to(double tolerance, FitKnots knots = FitKnots::adaptive,
              HermiteChoice choice = HermiteChoice::order_ten) {
  FitOptions options;
  options.tolerance = tolerance;
  options.knots = knots;
  options.choice = choice;
  return options;
}

/// Fits a known curve along a ladder of tolerances, both ways of placing knots and both choices.
template <class Gamma>
void climb(const Gamma& gamma, double begin, double end, double size) {
  // Tolerances asked for, over the size of the curve.
  constexpr double ladder[] = {1e-1, 1e-3, 1e-6, 1e-9, 1e-12};
  // An estimate sees the largest distance to a few per cent; rounding of positions comes on top.
  constexpr double estimate = 1.05;
  std::size_t before = 0;
  for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
    before = 0;
    for (const double step : ladder) {
      const double tolerance = step * size;
      std::size_t counts[2] = {};
      for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
        const auto result = fit(differentiated(gamma), begin, end, to(tolerance, knots, choice));
        ASSERT_TRUE(result) << tolerance << ": " << result.fault().sentence;
        EXPECT_FALSE(result->error.certified);
        EXPECT_LE(result->error.error.upper(), tolerance);
        EXPECT_LE(sampled_error(gamma, result->path), estimate * tolerance + 16.0 * eps * size);
        EXPECT_EQ(result->segment_errors.size(), result->path.segment_count());
        EXPECT_EQ(result->path.xi_begin(), begin);
        EXPECT_EQ(result->path.xi_end(), end);
        const auto orders = continuity(result->path);
        EXPECT_EQ(orders.position.order(), 4);
        EXPECT_EQ(orders.preimage.order(), 3);
        counts[knots == FitKnots::uniform ? 1 : 0] = result->path.segment_count();
      }
      EXPECT_GE(counts[0], before) << "a smaller tolerance cannot need fewer segments";
      before = counts[0];
    }
  }
}

TEST(Fit, Curve23) { climb(test::Curve23{}, 0.0, 1.0, 3.0); }
TEST(Fit, Helix) { climb(test::Helix{}, -2.0, 8.0, 2.0); }
TEST(Fit, TorusKnot) { climb(test::TorusKnot{}, 0.0, 2.0 * pi, 3.0); }
TEST(Fit, Viviani) { climb(test::Viviani{}, 0.0, 4.0 * pi, 2.0); }

TEST(Fit, FewestUniformSegmentsAreTheFewest) {
  const auto gamma = differentiated(test::Curve23{});
  for (const double tolerance : {0.1, 0.001}) {
    const auto least = fit(gamma, 0.0, 1.0, to(tolerance, FitKnots::uniform)).value();
    FitOptions fixed;
    fixed.segments = least.path.segment_count();
    EXPECT_EQ(fit(gamma, 0.0, 1.0, fixed)->path, least.path);
    fixed.segments = least.path.segment_count() - 1;
    EXPECT_GT(fit(gamma, 0.0, 1.0, fixed)->error.error.upper(), tolerance);
  }
  // One is enough for a straight line.
  const DerivativeCurve line = [](double xi) {
    return HermitePoint<4>{{{xi, 2.0 * xi, 1.0}, {1.0, 2.0, 0.0}, {}, {}, {}}};
  };
  constexpr double near_rounding = 16.0 * eps;
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    EXPECT_EQ(fit(line, 0.0, 1.0, to(near_rounding, knots))->path.segment_count(), 1U);
  }
}

TEST(Fit, ScalesWithTheCurve) {
  const auto reference = fit(differentiated(test::Curve23{}), 0.0, 1.0, to(medium)).value();
  for (const int exponent : {-498, -40, 40, 498}) {
    const double scale = std::ldexp(1.0, exponent);
    const auto gamma = [scale](const auto& xi) {
      using S = std::remove_cvref_t<decltype(xi)>;
      return S(scale) * test::Curve23{}(xi);
    };
    const auto scaled = fit(differentiated(gamma), 0.0, 1.0, to(scale * medium));
    ASSERT_TRUE(scaled) << scaled.fault().sentence;
    EXPECT_EQ(scaled->path.knots(), reference.path.knots());
  }
}

// ---- closed curves
// ---------------------------------------------------------------------------------

TEST(Fit, ClosedCurvesCloseExactly) {
  const auto check = [](const auto& gamma, double period) {
    FitOptions options = to(medium);
    options.closed = true;
    const auto result = fit(differentiated(gamma), 0.0, period, options);
    ASSERT_TRUE(result) << result.fault().sentence;
    EXPECT_TRUE(result->path.is_closed());
    const auto orders = continuity(result->path);
    EXPECT_EQ(orders.position.order(), 4);
    // The frame is left with a roll; distributing it closes the frame.
    const auto left_over = holonomy(result->path).value();
    const auto roll = closing_roll(result->path).value();
    const AdaptedFrame frame(result->path, roll);
    const auto start = frame.at(0.0), end = frame.at(period);
    EXPECT_CLOSE(end, start, 64.0, 1.0);
    EXPECT_CLOSE(roll.angle(period), -left_over.roll, 4.0, pi);
  };
  check(test::TorusKnot{}, 2.0 * pi);
  check(test::Viviani{}, 4.0 * pi);
}

TEST(Fit, PlanarClosedCurveIsAntiperiodic) {
  // Once round a circle the frame turns by 2π: the preimage returns to its negative, C³.
  FitOptions options = to(fine);
  options.closed = true;
  const auto result = fit(differentiated(test::Circle{}), 0.0, 2.0 * pi, options).value();
  const auto orders = continuity(result.path);
  EXPECT_TRUE(orders.antiperiodic);
  EXPECT_EQ(orders.preimage.order(), 3);
  EXPECT_EQ(orders.position.order(), 4);
  const auto left_over = holonomy(result.path).value();
  EXPECT_CLOSE(left_over.roll, 0.0, 64.0, 1.0);
  EXPECT_EQ(left_over.sign, -1);
}

TEST(Fit, DeclaredClosedButOpen) {
  FitOptions options = to(medium);
  options.closed = true;
  const auto open = fit(differentiated(test::Curve23{}), 0.0, 1.0, options);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(open.fault().sentence.find("the curve is not closed: derivative 0 differs by"), 0U)
      << open.fault().sentence;
  // Position closes, the velocity does not: half of a figure of eight.
  const auto drop = [](const auto& xi) {
    using std::sin;
    using S = std::remove_cvref_t<decltype(xi)>;
    return Vector3<S>{sin(xi), sin(S(2) * xi), S(0)};
  };
  const auto corner = fit(differentiated(drop), 0.0, pi, options);
  ASSERT_FALSE(corner);
  EXPECT_EQ(corner.fault().sentence.find("the curve is not closed: derivative 1 differs by"), 0U)
      << corner.fault().sentence;
}

// ---- splines
// -----------------------------------------------------------------------------------------

std::vector<double> sample_times(std::size_t count, double begin, double end) {
  std::vector<double> t;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(count - 1);
    t.push_back(i + 1 == count ? end : begin + u * (end - begin));
  }
  return t;
}

template <std::size_t p>
void fit_spline_of(double tolerance) {
  const auto t = sample_times(81, 0.0, 1.0);
  std::vector<Vector3<double>> points;
  for (const double xi : t) points.push_back(test::Curve23{}(xi));
  const auto spline = InterpolatingSpline<p>::through(t, points).value();
  const auto result = fit(spline, to(tolerance));
  ASSERT_TRUE(result) << result.fault().sentence;
  EXPECT_TRUE(result->error.certified);
  EXPECT_LE(result->error.error.upper(), tolerance);
  // Against the spline itself, evaluated in double: its own rounding is 16 ε of the coordinates.
  double worst = 0.0;
  for (int i = 0; i <= 4000; ++i) {
    const double xi = i / 4000.0;
    worst = std::max(worst, norm(spline(xi)[0] - result->path.position(xi)));
  }
  EXPECT_LE(worst, result->error.error.upper() + 16.0 * eps * 3.0);
  EXPECT_GE(1.1 * worst, result->error.error.lower());
  EXPECT_EQ(continuity(result->path).position.order(), 4);
}

TEST(FitSpline, TheErrorIsCertifiedAndEnclosesTheTruth) {
  for (const double tolerance : {coarse, medium, fine}) {
    fit_spline_of<5>(tolerance);
    fit_spline_of<7>(tolerance);
  }
}

TEST(FitSpline, PeriodicSamplesGiveAClosedPath) {
  const auto t = sample_times(101, 0.0, 2.0 * pi);
  std::vector<Vector3<double>> points;
  for (const double xi : t) points.push_back(test::TorusKnot{}(xi));
  points.back() = points.front();
  const auto spline = InterpolatingSpline<5>::through(t, points, SplineEnds::periodic).value();
  const auto result = fit(spline, to(medium)).value();
  EXPECT_TRUE(result.path.is_closed());
  EXPECT_TRUE(result.error.certified);
  const auto orders = continuity(result.path);
  EXPECT_EQ(orders.position.order(), 4);
}

// ---- what is refused
// -----------------------------------------------------------------------------------

/// (ξ, height(ξ), 0) with the derivatives of the height given.
DerivativeCurve graph(const std::function<std::array<double, 5>(double)>& height) {
  return [height](double xi) {
    const auto y = height(xi);
    return HermitePoint<4>{{{xi, y[0], 0}, {1, y[1], 0}, {0, y[2], 0}, {0, y[3], 0}, {0, y[4], 0}}};
  };
}

std::string sentence_of(const Result<Fit>& result) {
  return result ? "accepted" : result.fault().sentence;
}

TEST(FitRefusals, Options) {
  const auto gamma = differentiated(test::Curve23{});
  EXPECT_EQ(sentence_of(fit(gamma, 1.0, 1.0, to(0.5))),
            "the parameter interval must have a positive length; got [1, 1]");
  EXPECT_EQ(sentence_of(fit(gamma, 0.0, std::numeric_limits<double>::infinity(), to(0.5))),
            "the parameter interval must have a positive length; got [0, inf]");
  EXPECT_EQ(sentence_of(fit(gamma, 0.0, 1.0, to(0.0))), "the tolerance must be positive; got 0");
  EXPECT_EQ(sentence_of(fit(gamma, 0.0, 1.0, to(std::numeric_limits<double>::quiet_NaN()))),
            "the tolerance must be positive; got nan");
  FitOptions many;
  many.segments = 300000;
  EXPECT_EQ(sentence_of(fit(gamma, 0.0, 1.0, many)),
            "at most 200000 segments are allowed; got 300000");
}

TEST(FitRefusals, NotANumberSomewhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    // In an interval that no early knot meets.
    const auto hole = graph([nan](double xi) {
      const bool in = 0.30 < xi && xi < 0.36;
      return std::array<double, 5>{in ? nan : xi * xi, 2.0 * xi, 2.0, 0.0, 0.0};
    });
    const auto result = fit(hole, 0.0, 1.0, to(fine, knots));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.fault().code, FaultCode::not_finite);
    EXPECT_EQ(result.fault().sentence.find(
                  "the curve or one of its first four derivatives is not finite at xi = 0.3"),
              0U)
        << result.fault().sentence;
    // Only in a derivative, at the start.
    const auto bad = graph([nan](double xi) {
      return std::array<double, 5>{xi * xi, 2.0 * xi, 2.0, xi == 0.0 ? nan : 0.0, 0.0};
    });
    EXPECT_EQ(sentence_of(fit(bad, 0.0, 1.0, to(0.25, knots))),
              "the curve or one of its first four derivatives is not finite at xi = 0");
  }
  // With fixed segments, too.
  FitOptions fixed;
  fixed.segments = 1;
  const auto pole = graph([](double xi) {
    const double top = std::numeric_limits<double>::infinity();
    return std::array<double, 5>{std::abs(xi - 0.5) < 0.125 ? top : 0.0, 0.0, 0.0, 0.0, 0.0};
  });
  EXPECT_EQ(fit(pole, 0.0, 1.0, fixed).fault().code, FaultCode::not_finite);
}

TEST(FitRefusals, ZeroSpeed) {
  const auto stop = [](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return Vector3<S>{xi * xi * xi, xi * xi * xi * xi, S(0)};
  };
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    EXPECT_EQ(
        sentence_of(fit(differentiated(stop), 0.0, 1.0, to(medium, knots))),
        "the curve stands still at xi = 0: a PH path has no direction there; fit the parts on "
        "either side, or reparametrise");
    // Inside, met by the second knot.
    EXPECT_EQ(fit(differentiated(stop), -1.0, 1.0, to(medium, knots)).fault().code,
              FaultCode::zero_speed);
  }
}

/// Either a fault with a sentence, or a path that keeps its promise.
template <class Gamma>
void refused_or_kept(const Gamma& gamma, const DerivativeCurve& curve, double begin, double end,
                     double tolerance) {
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    FitOptions options = to(tolerance, knots);
    options.most_segments = 3000;
    const auto result = fit(curve, begin, end, options);
    if (!result) {
      EXPECT_TRUE(is_no_solution(result.fault().code) ||
                  result.fault().code == FaultCode::zero_speed);
      EXPECT_NE(result.fault().sentence.find("xi = "), std::string::npos)
          << result.fault().sentence;
      continue;
    }
    double worst = 0.0;
    for (int i = 0; i <= 20000; ++i) {
      const double u = i / 20000.0, xi = (1.0 - u) * begin + u * end;
      worst = std::max(worst, norm(gamma(xi) - result->path.position(xi)));
    }
    EXPECT_LE(worst, 2.0 * tolerance);  // an estimate from 33 places of a curve that is not smooth
  }
}

TEST(FitRefusals, CuspCornerAndJump) {
  const auto cusp = [](const auto& xi) {
    using S = std::remove_cvref_t<decltype(xi)>;
    return Vector3<S>{xi * xi, xi * xi * xi, S(0)};
  };
  refused_or_kept(cusp, differentiated(cusp), -1.0, 1.375, medium);
  refused_or_kept(cusp, differentiated(cusp), -1.0, 1.0, medium);
  const auto corner_height = [](double xi) {
    return std::array<double, 5>{std::abs(xi), xi < 0 ? -1.0 : 1.0, 0, 0, 0};
  };
  const auto corner = [](double xi) { return Vector3<double>{xi, std::abs(xi), 0}; };
  refused_or_kept(corner, graph(corner_height), -1.0, 1.375, medium);

  const auto jump = graph([](double xi) {
    return std::array<double, 5>{xi < 0.3 ? 0.0 : 1.0, 0, 0, 0, 0};
  });
  const auto adaptive = fit(jump, 0.0, 1.0, to(coarse));
  ASSERT_FALSE(adaptive);
  EXPECT_EQ(adaptive.fault().code, FaultCode::tolerance_not_reached);
  EXPECT_NE(
      adaptive.fault().sentence.find("the interval cannot be halved any further: the curve or "
                                     "its derivatives jump there"),
      std::string::npos)
      << adaptive.fault().sentence;
  FitOptions few = to(coarse, FitKnots::uniform);
  few.most_segments = 1000;
  const auto uniform = fit(jump, 0.0, 1.0, few);
  ASSERT_FALSE(uniform);
  EXPECT_TRUE(is_no_solution(uniform.fault().code)) << uniform.fault().sentence;
}

TEST(FitRefusals, ToleranceBelowRounding) {
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    const auto result = fit(differentiated(test::Curve23{}), 0.0, 1.0, to(below_rounding, knots));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.fault().code, FaultCode::tolerance_not_reached);
    EXPECT_NE(result.fault().sentence.find("that is the rounding of double precision"),
              std::string::npos)
        << result.fault().sentence;
    EXPECT_EQ(result.fault().sentence.find("the tolerance " + to_text(below_rounding) +
                                           " was not reached"),
              0U);
  }
}

TEST(FitRefusals, MostSegmentsAndCancelling) {
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    for (const std::size_t most : {1U, 2U, 7U}) {
      FitOptions options = to(finer, knots);
      options.most_segments = most;
      const auto result = fit(differentiated(test::Curve23{}), 0.0, 1.0, options);
      ASSERT_FALSE(result);
      EXPECT_EQ(result.fault().code, FaultCode::tolerance_not_reached);
      EXPECT_NE(result.fault().sentence.find("was not reached with " + std::to_string(most) +
                                             " segments"),
                std::string::npos)
          << result.fault().sentence;
    }
    FitOptions options = to(medium, knots);
    double seen = 0.0;
    options.progress = [&](std::size_t, double fraction) {
      seen = fraction;
      return fraction < 0.5;
    };
    const auto stopped = fit(differentiated(test::Curve23{}), 0.0, 1.0, options);
    EXPECT_EQ(sentence_of(stopped), "the fit was stopped on request");
    EXPECT_GE(seen, 0.5);
  }
}

}  // namespace
}  // namespace hodograph
