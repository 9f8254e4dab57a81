// SPDX-License-Identifier: MIT
// Table 1 of PHODCOS, recomputed in 60 digits: the largest distance between curve (23) and its C⁴
// interpolants on N = 1 ... 8192 uniform segments, with the paper's choice of the free parameters
// and with the choice of order ten.
//
// Usage: table1 [largest N]
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "convergence_table.hpp"

namespace {

using hodograph::convergence::Row;
using hodograph::convergence::Wide;

/// What the paper prints where a recomputation shows a misprint.
const char* misprint(std::size_t segments) {
  switch (segments) {
    case 16:
      return "24.455e-6 (a misprint)";
    case 32:
      return "ratio 134.145 (a misprint)";
    case 8192:
      return "1.186e-23 (a misprint)";
    default:
      return "";
  }
}

std::string digits(const Wide& x) { return x.str(6, std::ios_base::scientific); }

/// The ratio to the row before and the order of convergence it means.
std::string progress(const Wide& before, const Wide& now) {
  if (before == Wide(0)) return "       -      -";
  const double ratio = static_cast<double>(Wide(before / now));
  char text[40];
  std::snprintf(text, sizeof text, "%8.3f %6.3f", ratio, std::log2(ratio));
  return text;
}

void print_head() {
  std::printf(
      "Largest distance between curve (23) of PHODCOS and its interpolants on N uniform\n"
      "segments, in 60-digit arithmetic. S=50: over u = i/50 in each segment, as the paper\n"
      "took it; true: over all u. ratio: S=50 of the row before over this one; order: its\n"
      "base 2 logarithm.\n\n");
  std::printf("%6s  %-42s  %-42s\n", "", "order six: the paper's free parameters, 0", "order ten");
  for (int choice = 0; choice < 2; ++choice) {
    std::printf("%6s  %-12s %-12s %8s %6s", choice == 0 ? "N" : "", "S=50", "true", "ratio",
                "order");
  }
  std::printf("  the paper prints\n");
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t most = 8192;
  if (argc > 1) {
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(argv[1], &end, 10);
    if (argc > 2 || errno != 0 || *end != '\0' || value < 1 || value > 8192) {
      std::fprintf(stderr, "table1: the largest number of segments must be 1 to 8192; got %s\n",
                   argv[1]);
      return 2;
    }
    most = static_cast<std::size_t>(value);
  }
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  print_head();
  std::array<Row, 2> before{};
  for (std::size_t segments = 1; segments <= most; segments *= 2) {
    const auto rows = hodograph::convergence::rows(segments, threads);
    const Row &six = rows.of[0], &ten = rows.of[1];
    std::printf("%6zu  %s %s %s", segments, digits(six.sampled).c_str(),
                digits(six.largest).c_str(), progress(before[0].sampled, six.sampled).c_str());
    std::printf("%6s  %s %s %s  %s\n", "", digits(ten.sampled).c_str(), digits(ten.largest).c_str(),
                progress(before[1].sampled, ten.sampled).c_str(), misprint(segments));
    std::fflush(stdout);
    before = rows.of;
  }
  return 0;
}
