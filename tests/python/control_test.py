#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""References, ascents, path following, receding horizons and generated code."""

import ctypes
import pickle
import signal
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

import hodograph
from hodograph import FollowStart, HodographError

EPSILON = np.finfo(float).eps


def bend():
    return hodograph.rounded_polyline([[0, 0], [40, 0], [40, 30]], most_curvature=0.2)


class References(unittest.TestCase):
    def spatial(self):
        knots = np.linspace(0.0, 4.5, 7)
        points = np.stack([[np.cos(knots + k * np.pi / 2), np.sin(knots + k * np.pi / 2),
                            [knots, 0 * knots + 1, 0 * knots, 0 * knots, 0 * knots][k]]
                           for k in range(5)])
        return hodograph.hermite_path(knots, points.transpose(2, 0, 1))

    def test_jets_are_the_paths_own(self):
        for path in (bend(), self.spatial()):
            reference = hodograph.ReferencePath(path)
            xi = np.linspace(path.xi_begin, path.xi_end, 24).reshape(2, 3, 4)
            jets = reference.at(xi)
            d = path.dimension
            self.assertEqual(jets.position.shape, (2, 3, 4, 3, d))
            state = hodograph.evaluate(path, xi)
            scale = np.abs(path.starts).max() + path.arc_length()
            for mine, its in ((jets.position, state.position), (jets.frame, state.frame),
                              (jets.body_rate, state.body_rate_per_xi), (jets.speed, state.speed)):
                first = mine[:, :, :, 0]
                np.testing.assert_allclose(first, its, atol=4096 * EPSILON * scale)
            np.testing.assert_allclose(jets.position[:, :, :, 1],
                                       hodograph.derivatives(path, xi, 1),
                                       atol=4096 * EPSILON * scale)
            again = pickle.loads(pickle.dumps(reference)).at(0.5)
            np.testing.assert_array_equal(again.position, reference.at(0.5).position)

    def test_progress_by_arc_length(self):
        path = self.spatial()
        reference = hodograph.ReferencePath(path, hodograph.ProgressBy.arc_length)
        s = np.linspace(0.0, path.arc_length(), 9)
        np.testing.assert_allclose(reference.xi_of(s), path.parameter_at_arc_length(s),
                                   atol=256 * EPSILON * 5)
        np.testing.assert_allclose(reference.at(s).speed[:, 0], 1.0, atol=256 * EPSILON)
        self.assertAlmostEqual(reference.end, path.arc_length(), delta=64 * EPSILON * 7)

    def test_coordinates(self):
        path = bend()
        reference = hodograph.ReferencePath(path)
        xi = 0.5 * (path.xi_begin + path.xi_end)
        state = hodograph.evaluate(path, xi)
        place = hodograph.place_of(reference, xi, 0.5)
        np.testing.assert_allclose(place, state.position + 0.5 * state.frame[:, 1], atol=1e-12)
        stretch = hodograph.progress_stretch(reference, xi, 0.5)
        self.assertAlmostEqual(stretch, state.speed - 0.5 * state.body_rate_per_xi, delta=1e-12)
        rates = hodograph.coordinate_rates(reference, xi, 0.5, [1.0, 2.0])
        np.testing.assert_allclose(rates, [np.array([1.0, 2.0]) @ state.frame[:, 0] / stretch,
                                           np.array([1.0, 2.0]) @ state.frame[:, 1]], atol=1e-12)
        limits = hodograph.offset_limits(path)
        self.assertAlmostEqual(limits.left, 5.0, delta=1e-4)  # the radius of the sharpest bend
        for call in (lambda: reference.at([0.0, np.nan]),
                     lambda: hodograph.place_of(reference, xi, [1.0, 2.0]),
                     lambda: hodograph.coordinate_rates(reference, xi, 0.0, [1.0, 2.0, 3.0])):
            with self.assertRaises(HodographError):
                call()


