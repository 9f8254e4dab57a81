# SPDX-License-Identifier: MIT
"""Everything a follower of a path asks at a parameter, in one evaluation."""

from __future__ import annotations

from typing import NamedTuple

import numpy
from numpy.typing import ArrayLike, NDArray

from ._core import Path


class PathState(NamedTuple):
    """The state of a path at one parameter or at many; see evaluate()."""

    position: NDArray[numpy.float64]
    frame: NDArray[numpy.float64]
    body_rate_per_xi: NDArray[numpy.float64] | float
    speed: NDArray[numpy.float64] | float
    arc_length: NDArray[numpy.float64] | float


def evaluate(path: Path, xi: ArrayLike) -> PathState:
    """Position (..., d), Euler-Rodrigues frame (..., d, d) with the axes as columns, its angular
    velocity per unit xi in body components, speed and arc length at xi.

    Raises HodographError: outside_domain, zero_speed.
    """
    return PathState(*path._state(xi))
