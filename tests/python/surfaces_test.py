#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Offsets, sweeps, meshes: exact pieces against samples, meshes against volumes that are known."""

import json
import pickle
import unittest
from pathlib import Path

import numpy as np

import hodograph
from hodograph import HodographError

GOLDEN = Path(__file__).resolve().parents[1] / "golden"


def wave():
    return hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4]])


def loop():
    return hodograph.closed_loop(0.3, 1.0, length=2.0)


class Offsets(unittest.TestCase):
    def test_pieces_are_the_golden_ones(self):
        for case in json.loads((GOLDEN / "planar_offset.json").read_text())["offset"]:
            given, expected = case["input"], case["expected"]
            path = hodograph.Path([0.0, 1.0], [given["p0"]], [given["w"]])
            pieces = hodograph.rational_offset(path, -given["d"])  # golden: positive to the right
            for at in expected["points"]:
                point = hodograph.offset_position(path, at["xi"], -given["d"])
                np.testing.assert_allclose(point, at["point"], atol=1e-12 * max(
                    1.0, np.abs(at["point"]).max()))
            if len(pieces) > 1:
                continue  # halved, where weights are negative
            curve = pieces[0].curve
            weights = np.array(expected["W"])
            points = np.stack([expected["X"], expected["Y"]], axis=1) / weights[:, None]
            size = max(1.0, np.abs(points).max())
            np.testing.assert_allclose(curve.weights, weights, rtol=1e-12)
            np.testing.assert_allclose(curve.control_points, points, atol=1e-11 * size)

    def test_are_the_path_moved_along_its_normal(self):
        path, d = wave(), 0.3
        xi = np.linspace(path.xi_begin, path.xi_end, 301)
        t = hodograph.tangent(path, xi)
        expected = path.position(xi) + d * np.stack([-t[:, 1], t[:, 0]], axis=1)
        np.testing.assert_allclose(hodograph.offset_position(path, xi, d), expected, atol=1e-13)
        for piece in hodograph.rational_offset(path, d):
            curve, u = piece.curve, np.linspace(0.0, 1.0, 21)
            at = np.clip(curve.begin + u * (curve.end - curve.begin), curve.begin, curve.end)
            np.testing.assert_allclose(curve.position(u),
                                       hodograph.offset_position(path, at, d), atol=1e-11)

    def test_cusps_are_where_the_curvature_says(self):
        path = wave()
        limits = hodograph.cusp_free_offsets(path)
        self.assertEqual(hodograph.offset_cusps(path, 0.99 * limits.left.lower), [])
        cusps = hodograph.offset_cusps(path, 1.2 * limits.left.upper)
        self.assertEqual(len(cusps), 2)
        for cusp in cusps:
            self.assertAlmostEqual(hodograph.curvature(path, cusp.xi) * 1.2 * limits.left.middle,
                                   1.0, delta=1e-9)


class Sweeps(unittest.TestCase):
    def test_a_tube_has_the_volume_of_one(self):
        path, radius = loop(), 0.03
        sweep = hodograph.Sweep(hodograph.Motion.along(path), hodograph.Profile.circle(radius))
        made = hodograph.mesh_of(sweep, tolerance=1e-4)
        self.assertLessEqual(made.deviation, 1e-4)
        facts = hodograph.facts_of(made.mesh)
        self.assertTrue(facts.is_closed and facts.is_manifold)
        self.assertEqual(facts.euler_characteristic, 0)  # a torus
        # Pappus: the area of the section times the length.
        self.assertAlmostEqual(facts.volume / (np.pi * radius**2 * 2.0), 1.0, delta=2e-2)
        self.assertEqual(hodograph.fold_of(sweep).kind, hodograph.SweepFoldKind.none)
        tube = hodograph.largest_tube_radius(path)
        self.assertTrue(hodograph.is_certainly_free(sweep, tube))
        self.assertIsNone(hodograph.contact_fault(sweep, tube))
        wide = hodograph.Sweep(hodograph.Motion.along(path), hodograph.Profile.circle(0.2))
        self.assertIn("0.1", hodograph.contact_fault(wide, tube))
        self.assertTrue(hodograph.contact_of(sweep).free)
        self.assertGreater(hodograph.largest_free_factor(sweep, tube), 3.0)

    def test_meshes_are_arrays(self):
        sweep = hodograph.Sweep(hodograph.Motion.along(loop()), hodograph.Profile.circle(0.03))
        mesh = hodograph.mesh_of(sweep, tolerance=1e-3).mesh
        self.assertEqual(mesh.vertices.shape, mesh.normals.shape)
        self.assertEqual(mesh.triangles.dtype, np.uint32)
        a, b, c = (mesh.vertices[mesh.triangles[:, i]] for i in range(3))
        areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        self.assertAlmostEqual(hodograph.mesh_area(mesh), areas.sum(), delta=1e-12)
        volume = np.einsum("ij,ij->", a, np.cross(b, c)) / 6.0
        self.assertAlmostEqual(hodograph.mesh_volume(mesh), volume, delta=1e-12)
        again = hodograph.TriangleMesh(mesh.vertices, mesh.triangles, mesh.normals)
        np.testing.assert_array_equal(again.triangles, mesh.triangles)
        with self.assertRaises(ValueError):
            mesh.triangles[0, 0] = 1

    def test_patches_are_the_surface(self):
        path = hodograph.subpath(loop(), 0.0, 1.0)  # open
        motion = hodograph.Motion.along(path, hodograph.MotionFrame.euler_rodrigues, [1.0, 2.0, 1.0])
        sweep = hodograph.Sweep(motion, hodograph.Profile.polyline([[-0.02, 0], [0.03, 0]]))
        patches = hodograph.rational_patches(sweep)
        v = np.linspace(0.0, 1.0, 11)
        patch = patches[0]
        xi = patch.begin_v + v * (patch.end_v - patch.begin_v)
        erf = hodograph.euler_rodrigues_frame(path, xi)
        scale = (1 - xi)**2 + 4 * xi * (1 - xi) + xi**2
        for u, x in ((0.0, -0.02), (1.0, 0.03)):
            expected = path.position(xi) + (scale * x)[:, None] * erf[:, :, 1]
            np.testing.assert_allclose(patch.position(v, u), expected, atol=1e-12)
        point = hodograph.point_of(sweep, 0, v[:, None], 0, np.array([0.0, 0.5, 1.0]))
        self.assertEqual(point.position.shape, (11, 3, 3))
        np.testing.assert_allclose(np.linalg.norm(point.normal, axis=2), 1.0, atol=1e-12)
        track = hodograph.offset_track(motion, [0.0, 0.03, 0.0])
        np.testing.assert_allclose(track[0].position(0.0), patch.position(0.0, 1.0), atol=1e-12)

    def test_rolls_carry_profiles(self):
        path = loop()
        roll = hodograph.least_twist_roll(path)
        motion = hodograph.Motion.along(path, roll)
        state = motion.at(0, 0.25)
        np.testing.assert_allclose(state.frame, hodograph.RolledFrames(path, roll).at(0.25),
                                   atol=1e-12)
        with self.assertRaises(HodographError) as caught:
            hodograph.rational_patches(hodograph.Sweep(motion, hodograph.Profile.circle(0.01)))
        self.assertEqual(caught.exception.code, "unsupported")

    def test_planar_paths_sweep_too(self):
        oval = hodograph.planar_spline([[2, 0], [0, 1], [-2, 0], [0, -1]], closed=True)
        profile = hodograph.Profile.of(hodograph.scaled(oval, 0.1))
        self.assertTrue(profile.is_closed)
        sweep = hodograph.Sweep(hodograph.Motion.along(oval), profile)
        self.assertTrue(hodograph.facts_of(hodograph.mesh_of(sweep, tolerance=0.01).mesh).is_closed)
        self.assertEqual(hodograph.in_space(oval).dimension, 3)


