#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Bounds and analyses: golden values lie in their enclosures, samples never leave them."""

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


def single(preimage, start=(0.0, 0.0)):
    return hodograph.Path([0.0, 1.0], [start], [preimage])


def wave():
    return hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4], [7, 3]])


def loop():
    return hodograph.closed_loop(0.3, 1.0, length=2.0)


class Golden(unittest.TestCase):
    def test_bending_energies(self):
        for case in golden("planar_energy", "energy"):
            path = single(case["input"]["w"])
            expected = case["expected"]["energy"]
            self.assertAlmostEqual(hodograph.bending_energy(path), expected,
                                   delta=case["rel_tol"] * max(1.0, expected))
            found = hodograph.bending_energy_enclosure(path)
            self.assertLess(max(found.lower - expected, expected - found.upper),
                            case["rel_tol"] * max(1.0, expected))

    def test_extremes_of_curvature(self):
        for case in golden("planar_curvature", "curvature_extrema"):
            path, expected = single(case["input"]["w"]), case["expected"]
            largest = expected["kappa_max_abs"]
            tolerance = case["rel_tol"] * max(1.0, largest)
            found = hodograph.curvature_extremes(path, relative_width=2.0**-40)
            self.assertAlmostEqual(max(-found.minimum.lower, found.maximum.upper), largest,
                                   delta=tolerance + 2.0**-39 * largest)
            places = [at.xi for at in hodograph.curvature_stationary_points(path)
                      if at.kind != hodograph.CurvatureExtremeKind.undecided]
            for place in places:
                self.assertLess(min(abs(place - root) for root in expected["roots"]), 1e-6)


class Samples(unittest.TestCase):
    def test_never_leave_the_bounds(self):
        for path in (wave(), loop()):
            xi = np.linspace(path.xi_begin, path.xi_end, 2001)
            for extremes, values in (
                    (hodograph.speed_extremes(path), path.speed(xi)),
                    (hodograph.curvature_extremes(path), hodograph.curvature(path, xi))):
                slack = 64 * EPSILON * np.abs(values).max()
                self.assertLessEqual(extremes.minimum.lower - slack, values.min())
                self.assertLessEqual(values.max(), extremes.maximum.upper + slack)
                self.assertLess(extremes.maximum.upper - values.max(), 1e-3 * values.max())
            box = hodograph.bounding_box(path)
            self.assertEqual(len(box), path.dimension)
            for side, values in zip(box, path.position(xi).T):
                self.assertLessEqual(side.range.lower - 1e-13, values.min())
                self.assertLessEqual(values.max(), side.range.upper + 1e-13)
            rates = hodograph.body_rate_per_xi(path, xi)
            rates = np.abs(rates) if path.dimension == 2 else np.linalg.norm(rates, axis=1)
            most = hodograph.angular_rate_extremes_per_xi(path).maximum
            self.assertLessEqual(rates.max(), most.upper * (1 + 64 * EPSILON))
            self.assertLess(most.lower, rates.max() * 1.001)
            self.assertTrue(hodograph.arc_length_enclosure(path).contains(path.arc_length()))

    def test_torsion(self):
        path = loop()
        tau = hodograph.torsion(path, np.linspace(0.0, 1.0, 2001))
        found = hodograph.torsion_extremes(path)
        self.assertLessEqual(found.minimum.lower, tau.min() + 1e-9)
        self.assertLessEqual(tau.max(), found.maximum.upper + 1e-9)
        self.assertLess(tau.min() - found.minimum.lower, 1e-3)

    def test_parts_bound_the_curvature(self):
        path = wave()
        parts = hodograph.curvature_parts(path, 8)
        self.assertEqual(parts.arc_lengths.shape, (8 * path.segment_count + 1,))
        s = np.linspace(0.0, path.arc_length(), 3000)
        part = np.clip(np.searchsorted(parts.arc_lengths, s, side="right") - 1, 0,
                       len(parts.most_curvature) - 1)
        kappa = np.abs(hodograph.curvature(path, path.parameter_at_arc_length(s)))
        self.assertTrue((kappa <= parts.most_curvature[part] * (1 + 1e-9)).all())


