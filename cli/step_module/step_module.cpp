// SPDX-License-Identifier: MIT
// What the program loads when a STEP file is asked for.
#include "cli/step_module/step_module.hpp"

#include "hodograph/cad/step.hpp"

extern "C" __attribute__((visibility("default"))) void hodograph_write_step(
    const hodograph::Sweep& sweep, const hodograph::cli::StepRequest& request,
    hodograph::cli::StepAnswer& answer) {
  const auto model =
      hodograph::save_step(sweep, {request.name, request.length_unit, request.caps}, request.path);
  if (!model) {
    answer.fault = model.fault();
    return;
  }
  answer.faces = model->faces;
  answer.solid = model->solid;
  answer.degree_along = model->degree_along;
  answer.degree_round = model->degree_round;
}
