# SPDX-License-Identifier: MIT
"""The sample worlds and swarms of data/ and examples/, for the gallery."""

from __future__ import annotations

import json

import numpy as np
from gallery import ROOT, direction

import hodograph


def world(name):
    """A world from GeoJSON, with its start and goal."""
    features = json.loads((ROOT / name).read_text("utf-8"))["features"]
    obstacles, bounds, ends = [], None, {}
    for feature in features:
        role = feature["properties"].get("role")
        shape = feature["geometry"]
        if shape["type"] == "Point":
            ends[role] = shape["coordinates"]
            continue
        polygons = [shape["coordinates"]] if shape["type"] == "Polygon" else shape["coordinates"]
        for rings in polygons:
            rings = [np.array(ring, dtype=float)[:-1] for ring in rings]
            if role == "bounds":
                bounds = rings[0]
            else:
                obstacles.append(hodograph.Polygon(rings[0], rings[1:]))
    return hodograph.World(obstacles, bounds), ends["start"], ends["goal"]


def arriving(name):
    """The vehicles of a swarm's file that arrive together, and the file's other members."""
    data = json.loads((ROOT / name).read_text("utf-8"))
    vehicles = [hodograph.ArrivingVehicle(
        one["id"], one["start"]["position"], direction(one["start"]["angle"]),
        one["end"]["position"], direction(one["end"]["angle"]), speed=one.get("speed", 1.0),
        departure=one.get("departure", 0.0), radius=one.get("radius", 0.0),
        most_curvature=one.get("most_curvature"),
        altitude=one.get("altitude", 0.0)) for one in data["vehicles"]]
    return vehicles, data
