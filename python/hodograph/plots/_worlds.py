# SPDX-License-Identifier: MIT
"""A world of obstacles, and a plan in it: clearance band and circles of the turn radius."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy

from .. import _core
from . import _drawing
from ._paths import path as draw_path

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_SOLID, _EDGE, _OUTSIDE = "#d9dfe5", "#8b99a6", "#f3f5f7"
_SAME_PEAK = 1e-3  # of the largest curvature: peaks so near to it have their circle, too
_PEAK_SAMPLES, _PEAK_LEAST = 16000, 256


def _ring(points: Any) -> numpy.ndarray:
    ring = numpy.asarray(points, dtype=float)
    if ring.ndim != 2 or ring.shape[1] != 2 or len(ring) < 3:
        raise _drawing.refuse(f"a ring is an array of shape (n, 2), n at least 3, not "
                              f"{ring.shape}", "obstacles")
    return ring


def _rings_of(obstacle: Any) -> list[numpy.ndarray]:
    if hasattr(obstacle, "outer"):
        return [_ring(obstacle.outer)] + [_ring(hole) for hole in obstacle.holes]
    return [_ring(obstacle)]


def _add_polygon(ax: Axes, rings: list[numpy.ndarray], **options: Any) -> None:
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    parts = [Outline(numpy.vstack([ring, ring[:1]]), closed=True) for ring in rings]
    ax.add_patch(PathPatch(Outline.make_compound_path(*parts), **options))


def world(world: Any, ax: Axes | None = None, *, unit: str = "", **patch: Any) -> Axes:
    """Draws the obstacles of a World, or of an iterable of rings (n, 2), and returns the axes.

    Holes stay free; the bounds, where there are some, are a line. Keyword arguments go to the
    patches of the obstacles.
    """
    ax = _drawing.axes_for(ax, spatial=False)
    given: Iterable[Any] = getattr(world, "obstacles", world)
    rings = [_rings_of(obstacle) for obstacle in given]
    bounds = getattr(world, "bounds", None)
    options = {"facecolor": _SOLID, "edgecolor": _EDGE, "linewidth": 0.8, "zorder": 1.2, **patch}
    for obstacle in rings:
        _add_polygon(ax, obstacle, **options)
    if bounds is not None:
        _add_polygon(ax, [_ring(bounds)], facecolor="none", edgecolor=_EDGE, linewidth=1.2,
                     zorder=1.1)
    ax.autoscale_view()
    return _drawing.finished(ax, None, unit)


def _band(ax: Axes, path: _core.Path, distance: float, colour: Any, **options: Any) -> None:
    """The points at most so far from the path, as one patch with round joins and ends."""
    from matplotlib.collections import PolyCollection
    from matplotlib.patches import Circle

    xi = _drawing.parameters(path)
    points, tangents = path.position(xi), _core.tangent(path, xi)
    normals = numpy.stack([-tangents[:, 1], tangents[:, 0]], axis=-1) * distance
    left, right = points + normals, points - normals
    corners = numpy.stack([left[:-1], left[1:], right[1:], right[:-1]], axis=1)
    ax.add_collection(PolyCollection(corners, facecolors=colour, edgecolors=colour,
                                     linewidths=0.2, **options))
    if not path.is_closed:
        for end in points[[0, -1]]:
            ax.add_patch(Circle(end, distance, facecolor=colour, edgecolor="none", **options))


def band(path: Any, distance: float, ax: Axes | None = None, *, color: Any = "#d3e4f2",
         unit: str = "", **options: Any) -> Axes:
    """Draws the band of all points at most ``distance`` from a planar path, and returns the axes.

    Where it meets no obstacle the path keeps that clearance: drawn, not proven.
    """
    path = _drawing.a_path(path, spatial=False)
    if not distance > 0.0:
        raise _drawing.refuse(f"the band's distance is positive, not {distance}", "distance")
    ax = _drawing.axes_for(ax, spatial=False)
    _band(ax, path, distance, color, **{"zorder": 0.9, **options})
    ax.autoscale_view()
    return _drawing.finished(ax, None, unit)


def turn_circles(path: Any, ax: Axes | None = None, *, radius: float | None = None,
                 unit: str = "", **line: Any) -> Axes:
    """Draws the circles of curvature of a planar path where it is bent most, and returns the axes.

    ``radius`` draws circles of that size in their place, for comparison with a turn radius. A path
    without curvature has none.
    """
    path = _drawing.a_path(path, spatial=False)
    ax = _drawing.axes_for(ax, spatial=False)
    if radius is not None and not radius > 0.0:
        raise _drawing.refuse(f"the radius is positive, not {radius}", "radius")
    xi = _drawing.parameters(path, _PEAK_SAMPLES, _PEAK_LEAST)
    curvature = _core.curvature(path, xi)
    size = numpy.abs(curvature)
    peak = numpy.flatnonzero((size >= (1.0 - _SAME_PEAK) * size.max()) & (size > 0.0)
                             & (size >= numpy.append(size[1:], 0.0))
                             & (size > numpy.append(0.0, size[:-1])))
    options = _drawing.line_options(line, color=_drawing.COLOURS[1], linewidth=0.8,
                                    linestyle=(0, (4, 3)), zorder=1.6)
    round_about = numpy.linspace(0.0, 2.0 * numpy.pi, 97)
    tangents = _core.tangent(path, xi[peak])
    for place, tangent, bend in zip(path.position(xi[peak]), tangents, curvature[peak]):
        r = (1.0 / abs(bend) if radius is None else radius) * numpy.sign(bend)
        middle = place + r * numpy.array([-tangent[1], tangent[0]])
        ax.plot(middle[0] + r * numpy.cos(round_about), middle[1] + r * numpy.sin(round_about),
                **options)
    return _drawing.finished(ax, None, unit)


def plan(plan: Any, ax: Axes | None = None, *, world: Any = None, clearance: float | None = None,
         turn_radius: float | None = None, polyline: bool = False, unit: str = "",
         **line: Any) -> Axes:
    """Draws a plan (or any planar path) in its world, and returns the axes.

    ``clearance`` draws the band about the path that must stay free, ``turn_radius`` circles of
    that radius where the path is bent most, ``polyline`` what was rounded. Keyword arguments go to
    the path's line.
    """
    path = _drawing.a_path(plan, spatial=False)
    ax = _drawing.axes_for(ax, spatial=False)
    if world is not None:
        _draw_world(world, ax, unit=unit)
    if clearance:
        band(path, clearance, ax, unit=unit)
    if polyline:
        points = getattr(plan, "polyline", None)
        points = numpy.asarray(getattr(points, "points", points), dtype=float)
        if points.ndim != 2 or points.shape[1] != 2:
            raise _drawing.refuse("this plan has no polyline to draw", "polyline")
        ax.plot(*points.T, **_drawing.line_options({}, color=_drawing.QUIET, linewidth=0.8,
                                                   linestyle=(0, (1, 2)), zorder=1.8))
    if turn_radius is not None:
        turn_circles(path, ax, radius=turn_radius, unit=unit)
    draw_path(path, ax, unit=unit, **_drawing.line_options(line, color=_drawing.COLOURS[0]))
    ends = path.position([path.xi_begin, path.xi_end])
    ax.plot(*ends[0], "o", markersize=5, color=_drawing.COLOURS[0], markerfacecolor="white",
            zorder=3)
    ax.plot(*ends[1], "o", markersize=5, color=_drawing.COLOURS[0], zorder=3)
    return ax


_draw_world = world  # `plan` has a parameter of that name
