# SPDX-License-Identifier: MIT
"""Pythagorean-hodograph curves, paths and frames.

Paths whose arc length is an exact polynomial and whose moving frame is exact and twice
differentiable. Functions have the names they have in C++; parameters may be numbers or arrays of
any shape.
"""

try:
    import numpy as _numpy  # noqa: F401
except ImportError as error:  # pragma: no cover - tested in an interpreter without NumPy
    raise ImportError(
        "hodograph needs NumPy, which this Python lacks; install it (python3-numpy in Debian)"
    ) from error

from ._core import *  # noqa: F401,F403
from ._core import __version__
from .errors import HodographError
from .fitting import Fit, fit
from .states import PathState, evaluate

__all__ = [name for name in dir() if not name.startswith("_")] + ["__version__"]
