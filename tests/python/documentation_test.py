#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every Python block of README.md and of docs/ runs, and prints what the page says it prints.

The blocks of a page are one conversation, in a folder of its own, where they may write files. What one prints stands after
it in a block marked ```text; a block without one prints nothing. A picture that a page shows is drawn by one of its
blocks. (The gallery has a test of its own, which makes its pages.)
"""

import contextlib
import io
import re
import tempfile
import unittest
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

_ROOT = Path(__file__).resolve().parents[2]
_BLOCK = re.compile(r"^```python\n(.*?)^```\n(?:\s*^```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)
_PICTURE = re.compile(r"\]\(pictures/([^)]+)\)")


def pages():
    """The pages with Python in them, or pictures."""
    everything = [_ROOT / "README.md", *sorted((_ROOT / "docs").rglob("*.md"))]
    return [page for page in everything if page.parent.name != "gallery"
            and re.search(r"^```python$|\]\(pictures/", page.read_text(encoding="utf-8"),
                          re.MULTILINE)]


class Documentation(unittest.TestCase):
    def test_its_examples_run_and_print_what_it_says(self):
        from matplotlib import pyplot
        self.assertGreaterEqual(len(pages()), 10)
        for page in pages():
            text, names = page.read_text(encoding="utf-8"), {}
            with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
                for block in _BLOCK.finditer(text):
                    line = text.count("\n", 0, block.start()) + 1
                    with self.subTest(f"{page.relative_to(_ROOT)}:{line}"):
                        with contextlib.redirect_stdout(io.StringIO()) as printed:
                            exec(compile("\n" * line + block[1], str(page), "exec"), names)
                        self.assertEqual(printed.getvalue(), block[2] or "")
                drawn = {path.name for path in Path(folder).glob("*.png")}
            pyplot.close("all")
            self.assertEqual(set(_PICTURE.findall(text)) - drawn, set(), page)

    def test_every_construction_has_what_a_reader_asks_for(self):
        folder = _ROOT / "docs"
        made = {*(folder / "constructions").glob("*.md"), folder / "climbing.md", folder / "loops.md",
                folder / "rational.md"} - {folder / "constructions" / "planar.md"}  # which leads to the others
        self.assertGreaterEqual(len(made), 12)
        index = (folder / "index.md").read_text(encoding="utf-8")
        for page in sorted(made):
            text = page.read_text(encoding="utf-8")
            with self.subTest(page.name):
                self.assertIn(f"({page.relative_to(folder).as_posix()})", index)
                self.assertRegex(text, _PICTURE)
                self.assertRegex(text, r"(?m)^## When to use")
                self.assertRegex(text, r"(?m)^## (Limits|What cannot be done)")
                self.assertRegex(text, r"(?m)^(## )?Source\b")


if __name__ == "__main__":
    unittest.main()
