#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rolled frames of every kind, twist, holonomy, continuity, helices."""

import json
import unittest
from pathlib import Path

import numpy as np

import hodograph
from hodograph import HodographError

GOLDEN = json.loads((Path(__file__).resolve().parents[1] / "golden" / "frames.json").read_text())
EPSILON = np.finfo(float).eps


def loop():
    return hodograph.closed_loop(0.3, 1.0, length=2.0)


def climb():
    return hodograph.climb_curve([0, 0, 0], [1, 0], [10, 5, 3], [0, 1], 0.2).curve


class Twist(unittest.TestCase):
    def test_is_that_of_the_golden_loops(self):
        for case in GOLDEN["twist"]:
            path = hodograph.closed_loop(case["input"]["xi"], case["input"]["psi"])
            expected = case["expected"]
            erf = hodograph.frame_twist(path, hodograph.FrameRoll.none(path)).total
            tolerance = case["rel_tol"] * max(1.0, abs(expected["T_ERF"]))
            self.assertAlmostEqual(erf.middle, expected["T_ERF"], delta=tolerance)

    def test_least_gammas(self):
        for case in GOLDEN["twist_min"]:
            path = hodograph.closed_loop(case["input"]["xi"], case["input"]["psi"])
            found = hodograph.least_twist_gamma(path)
            self.assertAlmostEqual(found.absolute_twist, case["expected"]["T_abs"],
                                   delta=1e-7 * max(1.0, case["expected"]["T_abs"]))
            twist = hodograph.frame_twist(path, hodograph.periodic_roll(path, found.gamma))
            self.assertAlmostEqual(twist.absolute.middle, found.absolute_twist, delta=1e-9)

    def test_of_a_rotation_minimising_frame_is_zero(self):
        for path in (loop(), climb()):
            twist = hodograph.frame_twist(path, hodograph.rotation_minimising_roll(path))
            self.assertEqual((twist.total.lower, twist.total.upper), (0.0, 0.0))


