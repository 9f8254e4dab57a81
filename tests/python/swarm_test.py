#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Timing laws, separations, arrivals and deconfliction: golden values and dense samples."""

import json
import pickle
import unittest
from pathlib import Path

import numpy as np

import hodograph
from hodograph import Answer, HodographError, TimedMotion, TimingLaw

EPSILON = np.finfo(float).eps
GOLDEN = Path(__file__).resolve().parents[1] / "golden"


def straight(begin, end):
    """A straight planar path of unit speed."""
    step = np.subtract(end, begin, dtype=float)
    length = np.hypot(*step)
    root = np.sqrt(complex(*step) / length)
    return hodograph.Path([0.0, length], [begin], [[[root.real, root.imag]]])


def motion(path, speed=1.0, start=0.0, **members):
    return TimedMotion(path, TimingLaw.constant_speed(path.arc_length(), speed, start), **members)


def sampled(a, b, count=20001):
    window = hodograph.common_window(a, b)
    t = np.linspace(window.begin, window.end, count)
    return t, np.linalg.norm(a.position(t) - b.position(t), axis=1)


class Timing(unittest.TestCase):
    laws = (TimingLaw.constant_speed(6.0, 2.0, 1.0), TimingLaw.between(6.0, 1.0, 3.0),
            TimingLaw.trapezoidal(10.0, cruise_speed=2.0, acceleration=0.5, deceleration=1.0),
            TimingLaw.trapezoidal(1.0, cruise_speed=9.0, start_time=-2.0),
            TimingLaw.under_limits([0, 2, 3, 8], [3.0, 0.5, np.inf], cruise_speed=2.0),
            TimingLaw.from_speeds([1.0, 2.0, 1.0], [0.0, 1.0, 1.0, 0.0], 3.0))

    def test_arc_length_is_the_integral_of_speed(self):
        for law in self.laws:
            edges = np.concatenate([law.start_time + law.pieces[:, 0], [law.end_time]])
            middle = 0.5 * (edges[:-1] + edges[1:])  # speeds are linear between
            covered = law.speed_at(middle) @ np.diff(edges)
            self.assertAlmostEqual(covered, law.length, delta=64 * EPSILON * law.length)
            t = np.linspace(law.start_time, law.end_time, 60).reshape(3, 20)
            s = law.arc_length_at(t)
            self.assertEqual(s.shape, (3, 20))
            self.assertTrue(np.all(np.diff(s.ravel()) >= 0.0))
            np.testing.assert_allclose(law.arc_length_at(law.time_at(s)), s,
                                       atol=2 * law.arc_length_error())
            self.assertLessEqual(law.speed_at(t).max(), law.most_speed)
        self.assertEqual(self.laws[0], self.laws[0].delayed(0.0))
        self.assertEqual(self.laws[0].end_time, 4.0)
        self.assertEqual(self.laws[2].duration, 4.0 + 2.0 + 2.0)  # over 4, 4 and 2

    def test_laws_are_their_pieces(self):
        for law in self.laws:
            for later in (law, law.delayed(3.5)):
                self.assertEqual(pickle.loads(pickle.dumps(later)), later)
            self.assertEqual(
                TimingLaw.from_pieces(law.pieces, law.length, law.start_time), law)
        broken = self.laws[2].pieces.copy()
        broken[1, 2] += 1.0
        for pieces in (broken, np.zeros((0, 5)), np.zeros((2, 4)), np.full((1, 5), np.nan)):
            with self.assertRaises(HodographError):
                TimingLaw.from_pieces(pieces, 10.0)

    def test_bends_are_taken_slowly(self):
        path = hodograph.rounded_polyline([[0, 0], [10, 0], [10, 10]], most_curvature=2.0)
        law = hodograph.curvature_limited_timing(path, lateral_acceleration=0.5, cruise_speed=3.0)
        t = np.linspace(law.start_time, law.end_time, 4000)
        kappa = hodograph.curvature(path, path.parameter_at_arc_length(
            np.clip(law.arc_length_at(t), 0.0, path.arc_length())))
        self.assertLessEqual((law.speed_at(t)**2 * np.abs(kappa)).max(), 0.5 * (1 + 16 * EPSILON))
        self.assertGreater((law.speed_at(t)**2 * np.abs(kappa)).max(), 0.4)

    def test_refusals(self):
        for call in (lambda: TimingLaw.constant_speed(-1.0, 1.0),
                     lambda: TimingLaw.constant_speed(1.0, np.nan),
                     lambda: TimingLaw.between(1.0, 2.0, 2.0),
                     lambda: TimingLaw.trapezoidal(1.0, start_speed=50.0, cruise_speed=60.0),
                     lambda: TimingLaw.under_limits([0, 1], [0.0]),
                     lambda: TimingLaw.under_limits([], []),
                     lambda: TimingLaw.from_speeds([1.0], [1.0], 1.0),
                     lambda: self.laws[0].arc_length_at([1.0, 99.0]),
                     lambda: self.laws[0].speed_at(np.nan),
                     lambda: self.laws[0].delayed(np.inf)):
            with self.assertRaises(HodographError):
                call()


