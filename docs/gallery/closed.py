# SPDX-License-Identifier: MIT
"""The loops of the paper's examples, for the gallery."""

from __future__ import annotations

import numpy as np

import hodograph

EXAMPLE_1 = (1.0, 0.6 * np.pi)  #: xi and psi of Examples 1 to 3
EXAMPLE_4 = (-1.0, 0.1 * np.pi)


def loop(xi, psi, length=1.0):
    """A member of the family: at the origin, tangent i, principal normal j."""
    return hodograph.closed_loop(xi=xi, psi=psi, length=length)


def absolute_twist(path, gamma):
    """Of the periodic rational frame with gamma."""
    twist = hodograph.frame_twist(path, hodograph.periodic_roll(path, gamma)).absolute
    return 0.5 * (twist.lower + twist.upper)


def swept(path, gamma, length):
    """The surface that the planar oval of a length sweeps along the path, as a mesh."""
    oval = loop(0.0, np.pi, length)  # in the plane of i and j: its preimage is a + k b
    planar = hodograph.Path(oval.knots, oval.starts[:, :2], oval.preimages[..., [0, 3]],
                            closed=True)
    middle = np.array([0.0, length / (2.0 * np.pi)])
    profile = hodograph.Profile.of(hodograph.moved(planar, translation=-middle))
    motion = hodograph.Motion.along(path, hodograph.periodic_roll(path, gamma))
    return hodograph.mesh_of(hodograph.Sweep(motion, profile), tolerance=2e-3)
