#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 12: one intricate obstacle

A single obstacle with many convex and concave corners, and the way through it with turn radius 0.2.
Below, the curvature: every corner attains the bound 5 and none exceeds it.
"""

import numpy as np
from gallery import ORANGE, figure, save
from scenes import world

import hodograph
from hodograph import plots


def draw():
    labyrinth, start, goal = world("data/intricate.geojson")
    plan = hodograph.Planner(labyrinth, turn_radius=0.2).plan(start, goal)
    made, (above, below) = figure(2, 1, width=9, height=5.6, height_ratios=[1.5, 1])
    plots.plan(plan, above, world=labyrinth, turn_radius=0.2, polyline=True)
    above.set(xlabel="", ylabel="")
    plots.profile(plan.path, lambda xi: np.abs(hodograph.curvature(plan.path, xi)), below,
                  name="|curvature|", linewidth=1.2)
    below.axhline(5.0, color=ORANGE, linewidth=0.9, linestyle=(0, (6, 4)))
    below.set(ylim=(0, 5.8), xlim=(0, plan.path.arc_length()))
    proof = plan.certificate
    print(f"{len(plan.legs)} corners, length {proof.arc_length.lower:.4f}, largest curvature "
          f"{proof.curvature.upper:.6f}, clearance {proof.clearance.least().lower:.6f}")
    return made


if __name__ == "__main__":
    save(draw())
