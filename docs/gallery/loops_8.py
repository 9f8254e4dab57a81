#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 8: the periodic frame of least twist

Left, the absolute twist of the periodic rational frames of the loop of Example 1 over γ; right, the
frame of the least. The paper has 0.65175 at γ = −0.46209; the minimum is a little lower and lies
beside it.
"""

import numpy as np
from closed import EXAMPLE_1, absolute_twist, loop
from gallery import ORANGE, bare, figure, save, title, view

import hodograph
from hodograph import plots


def twist_over_gamma(ax, path):
    """The absolute twist over gamma, both signs."""
    for sign in (-1.0, 1.0):
        gammas = sign * np.geomspace(0.01, 6.0, 120)[::int(sign)]
        ax.plot(gammas, [absolute_twist(path, gamma) for gamma in gammas], color=plots.COLOURS[0])
    ax.set(xlabel="γ", ylabel="absolute twist / rad", ylim=(0, None), xlim=(-6, 6))


def draw():
    path = loop(*EXAMPLE_1)
    made, (left, right) = figure(1, 2, width=9.5, height=3.9, spatial={1}, width_ratios=[1.1, 1])
    twist_over_gamma(left, path)
    least = hodograph.least_twist_gamma(path)
    left.plot(least.gamma, least.absolute_twist, "o", color=ORANGE, markersize=5)
    plots.frames(path, right, frame=hodograph.periodic_roll(path, least.gamma), count=90,
                 length=0.06, which=(2, 3), linewidths=0.8)
    view(right, 28, -58, 1.4)
    bare(right)
    title(right, f"γ = {least.gamma:.5f}")
    print(f"least absolute twist {least.absolute_twist:.9f} rad at gamma = {least.gamma:.9f}")
    print(f"at the paper's gamma = -0.46209: {absolute_twist(path, -0.46209):.9f} rad")
    return made


if __name__ == "__main__":
    save(draw())
