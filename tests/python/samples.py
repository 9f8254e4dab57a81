# SPDX-License-Identifier: MIT
"""One value or more of every public class of hodograph, for tests that go over all of them."""

from __future__ import annotations

import functools
import inspect

import numpy as np

import hodograph


def classes():
    """Every public class by its name in the package, those inside classes included."""
    found = {}
    for name in hodograph.__all__:
        value = getattr(hodograph, name)
        if not inspect.isclass(value):
            continue
        found[name] = value
        for inner, nested in vars(value).items():
            if inspect.isclass(nested) and not inner.startswith("_"):
                found[f"{name}.{inner}"] = nested
    return found


def is_enum(kind):
    return hasattr(kind, "__members__")


def planar():
    return hodograph.rounded_polyline([[0, 0], [40, 0], [40, 30]], most_curvature=0.2)


def spatial():
    knots = np.linspace(0.0, 4.5, 7)
    points = np.stack([[np.cos(knots + k * np.pi / 2), np.sin(knots + k * np.pi / 2),
                        [knots, 0 * knots + 1, 0 * knots, 0 * knots, 0 * knots][k]]
                       for k in range(5)])
    return hodograph.hermite_path(knots, points.transpose(2, 0, 1))


def straight(begin, end):
    step = np.subtract(end, begin, dtype=float)
    length = np.hypot(*step)
    root = np.sqrt(complex(*step) / length)
    return hodograph.Path([0.0, length], [begin], [[[root.real, root.imag]]])


def of_core():
    h = hodograph
    path, space = planar(), spatial()
    loop = h.closed_loop(0.7)
    yield path, space, loop
    yield h.Enclosure(1.0, 2.0), h.evaluate(path, [1.0, 2.0]), h.evaluate(space, 1.0)
    yield h.HodographError("a sentence.", "not_finite", 3, "x", 1.0, 2.0)
    yield h.speed_extremes(path), h.self_distance(loop, 0.2), h.largest_tube_radius(space)
    yield h.curvature_parts(path), h.continuity(path), h.frame_continuity(space)
    yield h.jumps_at_knot(path, 1), h.holonomy(loop), h.frenet(space, 0.3), h.frenet(space, [.1, .2])
    yield h.recognised_helix(space), h.rotation_index_enclosures(path)
    yield h.curvature_stationary_points(path), h.inflections(swerve())
    yield h.intersections(straight([0, 0], [2, 2]), straight([0, 2], [2, 0]))
    yield h.line_intersections(path, [1.0, -1.0], [0.5, 1.0])
    yield h.stationary_points(path, [20.0, 3.0]), h.nearest_point(path, [20.0, 3.0])
    roll = h.rotation_minimising_roll(space)
    yield (roll, h.FrameRoll.none(space), h.FrameRoll.linear(space, 0.5, -1.0),
           h.frenet_roll(space), h.least_twist_roll(space, 0.1, end=0.3), h.closing_roll(loop),
           h.rotation_minimising_roll_within(space, 1e-6))
    yield h.frenet_roll(lifted_swerve()), h.RolledFrames(space, roll)
    yield h.rolled_state(space, roll, 0.3), h.rolled_state(space, roll, [0.1, 0.3])
    turned = h.closed_loop(0.7, 0.4)
    yield (h.periodic_roll(turned, 0.5), h.smooth_periodic_gammas(turned),
           h.least_twist_gamma(turned))
    yield h.frame_twist(space, h.FrameRoll.linear(space, 0.0, 2.0)), h.frame_twist(
        loop, h.FrameRoll.none(loop))
    yield h.erf_twist_in_closed_form(loop)
    yield h.rational_offset(path, 0.1), h.offset_cusps(path, 8.0), h.cusp_free_offsets(path)
    yield from surfaces(path, space)
    yield from constructions()
    yield from plans()
    yield from files()


def swerve():
    """A planar path that turns to the left, then to the right."""
    return hodograph.planar_spline([[0, 0], [1, 1], [2, 0], [3, 1]])


