#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Twenty vehicles on three altitudes

From a circle to the points opposite, arriving together, on three altitudes; some leave later, so
that none meets another. Left, the ways, and the vehicles half-way; right, the separations of all
190 pairs, with the distance that the vehicles' radii and the clearance ask for. It is certified for
every instant.
"""

import numpy as np
from gallery import bare, figure, legend, save, view
from scenes import arriving

import hodograph
from hodograph import plots


def draw():
    vehicles, data = arriving("data/twenty.json")
    arrival = hodograph.earliest_arrival(vehicles) * (1.0 + data["excess"])
    apart = hodograph.deconflict_arrival(vehicles, arrival, clearance=data["clearance"],
                                         latest_excess=0.25, later_arrivals=4, **data["deconflict"])
    fleet = apart.plan.vehicles
    made, (left, right) = figure(1, 2, width=10, height=4.4, spatial={0}, width_ratios=[1.2, 1])
    plots.swarm(fleet, left, time=0.5 * arrival, linewidth=0.9)
    view(left, 32, -60, 1.4)
    bare(left)
    required = data["clearance"] + 2.0 * fleet[0].radius
    plots.separations(fleet, right, required=required, samples=300, highlight=3)
    arrival = apart.plan.arrival
    right.set(xlim=(0, arrival), ylim=(0, None))
    legend(right, loc="upper right")
    delays = np.asarray(apart.delays)
    close = hodograph.close_pairs(fleet, clearance=data["clearance"])
    matrix = hodograph.separation_matrix(fleet)
    least = matrix.lower[np.triu_indices(len(fleet), 1)].min()
    print(f"arrival at {arrival:.4f}; {np.count_nonzero(delays)} of {len(fleet)} leave later, by "
          f"up to {delays.max():.2f}")
    print(f"least separation {least:.4f}, required {required:.2f}; pairs that come closer: "
          f"{len(close)}")
    return made


if __name__ == "__main__":
    save(draw())
