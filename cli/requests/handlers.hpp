// SPDX-License-Identifier: MIT
// The requests; docs/requests.md describes the members of each. All throw Error.
#pragma once

#include "cli/requests/batch.hpp"

namespace hodograph::cli {

Answer answer_hermite(Members& request);
Answer answer_hermite_path(Members& request);
Answer answer_fit(Members& request);
Answer answer_orbit(Members& request);
Answer answer_evaluate(Members& request);
Answer answer_sample(Members& request);
Answer answer_nearest(Members& request);
Answer answer_inspect(Members& request);
Answer answer_operate(Members& request);

}  // namespace hodograph::cli
