#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every convention is fixed by a test: docs/conventions.md and the tests name the same set.

Each item of docs/conventions.md ends with the test that fixes it, as `Conventions.Name`; each
TEST(Conventions, Name) in tests/*/*_test.cpp, and each test of the class Conventions in
tests/python/conventions_test.py, stands in that page, once.
"""

import ast
import re
import tempfile
from pathlib import Path

from check_support import blank, main, write_tree

_PAGE = "docs/conventions.md"
_PYTHON = "tests/python/conventions_test.py"


def _tests(root):
    """{name: the file that defines it}, and what is defined twice."""
    found, problems = {}, []

    def add(name, path):
        file = path.relative_to(root).as_posix()
        if name in found:
            problems.append(f"{file} defines Conventions.{name}, as {found[name]} does")
        found[name] = file

    for path in sorted((root / "tests").glob("*/*_test.cpp")):
        for name in re.findall(r"\bTEST\(Conventions, (\w+)\)", blank(path.read_text(encoding="utf-8"))):
            add(name, path)
    path = root / _PYTHON
    for node in ast.parse(path.read_text(encoding="utf-8")).body if path.exists() else []:
        if isinstance(node, ast.ClassDef) and node.name == "Conventions":
            for one in node.body:
                if isinstance(one, ast.FunctionDef) and one.name.startswith("test_"):
                    add(one.name, path)
    return found, problems


def find_problems(root):
    page = (Path(root) / _PAGE).read_text(encoding="utf-8")
    defined, problems = _tests(Path(root))
    named = re.findall(r"`Conventions\.(\w+)`", page)
    problems += [f"{_PAGE} names Conventions.{n}, which no test defines"
                 for n in sorted(set(named) - set(defined))]
    problems += [f"{defined[n]} defines Conventions.{n}, which {_PAGE} does not name"
                 for n in sorted(set(defined) - set(named))]
    problems += [f"{_PAGE} names Conventions.{n} {named.count(n)} times"
                 for n in sorted(set(named)) if named.count(n) > 1]
    for item in re.split(r"^(?=- )", page, flags=re.MULTILINE)[1:]:
        item = re.split(r"\n\s*\n", item)[0]
        if "`Conventions." not in item:
            problems.append(f"{_PAGE}: no test fixes '{' '.join(item.split())[2:60]}...'")
    return problems


def self_test():
    cpp = "tests/conformance/conventions_test.cpp"
    with tempfile.TemporaryDirectory() as root:
        write_tree(root, {
            _PAGE: "# Page\n\n- One sign. `Conventions.One`\n- Another\n  sign. `Conventions.Two`\n"
                   "- A third. `Conventions.test_three`\n",
            cpp: "TEST(Conventions, One) {}\nTEST(Others, Four) {}\n",
            "tests/cli/more_test.cpp": "TEST(Conventions, Two) {}\n",
            _PYTHON: "class Conventions:\n    def test_three(self):\n        pass\n",
        })
        assert find_problems(root) == [], find_problems(root)
        write_tree(root, {
            _PAGE: "- One sign. `Conventions.One` `Conventions.Two` `Conventions.Two`\n"
                   "- A sign without a test.\n",
            cpp: "// TEST(Conventions, One)\nTEST(Conventions, Two) {}\n",
        })
        # One not defined, Two defined and named twice, test_three not named, a sign without a test.
        assert len(find_problems(root)) == 5, find_problems(root)


if __name__ == "__main__":
    main("conventions", find_problems, self_test)
