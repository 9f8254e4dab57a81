#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""hodograph.plots draws what the library computes, on the axes it is given, and refuses clearly."""

import sys
import unittest
from types import SimpleNamespace
from unittest import mock

import matplotlib

matplotlib.use("Agg")

import numpy as np  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from numpy.testing import assert_allclose, assert_array_equal  # noqa: E402

import hodograph  # noqa: E402
from hodograph import plots  # noqa: E402

_ROUNDING = 1e-12
_PLANAR = hodograph.planar_spline([[0, 0], [1, 2], [3, 1], [4, 4]])
_CLOSED = hodograph.planar_spline([[1, 0], [0, 1], [-1, 0], [0, -1]], closed=True)
_CORNERS = hodograph.rounded_polyline([[0, 0], [5, 0], [5, 5], [0, 5]], most_curvature=2.0)


def _helix(t):
    c, s = np.cos(t), np.sin(t)
    return np.array([[c, s, 0.5 * t], [-s, c, 0.5], [-c, -s, 0], [s, -c, 0], [c, s, 0]])


_SPATIAL = hodograph.fit(_helix, 1e-6, 0.0, 6.0).path
_TRIANGLE = (np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]]))


def _axes(spatial=False):
    return Figure().add_subplot(projection="3d" if spatial else None)


def _pieces(collection):
    return np.array(collection._segments3d if hasattr(collection, "_segments3d")
                    else collection.get_segments())


class Paths(unittest.TestCase):
    def test_a_planar_path_is_drawn_through_its_points(self):
        ax = _axes()
        self.assertIs(plots.path(_PLANAR, ax, unit="m"), ax)
        assert_array_equal(ax.lines[0].get_xydata(),
                           _PLANAR.position(plots.parameters(_PLANAR)))
        self.assertEqual((ax.get_xlabel(), ax.get_ylabel()), ("x / m", "y / m"))
        self.assertEqual(ax.get_aspect(), 1.0)

    def test_a_spatial_path_is_drawn_in_space_with_equal_scales(self):
        ax = plots.path(_SPATIAL, _axes(True))
        points = _SPATIAL.position(plots.parameters(_SPATIAL))
        assert_array_equal(np.transpose(ax.lines[0].get_data_3d()), points)
        sides = [np.ptp(limits) for limits in (ax.get_xlim(), ax.get_ylim(), ax.get_zlim())]
        assert_allclose(ax._box_aspect / ax._box_aspect[0], np.array(sides) / sides[0])

    def test_a_projection_shows_two_coordinates_in_the_order_asked(self):
        ax = plots.path(_SPATIAL, _axes(), plane="zx")
        points = _SPATIAL.position(plots.parameters(_SPATIAL))
        assert_array_equal(ax.lines[0].get_xydata(), points[:, [2, 0]])
        self.assertEqual((ax.get_xlabel(), ax.get_ylabel()), ("z", "x"))

    def test_knots_and_arrows_are_where_they_should_be(self):
        ax = plots.path(_PLANAR, _axes(), knots=True, arrows=3)
        assert_array_equal(ax.lines[1].get_xydata(), _PLANAR.position(_PLANAR.knots))
        tips = np.array([text.xy for text in ax.texts])
        s = _PLANAR.arc_length() * np.array([1, 3, 5]) / 6
        assert_allclose(tips, _PLANAR.point_at_arc_length(s), atol=_ROUNDING)

    def test_samples_hold_every_knot_and_are_about_as_many_as_asked(self):
        for path in (_PLANAR, _CLOSED, _SPATIAL, _CORNERS):
            for count in (2, 50, 1000):
                xi = plots.parameters(path, count)
                self.assertTrue(np.all(np.isin(path.knots, xi)))
                self.assertTrue(np.all(np.diff(xi) > 0.0))
                self.assertLessEqual(len(xi), count + 17 * len(path.knots))

    def test_keywords_reach_the_line(self):
        line = plots.path(_PLANAR, _axes(), color="k", lw=3, label="way").lines[0]
        self.assertEqual((line.get_color(), line.get_linewidth(), line.get_label()),
                         ("k", 3, "way"))

    def test_a_path_inside_a_result_is_drawn(self):
        for result in (SimpleNamespace(path=_PLANAR), SimpleNamespace(curve=_PLANAR)):
            self.assertEqual(len(plots.path(result, _axes()).lines), 1)


