# SPDX-License-Identifier: MIT
"""A user's program as mypy --strict reads it; api_test.py compares what it says with the comments.

A line with `# is: X` must have that type revealed, a line with `# error: X` that error, and no
other line an error.
"""

import numpy as np
from numpy.typing import NDArray

import hodograph
from hodograph import HodographError, Path, evaluate, fit


def halfway(path: Path) -> float:
    return path.parameter_at_arc_length(path.arc_length() / 2)


def largest_curvature(path: Path) -> float:
    grid = np.linspace(path.xi_begin, path.xi_end, 100)
    return float(np.abs(hodograph.curvature(path, grid)).max())


def helix(t: float) -> NDArray[np.float64]:
    c, s = np.cos(t), np.sin(t)
    return np.array([[c, s, t], [-s, c, 1], [-c, -s, 0], [s, -c, 0], [c, s, 0]])


path = hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4]], closed=False)
try:
    fitted = fit(helix, 1e-6, 0.0, 6.0, knots=hodograph.FitKnots.uniform)
except HodographError as error:
    reveal_type(error.index)  # is: Union[builtins.int, None]
    raise
print(halfway(path), largest_curvature(path), fitted.error.upper)

reveal_type(path.speed(0.5))  # is: builtins.float
reveal_type(path.speed(1))  # is: builtins.float
reveal_type(path.speed(np.zeros(3)))  # is: numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]
reveal_type(path.speed([0.0, 1.0]))  # is: numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]
reveal_type(path.arc_length())  # is: builtins.float
reveal_type(path.position(0.5))  # is: numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]
reveal_type(evaluate(path, 0.5).frame)  # is: numpy.ndarray[Any, numpy.dtype[numpy.floating[numpy._typing._64Bit]]]
reveal_type(hodograph.FitKnots.adaptive)  # is: hodograph._core.FitKnots
reveal_type(hodograph.reversed(path))  # is: hodograph._core.Path
reveal_type(hodograph.__version__)  # is: builtins.str

hodograph.nothing  # error: Module has no attribute "nothing"  [attr-defined]
path.degree = 3  # error: Property "degree" defined in "Path" is read-only  [misc]
hodograph.planar_spline([[0, 0], [1, 1]], closed="yes")  # error: Argument "closed" to "planar_spline" has incompatible type "str"; expected "bool"  [arg-type]
hodograph.scaled(path)  # error: Missing positional argument "factor" in call to "scaled"  [call-arg]
