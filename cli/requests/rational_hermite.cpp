// SPDX-License-Identifier: MIT
// The request "rational_hermite".
#include "cli/requests/handlers.hpp"

#ifdef HODOGRAPH_HAS_RATIONAL
#include "cli/rational_hermites.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_RATIONAL
Answer answer_rational_hermite(Members& request) {
  RationalHermiteProblem problem;
  define(problem, request);
  request.require_all_known();
  const RationalHermiteAnswer found = answer_of(problem);
  Answer answer;
  answer.result = json_of(found);
  answer.result["bezier"] = Json();
  if (!found.curve) return answer;
  const double begin = found.data.begin.to_double(), end = found.data.end.to_double();
  try {
    answer.result["bezier"] = nurbs_of(*found.curve, begin, end);
    if (found.curve->curve.kind() == CurveKind::polynomial) {
      answer.document = to_json(path_of(*found.curve, begin, end, "").document);
    }
  } catch (const Error& error) {  // the exact answer stands; doubles do not hold it
    answer.result["export_refused"] = error.fault().sentence;
  }
  return answer;
}
#else
Answer answer_rational_hermite(Members& request) {
  request.refuse("request",
                 "this program was built without rational curves (FLINT or Clp was missing)");
}
#endif

}  // namespace hodograph::cli