class CurvatureComb(unittest.TestCase):
    def test_teeth_are_the_curvature_long_and_point_away_from_the_centre(self):
        ax = plots.curvature_comb(_CLOSED, _axes(), scale=0.5, teeth=40)
        teeth = _pieces(ax.collections[0])
        self.assertEqual(teeth.shape, (40, 2, 2))
        s = np.arange(40) / 40 * _CLOSED.arc_length()
        at = _CLOSED.parameter_at_arc_length(s)
        assert_allclose(teeth[:, 0], _CLOSED.position(at), atol=_ROUNDING)
        length = np.linalg.norm(teeth[:, 1] - teeth[:, 0], axis=1)
        assert_allclose(length, 0.5 * np.abs(hodograph.curvature(_CLOSED, at)), rtol=1e-9)
        self.assertTrue(np.all(np.linalg.norm(teeth[:, 1], axis=1) > 1.1))  # a circle, about

    def test_a_helix_has_teeth_away_from_its_axis(self):
        ax = plots.curvature_comb(_SPATIAL, _axes(True), scale=1.0, teeth=9)
        teeth = _pieces(ax.collections[0])
        assert_allclose(teeth[:, 1, :2], 1.8 * teeth[:, 0, :2], atol=1e-3)  # curvature 1/1.25

    def test_a_straight_path_has_a_comb_of_no_height(self):
        line = hodograph.planar_hermite_path([0, 1], [[0, 0], [3, 4]], [[3, 4], [3, 4]])
        tips = plots.curvature_comb(line, _axes()).lines[-1].get_xydata()
        assert_allclose(tips[-1], [3, 4], atol=_ROUNDING)


class Frames(unittest.TestCase):
    def test_the_frame_of_the_preimage_is_drawn(self):
        ax = plots.frames(_SPATIAL, _axes(True), count=7, length=0.25)
        self.assertEqual(len(ax.collections), 3)
        at = _SPATIAL.parameter_at_arc_length(np.linspace(0, _SPATIAL.arc_length(), 7))
        matrices = hodograph.euler_rodrigues_frame(_SPATIAL, at)
        for axis, collection in enumerate(ax.collections):
            pieces = _pieces(collection)
            assert_allclose(pieces[:, 1] - pieces[:, 0], 0.25 * matrices[..., axis],
                            atol=_ROUNDING)

    def test_a_frame_of_ones_own_is_drawn(self):
        ax = plots.frames(_SPATIAL, _axes(), frame=lambda xi: np.tile(np.eye(3), (len(xi), 1, 1)),
                          count=5, which=(2,), plane="xy", length=1.0, linewidths=2.0)
        pieces = _pieces(ax.collections[0])
        assert_allclose(pieces[:, 1] - pieces[:, 0], np.tile([0.0, 1.0], (5, 1)), atol=_ROUNDING)
        self.assertEqual(ax.collections[0].get_linewidths()[0], 2.0)


    def test_a_roll_is_drawn(self):
        roll = hodograph.frenet_roll(_SPATIAL)
        ax = plots.frames(_SPATIAL, _axes(True), frame=roll, count=6, which=(2,), length=1.0)
        pieces = _pieces(ax.collections[0])
        assert_allclose(pieces[:, 1, :2], 0.0, atol=1e-4)  # a helix: towards its axis
        with self.assertRaisesRegex(hodograph.HodographError, "a FrameRoll or a callable, not int"):
            plots.frames(_SPATIAL, _axes(True), frame=3)


class Profiles(unittest.TestCase):
    def test_curvature_over_arc_length(self):
        line = plots.profile(_PLANAR, ax=_axes(), unit="m").lines[0]
        s, kappa = line.get_data()
        at = _PLANAR.parameter_at_arc_length(np.clip(s, 0.0, _PLANAR.arc_length()))
        assert_allclose(kappa, hodograph.curvature(_PLANAR, at), atol=1e-8)

    def test_angular_velocity_has_a_line_for_each_component(self):
        ax = plots.profile(_SPATIAL, "angular_velocity", _axes(), over="xi")
        xi = ax.lines[0].get_xdata()
        rates = hodograph.body_rate_per_arc_length(_SPATIAL, xi)
        for k, line in enumerate(ax.lines):
            assert_array_equal(line.get_ydata(), rates[:, k])

    def test_a_jump_breaks_the_line_and_continuity_does_not(self):
        jumps = plots.profile(_CORNERS, "speed", _axes()).lines[0].get_ydata()
        self.assertEqual(np.isnan(jumps).sum(), 4)
        self.assertFalse(np.isnan(plots.profile(_CORNERS, ax=_axes()).lines[0].get_ydata()).any())

    def test_a_path_of_one_segment_has_no_knot_to_break_at(self):
        one = hodograph.planar_hermite_path([0, 1], [[0, 0], [1, 0]], [[1, 1], [1, -1]])
        for quantity in ("curvature", lambda xi: np.stack([xi, xi], axis=-1)):
            lines = plots.profile(one, quantity, _axes(), knots=True).lines
            self.assertTrue(np.all(np.isfinite(lines[0].get_ydata())))

    def test_a_callable_and_relative_length(self):
        ax = plots.profile(_PLANAR, lambda xi: xi**2, _axes(), relative=True, knots=True, name="q")
        x, y = ax.lines[0].get_data()
        self.assertEqual((x[0], x[-1], y[-1]), (0.0, 1.0, _PLANAR.xi_end**2))
        self.assertEqual(ax.get_ylabel(), "q")
        self.assertEqual(len(ax.lines), 1 + _PLANAR.segment_count - 1)


