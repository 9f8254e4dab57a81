#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 6: periodic rational frames

The same loop with two of its periodic rational frames, γ = −1 left and γ = 1 right. Both close; the
second one turns about the tangent five times as much.
"""

from closed import EXAMPLE_1, absolute_twist, loop
from gallery import bare, figure, save, title, view

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_1)
    made, axes = figure(1, 2, width=9.5, height=4.2, spatial=True)
    for ax, gamma in zip(axes, (-1.0, 1.0)):
        plots.frames(path, ax, frame=hodograph.periodic_roll(path, gamma), count=90, length=0.06,
                     which=(2, 3), linewidths=0.8)
        ax.plot(*path.position(path.xi_begin), "o", color="#1b2733", markersize=4)
        view(ax, 28, -58, 1.4)
        bare(ax)
        title(ax, f"γ = {gamma:.0f}")
        print(f"gamma = {gamma:.0f}: absolute twist {absolute_twist(path, gamma):.6f} rad")
    return made


if __name__ == "__main__":
    save(draw())
