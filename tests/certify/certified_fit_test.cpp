// SPDX-License-Identifier: MIT
// Fits whose tolerance is certified: the certified error encloses the true one, and what cannot be
// certified is refused.
#include "hodograph/certify/certified_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "hodograph/path/continuity.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/true_error.hpp"

namespace hodograph {
namespace {

constexpr double pi = std::numbers::pi;

// Tolerances asked for, for curves of size 1 to 3; the last is some hundred roundings.
constexpr double ladder[] = {0x1p-4, 0x1p-12, 0x1p-24, 0x1p-36, 0x1p-44};

template <class Gamma>
void climb(const Gamma& gamma, double begin, double end, bool closed) {
  for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
    for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
      for (const double tolerance : ladder) {
        FitOptions options;
        options.tolerance = tolerance;
        options.choice = choice;
        options.knots = knots;
        options.closed = closed;
        const auto result = certified_fit(gamma, begin, end, options);
        ASSERT_TRUE(result) << tolerance << ": " << result.fault().sentence;
        EXPECT_TRUE(result->error.certified);
        EXPECT_LE(result->error.error.upper(), tolerance);
        EXPECT_EQ(continuity(result->path).position.order(), 4);
        // A few segments of long paths suffice: every one is certified the same way.
        const std::size_t count = result->path.segment_count(), stride = count / 8 + 1;
        for (std::size_t k = 0; k < count; k += stride) {
          const test::Wide truth =
              test::true_segment_error(gamma, result->path.segment(k), result->path.knots()[k],
                                       result->path.knots()[k + 1], 12);
          EXPECT_LE(truth, test::Wide(result->segment_errors[k].error.upper()))
              << "segment " << k << ", tolerance " << tolerance;
        }
      }
    }
  }
}

TEST(CertifiedFit, Curve23) { climb(test::Curve23{}, 0.0, 1.0, false); }
TEST(CertifiedFit, Helix) { climb(test::Helix{}, 0.0, 7.0, false); }
// The last knot takes the data of the first: 2π is not exactly the period, and the difference of a
// rounding is part of the certified error.
TEST(CertifiedFit, TorusKnotClosed) { climb(test::TorusKnot{}, 0.0, 2.0 * pi, true); }

TEST(CertifiedFit, WhatIsNotSmoothIsNotCertified) {
  const auto corner = [](const auto& xi) {
    using std::abs;
    using S = std::remove_cvref_t<decltype(xi)>;
    return Vector3<S>{xi, abs(xi - S(0.3)), S(0)};
  };
  FitOptions options;
  options.tolerance = ladder[1];
  options.most_segments = 2000;
  for (const FitKnots knots : {FitKnots::adaptive, FitKnots::uniform}) {
    options.knots = knots;
    const auto result = certified_fit(corner, 0.0, 1.0, options);
    ASSERT_FALSE(result);
    // Bisection closes in on the corner, and may meet it exactly: no derivative exists there.
    EXPECT_TRUE(result.fault().code == FaultCode::tolerance_not_reached ||
                result.fault().sentence ==
                    "the curve or one of its first four derivatives is not finite at xi = 0.3")
        << result.fault().sentence;
  }
}

}  // namespace
}  // namespace hodograph
