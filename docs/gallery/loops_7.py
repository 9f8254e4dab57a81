#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 7: curvature and torsion

Of the loop of Example 1 over its arc length. The curvature is the same at both ends, the torsion is
not.
"""

import numpy as np
from closed import EXAMPLE_1, loop
from gallery import ORANGE, figure, save

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_1)
    made, axes = figure(1, 2, width=9, height=3.3)
    ends = np.array([path.xi_begin, path.xi_end])
    for ax, quantity in zip(axes, ("curvature", "torsion")):
        plots.profile(path, quantity, ax)
        values = getattr(hodograph, quantity)(path, ends)
        ax.plot([0.0, path.arc_length()], values, "o", color=ORANGE, markersize=4)
        ax.axhline(values[0], color=ORANGE, linewidth=0.7, linestyle=(0, (5, 4)))
        ax.set_xlim(-0.02, 1.02)
        print(f"{quantity}: {values[0]:.6f} at the start, {values[1]:.6f} at the end")
    return made


if __name__ == "__main__":
    save(draw())
