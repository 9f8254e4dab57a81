#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Climbs, closed loops, planar curves of single problems: golden values and what is promised."""

import json
import pickle
import unittest
from pathlib import Path

import numpy as np

import hodograph
from hodograph import HodographError

GOLDEN = Path(__file__).resolve().parents[1] / "golden"
EPSILON = np.finfo(float).eps


def golden(file, group):
    return json.loads((GOLDEN / f"{file}.json").read_text(encoding="utf-8"))[group]


class Climbs(unittest.TestCase):
    def test_are_the_golden_ones(self):
        for case in golden("climb", "helical"):
            given, expected = case["input"], case["expected"]
            ends = (given["r_s"], hodograph.direction_of_angle(given["phi_s"]), given["r_e"],
                    hodograph.direction_of_angle(given["phi_e"]), given["theta"])
            if not expected["feasible"]:
                self.assertRaises(HodographError, hodograph.climb_curve, *ends)
                continue
            made = hodograph.climb_curve(*ends)
            self.assertAlmostEqual(made.ground_length, expected["S"], delta=1e-11)
            end = made.curve.position(1.0)
            size = max(1.0, made.curve.arc_length())
            np.testing.assert_allclose(end, given["r_e"], atol=1e-11 * size)
            slope = hodograph.tangent(made.curve, np.linspace(0, 1, 50))[:, 2]
            np.testing.assert_allclose(slope, np.sin(given["theta"]), atol=1e-12)
            self.assertEqual(len(hodograph.climb_solutions(*ends)), len(expected["solutions"]))
        for case in golden("climb", "reject"):
            given = case["input"]
            with self.assertRaises(HodographError):
                hodograph.climb_curve(given["r_s"], hodograph.direction_of_angle(given["phi_s"]),
                                      given["r_e"], hodograph.direction_of_angle(given["phi_e"]),
                                      given["theta"])

    def test_many_are_the_same_as_one(self):
        begins, ends = np.zeros((3, 3)), np.array([[10, 5, 3], [8, -3, 4], [9, 1, 2]], dtype=float)
        headings = np.array([[1, 0], [1, 1], [0, 1]], dtype=float)
        preimages, lengths, indices, margins = hodograph.climb_curves(begins, headings, ends,
                                                                      headings[::-1], 0.15)
        for i in range(3):
            one = hodograph.climb_curve(begins[i], headings[i], ends[i], headings[::-1][i], 0.15)
            np.testing.assert_array_equal(one.curve.preimages[0], preimages[i])
            self.assertEqual((one.ground_length, one.rotation_index, one.margin),
                             (lengths[i], indices[i], margins[i]))

    def test_limits_are_kept(self):
        ends = ([0, 0, 0], [1, 0], [100, 40, 30], [0, 1])
        made = hodograph.climb_path_within(*ends, climb_angle=0.2, descent_angle=0.2,
                                           turn_radius=15.0)
        self.assertLessEqual(made.climb_angle, 0.2 + 4 * EPSILON)
        self.assertLessEqual(made.most_ground_curvature, 1 / 15.0)
        np.testing.assert_allclose(made.path.position(made.path.xi_end), ends[2], atol=1e-10)
        exact = hodograph.climb_path(*ends, 0.1, 15.0)
        self.assertEqual(exact.climb_angle, 0.1)
        self.assertAlmostEqual(exact.ground_length, 30 / np.tan(0.1), delta=1e-10)
        longer = hodograph.climb_path_of_ground_length(*ends, 400.0, 15.0)
        self.assertAlmostEqual(longer.path.arc_length(), np.hypot(400.0, 30.0), delta=1e-9)
        helix = hodograph.helical_curve([0, 0, 1], [0, 0, 0], [1, 0, 0.1], [5, 3, 1.0],
                                        [0, 1, 0.1])
        self.assertAlmostEqual(helix.climb_angle, np.arctan(0.1), delta=1e-14)

    def test_routes_pass_their_waypoints(self):
        places = [[0, 0, 0], [100, 0, 10], [100, 100, 20], [0, 100, 20]]
        waypoints = [hodograph.ClimbWaypoint(places[0], heading=[1, 0])]
        waypoints += [hodograph.ClimbWaypoint(place) for place in places[1:]]
        route = hodograph.climb_route(waypoints, climb_angle=0.3, descent_angle=0.3,
                                      turn_radius=10.0)
        self.assertEqual(len(route.spans), 3)
        self.assertEqual(len(route.joints), 2)
        knots = [route.path.knots[span.first] for span in route.spans] + [route.path.xi_end]
        np.testing.assert_allclose(route.path.position(knots), places, atol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(route.headings, axis=1), 1.0, atol=1e-12)


