#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A clearance that is proven

The way through the harbour of `examples/`: turn radius 3, clearance 1 beyond half the width of 2.
The band is all that the vehicle and its clearance cover; circles of the turn radius touch the path
where it is bent most. That nothing solid is in the band is certified for every point of the path,
rounding included.
"""

from gallery import GREEN, figure, save
from scenes import world

import hodograph
from hodograph import plots


def draw():
    harbour, start, goal = world("examples/harbour.geojson")
    planner = hodograph.Planner(harbour, turn_radius=3.0, clearance=1.0, width=2.0)
    plan = planner.plan(start, goal)
    made, (ax,) = figure(width=7.6, height=5.8)
    plots.plan(plan, ax, world=harbour, clearance=planner.limits.distance(), turn_radius=3.0,
               polyline=True, unit="m")
    proof = plan.certificate
    for near in proof.clearance.near:
        if near.distance.lower < 3.0:
            place = plan.path.position(near.xi)
            ax.plot(*zip(place, near.nearest), color=GREEN, linewidth=1.2)
            ax.plot(*near.nearest, "o", color=GREEN, markersize=3)
    print(f"length {proof.arc_length.lower:.4f}, largest curvature {proof.curvature.upper:.6f}, "
          f"least distance {proof.clearance.least().lower:.6f}")
    print(f"obstacles within 3: "
          f"{sum(near.distance.lower < 3.0 for near in proof.clearance.near)}; "
          f"corners {len(plan.legs)}")
    return made


if __name__ == "__main__":
    save(draw())
