#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 10: where every γ > 0 is best

Left, the absolute twist over γ of the loop of Example 4 (ψ = 0.1π, ξ = −1): for every γ > 0 the
frame turns in one sense, so no one is better. Right, the oval of length 0.2 swept along the loop
with the smooth one of them, γ₊.
"""

from closed import EXAMPLE_4, absolute_twist, loop, swept
from gallery import bare, figure, save, title, view
from loops_8 import twist_over_gamma

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_4)
    gammas = hodograph.smooth_periodic_gammas(path)
    made, (left, right) = figure(1, 2, width=9.5, height=3.9, spatial={1}, width_ratios=[1.1, 1])
    twist_over_gamma(left, path)
    right.view_init(elev=32, azim=-70)
    plots.surface(swept(path, gammas.positive, 0.2), right)
    view(right, 32, -70, 1.4)
    bare(right)
    title(right, f"γ₊ = {gammas.positive:.6f}")
    least = hodograph.least_twist_gamma(path)
    print(f"least absolute twist {least.absolute_twist:.6f} rad, on an interval: {least.plateau}")
    for name, gamma in (("-", gammas.negative), ("+", gammas.positive)):
        print(f"gamma{name} = {gamma:.6f}: absolute twist {absolute_twist(path, gamma):.6f} rad")
    return made


if __name__ == "__main__":
    save(draw())