class Loops(unittest.TestCase):
    def test_control_points_and_curvatures(self):
        for case in golden("closed_loops", "loop"):
            shape, expected = case["input"], case["expected"]
            points = hodograph.closed_loop_control_points(shape["xi"], shape["psi"])
            size = max(1.0, np.abs(expected["control_points"]).max())
            np.testing.assert_allclose(points, expected["control_points"],
                                       atol=case["rel_tol"] * size)
            juncture = hodograph.closed_loop_juncture(shape["xi"], shape["psi"])
            self.assertAlmostEqual(juncture.curvature / expected["curvature_0"], 1.0, delta=1e-11)
            path = hodograph.closed_loop(shape["xi"], shape["psi"], length=3.0, start=[1, 2, 3])
            self.assertAlmostEqual(path.arc_length(), 3.0, delta=16 * EPSILON)
            np.testing.assert_allclose(path.position(1.0), [1, 2, 3], atol=64 * EPSILON)

    def test_choices_serve_their_purpose(self):
        near = hodograph.choose_loop(hodograph.LoopPurpose.near_point, point=[0.1, 0.2, 0.1])
        self.assertLess(near.value.upper, 1e-9)
        self.assertLess(hodograph.nearest_point(near.path, [0.1, 0.2, 0.1]).distance.upper, 1e-9)
        calm = hodograph.choose_loop()
        self.assertAlmostEqual(calm.value.middle, 39.64, delta=0.01)
        self.assertEqual(pickle.loads(pickle.dumps(calm)).shape, calm.shape)
        facts = hodograph.loop_facts(calm.path)
        self.assertAlmostEqual(facts.energy.middle, calm.value.middle, delta=1e-9)
        self.assertEqual(len(facts.box), 3)

    def test_frames_at_the_start(self):
        q = hodograph.frame_towards([1, 1, 0], [0, 0, 1])
        path = hodograph.closed_loop(0.2, 2.0, frame=q)
        frame = hodograph.euler_rodrigues_frame(path, 0.0)
        np.testing.assert_allclose(frame[:, 0], np.array([1, 1, 0]) / np.sqrt(2), atol=1e-14)
        np.testing.assert_allclose(frame[:, 1], [0, 0, 1], atol=1e-14)
        self.assertAlmostEqual(np.linalg.norm(hodograph.level_frame([1, 2, 3], 0.4)), 1.0,
                               delta=4 * EPSILON)


