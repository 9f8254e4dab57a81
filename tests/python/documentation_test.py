#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every Python block of docs/python.md runs, and prints what the page says it prints.

A block's expected output stands after it in a block marked ```text; without one, only that it runs
is tested.
"""

import contextlib
import io
import re
import unittest
from pathlib import Path

_PAGE = Path(__file__).resolve().parents[2] / "docs" / "python.md"
_BLOCK = re.compile(r"```python\n(.*?)```(?:\s*```text\n(.*?)```)?", re.DOTALL)


class Documentation(unittest.TestCase):
    def test_its_examples_run_and_print_what_it_says(self):
        blocks = _BLOCK.findall(_PAGE.read_text(encoding="utf-8"))
        self.assertGreaterEqual(len(blocks), 1)
        names = {}
        for code, expected in blocks:
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                exec(compile(code, str(_PAGE), "exec"), names)  # one page, one conversation
            if expected:
                self.assertEqual(printed.getvalue(), expected)


if __name__ == "__main__":
    unittest.main()