class Sampling(unittest.TestCase):
    def test_parameters_are_where_they_should_be(self):
        for path in (wave(), loop()):
            even = hodograph.parameters_even_in_arc_length(path, 50)
            np.testing.assert_allclose(np.diff(path.arc_length(even)), path.arc_length() / 49,
                                       rtol=1e-12)
            np.testing.assert_allclose(hodograph.parameters_even_in_xi(path, 11),
                                       np.linspace(path.xi_begin, path.xi_end, 11), rtol=1e-14)
            steps = hodograph.parameters_by_arc_length_step(path, 0.3)
            np.testing.assert_allclose(np.diff(path.arc_length(steps))[:-1], 0.3, rtol=1e-12)
            self.assertEqual(len(hodograph.parameters_per_segment(path, 4)),
                             4 * path.segment_count + 1)
            corners = hodograph.polyline_parameters(path, 1e-3)
            fine = np.linspace(corners[:-1], corners[1:], 9, axis=1)
            a, b = path.position(corners[:-1])[:, None], path.position(corners[1:])[:, None]
            p, along = hodograph.points_at(path, fine), b - a
            t = np.sum((p - a) * along, axis=2) / np.sum(along * along, axis=2)
            distance = np.linalg.norm(p - a - np.clip(t, 0, 1)[:, :, None] * along, axis=2)
            self.assertLessEqual(distance.max(), 1e-3)

    def test_derivatives_of_curvature_are_those_of_differences(self):
        for path, xi in ((wave(), 0.4), (loop(), 0.3)):
            h = 1e-4
            kappa = hodograph.curvature(path, [xi - h, xi, xi + h])
            expected = [kappa[1], (kappa[2] - kappa[0]) / (2 * h),
                        (kappa[2] - 2 * kappa[1] + kappa[0]) / h**2]
            np.testing.assert_allclose(hodograph.curvature_derivatives(path, xi), expected,
                                       rtol=1e-4)


class Planar(unittest.TestCase):
    def test_turning_is_that_of_the_tangents(self):
        path = wave()
        xi = np.linspace(path.xi_begin, path.xi_end, 20001)
        t = hodograph.tangent(path, xi)
        turns = np.diff(np.unwrap(np.arctan2(t[:, 1], t[:, 0])))
        self.assertAlmostEqual(hodograph.rotation_index(path), turns.sum(), delta=1e-12)
        self.assertAlmostEqual(hodograph.absolute_rotation_index(path), np.abs(turns).sum(),
                               delta=1e-5)
        both = hodograph.rotation_index_enclosures(path)
        self.assertTrue(both.with_sign.contains(hodograph.rotation_index(path)))
        self.assertTrue(both.absolute.contains(hodograph.absolute_rotation_index(path)))

    def test_inflections_are_changes_of_sign(self):
        path = wave()
        xi = np.linspace(path.xi_begin, path.xi_end, 20001)
        kappa = hodograph.curvature(path, xi)
        places = xi[:-1][np.sign(kappa[:-1]) != np.sign(kappa[1:])]
        found = [at.xi for at in hodograph.inflections(path)
                 if at.kind == hodograph.RootKind.simple]
        np.testing.assert_allclose(found, places, atol=1e-3)
        most = np.abs(kappa).max()
        self.assertEqual(hodograph.curvature_stays_within(path, 1.01 * most), hodograph.Answer.yes)
        self.assertEqual(hodograph.curvature_stays_within(path, 0.99 * most), hodograph.Answer.no)

    def test_areas_are_those_of_polygons(self):
        path = hodograph.planar_spline([[0, 0], [2, 0], [2, 2], [0, 2]], closed=True)
        p = path.position(np.linspace(path.xi_begin, path.xi_end, 20001))
        area = 0.5 * np.sum(p[:-1, 0] * p[1:, 1] - p[1:, 0] * p[:-1, 1])
        self.assertAlmostEqual(hodograph.signed_area(path), area, delta=1e-6)
        self.assertTrue(
            hodograph.signed_area_enclosure(path).contains(hodograph.signed_area(path)))
        self.assertAlmostEqual(hodograph.signed_area(hodograph.reversed(path)), -area, delta=1e-6)

    def test_meetings_are_common_points(self):
        path = wave()
        other = hodograph.planar_spline([[0, 3], [2, 1], [5, 3.5], [7, 1]])
        found = hodograph.intersections(path, other)
        self.assertGreaterEqual(len(found), 2)
        for at in found:
            self.assertEqual(at.kind, hodograph.IntersectionKind.crossing)
            np.testing.assert_allclose(other.position(at.xi_second), at.point, atol=1e-10)
        for at in hodograph.segment_intersections(path, [0, 1.5], [7, 1.5]):
            self.assertAlmostEqual(at.point[1], 1.5, delta=1e-10)
        whole = hodograph.line_intersections(path, [0, 1.5], [1, 0])
        self.assertGreaterEqual(len(whole), 2)

    def test_a_path_that_meets_itself(self):
        path = hodograph.planar_spline([[0, 0], [2, 2], [2, 0], [0, 2]])
        found = hodograph.self_intersections(path)
        self.assertEqual([at.kind for at in found], [hodograph.IntersectionKind.crossing])
        np.testing.assert_allclose(path.position(found[0].xi_second), found[0].point, atol=1e-10)
        self.assertEqual(hodograph.self_intersections(wave()), [])

    def test_higher_degrees_agree(self):
        path = wave()
        for degree in (3, 5, 7, 12):
            same = hodograph.with_preimage_degree(path, degree)
            self.assertAlmostEqual(hodograph.bending_energy(same), hodograph.bending_energy(path),
                                   delta=1e-10)
            self.assertEqual(len(hodograph.inflections(same)), len(hodograph.inflections(path)))


