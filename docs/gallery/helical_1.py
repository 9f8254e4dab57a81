#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Helical paths, Figure 1: climbs of a given angle

Two helical quintics (blue) between given points and headings that climb at exactly 45° and 36°, and
the planar quintics of prescribed length below them (orange), whose lifting they are. Of the two
plans of that length the one that turns less is taken. The paper's rotation indices (1.454364,
5.360182) are half of ∫|κ| ds.
"""

import numpy as np
from gallery import BLUE, ORANGE, direction, figure, save, strokes, title, view

import hodograph
from hodograph import plots

#: climb angle, start, length over ground, headings: the two cases of section 7
CASES = ((np.pi / 4, 0.25, 1.12, np.pi / 4, np.pi / 3), 
         (np.pi / 5, 0.35, 1.24, -np.pi / 2, np.pi / 3))


def climb_and_plan(angle, start, length, heading, last):
    """The climb from (start, start, start) by length tan(angle), and its plan."""
    begin = np.full(3, start)
    end = begin + [1.0, 0.0, length * np.tan(angle)]
    climb = hodograph.climb_curve(begin, direction(heading), end, direction(last), angle)
    plan = hodograph.prescribed_length_curve(begin[:2], direction(heading), end[:2],
                                             direction(last), climb.ground_length)
    return climb, plan


def below(ax, climb, plan, height, **line):
    """The climb with its plan at a height and lines between them."""
    plots.path(climb.curve, ax, color=BLUE, **line)
    ground = hodograph.moved(hodograph.lifted(plan.curve), translation=[0.0, 0.0, height])
    plots.path(ground, ax, color=ORANGE, **line)
    xi = np.linspace(0.0, 1.0, 25)
    strokes(ax, climb.curve.position(xi), ground.position(xi), color="#8b99a6", linewidth=0.4)


def draw():
    made, axes = figure(1, 2, width=9, height=4.4, spatial=True)
    for ax, case in zip(axes, CASES):
        climb, plan = climb_and_plan(*case)
        below(ax, climb, plan, 0.0)
        view(ax, 22, -70, 1.0)
        title(ax, f"climb angle {np.degrees(case[0]):.0f}°")
        t = hodograph.tangent(climb.curve, np.linspace(0.0, 1.0, 101))
        w = hodograph.preimage(plan.curve, np.array([0.0, 1.0]))
        solutions = hodograph.prescribed_length_solutions(
            plan.curve.position(0.0), direction(case[3]), plan.curve.position(1.0),
            direction(case[4]), case[2])
        print(f"climb angle {np.degrees(np.arcsin(t[:, 2])).min():.6f} to "
              f"{np.degrees(np.arcsin(t[:, 2])).max():.6f} degrees, length over ground "
              f"{climb.ground_length:.6f}, w0 = {w[0, 0]:.6f} {w[0, 1]:+.6f} i")
        print("rotation indices of its plans: "
              + ", ".join(f"{one.rotation_index:.6f}" for one in solutions))
    return made


if __name__ == "__main__":
    save(draw())
