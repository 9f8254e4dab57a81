#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path planning, Figure 1: the separation of two vehicles

Two quintics of one length S, flown at one constant speed. They cross, yet the vehicles keep 0.025 S
apart: the dots are where they come closest. Right, their separation over the part of the way, with
the limit. The least separation is enclosed; the paper samples it.
"""

import numpy as np
from gallery import BLUE, ORANGE, figure, save
from scenes import arriving

import hodograph
from hodograph import plots

_SAFE = 0.025  # of the length


def draw():
    vehicles, data = arriving("data/crossing_pair.json")
    length = data["length"]
    pair = hodograph.arrival_at(vehicles, length)
    first, second = (vehicle.motion for vehicle in pair.vehicles)
    least = hodograph.least_separation(first, second)
    made, (left, right) = figure(1, 2, width=9.5, height=3.6)
    for member, colour in zip(pair.paths, (BLUE, ORANGE)):
        plots.path(member.path, left, color=colour, arrows=2)
    for place, colour in ((least.first, BLUE), (least.second, ORANGE)):
        left.plot(*place[:2], "o", color=colour, markersize=5, zorder=4)
    t = np.linspace(0.0, length, 801)
    apart = np.linalg.norm(first.position(t) - second.position(t), axis=1) / length
    right.plot(t / length, apart, color=BLUE)
    right.axhline(_SAFE, color=ORANGE, linewidth=0.9, linestyle=(0, (6, 4)))
    right.plot(least.time / length, least.distance.upper / length, "o", color=BLUE, markersize=5)
    right.set(xlabel="part of the way", ylabel="separation / S", ylim=(0, None))
    for member in pair.paths:
        print(f"length {member.path.arc_length():.6f}")
    print(f"least separation {least.distance.upper / length:.6f} S after "
          f"{least.time / length:.4f} of the way; required {_SAFE} S")
    return made


if __name__ == "__main__":
    save(draw())
