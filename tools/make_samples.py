#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the sample worlds and swarms of data/: the same files, bit for bit, wherever it runs.

    tools/make_samples.py             writes data/
    tools/make_samples.py --to DIR    writes DIR instead
    tools/make_samples.py --check     says which files differ from data/, exit code 1 if any does

Random numbers are whole-number arithmetic of our own, coordinates are rounded to a few decimals,
so that neither the version of Python nor the rounding of a sine decides a digit.
"""

import argparse
import math
import sys
from pathlib import Path


class Random:
    """Numbers from Marsaglia's 64-bit xorshift."""

    def __init__(self, seed):
        self.state = seed

    def whole(self, low, high):
        """A whole number from low to high, both included."""
        mask = (1 << 64) - 1
        x = self.state
        x ^= (x << 13) & mask
        x ^= x >> 7
        x ^= (x << 17) & mask
        self.state = x
        return low + (x >> 11) % (high - low + 1)

    def between(self, low, high):
        return low + (high - low) * self.whole(0, 10000) / 10000


def text(value, decimals=4):
    """A number, rounded, without trailing zeros."""
    rounded = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if rounded in ("-0", "") else rounded


def point(p):
    return f"[{text(p[0])}, {text(p[1])}]"


def ring(points):
    return "[" + ", ".join(point(p) for p in [*points, points[0]]) + "]"


def feature(geometry, properties):
    inside = ", ".join(f'"{key}": "{value}"' for key, value in properties.items())
    return f'{{"type": "Feature", "properties": {{{inside}}}, "geometry": {geometry}}}'


def polygon(rings, **properties):
    coordinates = ", ".join(ring(r) for r in rings)
    return feature(f'{{"type": "Polygon", "coordinates": [{coordinates}]}}', properties)


def place(p, role):
    return feature(f'{{"type": "Point", "coordinates": {point(p)}}}', {"role": role})


def collection(features):
    return ('{"type": "FeatureCollection", "features": [\n' + ",\n".join(features) + "\n]}\n")


