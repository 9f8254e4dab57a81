#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A signal stops what takes long: its handler's exception comes out, and soon."""

import signal
import time
import unittest

import numpy as np

import hodograph

AFTER = 0.2  # seconds until the signal
SOON = 8.0  # seconds in which the call must end then, on a busy machine
# Every call below takes many times AFTER + SOON when nothing stops it.


class Stop(Exception):
    pass


def straight(begin, end):
    step = np.subtract(end, begin, dtype=float)
    length = np.hypot(*step)
    root = np.sqrt(complex(*step) / length)
    return hodograph.Path([0.0, length], [begin], [[[root.real, root.imag]]])


def flyers(count):
    """Vehicles that fly past each other in all directions."""
    made = []
    for i, angle in enumerate(np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)):
        at = 100.0 * np.array([np.cos(angle), np.sin(angle)])
        law = hodograph.TimingLaw.constant_speed(np.hypot(*(2.0 * at)), 1.0)
        made.append(hodograph.Vehicle(str(i), hodograph.TimedMotion(straight(at, -at), law), 0.5))
    return made


class Signals(unittest.TestCase):
    def stopped(self, call):
        def handler(*_):
            self.fired = time.monotonic()
            raise Stop

        before = signal.signal(signal.SIGALRM, handler)
        try:
            signal.setitimer(signal.ITIMER_REAL, AFTER)
            with self.assertRaises(Stop):
                call()
            self.assertLess(time.monotonic() - self.fired, SOON)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0.0)
            signal.signal(signal.SIGALRM, before)

    def test_all_pairs_of_a_swarm(self):
        vehicles = flyers(2500)
        self.stopped(lambda: hodograph.separation_matrix(vehicles, threads=2))

    def test_deconfliction(self):
        vehicles = flyers(60)
        self.stopped(lambda: hodograph.deconflict_by_delays(
            vehicles, 60.0, 60, most_choices=10**9, clearance=2.0))

    def test_fits_of_arrays(self):
        t = np.linspace(0.0, 200.0, 20001)
        points = np.stack([np.cos(t), np.sin(3.0 * t), np.sin(t * t / 50.0)], axis=1)
        self.stopped(lambda: hodograph.fit(points, 1e-11, parameters=t))

    def test_exact_solutions(self):
        a = "+".join(f"({k + 1}/{k + 7} t^{k} + {k}) {u}" for k, u in enumerate(["", "i", "j", "k"] * 8))
        solve = hodograph.solve  # loads its module
        self.stopped(lambda: solve(a, "(t^2 + t/3 + 7)^20 (t - 5/7)^9", 500))

    def test_plans_and_shortest_polylines(self):
        rng = np.random.default_rng(1)
        square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
        world = hodograph.World([square * rng.uniform(0.3, 0.45) + [2 * i, 2 * j]
                                 for i in range(60) for j in range(60)])
        planner = hodograph.Planner(world, turn_radius=0.9, clearance=0.02)
        self.stopped(lambda: [planner.plan([-1.0, -1.0], [119.0, 119.0], most_attempts=10**6)
                              for _ in range(10**6)])


if __name__ == "__main__":
    unittest.main()
