# SPDX-License-Identifier: MIT
"""Pictures of paths, frames, plans, swarms and surfaces, with matplotlib.

Every function draws on the axes given as ``ax``, or on new ones of pyplot, and returns them;
nothing global is changed. Lengths have equal scales. matplotlib is imported when something is first
drawn.
"""

from ._convergence import convergence, orders
from ._drawing import COLOURS, FRAME_COLOURS, equal_scales, parameters, shades, style
from ._paths import curvature_comb, frames, path
from ._profiles import profile
from ._surfaces import surface
from ._swarms import separations, swarm
from ._worlds import band, plan, turn_circles, world

__all__ = ["COLOURS", "FRAME_COLOURS", "band", "convergence", "curvature_comb", "equal_scales",
           "frames", "orders", "parameters", "path", "plan", "profile", "separations", "shades",
           "style", "surface", "swarm", "turn_circles", "world"]
