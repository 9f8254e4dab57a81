#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The thickest tube about a knot

A trefoil knot, fitted as a closed path, with the largest tube that does not touch itself. Its
radius, the reach of the path, is enclosed. Here two strands come near each other, at the dots;
where a path is bent more than that it would be the least radius of curvature.
"""

import numpy as np
from gallery import ORANGE, bare, figure, save, view

import hodograph
from hodograph import plots


def trefoil():
    t = np.linspace(0.0, 2.0 * np.pi, 241)
    radius = 2.0 + np.cos(3.0 * t)
    points = np.stack([radius * np.cos(2.0 * t), radius * np.sin(2.0 * t), np.sin(3.0 * t)], axis=-1)
    return hodograph.fit(points, 1e-4, parameters=t, periodic=True).path


def draw():
    path = trefoil()
    tube = hodograph.largest_tube_radius(path)
    motion = hodograph.Motion.along(path, hodograph.least_twist_roll(path))
    profile = hodograph.Profile.circle(tube.radius.lower)
    mesh = hodograph.mesh_of(hodograph.Sweep(motion, profile), tolerance=0.015)
    made, (left, right) = figure(1, 2, width=9.5, height=4.6, spatial=True)
    left.view_init(elev=42, azim=-60)
    plots.surface(mesh, left)
    view(left, 42, -60, 1.35)
    plots.path(path, right, linewidth=2.0)
    if tube.distance is not None:
        right.plot(*path.position(tube.distance.xi).T, "o-", color=ORANGE, markersize=4,
                   linewidth=1.0)
    view(right, 42, -60, 1.35)
    bare(left)
    bare(right)
    print(f"{path.segment_count} segments, length {path.arc_length():.6f}; largest radius "
          f"{tube.radius.lower:.6f}, limited by {tube.limit.name}; least radius of curvature "
          f"{1.0 / tube.curvature.upper:.6f}")
    facts = hodograph.facts_of(mesh.mesh)
    exact = 2.0 * np.pi * tube.radius.lower * path.arc_length()
    print(f"area of the mesh {facts.area:.3f}, of the tube {exact:.3f}; closed: {facts.is_closed}, "
          f"Euler characteristic {facts.euler_characteristic}")
    return made


if __name__ == "__main__":
    save(draw())
