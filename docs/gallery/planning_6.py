#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 6: largest curvature over length

The largest curvature of the paths above for every length from 1.05 to 4; the paper's figure ends at
1.6 (dotted line). It falls on all of the paper's range, by more than half after 1.3, where the
paper sees "only marginal reduction". Its first minimum is near S = 2.26; much longer paths bend
less again.
"""

import numpy as np
from gallery import ORANGE, direction, figure, largest_curvature, save
from planning_5 import of_length

import hodograph


def draw():
    made, (ax,) = figure(width=6.2, height=3.6)
    lengths = np.linspace(1.05, 4.0, 296)
    most = np.array([largest_curvature(of_length(s)) for s in lengths])
    ax.plot(lengths, most, linewidth=1.6)
    least = hodograph.least_peak_curvature_of_length(
        [0, 0], direction(np.pi / 3), [1, 0], direction(-3 * np.pi / 4), 3.0)
    length = least.curve.arc_length()
    ax.plot(length, least.peak_curvature.upper, "o", color=ORANGE, markersize=5)
    ax.annotate(f"{least.peak_curvature.upper:.4f} at S = {length:.4f}",
                (length, least.peak_curvature.upper), xytext=(0, 10), textcoords="offset points",
                fontsize=8, ha="center")
    ax.axvline(1.6, color="#51606e", linewidth=0.8, linestyle=(0, (1, 2)))
    ax.set(xlabel="arc length S", ylabel="largest |curvature|", yscale="log", xlim=(1.0, 4.0))
    ax.set_yticks([3, 5, 10, 20, 50], ["3", "5", "10", "20", "50"])
    ax.minorticks_off()
    for s in (1.3, 1.6):
        print(f"S = {s}: largest curvature {largest_curvature(of_length(s)):.6f}")
    print(f"least below S = 3: {least.peak_curvature.upper:.4f} at S = {length:.4f}")
    return made


if __name__ == "__main__":
    save(draw())
