#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""All curves with one set of tangents

Left, a tangent indicatrix on the unit sphere, that of A = t² − (i + j) t + k. Right, three rational
PH curves with the denominator (t² + 1)⁴ that have these tangents, members of one linear space found
exactly: at equal t (dots, with their tangents) they are parallel, up to the sense.
"""

import numpy as np
from exact import rotated
from gallery import BLUE, GREEN, ORANGE, bare, figure, save, strokes, title, view

import hodograph
from hodograph import plots

_A, _ALPHA, _DEGREE = "t^2 - (i + j)*t + k", "(t^2 + 1)^4", 12


def draw():
    space = hodograph.solve(_A, _ALPHA, _DEGREE)
    t = np.linspace(-1.6, 1.6, 260)
    marks = np.arange(10, 260, 40)
    a = np.stack([t**2, -t, -t, np.ones_like(t)], axis=-1)
    tangents = rotated(a, 1) / np.sum(a * a, axis=1, keepdims=True)
    made, (left, right) = figure(1, 2, width=9.5, height=4.4, spatial=True)
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 25), np.linspace(0, np.pi, 13))
    left.plot_wireframe(np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v),
                        color="#d9dfe5", linewidth=0.4)
    left.plot(*tangents.T, color=ORANGE, linewidth=2.0)
    left.plot(*tangents[marks].T, "o", color="#1b2733", markersize=3)
    left.set_box_aspect((1, 1, 1))
    view(left, 20, -50, 1.3)
    bare(left)
    title(left, "tangent indicatrix")
    curves = [hodograph.RationalPhCurve.of_solution(space.preimage, space.alpha, b)
              for b in space.basis[:3]]
    for k, (curve, colour) in enumerate(zip(curves, (BLUE, GREEN, ORANGE))):
        r = curve(t)
        r = (r - r[130]) / np.ptp(r, axis=0).max()
        right.plot(*r.T, color=colour, linewidth=1.6)
        right.plot(*r[marks].T, "o", color="#1b2733", markersize=3)
        strokes(right, r[marks], r[marks] + 0.15 * tangents[marks], color=colour, linewidth=0.8)
    plots.equal_scales(right)
    view(right, 20, -50, 1.4)
    bare(right)
    title(right, "curves")
    print(f"deg B up to {_DEGREE}: dimension {space.dimension} = {space.rational_dimension} truly "
          f"rational + {space.polynomial_dimension} polynomial + {space.constant_dimension} points")
    return made


if __name__ == "__main__":
    save(draw())
