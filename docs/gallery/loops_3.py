#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 3: the two planar loops

Left ξ = ψ = 0, a figure of eight; right ξ = 0, ψ = π, close to the circle of radius 1/2π (orange).
Grey, the same polynomials before and after the loop.
"""

import numpy as np
from closed import loop
from gallery import BLUE, ORANGE, figure, save, title

from hodograph import plots


def draw():
    made, axes = figure(1, 2, width=8.5, height=3.7)
    for ax, psi, name in zip(axes, (0.0, np.pi), ("ξ = ψ = 0", "ξ = 0, ψ = π")):
        path = loop(0.0, psi)
        nodes = np.cos(np.pi * (np.arange(8) + 0.5) / 8) / 2 + 0.5
        whole = np.polynomial.chebyshev.chebfit(2 * nodes - 1, path.position(nodes), 7)
        for t in (np.linspace(-0.14, 0.0, 60), np.linspace(1.0, 1.14, 60)):
            outside = np.polynomial.chebyshev.chebval(2 * t - 1, whole)
            ax.plot(*outside[:2], color="#b9c3cc", linewidth=1.4)
        plots.path(path, ax, plane="xy", color=BLUE, linewidth=1.8)
        print(f"{name}: largest |z| {abs(path.position(nodes)[:, 2]).max():.1e}")
        if psi > 0:
            radius, angle = 0.5 / np.pi, np.linspace(0.0, 2.0 * np.pi, 200)
            ax.plot(radius * np.cos(angle), radius + radius * np.sin(angle), color=ORANGE,
                    linewidth=0.9)
            u = np.linspace(0.0, 1.0, 4001)
            away = np.linalg.norm(path.position(u)[:, :2] - [0.0, radius], axis=1) / radius
            print(f"distance from the circle's centre {away.min():.6f} to {away.max():.6f} radii, "
                  f"speed {path.speed(u).min():.6f} to {path.speed(u).max():.6f}")
        title(ax, name)
    return made


if __name__ == "__main__":
    save(draw())
