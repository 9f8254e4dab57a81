#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 5: quintics of given lengths

From (0, 0), leaving at 60°, to (1, 0), arriving at −135°, with the arc lengths 1.1 to 1.6, exactly.
Right, their curvature over the part of the length. In short ones the largest is at an end.
"""

import numpy as np
from gallery import direction, figure, largest_curvature, legend, save

import hodograph
from hodograph import plots


def of_length(length):
    return hodograph.prescribed_length_curve([0, 0], direction(np.pi / 3), [1, 0],
                                             direction(-3 * np.pi / 4), length).curve


def draw():
    made, (left, right) = figure(1, 2, width=9.5, height=3.8)
    lengths = np.linspace(1.1, 1.6, 6)
    shades = plots.shades(len(lengths))
    for length, colour in zip(lengths, shades):
        path = of_length(length)
        plots.path(path, left, color=colour)
        plots.profile(path, ax=right, relative=True, color=colour, label=f"S = {length:.1f}")
        most = largest_curvature(path)
        ends = np.abs(hodograph.curvature(path, np.array([0.0, 1.0]))).max()
        where = "at an end" if most < ends * (1.0 + 1e-6) else "inside"
        print(f"S = {path.arc_length():.6f}: largest curvature {most:.6f}, {where}")
    legend(right, loc="lower center", ncols=2)
    right.set_ylim(-30, 0)
    return made


if __name__ == "__main__":
    save(draw())
