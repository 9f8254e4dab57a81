#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Order ten against order six

Errors of C⁴ paths through the Hermite data of curve (23) on 2ⁿ segments: the paper's choice of the
free parameters, of order six, and this library's, whose end frames are rotation-minimising and
which has no mean twist, of order ten. Dashed, lines of exactly these orders.
"""

import numpy as np
from curve23 import derivatives, points
from gallery import figure, largest_difference, legend, save

import hodograph
from hodograph import plots

_PER_SEGMENT = 50


def error(count, choice):
    knots = np.linspace(0.0, 1.0, count + 1)
    path = hodograph.hermite_path(knots, np.array([derivatives(t) for t in knots]), choice=choice)
    at = np.linspace(0.0, 1.0, _PER_SEGMENT * count + 1)
    return largest_difference(path.position(at), points(at))


def draw():
    made, (ax,) = figure(width=6.2, height=4.2)
    counts = 2 ** np.arange(8)
    for name, order in (("order_six", 6), ("order_ten", 10)):
        choice = getattr(hodograph.HermiteChoice, name)
        errors = np.array([error(count, choice) for count in counts])
        plots.convergence(counts, errors, ax, order=order, label=name)
        told = slice(3, -1)  # the last error of order ten is near rounding
        print(f"{name}: " + ", ".join(f"{n}: {e:.2e}" for n, e in zip(counts[told], errors[told])))
        print(f"{name}: orders "
              + ", ".join(f"{o:.2f}" for o in plots.orders(counts, errors)[told]))
    ax.set_ylim(1e-14, 10)
    legend(ax)
    return made


if __name__ == "__main__":
    save(draw())
