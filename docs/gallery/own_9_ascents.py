#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Ascents with gravity

From rest on the Moon's surface to the Gateway's orbit, with the velocity of the orbit there, in the
least time with a thrust of at most 5 m/s²: from the north pole and the far side. Three-body
dynamics; exact derivatives; the answers are followed again by another integrator.
"""

import numpy as np
from gallery import figure, legend, save, view
from gateway import MOON, UNIT, ball

import hodograph
from hodograph import plots

_STARTS = ("+z", "+x")
_SURFACE = 1740.0  # km, of the publication


def draw():
    reference = hodograph.AscentReference.gateway()
    made, (space, thrust) = figure(1, 2, width=10, height=4.6, spatial={0}, width_ratios=[1.2, 1])
    ball(space, np.zeros(3), MOON, "#b9c3cc", 16)
    for name, colour in zip(_STARTS, plots.COLOURS):
        ascent = hodograph.powered_ascent(
            reference, hodograph.ascent_start(name), guesses=1,
            objective=hodograph.PoweredObjective.least_time)
        way = np.asarray(ascent.position) / 1000.0
        space.plot(*way.T, color=colour, linewidth=1.8, label=name)
        push = np.asarray(ascent.thrust)
        space.quiver(*way[:-1:6].T, *(0.07 * push[::6].T), color=colour, linewidth=0.8,
                     arrow_length_ratio=0.2)
        height = np.linalg.norm(way, axis=1) * 1000.0 - _SURFACE
        thrust.plot(np.asarray(ascent.time_s) / 60.0, height, color=colour, label=name)
        print(f"{name}: {ascent.duration_s / 60:.2f} minutes, velocity change "
              f"{ascent.velocity_change_m_s:.1f} m/s")
    moon = np.asarray(reference.moon)
    orbit = hodograph.scaled(hodograph.moved(reference.path, translation=-moon), UNIT)
    near = hodograph.subpath(orbit, 0.49, 0.51)
    plots.path(near, space, color="#51606e", linewidth=1.0, linestyle=(0, (4, 3)), unit="1000 km")
    thrust.set(xlabel="time / min", ylabel="height / km", ylim=(0, None))
    legend(thrust)
    view(space, 16, -40, 1.1)
    return made


if __name__ == "__main__":
    save(draw())