class Planar(unittest.TestCase):
    def test_prescribed_lengths_have_the_golden_curvatures(self):
        for case in golden("planar_curvature", "kmax_vs_S"):
            given, expected = case["input"], case["expected"]
            made = hodograph.prescribed_length_curve(
                given["q0"], hodograph.direction_of_angle(given["theta0"]), given["q1"],
                hodograph.direction_of_angle(given["theta1"]), given["S"])
            self.assertAlmostEqual(made.rotation_index, expected["R_abs"], delta=1e-9)
            most = hodograph.curvature_extremes(made.curve, relative_width=2.0**-40).range
            self.assertAlmostEqual(max(-most.lower, most.upper) / expected["kappa_max"], 1.0,
                                   delta=1e-9)

    def test_hermite_solutions(self):
        data = ([0, 0], [4, 1], [3, 1], [0, 2])
        best = hodograph.planar_hermite(*data)
        all_four = hodograph.planar_hermite_solutions(*data)
        self.assertEqual(len(all_four), 4)
        self.assertEqual(all_four[0].curve, best.curve)
        self.assertAlmostEqual(all_four[1].rotation_index - best.rotation_index, best.margin,
                               delta=1e-12)
        positions, derivatives = hodograph.hermite_data_of_control_points(
            [0, 0], [1, 0], [2, 1], [3, 3])
        np.testing.assert_allclose(positions, [[0, 0], [3, 3]])
        np.testing.assert_allclose(derivatives, [[5, 0], [5, 10]])

    def test_corners(self):
        corner = ([0, 0], [10, 0], [10, 10])
        made = hodograph.corner_of_curvature(*corner, 2.0)
        most = hodograph.curvature_extremes(made.curve).maximum
        self.assertAlmostEqual(most.middle, 2.0, delta=1e-5)
        self.assertAlmostEqual(hodograph.corner_of_deviation(*corner, 0.5).shape.deviation, 0.5,
                               delta=1e-14)
        self.assertEqual(hodograph.corner_of_room(*corner).leg, 10.0)
        one = hodograph.corner_of_leg(*corner, 2.0)
        self.assertAlmostEqual(one.curve.arc_length(), one.shape.arc_length, delta=1e-14)
        self.assertAlmostEqual(hodograph.corner_shape(*corner).turning_angle, np.pi / 2, delta=1e-15)
        self.assertAlmostEqual(hodograph.corner_clearance_factor(np.pi), 32 / 15, delta=1e-14)
        path = hodograph.rounded_polyline_of_legs([[0, 0], [10, 0], [10, 10]], [2.0])
        self.assertEqual(path.segment_count, 3)
        tangents = hodograph.waypoint_tangents([[0, 0], [1, 0], [2, 0]],
                                               rule=hodograph.TangentRule.t1)
        np.testing.assert_allclose(tangents, [[1, 0]] * 3, atol=1e-15)

    def test_turn_limits_and_least_peaks(self):
        ends = ([0, 0], [1, 0], [10, 3], [0, 1])
        path = hodograph.turn_limited_path(*ends, 20.0, 1.0)
        self.assertAlmostEqual(path.path.arc_length(), 20.0, delta=1e-12)
        self.assertLessEqual(path.most_curvature, 1.0)
        short = hodograph.shortest_turn_limited_path(*ends, 1.0)
        self.assertLess(short.path.arc_length(), 13.0)
        lengths = [hodograph.least_peak_curvature_of_length(*ends, most) for most in (12.0, 30.0)]
        for made, most in zip(lengths, (12.0, 30.0)):
            self.assertLessEqual(made.curve.arc_length(), most * (1 + 8 * EPSILON))
            self.assertNotEqual(made.kind, hodograph.PeakMinimum.straight_line)
            self.assertLess(made.peak_curvature.upper, 1.0)
        equal = hodograph.least_peak_curvature_of_equal_speeds(*ends, 30.0)
        free = hodograph.least_peak_curvature_of_speeds(*ends, 30.0)
        self.assertLessEqual(free.peak_curvature.upper, equal.peak_curvature.upper * 1.001)

    def test_splines_say_how_they_were_found(self):
        points = [[0, 0], [1, 2], [3, 1], [4, 4]]
        made = hodograph.planar_spline_with_report(points, with_energy=True)
        self.assertEqual(made.path, hodograph.planar_spline(points))
        self.assertAlmostEqual(made.report.energy, hodograph.bending_energy(made.path), delta=1e-9)

    def test_many_lengths_are_the_same_as_one(self):
        begins, ends = np.zeros((2, 2)), np.array([[4.0, 0.0], [3.0, 1.0]])
        along = np.array([[1.0, 1.0], [1.0, 0.0]])
        preimages, indices, margins = hodograph.prescribed_length_curves(begins, along, ends,
                                                                         along, [6.0, 5.0])
        for i, length in enumerate((6.0, 5.0)):
            one = hodograph.prescribed_length_curve(begins[i], along[i], ends[i], along[i], length)
            np.testing.assert_array_equal(one.curve.preimages[0], preimages[i])
            self.assertEqual((one.rotation_index, one.margin), (indices[i], margins[i]))

    def test_self_crossings(self):
        path = hodograph.planar_spline([[0, 0], [1, 0]])
        with self.assertRaises(HodographError):
            hodograph.crosses_itself(hodograph.planar_spline([[0, 0], [1, 2], [3, 1]]))
        self.assertFalse(hodograph.crosses_itself(path))


