#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 4: limits of the family

The loops for ξ → ∞ (orange) and ξ → −∞ (blue) with ψ = kπ/5: all are one planar curve, turned about
the binormal **k**. They stand still at their start. Thick, ψ = 0.
"""

import numpy as np
from closed import loop
from gallery import BLUE, ORANGE, bare, figure, save, view

from hodograph import plots


def draw():
    made, (ax,) = figure(width=6, height=4.6, spatial=True)
    for k in range(-4, 6):
        for xi, colour in ((np.inf, ORANGE), (-np.inf, BLUE)):
            path = loop(xi, k * np.pi / 5)
            plots.path(path, ax, color=colour, linewidth=2.6 if k == 0 else 0.8)
    view(ax, 22, -55, 0.95)
    bare(ax)
    first = loop(np.inf, 0.0)
    away = np.linalg.norm(first.position(np.linspace(0.0, 1.0, 4001)), axis=1).max()
    print(f"length {first.arc_length():.6f}, speed at the start {first.speed(0.0):.6f}, largest "
          f"distance from it {away:.6f}")
    return made


if __name__ == "__main__":
    save(draw())
