#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The examples of the paper

The rational PH curves of Examples 5.1, 5.3, 5.4, 5.5 and 5.6, each the only truly rational one of
its degree up to scale and place, with the frame that the quaternion polynomial A carries (e₂ blue,
e₃ green). The dimensions are those of the space of all curves with that A, that denominator and
that degree.
"""

import numpy as np
from exact import rotated, simplest
from gallery import FRAME, bare, figure, save, strokes, title, view

from hodograph import plots

#: example, A, its coefficients by falling degree, alpha, degree of B, range of t
_A1 = "t^2 - (i + j)*t + k", [[1, 0, 0, 0], [0, -1, -1, 0], [0, 0, 0, 1]]
_A4 = "t^2 + 3t*i + 2j + k - 1", [[1, 0, 0, 0], [0, 3, 0, 0], [-1, 0, 2, 1]]
_A5 = ("(7t^2 - 22t + 10) + (-19t^2 + 14t)i + (-26t^2 + 16t)j + (-2t^2 + 12t)k",
       [[7, -19, -26, -2], [-22, 14, 16, 12], [10, 0, 0, 0]])
_A6 = ("(-t^2 + t - 1) + (t^3 - 2t + 2)i + (-2t^3 + 3t^2 + t - 1)j + (-t^3 + 4t^2 - 2t + 2)k",
       [[0, 1, -2, -1], [-1, 0, 3, 4], [1, -2, 1, -2], [-1, 2, -1, 2]])
_EXAMPLES = (("5.1", _A1, "t^3", 6, (0.45, 1.9)), ("5.3", _A1, "(t+1)^2", 6, (-0.55, 1.3)),
             ("5.4", _A4, "t^2+1", 3, (-3.0, 3.0)), ("5.5", _A5, "(t+10)^5", 5, (0.0, 1.0)),
             ("5.6", _A6, "t*(t-1)", 5, (0.12, 0.88)))


def draw():
    made, axes = figure(2, 3, width=10, height=6.6, spatial=True)
    bare(axes[-1])
    for ax, (name, (text, coefficients), alpha, degree, (begin, end)) in zip(axes, _EXAMPLES):
        space, curve = simplest(text, alpha, degree)
        t = np.linspace(begin, end, 241)
        r = curve(t)
        r = (r - r.mean(axis=0)) / np.ptp(r, axis=0).max()
        a = sum(np.multiply.outer(t**(len(coefficients) - 1 - k), row)
                for k, row in enumerate(np.array(coefficients, dtype=float)))
        size = np.sum(a * a, axis=1, keepdims=True)
        along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(r, axis=0), axis=1))])
        at = np.unique(np.searchsorted(along, np.linspace(0.0, along[-1], 45)))
        for axis in (2, 3):
            tips = r + 0.12 * rotated(a, axis) / size
            strokes(ax, r[at], tips[at], color=FRAME[axis - 1], linewidth=0.8)
        ax.plot(*r.T, color="#1b2733", linewidth=1.6)
        plots.equal_scales(ax)
        view(ax, 22, -55, 1.35)
        bare(ax)
        title(ax, f"Example {name}, t from {begin} to {end}")
        print(f"Example {name}: dimension {space.dimension}, of which truly rational "
              f"{space.rational_dimension}; arc length rational: "
              f"{curve.arc_length_is_rational()}")
    return made


if __name__ == "__main__":
    save(draw())