class Rolled(unittest.TestCase):
    def rolls(self, path):
        made = [hodograph.FrameRoll.none(path), hodograph.FrameRoll.linear(path, 0.5, 2.0),
                hodograph.rotation_minimising_roll(path, 0.25), hodograph.frenet_roll(path),
                hodograph.least_twist_roll(path),
                hodograph.rotation_minimising_roll_within(path, 1e-6)]
        if path.is_closed:
            gammas = hodograph.smooth_periodic_gammas(path)
            made += [hodograph.periodic_roll(path, gammas.negative), hodograph.closing_roll(path)]
        return made

    def test_frames_are_the_erf_turned_by_the_roll(self):
        for path in (loop(), climb()):
            xi = np.linspace(path.xi_begin, path.xi_end, 101)
            erf = hodograph.euler_rodrigues_frame(path, xi)
            for roll in self.rolls(path):
                theta = roll.angle(xi)
                c, s = np.cos(theta), np.sin(theta)
                turn = np.zeros((101, 3, 3))
                turn[:, 0, 0] = 1.0
                turn[:, 1, 1] = turn[:, 2, 2] = c
                turn[:, 2, 1], turn[:, 1, 2] = s, -s
                frames = hodograph.RolledFrames(path, roll).at(xi)
                np.testing.assert_allclose(frames, erf @ turn, atol=2.0**-45)
                state = hodograph.rolled_state(path, roll, xi)
                np.testing.assert_allclose(state.frame, frames, atol=2.0**-45)
                np.testing.assert_allclose(roll.derivatives(xi, 1)[:, 0], theta, atol=2.0**-45)
                w, x, y, z = state.rotation.T
                np.testing.assert_allclose(
                    frames[:, :, 0],
                    np.stack([w * w + x * x - y * y - z * z, 2 * (x * y + w * z),
                              2 * (x * z - w * y)], axis=1), atol=1e-13)

    def test_minimising_frames_in_one_go(self):
        path, xi = climb(), np.linspace(0.0, 1.0, 17)
        frames = hodograph.RolledFrames(path, hodograph.rotation_minimising_roll(path, 0.5)).at(xi)
        np.testing.assert_allclose(hodograph.rotation_minimising_frames(path, 1e-8, xi, 0.5),
                                   frames, atol=2e-8)

    def test_rates_are_the_derivatives_of_frames(self):
        path, h = climb(), 1e-5
        for roll in self.rolls(path):
            frames = hodograph.RolledFrames(path, roll)
            for xi in (0.2, 0.5, 0.8):
                turning = frames.at(xi).T @ (frames.at(xi + h) - frames.at(xi - h)) / (2 * h)
                chi = hodograph.rolled_state(path, roll, xi).body_rate_per_xi
                np.testing.assert_allclose(chi, [turning[2, 1], turning[0, 2], turning[1, 0]],
                                           atol=1e-6)

    def test_closing_frames_return(self):
        path = loop()
        self.assertAlmostEqual(hodograph.holonomy(path).roll, 2.0, delta=1e-12)
        for roll in (hodograph.closing_roll(path), hodograph.least_twist_roll(path),
                     hodograph.periodic_roll(path, -2.0)):
            ends = hodograph.RolledFrames(path, roll).at([0.0, 1.0])
            np.testing.assert_allclose(ends[0], ends[1], atol=1e-12)

    def test_frenet(self):
        path = climb()
        xi = np.linspace(0.1, 0.4, 7)
        state = hodograph.frenet(path, xi)
        np.testing.assert_allclose(state.curvature, hodograph.curvature(path, xi), rtol=1e-12)
        np.testing.assert_allclose(state.torsion, hodograph.torsion(path, xi), rtol=1e-9)
        bend = hodograph.derivatives(path, xi, 2)
        across = np.cross(hodograph.derivatives(path, xi, 1), bend)
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        np.testing.assert_allclose(state.frame[:, :, 2], across, atol=1e-10)

    def test_directions_can_be_asked_for(self):
        path = climb()
        theta = hodograph.roll_towards(path, 0.3, [0, 0, 1])
        frame = hodograph.RolledFrames(path, hodograph.FrameRoll.linear(path, theta, 0.0)).at(0.3)
        self.assertGreater(frame[2, 1], 0.9)
        self.assertAlmostEqual(frame[2, 2], 0.0, delta=1e-13)


class Smoothness(unittest.TestCase):
    def test_orders_are_those_of_the_constructions(self):
        data = np.array([[[np.cos(t + k * np.pi / 2), np.sin(t + k * np.pi / 2),
                           (t, 1, 0, 0, 0)[k]] for k in range(5)] for t in np.linspace(0, 5, 8)])
        path = hodograph.hermite_path(np.linspace(0, 5, 8), data)
        self.assertEqual(hodograph.continuity(path).position.order, 4)
        frame = hodograph.frame_continuity(path)
        self.assertEqual((frame.frame.order, frame.angular_velocity.order), (3, 2))
        one = hodograph.jumps_at_knot(path, 3)
        self.assertEqual((one.position.order, one.preimage.order), (4, 3))
        spline = hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4]])
        self.assertEqual(hodograph.continuity(spline).position.order, 2)

    def test_helices_are_recognised(self):
        found = hodograph.recognised_helix(climb())
        self.assertTrue(found.is_helix)
        np.testing.assert_allclose(found.axis, [0, 0, 1], atol=1e-12)
        self.assertAlmostEqual(found.stretches[0].sine, np.sin(0.2), delta=1e-14)
        self.assertFalse(hodograph.recognised_helix(loop()).is_helical)
        self.assertIn(np.sin(0.2), hodograph.sine_range(climb(), [0, 0, 1], 0, 0))
        u = hodograph.turn_upright([1.0, 2.0, 2.0])
        self.assertAlmostEqual(np.linalg.norm(u), 1.0, delta=4 * EPSILON)
        np.testing.assert_allclose(hodograph.unit_axis([0, 0, 5]), [0, 0, 1])


    def test_lifts_and_their_plans(self):
        plan = hodograph.planar_spline([[0, 0], [1, 2], [3, 1]])
        path = hodograph.lifted(plan, 5.0, 0.25)
        xi = np.linspace(0.0, 2.0, 30)
        np.testing.assert_allclose(path.position(xi)[:, :2], plan.position(xi), atol=1e-13)
        np.testing.assert_allclose(path.position(xi)[:, 2], 5.0 + 0.25 * plan.arc_length(xi),
                                   atol=1e-13)
        self.assertEqual(hodograph.lifted(plan, 0.0, [0.1, 0.2]).segment_count, 2)
        found = hodograph.helical_decomposition(path, 0, [0, 0, 1])
        self.assertAlmostEqual(found.sine / found.cosine, 0.25, delta=1e-14)
        size = np.abs(found.plan).max()
        same = min(np.abs(found.plan - plan.preimages[0]).max(),
                   np.abs(found.plan + plan.preimages[0]).max())
        self.assertLess(same, 1e-13 * size)


