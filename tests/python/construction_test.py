#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Constructions from Python: fits of callables, samples and SciPy splines; planar paths; files."""

import os
import tempfile
import unittest

import numpy as np
from scipy.interpolate import make_interp_spline

import hodograph
from hodograph import HodographError

EPSILON = np.finfo(float).eps


def helix(t):
    return np.array([[np.cos(t + k * np.pi / 2), np.sin(t + k * np.pi / 2), (t, 1, 0, 0, 0)[k]]
                     for k in range(5)])


class Fit(unittest.TestCase):
    def distance(self, path):
        xi = np.linspace(path.xi_begin, path.xi_end, 1000)
        return np.abs(path.position(xi) - np.array([helix(t)[0] for t in xi])).max()

    def test_of_a_callable_is_within_the_tolerance(self):
        for tolerance in (1e-3, 1e-9):
            made = hodograph.fit(helix, tolerance, 0.0, 6.0)
            self.assertLessEqual(self.distance(made.path), tolerance)
            self.assertLessEqual(made.error.upper, tolerance)
            self.assertFalse(made.certified)
            self.assertEqual(made.segment_errors.shape, (made.path.segment_count,))

    def test_of_samples_is_certified(self):
        t = np.linspace(0.0, 6.0, 200)
        samples = np.array([helix(x)[0] for x in t])
        made = hodograph.fit(samples, 1e-7, parameters=t)
        self.assertTrue(made.certified)
        # The spline itself is off by its own error, of order h^6 = 7e-10 times a derivative of 1.
        self.assertLessEqual(self.distance(made.path), 1e-7 + 1e-9)

    def test_of_a_scipy_spline(self):
        t = np.linspace(0.0, 6.0, 100)
        spline = make_interp_spline(t, np.array([helix(x)[0] for x in t]), k=7)
        path = hodograph.fit(spline, 1e-8).path
        self.assertEqual((path.xi_begin, path.xi_end), (0.0, 6.0))
        xi = np.linspace(0.0, 6.0, 1000)
        self.assertLessEqual(np.linalg.norm(path.position(xi) - spline(xi), axis=1).max(), 1e-8)

    def test_passes_on_what_the_callable_raises(self):
        with self.assertRaises(ZeroDivisionError):
            hodograph.fit(lambda t: 1 / 0, 1e-6, 0.0, 1.0)
        with self.assertRaisesRegex(HodographError, r"\(5, 3\)"):
            hodograph.fit(lambda t: np.zeros((4, 3)), 1e-6, 0.0, 1.0)

    def test_says_what_is_missing(self):
        with self.assertRaisesRegex(HodographError, "begin"):
            hodograph.fit(helix, 1e-6)
        with self.assertRaises(HodographError):
            hodograph.fit(helix, -1.0, 0.0, 1.0)
        with self.assertRaises(HodographError):
            hodograph.fit(np.zeros((0, 3)), 1e-6)


class Planar(unittest.TestCase):
    def test_splines_pass_through_their_points(self):
        points = np.array([[0, 0], [1, 2], [3, 1], [4, 4], [6, 3]], dtype=float)
        for options in ({}, {"closed": True},
                        {"parameters": hodograph.SplineParameters.chord_length}):
            path = hodograph.planar_spline(points, **options)
            np.testing.assert_allclose(path.position(path.knots)[:5], points, atol=1e3 * EPSILON)
        path = hodograph.waypoint_path(points, rule=hodograph.TangentRule.t1)
        np.testing.assert_allclose(path.position(path.knots), points, atol=1e3 * EPSILON)

    def test_lengths_are_as_prescribed(self):
        made = hodograph.prescribed_length_curve([0, 0], [1, 1], [4, 0], [1, -1], 6.0)
        path = made.curve
        self.assertTrue(made.loop_free)
        self.assertAlmostEqual(path.arc_length(), 6.0, delta=32 * EPSILON)
        np.testing.assert_allclose(path.position(1.0), [4.0, 0.0], atol=32 * EPSILON)
        with self.assertRaises(HodographError) as caught:
            hodograph.prescribed_length_curve([0, 0], [1, 1], [4, 0], [1, -1], 3.0)
        self.assertEqual(caught.exception.code, "no_interpolant")

    def test_corners_keep_to_their_bounds(self):
        path = hodograph.rounded_polyline([[0, 0], [10, 0], [10, 10]], most_curvature=2.0)
        curvature = np.abs(hodograph.curvature(path, np.linspace(path.xi_begin, path.xi_end, 999)))
        self.assertLessEqual(curvature.max(), 2.0 * (1 + 64 * EPSILON))
        self.assertGreater(curvature.max(), 1.9)

    def test_hermite_data_are_met(self):
        path = hodograph.planar_hermite_path([0.0, 2.0], [[0, 0], [4, 1]], [[1, 0], [0, 2]])
        np.testing.assert_allclose(hodograph.derivatives(path, [0.0, 2.0], 1), [[1, 0], [0, 2]],
                                   atol=64 * EPSILON)


class Files(unittest.TestCase):
    def test_documents_read_back_bit_for_bit(self):
        path = hodograph.planar_spline([[0, 0], [1, 2], [3, 1]])
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "path.json")
            hodograph.save_document(path, file, name="three points", length_unit="m")
            self.assertEqual(hodograph.load_document(file).path, path)
            with self.assertRaises(HodographError):
                hodograph.load_document(os.path.join(folder, "missing.json"))
            with self.assertRaises(HodographError):
                hodograph.save_document(path, os.path.join(folder, "missing", "path.json"))
        with self.assertRaises(HodographError) as caught:
            hodograph.parse_document("{")
        self.assertEqual(caught.exception.code, "malformed_document")


if __name__ == "__main__":
    unittest.main()
