// SPDX-License-Identifier: MIT
// The members of a request, read with their types checked; what is wrong leaves as Error that names
// the member by its JSON pointer.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/algebra/vector.hpp"
#include "hodograph/io/document.hpp"

namespace hodograph::cli {

/// What one request may ask for, so that its answer stays below some hundred megabytes: places to
/// evaluate at, points of a sample, segments of a fit.
inline constexpr std::size_t most_places = 20'000;
inline constexpr std::size_t most_points = 1'000'000;
inline constexpr std::size_t most_fit_segments = 500'000;

/// The text in single quotes, on one line, cut to a readable length.
std::string in_quotes(std::string_view text);

class Members {
 public:
  /// Of the object `json` at `pointer` ("" for all of it, which sentences call `whole`). Throws
  /// Error if it is none.
  Members(const Json& json, std::string pointer, std::string whole = "the request");

  bool has(std::string_view name) const { return json_->contains(name); }

  double number(std::string_view name);
  double number(std::string_view name, double otherwise);
  std::optional<double> maybe_number(std::string_view name);
  bool truth(std::string_view name, bool otherwise);
  std::size_t count(std::string_view name);
  std::size_t count(std::string_view name, std::size_t otherwise);
  std::string text(std::string_view name);
  std::string text(std::string_view name, const std::string& otherwise);
  /// One of the given words.
  std::string word(std::string_view name, const std::vector<std::string>& words,
                   const std::string& otherwise = "");
  std::vector<double> numbers(std::string_view name);
  /// Exactly `count` numbers.
  std::vector<double> numbers(std::string_view name, std::size_t count);
  /// A list of lists of exactly `size` numbers.
  std::vector<std::vector<double>> vectors(std::string_view name, std::size_t size);
  Vector3<double> point(std::string_view name);
  /// Lists of `count` points of space: [item][order].
  std::vector<std::vector<Vector3<double>>> jets(std::string_view name, std::size_t count);
  /// `count` points of space.
  std::vector<Vector3<double>> jet(std::string_view name, std::size_t count);
  Members object(std::string_view name);
  /// A list of objects.
  std::vector<Members> objects(std::string_view name);
  /// Any value, as JSON text.
  std::string json_text(std::string_view name);
  /// The path document in `document`, or in the file that `file` names (with other names for both).
  PathDocument document(std::string_view document = "document", std::string_view file = "file");

  /// Refuses a number of items beyond a limit.
  void require_at_most(std::string_view name, std::size_t count, std::size_t limit) const;
  /// Refuses a member that was never asked for: a misspelt option is not ignored.
  void require_all_known() const;

  [[noreturn]] void refuse(std::string_view name, const std::string& what) const;

 private:
  const Json& need(std::string_view name);
  const Json* find(std::string_view name);
  double number_of(const Json& value, const std::string& place) const;
  std::vector<double> numbers_of(const Json& value, const std::string& place) const;
  Vector3<double> point_of(const Json& value, const std::string& place) const;
  std::vector<Vector3<double>> jet_of(const Json& value, std::size_t count,
                                      const std::string& place) const;
  [[noreturn]] void refuse_at(const std::string& place, const std::string& what) const;

  const Json* json_;
  std::string pointer_, whole_;
  std::vector<std::string> known_;
};

}  // namespace hodograph::cli
