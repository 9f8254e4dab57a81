# SPDX-License-Identifier: MIT
"""Rational PH curves from text, for the gallery."""

from __future__ import annotations

import numpy as np

import hodograph


def simplest(preimage, alpha, degree):
    """The space of curves -2 B/alpha with deg B at most degree, and its truly rational curve."""
    space = hodograph.solve(preimage, alpha, degree)
    return space, hodograph.RationalPhCurve.of_solution(space.preimage, space.alpha,
                                                        space.basis[0])


def rotated(a, axis):
    """A e A* for quaternions (n, 4) and a unit i, j or k (1, 2, 3), (n, 3)."""
    w, x, y, z = np.asarray(a).T
    columns = {1: (w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)),
               2: (2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)),
               3: (2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z)}
    return np.stack(columns[axis], axis=-1)
