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

from . import _optional
from ._core import *  # noqa: F401,F403
from ._core import __version__
from .errors import HodographError
from .fitting import Fit, fit
from .requests import answer, answer_lines
from .states import PathState, evaluate

_MODULES = {"errors", "fitting", "requests", "states"}  # whose names are the package's own
__all__ = sorted({name for name in dir() if not name.startswith("_")} - _MODULES
                 | set(_optional.NAMES) | {"__version__"})


def __getattr__(name: str):
    return _optional.load(name)


def __dir__():
    return __all__
