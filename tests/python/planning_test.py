#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Worlds, shortest polylines and plans: against distances and shortest ways computed here."""

import copy
import itertools
import pickle
import unittest

import numpy as np
from scipy.optimize import linprog

import hodograph
from hodograph import CornerAim, HodographError, WorldPosition, WorldVertex

EPSILON = np.finfo(float).eps
BLOCK = np.array([[0, -2], [4, -2], [4, 2], [0, 2]], dtype=float)


def distance_to_rings(points, rings):
    """The least distance of points (n, 2) from the edges of rings."""
    least = np.full(len(points), np.inf)
    for ring in rings:
        for a, b in zip(ring, np.roll(ring, -1, axis=0)):
            along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
            least = np.minimum(least, np.hypot(*(points - a - along[:, None] * (b - a)).T))
    return least


def rings_of(world):
    rings = [ring for polygon in world.obstacles for ring in [polygon.outer, *polygon.holes]]
    return rings + ([world.bounds] if world.bounds is not None else [])


class Worlds(unittest.TestCase):
    def test_rings_are_cleaned_turned_and_reported(self):
        ring = [[0, 0], [0, 1], [0, 1], [1, 1], [1, 0]]  # clockwise, with a point twice
        world = hodograph.World([hodograph.Polygon(ring, name="shed")], bounds=10 * (BLOCK + [-2, 0]))
        polygon = world.obstacles[0]
        x, y = polygon.outer.T
        self.assertEqual(polygon.outer.shape, (4, 2))
        self.assertGreater(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)), 0.0)  # anticlockwise
        self.assertEqual([repair.kind.name for repair in world.repairs],
                         ["repeated_point", "turned_ring"])
        self.assertIn("point 2 repeats", str(world.repairs[0]))
        self.assertEqual(world.vertex_count, 8)
        self.assertEqual(world.name_of(0), "obstacle 0 ('shed')")
        self.assertEqual(world.name_of(WorldVertex.bounds), "the bounds")
        for k in range(4):
            at = WorldVertex(0, 0, k)
            np.testing.assert_array_equal(world.point(at), np.array(ring)[world.source_vertex(at)])
        np.testing.assert_array_equal(world.box.lower, [-20.0, -20.0])
        self.assertTrue(world.box.contains([0, 0]))

    def test_pickles_and_copies_are_equal_repairs_included(self):
        outer = [[0, 0], [0, 9], [9, 9], [9, 9], [9, 0], [0, 0]]
        hole = [[2, 2], [4, 2], [4, 2], [4, 4]]
        world = hodograph.World([hodograph.Polygon(outer, [hole], "court"), BLOCK + 20],
                                bounds=[[-50, -50], [-50, 50], [50, 50], [50, -50]])
        for other in (pickle.loads(pickle.dumps(world)), copy.copy(world), copy.deepcopy(world)):
            self.assertEqual(other, world)
            self.assertEqual(other.repairs, world.repairs)
        self.assertEqual(hodograph.World(), hodograph.World([]))
        self.assertIsNone(hodograph.World().box)
        self.assertEqual(repr(hodograph.World([BLOCK])),
                         "<hodograph.World: 1 obstacle, 4 vertices>")

    def test_what_is_no_polygon_is_refused(self):
        def refused(code, *arguments, **members):
            with self.assertRaises(HodographError) as caught:
                hodograph.World(*arguments, **members)
            self.assertEqual(caught.exception.code, code)
            return caught.exception

        nan = float("nan")
        self.assertEqual(refused("not_finite", [BLOCK, [[0, 0], [nan, 1], [1, 1]]]).index, 1)
        refused("too_few", [[[0, 0], [1, 1]]])
        refused("too_few", [np.zeros((0, 2))])
        refused("outside_domain", [[[0, 0], [1, 1], [1, 0], [0, 1]]])  # crosses itself
        refused("outside_domain", [hodograph.Polygon(BLOCK, [BLOCK + 10])])  # a hole outside
        refused("mismatched_size", [np.zeros((4, 3))])
        refused("mismatched_size", [[1.0, 2.0, 3.0]])
        refused("mismatched_size", [], bounds=[0.0, 1.0])
        for nonsense in (["shed"], [None], 7):
            with self.assertRaises((TypeError, ValueError)):
                hodograph.World(nonsense)
        world = hodograph.World([BLOCK])
        for vertex in (WorldVertex(1), WorldVertex(0, 1), WorldVertex(0, 0, 4),
                       WorldVertex(WorldVertex.bounds)):
            with self.assertRaises(HodographError):
                world.point(vertex)
        with self.assertRaises(HodographError):
            world.ring(2)

    def test_points_are_located(self):
        world = hodograph.MitredWorld(hodograph.World([BLOCK]), 0.5)
        self.assertEqual(world.locate([2, 0]).kind, WorldPosition.Kind.in_obstacle)
        self.assertEqual(world.locate([9, 9]).kind, WorldPosition.Kind.free)
        band = world.locate([4.25, 0])
        self.assertEqual(band.kind, WorldPosition.Kind.in_band)
        self.assertAlmostEqual(band.missing, 0.25, delta=8 * EPSILON)
        self.assertFalse(world.sees([-3, 0], [7, 0]))
        self.assertTrue(world.sees([-3, 2.5], [7, 2.5]))  # along the grown block
        corner = next(k for k in range(4) if list(world.world.point(WorldVertex(0, 0, k))) == [4, 2])
        np.testing.assert_allclose(world.mitre_tip(WorldVertex(0, 0, corner)), [4.5, 2.5],
                                   atol=8 * EPSILON)
        again = pickle.loads(pickle.dumps(world))
        self.assertEqual((again.offset, again.corner_count), (0.5, 4))
        with self.assertRaises(HodographError):
            world.locate([float("nan"), 0])
        with self.assertRaises(HodographError):
            hodograph.MitredWorld(hodograph.World([BLOCK]), -1.0)


