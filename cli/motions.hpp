// SPDX-License-Identifier: MIT
// Paths that are flown, and how close two of them come: what the subcommands `separation` and
// `swarm` and their requests have in common.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/io/svg.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/planning/swarm/separation.hpp"

namespace hodograph::cli {

class Members;

/// How a path is flown, as options and requests say it. Without anything: at speed 1 from time 0.
struct Flight {
  double departure = 0.0;
  std::optional<double> speed{};    ///< 1 where neither it nor the arrival is given
  std::optional<double> arrival{};  ///< instead of a speed
  /// From rest to rest; the deceleration is equal unless it is given.
  std::optional<double> acceleration{}, deceleration{};
  /// Slower in bends, so that the lateral acceleration stays below this.
  std::optional<double> lateral_acceleration{};
  Presence presence{};
  std::optional<double> altitude{};  ///< z of a path in the plane; 0 where it is not given
};

/// The path in time. Throws Error: malformed_document (members that exclude each other), and the
/// faults of TimingLaw.
TimedMotion motion_of(const AnyPath& path, const Flight& flight);

/// The members `departure`, `speed`, `arrival`, `acceleration`, `deceleration`,
/// `lateral_acceleration`, `stands` and `altitude` of an object.
Flight flight_of(Members& members);

/// Whether a vehicle stands before it starts and after it has arrived, by one of these words.
inline constexpr const char* standing_words[] = {"always", "before", "after", "never"};
Presence presence_of(const std::string& word);

/// Distances of which heights count 1/factor. Throws Error (outside_domain) unless it is positive.
double vertical_scale_of(double factor);

/// "yes", "no" or "undecided".
const char* word_of(hodograph::Answer answer);

/// What is known of two motions.
struct SeparationFacts {
  Separation least;
  std::optional<double> at_least{};  ///< the distance that was asked for
  hodograph::Answer keeps = hodograph::Answer::yes;
  std::vector<ClosePassage> passages{};  ///< when it is not kept
  std::optional<SteppedSeparation> stepped{};
};

/// Throws Error: the faults of least_separation and, with a step, of stepped_separation.
SeparationFacts separation_facts(const TimedMotion& a, const TimedMotion& b,
                                 const SeparationGoal& goal, const std::optional<double>& at_least,
                                 const std::optional<double>& step);

Json json_of(const SeparationFacts& facts);
Json json_of(const std::vector<ClosePassage>& passages);

/// The rows of the table that people read.
std::vector<std::pair<std::string, std::string>> rows_of(const SeparationFacts& facts);

/// A table of such rows.
std::string table_of(const std::vector<std::pair<std::string, std::string>>& rows);

/// The distance of two motions at times that are evenly spaced over those they have in common; no
/// points where there are none.
Series distances_in_time(const TimedMotion& a, const TimedMotion& b, double vertical_scale,
                         std::size_t points);

/// One point at 0, which is not drawn: the axis of distances then begins there.
Series at_zero(const Series& series);

/// The distance against time, with the least one and the one asked for.
Plot separation_picture(const TimedMotion& a, const TimedMotion& b, const SeparationGoal& goal,
                        const SeparationFacts& facts);

}  // namespace hodograph::cli
