# SPDX-License-Identifier: MIT
"""Profiles: what varies along a path, over its arc length or its parameter."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy

from .. import _core
from . import _drawing
from ._paths import _one_sided_parameters

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_JUMP = 1e-3  # of the range of the values: a jump at a knot that is drawn as a gap

_NAMES = {"speed": "speed", "curvature": "curvature", "torsion": "torsion",
          "angular_velocity": "angular velocity per arc length"}


def _values(path: _core.Path, quantity: str | Callable[[numpy.ndarray], numpy.ndarray],
            xi: numpy.ndarray) -> numpy.ndarray:
    if callable(quantity):
        values = numpy.asarray(quantity(xi), dtype=float)
        if values.shape[:1] != xi.shape or values.ndim > 2:
            raise _drawing.refuse(f"`quantity` returns an array of shape ({len(xi)},) or "
                                  f"({len(xi)}, k) here, not {values.shape}", "quantity")
        return values
    if quantity == "speed":
        return path.speed(xi)
    if quantity == "curvature":
        return _core.curvature(path, xi)
    if quantity == "torsion":
        return _core.torsion(_drawing.a_path(path, spatial=True), xi)
    if quantity == "angular_velocity":
        return _core.body_rate_per_arc_length(path, xi)
    raise _drawing.refuse(f"`quantity` is {', '.join(map(repr, _NAMES))} or a callable, not "
                          f"{quantity!r}", "quantity")


def profile(path: Any, quantity: str | Callable[[numpy.ndarray], numpy.ndarray] = "curvature",
            ax: Axes | None = None, *, over: str = "arc_length", knots: bool = False,
            relative: bool = False, name: str | None = None, unit: str = "", **line: Any) -> Axes:
    """Draws a quantity along a path, and returns the axes.

    ``quantity`` is "speed" (with respect to xi), "curvature" (signed in the plane), "torsion",
    "angular_velocity" (of the Euler-Rodrigues frame, per arc length: one line for each component
    in the frame), or a callable from parameters (n,) to values (n,) or (n, k). Drawn over
    "arc_length", as part of the whole if ``relative``, or over "xi". ``knots`` draws thin lines
    there. Where a quantity jumps at a knot, the line is broken. ``unit`` is the unit of length.
    """
    path = _drawing.a_path(path)
    ax = _drawing.axes_for(ax, spatial=False)
    if over not in ("arc_length", "xi"):
        raise _drawing.refuse(f"profiles are drawn over 'arc_length' or 'xi', not {over!r}", "over")
    xi = _one_sided_parameters(path)
    values = _values(path, quantity, xi)

    def axis_of(at: numpy.ndarray) -> numpy.ndarray:
        along = path.arc_length(at) if over == "arc_length" else at
        if not relative:
            return along
        begin, end = axis_range
        return (along - begin) / (end - begin)

    axis_range = (0.0, path.arc_length()) if over == "arc_length" else (path.xi_begin, path.xi_end)
    along = axis_of(xi)
    # Before every inner knot there is the value from its left: break the line where it jumps.
    left = numpy.flatnonzero(numpy.isin(xi, numpy.asarray(path.knots)[1:-1])) - 1
    size = numpy.ptp(values, axis=0)
    jumps = numpy.abs(values[left + 1] - values[left]) > _JUMP * size
    breaks = left[jumps if jumps.ndim == 1 else jumps.any(axis=1)] + 1
    along = numpy.insert(along, breaks, numpy.nan)
    values = numpy.insert(values, breaks, numpy.nan, axis=0)
    table = values.reshape(len(along), -1)
    labels = [None] if table.shape[1] == 1 else [f"{k + 1}" for k in range(table.shape[1])]
    if quantity == "angular_velocity" and table.shape[1] == 3:
        labels = ["about e1", "about e2", "about e3"]
    for k, label in enumerate(labels):
        options = _drawing.line_options(line)
        if len(labels) > 1:
            options = _drawing.line_options(
                line, color=_drawing.FRAME_COLOURS[k % 3] if len(labels) == 3
                else _drawing.COLOURS[k % 6], label=label)
        ax.plot(along, table[:, k], **options)
    if knots:
        for at in axis_of(numpy.asarray(path.knots)[1:-1]):
            ax.axvline(at, color=_drawing.QUIET, linewidth=0.6, zorder=0.5)
    if over == "xi":
        bottom = "parameter"
    else:
        bottom = "arc length" + (" / whole" if relative else f" / {unit}" if unit else "")
    side = name or (_NAMES.get(quantity, "") if isinstance(quantity, str) else "")
    if unit and name is None and quantity in ("curvature", "torsion", "angular_velocity"):
        side += f" / (1/{unit})"
    _drawing.label_axes(ax, (bottom, side))
    return ax