class Polylines(unittest.TestCase):
    def test_the_shortest_is_that_of_a_search_of_all_ways(self):
        world = hodograph.MitredWorld(hodograph.World([BLOCK, BLOCK + [7, 3]]), 0.5)
        start, goal = np.array([-3.0, 0.0]), np.array([14.0, 2.0])
        tips = [world.mitre_tip(WorldVertex(obstacle, 0, k))
                for obstacle in range(2) for k in range(4)]
        places = [start, *tips, goal]
        length = {(i, j): np.hypot(*(places[i] - places[j])) if world.sees(places[i], places[j])
                  else np.inf
                  for i, j in itertools.permutations(range(len(places)), 2)}
        best = np.full(len(places), np.inf)
        best[0] = 0.0
        for _ in places:  # Bellman and Ford
            for (i, j), leg in length.items():
                best[j] = min(best[j], best[i] + leg)
        found = hodograph.shortest_polyline(world, start, goal)
        self.assertAlmostEqual(found.length, best[-1], delta=64 * EPSILON * best[-1])
        legs = np.hypot(*np.diff(found.points, axis=0).T)
        self.assertAlmostEqual(found.length, legs.sum(), delta=64 * EPSILON * best[-1])
        self.assertEqual(len(found.corners), len(found.points) - 2)
        for corner, point in zip(found.corners, found.points[1:-1]):
            np.testing.assert_array_equal(corner.point, point)
            np.testing.assert_array_equal(world.mitre_tip(corner.vertex), point)
        forbidden = [hodograph.ForbiddenCorner(c.vertex, c.side) for c in found.corners]
        other = hodograph.shortest_polyline(world, start, goal, forbidden_corners=forbidden)
        self.assertGreater(other.length, found.length)
        leg = hodograph.ForbiddenLeg(None, found.corners[0].vertex)
        self.assertGreaterEqual(
            hodograph.shortest_polyline(world, start, goal, forbidden_legs=[leg]).length,
            found.length)
        wider = hodograph.shortest_polyline(
            world, start, goal, obstacle_offsets=[hodograph.ObstacleOffset(0, 0.75)],
            corner_offsets=[hodograph.CornerOffset(WorldVertex(1, 0, 0), 0.6)])
        self.assertGreater(wider.length, found.length)

    def test_starts_and_goals_that_are_not_free_are_refused(self):
        world = hodograph.MitredWorld(hodograph.World([BLOCK]), 0.5)
        for start, code in (([1, 1], "outside_domain"), ([-0.25, 0], "outside_domain"),
                            ([np.nan, 0], "not_finite"), ([0, 0, 0], "mismatched_size"),
                            ([], "mismatched_size")):
            with self.assertRaises(HodographError) as caught:
                hodograph.shortest_polyline(world, start, [9, 0])
            self.assertEqual(caught.exception.code, code)
        with self.assertRaises(HodographError):
            hodograph.shortest_polyline(
                world, [-3, 0], [9, 0], corner_offsets=[hodograph.CornerOffset(WorldVertex(5), 1.0)])


