#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 4: fifteen separations

The separation of every pair of the six above over time, the three closest pairs named. All keep 1 %
of S (dashed), which is certified for every instant.
"""

import numpy as np
from gallery import figure, legend, save
from planning_3 import fleet

import hodograph
from hodograph import plots


def draw():
    together, length = fleet()
    made, (ax,) = figure(width=7.2, height=3.8)
    plots.separations(together.vehicles, ax, required=0.01 * length)
    ax.set_xlim(0, length)
    legend(ax, loc="upper left")
    matrix = hodograph.separation_matrix(together.vehicles)
    pairs = np.triu_indices(len(together.vehicles), 1)
    least = np.sort(matrix.lower[pairs]) / length
    print(f"{len(least)} pairs; least separations {least[0]:.6f} S, {least[1]:.6f} S, "
          f"{least[2]:.6f} S")
    print(f"pairs closer than 0.01 S: "
          f"{len(hodograph.close_pairs(together.vehicles, clearance=0.01 * length))}")
    return made


if __name__ == "__main__":
    save(draw())
