#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 2 B: what is continuous where two segments meet

The two segments of the figure above over their parameter: preimage, the three axes of the
frame, its angular velocity, with first and second derivatives below. All continue at the knot
ξ = 0.5 (grey). Dotted: the second segment made by itself, whose preimage and frame have another
roll; the path is the same.
"""

import numpy as np
from curve23 import derivatives
from gallery import BLUE, GREEN, GREY, ORANGE, figure, save, title

import hodograph

_COLOURS = {4: (GREY, ORANGE, BLUE, GREEN), 3: (ORANGE, BLUE, GREEN)}
_ORDERS = 4


def product(a, b):
    """Of two quaternion series (orders, 4, n), as far as both are known."""
    def multiply(p, q):
        w = p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3]
        x = p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2]
        y = p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1]
        z = p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]
        return np.array([w, x, y, z])
    return np.array([sum(multiply(a[j], b[k - j]) for j in range(k + 1))
                     for k in range(min(len(a), len(b)))])


def quotient(a, s):
    """Of a series (orders, d, n) by a series of numbers (orders, n)."""
    result = np.zeros_like(a)
    for k in range(len(a)):
        result[k] = (a[k] - sum(s[j] * result[k - j] for j in range(1, k + 1))) / s[0]
    return result


def quantities(path, xi):
    """Taylor coefficients of preimage, frame axes and angular velocity, each (orders, d, n)."""
    factorial = 1.0
    preimage = []
    for order in range(_ORDERS + 1):
        factorial *= max(1, order)
        preimage.append(hodograph.preimage(path, xi, order).T / factorial)
    a = np.array(preimage)
    conjugate = a * np.array([1.0, -1.0, -1.0, -1.0])[:, None]
    square = product(a, conjugate)[:, 0]
    axes = []
    for axis in (1, 2, 3):
        unit = np.zeros((_ORDERS + 1, 4, 1))
        unit[0, axis] = 1.0
        axes.append(quotient(product(product(a, unit), conjugate)[:, 1:], square))
    change = a[1:] * np.arange(1, _ORDERS + 1)[:, None, None]
    rate = quotient(2.0 * product(conjugate, change)[:, 1:], square[:-1])
    return [a, *axes, rate]


def draw():
    knots = np.array([0.0, 0.5, 1.0])
    data = np.array([derivatives(t) for t in knots])
    choice = hodograph.HermiteChoice.order_six
    path = hodograph.hermite_path(knots, data, choice=choice)
    alone = hodograph.hermite_path(knots[1:], data[1:], choice=choice)
    made, axes = figure(3, 5, width=11, height=6)
    names = ("preimage A", "tangent e₁", "e₂", "e₃", "angular velocity χ")
    left, right = np.linspace(0.0, np.nextafter(0.5, 0.0), 160), np.linspace(0.5, 1.0, 160)
    before, after = quantities(path, left), quantities(path, right)
    by_itself = quantities(alone, right)
    for column, name in enumerate(names):
        jumps = []
        for order in range(_ORDERS):
            scale = [1.0, 1.0, 2.0, 6.0][order]
            jump = scale * np.abs(after[column][order][:, 0] - before[column][order][:, -1]).max()
            jumps.append(jump)
            if order > 2:
                break
            ax = axes[5 * order + column]
            ax.axvline(0.5, color="#8b99a6", linewidth=1.0, zorder=1)
            for series, xi in ((before, left), (after, right)):
                rows = scale * series[column][order]
                for row, colour in zip(rows, _COLOURS[len(rows)]):
                    ax.plot(xi, row, color=colour, linewidth=1.2)
            if order == 0:
                rows = by_itself[column][0]
                for row, colour in zip(rows, _COLOURS[len(rows)]):
                    ax.plot(right, row, color=colour, linewidth=1.0, linestyle=(0, (1, 1.5)))
                title(ax, name)
            if column == 0:
                ax.set_ylabel(("value", "first derivative", "second derivative")[order])
            ax.set_xticks([0, 0.5, 1])
            ax.set_xlim(0, 1)
        for ax in axes[10:]:
            ax.set_xlabel("ξ")
        print(f"{name}: jumps at the knot "
              + ", ".join(f"{jump:.5g}" if jump > 1e-6 else "0" for jump in jumps)
              + " (derivatives 0 to 3)")
    return made


if __name__ == "__main__":
    save(draw())
