#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 8: the end speed of least curvature

The largest curvature of the paths above over the end speed. The minimum is found by
`least_peak_curvature_of_equal_speeds`, and its curvature is enclosed.
"""

import numpy as np
from gallery import ORANGE, direction, figure, largest_curvature, save
from planning_7 import of_speed

import hodograph


def draw():
    made, (ax,) = figure(width=6.2, height=3.4)
    speeds = np.linspace(0.8, 4.5, 371)
    most = np.array([largest_curvature(of_speed(s)) for s in speeds])
    ax.plot(speeds, most, linewidth=1.6)
    least = hodograph.least_peak_curvature_of_equal_speeds(
        [0, 0], direction(np.pi / 6), [1, 0], direction(np.pi / 4), 2.0)
    peak = least.peak_curvature.upper
    ax.plot(least.begin_speed, peak, "o", color=ORANGE, markersize=5)
    ax.annotate(f"{peak:.4f} at {least.begin_speed:.4f}", (least.begin_speed, peak),
                xytext=(0, -16), textcoords="offset points", fontsize=8, ha="center")
    ax.set(xlabel="|r′| at both ends", ylabel="largest |curvature|", ylim=(0, 16))
    print(f"least largest curvature {peak:.4f} at end speed {least.begin_speed:.4f}, "
          f"length {least.curve.arc_length():.4f}")
    return made


if __name__ == "__main__":
    save(draw())
