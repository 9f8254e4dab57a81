// SPDX-License-Identifier: MIT
// Table 1 of PHODCOS as tools/table1.cpp computes it, up to 128 segments.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tools/convergence_table.hpp"

namespace hodograph {
namespace {

struct Expected {
  std::size_t segments;
  const char* sampled;
  const char* largest;
};

/// The table recomputed in 200 bits by an independent program, to the digits it prints.
constexpr std::array<Expected, 8> order_six{{{1, "1.256859e+00", "1.257542e+00"},
                                             {2, "5.446536e-01", "5.452691e-01"},
                                             {4, "3.319969e-02", "3.324539e-02"},
                                             {8, "1.608048e-03", "1.608212e-03"},
                                             {16, "2.545474e-05", "2.547675e-05"},
                                             {32, "1.897492e-07", "1.897842e-07"},
                                             {64, "5.009545e-09", "5.009634e-09"},
                                             {128, "8.009526e-11", "8.009640e-11"}}};
/// The same source for the choice of order ten: 1 to 64 sampled, 16 to 128 as measured.
constexpr std::array<const char*, 7> order_ten_sampled{
    "1.604499e+00", "1.937846e-01", "2.535947e-02", "1.548645e-03",
    "1.930244e-05", "1.132725e-07", "1.959821e-10"};
constexpr std::array<const char*, 4> order_ten_measured{"1.932e-05", "1.133e-07", "1.960e-10",
                                                        "2.185e-13"};

TEST(Table1, RecomputedToThePrintedDigits) {
  const auto digits = [](const convergence::Wide& x, int count) {
    return x.str(count, std::ios_base::scientific);
  };
  double before = 0.0;
  for (std::size_t i = 0; i < order_six.size(); ++i) {
    const auto rows = convergence::rows(order_six[i].segments, 2);
    EXPECT_EQ(digits(rows.of[0].sampled, 6), order_six[i].sampled) << order_six[i].segments;
    EXPECT_EQ(digits(rows.of[0].largest, 6), order_six[i].largest) << order_six[i].segments;
    if (i < order_ten_sampled.size()) {
      EXPECT_EQ(digits(rows.of[1].sampled, 6), order_ten_sampled[i]) << order_six[i].segments;
    }
    if (i >= 4) {
      EXPECT_EQ(digits(rows.of[1].largest, 3), order_ten_measured[i - 4]) << order_six[i].segments;
    }
    // Orders 9 to 10 from 64 segments on.
    const double now = static_cast<double>(rows.of[1].largest);
    if (i >= 6) {
      const double order = std::log2(before / now);
      EXPECT_GE(order, 9.0) << order_six[i].segments;
      EXPECT_LE(order, 10.0) << order_six[i].segments;
    }
    before = now;
  }
}

}  // namespace
}  // namespace hodograph
