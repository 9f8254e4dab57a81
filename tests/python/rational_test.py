#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Rational PH curves, exactly: against the golden file and with Python's own fractions."""

import json
import pickle
import unittest
from fractions import Fraction
from pathlib import Path

import numpy as np

import hodograph
from hodograph import (HodographError, QuaternionPolynomial, RationalFunction, RationalPhCurve,
                       RationalPolynomial, VectorFunction, VectorPolynomial)

GOLDEN = json.loads((Path(__file__).resolve().parents[1] / "golden" / "rational.json").read_text())
EPSILON = np.finfo(float).eps


def evaluated(coefficients, t):
    """A polynomial by its coefficients, the constant one first, at a Fraction."""
    return sum((Fraction(c) * t**k for k, c in enumerate(coefficients)), Fraction(0))


def vector(polynomials):
    return VectorPolynomial(polynomials)


class Polynomials(unittest.TestCase):
    def test_texts_lists_and_numbers_are_the_same(self):
        p = RationalPolynomial("t^2 - t/2 + 3/4")
        self.assertEqual(p.coefficients, [Fraction(3, 4), Fraction(-1, 2), Fraction(1)])
        self.assertEqual(p, RationalPolynomial(["3/4", -0.5, 1]))
        self.assertEqual(p, RationalPolynomial([Fraction(3, 4), Fraction(-1, 2), np.int64(1)]))
        self.assertEqual(p, "t^2 - t/2 + 3/4")
        self.assertNotEqual(p, 1)
        self.assertEqual(RationalPolynomial(0.1).coefficients, [Fraction(0.1)])
        self.assertEqual(str(p), "t^2 - 1/2*t + 3/4")
        self.assertEqual(RationalPolynomial().degree, -1)

    def test_coefficients_above_the_degree_are_zero(self):
        p = RationalPolynomial("t^2 - 2")
        self.assertEqual(p.taylor_coefficient(1), RationalPolynomial("2t"))
        self.assertEqual(p.taylor_coefficient(2), 1)
        for k in (3, 2**40):  # soon, without k!
            self.assertEqual(p.taylor_coefficient(k), 0)
            self.assertEqual(VectorPolynomial([p, 1, 0]).taylor_coefficient(k),
                             VectorPolynomial([0, 0, 0]))

    def test_are_a_ring_with_division(self):
        a, b = RationalPolynomial("3t^5 - t^2 + 7/3"), RationalPolynomial("2t^2 + t - 1")
        for t in (Fraction(0), Fraction(2, 7), Fraction(-5)):
            x, y = (evaluated(p.coefficients, t) for p in (a, b))
            self.assertEqual(a.value(t), x)
            self.assertEqual((a + b).value(t), x + y)
            self.assertEqual((a - 2).value(t), x - 2)
            self.assertEqual((3 - a).value(t), 3 - x)
            self.assertEqual((a * b).value(t), x * y)
            self.assertEqual((b**3).value(t), y**3)
            self.assertEqual((a // b * b + a % b).value(t), x)
        self.assertLess((a % b).degree, b.degree)
        self.assertEqual(a.integral().derivative(), a)
        self.assertEqual(a.shifted("1/2").value("1/2"), a.value(1))
        x = np.linspace(-1.0, 1.0, 6).reshape(2, 3)
        np.testing.assert_allclose(a(x), 3 * x**5 - x**2 + 7 / 3, rtol=16 * EPSILON)
        self.assertIsInstance(a(0.5), float)

    def test_factors_and_roots(self):
        p = RationalPolynomial("5 (t - 1)^2 (t^2 - 2)")
        self.assertEqual([(str(f.factor), f.multiplicity)
                          for f in hodograph.irreducible_factors(p)],
                         [("t - 1", 2), ("t^2 - 2", 1)])
        roots = hodograph.real_roots(p)
        np.testing.assert_allclose([float(root) for root in roots], [-2**0.5, 1.0, 2**0.5],
                                   rtol=EPSILON)
        self.assertTrue(roots[1].is_rational)
        self.assertEqual(roots[2].compare("99/70"), -1)  # 99/70 is above the root of 2
        self.assertLessEqual(roots[2].halved().upper - roots[2].halved().lower,
                             (roots[2].upper - roots[2].lower) / 2)
        self.assertEqual(hodograph.count_real_roots(p, 0, 3), 2)
        self.assertTrue(hodograph.is_positive("t^2 - 2", 2, 3))
        self.assertFalse(hodograph.is_nonnegative("t^2 - 2", 1, 3))
        self.assertEqual(hodograph.gcd("t^2 - 1", "(t - 1)^2"), "t - 1")
        self.assertEqual(float(pickle.loads(pickle.dumps(roots[0]))), float(roots[0]))

    def test_pickles_and_copies(self):
        for value in (RationalPolynomial("t^3 - 1/7"), QuaternionPolynomial("t^2 - (i + j)*t + k"),
                      VectorPolynomial("(t, 3t^2, 1)"), RationalFunction("(t + 1)/(t^2 - 2)"),
                      VectorFunction("(t, 3t^2, 1)/t^3")):
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)
            self.assertEqual(eval(repr(value), globals()), value)

    def test_refusals(self):
        def refused(code, call):
            with self.assertRaises(HodographError) as caught:
                call()
            self.assertEqual(caught.exception.code, code)
            return caught.exception

        error = refused("malformed_document", lambda: RationalPolynomial("t^2 + + "))
        self.assertIn("column", str(error))
        refused("malformed_document", lambda: RationalPolynomial("i t"))
        refused("malformed_document", lambda: RationalPolynomial(["x"]))
        refused("not_finite", lambda: RationalPolynomial([np.nan]))
        refused("outside_domain", lambda: RationalPolynomial("t") // 0)
        refused("outside_domain", lambda: hodograph.real_roots(0))
        refused("outside_domain", lambda: RationalFunction("1/t").value(0))
        refused("outside_domain", lambda: RationalFunction("1/t")([1.0, 0.0]))
        refused("outside_domain", lambda: RationalFunction(1, 0))
        refused("mismatched_size", lambda: QuaternionPolynomial([1, 2, 3]))
        refused("not_increasing", lambda: hodograph.is_positive("t", 1, 0))
        refused("unsupported", lambda: RationalPolynomial("t^99999"))
        refused("unsupported", lambda: RationalPolynomial("t")**100000)
        for nonsense in (None, {}, 1j):
            with self.assertRaises(TypeError):
                RationalPolynomial(nonsense)


class Spaces(unittest.TestCase):
    def test_golden_dimensions_bases_and_existence(self):
        for case in GOLDEN["cases"][:6]:
            a, alpha = QuaternionPolynomial(case["A"]), RationalPolynomial(case["alpha"])
            answer = hodograph.existence(a, alpha)
            self.assertEqual(answer.exists, bool(case["theorem46"]["exists"]), case["name"])
            self.assertEqual(answer.freedom, case["theorem46"]["N"])
            reduced = hodograph.reduction(a)
            self.assertEqual(reduced.reduced, QuaternionPolynomial(case["A_reduced"]))
            for degree, dimension in enumerate(case["dims_by_degB"]):
                space = hodograph.solve(a, alpha, degree)
                self.assertEqual(space.dimension, dimension)
                self.assertGreaterEqual(dimension, answer.dimension(degree).value)
            for degree, expected in list(case["solutions"].items())[:2]:
                space = hodograph.solve(a, alpha, int(degree))
                self.assertEqual(space.canonical_basis(), [vector(b) for b in expected["basis"]])
                self.assertEqual(space.lambda_numerators(),
                                 [RationalPolynomial(h) for h in expected["lambda_numerators_h"]])
                again = pickle.loads(pickle.dumps(space))
                self.assertEqual(again.canonical_basis(), space.canonical_basis())

    def test_golden_curves(self):
        for case in GOLDEN["cases"][:4]:
            for given in case["given_curves"]:
                r = VectorFunction(vector(given["r_num"]), given["r_den"])
                curve = RationalPhCurve(case["A"], r)
                self.assertEqual(curve.kind.name, given["class"])
                self.assertEqual(curve.lambda_,
                                 RationalFunction(RationalPolynomial(given["lambda"]["num"]),
                                                  RationalPolynomial(given["lambda"]["den"])))
                self.assertEqual(curve.arc_length_is_rational(), bool(given["arc_length_rational"]))
                self.assertEqual(len(curve.poles()), given["real_poles"])
                self.assertEqual(curve.decomposition().constant,
                                 [Fraction(x) for x in given["decomposition"]["constant"]])
                self.assertEqual(pickle.loads(pickle.dumps(curve)), curve)
                motion = curve.motion()
                self.assertTrue(motion.is_motion_polynomial())
                self.assertTrue(hodograph.is_framing(motion))
                self.assertEqual(hodograph.trajectory(motion, [0, 0, 0]), curve.position)

    def test_the_curve_of_example_5_1(self):
        space = hodograph.solve("t^2 - (i + j)*t + k", "t^3", 6)
        b = space.combination([Fraction(-1, 2), 0, 0, 0])
        curve = RationalPhCurve.of_solution(space.preimage, space.alpha, b)
        t = np.array([0.25, 0.5, 2.0])
        expected = np.stack([t**6 + 3 * t**4 + 3 * t**2 + 1, 12 * t**4 - 12 * t**2,
                             3 * t**5 + 3 * t], axis=1) / t[:, None]**3
        np.testing.assert_allclose(curve(t), expected, rtol=16 * EPSILON)
        # At 1/2: (1/64 + 3/16 + 3/4 + 1)/(1/8).
        self.assertEqual(curve.position.value("1/2")[0], Fraction(125, 8))
        # r' . r' = sigma^2, exactly.
        along = curve.position.derivative()
        square = sum((along.value("2/3")[i]**2 for i in range(3)), Fraction(0))
        self.assertEqual(square, curve.speed.value("2/3")**2)
        with self.assertRaises(HodographError) as caught:
            curve([1.0, 0.0])
        self.assertEqual((caught.exception.code, caught.exception.index), ("outside_domain", 1))

    def test_rational_bezier_pieces_follow_the_curve(self):
        curve = RationalPhCurve("t^2 - (i + j)*t + k",
                                "(t^6 + 3t^4 + 3t^2 + 1, 12t^4 - 12t^2, 3t^5 + 3t)/t^3")
        pieces = curve.rational_bezier(0.5, 2.0)
        self.assertEqual((pieces[0].begin, pieces[-1].end), (0.5, 2.0))
        for piece in pieces:
            for u in (0.0, 0.3, 1.0):
                np.testing.assert_allclose(
                    piece.position(u), curve(piece.begin + u * (piece.end - piece.begin)),
                    rtol=256 * EPSILON, atol=256 * EPSILON)
        with self.assertRaises(HodographError):
            curve.rational_bezier(-1.0, 1.0)
        with self.assertRaises(HodographError):
            curve.path(0.5, 2.0)  # it has a pole: no polynomial

    def test_polynomial_curves_become_paths(self):
        space = hodograph.solve("t^2 - (i + j)*t + k", 1, 5)
        b = next(b for b in space.basis if hodograph.kind_of(b, 1).name == "polynomial")
        curve = RationalPhCurve.of_solution(space.preimage, 1, b)
        path = curve.path(0.0, 1.0)
        t = np.linspace(0.0, 1.0, 9)
        np.testing.assert_allclose(path.position(t), curve(t), atol=256 * EPSILON * 10)

    def test_definitions_are_read(self):
        read = hodograph.parse_definitions("A = t^2 - (i + j)*t + k; alpha = 3t(t - 1)\nr = (t, 1, t)/t")
        self.assertIsInstance(read["A"], QuaternionPolynomial)
        self.assertEqual(read["alpha"], "3t^2 - 3t")
        self.assertEqual(read["r"], VectorFunction("(t, 1, t)/t"))

    def test_refusals(self):
        for call in (lambda: hodograph.solve(0, 1, 3), lambda: hodograph.solve("t + i", 0, 3),
                     lambda: hodograph.solve("t + i", 1, 10**6),
                     lambda: hodograph.solve("t + ", 1, 3),
                     lambda: hodograph.existence([0, 0, 0, 0], 1),
                     lambda: hodograph.reduction([0, 0, 0, 0]),
                     lambda: RationalPhCurve("t + j", "(t, t^2, t^3)"),
                     lambda: hodograph.solve("t + j", 1, 3).combination([1])):
            with self.assertRaises((HodographError, TypeError)):
                call()


class Hermite(unittest.TestCase):
    def test_golden_problems(self):
        for problem in GOLDEN["hermite"][:6]:
            space = hodograph.solve(problem["A"], problem["alpha"], problem["degB"])
            begin, end = problem["interval"]
            curves = hodograph.HermiteCurves(space, problem["P0"], problem["P1"],
                                             begin_derivative=problem["v0"],
                                             end_derivative=problem["v1"], begin=begin, end=end)
            self.assertEqual(curves.solvable, bool(problem["solvable"]), problem["name"])
            self.assertEqual((curves.unknowns, curves.equations),
                             (problem["unknowns"], problem["equations"]))
            if not curves.solvable:
                with self.assertRaises(HodographError):
                    curves.curve()
                continue
            self.assertEqual(curves.freedom, problem["free"])
            curve = curves.curve()
            start, stop = curve.position.value(begin), curve.position.value(end)
            self.assertEqual([b - a for a, b in zip(start, stop)],
                             [Fraction(b) - Fraction(a)
                              for a, b in zip(problem["P0"], problem["P1"])])
            answer = hodograph.cusp_free_curve(curves)
            if answer.outcome != hodograph.CuspFreeAnswer.Outcome.undecided:
                self.assertTrue(hodograph.holds(answer, curves))

    def test_a_curve_without_cusps_is_found(self):
        chosen = hodograph.chosen_preimage([3, 1, 1], [1, 0, 0], [0, 1, 0])
        search = hodograph.smallest_cusp_free(chosen.preimage, [0, 0, 0], [3, 1, 1], 1, 9)
        self.assertIsNotNone(search.found)
        curve = search.found.answer.curve
        t = np.linspace(0.0, 1.0, 50)
        points = curve(t)
        np.testing.assert_allclose(points[-1] - points[0], [3, 1, 1], atol=1e-12)
        self.assertGreater(curve.speed(t).min(), 0.0)
        along = np.gradient(points, t, axis=0)[[0, -1]]
        np.testing.assert_allclose(along / np.linalg.norm(along, axis=1)[:, None],
                                   [[1, 0, 0], [0, 1, 0]], atol=0.1)

    def test_directions(self):
        exact = hodograph.rational_direction([2, 1, 2])
        self.assertEqual(exact.unit, [Fraction(2, 3), Fraction(1, 3), Fraction(2, 3)])
        near = hodograph.rational_direction([1, 1, 0], bits=20)
        self.assertEqual(sum(x * x for x in near.unit), 1)
        self.assertLessEqual(near.deviation, 2.0**-20)
        a = hodograph.preimage_between(exact.unit, [0, 1, 0], inner=[[1, 0, 2, "1/2"]])
        f = a.indicatrix().value(1)
        self.assertEqual((f[0], f[2]), (0, 0))
        self.assertGreater(f[1], 0)
        test = hodograph.cone_test(a.indicatrix(), [-2, -1, -2])
        self.assertEqual(test.outcome, hodograph.ConeTest.Outcome.outside)

    def test_refusals(self):
        for call in (lambda: hodograph.rational_direction([0, 0, 0]),
                     lambda: hodograph.rational_direction([1, 0]),
                     lambda: hodograph.rational_direction([1, 0, 0], bits=1000),
                     lambda: hodograph.preimage_between([1, 1, 0], [1, 0, 0]),
                     lambda: hodograph.preimage_between([1, 0, 0], [1, 0, 0], begin=1, end=1),
                     lambda: hodograph.cone_test("(t, t, t)", [1, 0, 0]),
                     lambda: hodograph.cone_test("(1, t, 1)", [1, 0, 0], 1, 0),
                     lambda: hodograph.chosen_preimage([1, 0, 0], [0, 0, 0], [1, 0, 0])):
            with self.assertRaises(HodographError):
                call()


if __name__ == "__main__":
    unittest.main()
