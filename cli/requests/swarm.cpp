// SPDX-License-Identifier: MIT
// The request "swarm".
#include "cli/swarms.hpp"

#include "cli/requests/handlers.hpp"

namespace hodograph::cli {

Answer answer_swarm(Members& request) {
  constexpr std::size_t most_answered = 500;  // vehicles whose paths or matrix fit into one answer
  constexpr std::size_t listed = 10;
  const SwarmRequest swarm = swarm_request(request);
  const std::size_t closest = request.count("closest", listed);
  const bool documents = request.truth("documents", true);
  const bool matrix = request.truth("matrix", false);
  request.require_all_known();
  request.require_at_most("closest", closest, most_places);
  const std::size_t count = swarm.arriving.size() + swarm.flying.size();
  if (documents && !swarm.arriving.empty()) {
    request.require_at_most("vehicles", count, most_answered);
  }
  if (matrix) request.require_at_most("vehicles", count, most_answered);
  Answer answer;
  answer.result = json_of(swarm_facts(swarm), closest, documents, matrix);
  return answer;
}

}  // namespace hodograph::cli