class Following(unittest.TestCase):
    limits = {"speed": 5.0, "acceleration": 1.0, "offset": 1.0, "lateral_acceleration": 1.0}

    def test_limits_hold_at_the_nodes(self):
        path, seen = bend(), []
        made = hodograph.follow(path, FollowStart(speed=1.0), intervals=40,
                                progress=lambda at: seen.append(at.iteration), **self.limits)
        self.assertEqual(len(made.time), 41)
        self.assertLessEqual(np.abs(made.speed).max(), 5.0 + 1e-6)
        self.assertLessEqual(np.abs(made.lateral).max(), 1.0 + 1e-6)
        self.assertLessEqual(np.abs(made.offset).max(), 1.0 + 1e-6)
        self.assertEqual((made.position.shape, made.offset.shape), ((41, 3), (41, 2)))
        reference = hodograph.ReferencePath(path)
        for xi, offset, place in list(zip(made.xi, made.offset, made.position))[::10]:
            np.testing.assert_allclose(place[:2], hodograph.place_of(reference, xi, offset[0]),
                                       atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(made.velocity, axis=1), made.speed, atol=1e-9)
        # No faster than at full speed all the way, and not slower than with the corners' limit.
        self.assertGreater(made.duration, (path.arc_length() - 5.0) / 5.0)
        self.assertIn(1, seen)

    def test_progress_stops_it_and_raises(self):
        def follow(progress):
            return hodograph.follow(bend(), FollowStart(speed=1.0), intervals=20,
                                    progress=progress, **self.limits)

        with self.assertRaises(HodographError) as caught:
            follow(lambda at: at.iteration < 3)
        self.assertEqual(caught.exception.code, "cancelled")
        with self.assertRaises(ZeroDivisionError):
            follow(lambda at: 1 / 0)

    def test_control_c_ends_it(self):
        def interrupt(at):
            if at.iteration == 2:
                signal.raise_signal(signal.SIGINT)

        self.assertIs(threading.current_thread(), threading.main_thread())
        with self.assertRaises(KeyboardInterrupt):
            hodograph.follow(bend(), FollowStart(speed=1.0), intervals=20, progress=interrupt,
                             **self.limits)

    def test_a_horizon_moves_on(self):
        horizon = hodograph.RecedingHorizon(bend(), intervals=10, step=0.2, **self.limits)
        with self.assertRaises(HodographError):
            horizon.predicted()
        at = FollowStart(speed=1.0)
        for _ in range(3):
            plan = horizon.plan(at)
            self.assertTrue(plan.finished)
            ahead = horizon.predicted()
            self.assertGreater(ahead.xi, at.xi)
            at = ahead
        self.assertTrue(plan.warm)
        again = pickle.loads(pickle.dumps(at))
        self.assertEqual((again.xi, list(again.offset)), (at.xi, list(at.offset)))

    def test_refusals(self):
        for members in ({"speed": 0.0}, {"offset": 100.0}, {"acceleration": np.nan}):
            with self.assertRaises(HodographError):
                hodograph.follow(bend(), FollowStart(), **{**self.limits, **members})
        with self.assertRaises(HodographError):
            hodograph.follow(bend(), FollowStart(offset=[5.0]), **self.limits)
        with self.assertRaises(HodographError):
            hodograph.follow(bend(), FollowStart(), settings={"hessian_approximation": "x"},
                             **self.limits)
        with self.assertRaises(HodographError):
            FollowStart(offset=[1, 2, 3])


class Ascents(unittest.TestCase):
    def test_the_published_ascent_arrives(self):
        reference = hodograph.AscentReference.gateway()
        self.assertAlmostEqual(reference.period_s / 86400, 7.008, delta=5e-4)
        start = hodograph.ascent_start("+z")
        self.assertEqual([one.name for one in hodograph.ascent_starts()][0], "+z")
        guesses = set()
        made = hodograph.tracking_ascent(
            reference, start, intervals=40, guesses=1,
            progress=lambda guess, at: guesses.add((guess, at.iteration)) or True)
        self.assertEqual(made.position.shape, (41, 3))
        np.testing.assert_allclose(
            made.reference, reference.derivatives(0.5 + 0.08 * np.linspace(0, 1, 41))[:, 0],
            atol=1e-12)
        error = np.linalg.norm(made.position - made.reference, axis=1)
        np.testing.assert_allclose(made.position_error_km, error * 389703.0, rtol=1e-9, atol=1e-6)
        self.assertIn((0, 1), guesses)
        self.assertEqual(made.solved.tried, 1)
        again = pickle.loads(pickle.dumps(made))
        np.testing.assert_array_equal(again.position, made.position)

    def test_a_powered_ascent_obeys_its_limits(self):
        reference = hodograph.AscentReference.gateway()
        made = hodograph.powered_ascent(reference, hodograph.ascent_start("+x"), intervals=30,
                                        guesses=1)
        self.assertLessEqual(np.linalg.norm(made.thrust, axis=1).max(), 5.0 + 1e-6)
        self.assertEqual(made.duration_s, 5400.0)
        self.assertAlmostEqual(np.linalg.norm(made.position[0]), 1740.0, delta=1e-6)
        spent = np.linalg.norm(made.thrust, axis=1).sum() * 5400.0 / 30
        self.assertAlmostEqual(made.velocity_change_m_s, spent, delta=1e-6 * spent)

    def test_refusals(self):
        reference = hodograph.AscentReference.gateway()
        start = hodograph.ascent_start("+z")
        for call in (lambda: hodograph.ascent_start("north"),
                     lambda: hodograph.tracking_ascent(reference, start, intervals=0),
                     lambda: hodograph.powered_ascent(reference, start, thrust_limit_m_s2=-1.0),
                     lambda: hodograph.powered_ascent(reference, start, progress=lambda *a: False)):
            with self.assertRaises(HodographError):
                call()


class Code(unittest.TestCase):
    def test_compiled_it_gives_the_same_bits(self):
        path = bend()
        code = hodograph.generate_code(path, "bend")
        self.assertEqual(pickle.loads(pickle.dumps(code)).source, code.source)
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / code.header_name).write_text(code.header)
            (Path(folder) / code.source_name).write_text(code.source)
            library = Path(folder) / "bend.so"
            subprocess.run(["cc", "-std=c99", "-O1", "-ffp-contract=off", "-shared", "-fPIC", "-o",
                            library, Path(folder) / code.source_name, "-lm"], check=True)
            compiled = ctypes.CDLL(str(library)).bend_position
            compiled.argtypes = [ctypes.c_double, ctypes.c_int, ctypes.POINTER(ctypes.c_double)]
            for xi in np.linspace(path.xi_begin, path.xi_end, 11):
                result = (ctypes.c_double * 4)()
                self.assertEqual(compiled(xi, 1, result), 0)
                np.testing.assert_array_equal(result[:2], path.position(xi))
                np.testing.assert_allclose(result[2:], hodograph.derivatives(path, xi, 1),
                                           atol=16 * EPSILON)

    def test_names_that_are_none_are_refused(self):
        for name in ("", "1a", "int", "a b", "a" * 64):
            with self.assertRaises(HodographError):
                hodograph.generate_code(bend(), name)


if __name__ == "__main__":
    unittest.main()
