# SPDX-License-Identifier: MIT
"""What the scripts of the gallery share: figures of one look, numbers of one form, and running one.

A script has a docstring (its first line is the title, the rest the caption, in Markdown) and a
function draw() that computes with `hodograph`, draws with `hodograph.plots`, prints the numbers
worth knowing and returns the figure.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import hodograph
from hodograph import plots

ROOT = Path(__file__).resolve().parents[2]
BLUE, ORANGE, GREEN, PURPLE, GOLD, GREY = plots.COLOURS
FRAME = plots.FRAME_COLOURS
INK, PALE = "#1b2733", "#b9c3cc"
_DPI = 130


def figure(rows=1, columns=1, *, width=9.0, height=4.0, spatial=(), **grid):
    """A figure and its axes, (rows, columns) flattened; `spatial` names those in space by number,
    True all of them."""
    made = Figure(figsize=(width, height), layout="constrained", facecolor="white")
    made.get_layout_engine().set(w_pad=0.08, h_pad=0.06)
    places = made.add_gridspec(rows, columns, **grid)
    axes = [made.add_subplot(place, projection="3d" if spatial is True or k in spatial else None)
            for k, place in enumerate(places)] if spatial else \
        [made.add_subplot(place) for place in places]
    return made, [plots.style(ax) for ax in axes]


def title(ax, text):
    """A small heading of axes, in the plane at their left."""
    if ax.name == "3d":
        ax.set_title(text, fontsize=9, color=INK, pad=-4)
    else:
        ax.set_title(text, loc="left", fontsize=9, color=INK)


def strokes(ax, begin, end, **line):
    """Straight strokes between points (n, d) as one line."""
    gap = np.full_like(begin, np.nan)
    ax.plot(*np.stack([begin, end, gap], axis=1).reshape(-1, begin.shape[1]).T, **line)


def legend(ax, **options):
    """A legend without a box."""
    return ax.legend(**{"fontsize": 8, "frameon": False, "labelcolor": INK,
                        "handlelength": 1.6, **options})


def bare(ax):
    """Axes without ticks, panes and labels: only what is drawn."""
    ax.set_axis_off()


def view(ax, elevation, azimuth, zoom=1.15):
    """Axes in space seen from there, nearer for a larger zoom."""
    ax.view_init(elev=elevation, azim=azimuth)
    ax.set_box_aspect(ax._box_aspect, zoom=zoom)


def largest_difference(a, b):
    """The largest distance of points (n, d)."""
    return float(np.linalg.norm(np.asarray(a) - np.asarray(b), axis=-1).max())


def largest_curvature(path):
    """The largest |curvature| of a path, an upper bound."""
    extremes = hodograph.curvature_extremes(path)
    return max(-extremes.minimum.lower, extremes.maximum.upper)


def direction(angle):
    """(cos, sin)."""
    return np.array([np.cos(angle), np.sin(angle)])


def save(made, name=None, dpi=_DPI):
    """Writes a figure: to the file named as argument of the script, or <script>.png here."""
    to = name or (sys.argv[1] if len(sys.argv) > 1 else Path(sys.argv[0]).stem + ".png")
    made.savefig(to, dpi=dpi)
