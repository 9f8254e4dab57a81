#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 3: six vehicles that arrive together

From six points of a circle to the corresponding points of another, all with the same speed, leaving
and arriving in different directions. Every path is exactly 12.5 % longer than the straight line.
"""

from gallery import figure, save
from scenes import arriving

import hodograph
from hodograph import plots


def fleet():
    """The six, arriving together, and the common length."""
    vehicles, data = arriving("data/six.json")
    length = hodograph.earliest_arrival(vehicles) * (1.0 + data["excess"])
    return hodograph.arrival_at(vehicles, length), length


def draw():
    together, length = fleet()
    made, (ax,) = figure(width=8, height=3.9)
    plots.swarm(together.vehicles, ax, time=0.5 * length)
    for vehicle, member in zip(together.vehicles, together.paths):
        begin = member.path.position(member.path.xi_begin)
        ax.annotate(vehicle.id, begin, xytext=(-10, -3), textcoords="offset points", fontsize=8)
        end = member.path.position(member.path.xi_end)
        ax.plot(*end, "o", color="#51606e", markersize=3)
    print(f"S = {length:.6f}; lengths "
          + ", ".join(f"{member.path.arc_length():.6f}" for member in together.paths))
    print("largest curvatures "
          + ", ".join(f"{member.largest_curvature.upper:.3f}" for member in together.paths))
    return made


if __name__ == "__main__":
    save(draw())
