#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Helical paths, Figure 2: families of climbs

From (0.5, 0.5, 0.5) to (1.5, 0.5, 1.7). Left, climb angles 0.18π, 0.20π, 0.22π and 0.24π: the
shallower, the longer. Right, all at 0.20π with six initial headings, −0.88π to −0.48π. Below, their
plans.
"""

import numpy as np
from gallery import BLUE, ORANGE, direction, figure, save, title, view

import hodograph
from hodograph import plots

_BEGIN, _END = np.array([0.5, 0.5, 0.5]), np.array([1.5, 0.5, 1.7])


def family(ax, cases):
    for angle, heading in cases:
        climb = hodograph.climb_curve(_BEGIN, direction(heading), _END, direction(np.pi / 3), angle)
        plots.path(climb.curve, ax, color=BLUE, linewidth=1.4)
        points = climb.curve.position(plots.parameters(climb.curve))
        ax.plot(points[:, 0], points[:, 1], np.zeros(len(points)), color=ORANGE, linewidth=1.2)
        yield climb
    view(ax, 24, -96, 0.95)


def draw():
    made, (left, right) = figure(1, 2, width=9, height=4.4, spatial=True)
    angles = np.array([0.18, 0.20, 0.22, 0.24]) * np.pi
    for angle, climb in zip(angles, family(left, [(a, -np.pi / 2) for a in angles])):
        print(f"climb angle {angle / np.pi:.2f} pi: length over ground {climb.ground_length:.4f}, "
              f"of the path {climb.curve.arc_length():.4f}")
    headings = np.array([-0.88, -0.80, -0.72, -0.64, -0.56, -0.48]) * np.pi
    for heading, climb in zip(headings, family(right, [(0.2 * np.pi, h) for h in headings])):
        print(f"initial heading {heading / np.pi:.2f} pi: rotation index over ground "
              f"{climb.rotation_index:.4f}")
    title(left, "climb angles")
    title(right, "initial headings")
    return made


if __name__ == "__main__":
    save(draw())