class Refusals(unittest.TestCase):
    def expect(self, code, call):
        with self.assertRaises(HodographError) as caught:
            call()
        self.assertEqual(caught.exception.code, code, str(caught.exception))

    def test_are_of_what_cannot_be_done(self):
        plane = hodograph.planar_spline([[0, 0], [1, 2], [3, 1]])
        path, nan = climb(), float("nan")
        roll = hodograph.rotation_minimising_roll(path)
        self.expect("unsupported", lambda: hodograph.rotation_minimising_roll(plane))
        self.expect("unsupported", lambda: hodograph.periodic_roll(path, 1.0))
        self.expect("unsupported", lambda: hodograph.frenet(plane, 0.5))
        self.expect("unsupported", lambda: hodograph.recognised_helix(plane))
        self.expect("unsupported", lambda: hodograph.holonomy(path))
        self.expect("outside_domain", lambda: hodograph.periodic_roll(loop(), 0.0))
        self.expect("outside_domain", lambda: roll.angle([0.5, 2.0]))
        self.expect("outside_domain", lambda: roll.angle(nan))
        self.expect("outside_domain", lambda: roll.method(7))
        self.expect("outside_domain", lambda: hodograph.RolledFrames(path, roll).at([nan]))
        self.expect("outside_domain", lambda: hodograph.unit_axis([0, 0, 0]))
        self.expect("outside_domain", lambda: hodograph.jumps_at_knot(path, 0))
        self.expect("outside_domain", lambda: hodograph.sine_range(path, [0, 0, 1], 0, 5))
        self.expect("not_finite", lambda: hodograph.FrameRoll.linear(path, nan, 0.0))
        self.expect("not_finite", lambda: hodograph.rotation_minimising_roll(path, nan))
        self.expect("mismatched_size",
                    lambda: hodograph.RolledFrames(hodograph.scaled(loop(), 2.0),
                                                   hodograph.FrameRoll.none(
                                                       hodograph.reparametrised(loop(), 0, 2))))
        self.assertEqual(hodograph.RolledFrames(path, roll).at([]).shape, (0, 3, 3))
        self.expect("mismatched_size", lambda: hodograph.lifted(plane, 0.0, [0.1, 0.2, 0.3]))
        self.expect("unsupported", lambda: hodograph.lifted(path, 0.0, 0.1))
        self.expect("not_finite", lambda: hodograph.lifted(plane, 0.0, nan))
        self.expect("unsupported", lambda: hodograph.helical_decomposition(loop(), 0, [0, 0, 1]))
        self.expect("outside_domain", lambda: hodograph.helical_decomposition(path, 5, [0, 0, 1]))


if __name__ == "__main__":
    unittest.main()
