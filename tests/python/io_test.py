#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files of others: documents with their promises, GeoJSON, tables, missions, meshes, pictures.

What is written is read by the parsers of Python's standard library, not by the library itself.
"""

import csv
import io
import json
import pickle
import re
import struct
import tempfile
import unittest
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

import hodograph
from hodograph import Enclosure, HodographError, PathDocument, Promises

ROOT = Path(__file__).resolve().parents[2]
EPSILON = np.finfo(float).eps


def refusal(test, call):
    with test.assertRaises(HodographError) as caught:
        call()
    return caught.exception


class Documents(unittest.TestCase):
    def document(self, planar=True):
        path = hodograph.planar_spline([[0, 0], [1, 2], [3, 1]])
        path = path if planar else hodograph.lifted(path)
        promises = Promises(
            continuity=hodograph.ContinuityOrders(position=2, preimage=1, frame=1,
                                                  angular_velocity=0),
            error=hodograph.ErrorPromise(Enclosure(0.0, 1e-9), True, "a spline"),
            arc_length=Enclosure(5.0, 5.5), smallest_speed=Enclosure(0.5, 1.0),
            largest_speed=Enclosure(2.0, 3.0), curvature_bound=4.0, end=[3, 1, 0],
            largest_curvature=Enclosure(3.0, 3.5),
            clearance=hodograph.ClearancePromise(
                world="city.geojson", reach=2.5,
                obstacles=[hodograph.ObstacleDistance(3, Enclosure(0.5, 0.75))],
                bounds=Enclosure(1.0, 1.25)) if planar else None,
            helix=None if planar else hodograph.HelixPromise(
                axis=[0, 1, 0], sines=[hodograph.HelixSine(0, Enclosure(0.25, 0.5))]))
        return PathDocument(
            path, name="route", length_unit="m", parameter_unit="s",
            roll=None if planar else hodograph.LinearRoll(0.0, 0.125, 0.5),
            provenance=hodograph.Provenance(program="test", source="points", method="spline",
                                            choice="chords", tolerance=1e-9),
            promises=promises)

    def test_hold_every_member_and_promise(self):
        for planar in (True, False):
            document = self.document(planar)
            text = hodograph.to_json(document)
            stated = json.loads(text)
            self.assertEqual((stated["format"], stated["version"]),
                             (hodograph.document_format, hodograph.document_version))
            self.assertEqual(stated["promises"]["curvature_bound"], 4.0)
            for again in (hodograph.parse_document(text), pickle.loads(pickle.dumps(document))):
                self.assertEqual(again.path, document.path)
                self.assertEqual(again.provenance, document.provenance)
                self.assertEqual(again.promises, document.promises)
                self.assertEqual((again.name, again.length_unit, again.parameter_unit),
                                 ("route", "m", "s"))
                if not planar:
                    self.assertEqual(again.roll.angle(2.0), 1.125)
        self.assertTrue(PathDocument(document.path).promises.empty())
        self.assertIn("Promises(continuity=ContinuityOrders(position=2", repr(document.promises))

    def test_go_to_files_and_back(self):
        document = self.document()
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "path.json"
            hodograph.save_document(document, file)
            self.assertEqual(hodograph.load_document(file).promises, document.promises)
            self.assertEqual(hodograph.load_document(str(file)).path, document.path)
            hodograph.save_document(document.path, file, name="bare")
            self.assertEqual(hodograph.load_document(file).name, "bare")
            error = refusal(self, lambda: hodograph.save_document(document, Path(folder) / "a/b"))
            self.assertEqual(error.code, "not_written")
        error = refusal(self, lambda: hodograph.parse_document('{"format": 1}', "it"))
        self.assertIn("it", str(error))
        refusal(self, lambda: hodograph.LinearRoll(0.0, float("nan"), 0.0))
        refusal(self, lambda: Promises(end=[0, 1]))


class GeoJson(unittest.TestCase):
    def test_worlds_are_those_of_the_file(self):
        file = ROOT / "examples" / "harbour.geojson"
        read = hodograph.load_world(file)
        features = json.loads(file.read_text())["features"]
        polygons = []
        for feature in features:
            kind, rings = feature["geometry"]["type"], feature["geometry"]["coordinates"]
            if feature["properties"].get("role", "obstacle") == "obstacle":
                polygons += rings if kind == "MultiPolygon" else [rings]
        self.assertEqual(len(read.world.obstacles), len(polygons))
        for mine, given in zip(read.world.obstacles, polygons):
            self.assertEqual({tuple(p) for p in mine.outer}, {tuple(p) for p in given[0]})
            self.assertEqual(len(mine.holes), len(given) - 1)
        np.testing.assert_array_equal(read.start, [0, 0])
        np.testing.assert_array_equal(read.goal, [80, 60])
        self.assertEqual(pickle.loads(pickle.dumps(read)).world, read.world)

    def test_scenes_read_back_as_the_same_world(self):
        read = hodograph.load_world(ROOT / "examples" / "harbour.geojson")
        plan = hodograph.Planner(read.world, turn_radius=3.0, clearance=1.0).plan(read.start,
                                                                               read.goal)
        line = hodograph.waypoints_along(plan.path, 0.01)
        promises = Promises(arc_length=plan.certificate.arc_length)
        text = hodograph.to_geojson(
            read.world, [hodograph.GeoJsonPath(line[:, :2], name="way", chord_tolerance=0.01,
                                               promises=promises)],
            start=read.start, goal=read.goal)
        again = hodograph.parse_world(text)
        self.assertEqual(again.world.obstacles, read.world.obstacles)
        np.testing.assert_array_equal(again.goal, read.goal)
        [way] = [feature for feature in json.loads(text)["features"]
                 if feature["geometry"]["type"] == "LineString"]
        np.testing.assert_array_equal(way["geometry"]["coordinates"], line[:, :2])
        # Every point of the path is within the tolerance of the line.
        points = plan.path.position(np.linspace(plan.path.xi_begin, plan.path.xi_end, 3000))
        least = np.full(len(points), np.inf)
        for a, b in zip(line[:-1, :2], line[1:, :2]):
            along = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
            least = np.minimum(least, np.hypot(*(points - a - along[:, None] * (b - a)).T))
        self.assertLessEqual(least.max(), 0.01)

    def test_refusals(self):
        self.assertEqual(refusal(self, lambda: hodograph.parse_world("{")).code,
                         "malformed_document")
        refusal(self, lambda: hodograph.load_world("missing.geojson"))
        refusal(self, lambda: hodograph.to_geojson(
            hodograph.World(), [hodograph.GeoJsonPath([[0.0, 0.0]])]))
        refusal(self, lambda: hodograph.GeoJsonPath([0.0, 1.0]))


class Tables(unittest.TestCase):
    def test_are_those_of_the_csv_module(self):
        text = 'Time (TU),"x, first",y\n0,1.5,2\n0.25,-1e-300,3\n'
        table = hodograph.read_table(text)
        rows = list(csv.reader(io.StringIO(text)))
        self.assertEqual(table.names, rows[0])
        np.testing.assert_array_equal(table.values, np.array(rows[1:], dtype=float))
        self.assertEqual(table.column("time"), 0)
        self.assertEqual(hodograph.unit_of(table.names[0]), "TU")
        self.assertEqual(table.lines, [2, 3])
        again = hodograph.Table(table.values, table.names)
        self.assertEqual(hodograph.to_csv(again), hodograph.to_csv(table))
        with self.assertRaises(ValueError):
            table.values[0, 0] = 1.0
        samples = hodograph.curve_samples(table, coordinates=["2", "3"])
        np.testing.assert_array_equal(samples.points, table.values[:, 1:])
        self.assertEqual((samples.dimension, samples.parameter_unit), (2, "TU"))

    def test_refusals(self):
        error = refusal(self, lambda: hodograph.read_table("a,b\n1,2\n3\n"))
        self.assertIn("line 3", str(error))
        refusal(self, lambda: hodograph.read_table(""))
        refusal(self, lambda: hodograph.Table(np.zeros(3)))
        refusal(self, lambda: hodograph.Table([[np.nan]]))
        refusal(self, lambda: hodograph.Table(np.zeros((2, 2)), ["a"]))
        refusal(self, lambda: hodograph.Table(np.zeros((2, 2))).column("z"))
        with self.assertRaises(IndexError):
            hodograph.Table(np.zeros((2, 2))).title(2)


class Missions(unittest.TestCase):
    datum = hodograph.GeodeticPoint(51.5, 7.25, 100.0)

    def local_axes(self):
        """East, north and up at the datum, and the datum, in the axes of the Earth (WGS 84)."""
        a, f = 6378137.0, 1.0 / 298.257223563
        return a, f * (2.0 - f)

    def earth_centred(self, place):
        a, e2 = self.local_axes()
        lat, lon = np.radians([place.latitude, place.longitude])
        n = a / np.sqrt(1.0 - e2 * np.sin(lat)**2)
        return np.array([(n + place.altitude) * np.cos(lat) * np.cos(lon),
                         (n + place.altitude) * np.cos(lat) * np.sin(lon),
                         (n * (1.0 - e2) + place.altitude) * np.sin(lat)])

    def test_places_are_those_of_the_ellipsoid(self):
        plane = hodograph.LocalTangentPlane(self.datum)
        lat, lon = np.radians([self.datum.latitude, self.datum.longitude])
        east = np.array([-np.sin(lon), np.cos(lon), 0.0])
        up = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
        north = np.cross(up, east)
        for local in ([0, 0, 0], [1200.0, -350.0, 80.0], [-9000.0, 4000.0, -20.0]):
            place = plane.to_geodetic(local)
            offset = self.earth_centred(place) - self.earth_centred(self.datum)
            np.testing.assert_allclose([offset @ east, offset @ north, offset @ up], local,
                                       atol=1e-7)
            np.testing.assert_allclose(plane.to_local(place), local, atol=2e-8)

    def test_files_hold_the_waypoints(self):
        path = hodograph.planar_spline([[0, 0], [100, 200], [300, 100]])
        points = hodograph.waypoints_along(path, 1.0, 30.0)
        self.assertTrue(np.all(points[:, 2] == 30.0))
        mission = hodograph.mission(points, self.datum, speeds=7.5, acceptance_radius=2.0)
        self.assertEqual(len(mission.waypoints), len(points))
        self.assertEqual(pickle.loads(pickle.dumps(mission)).waypoints, mission.waypoints)
        plan = json.loads(hodograph.to_qgroundcontrol_plan(mission))
        self.assertEqual(plan["fileType"], "Plan")
        legs = [item for item in plan["mission"]["items"] if item["command"] == 16]
        self.assertEqual([leg["params"][4:6] for leg in legs],
                         [[w.latitude, w.longitude] for w in mission.waypoints])
        lines = hodograph.to_waypoint_file(mission).splitlines()
        self.assertEqual(lines[0], "QGC WPL 110")
        self.assertEqual(len(lines[1].split("\t")), 12)

    def test_refusals(self):
        refusal(self, lambda: hodograph.GeodeticPoint(91.0, 0.0))
        refusal(self, lambda: hodograph.mission(np.zeros((0, 3)), self.datum))
        refusal(self, lambda: hodograph.mission(np.zeros((2, 2)), self.datum))
        refusal(self, lambda: hodograph.mission(np.zeros((2, 3)), self.datum, speeds=[1.0]))
        error = refusal(self, lambda: hodograph.mission(np.zeros((2, 3)), self.datum,
                                                        speeds=[1.0, -1.0]))
        self.assertEqual(error.index, 1)
        refusal(self, lambda: hodograph.waypoints_along(
            hodograph.planar_spline([[0, 0], [1, 2], [3, 1]]), 0.0))
        refusal(self, lambda: hodograph.LocalTangentPlane(self.datum).to_geodetic([1e7, 0, 0]))


class Meshes(unittest.TestCase):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])

    def test_files_hold_the_triangles(self):
        mesh = hodograph.TriangleMesh(self.corners, self.triangles)
        with tempfile.TemporaryDirectory() as folder:
            for suffix in ("stl", "obj", "glb"):
                file = Path(folder) / ("solid." + suffix)
                hodograph.save_mesh(mesh, file, name="corner")
                kind = hodograph.mesh_format_of(str(file))
                self.assertEqual(file.read_bytes(),
                                 hodograph.mesh_bytes(mesh, kind, name="corner"))
            refusal(self, lambda: hodograph.save_mesh(mesh, Path(folder) / "solid.xyz"))
            refusal(self, lambda: hodograph.save_mesh(mesh, Path(folder) / "no" / "solid.stl"))
        stl = hodograph.mesh_bytes(mesh, hodograph.MeshFormat.stl)
        self.assertEqual(struct.unpack_from("<I", stl, 80), (4,))
        first = np.array(struct.unpack_from("<12f", stl, 84)[3:]).reshape(3, 3)
        np.testing.assert_array_equal(first, self.corners[self.triangles[0]])
        obj = hodograph.mesh_bytes(mesh, hodograph.MeshFormat.obj).decode()
        self.assertEqual(len(re.findall(r"^v ", obj, re.MULTILINE)), 4)
        self.assertEqual(len(re.findall(r"^f ", obj, re.MULTILINE)), 4)
        self.assertEqual(hodograph.mesh_bytes(mesh, hodograph.MeshFormat.glb)[:4], b"glTF")
        self.assertEqual(hodograph.rounding_of(mesh, hodograph.MeshFormat.obj), 0.0)
        self.assertTrue(ElementTree.fromstring(hodograph.mesh_svg(mesh)).tag.endswith("svg"))
        refusal(self, lambda: hodograph.mesh_svg(mesh, width=float("nan")))

    def test_what_a_format_cannot_hold_is_refused(self):
        far = hodograph.TriangleMesh(self.corners * 1e300, self.triangles)
        for kind in (hodograph.MeshFormat.stl, hodograph.MeshFormat.glb):
            refusal(self, lambda: hodograph.mesh_bytes(far, kind))
        text = hodograph.mesh_bytes(far, hodograph.MeshFormat.obj).decode()
        self.assertIn("1e+300", text.replace("1e300", "1e+300"))


class Pictures(unittest.TestCase):
    def test_svg_is_xml_and_holds_the_labels(self):
        x = np.linspace(0.0, 6.0, 50)
        plot = hodograph.Plot(
            [hodograph.Series(x, np.sin(x), label="sine < 1"),
             hodograph.Series(x, np.cos(x), style=hodograph.SeriesStyle.dots,
                              color=hodograph.PlotColor.gold)],
            title="waves", x=hodograph.PlotAxis("t"), y=hodograph.PlotAxis("y"),
            arrows=[hodograph.Arrows([[0, 0]], [[1, 1]])], levels=[hodograph.PlotLevel(0.5, "half")],
            marks=[hodograph.PlotMark([0, 0], "start")], x_marks=[1.0, 2.0])
        root = ElementTree.fromstring(hodograph.to_svg(plot))
        words = "".join(root.itertext())
        for label in ("sine < 1", "waves", "half", "start"):
            self.assertIn(label, words)
        ElementTree.fromstring(hodograph.to_svg([plot, plot], 2))
        self.assertEqual(hodograph.escaped_markup("<&>"), "&lt;&amp;&gt;")
        self.assertIn("{", hodograph.plot_style())
        refusal(self, lambda: hodograph.Series([0, 1], [0]))
        refusal(self, lambda: hodograph.Plot(width=0.0))
        refusal(self, lambda: hodograph.to_svg([], 1))
        refusal(self, lambda: hodograph.Arrows([[0, 0]], np.zeros((2, 2))))

    def test_curves_with_frames_are_projected(self):
        t = np.linspace(0.0, 6.0, 60)
        points = np.stack([np.cos(t), np.sin(t), 0.1 * t], axis=1)
        frames = np.broadcast_to(np.eye(3), (4, 3, 3))
        curve = hodograph.FramedPolyline(points, frame_origins=points[:4], frames=frames,
                                         knots=points[::20])
        for projection in hodograph.Projection.__members__.values():
            plot = hodograph.projected(curve, projection, "m")
            ElementTree.fromstring(hodograph.to_svg(plot))
        plane = hodograph.FramedPolyline(points[:, :2], frame_origins=points[:2, :2],
                                         frames=np.broadcast_to(np.eye(2), (2, 2, 2)))
        self.assertEqual(plane.points.shape, (60, 3))
        ElementTree.fromstring(hodograph.to_svg(hodograph.plane_picture(plane)))
        refusal(self, lambda: hodograph.FramedPolyline(points, frame_origins=points[:2]))
        refusal(self, lambda: hodograph.FramedPolyline(points, frame_origins=points[:2],
                                                       frames=np.zeros((3, 3, 3))))

    def test_dxf_holds_the_control_points(self):
        curve = hodograph.RationalBezier([[0, 0], [1, 2], [3, 1]], [1.0, 0.5, 1.0])
        text = hodograph.to_dxf([hodograph.DxfCurves([curve], layer="cut")],
                                hodograph.dxf_unit("mm"))
        pairs = list(zip(*[iter(text.splitlines())] * 2))
        entity = pairs[pairs.index(("  0", "SPLINE")) if ("  0", "SPLINE") in pairs
                       else [p[1] for p in pairs].index("SPLINE"):]
        xs = [float(value) for code, value in entity if code.strip() == "10"]
        ys = [float(value) for code, value in entity if code.strip() == "20"]
        self.assertEqual(list(zip(xs, ys)), [(0.0, 0.0), (1.0, 2.0), (3.0, 1.0)])
        self.assertIn("cut", text)


if __name__ == "__main__":
    unittest.main()
