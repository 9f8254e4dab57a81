#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every convention is fixed by a test: docs/conventions.md and its tests name the same set.

Each item of docs/conventions.md ends with the test that fixes it, as `Conventions.Name`; each
TEST(Conventions, Name) of tests/conformance/conventions_test.cpp stands in that page.
"""

import re
import tempfile
from pathlib import Path

from check_support import blank, main, write_tree

_PAGE = "docs/conventions.md"
_TESTS = "tests/conformance/conventions_test.cpp"


def find_problems(root):
    page = (Path(root) / _PAGE).read_text(encoding="utf-8")
    tests = blank((Path(root) / _TESTS).read_text(encoding="utf-8"))
    defined = set(re.findall(r"\bTEST\(Conventions, (\w+)\)", tests))
    named = set(re.findall(r"`Conventions\.(\w+)`", page))
    problems = [f"{_PAGE} names Conventions.{n}, which {_TESTS} does not define"
                for n in sorted(named - defined)]
    problems += [f"{_TESTS} defines Conventions.{n}, which {_PAGE} does not name"
                 for n in sorted(defined - named)]
    for item in re.split(r"^(?=- )", page, flags=re.MULTILINE)[1:]:
        item = re.split(r"\n\s*\n", item)[0]
        if "`Conventions." not in item:
            problems.append(f"{_PAGE}: no test fixes '{' '.join(item.split())[2:60]}...'")
    return problems


def self_test():
    with tempfile.TemporaryDirectory() as root:
        write_tree(root, {
            _PAGE: "# Page\n\n- One sign. `Conventions.One`\n- Another\n  sign. `Conventions.Two`\n",
            _TESTS: "TEST(Conventions, One) {}\nTEST(Conventions, Two) {}\n",
        })
        assert find_problems(root) == [], find_problems(root)
        write_tree(root, {
            _PAGE: "- One sign. `Conventions.One`\n- A sign without a test.\n",
            _TESTS: "// TEST(Conventions, One)\nTEST(Conventions, Two) {}\n",
        })
        assert len(find_problems(root)) == 3, find_problems(root)


if __name__ == "__main__":
    main("conventions", find_problems, self_test)
