# SPDX-License-Identifier: MIT
"""A path, its curvature comb and its frames."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy

from .. import _core
from . import _drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_COMB_SHARE = 0.2  # of the largest side of the path's box: the longest tooth by default
_CURVED_SAMPLES, _CURVED_LEAST = 1600, 64  # curvature varies more than the path itself
_ARROW_SHAFT = 1e-3  # of the extent: an arrow is all head
_EDGE_ON = 0.05  # a tangent whose projection is shorter has no arrow head
_AXIS_SHARE = 0.08  # the same, for the axes of frames


def _extent(points: numpy.ndarray) -> float:
    return float(numpy.ptp(points, axis=0).max())


def _arrows(ax: Axes, path: _core.Path, count: int, shown: tuple[int, int] | None, colour: Any,
            size: float) -> None:
    """Arrow heads that show the direction, in the middle of `count` equal parts."""
    at = path.parameter_at_arc_length(path.arc_length() * (numpy.arange(count) + 0.5) / count)
    places, tangents = path.position(at), _core.tangent(path, at)
    if _drawing.is_spatial(ax):
        length = size * _extent(path.position(_drawing.parameters(path)))
        back = [(p, p - length * t) for p, t in zip(places, tangents)]
        for place, tail in back:  # two strokes in the normal plane that shows most of them
            side = numpy.cross(place - tail, numpy.eye(3)[numpy.abs(place - tail).argmin()])
            side *= 0.4 * length / numpy.linalg.norm(side)
            _drawing.segments(ax, list(numpy.array([tail + side, tail - side]).T),
                              list(numpy.array([place, place]).T), colors=[colour],
                              linewidths=1.2)
        return
    extent = _extent(path.position(_drawing.parameters(path)))
    x, y = _drawing.columns(places, ax, shown)
    u, v = _drawing.columns(tangents, ax, shown)
    for place, way in zip(zip(x, y), zip(u, v)):
        if numpy.hypot(*way) > _EDGE_ON:  # not where a projection looks along the path
            ax.annotate("", place, place - _ARROW_SHAFT * extent * numpy.array(way),
                        arrowprops={"arrowstyle": "-|>", "color": colour, "mutation_scale": 13,
                                    "linewidth": 0.0, "shrinkA": 0, "shrinkB": 0})


def path(path: Any, ax: Axes | None = None, *, knots: bool = False, arrows: int = 0,
         plane: str | None = None, unit: str = "", samples: int = 600, **line: Any) -> Axes:
    """Draws a path (or the path of a fit or plan) with equal scales, and returns the axes.

    ``knots`` marks the ends of the segments, ``arrows`` is a number of arrow heads along the path.
    A spatial path is drawn in space, or as its projection on ``plane``: "xy", "xz", "zy" and so on.
    ``unit`` stands in the labels; other keyword arguments go to the line.
    Raises HodographError: no path, axes of the wrong kind, not a plane.
    """
    path = _drawing.a_path(path)
    shown = _drawing.plane_of(plane, path.dimension)
    ax = _drawing.spatial_axes(ax, path.dimension, shown)
    points = path.position(_drawing.parameters(path, samples))
    options = _drawing.line_options(line, solid_joinstyle="round", solid_capstyle="round")
    drawn, = ax.plot(*_drawing.columns(points, ax, shown), **options)
    colour = drawn.get_color()
    if knots:
        at = numpy.asarray(path.knots)[:-1 if path.is_closed else None]
        places = _drawing.columns(path.position(at), ax, shown)
        ax.plot(*places, linestyle="none", marker="o", markersize=3.5, color=colour,
                markerfacecolor="white", markeredgewidth=1.0, zorder=drawn.get_zorder() + 0.1)
    if arrows:
        _arrows(ax, path, arrows, shown, colour, 0.03)
    return _drawing.finished(ax, shown, unit)


def _curvature_vectors(path: _core.Path, at: numpy.ndarray) -> numpy.ndarray:
    """The curvature times the normal towards the centre, (n, d)."""
    first, second = (_core.derivatives(path, at, order) for order in (1, 2))
    squared = numpy.sum(first * first, axis=-1, keepdims=True)
    if numpy.any(squared == 0.0):
        raise _drawing.refuse(f"the path stands still at xi = {at[squared[:, 0] == 0.0][0]}, where "
                              "it has no curvature", "path")
    along = numpy.sum(first * second, axis=-1, keepdims=True) / squared
    return (second - along * first) / squared


def curvature_comb(path: Any, ax: Axes | None = None, *, scale: float | None = None,
                   teeth: int = 120, plane: str | None = None, unit: str = "",
                   draw_path: bool = True, **line: Any) -> Axes:
    """Draws the curvature comb of a path: from every point a tooth of length ``scale`` times the
    curvature, away from the centre of curvature, and the line through their tips.

    ``scale`` is chosen so that the longest tooth is a fifth of the path's extent. ``teeth`` is
    their number, evenly spaced along the path; the keyword arguments go to the line of the tips.
    Where the curvature jumps, so does that line.
    """
    path = _drawing.a_path(path)
    shown = _drawing.plane_of(plane, path.dimension)
    ax = _drawing.spatial_axes(ax, path.dimension, shown)
    xi = _one_sided_parameters(path)
    points, bends = path.position(xi), _curvature_vectors(path, xi)
    largest = float(numpy.linalg.norm(bends, axis=-1).max())
    if scale is None:
        scale = _COMB_SHARE * _extent(points) / largest if largest > 0.0 else 1.0
    if teeth < 1:
        raise _drawing.refuse(f"a comb has one tooth at least, not {teeth}", "teeth")
    at = _drawing.even_parameters(path, teeth)
    feet = path.position(at)
    ends = feet - scale * _curvature_vectors(path, at)
    options = _drawing.line_options(line, color=_drawing.COLOURS[1], linewidth=1.0)
    if draw_path:
        ax.plot(*_drawing.columns(points, ax, shown),
                **_drawing.line_options({}, color=_drawing.COLOURS[0], zorder=2.5))
    _drawing.segments(ax, _drawing.columns(feet, ax, shown), _drawing.columns(ends, ax, shown),
                      colors=[options["color"]], linewidths=0.5, alpha=0.6)
    ax.plot(*_drawing.columns(points - scale * bends, ax, shown), **options)
    return _drawing.finished(ax, shown, unit)


def _one_sided_parameters(path: _core.Path) -> numpy.ndarray:
    """parameters(), with every inner knot once from each side."""
    xi = _drawing.parameters(path, _CURVED_SAMPLES, _CURVED_LEAST)
    inner = numpy.isin(xi, numpy.asarray(path.knots)[1:-1])
    repeated = numpy.repeat(xi, 1 + inner)
    first = numpy.flatnonzero(inner) + numpy.arange(inner.sum())
    repeated[first] = numpy.nextafter(repeated[first], -numpy.inf)
    return repeated


def _frame_of(path: _core.Path, frame: Any) -> Callable[[numpy.ndarray], numpy.ndarray]:
    if frame is None:
        return lambda xi: _core.euler_rodrigues_frame(path, xi)
    if callable(frame):
        return frame
    if not isinstance(frame, _core.FrameRoll):
        raise _drawing.refuse(f"`frame` is a FrameRoll or a callable, not {type(frame).__name__}",
                              "frame")
    return _core.RolledFrames(path, frame).at


def frames(path: Any, ax: Axes | None = None, *,
           frame: Any = None, count: int = 40,
           length: float | None = None, which: Sequence[int] = (1, 2, 3),
           plane: str | None = None, colours: Sequence[Any] = _drawing.FRAME_COLOURS,
           draw_path: bool = True, unit: str = "", **lines: Any) -> Axes:
    """Draws frames of a path at ``count`` points evenly spaced along it.

    ``frame`` is a FrameRoll, or a callable from parameters (n,) to matrices (n, d, d) with the axes
    as columns; by default it is the Euler-Rodrigues frame. ``which`` are the axes drawn: 1 is the
    tangent.
    ``length`` is theirs, by default a twelfth of the path's extent; further keyword arguments go
    to the collections of lines.
    """
    path = _drawing.a_path(path)
    shown = _drawing.plane_of(plane, path.dimension)
    wanted = tuple(which)
    if any(axis not in range(1, path.dimension + 1) for axis in wanted):
        raise _drawing.refuse(f"the axes of this frame are 1 to {path.dimension}, not {wanted}",
                              "which")
    if count < 1:
        raise _drawing.refuse(f"at least one frame is drawn, not {count}", "count")
    ax = _drawing.spatial_axes(ax, path.dimension, shown)
    points = path.position(_drawing.parameters(path))
    at = _drawing.even_parameters(path, count)
    matrices = numpy.asarray(_frame_of(path, frame)(at), dtype=float)
    if matrices.shape != (len(at), path.dimension, path.dimension):
        raise _drawing.refuse(f"`frame` returns an array of shape ({len(at)}, {path.dimension}, "
                              f"{path.dimension}) here, not {matrices.shape}", "frame")
    if length is None:
        length = _AXIS_SHARE * _extent(points)
    if draw_path:
        ax.plot(*_drawing.columns(points, ax, shown),
                **_drawing.line_options({}, color=_drawing.INK, linewidth=0.9))
    begin = path.position(at)
    for axis in wanted:
        end = begin + length * matrices[..., axis - 1]
        options = {"colors": [colours[axis - 1]], "linewidths": 0.9, "label": f"e{axis}", **lines}
        _drawing.segments(ax, _drawing.columns(begin, ax, shown),
                          _drawing.columns(end, ax, shown), **options)
    return _drawing.finished(ax, shown, unit)
