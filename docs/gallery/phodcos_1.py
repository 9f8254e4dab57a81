#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 1: a coordinate system along the Gateway's orbit

Four revolutions of the near-rectilinear halo orbit as seen from the Earth (green), in axes that do
not turn, with the frame of the fitted path: tangent orange, e₂ blue, e₃ green. Dashed, the Moon's
orbit. Lengths in 1000 km.
"""

import numpy as np
from gallery import figure, save, view
from gateway import EARTH, UNIT, ball, fitted

import hodograph
from hodograph import plots


def draw():
    fit = fitted(hodograph.OrbitFrame.earth_centred_inertial, 4, 1e-6)
    path = hodograph.scaled(fit.path, UNIT)
    made, (ax,) = figure(width=8, height=5, spatial=True)
    plots.frames(path, ax, count=420, length=45.0, linewidths=0.6)
    angle = np.linspace(0.0, 2.0 * np.pi, 361)
    ax.plot(UNIT * np.cos(angle), UNIT * np.sin(angle), 0.0 * angle, color="#8b99a6",
            linewidth=1.0, linestyle=(0, (5, 4)))
    ball(ax, np.zeros(3), 3.0 * EARTH, "#66b08c", 10)
    ax.set(xlabel="x", ylabel="y", zlabel="z")
    view(ax, 24, -60, 1.5)
    print(f"{path.segment_count} segments, error below {fit.error.upper * UNIT * 1000:.3f} km, "
          f"length {path.arc_length() / 1000:.6f} million km")
    return made


if __name__ == "__main__":
    save(draw())
