#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""No bare tolerances: a small number has a name and a reason.

In include/, src/, cli/, tests/ and bench/ a literal with a negative exponent and at most two
significant digits (1e-9, 2.5e-12, 1.0e-6L, also 0x1p-40) is refused unless
  1. its statement defines a named constant (`constexpr ... name = ...`, `const double name = ...`)
     and has a comment: on one of its lines or on the line directly above it; or
  2. its line has a comment `not a tolerance: <why>`, for input that merely is small.
A tolerance argument of EXPECT_NEAR or ASSERT_NEAR is never a plain number of any form.
Literals in comments and strings do not count.
"""

import re
import tempfile
from pathlib import Path

from check_support import blank, line_of, main, sources, write_tree

FOLDERS = ("include", "src", "cli", "tests", "bench")

_DECIMAL = re.compile(r"(?<![\w.])((?:\d[\d']*)?\.?\d[\d']*\.?)[eE]-\d+[fFlLqQ]?(?![\w.])")
_HEXADECIMAL = re.compile(r"(?<![\w.])0[xX]([0-9a-fA-F']*\.?[0-9a-fA-F']*)[pP]-\d+[fFlL]?(?![\w.])")
_CONSTANT = re.compile(r"[^()=]*\b(?:constexpr|const)\b[^()=]*\b[A-Za-z_]\w*\s*(?:\[[^\]]*\]\s*)?[={]")
_NUMBER = re.compile(r"^[-+]?(?:\d[\d']*\.?[\d']*|\.\d+)(?:[eE][-+]?\d+)?[fFlLqQ]?$")
_EXCUSE = re.compile(r"//.*\bnot a tolerance: \S")


def find_problems(root):
    problems = []
    for path in sources(root, FOLDERS):
        text = path.read_text(encoding="utf-8")
        name = path.relative_to(root)
        for position, problem in sorted(set(_problems_of(text))):
            problems.append(f"{name}:{line_of(text, position)}: {problem}")
    return problems


def _problems_of(text):
    code = blank(text)
    lines = text.split("\n")
    for pattern in (_DECIMAL, _HEXADECIMAL):
        for match in pattern.finditer(code):
            digits = re.sub(r"[.']", "", match.group(1)).strip("0")
            if len(digits) > 2:
                continue  # data, not a tolerance
            line = line_of(code, match.start())
            if _EXCUSE.search(lines[line - 1]) or _is_named(code, lines, match.start(), line):
                continue
            yield match.start(), (
                f"bare {match.group(0)}: name it as a constant with a comment that derives it, "
                "or take it from foundation/accuracy.hpp")
    for match in re.finditer(r"\b(?:EXPECT|ASSERT)_NEAR\s*\(", code):
        arguments = _arguments(code, match.end())
        if len(arguments) == 3 and _NUMBER.match(arguments[2].strip()):
            yield match.start(), f"bare tolerance {arguments[2].strip()} in {match.group(0)[:-1]}"


def _is_named(code, lines, position, line):
    """Whether the statement around a position defines a commented constant."""
    start = position
    while start > 0:
        previous = code[start - 1]
        if previous in ";}" or (previous == "{" and not _opens_initializer(code, start - 1)):
            break
        start -= 1
    statement = re.sub(r"^\s*#.*$", "", code[start:position], flags=re.MULTILINE).lstrip()
    if not _CONSTANT.match(statement):
        return False
    first = line_of(code, position - len(statement))
    if any("//" in lines[i - 1] for i in range(first, line + 1)):
        return True
    return first >= 2 and lines[first - 2].lstrip().startswith("//")


def _opens_initializer(code, brace):
    """Whether a '{' opens the initializer of a constant rather than a block."""
    before = code[:brace].rstrip()
    if before.endswith(("=", ",", "{", "(")):
        return True
    statement = re.split(r"[;{}]", before)[-1]
    statement = re.sub(r"\btemplate\s*<[^>]*>", "", statement)
    return bool(re.search(r"\b(?:constexpr|const)\b[^()]*\b\w+$", statement))


def _arguments(code, start):
    """The top-level arguments of a call whose '(' ends at start."""
    depth, begin, found = 0, start, []
    for i in range(start, len(code)):
        c = code[i]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return found + [code[begin:i]]
            depth -= 1
        elif c == "," and depth == 0:
            found.append(code[begin:i])
            begin = i + 1
    return found


def self_test():
    good = """// a comment about 1e-9
const char* text = "1e-9";
constexpr double mass = 1.2505e-7;
// Two roundings of a number of size 1.
constexpr double two_roundings = 2e-16;
inline constexpr std::array<double, 2> steps = {1e-3,  // coarse
                                                1e-6};
template <class S>
constexpr double scaled{1e-12};  // derived in the paper
path.scale(1e-150);  // not a tolerance: the smallest scale promised
EXPECT_NEAR(a, b, bound(a, 1));
const double big = 1e9;
"""
    assert list(_problems_of(good)) == [], list(_problems_of(good))
    bad = [
        "if (x < 1e-9) return;",
        "constexpr double unexplained = 1e-9;",
        "// comment\n\nconstexpr double far_from_comment = 1e-9;",
        "constexpr double f() { return 1e-12; }  // a function is no name",
        "void f() {  // reason\n  const bool near = false;\n  g(2.50e-6L);\n}",
        "double tolerance = 0x1p-40;  // not constant",
        "EXPECT_NEAR(f(a, b), 1.0, 0.001);",
        "ASSERT_NEAR(a,\n            b, 1e-3);",
    ]
    for text in bad:
        assert list(_problems_of(text)), text
    with tempfile.TemporaryDirectory() as root:
        write_tree(root, {"src/path/a.cpp": "int a;\nbool b = x < 1e-9;\n"})
        assert find_problems(Path(root))[0].startswith("src/path/a.cpp:2: bare 1e-9"), "place"


if __name__ == "__main__":
    main("tolerances", find_problems, self_test)
