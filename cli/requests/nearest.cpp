// SPDX-License-Identifier: MIT
// The request "nearest".
#include "cli/requests/handlers.hpp"

namespace hodograph::cli {

Answer answer_nearest(Members& request) { request.refuse("request", "not offered yet"); }

}  // namespace hodograph::cli
