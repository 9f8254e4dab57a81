#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 9: corners

A corner of two lines rounded by one quintic that meets both with curvature zero, for turning angles
of 45°, 90° and 135°, with legs of length L. Right, their curvature for L = 1: one peak, in the
middle.
"""

import numpy as np
from gallery import GREY, bare, direction, figure, legend, save

import hodograph
from hodograph import plots


def draw():
    made, (left, right) = figure(1, 2, width=10, height=3.2, width_ratios=[1.8, 1])
    for k, degrees in enumerate((45, 90, 135)):
        corner = np.array([2.3 * k, 0.0])
        points = [corner - [1.0, 0.0], corner, corner + direction(np.radians(degrees))]
        path = hodograph.rounded_polyline_of_legs(points, [1.0])
        left.plot(*np.transpose(points), color=GREY, linewidth=0.8, linestyle=(0, (4, 3)))
        plots.path(path, left, color=plots.COLOURS[k])
        left.annotate(f"θ = {degrees}°", corner - [1.0, 0.0], xytext=(0, -14),
                      textcoords="offset points", fontsize=9)
        plots.profile(path, ax=right, color=plots.COLOURS[k], label=f"{degrees}°")
        middle = path.position(0.5 * (path.xi_begin + path.xi_end))
        peak = hodograph.curvature(path, 0.5 * (path.xi_begin + path.xi_end))
        print(f"{degrees}°, L = 1: peak curvature {peak:.6f}, length {path.arc_length():.6f}, "
              f"misses the corner by {np.linalg.norm(middle - corner):.6f}")
    left.set_ylim(-0.4, 1.1)
    bare(left)
    legend(right)
    return made


if __name__ == "__main__":
    save(draw())
