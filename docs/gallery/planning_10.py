#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 10: a way through a field of obstacles

In a field like the paper's: the shortest polyline that keeps its distance, its corners rounded by
G² quintics (turn radius 0.2, clearance 0.05), and the G¹ paths through the polyline's points with
tangents by the rules T1 and T2. Lengths and clearances are enclosed; the numbers are their lower
ends.
"""

import numpy as np
from gallery import BLUE, figure, save, title
from scenes import world

import hodograph
from hodograph import plots

_TURN_RADIUS, _CLEARANCE = 0.2, 0.05


def plans():
    """The world, its plan and the two paths by rules."""
    field, start, goal = world("data/obstacle_field.geojson")
    planner = hodograph.Planner(field, turn_radius=_TURN_RADIUS, clearance=_CLEARANCE)
    plan = planner.plan(start, goal)
    index = hodograph.ClearanceIndex(field)
    ruled = [hodograph.tangent_plan(plan.polyline, rule, index, 1.0)
             for rule in (hodograph.TangentRule.t1, hodograph.TangentRule.t2)]
    return field, plan, ruled


def draw():
    field, plan, (t1, t2) = plans()
    made, axes = figure(2, 2, width=10, height=4.9)
    points = np.asarray(plan.polyline.points)
    plots.world(field, axes[0])
    axes[0].plot(*points.T, color=BLUE, linewidth=1.4)
    plots.plan(plan, axes[1], world=field)
    for ax, path in zip(axes[2:], (t1.path, t2.path)):
        plots.plan(path, ax, world=field)
        ax.plot(*points.T, ".", color=BLUE, markersize=4)
    names = ("polyline", "G² corners", "rule T1", "rule T2")
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    print(f"polyline: {len(points) - 2} corners, length {length:.4f}")
    for name, one in zip(names[1:], (plan, t1, t2)):
        proof = one.certificate
        print(f"{name}: length {proof.arc_length.lower:.4f}, largest curvature "
              f"{proof.curvature.upper:.4f}, clearance {proof.clearance.least().lower:.4f}")
    for ax, name in zip(axes, names):
        title(ax, name)
        ax.set(xlim=(-0.5, 22.5), ylim=(-0.5, 10.5), xlabel="", ylabel="")
    return made


if __name__ == "__main__":
    save(draw())
