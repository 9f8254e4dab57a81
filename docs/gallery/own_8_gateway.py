#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Few segments where little happens

The knots of the adaptive fit of the Gateway's orbit, one revolution to 0.4 m: most of the segments
are spent on the short time at the Moon. Right, the errors of all segments, below the tolerance
(dashed) each.
"""

import numpy as np
from gallery import GREY, ORANGE, figure, save, view
from gateway import MOON, UNIT, ball, fitted

import hodograph
from hodograph import plots


def draw():
    fit = fitted(hodograph.OrbitFrame.rotating)
    system = hodograph.earth_moon_system
    path = hodograph.scaled(
        hodograph.moved(fit.path, translation=[-(1.0 - system.mass_ratio), 0.0, 0.0]), UNIT)
    made, (left, right) = figure(1, 2, width=9.5, height=4.6, spatial={0}, width_ratios=[1, 1.1])
    plots.path(path, left, knots=True, unit="1000 km")
    ball(left, np.zeros(3), MOON, "#b9c3cc", 10)
    view(left, 16, -50, 1.0)
    errors = fit.segment_errors * UNIT * 1e6
    knots = np.asarray(path.knots)
    right.stairs(errors, knots, color=GREY, linewidth=1.4)
    right.axhline(1e-9 * UNIT * 1e6, color=ORANGE, linewidth=0.9, linestyle=(0, (6, 4)))
    right.set(yscale="log", xlabel="revolutions", ylabel="error of the segment / m", xlim=(0, 1))
    steps = np.diff(knots)
    print(f"{path.segment_count} segments of {steps.min():.6f} to {steps.max():.6f} revolutions; "
          f"largest error {errors.max():.3f} m of {UNIT * 1e-3:.3f} m allowed")
    return made


if __name__ == "__main__":
    save(draw())
