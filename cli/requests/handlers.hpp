// SPDX-License-Identifier: MIT
// The requests; docs/requests.md describes the members of each. All throw Error.
#pragma once

#include "cli/requests/batch.hpp"

namespace hodograph::cli {

Answer answer_hermite(Members& request);
Answer answer_hermite_path(Members& request);
Answer answer_planar_hermite(Members& request);
Answer answer_prescribed_length(Members& request);
Answer answer_least_peak_curvature(Members& request);
Answer answer_corner(Members& request);
Answer answer_rounded_polyline(Members& request);
Answer answer_waypoint_path(Members& request);
Answer answer_planar_spline(Members& request);
Answer answer_climb(Members& request);
Answer answer_climb_route(Members& request);
Answer answer_helix(Members& request);
Answer answer_loop(Members& request);
Answer answer_plan(Members& request);
Answer answer_swarm(Members& request);
Answer answer_separation(Members& request);
Answer answer_rational(Members& request);
Answer answer_rational_hermite(Members& request);
Answer answer_frame(Members& request);
Answer answer_fit(Members& request);
Answer answer_orbit(Members& request);
Answer answer_ascend(Members& request);
Answer answer_evaluate(Members& request);
Answer answer_sample(Members& request);
Answer answer_nearest(Members& request);
Answer answer_inspect(Members& request);
Answer answer_analyse(Members& request);
Answer answer_offset(Members& request);
Answer answer_sweep(Members& request);
Answer answer_follow(Members& request);
Answer answer_codegen(Members& request);
Answer answer_mission(Members& request);
Answer answer_intersections(Members& request);
Answer answer_operate(Members& request);

}  // namespace hodograph::cli
