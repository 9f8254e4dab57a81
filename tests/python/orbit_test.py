#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Three-body motion and periodic orbits: against printed values and SciPy's integrator."""

import copy
import pickle
import unittest

import numpy as np
from scipy.integrate import solve_ivp

import hodograph
from hodograph import HodographError

SYSTEM = hodograph.earth_moon_system
MU = SYSTEM.mass_ratio


def potential(p):
    x, y, z = np.moveaxis(np.asarray(p), -1, 0)
    return ((x**2 + y**2) / 2 + (1 - MU) / np.sqrt((x + MU)**2 + y**2 + z**2)
            + MU / np.sqrt((x - 1 + MU)**2 + y**2 + z**2))


def rate(_, s):
    g = hodograph.pseudo_potential_gradient(SYSTEM, s[:3])
    return [*s[3:], g[0] + 2 * s[4], g[1] - 2 * s[3], g[2]]


class ThreeBody(unittest.TestCase):
    points = np.array([[[0.5, 0.3, -0.2], [1.1, 0.0, 0.1]]])

    def test_the_potential_and_its_derivatives(self):
        np.testing.assert_allclose(hodograph.pseudo_potential(SYSTEM, self.points),
                                   potential(self.points), rtol=1e-15)
        step = 2.0**-17
        gradient = hodograph.pseudo_potential_gradient(SYSTEM, self.points)
        hessian = hodograph.pseudo_potential_hessian(SYSTEM, self.points)
        self.assertEqual((gradient.shape, hessian.shape), ((1, 2, 3), (1, 2, 3, 3)))
        for i in range(3):
            e = step * np.eye(3)[i]
            np.testing.assert_allclose(
                gradient[..., i], (potential(self.points + e) - potential(self.points - e))
                / (2 * step), rtol=1e-6)
            np.testing.assert_allclose(
                hessian[..., i], (hodograph.pseudo_potential_gradient(SYSTEM, self.points + e)
                                  - hodograph.pseudo_potential_gradient(SYSTEM, self.points - e))
                / (2 * step), rtol=1e-5, atol=1e-7)

    def test_motion_is_that_of_another_integrator(self):
        start = np.array([1.02, 0.01, -0.18, 0.02, -0.11, 0.03])
        there = hodograph.propagate(SYSTEM, start, 1.0)
        peer = solve_ivp(rate, (0.0, 1.0), start, method="DOP853", rtol=1e-12, atol=1e-13)
        np.testing.assert_allclose(there.state, peer.y[:, -1], atol=1e-9)
        back = hodograph.propagate(SYSTEM, there.state, -1.0).state
        np.testing.assert_allclose(back, start, atol=1e-12)
        self.assertAlmostEqual(hodograph.jacobi_constant(SYSTEM, start),
                               hodograph.jacobi_constant(SYSTEM, there.state), delta=1e-13)
        np.testing.assert_allclose(hodograph.three_body_acceleration(SYSTEM, start),
                                   rate(0.0, start)[3:], rtol=1e-14)

    def test_variations_are_differences(self):
        start = np.array([1.02, 0.01, -0.18, 0.02, -0.11, 0.03])
        made = hodograph.propagate_variations(SYSTEM, start, 0.5)
        step = 2.0**-20
        for i in range(6):
            e = step * np.eye(6)[i]
            difference = (hodograph.propagate(SYSTEM, start + e, 0.5).state
                          - hodograph.propagate(SYSTEM, start - e, 0.5).state) / (2 * step)
            np.testing.assert_allclose(made.transition[:, i], difference, rtol=1e-6, atol=1e-6)
        # The flow keeps volumes.
        self.assertAlmostEqual(np.linalg.det(made.transition), 1.0, delta=1e-9)

    def test_derivatives_of_motion_and_frames(self):
        start = np.array([1.02, 0.01, -0.18, 0.02, -0.11, 0.03])
        jet = hodograph.motion_derivatives(SYSTEM, start)
        np.testing.assert_array_equal(jet[:2].ravel(), start)
        np.testing.assert_allclose(jet[2], rate(0.0, start)[3:], rtol=1e-14)
        step = 2.0**-8
        ahead, behind = (hodograph.motion_derivatives(
            SYSTEM, hodograph.propagate(SYSTEM, start, s).state) for s in (step, -step))
        np.testing.assert_allclose(jet[1:], np.vstack([(ahead - behind)[:4] / (2 * step)]),
                                   rtol=2e-3, atol=2e-3)
        t = 0.7
        inertial = hodograph.to_earth_centred_inertial(SYSTEM, jet, t)
        turned = np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]])
        np.testing.assert_allclose(inertial[0], turned @ (start[:3] + [MU, 0, 0]), rtol=1e-14)
        np.testing.assert_allclose(
            inertial[1], turned @ (start[3:] + np.cross([0, 0, 1], start[:3] + [MU, 0, 0])),
            rtol=1e-14)
        np.testing.assert_allclose(
            hodograph.from_earth_centred_inertial(SYSTEM, inertial, t), jet, atol=1e-14)
        np.testing.assert_allclose(hodograph.smaller_primary_inertial(t),
                                   [np.cos(t), np.sin(t), 0.0])

    def test_refusals(self):
        start = [1.02, 0.01, -0.18, 0.02, -0.11, 0.03]
        for call in (lambda: hodograph.propagate(SYSTEM, start[:5], 1.0),
                     lambda: hodograph.propagate(SYSTEM, [np.nan, *start[1:]], 1.0),
                     lambda: hodograph.propagate(SYSTEM, start, np.inf),
                     lambda: hodograph.propagate(SYSTEM, start, 1.0, max_steps=3),
                     lambda: hodograph.propagate(SYSTEM, [1 - MU, 0, 0, 0, 0, 0], 1.0),
                     lambda: hodograph.pseudo_potential(SYSTEM, [-MU, 0.0, 0.0]),
                     lambda: hodograph.pseudo_potential(SYSTEM, 1.0),
                     lambda: hodograph.pseudo_potential(SYSTEM, [[np.nan, 0, 0]]),
                     lambda: hodograph.ThreeBodySystem(0.9, 1.0, 1.0),
                     lambda: hodograph.to_earth_centred_inertial(SYSTEM, np.zeros((3, 3)), 0.0),
                     lambda: hodograph.next_plane_crossing(SYSTEM, start, 1e-6)):
            with self.assertRaises(HodographError):
                call()


