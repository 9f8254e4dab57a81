// SPDX-License-Identifier: MIT
// JSON values for answers; numbers are the shortest decimals that read back to the same doubles.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/path_facts.hpp"
#include "cli/point_state.hpp"
#include "hodograph/foundation/fault.hpp"

namespace hodograph::cli {

using Json = nlohmann::ordered_json;

/// Appends a value on one line. What is no finite number is null; text that is no UTF-8 is mended.
void append_json(std::string& out, const Json& value);

/// The components of a vector, complex number or quaternion as a list.
template <class V>
Json list_of(const V& value) {
  Json list = Json::array();
  for (std::size_t i = 0; i < V::dimension; ++i) list.push_back(value[i]);
  return list;
}

/// {"lower": ..., "upper": ...}; an end that is infinite is null.
Json json_of(const Enclosure& bound);
Json json_of(const ErrorPromise& error);
Json json_of(const ContinuityOrders& orders);
/// {"code", "sentence", "index", "quantity", "value", "bound"}, absent ones null.
Json json_of(const Fault& fault);
Json json_of(const PathFacts& facts);
Json json_of(const PointState& state);
/// Algebra, degree, segments, interval, units, provenance, lengths, bounds, continuity, holonomy
/// and what the document promises.
Json json_of(const PathDocument& document, const PathFacts& facts);

}  // namespace hodograph::cli