class Refusals(unittest.TestCase):
    def expect(self, code, call):
        with self.assertRaises(HodographError) as caught:
            call()
        self.assertEqual(caught.exception.code, code, str(caught.exception))

    def test_are_of_what_cannot_be_done(self):
        nan, path = float("nan"), loop()
        sweep = hodograph.Sweep(hodograph.Motion.along(path), hodograph.Profile.circle(0.03))
        self.expect("unsupported", lambda: hodograph.rational_offset(path, 0.1))
        self.expect("unsupported", lambda: hodograph.offset_position(path, 0.5, 0.1))
        self.expect("not_finite", lambda: hodograph.rational_offset(wave(), nan))
        self.expect("not_finite", lambda: hodograph.offset_cusps(wave(), nan))
        self.expect("outside_domain", lambda: hodograph.offset_position(wave(), nan, 0.1))
        self.expect("outside_domain", lambda: hodograph.Profile.circle(-1.0))
        self.expect("too_few", lambda: hodograph.Profile.polygon(np.zeros((2, 2))))
        self.expect("mismatched_size", lambda: hodograph.Profile.polygon([0, 1, 2]))
        self.expect("unsupported", lambda: hodograph.Profile.of(path))
        self.expect("outside_domain", lambda: hodograph.Motion.along(path, scale=[]))
        self.expect("outside_domain", lambda: hodograph.Motion.along(path, scale=[1.0, -1.0]))
        self.expect("outside_domain", lambda: hodograph.mesh_of(sweep, tolerance=nan))
        self.expect("outside_domain", lambda: hodograph.point_of(sweep, 9, 0.5, 0, 0.5))
        self.expect("outside_domain", lambda: hodograph.point_of(sweep, 0, nan, 0, 0.5))
        self.expect("outside_domain", lambda: hodograph.contact_of(sweep, nan))
        self.expect("tolerance_not_reached",
                    lambda: hodograph.mesh_of(sweep, tolerance=1e-6, most_triangles=1000))
        vertices = np.zeros((3, 3))
        self.expect("outside_domain", lambda: hodograph.TriangleMesh(vertices, [[0, 1, 3]]))
        self.expect("outside_domain", lambda: hodograph.TriangleMesh(vertices, [[0, 1, -1]]))
        self.expect("mismatched_size", lambda: hodograph.TriangleMesh(vertices, [0, 1, 2]))
        self.expect("not_finite",
                    lambda: hodograph.TriangleMesh(np.full((3, 3), nan), [[0, 1, 2]]))
        empty = hodograph.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=int))
        self.assertEqual((empty.vertices.shape, empty.triangles.shape), ((0, 3), (0, 3)))
        self.expect("outside_domain", lambda: hodograph.RationalBezier([[0, 0], [1, 1]], [1, -1]))
        self.expect("mismatched_size", lambda: hodograph.RationalBezier([[0, 0], [1, 1]], [1]))
        self.expect("too_few", lambda: hodograph.RationalBezier(np.zeros((0, 2)), []))

    def test_curves_are_values(self):
        curve = hodograph.rational_offset(wave(), 0.1)[0].curve
        self.assertEqual(pickle.loads(pickle.dumps(curve)), curve)


if __name__ == "__main__":
    unittest.main()
