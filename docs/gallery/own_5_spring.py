#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A spring that changes its sense

The cord of an old telephone, whose coil turns over in the middle, from the side. Above, its Frenet
frame, its Euler-Rodrigues frame and a rotation-minimising frame (e₂ blue, e₃ green). Below, how
fast each turns about the tangent: the Frenet frame by the torsion, which peaks where the coil turns
over; the Euler-Rodrigues frame hardly; the last not at all.
"""

import numpy as np
from gallery import BLUE, GREEN, ORANGE, bare, figure, legend, save, title

import hodograph
from hodograph import plots

_TURNS, _LENGTH = 4.0, 9.0


def cord():
    """Samples of (x, cos p, sin p) with p even in x: the coil turns back where x = 0."""
    x = np.linspace(-0.5, 0.5, 241) * _LENGTH
    angle = _TURNS * np.log(np.cosh(x))
    return np.stack([x, np.cos(angle), np.sin(angle)], axis=-1)


def draw():
    path = hodograph.fit(cord(), 1e-3).path
    frenet = hodograph.frenet_roll(path)
    still = hodograph.rotation_minimising_roll(path)
    made = figure(1, 1, width=9, height=9.0)[0]
    made.clear()
    grid = made.add_gridspec(4, 1, height_ratios=[1, 1, 1, 1.1])
    rates = {}
    xi = plots.parameters(path, 4000)
    for k, (roll, name) in enumerate(((frenet, "Frenet"),
                                      (hodograph.FrameRoll.none(path), "Euler-Rodrigues"),
                                      (still, "rotation-minimising"))):
        ax = plots.style(made.add_subplot(grid[k]))
        plots.frames(path, ax, frame=roll, count=260, length=0.4, which=(2, 3), plane="xz",
                     linewidths=0.7)
        bare(ax)
        title(ax, name)
        state = hodograph.rolled_state(path, roll, xi)
        rates[name] = state.body_rate_per_xi[:, 0] / state.speed
        twist = hodograph.frame_twist(path, roll).absolute
        print(f"{name}: absolute twist {twist.upper:.4f} rad")
    below = plots.style(made.add_subplot(grid[3]))
    for (name, rate), colour in zip(rates.items(), (ORANGE, BLUE, GREEN)):
        below.plot(path.arc_length(xi), rate, color=colour, linewidth=1.2, label=name)
    below.set(xlabel="arc length", ylabel="turn about the tangent",
              xlim=(0, path.arc_length()))
    legend(below, loc="upper left", ncols=3)
    return made


if __name__ == "__main__":
    save(draw())
