#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 9: a frame that is smooth all round, and what it sweeps

The periodic frame of the loop of Example 1 whose rate agrees where it closes, too (γ₋), and the
surface that the planar oval (ψ = π; the paper's ψ = π/2 is not planar) of length 0.5 sweeps along
the loop with it.
"""

from closed import EXAMPLE_1, absolute_twist, loop, swept
from gallery import bare, figure, save, title, view

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_1)
    gammas = hodograph.smooth_periodic_gammas(path)
    made, (left, right) = figure(1, 2, width=9.5, height=4.2, spatial=True)
    plots.frames(path, left, frame=hodograph.periodic_roll(path, gammas.negative), count=90,
                 length=0.06, which=(2, 3), linewidths=0.8)
    view(left, 28, -58, 1.4)
    bare(left)
    right.view_init(elev=28, azim=-58)
    surface = swept(path, gammas.negative, 0.5)
    plots.surface(surface, right)
    view(right, 28, -58, 1.4)
    bare(right)
    title(left, f"γ₋ = {gammas.negative:.5f}")
    facts = hodograph.facts_of(surface.mesh)
    for name, gamma in (("-", gammas.negative), ("+", gammas.positive)):
        print(f"gamma{name} = {gamma:.6f}: absolute twist {absolute_twist(path, gamma):.6f} rad")
    print(f"mesh: closed {facts.is_closed}, Euler characteristic {facts.euler_characteristic}")
    return made


if __name__ == "__main__":
    save(draw())
