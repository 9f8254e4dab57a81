#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Swept surfaces as STEP."""

import re
import tempfile
import unittest
from pathlib import Path

import hodograph
from hodograph import HodographError


def tube(degree=None):
    path = hodograph.lifted(hodograph.planar_spline([[0, 0], [2, 1], [4, 0]]))
    if degree is not None:
        path = hodograph.with_preimage_degree(path, degree)
    return hodograph.Sweep(hodograph.Motion.along(path), hodograph.Profile.circle(0.1))


class Step(unittest.TestCase):
    def test_a_tube_is_a_solid(self):
        model = hodograph.step_of(tube(), name="tube", length_unit="m")
        self.assertTrue(model.solid)
        self.assertTrue(model.text.startswith("ISO-10303-21;"))
        self.assertTrue("'tube 1'" in model.text)  # OpenCASCADE counts the products
        surfaces = re.findall(r"RATIONAL_B_SPLINE_SURFACE", model.text)
        self.assertEqual(model.faces, len(surfaces) + 2)  # and two plane caps
        # Along it the sweep of a path of preimage degree n has degree 4n + 1.
        self.assertEqual(model.degree_along, 9)
        shell = hodograph.step_of(tube(), caps=False)
        self.assertFalse(shell.solid)
        self.assertEqual(shell.faces, len(surfaces))
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "tube.step"
            self.assertEqual(hodograph.save_step(tube(), file).faces, model.faces)
            self.assertTrue(file.read_text().startswith("ISO-10303-21;"))
            with self.assertRaises(HodographError) as caught:
                hodograph.save_step(tube(), Path(folder) / "no" / "tube.step")
            self.assertEqual(caught.exception.code, "not_written")

    def test_degrees_that_no_cad_program_takes_are_refused(self):
        with self.assertRaises(HodographError) as caught:
            hodograph.step_of(tube(8))
        self.assertEqual(caught.exception.code, "unsupported")
        self.assertEqual(caught.exception.bound, hodograph.largest_cad_degree)


if __name__ == "__main__":
    unittest.main()
