#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Path: numbers in and out, evaluation at numbers and arrays, operations, refusals."""

import copy
import pickle
import unittest

import numpy as np

import hodograph
from hodograph import HodographError

EPSILON = np.finfo(float).eps


def planar():
    return hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4]])


def spatial():
    """Three quarters of a turn of a helix, and its derivatives are known."""
    knots = np.linspace(0.0, 4.5, 7)
    points = np.stack([[np.cos(knots + k * np.pi / 2), np.sin(knots + k * np.pi / 2),
                        [knots, 0 * knots + 1, 0 * knots, 0 * knots, 0 * knots][k]]
                       for k in range(5)])
    return hodograph.hermite_path(knots, points.transpose(2, 0, 1))


class Numbers(unittest.TestCase):
    def test_a_path_is_its_numbers(self):
        for path in (planar(), spatial()):
            again = hodograph.Path(path.knots, path.starts, path.preimages, closed=path.is_closed)
            self.assertEqual(again, path)
            self.assertEqual(path.preimages.shape,
                             (path.segment_count, path.preimage_degree + 1,
                              2 if path.dimension == 2 else 4))

    def test_copies_pickles_and_documents_are_equal(self):
        for path in (planar(), spatial()):
            self.assertEqual(pickle.loads(pickle.dumps(path)), path)
            self.assertEqual(copy.copy(path), path)
            self.assertEqual(copy.deepcopy(path), path)
            self.assertEqual(hodograph.parse_document(hodograph.to_json(path)).path, path)

    def test_views_live_on_and_cannot_be_written(self):
        knots = planar().knots
        self.assertEqual(knots.tolist(), [0.0, 1.0, 2.0, 3.0])
        with self.assertRaises(ValueError):
            knots[0] = 1.0

    def test_repr_says_what_it_is(self):
        self.assertIn("planar, degree 5, 3 segments", repr(planar()))


class Evaluation(unittest.TestCase):
    def test_shapes_follow_the_parameters(self):
        path = spatial()
        grid = np.linspace(0.0, 4.5, 12).reshape(3, 4)
        self.assertEqual(path.position(grid).shape, (3, 4, 3))
        self.assertEqual(path.speed(grid).shape, (3, 4))
        self.assertEqual(path.position(1.0).shape, (3,))
        self.assertIsInstance(path.speed(1.0), float)
        self.assertEqual(hodograph.euler_rodrigues_frame(path, grid).shape, (3, 4, 3, 3))
        self.assertEqual(path.position([]).shape, (0, 3))
        self.assertEqual(hodograph.body_rate_per_xi(planar(), grid / 2).shape, (3, 4))

    def test_the_state_is_what_the_single_functions_give(self):
        for path in (planar(), spatial()):
            xi = np.linspace(path.xi_begin, path.xi_end, 300)
            state = hodograph.evaluate(path, xi)
            np.testing.assert_array_equal(state.position, path.position(xi))
            np.testing.assert_array_equal(state.speed, path.speed(xi))
            np.testing.assert_array_equal(state.arc_length, path.arc_length(xi))
            np.testing.assert_array_equal(state.frame, hodograph.euler_rodrigues_frame(path, xi))
            identity = np.eye(path.dimension)
            turned = np.swapaxes(state.frame, 1, 2) @ state.frame
            np.testing.assert_allclose(turned - identity, 0.0, atol=16 * EPSILON)
            np.testing.assert_allclose(state.frame[:, :, 0], hodograph.tangent(path, xi),
                                       atol=8 * EPSILON)

    def test_the_identity_of_speed_and_hodograph(self):
        path = spatial()
        xi = np.linspace(0.0, 4.5, 100)
        along = hodograph.derivatives(path, xi, 1)
        np.testing.assert_allclose(np.linalg.norm(along, axis=1), path.speed(xi),
                                   rtol=16 * EPSILON)
        np.testing.assert_array_equal(hodograph.derivatives(path, xi, 0), path.position(xi))

    def test_a_helix_has_the_curvature_and_torsion_of_one(self):
        path = hodograph.fit(lambda t: np.array(
            [[np.cos(t + k * np.pi / 2), np.sin(t + k * np.pi / 2), (t, 1, 0, 0, 0)[k]]
             for k in range(5)]), 1e-12, 0.0, 4.5).path
        # Both are 1/2; they are second and third derivatives of a curve fitted to order ten.
        for value in (hodograph.curvature(path, path.knots), hodograph.torsion(path, path.knots)):
            np.testing.assert_allclose(value, 0.5, atol=2.0**-30)

    def test_arc_length_and_its_inverse(self):
        for path in (planar(), spatial()):
            s = np.linspace(0.0, path.arc_length(), 200)
            xi = path.parameter_at_arc_length(s)
            np.testing.assert_allclose(path.arc_length(xi), s,
                                       atol=8 * EPSILON * path.arc_length())
            np.testing.assert_allclose(path.point_at_arc_length(s), path.position(xi),
                                       atol=32 * EPSILON * path.arc_length())


