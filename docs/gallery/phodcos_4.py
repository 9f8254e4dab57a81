#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 4: the Gateway's orbit in the rotating frame

One revolution where Earth and Moon rest: in space, from the front (along x) and from the side
(along y), with the frame of the fitted path; the Moon in grey. Below, parametric speed and angular
velocity over the parameter, which counts revolutions from the lowest southern point. Lengths in
1000 km. The passage of the Moon takes hours of 7.008 days.
"""

import numpy as np
from gallery import BLUE, FRAME, figure, legend, save, title, view
from gateway import MOON, UNIT, ball, fitted

import hodograph
from hodograph import plots


def draw():
    fit = fitted(hodograph.OrbitFrame.rotating)
    system = hodograph.earth_moon_system
    to_moon = [-(1.0 - system.mass_ratio), 0.0, 0.0]
    path = hodograph.scaled(hodograph.moved(fit.path, translation=to_moon), UNIT)
    made = figure(1, 1, width=10, height=7.4)[0]
    made.clear()
    grid = made.add_gridspec(2, 6, height_ratios=[1.7, 1])
    space = plots.style(made.add_subplot(grid[0, :2], projection="3d"))
    plots.frames(path, space, count=160, length=9.0, linewidths=0.6)
    ball(space, np.zeros(3), MOON, "#b9c3cc", 10)
    view(space, 18, -50, 1.25)
    space.set(xlabel="", ylabel="", zlabel="")
    for k, plane in enumerate(("yz", "xz")):
        ax = plots.style(made.add_subplot(grid[0, 2 + 2 * k:4 + 2 * k]))
        plots.frames(path, ax, count=160, length=9.0, linewidths=0.6, plane=plane)
        ax.plot(0, 0, "o", color="#8b99a6", markersize=4, zorder=5)
    speed = plots.style(made.add_subplot(grid[1, :3]))
    xi = plots.parameters(path, 3000)
    speed.plot(xi, path.speed(xi), color=BLUE, linewidth=1.3)
    speed.set(xlabel="revolutions", xlim=(0, 1))
    title(speed, "speed / 1000 km per revolution")
    turning = plots.style(made.add_subplot(grid[1, 3:]))
    rates = hodograph.body_rate_per_xi(path, xi)
    for axis in range(3):
        turning.plot(xi, rates[:, axis], color=FRAME[axis], linewidth=1.3,
                     label=f"about e{axis + 1}")
    turning.set(xlabel="revolutions", xlim=(0, 1))
    title(turning, "angular velocity / rad per revolution")
    legend(turning)
    at = np.linspace(0.0, 1.0, 20001)
    print(f"{path.segment_count} segments, error below {fit.error.upper * UNIT * 1e6:.3f} m, "
          f"length {path.arc_length():.4f} thousand km, closed: {path.is_closed}")
    print(f"speed {path.speed(at).min():.3f} to {path.speed(at).max():.3f}, angular velocity up to "
          f"{np.linalg.norm(hodograph.body_rate_per_xi(path, at), axis=1).max():.3f}")
    near = np.linalg.norm(path.position(at), axis=1)
    print(f"distance from the Moon's centre {near.min():.3f} to {near.max():.3f} thousand km")
    return made


if __name__ == "__main__":
    save(draw())