class Worlds(unittest.TestCase):
    def test_rings_and_holes_are_drawn(self):
        square = np.array([[0.0, 0], [4, 0], [4, 4], [0, 4]])
        yard = SimpleNamespace(outer=square, holes=[square / 2 + 1])
        world = SimpleNamespace(obstacles=[yard, square + 10], bounds=square * 5)
        ax = plots.world(world, _axes())
        self.assertEqual([len(patch.get_path().vertices) for patch in ax.patches], [10, 5, 5])
        self.assertLessEqual(ax.get_xlim()[0], 0.0)
        self.assertGreaterEqual(ax.get_xlim()[1], 20.0)

    def test_the_band_reaches_as_far_as_asked(self):
        ax = plots.band(_CORNERS, 0.25, _axes())
        corners = np.concatenate([path.vertices for path in ax.collections[0].get_paths()])
        points = _CORNERS.position(plots.parameters(_CORNERS))
        distance = np.array([np.linalg.norm(points - corner, axis=1).min() for corner in corners])
        self.assertLess(distance.max(), 0.25 + _ROUNDING)
        self.assertGreater(distance.max(), 0.2499)

    def test_circles_touch_the_path_where_it_is_bent_most(self):
        ax = plots.turn_circles(_CORNERS, _axes())
        self.assertEqual(len(ax.lines), 2)
        for line in ax.lines:
            round_about = line.get_xydata()
            middle = round_about[:-1].mean(axis=0)
            radius = np.linalg.norm(round_about - middle, axis=1)
            assert_allclose(radius, 0.5, rtol=1e-3)
        line = hodograph.planar_hermite_path([0, 1], [[0, 0], [3, 4]], [[3, 4], [3, 4]])
        self.assertEqual(len(plots.turn_circles(line, _axes()).lines), 0)

    def test_a_plan_is_drawn_with_its_world(self):
        ax = plots.plan(_CORNERS, _axes(), world=[np.array([[0.5, 0.5], [1.5, 0.5], [1, 1.5]])],
                        clearance=0.1, turn_radius=0.5)
        self.assertEqual(len(ax.patches), 3)  # the obstacle and the band's two ends
        self.assertEqual(len(ax.lines), 5)  # two circles, the path, start and goal


class Swarms(unittest.TestCase):
    def setUp(self):
        def vehicle(name, y, begin):
            motion = SimpleNamespace(
                position=lambda t: np.stack([t, np.full_like(t, y), 0.0 * t], axis=-1),
                start_time=begin, end_time=10.0)
            return SimpleNamespace(id=name, motion=motion, radius=0.5)

        self.fleet = [vehicle("a", 0.0, 0.0), vehicle("b", 3.0, 2.0), vehicle("c", 7.0, 0.0)]

    def test_ways_and_places(self):
        ax = plots.swarm(self.fleet, _axes(), time=4.0)
        assert_allclose(ax.lines[3].get_xydata()[[0, -1]], [[2.0, 3.0], [10.0, 3.0]])
        self.assertEqual(len(ax.patches), 3)
        assert_allclose(ax.patches[1].center, [4.0, 3.0])

    def test_separations_of_all_pairs(self):
        ax = plots.separations(self.fleet, _axes(), required=1.0, highlight=1, unit="m")
        pairs = {line.get_label(): line for line in ax.lines[:3]}
        assert_allclose(pairs["a and b"].get_ydata(), 3.0)
        self.assertEqual(pairs["a and b"].get_xdata()[0], 2.0)
        self.assertEqual(len(ax.lines), 4)


class Surfaces(unittest.TestCase):
    def test_all_triangles_are_drawn(self):
        vertices = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0.5]])
        faces = np.array([[0, 1, 2], [2, 1, 3]])
        ax = plots.surface(vertices, _axes(True), faces=faces)
        self.assertEqual(ax.collections[0]._vec.shape[1], 6)
        self.assertGreaterEqual(ax.get_zlim()[1], 0.5)
        mesh = SimpleNamespace(positions=vertices, triangles=faces, position_of=[])
        self.assertEqual(plots.surface(SimpleNamespace(mesh=mesh), _axes(True))
                         .collections[0]._vec.shape[1], 6)


