# SPDX-License-Identifier: MIT
"""Convergence: errors over numbers of segments, or over steps, with their orders."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy
from numpy.typing import ArrayLike

from . import _drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def orders(counts: ArrayLike, errors: ArrayLike) -> numpy.ndarray:
    """The order between every two neighbours: -log(error ratio) / log(count ratio), (n - 1,)."""
    n, e = _table(counts, errors)
    return -numpy.diff(numpy.log(e)) / numpy.diff(numpy.log(n))


def _table(counts: ArrayLike, errors: ArrayLike) -> tuple[numpy.ndarray, numpy.ndarray]:
    n, e = numpy.asarray(counts, dtype=float), numpy.asarray(errors, dtype=float)
    if n.ndim != 1 or n.shape != e.shape or len(n) < 2:
        raise _drawing.refuse(f"`counts` and `errors` have one shape (n,), n at least 2, not "
                              f"{n.shape} and {e.shape}", "errors")
    if not (numpy.all(n > 0.0) and numpy.all(e > 0.0) and numpy.all(numpy.isfinite(n * e))):
        raise _drawing.refuse("logarithmic axes need counts and errors that are positive", "errors")
    if numpy.any(numpy.diff(n) == 0.0):
        raise _drawing.refuse("two neighbouring counts are equal: they have no order", "counts")
    return n, e


def convergence(counts: ArrayLike, errors: ArrayLike, ax: Axes | None = None, *,
                order: float | None = None, show_orders: bool = True, label: str | None = None,
                unit: str = "", **line: Any) -> Axes:
    """Draws errors over numbers of segments on logarithmic axes, and returns the axes.

    ``show_orders`` writes the order of the last two beside the last; with ``order`` a thin line of
    exactly that order goes through the last point. Other keyword arguments go to the line.
    """
    n, e = _table(counts, errors)
    ax = _drawing.axes_for(ax, spatial=False)
    ax.set_xscale("log", base=2)
    ax.set_yscale("log")
    drawn, = ax.plot(n, e, **_drawing.line_options(line, marker="o", markersize=4, label=label))
    colour = drawn.get_color()
    if order is not None:
        ends = n[[0, -1]]
        ax.plot(ends, e[-1] * (ends / n[-1]) ** -order, color=colour, linewidth=0.7,
                linestyle=(0, (5, 4)), zorder=1.5, scaley=False)
    if show_orders:
        ax.annotate(f"order {orders(n, e)[-1]:.2f}", (n[-1], e[-1]), xytext=(6, 0),
                    textcoords="offset points", color=colour, fontsize=8, va="center")
    _drawing.label_axes(ax, ("segments", f"largest error / {unit}" if unit else "largest error"))
    return ax
