// SPDX-License-Identifier: MIT
// The request "rational".
#include "cli/requests/handlers.hpp"

#ifdef HODOGRAPH_HAS_RATIONAL
#include "cli/rationals.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_RATIONAL
Answer answer_rational(Members& request) {
  RationalProblem problem;
  define(problem, request);
  std::vector<double> interval;
  if (request.has("interval")) interval = request.numbers("interval", 2);
  request.require_all_known();
  const RationalAnswer found = answer_of(problem);
  Answer answer;
  answer.result = json_of(found);
  if (!interval.empty()) {
    const DescribedCurve curve = shown_curve(found);
    answer.result["bezier"] = nurbs_of(curve, interval[0], interval[1]);
    if (curve.curve.kind() == CurveKind::polynomial) {
      try {
        answer.document = to_json(path_of(curve, interval[0], interval[1], "").document);
      } catch (const Error& error) {
        answer.result["path_refused"] = error.fault().sentence;
      }
    }
  }
  return answer;
}
#else
Answer answer_rational(Members& request) {
  request.refuse("request", "this program was built without rational curves (FLINT was missing)");
}
#endif

}  // namespace hodograph::cli