def lifted_swerve():
    return hodograph.lifted(swerve(), 0.0, 0.5)


def surfaces(path, space):
    h = hodograph
    square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
    profiles = (h.Profile.circle(0.1), h.Profile.ellipse(0.1, 0.2), h.Profile.polygon(square),
                h.Profile.polyline([[0, 0], [0.2, 0]]), h.Profile.of(straight([0, 0], [1, 0])),
                h.Profile.in_space(space))
    yield profiles
    motions = (h.Motion.along(space), h.Motion.along(space, h.frenet_roll(space)),
               h.Motion.polynomial([[0, 0, 0], [1, 0, 0]], [[1, 0, 0, 0], [1, 0.1, 0, 0]]))
    yield motions, motions[0].at(0, 0.5)
    sweep = h.Sweep(motions[0], profiles[0])
    yield sweep, h.point_of(sweep, 0, [0.1, 0.5], 0, 0.5), h.rational_patches(sweep)[0]
    yield h.offset_track(motions[0], [0, 0.1, 0]), h.fold_of(sweep), h.contact_of(sweep)
    mesh = h.mesh_of(sweep, tolerance=0.01)
    yield mesh, mesh.mesh, h.facts_of(mesh.mesh)
    yield h.TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])


def constructions():
    h = hodograph
    yield h.climb_curve([0, 0, 0], [1, 0], [10, 5, 3], [0, 1], 0.2)
    yield h.climb_solutions([0, 0, 0], [1, 0], [10, 5, 3], [0, 1], 0.2)
    yield h.climb_path([0, 0, 0], [1, 0], [100, 50, 40], [0, 1], 0.2, 2.0)
    way = [h.ClimbWaypoint([0, 0, 0], heading=[1, 0]), h.ClimbWaypoint([60, 10, 4]),
           h.ClimbWaypoint([120, 0, 8])]
    yield way, h.climb_route(way, climb_angle=0.3, descent_angle=0.3, turn_radius=2.0)
    yield h.LoopShape(0.5, 0.25), h.closed_loop_juncture(0.7), h.loop_facts(h.closed_loop(0.7))
    yield h.choose_loop(h.LoopPurpose.near_point, point=[0.1, 0.2, 0.1], length=1.0, xi=0.5)
    yield h.planar_hermite([0, 0], [1, 0], [2, 1], [0, 1])
    yield h.planar_hermite_solutions([0, 0], [1, 0], [2, 1], [0, 1])
    yield h.prescribed_length_curve([0, 0], [1, 0], [2, 1], [0, 1], 3.0)
    yield h.corner_shape([0, 0], [1, 0], [1, 1])
    yield h.corner_of_leg([0, 0], [1, 0], [1, 1], 0.3)
    yield h.turn_limited_path([0, 0], [1, 0], [10, 5], [0, 1], 15.0, 1.0)
    yield h.least_peak_curvature_of_length([0, 0], [1, 0], [2, 1], [0, 1], 4.0)
    yield h.planar_spline_with_report([[0, 0], [1, 1], [2, 0], [3, 1]])
    t = np.linspace(0.0, 1.0, 12)
    points = np.stack([t, t * t, t ** 3], axis=1)
    yield h.InterpolatingSpline(t, points), h.fit(points, 1e-3, parameters=t)
    spline = h.InterpolatingSpline(t, points)
    yield h.spline_error(spline, h.fit(points, 1e-3, parameters=t).path)
    yield h.helical_decomposition(h.lifted(straight([0, 0], [2, 0]), 0.0, 0.5), 0, [0, 0, 1])


