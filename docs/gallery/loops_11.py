#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 11: a tubular surface of loops

The loop of Example 1 moved through space: it is shifted along a quadratic, turned by a quaternion
polynomial and scaled by a quadratic, which makes a surface of rational patches whose cross-sections
are all C² loops.
"""

import numpy as np
from closed import EXAMPLE_1, loop
from gallery import ORANGE, bare, figure, save, view

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_1)
    motion = hodograph.Motion.polynomial(
        position=np.array([[0.0, 0.0, 0.0], [0.25, 0.35, 0.5], [0.1, 0.0, 1.0]]),
        rotation=np.array([[1.0, 0.0, 0.0, 0.0], [1.0, 0.2, 0.0, 0.5], [0.6, 0.1, 0.3, 0.9]]),
        scale=np.array([1.0, 0.35, 1.1]))
    sweep = hodograph.Sweep(motion, hodograph.Profile.in_space(path))
    mesh = hodograph.mesh_of(sweep, tolerance=1.5e-3)
    made, (ax,) = figure(width=6.4, height=5.4, spatial=True)
    ax.view_init(elev=18, azim=-50)
    plots.surface(mesh, ax)
    for v in np.linspace(0.0, 1.0, 7):
        state = motion.at(0, v)
        ring = path.position(np.linspace(0.0, 1.0, 200)) * state.scale @ np.transpose(state.frame)
        ax.plot(*(ring + state.position).T, color=ORANGE if v in (0.0, 1.0) else "#1b2733",
                linewidth=0.8, zorder=5)
    view(ax, 18, -50, 0.92)
    bare(ax)
    patches = hodograph.rational_patches(sweep)
    print(f"{len(patches)} rational patch{'es' if len(patches) != 1 else ''}; mesh within "
          f"{mesh.deviation:.4f} of the surface")
    return made


if __name__ == "__main__":
    save(draw())
