#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 5: ascents that follow the orbit, as published

The optimal control problem (25) of the paper from five places of the Moon's surface: minimise the
distance from the orbit's moving point. Left, the ways to the orbit; right, distance from the orbit,
angle to its tangent, and speed over the parameter (one revolution is 1). There is no gravity in
this problem, and every start ends 29 km from the orbit.
"""

import numpy as np
from gallery import figure, legend, save, view
from gateway import MOON, UNIT, ball

import hodograph
from hodograph import plots

_STARTS = ("+z", "-z", "-y", "+y", "+x")
_SHOWN = (0.485, 0.515)  # the part of the orbit in the picture, near the Moon


def draw():
    reference = hodograph.AscentReference.gateway()
    moon = np.asarray(reference.moon)
    made = figure(1, 1, width=10, height=5.6)[0]
    made.clear()
    grid = made.add_gridspec(3, 2, width_ratios=[1.25, 1])
    space = plots.style(made.add_subplot(grid[:, 0], projection="3d"))
    rows = [plots.style(made.add_subplot(grid[row, 1])) for row in range(3)]
    ball(space, np.zeros(3), MOON, "#b9c3cc", 14)
    for name, colour in zip(_STARTS, plots.COLOURS):
        ascent = hodograph.tracking_ascent(reference, hodograph.ascent_start(name), guesses=1)
        way = (np.asarray(ascent.position) - moon) * UNIT
        near = np.asarray(ascent.xi) <= _SHOWN[1]
        space.plot(*way[near].T, color=colour, linewidth=1.6, label=name)
        xi = np.asarray(ascent.xi)
        for ax, values in zip(rows, (ascent.position_error_km, np.degrees(ascent.orientation_error),
                                     np.asarray(ascent.speed) * ascent.speed_unit_m_s / 1000.0)):
            ax.plot(xi, values, color=colour, linewidth=1.3)
        print(f"{name}: objective {ascent.solved.objective:.4e}, "
              f"{ascent.end_error_km:.1f} km from the orbit in the end")
    orbit = hodograph.scaled(hodograph.moved(reference.path, translation=-moon), UNIT)
    plots.path(hodograph.subpath(orbit, *_SHOWN), space, color="#1b2733", linewidth=1.2,
               linestyle=(0, (4, 3)), label="orbit", unit="1000 km")
    for ax, name in zip(rows, ("distance / km", "angle / °", "speed / (km/s)")):
        ax.set_ylabel(name)
    rows[0].set_yscale("log")
    rows[2].set_xlabel("revolutions")
    view(space, 18, -35, 1.0)
    legend(space, loc="upper left")
    return made


if __name__ == "__main__":
    save(draw())