class Operations(unittest.TestCase):
    def test_each_does_what_it_says(self):
        path = spatial()
        back = hodograph.reversed(path)
        np.testing.assert_allclose(back.position(back.xi_begin), path.position(path.xi_end),
                                   atol=8 * EPSILON * path.arc_length())
        first, second = (hodograph.subpath(path, 0.0, 2.0), hodograph.subpath(path, 2.0, 4.5))
        whole = hodograph.joined(hodograph.with_preimage_degree(first, 9), second)
        self.assertEqual(whole.preimage_degree, 9)
        self.assertAlmostEqual(whole.arc_length(), path.arc_length(),
                               delta=32 * EPSILON * path.arc_length())
        self.assertEqual(hodograph.lifted(planar()).dimension, 3)
        self.assertAlmostEqual(hodograph.scaled(path, 2.0).arc_length(), 2.0 * path.arc_length(),
                               delta=32 * EPSILON * path.arc_length())
        shifted = hodograph.moved(path, translation=[1.0, 2.0, 3.0])
        np.testing.assert_array_equal(shifted.starts, path.starts + [1.0, 2.0, 3.0])
        turned = hodograph.moved(planar(), np.pi / 2)
        np.testing.assert_allclose(turned.position(3.0), [-4.0, 4.0], atol=64 * EPSILON)
        mirrored = hodograph.reflected(path, [0.0, 0.0, 1.0])
        np.testing.assert_allclose(mirrored.position(2.0), path.position(2.0) * [1, 1, -1],
                                   atol=16 * EPSILON)
        self.assertAlmostEqual(hodograph.reparametrised(path, 0.0, 1.0).arc_length(),
                               path.arc_length(), delta=32 * EPSILON * path.arc_length())


class Refusals(unittest.TestCase):
    def expect(self, code, call):
        with self.assertRaises(HodographError) as caught:
            call()
        self.assertIsInstance(caught.exception, ValueError)
        self.assertEqual(caught.exception.code, code)
        self.assertTrue(str(caught.exception))
        return caught.exception

    def test_they_name_place_value_and_bound(self):
        error = self.expect("outside_domain", lambda: spatial().position([0.0, 1.0, 5.0]))
        self.assertEqual((error.index, error.value, error.bound), (2, 5.0, 4.5))
        error = self.expect("outside_domain",
                            lambda: hodograph.curvature(spatial(), np.full(1000, -1.0)))
        self.assertEqual(error.index, 0)

    def test_nothing_is_nan(self):
        nan = float("nan")
        self.expect("outside_domain", lambda: spatial().position(nan))
        self.expect("outside_domain", lambda: spatial().parameter_at_arc_length([0.0, nan]))
        self.expect("not_finite", lambda: hodograph.planar_spline([[0, 0], [1, nan], [2, 0]]))

    def test_shapes_that_do_not_fit(self):
        error = self.expect("mismatched_size", lambda: hodograph.planar_spline([[0, 0, 1]]))
        self.assertIn("(n, 2)", str(error))
        self.expect("mismatched_size", lambda: hodograph.Path([0, 1], [[0, 0]], [[[1, 0, 0, 0]]]))
        self.expect("mismatched_size", lambda: hodograph.Path([0, 1], [[0, 0]], [[[1, 0]]] * 2))
        self.expect("mismatched_size", lambda: hodograph.hermite_path([0, 1], np.zeros((2, 4, 3))))
        self.expect("mismatched_size", lambda: hodograph.reflected(planar(), [0, 0, 1]))
        self.expect("unsupported", lambda: hodograph.torsion(planar(), 0.5))
        self.expect("unsupported", lambda: hodograph.lifted(spatial()))
        self.expect("unsupported", lambda: hodograph.derivatives(spatial(), 0.0, 5))

    def test_straight_lines_have_no_torsion(self):
        line = hodograph.Path([0.0, 1.0], [[0.0, 0.0, 0.0]], [[[1.0, 0.0, 0.0, 0.0]]])
        self.expect("outside_domain", lambda: hodograph.torsion(line, 0.5))
        still = hodograph.Path([0.0, 1.0], [[0.0, 0.0]], [[[0.0, 0.0], [1.0, 0.0]]])
        error = self.expect("zero_speed", lambda: hodograph.tangent(still, [0.5, 0.0]))
        self.assertEqual(error.index, 1)


if __name__ == "__main__":
    unittest.main()
