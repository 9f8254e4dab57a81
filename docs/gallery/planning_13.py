#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 13: small corners and large ones

The polyline of the field of Figure 10 with corners as small as the turn radius allows (above) and
as large as the obstacles and the legs do (below): a shorter path that bends much less at most
corners.
"""

import numpy as np
from gallery import ORANGE, figure, save, title
from planning_10 import _CLEARANCE, _TURN_RADIUS
from scenes import world

import hodograph
from hodograph import plots


def draw():
    field, start, goal = world("data/obstacle_field.geojson")
    planner = hodograph.Planner(field, turn_radius=_TURN_RADIUS, clearance=_CLEARANCE)
    made, axes = figure(2, 2, width=10, height=5.4, width_ratios=[1.25, 1])
    grown = planner.plan(start, goal, aim=hodograph.CornerAim.largest).offsets
    offset = max(grown) - _CLEARANCE  # the same about every obstacle, for both
    for row, aim in enumerate((hodograph.CornerAim.smallest, hodograph.CornerAim.largest)):
        plan = planner.plan(start, goal, aim=aim, corner_offset=offset)
        where, how = axes[2 * row:2 * row + 2]
        plots.plan(plan, where, world=field)
        where.set(xlim=(-0.5, 22.5), ylim=(-0.5, 10.5), xlabel="", ylabel="")
        title(where, f"{aim.name} corners")
        plots.profile(plan.path, lambda xi, path=plan.path: np.abs(hodograph.curvature(path, xi)),
                      how, name="|curvature|", linewidth=1.2)
        how.axhline(1.0 / _TURN_RADIUS, color=ORANGE, linewidth=0.9, linestyle=(0, (6, 4)))
        how.set(ylim=(0, 5.8), xlim=(0, plan.path.arc_length()))
        proof = plan.certificate
        print(f"{aim.name} corners: length {proof.arc_length.lower:.4f}, largest curvature "
              f"{proof.curvature.upper:.4f}, legs {min(plan.legs):.4f} to {max(plan.legs):.4f}")
    return made


if __name__ == "__main__":
    save(draw())
