# SPDX-License-Identifier: MIT
"""A swarm: the ways of its vehicles, and how far every pair is apart at every time."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy

from . import _drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_TIMES = 400


def _motions(vehicles: Any) -> tuple[list[Any], list[str], list[float]]:
    """Motions (with position(t), start_time, end_time), names and radii of a swarm."""
    listed = list(getattr(vehicles, "vehicles", vehicles))
    if not listed:
        raise _drawing.refuse("a swarm has one vehicle at least", "vehicles")
    motions = [getattr(vehicle, "motion", vehicle) for vehicle in listed]
    for motion in motions:
        if not all(hasattr(motion, name) for name in ("position", "start_time", "end_time")):
            raise _drawing.refuse(f"a swarm is drawn from vehicles or timed motions, not "
                                  f"{type(motion).__name__}", "vehicles")
    names = [str(getattr(vehicle, "id", "") or k + 1) for k, vehicle in enumerate(listed)]
    return motions, names, [float(getattr(vehicle, "radius", 0.0)) for vehicle in listed]


def _places(motion: Any, times: numpy.ndarray) -> numpy.ndarray:
    return numpy.asarray(motion.position(times), dtype=float)


def swarm(vehicles: Any, ax: Axes | None = None, *, time: float | None = None,
          plane: str | None = None, labels: bool = True, unit: str = "", **line: Any) -> Axes:
    """Draws the ways of vehicles (or timed motions), and returns the axes.

    At ``time`` every vehicle is marked, by a circle of its radius where it has one. Ways in one
    horizontal plane are drawn in it, others in space or on ``plane``.
    """
    motions, names, radii = _motions(vehicles)
    ways = [_places(motion, numpy.linspace(motion.start_time, motion.end_time, _TIMES))
            for motion in motions]
    heights = numpy.concatenate([way[:, 2] for way in ways])
    flat = numpy.ptp(heights) == 0.0
    shown = _drawing.plane_of(plane or ("xy" if flat else None), 3)
    ax = _drawing.axes_for(ax, spatial=shown is None)
    for k, (motion, name, radius, way) in enumerate(zip(motions, names, radii, ways)):
        options = _drawing.line_options(line, color=_drawing.COLOURS[k % len(_drawing.COLOURS)],
                                        label=name if labels else None)
        ax.plot(*_drawing.columns(way, ax, shown), **options)
        start = _drawing.columns(way[:1], ax, shown)
        ax.plot(*start, linestyle="none", marker="o", markersize=4, color=options["color"],
                markerfacecolor="white")
        if time is None:
            continue
        place = _drawing.columns(_places(motion, numpy.array([time])), ax, shown)
        if radius > 0.0 and shown is not None:
            from matplotlib.patches import Circle

            ax.add_patch(Circle((place[0][0], place[1][0]), radius, facecolor=options["color"],
                                alpha=0.35, edgecolor=options["color"], zorder=2.6))
        ax.plot(*place, linestyle="none", marker="o", markersize=4, color=options["color"],
                zorder=2.7)
    return _drawing.finished(ax, shown, unit)


def separations(vehicles: Any, ax: Axes | None = None, *, required: float | None = None,
                highlight: int = 3, samples: int = 600, unit: str = "", time_unit: str = "",
                **line: Any) -> Axes:
    """Draws the distance of every pair over time, and returns the axes.

    A pair has a line over the time that both are on their way. The ``highlight`` pairs that come
    closest are coloured and named, the others grey; ``required`` is drawn as a level.
    """
    motions, names, _ = _motions(vehicles)
    if len(motions) < 2:
        raise _drawing.refuse("one vehicle alone has no separations", "vehicles")
    ax = _drawing.axes_for(ax, spatial=False)
    lines = []
    for i, j in combinations(range(len(motions)), 2):
        begin = max(motions[i].start_time, motions[j].start_time)
        end = min(motions[i].end_time, motions[j].end_time)
        if begin >= end:
            continue
        times = numpy.linspace(begin, end, samples)
        apart = numpy.linalg.norm(_places(motions[i], times) - _places(motions[j], times), axis=1)
        lines.append((float(apart.min()), f"{names[i]} and {names[j]}", times, apart))
    lines.sort(key=lambda each: each[0])
    for k, (_, name, times, apart) in reversed(list(enumerate(lines))):
        named = k < highlight
        options = _drawing.line_options(
            line, color=_drawing.COLOURS[k % 6] if named else "#b9c3cc",
            linewidth=1.4 if named else 0.8, zorder=2.5 if named else 2.0,
            label=name if named else None)
        ax.plot(times, apart, **options)
    if required is not None:
        ax.axhline(required, color=_drawing.INK, linewidth=0.9, linestyle=(0, (6, 4)), zorder=1.9)
    ax.set_ylim(bottom=0.0)
    _drawing.label_axes(ax, (f"time / {time_unit}" if time_unit else "time",
                             f"separation / {unit}" if unit else "separation"))
    return ax
