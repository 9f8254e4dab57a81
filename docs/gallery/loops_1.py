#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 1: symmetric loops

The C² loops of length 1 with ξ = 0 and ψ = kπ/10, k = 1 to 4. They start at the dot; a half turn
about the line from there along the principal normal maps each to itself.
"""

import numpy as np
from closed import loop
from gallery import ORANGE, bare, figure, save, title, view

import hodograph
from hodograph import plots


def draw():
    made, axes = figure(1, 4, width=11, height=3.2, spatial=True)
    for k, ax in enumerate(axes, 1):
        path = loop(0.0, k * np.pi / 10)
        plots.path(path, ax, linewidth=1.8)
        ax.plot(*path.position(path.xi_begin), "o", color=ORANGE, markersize=5)
        view(ax, 35, -60, 1.3)
        bare(ax)
        title(ax, f"ψ = {k}π/10")
        kappa = hodograph.curvature_extremes(path)
        print(f"psi = {k} pi/10: length {path.arc_length():.6f}, curvature "
              f"{kappa.minimum.lower:.6f} to {kappa.maximum.upper:.6f}")
    return made


if __name__ == "__main__":
    save(draw())
