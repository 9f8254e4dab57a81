#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every script of the gallery runs, its figure can be drawn, and the pages hold its numbers."""

import sys
import unittest
from pathlib import Path

_FOLDER = Path(__file__).resolve().parents[2] / "docs" / "gallery"
sys.path.insert(0, str(_FOLDER))

import build  # noqa: E402

_DPI = 25


class Gallery(unittest.TestCase):
    def test_the_pages_say_what_the_scripts_print_and_every_figure_draws(self):
        made = []
        for name in build.scripts():
            with self.subTest(script=name):
                each = build.make(name)
                each.figure.set_dpi(_DPI)
                each.figure.canvas.draw()
                self.assertTrue(each.title and each.caption and each.numbers)
                page = (_FOLDER / f"{name.partition('_')[0]}.md").read_text("utf-8")
                self.assertIn(build.section(each), page)
                each.figure = None
                made.append(each)
        for name, text in build.pages(made).items():
            self.assertEqual((_FOLDER / name).read_text("utf-8"), text)

    def test_every_script_belongs_to_a_page(self):
        shared = {"build", "closed", "curve23", "exact", "gallery", "gateway", "scenes"}
        names = {path.stem for path in _FOLDER.glob("*.py")} - shared
        self.assertEqual(names, set(build.scripts()))


if __name__ == "__main__":
    unittest.main()