class Orbits(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.orbit = hodograph.lunar_gateway_nrho()

    def test_the_orbit_of_the_catalogue(self):
        orbit = self.orbit
        # Recomputed in forty digits elsewhere; the catalogue's period is 7.008 days.
        np.testing.assert_allclose(orbit.initial,
                                   [1.02731322944525, 0, -0.18551533506611556, 0,
                                    -0.114498861101236, 0], rtol=0, atol=1e-14)
        self.assertAlmostEqual(orbit.period, 1.58092382295613, delta=1e-14)
        self.assertAlmostEqual(orbit.period * SYSTEM.time_unit_s / 86400, 7.008, delta=5e-4)
        self.assertLessEqual(orbit.crossing_residual, hodograph.crossing_tolerance)
        self.assertAlmostEqual(orbit.jacobi, hodograph.jacobi_constant(SYSTEM, orbit.initial),
                               delta=1e-14)
        half = hodograph.next_plane_crossing(SYSTEM, orbit.initial, 1.0)
        self.assertAlmostEqual(2 * half, orbit.period, delta=1e-12)
        values = np.linalg.eigvals(orbit.monodromy)
        for index in orbit.stability_indices:
            pair = 0.5 * (values + 1 / values)
            self.assertLess(np.abs(pair - index).min(), 1e-4)

    def test_corrections_and_continuation(self):
        guess = self.orbit.initial + [1e-4, 0, 0, 0, 1e-4, 0]
        again = hodograph.correct_symmetric_orbit(SYSTEM, guess[0], guess[2], guess[4])
        np.testing.assert_allclose(again.initial, self.orbit.initial, atol=1e-13)
        longer = hodograph.continue_to_period(self.orbit, self.orbit.period + 0.01)
        self.assertAlmostEqual(longer.period, self.orbit.period + 0.01, delta=1e-15)
        with self.assertRaises(HodographError):
            hodograph.correct_symmetric_orbit(SYSTEM, 1.02, -0.18, np.nan)
        with self.assertRaises(HodographError):
            hodograph.correct_symmetric_orbit(SYSTEM, guess[0], guess[2], guess[4], -1.0)

    def test_curves_and_fits(self):
        curve = hodograph.OrbitCurve(self.orbit)
        self.assertAlmostEqual(curve.end, self.orbit.period, delta=1e-15)
        t = np.linspace(0.0, curve.end, 7)
        jets = curve(t)
        self.assertEqual(jets.shape, (7, 5, 3))
        for time, jet in zip(t, jets):
            state = hodograph.propagate(SYSTEM, self.orbit.initial, time).state
            np.testing.assert_allclose(jet[:2].ravel(), state, atol=1e-12)
        fitted = hodograph.fit(curve, 1e-6, 0.0, curve.end, periodic=True)
        self.assertTrue(fitted.path.is_closed)
        t = np.linspace(0.0, curve.end, 500)
        np.testing.assert_allclose(fitted.path.position(t), curve(t)[:, 0], atol=1e-6)
        inertial = hodograph.OrbitCurve(
            self.orbit, frame=hodograph.OrbitFrame.earth_centred_inertial,
            parameter=hodograph.OrbitParameter.revolutions, revolutions=2)
        self.assertEqual((inertial.end, inertial.revolutions), (2.0, 2))
        expected = hodograph.to_earth_centred_inertial(SYSTEM, curve(0.3 * self.orbit.period),
                                                       0.3 * self.orbit.period)
        np.testing.assert_allclose(inertial(0.3)[0], expected[0], atol=1e-13)
        with self.assertRaises(HodographError):
            curve([0.0, np.nan])
        with self.assertRaises(HodographError):
            hodograph.OrbitCurve(self.orbit, revolutions=0)

    def test_pickles_lose_nothing(self):
        for again in (pickle.loads(pickle.dumps(self.orbit)), copy.copy(self.orbit)):
            np.testing.assert_array_equal(again.initial, self.orbit.initial)
            np.testing.assert_array_equal(again.monodromy, self.orbit.monodromy)
            self.assertEqual((again.closure, again.iterations, again.stability_indices),
                             (self.orbit.closure, self.orbit.iterations,
                              self.orbit.stability_indices))
            a, b = hodograph.OrbitCurve(again), hodograph.OrbitCurve(self.orbit)
            np.testing.assert_array_equal(a(0.4), b(0.4))
        again = pickle.loads(pickle.dumps(hodograph.OrbitCurve(self.orbit, revolutions=3)))
        self.assertEqual(again.revolutions, 3)


if __name__ == "__main__":
    unittest.main()