def plans():
    h = hodograph
    square = [[4.0, -1.0], [6.0, -1.0], [6.0, 2.0], [4.0, 2.0]]
    world = h.World([h.Polygon(square, name="a")], bounds=[[-9, -9], [20, -9], [20, 9], [-9, 9]])
    yield world, h.World([square + square[:1]]).repairs, world.box, h.WorldVertex(0, 0, 1)
    yield h.World([[[0, 0], [4, 0], [4, 4], [2, 0], [0, 4]]]).contacts
    grown = h.MitredWorld(world, 0.5)
    polyline = h.shortest_polyline(grown, [0, 0], [10, 0])
    yield grown.locate([0, 0])
    yield grown, polyline, h.CornerOffset(h.WorldVertex(0), 0.5), h.ObstacleOffset(0, 0.5)
    yield (h.ForbiddenCorner(h.WorldVertex(0), h.TurnSide.left),
           h.ForbiddenLeg(h.WorldVertex(0), None), h.CornerRoom(0.1, 0.5))
    index = h.ClearanceIndex(world)
    planner = h.Planner(world, turn_radius=0.5, clearance=0.2)
    plan = planner.plan([0, 0], [10, 0])
    yield index, planner, plan, index.clearance(plan.path, 3.0)
    walls = h.World([[[0, -8], [0.5, -8], [0.5, 1], [0, 1]], [[1.5, -1], [2, -1], [2, 8], [1.5, 8]]])
    yield h.Planner(walls, turn_radius=2.0, clearance=0.1).plan([-4, 0], [6, 0]).given_up
    yield h.tangent_plan(polyline, h.TangentRule.t1, index, 3.0)
    yield h.VehicleLimits(turn_radius=1.0)
    law = h.TimingLaw.constant_speed(10.0, 2.0)
    a = h.TimedMotion(straight([0, 0], [10, 0]), law)
    b = h.TimedMotion(straight([5, -5], [5, 5]), law)
    yield law, a, h.least_separation(a, b), h.common_window(a, b)
    yield h.stepped_separation(a, b, 0.1), h.close_passages(a, b, 1.0, 0.01)
    flyers = [h.Vehicle("a", a, 0.5), h.Vehicle("b", b, 0.5)]
    yield flyers, h.close_pairs(flyers), h.conflicts(flyers), h.separation_matrix(flyers)
    yield h.separation_matrix(flyers)[0, 1]
    arriving = [h.ArrivingVehicle("a", [0, 0], [1, 0], [10, 0], [1, 0]),
                h.ArrivingVehicle("b", [0, 5], [1, 0], [10, 5], [1, 0], radius=0.25)]
    yield arriving, h.arriving_path(arriving[0], 12.0), h.arrival_at(arriving, 12.0)
    yield h.least_separated_arrival(arriving), h.deconflict_by_delays(flyers, 10.0, 20)
    yield h.deconflict_arrival(arriving, 12.0, 5.0, 10)


def files():
    h = hodograph
    path, space = planar(), spatial()
    one = h.Enclosure(1.0, 2.0)
    promises = h.Promises(
        continuity=h.ContinuityOrders(position=2), error=h.ErrorPromise(one, True, "x"),
        arc_length=one, end=[1, 2, 3],
        clearance=h.ClearancePromise(world="w", reach=3.0,
                                     obstacles=[h.ObstacleDistance(0, one)], bounds=one),
        helix=h.HelixPromise(sines=[h.HelixSine(0, one)]))
    yield h.PathDocument(space, name="n", roll=h.LinearRoll(0.0, 1.0, 2.0),
                         provenance=h.Provenance(program="p"), promises=promises)
    world = h.World([[[0, 0], [1, 0], [0, 1]]])
    yield h.WorldDocument(world, start=[3, 3]), h.GeoJsonPath([[0, 0], [1, 1]], name="g")
    table = h.Table([[0.0, 1.0, 2.0], [1.0, 3.0, 4.0]], ["t", "x", "y"])
    yield table, h.curve_samples(table)
    place = h.GeodeticPoint(46.0, 7.0, 500.0)
    yield place, h.LocalTangentPlane(place), h.mission([[0, 0, 10], [100, 0, 10]], place, speeds=5.0)
    series = h.Series([0, 1], [2, 3], label="s")
    plot = h.Plot([series], title="t", arrows=[h.Arrows([[0, 0]], [[1, 1]])],
                  marks=[h.PlotMark([0, 0], "m")], levels=[h.PlotLevel(1.0)], x_marks=[0.5])
    yield plot, h.FramedPolyline([[0, 0], [1, 1]], frame_origins=[[0, 0]],
                                 frames=[np.eye(2)])
    yield h.DxfCurves([piece.curve for piece in h.rational_offset(path, 0.1)])