class Separations(unittest.TestCase):
    def test_agree_with_the_golden_values(self):
        for entry in json.loads((GOLDEN / "planar_separation.json").read_text())["separation"]:
            given, expected = entry["input"], entry["expected"]
            a, b = (hodograph.Path([0.0, 1.0], [given["p_" + one]], [given["w_" + one]])
                    for one in "ab")
            absent = {"before_start": False, "after_arrival": False}
            first, second = motion(a, **absent), motion(b, **absent)
            found = hodograph.least_separation(first, second)
            truth = expected["true_min"]
            last = 4 * EPSILON * max(1.0, truth)
            self.assertLessEqual(found.distance.lower, truth + last)
            self.assertGreaterEqual(found.distance.upper, truth - last)
            self.assertLessEqual(found.distance.width, 2.0**-29 * min(a.arc_length(),
                                                                      b.arc_length()))
            stepped = hodograph.stepped_separation(first, second, expected["ds"])
            self.assertEqual(stepped.index, expected["k_min"])
            self.assertAlmostEqual(stepped.sampled, expected["min_sampled"],
                                   delta=entry["rel_tol"])

    def test_are_right_for_two_that_cross(self):
        # Along the axes at unit speed, the second later by 1: nearest when both are 1/2 away.
        a = motion(straight([-5, 0], [5, 0]), **{"after_arrival": False, "before_start": False})
        b = motion(straight([0, -5], [0, 5]), start=1.0)
        found = hodograph.least_separation(a, b)
        self.assertIn(np.sqrt(0.5), found.distance)
        self.assertAlmostEqual(found.time, 5.5, delta=1e-4)
        np.testing.assert_allclose(found.first, a.position(found.time), atol=1e-12)
        self.assertEqual(hodograph.separated_by(a, b, 0.7), Answer.yes)
        self.assertEqual(hodograph.separated_by(a, b, 0.71), Answer.no)
        passages = hodograph.close_passages(a, b, 1.0, 1e-6)
        self.assertEqual(len(passages), 1)
        # (t - 5)^2 + (t - 6)^2 = 1 at 5 and 6.
        self.assertAlmostEqual(passages[0].begin, 5.0, delta=1e-5)
        self.assertAlmostEqual(passages[0].end, 6.0, delta=1e-5)
        self.assertTrue(passages[0].certain)

    def test_enclose_dense_samples_in_space(self):
        random = np.random.default_rng(3)
        for _ in range(4):
            pair = []
            for _ in range(2):
                preimage = random.normal(size=(1, 3, 4))
                path = hodograph.Path([0.0, 1.0], random.normal(size=(1, 3)), preimage)
                pair.append(motion(path, speed=path.arc_length()))
            found = hodograph.least_separation(*pair)
            least = sampled(*pair)[1].min()
            self.assertGreaterEqual(least, found.distance.lower)
            self.assertLessEqual(found.distance.lower, found.distance.upper)
            self.assertAlmostEqual(least, found.distance.upper, delta=1e-3)

    def test_motions_carry_their_paths(self):
        path = straight([0, 0], [3, 4])
        flown = motion(path, altitude=7.0, before_start=False)
        self.assertEqual(flown.path, path)
        self.assertEqual((flown.altitude, flown.before_start, flown.after_arrival),
                         (7.0, False, True))
        np.testing.assert_allclose(flown.position([[-1.0], [2.5], [9.0]]),
                                   [[[0, 0, 7]], [[1.5, 2, 7]], [[3, 4, 7]]], atol=16 * EPSILON)
        again = pickle.loads(pickle.dumps(flown.delayed(2.0)))
        self.assertEqual((again.path, again.law, again.altitude),
                         (path, flown.law.delayed(2.0), 7.0))
        with self.assertRaises(HodographError):
            TimedMotion(path, TimingLaw.constant_speed(4.0, 1.0))
        with self.assertRaises(HodographError):
            motion(hodograph.lifted(path), altitude=1.0)
        with self.assertRaises(HodographError):
            flown.position([0.0, np.nan])
        with self.assertRaises(HodographError):
            hodograph.separated_by(flown, flown, np.nan)
        self.assertIsNone(hodograph.common_window(
            motion(path, before_start=False, after_arrival=False),
            motion(path, start=100.0, before_start=False, after_arrival=False)))


