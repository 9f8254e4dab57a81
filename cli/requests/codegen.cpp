// SPDX-License-Identifier: MIT
// The request "codegen".
#include "cli/requests/handlers.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include "hodograph/control/code_generation.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL

Answer answer_codegen(Members& request) {
  const PathDocument document = request.document();
  CodeOptions options;
  options.name = request.text("name", options.name);
  options.casadi = request.truth("casadi", false);
  request.require_all_known();
  GeneratedCode code = generate_code(document.path, options).value();
  Answer answer;
  answer.result["header_name"] = std::move(code.header_name);
  answer.result["header"] = std::move(code.header);
  answer.result["source_name"] = std::move(code.source_name);
  answer.result["source"] = std::move(code.source);
  return answer;
}

#else

Answer answer_codegen(Members&) {
  throw Error(Fault{FaultCode::unsupported, "this program was built without the component control",
                    std::nullopt, "request", std::nullopt, std::nullopt});
}

#endif

}  // namespace hodograph::cli