class Convergence(unittest.TestCase):
    def test_orders_and_points(self):
        counts = 2 ** np.arange(6)
        ax = plots.convergence(counts, 3.0 * counts**-4.0, _axes(), order=4)
        assert_allclose(plots.orders(counts, 3.0 * counts**-4.0), 4.0)
        assert_array_equal(ax.lines[0].get_xdata(), counts)
        assert_allclose(ax.lines[1].get_ydata(), [3.0, 3.0 * 32**-4.0])
        self.assertEqual(ax.texts[0].get_text(), "order 4.00")


class Refusals(unittest.TestCase):
    def refused(self, pattern, function, *arguments, **named):
        with self.assertRaisesRegex(hodograph.HodographError, pattern):
            function(*arguments, **named)

    def test_they_say_what_was_wrong(self):
        self.refused("not list", plots.path, [[0, 0], [1, 1]])
        self.refused("projection='3d'", plots.path, _SPATIAL, _axes())
        self.refused("must not have", plots.profile, _PLANAR, ax=_axes(True))
        self.refused("not 'xx'", plots.path, _SPATIAL, _axes(), plane="xx")
        self.refused("two of x, y, such", plots.path, _PLANAR, _axes(), plane="xz")
        self.refused("axes of matplotlib, not int", plots.path, _PLANAR, 3)
        self.refused("2 samples at least, not 1", plots.path, _PLANAR, _axes(), samples=1)
        self.refused("a planar path is needed", plots.band, _SPATIAL, 1.0, _axes())
        self.refused("positive, not 0", plots.band, _PLANAR, 0.0, _axes())
        self.refused("a spatial path", plots.profile, _PLANAR, "torsion", _axes())
        self.refused("not 'sped'", plots.profile, _PLANAR, "sped", _axes())
        self.refused("not 'time'", plots.profile, _PLANAR, ax=_axes(), over="time")
        self.refused("1 to 2, not", plots.frames, _PLANAR, _axes(), which=(3,))
        self.refused("shape", plots.frames, _SPATIAL, _axes(True), frame=lambda xi: xi)
        self.refused("one shape", plots.convergence, [1, 2], [1.0], _axes())
        self.refused("positive", plots.convergence, [1, 2], [1.0, 0.0], _axes())
        self.refused("one vehicle at least", plots.swarm, [])
        self.refused("timed motions, not int", plots.swarm, [1])
        self.refused("TriangleMesh", plots.surface, 3, _axes(True))
        self.refused("vertices 0 to 2", plots.surface, _TRIANGLE[0], _axes(True),
                     faces=_TRIANGLE[1] + 1)
        self.refused("one triangle at least", plots.surface, _TRIANGLE[0], _axes(True),
                     faces=np.zeros((0, 3), int))
        self.refused("radius is positive, not -1", plots.turn_circles, _PLANAR, _axes(), radius=-1)
        rest = hodograph.planar_hermite_path([0, 1], [[0, 0], [1, 0]], [[0, 0], [1, 1]])
        self.refused("stands still at xi = 0", plots.curvature_comb, rest, _axes())
        self.refused("one tooth", plots.curvature_comb, _PLANAR, _axes(), teeth=0)
        self.refused("n at least 3", plots.world, [[[0, 0], [1, 1]]], _axes())

    def test_matplotlib_missing_is_said(self):
        with mock.patch.dict(sys.modules, {"matplotlib": None}):
            with self.assertRaisesRegex(ImportError, "python3-matplotlib"):
                plots.path(_PLANAR)


class Looks(unittest.TestCase):
    def test_shades_are_so_many_distinct_colours(self):
        for count in (1, 2, 5, 20):
            shades = plots.shades(count)
            self.assertEqual(len(set(shades)), count)
            self.assertTrue(all(0.0 <= part <= 1.0 for colour in shades for part in colour))

    def test_flat_data_in_space_keep_a_box_with_sides(self):
        ax = plots.path(hodograph.lifted(_PLANAR), _axes(True))
        self.assertGreater(min(ax._box_aspect), 0.0)
        self.assertLess(ax.get_zlim()[0], 0.0)


class Manners(unittest.TestCase):
    def test_nothing_global_changes_and_pyplot_makes_new_axes_only(self):
        from matplotlib import pyplot

        before = dict(matplotlib.rcParams)
        plots.path(_PLANAR, _axes())
        self.assertEqual(pyplot.get_fignums(), [])
        ax = plots.frames(_SPATIAL)
        self.assertEqual(ax.name, "3d")
        self.assertEqual(len(pyplot.get_fignums()), 1)
        pyplot.close("all")
        self.assertEqual(before, dict(matplotlib.rcParams))

    def test_importing_the_package_does_not_import_matplotlib(self):
        import subprocess

        check = "import sys, hodograph.plots; sys.exit('matplotlib' in sys.modules)"
        self.assertEqual(subprocess.run([sys.executable, "-c", check]).returncode, 0)


if __name__ == "__main__":
    unittest.main()