def rectangle(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def star(random, middle, radius, corners, least=0.45):
    """Corners at growing angles, each between `least` and 1 of the radius away."""
    turn = random.between(0, 2 * math.pi)
    result = []
    for k in range(corners):
        angle = turn + 2 * math.pi * k / corners
        r = radius * random.between(least, 1)
        result.append((middle[0] + r * math.cos(angle), middle[1] + r * math.sin(angle)))
    return result


# ---- worlds -------------------------------------------------------------------------------------


def obstacle_field():
    """A field of polygons in staggered columns, as in Figures 10, 11 and 13."""
    random = Random(20100731)
    features = [place((0, 4.2), "start"), place((22, 4.6), "goal")]
    for column in range(7):
        for row in range(5):
            middle = (2.4 + 2.8 * column + random.between(-0.2, 0.2),
                      0.4 + 2.3 * row + (1.15 if column % 2 else 0) + random.between(-0.15, 0.15))
            corners = random.whole(4, 7)
            features.append(polygon([star(random, middle, random.between(1.1, 1.3), corners, 0.75)]))
    return collection(features)


def intricate():
    """One obstacle with many convex and concave corners: a winding way between teeth that hang from
    above and stand below, as in Figure 12."""
    random = Random(17361736)
    width, height, wall, teeth, gap = 16.4, 4.0, 0.6, 7, 2.05
    top, bottom = [(0, height)], []
    for k in range(teeth):
        x = gap * (k + 1)
        half = random.between(0.25, 0.45)
        deep = random.between(2.5, 2.9)
        slant = random.between(-0.3, 0.3)
        if k % 2:  # hangs
            top += [(x - half - 0.05, height), (x - half, height - deep),
                    (x + half, height - deep - slant), (x + half + 0.05, height)]
        else:
            bottom += [(x - half - 0.05, 0), (x - half, deep), (x + half, deep + slant),
                       (x + half + 0.05, 0)]
    top.append((width, height))
    low, high = 0.5, 1.5
    points = [(-wall, -wall), (width + wall, -wall), (width + wall, height + wall),
              (-wall, height + wall), (-wall, high), (0, high), *top, (width, 0),
              *reversed(bottom), (0, 0), (0, low), (-wall, low)]
    return collection([place((-1.5, 1.2), "start"), place((width - 0.6, 0.8), "goal"),
                       polygon([points], name="labyrinth")])


def city():
    """Blocks of houses with streets between them; some houses have courts, some blocks are parks."""
    random = Random(5090)
    features = [place((-6, 31), "start"), place((318, 272), "goal"),
                polygon([rectangle(-20, -20, 332, 324)], role="bounds")]
    for column in range(12):
        for row in range(12):
            left = 26 * column + random.whole(0, 2)
            bottom = 25 * row + random.whole(0, 2)
            wide, deep = random.whole(15, 18), random.whole(14, 17)
            kind = random.whole(0, 9)
            name = f"block {column + 1}.{row + 1}"
            if kind == 0:  # a park
                continue
            if kind <= 3:  # in the shape of an L
                x, y = left + wide * 0.4, bottom + deep * 0.4
                features.append(polygon(
                    [[(left, bottom), (left + wide, bottom), (left + wide, y), (x, y),
                      (x, bottom + deep), (left, bottom + deep)]], name=name))
            elif kind <= 5:  # around a court
                court = rectangle(left + 4, bottom + 4, left + wide - 4, bottom + deep - 4)
                features.append(polygon([rectangle(left, bottom, left + wide, bottom + deep),
                                         court[::-1]], name=name))
            elif kind == 6:  # two houses that touch
                middle = left + wide / 2
                features.append(polygon([rectangle(left, bottom, middle, bottom + deep)],
                                        name=name + " west"))
                features.append(polygon([rectangle(middle, bottom, left + wide, bottom + deep - 3)],
                                        name=name + " east"))
            else:
                features.append(polygon([rectangle(left, bottom, left + wide, bottom + deep)],
                                        name=name))
    return collection(features)


def stars():
    """A thousand stars, 7424 vertices, many of which overlap."""
    random = Random(1000000007)
    features = [place((-2, -2), "start"), place((102, 102), "goal")]
    for _ in range(1000):
        middle = (random.between(0, 100), random.between(0, 100))
        corners = random.whole(5, 10)
        features.append(polygon([star(random, middle, random.between(0.4, 1.7), corners)]))
    return collection(features)


# ---- swarms -------------------------------------------------------------------------------------


def vehicle(name, start, start_angle, end, end_angle, more=""):
    return (f'    {{"id": "{name}", "start": {{"position": {point(start)}, "angle": '
            f'{text(start_angle)}}},\n     "end": {{"position": {point(end)}, "angle": '
            f'{text(end_angle)}}}{more}}}')


def swarm(members, vehicles):
    head = "".join(f'  "{key}": {value},\n' for key, value in members.items())
    return "{\n" + head + '  "vehicles": [\n' + ",\n".join(vehicles) + "\n  ]\n}\n"


def crossing_pair():
    """Two paths of one length S that cross, yet the vehicles keep 0.025 S, as in Figures 1 and 2:
    the offsets of the paths at 0.025 S meet all the same."""
    return swarm({"length": "1.2", "clearance": "0.03"},
                 [vehicle("blue", (0, 0), 1.1, (1, 0.1), 0.9),
                  vehicle("red", (0.1, 0.3), -0.9, (1.05, -0.15), -1.0)])


def six():
    """Six vehicles between equidistant points of two circles, S 12.5 % above their distance, as in
    Figures 3 and 4: all keep 1 % of S."""
    starts = [0.9, -0.6, 0.5, -0.5, 0.7, -0.8]
    ends = [-0.7, 0.8, 0.5, -0.4, -0.9, 0.6]
    vehicles = []
    for k in range(6):
        angle = math.pi * k / 3
        p = (0.2 * math.cos(angle), 0.2 * math.sin(angle))
        vehicles.append(vehicle("abcdef"[k], p, starts[k], (p[0] + 1, p[1]), ends[k],
                                ', "most_curvature": 12'))
    return swarm({"excess": "0.125", "clearance": "0.01125"}, vehicles)


def twenty():
    """Twenty vehicles that leave a circle for the points opposite, three levels of altitude; what
    keeps them apart is left to deconfliction."""
    random = Random(2020)
    vehicles = []
    for k in range(20):
        angle = 2 * math.pi * k / 20
        p = (10 * math.cos(angle), 10 * math.sin(angle))
        inward = math.atan2(-p[1], -p[0])
        turn = (1 if random.whole(0, 1) else -1) * random.between(0.65, 1)
        more = (f', "altitude": {2 * (k % 3) + 10}, "radius": 0.15, "most_curvature": 1')
        vehicles.append(vehicle(f"v{k + 1:02d}", p, inward + turn, (-p[0], -p[1]),
                                inward - turn + random.between(-0.1, 0.1), more))
    return swarm({"excess": "0.125", "clearance": "0.2",
                  "deconflict": '{"longest_delay": 4, "delays": 8}'}, vehicles)


def mixed():
    """Two that cross in given ways, and two for which paths are made around them."""
    given = [
        '    {"id": "ferry", "file": "ferry.json", "speed": 1, "radius": 0.02}',
        '    {"id": "patrol", "file": "patrol.json", "speed": 1.25, "departure": 0.1, '
        '"radius": 0.02}',
    ]
    return swarm({"excess": "0.125", "clearance": "0.02",
                  "deconflict": '{"longest_delay": 0.25, "delays": 8}'},
                 given + [vehicle("a", (0, 0.5), 0.55, (1, 0.1), -1.3,
                                  ', "radius": 0.02, "most_curvature": 12'),
                          vehicle("b", (0, 0.1), -0.4, (1, 0.6), 1.3,
                                  ', "radius": 0.02, "most_curvature": 12')])


def straight(name, start, end):
    """A path document of one straight segment, at speed 1."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    # w² = (dx + i dy)/length: the bisector of the direction and the x axis.
    c = math.sqrt((1 + dx / length) / 2)
    s = dy / length / (2 * c)
    return ('{\n  "format": "hodograph-path",\n  "version": 1,\n'
            f'  "name": "{name}",\n  "algebra": "complex",\n  "preimage_degree": 0,\n'
            f'  "closed": false,\n  "knots": [0, {text(length, 12)}],\n'
            f'  "segments": [{{"start": {point(start)}, "preimage": [[{text(c, 12)}, '
            f'{text(s, 12)}]]}}]\n}}\n')


FILES = {
    "obstacle_field.geojson": obstacle_field,
    "intricate.geojson": intricate,
    "city.geojson": city,
    "stars.geojson": stars,
    "crossing_pair.json": crossing_pair,
    "six.json": six,
    "twenty.json": twenty,
    "mixed.json": mixed,
    "ferry.json": lambda: straight("ferry", (0.5, -0.4), (0.5, 1)),
    "patrol.json": lambda: straight("patrol", (1, 0.35), (-0.2, 0.25)),
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--to", type=Path, help="a folder instead of data/")
    parser.add_argument("--check", action="store_true", help="compare with data/, write nothing")
    options = parser.parse_args()
    folder = options.to or Path(__file__).resolve().parent.parent / "data"
    different = []
    for name, make in FILES.items():
        made = make().encode()
        file = folder / name
        if options.check:
            if not file.is_file() or file.read_bytes() != made:
                different.append(name)
            continue
        folder.mkdir(parents=True, exist_ok=True)
        file.write_bytes(made)
    for name in different:
        print(f"{folder / name} differs from what tools/make_samples.py makes", file=sys.stderr)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
