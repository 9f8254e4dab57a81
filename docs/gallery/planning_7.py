#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 7: quintics of given end speeds

From (0, 0) at 30° to (1, 0) at 45° with |r′| = 1.0, 1.5, …, 4.0 at both ends: of the four PH
quintics each time the one that turns least. Right, their curvature.
"""

import numpy as np
from gallery import direction, figure, largest_curvature, legend, save

import hodograph
from hodograph import plots


def of_speed(speed):
    ends = speed * np.array([direction(np.pi / 6), direction(np.pi / 4)])
    return hodograph.planar_hermite_path([0, 1], [[0, 0], [1, 0]], ends)


def draw():
    made, (left, right) = figure(1, 2, width=9.5, height=3.6)
    speeds = np.linspace(1.0, 4.0, 7)
    for speed, colour in zip(speeds, plots.shades(len(speeds))):
        path = of_speed(speed)
        plots.path(path, left, color=colour, label=f"{speed:.1f}")
        plots.profile(path, ax=right, relative=True, color=colour)
        print(f"end speed {speed:.1f}: length {path.arc_length():.6f}, "
              f"largest curvature {largest_curvature(path):.6f}")
    legend(left, loc="lower center", ncols=4, title="end speed", title_fontsize=8)
    left.set_ylim(-0.62, 0.3)
    return made


if __name__ == "__main__":
    save(draw())
