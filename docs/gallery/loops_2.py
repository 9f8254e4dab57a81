#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 2: mirror-symmetric loops

Loops of length 1 with ψ = 0 (above) and ψ = π (below) for ξ = −2.2, −0.73, 0.73 and 2.2. The plane
x = 0 is a plane of symmetry; with the sign of ξ they change sides of the plane of the first tangent
and normal.
"""

import numpy as np
from closed import loop
from gallery import BLUE, ORANGE, bare, figure, save, title, view

from hodograph import plots


def draw():
    made, axes = figure(2, 4, width=11, height=5.6, spatial=True)
    for row, (psi, name) in enumerate(((0.0, "0"), (np.pi, "π"))):
        for k, xi in enumerate(np.linspace(-2.2, 2.2, 4)):
            ax = axes[4 * row + k]
            path = loop(xi, psi)
            plots.path(path, ax, color=(BLUE, ORANGE)[row], linewidth=1.8)
            ax.plot(*path.position(path.xi_begin), "o", color="#1b2733", markersize=4)
            view(ax, 25, -60, 1.3)
            bare(ax)
            title(ax, f"ψ = {name}, ξ = {xi:.2f}")
            points = path.position(plots.parameters(path, 2000))
            sides = np.ptp(points, axis=0)
            print(f"psi = {name}, xi = {xi:.4f}: box {sides[0]:.4f} x {sides[1]:.4f} x "
                  f"{sides[2]:.4f}, length {path.arc_length():.6f}")
    return made


if __name__ == "__main__":
    save(draw())