def of_orbit():
    h = hodograph
    if "PeriodicOrbit" not in h.__all__:
        return
    orbit = h.lunar_gateway_nrho()
    yield h.earth_moon_system, orbit, h.OrbitCurve(orbit)
    yield h.propagate(orbit.system, orbit.initial, 0.1)
    yield h.propagate_variations(orbit.system, orbit.initial, 0.1)


def of_rational():
    h = hodograph
    if "solve" not in h.__all__:
        return
    a = h.QuaternionPolynomial("1 + t i + t^2 k")
    space = h.solve(a, "(t^2 + 1)^3", 6)
    yield a, space, h.existence(a, "(t^2 + 1)^3"), h.reduction(a)
    yield h.existence(a, "(t^2 + 1)^3").dimension(6)
    yield h.RationalPolynomial("t^2 - 2"), h.real_roots("t^2 - 2")
    yield h.square_free_factors("t^2 (t - 1)"), h.VectorPolynomial("(t, 1, t^2)")
    f = h.RationalFunction("1/(t^2 - 1)")
    yield f, h.integral("1/t^2"), h.partial_fractions(f)
    yield h.VectorFunction(h.VectorPolynomial("(t, 1, t^2)"))


    chord = [4, 2, 1]
    yield h.rational_direction([3, 4, 0]), h.chosen_preimage(chord, [1, 0, 0], [0, 1, 0])
    curves = h.HermiteCurves(space, [0, 0, 0], [1, 1, 1])
    yield curves, h.cusp_free_curve(curves), h.cone_test("(1, t, t^2)", chord)
    curve = h.RationalPhCurve.of_solution(space.preimage, space.alpha, space.basis[0])
    yield curve, curve.decomposition(), curve.motion()
    yield h.RationalPhCurve("t^2 - (i + j)*t + k",
                            "(t^6 + 3t^4 + 3t^2 + 1, 12t^4 - 12t^2, 3t^5 + 3t)/t^3").decomposition()
    chosen = h.chosen_preimage([3, 1, 1], [1, 0, 0], [0, 1, 0])
    yield h.smallest_cusp_free(chosen.preimage, [0, 0, 0], [3, 1, 1], 1, 9)


def of_control():
    h = hodograph
    if "follow" not in h.__all__:
        return
    path = planar()
    reference = h.ReferencePath(path)
    yield reference, reference.at([1.0, 2.0]), h.offset_limits(path)
    start = h.FollowStart(0.0, speed=1.0)
    yield h.generate_code(path)
    yield start, h.follow(path, start, speed=3.0, acceleration=2.0, offset=0.5, intervals=20)
    horizon = h.RecedingHorizon(path, speed=3.0, acceleration=2.0, offset=0.5, time_limit_s=5.0)
    yield horizon, horizon.plan(start), h.ascent_starts()[0], h.AscentReference.gateway()
    seen = []
    ascent = h.tracking_ascent(h.AscentReference.gateway(), h.ascent_starts()[0], guesses=1,
                               progress=lambda guess, at: seen.append(at))
    yield ascent, seen[0]
    yield h.powered_ascent(h.AscentReference.gateway(), h.ascent_start("+x"), intervals=20,
                           guesses=1)


def of_cad():
    h = hodograph
    if "step_of" not in h.__all__:
        return
    sweep = h.Sweep(h.Motion.along(lifted_swerve()), h.Profile.circle(0.1))
    yield sweep, h.step_of(sweep)


ROOTS = (of_core, of_orbit, of_rational, of_control, of_cad)