class Plans(unittest.TestCase):
    def setUp(self):
        self.world = hodograph.World([hodograph.Polygon(BLOCK, name="block"), BLOCK + [7, 3]],
                                     bounds=[[-10, -10], [20, -10], [20, 14], [-10, 14]])
        self.planner = hodograph.Planner(self.world, turn_radius=0.5, clearance=0.25, width=0.5)

    def plan(self, **options):
        return self.planner.plan([-3, 0], [14, 2], **options)

    def test_limits_hold_at_samples_and_the_proof_contains_them(self):
        for aim in CornerAim.__members__.values():
            plan = self.plan(aim=aim)
            path, proof = plan.path, plan.certificate
            xi = np.linspace(path.xi_begin, path.xi_end, 5000)
            points = path.position(xi)
            curvature = np.abs(hodograph.curvature(path, xi)).max()
            distance = distance_to_rings(points, rings_of(self.world)).min()
            self.assertLessEqual(curvature, 2.0)
            self.assertGreaterEqual(distance, 0.5 - hodograph.planning_tolerance * 20.0)
            self.assertLessEqual(curvature, proof.curvature.upper)
            self.assertGreaterEqual(distance, proof.clearance.least().lower)
            self.assertIn(path.arc_length(), proof.arc_length)
            self.assertTrue(proof.proves(self.planner.limits, 20.0))
            self.assertFalse(proof.proves(hodograph.VehicleLimits(turn_radius=50.0), 20.0))
            np.testing.assert_allclose(path.position([path.xi_begin, path.xi_end]),
                                       [[-3, 0], [14, 2]], atol=1024 * EPSILON)
            self.assertEqual(len(plan.legs), len(plan.polyline.corners))

    def test_the_proof_can_be_made_again(self):
        plan = self.plan()
        index = hodograph.ClearanceIndex(self.world)
        again = hodograph.certify_plan(plan.path, index, plan.certificate.clearance.reach)
        self.assertEqual(again.curvature, plan.certificate.curvature)
        self.assertEqual(hodograph.largest_curvature(plan.path), plan.certificate.curvature)
        near = index.clearance(plan.path, 100.0).near
        self.assertEqual([one.obstacle for one in near], [0, 1, WorldVertex.bounds])
        for one in near[:2]:
            points = plan.path.position(np.linspace(plan.path.xi_begin, plan.path.xi_end, 20000))
            sampled = distance_to_rings(points, [self.world.ring(one.obstacle)]).min()
            self.assertGreaterEqual(sampled, one.distance.lower)
            self.assertAlmostEqual(sampled, one.distance.upper, delta=1e-3)
            at = plan.path.position(one.xi)
            self.assertAlmostEqual(np.hypot(*(at - one.nearest)), one.distance.upper, delta=1e-9)

    def test_results_are_pickled(self):
        plan = self.plan(corner_offset=1.0, aim=CornerAim.largest)
        again = pickle.loads(pickle.dumps(plan))
        self.assertEqual(again.path, plan.path)
        self.assertEqual(repr(again), repr(plan))
        np.testing.assert_array_equal(again.polyline.points, plan.polyline.points)
        self.assertEqual(pickle.loads(pickle.dumps(self.planner)).plan([-3, 0], [14, 2]).path,
                         self.plan().path)

    def test_what_cannot_be_planned_names_the_radius_that_could(self):
        with self.assertRaises(HodographError) as caught:
            hodograph.Planner(self.world, turn_radius=40.0).plan([-3, 0], [14, 2])
        error = caught.exception
        self.assertEqual((error.code, error.value), ("no_route", 40.0))
        self.assertLess(error.bound, 40.0)
        for members in ({"turn_radius": 0.0}, {"turn_radius": np.nan},
                        {"turn_radius": 1.0, "clearance": -1.0}):
            with self.assertRaises(HodographError):
                hodograph.Planner(self.world, **members)
        with self.assertRaises(HodographError) as caught:
            self.planner.plan([-3, 0], [2, 0])  # inside the block
        self.assertEqual(caught.exception.index, 0)
        with self.assertRaises(TypeError):
            hodograph.Planner(self.world)

    def test_tangent_plans_meet_the_corners(self):
        plan = self.plan()
        index = hodograph.ClearanceIndex(self.world)
        for rule in (hodograph.TangentRule.t1, hodograph.TangentRule.t2):
            made = hodograph.tangent_plan(plan.polyline, rule, index, 2.0)
            np.testing.assert_allclose(made.path.position(made.path.knots), plan.polyline.points,
                                       atol=1024 * EPSILON)
            xi = np.linspace(made.path.xi_begin, made.path.xi_end, 3000)
            curvature = np.abs(hodograph.curvature(made.path, xi)).max()
            self.assertLessEqual(curvature, made.certificate.curvature.upper)
            self.assertEqual(made.keeps_radius(0.5 / curvature), hodograph.Answer.yes)
            self.assertEqual(made.keeps_distance(50.0), hodograph.Answer.no)
            self.assertEqual(pickle.loads(pickle.dumps(made)).path, made.path)

    def test_spatial_paths_have_no_planar_proof(self):
        index = hodograph.ClearanceIndex(self.world)
        with self.assertRaises(HodographError) as caught:
            index.clearance(hodograph.lifted(self.plan().path), 1.0)
        self.assertEqual(caught.exception.code, "unsupported")


