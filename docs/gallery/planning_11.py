#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 11: curvature of the three ways

The rounded polyline bends at its corners alone, up to the limit 5 (dashed), continuously. The paths
by the rules T1 and T2 have room to bend less here, since the polyline's legs are long; their
curvature jumps at its points.
"""

import numpy as np
from gallery import ORANGE, figure, save, title
from planning_10 import plans

import hodograph
from hodograph import plots


def draw():
    _, plan, (t1, t2) = plans()
    made, axes = figure(3, 1, width=8.5, height=6.2)
    for ax, name, path in zip(axes, ("G² corners", "rule T1", "rule T2"),
                              (plan.path, t1.path, t2.path)):
        plots.profile(path, lambda xi, path=path: np.abs(hodograph.curvature(path, xi)), ax,
                      name="|curvature|", linewidth=1.2)
        ax.axhline(5.0, color=ORANGE, linewidth=0.9, linestyle=(0, (6, 4)))
        ax.set(ylim=(0, 5.8), xlim=(0, path.arc_length()))
        title(ax, name)
    for ax in axes[:2]:
        ax.set_xlabel("")
    print(f"G² corners: largest curvature {plan.certificate.curvature.upper:.6f}")
    for name, one in (("rule T1", t1), ("rule T2", t2)):
        print(f"{name}: largest curvature {one.certificate.curvature.upper:.6f}, jumps by up to "
              f"{one.curvature_jump:.6f}")
    return made


if __name__ == "__main__":
    save(draw())
