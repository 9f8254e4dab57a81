# SPDX-License-Identifier: MIT
"""A surface, as the triangles of a mesh with light from the upper left."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy

from . import _drawing

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_LIGHT = numpy.array([-0.45, -0.35, 0.82])
_DARKEST, _BRIGHTEST = 0.42, 1.0  # parts of the colour in shadow and in full light


def _triangles(mesh: Any, faces: Any) -> numpy.ndarray:
    """The corners of every triangle, (m, 3, 3)."""
    if faces is None:
        inner = getattr(mesh, "mesh", mesh)
        vertices = getattr(inner, "positions", None)
        faces = getattr(inner, "triangles", None)
        if vertices is None or faces is None:
            raise _drawing.refuse("a surface is drawn from a TriangleMesh, a SweepMesh, or vertices"
                                  f" (n, 3) with faces (m, 3), not {type(mesh).__name__}", "mesh")
        where = numpy.asarray(getattr(inner, "position_of", ()), dtype=int)
        faces = numpy.asarray(faces, dtype=int)
        faces = where[faces] if len(where) else faces
    else:
        vertices = mesh
    vertices, faces = numpy.asarray(vertices, dtype=float), numpy.asarray(faces, dtype=int)
    if vertices.ndim != 2 or vertices.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3:
        raise _drawing.refuse(f"vertices have shape (n, 3) and faces (m, 3), not {vertices.shape} "
                              f"and {faces.shape}", "mesh")
    if not len(faces):
        raise _drawing.refuse("a surface has one triangle at least", "faces")
    if not 0 <= faces.min() <= faces.max() < len(vertices):
        raise _drawing.refuse(f"faces name vertices 0 to {len(vertices) - 1}, not {faces.min()} to "
                              f"{faces.max()}", "faces")
    return vertices[faces]


def surface(mesh: Any, ax: Axes | None = None, *, faces: Any = None,
            color: Any = "#7fb2d9", back_color: Any = "#e8b48f", unit: str = "",
            **options: Any) -> Axes:
    """Draws the triangles of a mesh, shaded, on axes in space, and returns the axes.

    ``mesh`` is a TriangleMesh or SweepMesh, or an array of vertices (n, 3) with ``faces`` (m, 3).
    Triangles seen from behind have ``back_color``; what is behind and in front is matplotlib's
    guess, by the middle of every triangle. Set the view before: the colours depend on it.
    Keyword arguments go to the collection.
    """
    corners = _triangles(mesh, faces)
    ax = _drawing.axes_for(ax, spatial=True)
    from matplotlib.colors import to_rgb
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    sizes = numpy.linalg.norm(normals, axis=1, keepdims=True)
    normals = numpy.divide(normals, sizes, out=numpy.zeros_like(normals), where=sizes > 0.0)
    azimuth, elevation = numpy.radians([ax.azim, ax.elev])
    eye = numpy.array([numpy.cos(elevation) * numpy.cos(azimuth),
                       numpy.cos(elevation) * numpy.sin(azimuth), numpy.sin(elevation)])
    front = normals @ eye >= 0.0
    light = numpy.abs(normals @ (_LIGHT / numpy.linalg.norm(_LIGHT)))
    lit = numpy.where(front == (normals @ _LIGHT >= 0.0), light, 0.35 * light)
    shade = _DARKEST + (_BRIGHTEST - _DARKEST) * lit
    base = numpy.where(front[:, None], to_rgb(color), to_rgb(back_color))
    colours = base * shade[:, None]
    had_data = ax.has_data()
    ax.add_collection3d(Poly3DCollection(corners, **{
        "facecolors": colours, "edgecolors": colours, "linewidths": 0.25, **options}))
    ax.auto_scale_xyz(*(corners[..., i].ravel() for i in range(3)), had_data=had_data)
    return _drawing.finished(ax, None, unit)