class CornerSizes(unittest.TestCase):
    def test_the_shortest_path_is_a_linear_program(self):
        random = np.random.default_rng(7)
        for count in (1, 3, 6):
            least, saving = random.uniform(0, 1, count), random.uniform(0, 1, count)
            most = least + random.uniform(0, 3, count)
            ends = np.concatenate([[0.0], least, [0.0]])
            lines = ends[:-1] + ends[1:] + random.uniform(0, 3, count + 1)
            corners = [hodograph.CornerRoom(*row) for row in zip(least, most, saving)]
            legs = hodograph.corner_sizes(lines, corners, CornerAim.least_length)
            shares = np.zeros((count + 1, count))
            for k in range(count):
                shares[k, k] = shares[k + 1, k] = 1.0
            best = linprog(-saving, A_ub=shares, b_ub=lines, bounds=list(zip(least, most)))
            self.assertAlmostEqual(saving @ legs, -best.fun, delta=1e-9)
            np.testing.assert_array_equal(
                hodograph.corner_sizes(lines, corners, CornerAim.smallest), least)

    def test_no_room_is_refused(self):
        corner = hodograph.CornerRoom(2.0, 3.0)
        with self.assertRaises(HodographError) as caught:
            hodograph.corner_sizes([1.0, 5.0], [corner], CornerAim.smallest)
        self.assertEqual(caught.exception.code, "no_interpolant")
        with self.assertRaises(HodographError):
            hodograph.corner_sizes([5.0], [corner], CornerAim.smallest)
        with self.assertRaises(HodographError):
            hodograph.corner_sizes([[5.0, 5.0]], [corner], CornerAim.smallest)
        with self.assertRaises(HodographError):
            hodograph.corner_sizes([np.nan, 5.0], [corner], CornerAim.smallest)


if __name__ == "__main__":
    unittest.main()
