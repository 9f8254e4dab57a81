// SPDX-License-Identifier: MIT
// The examples of section 5 of "Rational Framing Motions and Spatial Rational Pythagorean Hodograph
// Curves" in its order, with the curves as printed there.
#include "cli/rationals.hpp"

namespace hodograph::cli {

const std::vector<PaperExample>& paper_examples() {
  static const std::vector<PaperExample> examples = {
      {"Example 5.1",
       "A = t^2 - (i + j)*t + k\n"
       "alpha = t^3\n"
       "degree = 9\n",
       9,
       "The points begin at deg B = 3, not 2 as printed: alpha itself has degree 3.",
       {{"p_6", "(t^6 + 3t^4 + t^3 + 3t^2 + 1, 12t^4 + t^3 - 12t^2, 3t^5 + t^3 + 3t)/t^3"}}},
      {"Remark 5.2",
       "A = t^2 - (i + j)*t + k\n"
       "alpha = t^3\n"
       "degree = 12\n",
       12,
       "From deg B = 8 on, every degree adds the integral of t^(deg B - 8) A i A*.",
       {}},
      {"Example 5.3",
       "A = t^2 - (i + j)*t + k\n"
       "alpha = (t + 1)^2\n"
       "degree = 6\n",
       6,
       "",
       {{"r",
         "(-6t^6 - 10t^5 - 2t^4 + 8t^3 - 2t^2 - 70t - 62, -48t^4 - 72t^3, -16t^5 - 26t^4 + 44t^3 - "
         "108t - 54)/(t + 1)^2"}}},
      {"Example 5.4",
       "A = t^2 + 3t*i + 2j + k - 1\n"
       "alpha = 60(t^2 + 1)\n"
       "degree = 3\n",
       3,
       "",
       {{"(15)", "-(t(t^2 - 4), 2t(3t - 1), t(3t + 4))/(60(t^2 + 1))"}}},
      {"Example 5.5",
       "A = (7t^2 - 22t + 10) + (-19t^2 + 14t)i + (-26t^2 + 16t)j + (-2t^2 + 12t)k\n"
       "alpha = (t + 10)^5\n"
       "degree = 5\n",
       5,
       "(16) is -20000000 p_4 + (-10736000, 37314400, 15820800).",
       {{"(16)",
         "800(-13420t^5 + 4000t^4 + 30000t^3 - 50000t^2 + 25000t, 46643t^5 - 67850t^4 - 7000t^3 + "
         "30000t^2, 19776t^5 - 111200t^4 + 126000t^3 - 40000t^2)/(t + 10)^5"},
        {"p_4 (17)",
         "(-27t^4 - 538t^3 - 5366t^2 - 26841t - 53680, 96t^4 + 1866t^3 + 18656t^2 + 93286t + "
         "186572, 44t^4 + 786t^3 + 7912t^2 + 39552t + 79104)/(t + 10)^5"}}},
      {"Example 5.6",
       "A = (-t^2 + t - 1) + (t^3 - 2t + 2)i + (-2t^3 + 3t^2 + t - 1)j + (-t^3 + 4t^2 - 2t + 2)k\n"
       "alpha = 3t(t - 1)\n"
       "degree = 5\n",
       5,
       "(18) is p + q, each with one of the two poles.",
       {{"(18)",
         "(-4t^5 + 22t^4 - 18t^3 - 10t^2 + 34t, -4t^5 + 4t^4 + 12t^3 + 26t^2 - 2t - 24, -2t^5 + "
         "2t^4 + 36t^3 - 32t^2 - 46t + 18)/(3t(t - 1))"},
        {"p",
         "(-20t^7 + 108t^6 - 135t^5 - 20t^4 - 30t^3 - 120t^2 - 170t, -20t^7 + 36t^6 + 30t^5 - "
         "80t^4 "
         "- 180t^3 + 360t^2 + 490t + 120, -10t^7 + 18t^6 + 90t^5 - 190t^4 + 210t^3 + 30t^2 - 130t "
         "- 90)/(15t)"},
        {"q",
         "(20t^7 - 128t^6 + 243t^5 - 135t^4 + 120t^3, 20t^7 - 56t^6 + 6t^5 + 90t^4 + 120t^3 - "
         "480t^2 + 360, 10t^7 - 28t^6 - 72t^5 + 270t^4 - 390t^3 + 360t^2 - 270)/(15(t - 1))"}}},
  };
  return examples;
}

}  // namespace hodograph::cli