class Nearest(unittest.TestCase):
    def test_no_sample_is_nearer(self):
        for path, q in ((wave(), [2.0, 3.0]), (loop(), [0.1, 0.2, 0.3])):
            xi = np.linspace(path.xi_begin, path.xi_end, 4001)
            distances = np.linalg.norm(path.position(xi) - q, axis=1)
            found = hodograph.nearest_point(path, q)
            self.assertLessEqual(found.distance.lower, distances.min())
            self.assertLess(distances.min() - found.distance.upper, 1e-5)
            self.assertEqual(found.at.point.shape, (path.dimension,))
            np.testing.assert_allclose(path.position(found.at.xi), found.at.point, atol=1e-13)
            all_places = hodograph.stationary_points(path, q)
            self.assertIn(found.at.xi, [at.xi for at in all_places])

    def test_tubes_and_distances(self):
        path = loop()
        tube = hodograph.largest_tube_radius(path)
        self.assertAlmostEqual(tube.radius.middle,
                               1.0 / hodograph.curvature_extremes(path).maximum.middle, delta=1e-5)
        self.assertEqual(tube.limit, hodograph.TubeLimit.curvature)
        s = np.linspace(0.0, 2.0, 401)[:-1]
        p = path.point_at_arc_length(s)
        gap = np.abs(s[:, None] - s[None, :])
        apart = np.minimum(gap, 2.0 - gap) >= 0.5
        distances = np.linalg.norm(p[:, None] - p[None, :], axis=2)[apart]
        found = hodograph.self_distance(path, 0.5)
        self.assertLessEqual(found.distance.lower, distances.min())
        self.assertLess(distances.min() - found.distance.upper, 1e-2)


class Values(unittest.TestCase):
    def test_results_are_pickled_and_shown(self):
        for value in (hodograph.curvature_extremes(wave()), hodograph.inflections(wave())[0],
                      hodograph.nearest_point(wave(), [1.0, 1.0]),
                      hodograph.largest_tube_radius(loop()), hodograph.continuity(loop())):
            self.assertEqual(repr(pickle.loads(pickle.dumps(value))), repr(value))
            self.assertIn(type(value).__name__ + "(", repr(value))


class Refusals(unittest.TestCase):
    def expect(self, code, call):
        with self.assertRaises(HodographError) as caught:
            call()
        self.assertEqual(caught.exception.code, code, str(caught.exception))

    def test_are_of_what_cannot_be_done(self):
        nan, plane, space = float("nan"), wave(), loop()
        self.expect("unsupported", lambda: hodograph.inflections(space))
        self.expect("unsupported", lambda: hodograph.rotation_index(space))
        self.expect("unsupported", lambda: hodograph.intersections(plane, space))
        self.expect("unsupported", lambda: hodograph.torsion_extremes(plane))
        self.expect("mismatched_size", lambda: hodograph.nearest_point(plane, [0, 0, 0]))
        self.expect("mismatched_size", lambda: hodograph.nearest_point(plane, [[0, 0]]))
        self.expect("not_finite", lambda: hodograph.nearest_point(plane, [nan, 0]))
        self.expect("not_finite", lambda: hodograph.line_intersections(plane, [0, nan], [1, 0]))
        self.expect("outside_domain", lambda: hodograph.line_intersections(plane, [0, 0], [0, 0]))
        self.expect("outside_domain", lambda: hodograph.self_distance(space, 1.5))
        self.expect("outside_domain", lambda: hodograph.curvature_extremes(plane, relative_width=nan))
        self.expect("too_few", lambda: hodograph.curvature_parts(plane, 0))
        self.expect("too_few", lambda: hodograph.parameters_even_in_xi(plane, 1))
        self.expect("outside_domain", lambda: hodograph.parameters_by_arc_length_step(plane, nan))
        self.expect("outside_domain", lambda: hodograph.polyline_parameters(plane, -1.0))
        self.expect("outside_domain", lambda: hodograph.curvature_derivatives(plane, nan))
        self.assertEqual(hodograph.curvature_stays_within(plane, nan), hodograph.Answer.no)
        rest = single([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])
        self.expect("zero_speed", lambda: hodograph.bending_energy(rest))
        self.assertEqual(hodograph.curvature_extremes(rest).maximum.upper, np.inf)


if __name__ == "__main__":
    unittest.main()
