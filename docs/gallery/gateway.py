# SPDX-License-Identifier: MIT
"""The Lunar Gateway's orbit as paths, and Earth and Moon, for the gallery. Lengths in 1000 km."""

from __future__ import annotations

import numpy as np

import hodograph
from hodograph import plots

UNIT = hodograph.earth_moon_system.length_unit_km / 1000.0
EARTH, MOON = 6.371, 1.7374  #: radii


def fitted(frame, revolutions=1, tolerance=1e-9):
    """The orbit's path, xi in revolutions, in units of the primaries' distance; and the fit."""
    curve = hodograph.OrbitCurve(hodograph.lunar_gateway_nrho(), frame=frame,
                                 parameter=hodograph.OrbitParameter.revolutions,
                                 revolutions=revolutions)
    return hodograph.fit(curve, tolerance, 0.0, float(revolutions),
                         periodic=frame == hodograph.OrbitFrame.rotating)


def ball(ax, middle, radius, colour, steps=24):
    """A shaded sphere."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 2 * steps + 1), np.linspace(0, np.pi, steps + 1))
    points = np.stack([np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)], axis=-1)
    vertices = np.asarray(middle) + radius * points.reshape(-1, 3)
    index = np.arange(vertices.shape[0]).reshape(u.shape)
    corner, right, below, across = (index[:-1, :-1], index[:-1, 1:], index[1:, :-1], index[1:, 1:])
    faces = np.concatenate([np.stack([corner, below, right], axis=-1).reshape(-1, 3),
                            np.stack([right, below, across], axis=-1).reshape(-1, 3)])
    plots.surface(vertices, ax, faces=faces, color=colour)
