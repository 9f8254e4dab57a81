#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 3: planar data stay planar, motions and reversal commute

Curve (23) with y = 0, one segment. Left: its Hermite data (arrows) interpolated, and the
same data turned by a right angle about the y axis and shifted by (-1, 0, 2.5); moved back, dashed,
that path lies on the first. Right: the path through the reversed data runs the other way along the
same points; its frame differs in direction alone.
"""

import numpy as np
from curve23 import derivatives
from gallery import BLUE, GREEN, ORANGE, figure, largest_difference, legend, save, title, view

import hodograph
from hodograph import plots

_TURN = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])  # about y, by 90 degrees
_SHIFT = np.array([-1.0, 0.0, 2.5])
_SIGNS = np.array([1.0, -1.0, 1.0, -1.0, 1.0])[:, None]  # odd derivatives of a reversed curve


def interpolated(data):
    return hodograph.hermite_path([0.0, 1.0], data, choice=hodograph.HermiteChoice.order_six)


def arrows(ax, data, colour="#1b2733"):
    for point, velocity in data[:, :2]:
        ax.quiver(*point, *(0.07 * velocity), color=colour, linewidth=1.3, arrow_length_ratio=0.25)


def draw():
    data = np.array([derivatives(t) for t in (0.0, 1.0)])
    data[..., 1] = 0.0
    moved_data = data @ _TURN.T
    moved_data[:, 0] += _SHIFT
    original, transformed = interpolated(data), interpolated(moved_data)
    half = np.sqrt(0.5)
    back = hodograph.moved(hodograph.moved(transformed, translation=-_SHIFT),
                           rotation=[half, 0.0, -half, 0.0])
    reverse = interpolated(data[::-1] * _SIGNS)
    xi = plots.parameters(original)
    print(f"distance from the plane {abs(original.position(xi)[:, 1]).max():.1e}, "
          f"after the motion {abs(transformed.position(xi)[:, 1]).max():.1e}")
    print(f"moved back against the original: below 1e-12: "
          f"{largest_difference(back.position(xi), original.position(xi)) < 1e-12}")
    print(f"reversed against the original: below 1e-12: "
          f"{largest_difference(reverse.position(1 - xi), original.position(xi)) < 1e-12}")
    print(f"length {original.arc_length():.6f}")

    made = figure(1, 1, width=9.5, height=4.6)[0]
    made.clear()
    grid = made.add_gridspec(2, 2, width_ratios=[1.3, 1])
    space = plots.style(made.add_subplot(grid[:, 0], projection="3d", computed_zorder=False))
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
    corners = [(-2.0, 0, 0.4), (2.0, 0, 0.4), (2.0, 0, 4.3), (-2.0, 0, 4.3)]
    space.add_collection3d(Poly3DCollection([corners], facecolor="#fbf3d5", zorder=0))
    plots.path(original, space, color=BLUE, linewidth=2.6, label="original", zorder=2)
    plots.path(transformed, space, color=ORANGE, label="turned and shifted", zorder=2)
    plots.path(back, space, color=ORANGE, linestyle=(0, (4, 3)), label="moved back", zorder=3)
    arrows(space, data)
    arrows(space, moved_data)
    space.set(xlim=(-2.0, 2.0), ylim=(-0.7, 0.7), zlim=(0.4, 4.3), yticks=[0])
    space.set_box_aspect((4.0, 1.4, 3.9))
    view(space, 14, -66, 1.2)
    legend(space, loc="upper left")
    for row, (path, name) in enumerate(((original, "original"), (reverse, "reversed"))):
        ax = plots.style(made.add_subplot(grid[row, 1]))
        plots.path(path, ax, plane="xz", color=(BLUE, ORANGE)[row], arrows=3)
        plots.frames(path, ax, which=(1, 3), count=24, length=0.28, plane="xz", draw_path=False,
                     colours=("#8b99a6", BLUE, GREEN))
        title(ax, f"{name}: tangent grey, e₃ green")
    return made


if __name__ == "__main__":
    save(draw())