class Swarms(unittest.TestCase):
    def star(self, count):
        """Vehicles from a circle to the points opposite, leaving together."""
        angles = np.arange(count) * 2 * np.pi / count
        return [hodograph.Vehicle(str(k), motion(straight(
            10 * np.array([np.cos(a), np.sin(a)]), -10 * np.array([np.cos(a), np.sin(a)]))), 0.1)
            for k, a in enumerate(angles)]

    def test_the_matrix_is_of_all_pairs(self):
        vehicles = [hodograph.Vehicle("p", motion(straight([0, 0], [9, 0])), 0.25),
                    hodograph.Vehicle("q", motion(straight([0, 2], [9, 2])), 0.25),
                    hodograph.Vehicle("r", motion(straight([0, 3], [9, 0])), 0.25)]
        matrix = hodograph.separation_matrix(vehicles)
        self.assertEqual((matrix.size, len(matrix)), (3, 3))
        for i in range(3):
            for j in range(3):
                if i == j:
                    self.assertEqual(matrix.lower[i, j], 0.0)
                    continue
                least = sampled(vehicles[i].motion, vehicles[j].motion)[1].min()
                self.assertEqual(matrix.lower[i, j], matrix[i, j].distance.lower)
                self.assertAlmostEqual(matrix.upper[i, j], least, delta=1e-3)
                self.assertLessEqual(matrix.lower[i, j], least)
        with self.assertRaises(IndexError):
            matrix[0, 3]
        with self.assertRaises(IndexError):
            matrix[1, 1]
        close = hodograph.close_pairs(vehicles, clearance=0.5)
        self.assertEqual([(pair.first, pair.second) for pair in close], [(0, 2), (1, 2)])
        found = hodograph.conflicts(vehicles, clearance=0.5, threads=1)
        self.assertEqual([(one.pair.first, one.pair.second) for one in found], [(0, 2), (1, 2)])
        for one in found:
            self.assertEqual(one.pair.required, 1.0)
            self.assertAlmostEqual(one.shortfall().upper, 1.0 - one.separation.distance.lower,
                                   delta=4 * EPSILON)
            self.assertTrue(one.passages)

    def test_delays_keep_a_star_apart(self):
        vehicles = self.star(5)
        self.assertEqual(len(hodograph.close_pairs(vehicles)), 10)
        apart = hodograph.deconflict_by_delays(vehicles, 4.0, 8, clearance=0.05)
        self.assertEqual(hodograph.close_pairs(apart.vehicles, clearance=0.05), [])
        for before, after, delay in zip(vehicles, apart.vehicles, apart.delays):
            self.assertEqual(after.motion.start_time, before.motion.start_time + delay)
            self.assertEqual(after.motion.path, before.motion.path)
        again = pickle.loads(pickle.dumps(apart))
        np.testing.assert_array_equal(again.delays, apart.delays)
        self.assertEqual(again.vehicles[3].motion.law, apart.vehicles[3].motion.law)
        with self.assertRaises(HodographError) as caught:
            hodograph.deconflict_by_delays(vehicles, 0.1, 1)
        self.assertEqual(caught.exception.code, "not_separated")

    def arriving(self, **members):
        return [hodograph.ArrivingVehicle(str(k), [0, k], [1, 0.5], [10, 3 - k], [1, 0.2 * k],
                                          radius=0.05, **members) for k in range(4)]

    def test_all_arrive_at_one_time_on_paths_of_their_lengths(self):
        vehicles = self.arriving(speed=2.0, departure=1.0)
        made = hodograph.arrival_at(vehicles, 8.0)
        for given, path, vehicle in zip(vehicles, made.paths, made.vehicles):
            self.assertAlmostEqual(path.path.arc_length(), 14.0, delta=64 * EPSILON * 14)
            self.assertEqual(vehicle.motion.path, path.path)
            np.testing.assert_allclose(vehicle.motion.position(8.0)[:2], given.end, atol=1e-12)
            np.testing.assert_allclose(vehicle.motion.position(1.0)[:2], given.begin, atol=1e-12)
        nearest = max(1.0 + np.hypot(*(v.end - v.begin)) / 2.0 for v in vehicles)
        self.assertAlmostEqual(hodograph.earliest_arrival(vehicles), nearest,
                               delta=8 * EPSILON * nearest)
        other = hodograph.arriving_path(vehicles[0], 8.0, 1)
        self.assertGreaterEqual(other.rotation_index, made.paths[0].rotation_index)
        again = pickle.loads(pickle.dumps(made))
        self.assertEqual(again.paths[2].path, made.paths[2].path)
        self.assertEqual(pickle.loads(pickle.dumps(vehicles[1])).departure, 1.0)

    def lanes(self, ends):
        """Four vehicles side by side whose ends are those of others."""
        return [hodograph.ArrivingVehicle(str(k), [0, 2 * k], [1, 0.5], [10, 2 * end], [1, 0.5],
                                          radius=0.05, most_curvature=0.7)
                for k, end in enumerate(ends)]

    def test_the_least_arrivals_keep_what_they_promise(self):
        vehicles = self.lanes([0, 1, 2, 3])
        first = hodograph.least_arrival(vehicles)
        apart = hodograph.least_separated_arrival(vehicles, clearance=0.1)
        self.assertLessEqual(hodograph.earliest_arrival(vehicles), first.arrival)
        self.assertLessEqual(first.arrival, apart.arrival)
        for path in first.paths:
            xi = np.linspace(path.path.xi_begin, path.path.xi_end, 500)
            self.assertLessEqual(np.abs(hodograph.curvature(path.path, xi)).max(), 0.7)
        self.assertEqual(hodograph.close_pairs(apart.vehicles, clearance=0.1), [])

    def test_vehicles_that_cross_are_kept_apart_by_departures(self):
        vehicles = self.lanes([1, 0, 3, 2])
        together = hodograph.least_arrival(vehicles)
        self.assertEqual(len(hodograph.close_pairs(together.vehicles, clearance=0.1)), 2)
        kept = hodograph.deconflict_arrival(vehicles, together.arrival + 0.5, 2.0, 8,
                                            clearance=0.1)
        self.assertEqual(hodograph.close_pairs(kept.plan.vehicles, clearance=0.1), [])
        self.assertGreater(kept.delays.max(), 0.0)
        self.assertGreater(kept.effort.pairs_checked, 0)
        with self.assertRaises(HodographError) as caught:
            hodograph.least_separated_arrival(vehicles, clearance=0.1)
        self.assertEqual(caught.exception.code, "not_separated")

    def test_refusals(self):
        vehicles = self.arriving()
        for call in (lambda: hodograph.arrival_at(vehicles, 5.0),  # sooner than straight on
                     lambda: hodograph.arrival_at(vehicles, np.nan),
                     lambda: hodograph.arrival_at([], 5.0),
                     lambda: hodograph.least_arrival([]),
                     lambda: hodograph.earliest_arrival([]),
                     lambda: hodograph.earliest_arrival(self.arriving(speed=0.0)),
                     lambda: hodograph.arriving_path(vehicles[0], 14.0, 2),
                     lambda: hodograph.close_pairs([]),
                     lambda: hodograph.separation_matrix(self.star(2), relative_width=0.0),
                     lambda: hodograph.close_pairs(self.star(2), clearance=-1.0),
                     lambda: hodograph.ArrivingVehicle("a", [0, 0, 0], [1, 0], [1, 1], [1, 0])):
            with self.assertRaises(HodographError):
                call()


if __name__ == "__main__":
    unittest.main()
