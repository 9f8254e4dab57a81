#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 2: safety zones about paths

The paths above with their offsets at ±0.025 S. The zones overlap, which would forbid what is safe:
they forget when the vehicles pass. Offsets of PH curves are rational; where the distance exceeds
the radius of curvature they have cusps.
"""

import numpy as np
from gallery import BLUE, ORANGE, figure, save
from scenes import arriving

import hodograph
from hodograph import plots

_ZONE = 0.025  # of the length


def draw():
    vehicles, data = arriving("data/crossing_pair.json")
    length = data["length"]
    pair = hodograph.arrival_at(vehicles, length)
    made, (ax,) = figure(width=7.2, height=3.8)
    for member in pair.paths:
        xi = plots.parameters(member.path)
        tangent = hodograph.tangent(member.path, xi)
        normal = np.stack([-tangent[:, 1], tangent[:, 0]], axis=1)
        for side in (-_ZONE, _ZONE):
            ax.plot(*(member.path.position(xi) + side * length * normal).T, color=ORANGE,
                    linewidth=1.0)
        plots.path(member.path, ax, color=BLUE)
    least = hodograph.least_separation(*(vehicle.motion for vehicle in pair.vehicles))
    for place in (least.first, least.second):
        ax.plot(*place[:2], "o", color=BLUE, markersize=5, zorder=4)
    print(f"least separation {least.distance.upper / length:.4f} S, zones {_ZONE} S to each side")
    for member in pair.paths:
        print(f"least radius of curvature {1.0 / member.largest_curvature.upper / length:.4f} S")
    return made


if __name__ == "__main__":
    save(draw())
