#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""PHODCOS, Figure 2 A: one, two and eight segments

Curve (23), dashed, and the C⁴ paths of degree 17 through its Hermite data on one, two and eight
uniform segments, with the choice of the paper (`HermiteChoice.order_six`), drawn as their
Euler-Rodrigues frames: tangent orange, e₂ blue, e₃ green. Above in space, below from the side and
from above. The errors are those of the paper's Table 1.
"""

import numpy as np
from curve23 import derivatives, points
from gallery import bare, figure, largest_difference, legend, save, title, view

import hodograph
from hodograph import plots

_PER_SEGMENT = 50  # the paper takes errors at so many parameters of a segment


def draw():
    made, axes = figure(3, 3, width=9, height=8.2, spatial={0, 1, 2},
                        height_ratios=[1.35, 1.0, 1.1])
    whole = points(np.linspace(0.0, 1.0, 600))
    for k, count in enumerate((1, 2, 8)):
        knots = np.linspace(0.0, 1.0, count + 1)
        path = hodograph.hermite_path(knots, np.array([derivatives(t) for t in knots]),
                                      choice=hodograph.HermiteChoice.order_six)
        at = np.linspace(0.0, 1.0, _PER_SEGMENT * count + 1)
        error = largest_difference(path.position(at), points(at))
        name = f"{count} segment{'s' if count > 1 else ''}"
        print(f"{name}: error {error:.4g}, length {path.arc_length():.4f}")
        for row, plane in enumerate((None, "xz", "xy")):
            ax = axes[3 * row + k]
            shown = whole.T if plane is None else whole[:, ["xyz".index(c) for c in plane]].T
            ax.plot(*shown, color="#51606e", linewidth=1.0, linestyle=(0, (4, 3)), zorder=3,
                    label="curve (23)")
            plots.frames(path, ax, count=110, length=0.32, plane=plane, linewidths=0.6)
        view(axes[k], 22, -62, 1.3)
        bare(axes[k])
        title(axes[k], f"{name}, error {error:.3g}")
    for row in (1, 2):
        limits = np.array([(*axes[3 * row + k].get_xlim(), *axes[3 * row + k].get_ylim())
                           for k in range(3)])
        for k in range(3):
            axes[3 * row + k].set(xlim=(limits[:, 0].min(), limits[:, 1].max()),
                                  ylim=(limits[:, 2].min(), limits[:, 3].max()))
    legend(axes[0], loc="lower left", ncols=4, bbox_to_anchor=(0.0, -0.12), borderaxespad=0)
    return made


if __name__ == "__main__":
    save(draw())
