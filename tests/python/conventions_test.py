#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""docs/conventions.md, one test a sign: the signs of what is built on single curves, and those that
Python adds. (The signs of curves and frames themselves: tests/conformance/conventions_test.cpp.)

Each test would fail if its sign were the other one.
"""

import inspect
import json
import unittest

import numpy as np

import hodograph

QUARTER = np.pi / 2
ROUNDING = 16 * np.finfo(float).eps


def along_x(length=2.0):
    """From the origin along x in space, |dr/dxi| = 1."""
    return hodograph.Path([0, length], [[0, 0, 0]], [[[1, 0, 0, 0], [1, 0, 0, 0]]])


def planar_along_x(length=2.0):
    return hodograph.Path([0, length], [[0, 0]], [[[1, 0], [1, 0]]])


def planar_left_turn():
    """From the origin along x, turning left: w = 1 + i xi/2, kappa = 1 at the start."""
    return hodograph.Path([0, 1], [[0, 0]], [[[1, 0], [1, 0.5]]])


def counter_clockwise():
    """A closed path that goes round the unit square's corners, its inside on the left."""
    return hodograph.planar_spline([[0, 0], [1, 0], [1, 1], [0, 1]], closed=True)


class Conventions(unittest.TestCase):
    def near(self, got, expected, ulps=1.0):
        expected = np.asarray(expected, dtype=float)
        bound = ulps * ROUNDING * max(1.0, np.abs(expected).max())
        np.testing.assert_allclose(got, expected, rtol=0, atol=bound)

    # ---- the curve -------------------------------------------------------------------------------

    def test_offsets_are_positive_to_the_left(self):
        self.near(hodograph.offset_position(planar_along_x(), 1.0, 0.25), [1, 0.25])
        piece = hodograph.rational_offset(planar_along_x(), 0.25)[0]
        self.near(piece.curve.position(0.5), [1, 0.25])
        inside = hodograph.cusp_free_offsets(counter_clockwise())  # a left turn limits the left side
        self.assertTrue(np.isfinite(inside.left.upper))
        self.assertFalse(np.isfinite(inside.right.upper))

    def test_the_absolute_rotation_index_is_the_integral_itself(self):
        self.near(hodograph.absolute_rotation_index(counter_clockwise()), 2 * np.pi)
        # 2 arctan(1/2) for w from 1 to 1 + i/2: neither halved nor divided by 2 pi.
        self.near(hodograph.absolute_rotation_index(planar_left_turn()), 2 * np.arctan(0.5))

    def test_rotation_and_area_are_positive_counter_clockwise(self):
        ring = counter_clockwise()
        self.near(hodograph.rotation_index(ring), 2 * np.pi)
        self.near(hodograph.rotation_index(hodograph.reversed(ring)), -2 * np.pi)
        self.assertGreater(hodograph.signed_area_enclosure(ring).lower, 1)
        self.assertLess(hodograph.signed_area_enclosure(hodograph.reversed(ring)).upper, -1)

    def test_turning_angles_are_positive_to_the_left(self):
        left = hodograph.corner_of_leg([0, 0], [2, 0], [2, 2], 1.0)
        right = hodograph.corner_of_leg([0, 0], [2, 0], [2, -2], 1.0)
        self.near(left.shape.turning_angle, QUARTER)
        self.near(right.shape.turning_angle, -QUARTER)

    def test_a_reversed_path_has_minus_the_parameters(self):
        path = hodograph.Path([1, 3], [[0, 0]], [[[1, 0], [2, 0]]])
        back = hodograph.reversed(path)
        self.assertEqual((back.xi_begin, back.xi_end), (-3, -1))
        self.near(back.position(-1.5), path.position(1.5))

    # ---- headings and climbs -----------------------------------------------------------------------

    def test_headings_count_from_x_towards_y(self):
        self.near(hodograph.direction_of_angle(QUARTER), [0, 1])
        answer = hodograph.answer({"request": "climb", "climb_angle": 0.1,
                                   "begin": {"position": [0, 0, 0], "heading": QUARTER},
                                   "end": {"position": [0, 9, 2], "heading": QUARTER}})
        path = hodograph.parse_document(json.dumps(answer["result"]["document"])).path
        self.near(hodograph.tangent(path, path.xi_begin), [0, np.cos(0.1), np.sin(0.1)])

    def test_climb_angles_are_positive_upwards(self):
        for angle in (0.2, -0.2):
            climb = hodograph.climb_curve([0, 0, 0], [1, 0], [10, 5, 3 * np.sign(angle)], [0, 1], angle)
            self.assertEqual(climb.climb_angle, angle)
            self.near(hodograph.tangent(climb.curve, [0.0, 0.5, 1.0])[:, 2], np.sin([angle] * 3))

    def test_climbs_have_level_wings(self):
        climb = hodograph.climb_curve([0, 0, 0], [1, 0], [10, 5, 3], [0, 1], 0.2).curve
        e1, e2, e3 = np.moveaxis(hodograph.euler_rodrigues_frame(climb, [0.0, 0.3, 1.0]), 2, 0)
        self.near(e2[:, 2], [0, 0, 0])
        self.near(e2[0], [0, 1, 0])  # to the left of x
        self.assertTrue((e3[:, 2] > 0).all() and (e1[:, 2] > 0).all())

    def test_start_frames_roll_from_the_left_upwards(self):
        frame = hodograph.euler_rodrigues_frame(
            hodograph.Path([0, 1], [[0, 0, 0]], [[hodograph.level_frame([1, 0, 0], QUARTER)] * 2]), 0.0)
        self.near(frame, [[1, 0, 0], [0, 0, -1], [0, 1, 0]])  # e2 = z, e3 = -y

    # ---- frames ------------------------------------------------------------------------------------

    def test_twist_has_the_sense_of_the_roll(self):
        path = along_x(2.0)
        for rate in (0.5, -0.5):
            twist = hodograph.frame_twist(path, hodograph.FrameRoll.linear(path, 0.0, rate))
            self.assertTrue(twist.total.contains(2.0 * rate))
            self.assertTrue(twist.absolute.contains(1.0))

    def test_holonomy_is_how_far_the_frame_has_rolled(self):
        loop = hodograph.closed_loop(0.3, 1.0)
        first, last = hodograph.euler_rodrigues_frame(loop, [0.0, 1.0])
        roll = hodograph.holonomy(loop).roll
        self.near(last[:, 1], np.cos(roll) * first[:, 1] + np.sin(roll) * first[:, 2], 4)
        self.near(hodograph.closing_roll(loop).angle(1.0), -roll)

    def test_psi_of_a_loop_is_half_the_roll_of_its_frame(self):
        for psi in (1.0, -0.75):
            self.near(hodograph.holonomy(hodograph.closed_loop(0.3, psi)).roll, 2 * psi)

    def test_loops_bend_to_the_left(self):
        loop = hodograph.closed_loop(0.3, 1.0)
        self.near(hodograph.tangent(loop, 0.0), [1, 0, 0])
        second = hodograph.derivatives(loop, 0.0, 2)
        self.assertGreater(second[1], 1)
        self.near(second[2], 0)

    # ---- surfaces ----------------------------------------------------------------------------------

    def test_profiles_lie_along_e2_and_e3(self):
        motion = hodograph.Motion.along(along_x())
        self.near(hodograph.offset_track(motion, [0, 0.25, 0.5])[0].position(0.5), [1, 0.25, 0.5])
        slab = hodograph.Sweep(motion, hodograph.Profile.polygon([[0, 0], [0.25, 0], [0.25, 0.5], [0, 0.5]]))
        self.near(hodograph.mesh_of(slab, tolerance=0.01).mesh.vertices.max(axis=0), [2, 0.25, 0.5])

    def test_meshes_face_outwards(self):
        square = np.array([[0, 0], [0.5, 0], [0.5, 0.5], [0, 0.5]])
        for corners in (square, square[::-1]):
            sweep = hodograph.Sweep(hodograph.Motion.along(along_x()), hodograph.Profile.polygon(corners))
            mesh = hodograph.mesh_of(sweep, tolerance=0.01).mesh
            a, b, c = np.moveaxis(mesh.vertices[mesh.triangles], 1, 0)
            self.near(np.sum(a * np.cross(b, c)) / 6, 0.5)  # not -0.5

    # ---- following ---------------------------------------------------------------------------------

    def test_offsets_of_a_follower_are_positive_to_the_left(self):
        straight = hodograph.ReferencePath(planar_along_x())
        self.near(hodograph.coordinate_rates(straight, 1.0, [0.1], [0, 1]), [0, 1])
        bend = hodograph.ReferencePath(planar_left_turn())
        self.near(hodograph.progress_stretch(bend, 0.0, [0.25]), 0.75)  # sigma - eta chi, inside
        in_space = hodograph.ReferencePath(along_x())
        self.near(hodograph.coordinate_rates(in_space, 1.0, [0.1, 0.2], [1, 2, 3]), [1, 2, 3])

    def test_start_headings_of_a_follower_count_to_the_left(self):
        lap = hodograph.follow(planar_along_x(20.0), hodograph.FollowStart(heading=0.2, speed=1.0),
                               speed=2.0, acceleration=1.0, offset=1.0, lateral_acceleration=1.0,
                               intervals=20)
        self.assertGreater(lap.position[1, 1], 0)

    # ---- on the Earth ------------------------------------------------------------------------------

    def test_local_axes_are_east_north_up(self):
        plane = hodograph.LocalTangentPlane(hodograph.GeodeticPoint(45, 8, 500))
        east = plane.to_local(hodograph.GeodeticPoint(45, 8.001, 500))
        north = plane.to_local(hodograph.GeodeticPoint(45.001, 8, 500))
        self.assertTrue(78 < east[0] < 80 and abs(east[1]) < 0.01)
        self.assertTrue(111 < north[1] < 112 and abs(north[0]) < 0.01)
        self.near(plane.to_local(hodograph.GeodeticPoint(45, 8, 501)), [0, 0, 1], 2**20)

    def test_geojson_has_the_longitude_first(self):
        world = hodograph.World([[[0, 0], [10, 0], [10, 10], [0, 10]]])
        text = hodograph.to_geojson(world, datum=hodograph.GeodeticPoint(45, 8, 0))
        ring = np.array(json.loads(text)["features"][0]["geometry"]["coordinates"][0])
        self.assertTrue((abs(ring[:, 0] - 8) < 0.001).all() and (abs(ring[:, 1] - 45) < 0.001).all())

    # ---- rational curves ---------------------------------------------------------------------------

    def test_rational_curves_are_minus_two_b_over_alpha(self):
        space = hodograph.solve("t^2 - (i + j)*t + k", "t^3", 6)
        curve = hodograph.RationalPhCurve.of_solution(space.preimage, space.alpha, space.basis[0])
        at_two = [component for component in curve.position.value("2")]
        b = [component for component in space.basis[0].value("2")]
        self.assertEqual(at_two, [-2 * component / 8 for component in b[-3:]])  # alpha(2) = 8

    def test_power_form_begins_with_the_constant(self):
        self.assertEqual(str(hodograph.RationalPolynomial(["1", "2", "3"])), "3*t^2 + 2*t + 1")

    # ---- names and units ---------------------------------------------------------------------------

    def test_rates_of_rotation_say_of_what_and_per_what(self):
        rates = {name for name in hodograph.__all__ if "_rate" in name and name.islower()
                 and name.startswith(("body", "world", "angular"))}
        self.assertTrue({"body_rate_per_xi", "body_rate_per_arc_length", "world_rate_per_xi",
                         "world_rate_per_arc_length"} <= rates)
        for name in rates:
            self.assertRegex(name, "_per_(xi|arc_length)$")
        self.assertFalse([name for name in hodograph.__all__ if "omega" in name.lower()])

    def test_functions_are_snake_case_and_types_camel_case(self):
        for name in hodograph.__all__:
            thing = getattr(hodograph, name)
            if isinstance(thing, type):
                self.assertRegex(name, "^([A-Z][a-z0-9]*)+$")
            elif callable(thing):
                self.assertRegex(name, "^[a-z][a-z0-9]*(_[a-z0-9]+)*$")

    def test_orbits_state_their_units(self):
        orbit = hodograph.answer({"request": "orbit", "name": "gateway"})["result"]
        self.assertTrue(3.8e5 < orbit["length_unit_km"] < 4e5)
        days = orbit["period"] * orbit["time_unit_s"] / 86400
        self.assertAlmostEqual(days, orbit["period_days"], places=9)

    # ---- numbers in Python and in files ------------------------------------------------------------

    def test_frames_have_their_axes_as_columns(self):
        turned = hodograph.Path([0, 1], [[0, 0, 0]], [[[1, 0, 0, 1], [1, 0, 0, 1]]])  # left, about z
        frame = hodograph.euler_rodrigues_frame(turned, 0.5)
        self.near(frame, [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
        self.near(frame[:, 0], hodograph.tangent(turned, 0.5))

    def test_quaternions_are_scalar_first_in_files(self):
        turned = hodograph.Path([0, 1], [[0, 0, 0]], [[[1, 0, 0, 1], [1, 0, 0, 1]]])
        segment = json.loads(hodograph.to_json(turned))["segments"][0]
        self.assertEqual(segment["preimage"], [[1, 0, 0, 1], [1, 0, 0, 1]])
        self.near(turned.position(1.0), [0, 2, 0])  # a turn about z, not about x

    def test_points_are_rows(self):
        self.assertEqual(planar_along_x().position([0.0, 1.0, 2.0]).shape, (3, 2))
        self.near(along_x().position([0.0, 1.0])[1], [1, 0, 0])

    def test_an_accuracy_is_asked_for_only_where_the_result_is_approximate(self):
        words = {"accuracy", "tolerance", "relative_width"}

        def asks(function):
            return any(word in (function.__doc__ or "").partition(")")[0] for word in words) or bool(
                words & set(inspect.signature(function).parameters)
                if inspect.isfunction(function) else False)

        for exact in (hodograph.Path.position, hodograph.Path.arc_length,
                      hodograph.Path.parameter_at_arc_length, hodograph.offset_position,
                      hodograph.curvature, hodograph.planar_spline, hodograph.climb_curve,
                      hodograph.hermite_path, hodograph.closed_loop, hodograph.rotation_index):
            self.assertFalse(asks(exact), exact)
        for approximate in (hodograph.fit, hodograph.mesh_of, hodograph.polyline_parameters,
                            hodograph.rotation_minimising_frames, hodograph.curvature_extremes):
            self.assertTrue(asks(approximate), approximate)


if __name__ == "__main__":
    unittest.main()
