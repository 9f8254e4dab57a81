#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A PH spline against the cubic spline

The same seven points through the C² spline of PH quintics and through SciPy's C² cubic spline, with
their curvature combs at one scale. Both are C²; the PH spline bends more evenly, less than half as
sharply, and its length is exact.
"""

import numpy as np
from gallery import BLUE, GREY, ORANGE, figure, save, strokes, title
from scipy.interpolate import CubicSpline

import hodograph
from hodograph import plots

_POINTS = np.array([[0, 0], [1.2, 1.9], [3.0, 0.4], [3.6, 2.4], [5.4, 2.6], [6.4, 0.3], [8.2, 1.2]])
_SCALE = 0.22


def draw():
    path = hodograph.planar_spline(_POINTS)
    cubic = CubicSpline(np.arange(len(_POINTS)), _POINTS, bc_type="natural")
    made, (above, below) = figure(2, 1, width=8, height=7)
    plots.curvature_comb(path, above, scale=_SCALE, teeth=200)
    t = np.linspace(0, len(_POINTS) - 1, 1201)
    r, v, a = (cubic(t, order) for order in range(3))
    speed = np.linalg.norm(v, axis=1)
    kappa = (v[:, 0] * a[:, 1] - v[:, 1] * a[:, 0]) / speed**3
    tips = r - _SCALE * (kappa / speed)[:, None] * np.stack([-v[:, 1], v[:, 0]], axis=1)
    below.plot(*r.T, color=BLUE)
    below.plot(*tips.T, color=ORANGE, linewidth=1.0)
    strokes(below, r[::6], tips[::6], color=ORANGE, linewidth=0.5, alpha=0.6)
    below.set_aspect("equal")
    for ax, name in ((above, "PH quintics"), (below, "cubics")):
        ax.plot(*_POINTS.T, "o", color=GREY, markersize=4, zorder=4)
        title(ax, name)
        ax.set(xlim=(-1.2, 9.2), ylim=(-1.7, 3.7), xlabel="x", ylabel="y")
    xi = plots.parameters(path, 4000)
    print(f"PH spline: length {path.arc_length():.6f}, largest curvature "
          f"{abs(hodograph.curvature(path, xi)).max():.3f}, speed "
          f"{path.speed(xi).min():.3f} to {path.speed(xi).max():.3f}")
    print(f"cubic spline: largest curvature {abs(kappa).max():.3f}, speed {speed.min():.3f} to "
          f"{speed.max():.3f}")
    return made


if __name__ == "__main__":
    save(draw())
