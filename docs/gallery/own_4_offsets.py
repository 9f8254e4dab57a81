#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Offsets and their cusps

Exact rational offsets of a closed spline, inwards, twelve distances. Where the distance reaches the
radius of curvature the offset turns back in a cusp (dots): these are isolated as roots of 1 − dκ,
and the largest distance without any is enclosed.
"""

import numpy as np
from gallery import BLUE, ORANGE, figure, save

import hodograph
from hodograph import plots

_POINTS = [[2.0, 0.0], [1.5, 1.3], [0.1, 0.7], [-1.6, 1.2], [-2.0, -0.3], [-0.6, -1.0], [0.9, -1.1]]


def draw():
    path = hodograph.planar_spline(_POINTS, closed=True)
    made, (ax,) = figure(width=6.6, height=4.8)
    xi = plots.parameters(path, 3000)
    distances = np.arange(1, 13) * 0.12
    counts = []
    for distance, colour in zip(distances, plots.shades(len(distances))):
        ax.plot(*hodograph.offset_position(path, xi, distance).T, color=colour, linewidth=0.8)
        cusps = hodograph.offset_cusps(path, distance)
        counts.append(len(cusps))
        if cusps:
            at = np.array([cusp.xi for cusp in cusps])
            ax.plot(*hodograph.offset_position(path, at, distance).T, ".", color="#1b2733",
                    markersize=4, zorder=4)
    plots.path(path, ax, color=BLUE, linewidth=2.2)
    limit = hodograph.cusp_free_offsets(path).left
    ax.plot(*hodograph.offset_position(path, xi, limit.lower).T, color=ORANGE, linewidth=1.6,
            linestyle=(0, (4, 2)))
    ax.set(xlabel="", ylabel="")
    print(f"length {path.arc_length():.6f}; inwards no cusp up to {limit.lower:.6f}")
    print("cusps at distances "
          + ", ".join(f"{d:.2f}: {n}" for d, n in zip(distances, counts) if n))
    return made


if __name__ == "__main__":
    save(draw())
