#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 5: quintics of given lengths

From (0, 0), leaving at 60°, to (1, 0), arriving at −135°, with the arc lengths 1.1 to 1.6, exactly.
Right, their curvature over the part of the length. In short ones the largest is at an end.
"""

import numpy as np
from gallery import direction, figure, legend, save

import hodograph
from hodograph import plots


def of_length(length):
    return hodograph.prescribed_length_curve([0, 0], direction(np.pi / 3), [1, 0],
                                             direction(-3 * np.pi / 4), length)


def draw():
    made, (left, right) = figure(1, 2, width=9.5, height=3.8)
    lengths = np.linspace(1.1, 1.6, 6)
    shades = plots.shades(len(lengths))
    for length, colour in zip(lengths, shades):
        path = of_length(length)
        plots.path(path, left, color=colour)
        plots.profile(path, ax=right, relative=True, color=colour, label=f"S = {length:.1f}")
        s = path.parameter_at_arc_length(np.linspace(0.0, path.arc_length(), 2001))
        kappa = np.abs(hodograph.curvature(path, s))
        where = "at an end" if kappa.argmax() in (0, 2000) else "inside"
        print(f"S = {path.arc_length():.6f}: largest curvature {kappa.max():.3f}, {where}")
    legend(right, loc="lower center", ncols=2)
    right.set_ylim(-30, 0)
    return made


if __name__ == "__main__":
    save(draw())
