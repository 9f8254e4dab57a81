// SPDX-License-Identifier: MIT
// Random and hostile Hermite data in numbers, counted by kind.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include "tests/support/hermite_judge.hpp"

namespace hodograph::test {

/// The counts of one kind.
struct CampaignCount {
  std::size_t sets = 0, accepted = 0, wrong = 0;
  std::map<std::string, std::size_t> refused;  ///< by reason
  double worst = 0.0;
};

/// Draws `sets` sets, kind after kind, degrees 4, 2, 1 in turn and both choices of each; reports up
/// to a dozen complaints through `complain`.
template <class Complain>
std::array<CampaignCount, data_kinds> run_campaign(Random& random, std::size_t sets,
                                                   const Complain& complain) {
  std::array<CampaignCount, data_kinds> counts;
  std::size_t complaints = 0;
  const auto take = [&]<std::size_t m>(DataKind kind) {
    const auto set = random_set<m>(random, kind);
    CampaignCount& count = counts[static_cast<std::size_t>(kind)];
    for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
      const Verdict verdict = judged<m>(set, choice);
      ++count.sets;
      if (verdict.accepted) {
        ++count.accepted;
        count.worst = std::max(count.worst, verdict.worst);
      } else {
        ++count.refused[std::string(name_of(verdict.code)) +
                        (verdict.quantity.empty() ? "" : " (" + verdict.quantity + ")")];
      }
      if (verdict.complaint.empty()) continue;
      ++count.wrong;
      constexpr std::size_t most_complaints = 12;
      if (++complaints <= most_complaints) {
        complain(name_of(kind) + ", m = " + std::to_string(m) +
                 (choice == HermiteChoice::order_ten ? ", order ten: " : ", order six: ") +
                 verdict.complaint + "\n  " + text_of<m>(set));
      }
    }
  };
  for (std::size_t i = 0; i < sets; ++i) {
    const auto kind = static_cast<DataKind>(i % data_kinds);
    switch ((i / data_kinds) % 4) {
      case 0:
        take.template operator()<1>(kind);
        break;
      case 1:
        take.template operator()<2>(kind);
        break;
      default:
        take.template operator()<4>(kind);
    }
  }
  return counts;
}

inline void print_campaign(const std::array<CampaignCount, data_kinds>& counts) {
  for (int kind = 0; kind < data_kinds; ++kind) {
    const CampaignCount& count = counts[static_cast<std::size_t>(kind)];
    std::printf("%-14s %8zu cases, %8zu accepted (worst miss %.3f of what is allowed), %zu wrong\n",
                name_of(static_cast<DataKind>(kind)).c_str(), count.sets, count.accepted,
                count.worst, count.wrong);
    for (const auto& [reason, number] : count.refused) {
      std::printf("%14s %8zu refused: %s\n", "", number, reason.c_str());
    }
  }
}

}  // namespace hodograph::test
