# SPDX-License-Identifier: MIT
"""What all plots share: axes, colours, labels, equal scales, and where a path is sampled."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy

from .._core import Path
from ..errors import HodographError

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Six colours that remain distinct with any kind of colour vision, in the order of their use.
COLOURS = ("#0068b5", "#d5500c", "#00896b", "#a8448f", "#bd8700", "#4a5865")
#: Of the axes e1, e2, e3 of a frame.
FRAME_COLOURS = (COLOURS[1], COLOURS[0], COLOURS[2])
INK, QUIET, GRID = "#1b2733", "#8b99a6", "#e4e9ee"

_LINE_WIDTH = 1.6
_SAMPLES = 600
_LEAST_PER_SEGMENT = 16
_ZOOM = 1.15  # boxes in space leave much of their axes empty
_FLATTEST_BOX = 0.05  # a side of a box in space, of the longest, however flat the data


def shades(count: int) -> list[tuple[float, float, float]]:
    """So many colours from orange over grey to blue, for a family with an order."""
    package = matplotlib()
    ends = [numpy.array(package.colors.to_rgb(c)) for c in ("#e08214", "#9a8fa3", "#0057a4")]
    at = numpy.linspace(0.0, 2.0, count) if count > 1 else numpy.array([2.0])
    return [tuple(ends[i] + (t - i) * (ends[min(i + 1, 2)] - ends[i]))
            for t, i in ((t, min(int(t), 1)) for t in at)]


def matplotlib() -> Any:
    """The package matplotlib, or ImportError with how to get it."""
    try:
        import matplotlib as package
        import matplotlib.colors
    except ImportError as error:
        raise ImportError("hodograph.plots needs matplotlib, which this Python lacks; install it "
                          "(python3-matplotlib in Debian)") from error
    return package


def refuse(sentence: str, quantity: str) -> HodographError:
    return HodographError(sentence, "outside_domain", None, quantity)


def style(ax: Axes) -> Axes:
    """Gives axes the look that the plots give to axes they make: few lines, small grey text."""
    if is_spatial(ax):
        for axis in (ax.xaxis, ax.yaxis, ax.zaxis):
            axis.set_pane_color((1.0, 1.0, 1.0, 0.0))
            axis.line.set_color(QUIET)
            axis.label.set(color=INK, fontsize=8)
            axis._axinfo["grid"].update(color=GRID, linewidth=0.5)
            axis._axinfo["tick"].update(inward_factor=0.0, outward_factor=0.15)
        ax.tick_params(labelsize=7, labelcolor=INK, pad=0)
        ax.locator_params(nbins=4)
    else:
        for side, spine in ax.spines.items():
            spine.set_visible(side in ("left", "bottom"))
            spine.set(color=QUIET, linewidth=0.8)
        ax.tick_params(labelsize=8, labelcolor=INK, color=QUIET, width=0.8, length=3)
        ax.tick_params(which="minor", color=QUIET, width=0.5, length=2)
        ax.xaxis.label.set(color=INK, fontsize=9)
        ax.yaxis.label.set(color=INK, fontsize=9)
        ax.grid(True, color=GRID, linewidth=0.6)
        ax.set_axisbelow(True)
    ax.title.set(color=INK, fontsize=10)
    ax.set_prop_cycle(color=list(COLOURS))
    return ax


def is_spatial(ax: Axes) -> bool:
    return getattr(ax, "name", "") == "3d"


def axes_for(ax: Axes | None, spatial: bool | None = None) -> Axes:
    """The axes given, or new ones of pyplot; refused where they are of the other kind."""
    matplotlib()
    if ax is None:
        from matplotlib import pyplot

        figure = pyplot.figure(layout="constrained")
        return style(figure.add_subplot(projection="3d" if spatial else None))
    if not hasattr(ax, "plot"):
        raise refuse(f"`ax` are axes of matplotlib, not {type(ax).__name__}", "ax")
    if spatial is not None and is_spatial(ax) != spatial:
        raise refuse("this is drawn in space: `ax` needs projection='3d'" if spatial else
                     "this is drawn in the plane: `ax` must not have projection='3d'", "ax")
    return ax


def plane_of(plane: str | None, dimension: int) -> tuple[int, int] | None:
    """The two coordinates that a plane such as "xz" shows; None for all."""
    if plane is None:
        return None
    letters = "xyz"[:dimension]
    if len(plane) != 2 or plane[0] == plane[1] or any(letter not in letters for letter in plane):
        raise refuse(f"`plane` names two of {', '.join(letters)}, such as 'xy', not {plane!r}",
                     "plane")
    return letters.index(plane[0]), letters.index(plane[1])


def columns(points: numpy.ndarray, ax: Axes, shown: tuple[int, int] | None) -> list[numpy.ndarray]:
    """The coordinates to draw, one array each; z = 0 for planar points on axes in space."""
    if shown is not None:
        return [points[..., i] for i in shown]
    drawn = [points[..., i] for i in range(points.shape[-1])]
    if is_spatial(ax) and len(drawn) == 2:
        drawn.append(numpy.zeros_like(drawn[0]))
    return drawn


def spatial_axes(ax: Axes | None, dimension: int, shown: tuple[int, int] | None) -> Axes:
    """Axes for points of a dimension, seen in a plane or as they are."""
    if dimension == 2 and shown is None and ax is not None:
        return axes_for(ax)  # planar data fit on both kinds of axes
    return axes_for(ax, dimension == 3 and shown is None)


def label_axes(ax: Axes, names: Sequence[str], unit: str = "") -> None:
    """Labels those axes that have no label yet."""
    text = [f"{name} / {unit}" if unit else name for name in names]
    for axis, label in zip((ax.xaxis, ax.yaxis, getattr(ax, "zaxis", None)), text):
        if axis is not None and not axis.get_label_text():
            axis.set_label_text(label)


def coordinate_names(ax: Axes, shown: tuple[int, int] | None) -> list[str]:
    if shown is not None:
        return ["xyz"[i] for i in shown]
    return list("xyz" if is_spatial(ax) else "xy")


def equal_scales(ax: Axes) -> None:
    """Gives axes the same length for one unit on every axis; in space the box fits the limits."""
    if not is_spatial(ax):
        ax.set_aspect("equal", adjustable="box")
        return
    sides = numpy.array([abs(high - low) for low, high in (ax.get_xlim(), ax.get_ylim(),
                                                           ax.get_zlim())])
    if numpy.all(sides == 0.0):
        return
    least = _FLATTEST_BOX * sides.max()
    for low_high, setter, side in zip((ax.get_xlim(), ax.get_ylim(), ax.get_zlim()),
                                      (ax.set_xlim, ax.set_ylim, ax.set_zlim), sides):
        if side < least:
            middle = 0.5 * sum(low_high)
            setter(middle - 0.5 * least, middle + 0.5 * least, auto=None)
    ax.set_box_aspect(numpy.maximum(sides, least), zoom=_ZOOM)


def finished(ax: Axes, shown: tuple[int, int] | None, unit: str) -> Axes:
    label_axes(ax, coordinate_names(ax, shown), unit)
    equal_scales(ax)
    return ax


def line_options(given: dict[str, Any], **defaults: Any) -> dict[str, Any]:
    """The keyword arguments of a line: what was given, and our defaults for the rest."""
    package = matplotlib()
    from matplotlib.lines import Line2D

    given = package.cbook.normalize_kwargs(given, Line2D)
    defaults = package.cbook.normalize_kwargs(defaults, Line2D)
    return {"linewidth": _LINE_WIDTH, **defaults, **given}


def a_path(path: Any, spatial: bool | None = None) -> Path:
    """The path itself, or that of a result that has one (a fit, a plan, a climb)."""
    inner = path if isinstance(path, Path) else getattr(path, "path", getattr(path, "curve", None))
    if not isinstance(inner, Path):
        raise refuse(f"a Path is drawn, or something with a `path`, not {type(path).__name__}",
                     "path")
    if spatial is not None and (inner.dimension == 3) != spatial:
        raise refuse(f"a {'spatial' if spatial else 'planar'} path is needed; this one has "
                     f"dimension {inner.dimension}", "path")
    return inner


def parameters(path: Any, count: int = _SAMPLES, least: int = _LEAST_PER_SEGMENT) -> numpy.ndarray:
    """Parameters at which plots sample a path: all knots, and between them about `count` in all,
    evenly spaced within every segment; more in longer ones, `least` in the shortest (less where
    that would make more than `count`). Middles of segments are among them if count allows."""
    path = a_path(path)
    if count < 2:
        raise refuse(f"a path is drawn from 2 samples at least, not {count}", "count")
    knots = numpy.asarray(path.knots)
    lengths = numpy.diff(numpy.asarray(path.knot_arc_lengths))
    least = max(1, min(least, count // len(lengths)))
    steps = numpy.maximum(least, numpy.ceil((count - 1) * lengths / lengths.sum()).astype(int))
    steps += (steps > 1) & (steps % 2 == 1)
    inside = [numpy.linspace(a, b, n, endpoint=False)
              for a, b, n in zip(knots[:-1], knots[1:], steps)]
    return numpy.append(numpy.concatenate(inside), knots[-1])


def even_parameters(path: Path, count: int) -> numpy.ndarray:
    """Parameters of `count` points evenly spaced along the path; on a closed one the last is not
    the first again."""
    s = numpy.linspace(0.0, path.arc_length(), count + 1 if path.is_closed else count)
    return path.parameter_at_arc_length(s[:count])


def segments(ax: Axes, begin: list[numpy.ndarray], end: list[numpy.ndarray],
             **options: Any) -> Any:
    """Many straight pieces as one collection; the axes grow to hold them."""
    pieces = numpy.stack([numpy.stack(begin, axis=-1), numpy.stack(end, axis=-1)], axis=1)
    if is_spatial(ax):
        from mpl_toolkits.mplot3d.art3d import Line3DCollection

        drawn = ax.add_collection3d(Line3DCollection(pieces, **options))
        ax.auto_scale_xyz(*(pieces[..., i].ravel() for i in range(3)), had_data=True)
        return drawn
    from matplotlib.collections import LineCollection

    drawn = ax.add_collection(LineCollection(pieces, **options))
    ax.autoscale_view()
    return drawn
