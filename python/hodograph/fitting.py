# SPDX-License-Identifier: MIT
"""fit(): a path within a tolerance of a callable, an array of samples or a SciPy spline."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._core import Enclosure, FitKnots, HermiteChoice, Path
from .errors import HodographError

_ORDERS = 5  # position and four derivatives


@dataclass(frozen=True)
class Fit:
    """A fitted path and how far it is from the curve."""

    path: Path
    error: Enclosure  #: of the whole path; an estimate from samples unless ``certified``
    certified: bool
    at_xi: float  #: where the error is about largest
    segment_errors: NDArray[numpy.float64]  #: the upper end for every segment


def _refuse(sentence: str, quantity: str) -> HodographError:
    return HodographError(sentence, "outside_domain", None, quantity)


def _is_scipy_spline(curve: Any) -> bool:
    return callable(curve) and callable(getattr(curve, "derivative", None))


def _derivatives_of_spline(spline: Any) -> Callable[[float], NDArray[numpy.float64]]:
    orders = [spline] + [spline.derivative(order) for order in range(1, _ORDERS)]
    return lambda xi: numpy.array([order(xi) for order in orders], dtype=float)


def fit(curve: Any, tolerance: float, begin: float | None = None, end: float | None = None, *,
        parameters: ArrayLike | None = None, periodic: bool = False,
        choice: HermiteChoice = HermiteChoice.order_ten,
        knots: FitKnots = FitKnots.adaptive, segments: int = 0,
        most_segments: int = 200_000) -> Fit:
    """A spatial C4 path of degree 17 within ``tolerance`` of a curve.

    ``curve`` is one of
      - a callable: curve(xi) returns position and four derivatives with respect to xi, shape
        (5, 3); ``begin`` and ``end`` are needed. The error is an estimate from samples.
      - an array of samples, shape (n, 3), at ``parameters`` (n,), by default 0, 1, ..., n - 1. They
        are interpolated by a C4 quintic spline; the error against that spline is certified.
      - a SciPy spline (BSpline, make_interp_spline, PPoly and the like) with values of shape (3,);
        it should be C4, of degree 5 at least.

    With ``segments`` > 0 so many equal segments are made, whatever the error.
    Raises HodographError; whatever a callable raises is passed on.
    """
    if callable(curve):
        gamma = curve
        if _is_scipy_spline(curve):
            gamma = _derivatives_of_spline(curve)
            axis = getattr(curve, "t", None)
            degree = getattr(curve, "k", 0)
            if axis is not None:
                begin = float(axis[degree]) if begin is None else begin
                end = float(axis[-degree - 1]) if end is None else end
            elif getattr(curve, "x", None) is not None:
                begin = float(curve.x[0]) if begin is None else begin
                end = float(curve.x[-1]) if end is None else end
        if begin is None or end is None:
            raise _refuse("a callable is fitted from `begin` to `end`; give both", "begin")
        if parameters is not None:
            raise _refuse("`parameters` belong to samples, not to a callable", "parameters")
        made = _core._fit_function(gamma, begin, end, tolerance, choice, knots, segments,
                                   most_segments, periodic)
    else:
        samples = numpy.asarray(curve, dtype=float)
        if begin is not None or end is not None:
            raise _refuse("samples are fitted over all their parameters; leave out begin and end",
                          "begin")
        if parameters is None:
            parameters = numpy.arange(len(samples) if samples.ndim else 0, dtype=float)
        made = _core._fit_samples(parameters, samples, periodic, tolerance, choice, knots,
                                  segments, most_segments)
    return Fit(**made)