class Spatial(unittest.TestCase):
    def data(self, t):
        return np.array([[np.cos(t + k * np.pi / 2), np.sin(t + k * np.pi / 2),
                          (t, 1, 0, 0, 0)[k]] for k in range(5)])

    def test_hermite_curves_meet_their_data(self):
        for order in (1, 2, 4):
            begin, end = self.data(0.0)[:order + 1], self.data(0.5)[:order + 1]
            for free in ({}, {"choice": hodograph.HermiteChoice.order_six, "theta_middle": 0.1}):
                curve = hodograph.hermite_curve(begin, end, 0.5, **free)
                for r in range(order + 1):
                    np.testing.assert_allclose(hodograph.derivatives(curve, [0.0, 0.5], r),
                                               [begin[r], end[r]], atol=1e-9)

    def test_splines_and_their_error(self):
        t = np.linspace(0.0, 6.0, 100)
        samples = np.array([self.data(x)[0] for x in t])
        spline = hodograph.InterpolatingSpline(t, samples)
        np.testing.assert_allclose(spline(t)[:, 0], samples, atol=1e-13)
        made = hodograph.fit(samples, 1e-7, parameters=t)
        error = hodograph.spline_error(spline, made.path)
        self.assertTrue(error.certified)
        self.assertEqual(error.error, made.error)


class Refusals(unittest.TestCase):
    def expect(self, code, call):
        with self.assertRaises(HodographError) as caught:
            call()
        self.assertEqual(caught.exception.code, code, str(caught.exception))

    def test_are_of_what_cannot_be_done(self):
        nan = float("nan")
        ends = ([0, 0, 0], [1, 0], [10, 5, 3], [0, 1])
        self.expect("outside_domain", lambda: hodograph.climb_curve(*ends, 2.0))
        self.expect("not_finite", lambda: hodograph.climb_curve(*ends, nan))
        self.expect("mismatched_size", lambda: hodograph.climb_curve([0, 0], *ends[1:], 0.2))
        self.expect("not_finite", lambda: hodograph.direction_of_angle(nan))
        self.expect("not_finite", lambda: hodograph.corner_clearance_factor(nan))
        self.expect("outside_domain",
                    lambda: hodograph.hermite_data_of_control_points(*[[0, 0]] * 4, h=0.0))
        self.expect("too_few", lambda: hodograph.climb_route([]))
        point = [[0, 0, 0], [1, 0, 0]]
        self.expect("mismatched_size", lambda: hodograph.hermite_curve(point, point[:1]))
        self.expect("mismatched_size", lambda: hodograph.hermite_curve([0, 0], [1, 1]))
        self.expect("unsupported", lambda: hodograph.hermite_curve(point, point, theta_end=0.1))
        self.expect("too_few", lambda: hodograph.InterpolatingSpline([0, 1], np.zeros((2, 3))))
        self.expect("mismatched_size",
                    lambda: hodograph.climb_curves(np.zeros((2, 3)), np.ones((1, 2)),
                                                   np.ones((2, 3)), np.ones((2, 2)), 0.2))
        none = hodograph.climb_curves(np.zeros((0, 3)), np.zeros((0, 2)), np.zeros((0, 3)),
                                      np.zeros((0, 2)), 0.2)
        self.assertEqual(none[0].shape, (0, 3, 4))
        self.expect("not_finite", lambda: hodograph.closed_loop(nan))
        self.expect("outside_domain", lambda: hodograph.closed_loop(0.0, 9.0))
        self.expect("outside_domain", lambda: hodograph.closed_loop(length=-1.0))
        self.expect("mismatched_size",
                    lambda: hodograph.choose_loop(hodograph.LoopPurpose.near_point))
        self.expect("mismatched_size", lambda: hodograph.choose_loop(within=[0, 1]))
        self.expect("unsupported",
                    lambda: hodograph.loop_facts(hodograph.planar_spline([[0, 0], [1, 1]])))
        self.expect("outside_domain", lambda: hodograph.frame_towards([0, 0, 0], [1, 0, 0]))
        self.expect("no_interpolant",
                    lambda: hodograph.prescribed_length_curve([0, 0], [1, 1], [4, 0], [1, 0], 3.0))
        self.expect("no_interpolant",
                    lambda: hodograph.turn_limited_path([0, 0], [1, 0], [4, 0], [1, 0], 3.0, 1.0))


if __name__ == "__main__":
    unittest.main()
