#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Closed loops, Figure 5: Frenet frame and Euler-Rodrigues frame

The loop of Example 1 (ψ = 0.6π, ξ = 1, length 1) with its Frenet frame, left, and its
Euler-Rodrigues frame, right, which does not return to itself: it has rolled by 2ψ. The dot is where
the loop closes.
"""

import numpy as np
from closed import EXAMPLE_1, loop
from gallery import bare, figure, save, title, view

import hodograph
from hodograph import plots


def draw():
    path = loop(*EXAMPLE_1)
    made, axes = figure(1, 2, width=9.5, height=4.2, spatial=True)
    for ax, roll, name in zip(axes, (hodograph.frenet_roll(path), None),
                              ("Frenet", "Euler-Rodrigues")):
        plots.frames(path, ax, frame=roll, count=90, length=0.06, which=(2, 3), linewidths=0.8)
        ax.plot(*path.position(path.xi_begin), "o", color="#1b2733", markersize=4)
        view(ax, 28, -58, 1.4)
        bare(ax)
        title(ax, name)
    twist = hodograph.frame_twist(path, hodograph.FrameRoll.none(path)).total
    last = hodograph.euler_rodrigues_frame(path, path.xi_end)
    first = hodograph.euler_rodrigues_frame(path, path.xi_begin)
    cosine, sine = first[:, 1] @ last[:, 1], first[:, 2] @ last[:, 1]
    print(f"twist of the Euler-Rodrigues frame {0.5 * (twist.lower + twist.upper):.6f} rad; "
          f"it comes back rolled by {np.degrees(np.arctan2(sine, cosine)):.4f} degrees")
    return made


if __name__ == "__main__":
    save(draw())
