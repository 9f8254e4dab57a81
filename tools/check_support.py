# SPDX-License-Identifier: MIT
"""What the checks of tools/check_*.py share: finding files, blanking comments, reporting."""

import re
import sys
from pathlib import Path

SOURCE_SUFFIXES = (".hpp", ".cpp")

# A folder is a module; a module includes only modules above it in this list.
MODULES = (
    "foundation", "algebra", "bernstein", "curve", "path", "frame", "construction", "certify",
    "rational", "surface", "planning", "orbit", "control", "io", "cad", "interop",
)
# The modules that depend on the standard library alone.
CORE_MODULES = MODULES[: MODULES.index("construction") + 1]

# Where the compiler does not look by itself: headers of others that public headers include.
LIBRARY_FLAGS = ("-isystem", "/usr/include/eigen3")

_COMMENT_OR_STRING = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^()\\\s]{0,16})\(.*?\)\1"'
    r'|"(?:\\.|[^"\\\n])*"|(?<![0-9A-Fa-f])\'(?:\\.|[^\'\\\n])*\'',
    re.DOTALL,
)


def blank(text, strings=True):
    """The text with comments (and strings, unless told otherwise) replaced by spaces, so that
    positions and line numbers stay."""

    def replace(match):
        found = match.group(0)
        if not strings and not found.startswith(("//", "/*")):
            return found
        return re.sub(r"[^\n]", " ", found)

    return _COMMENT_OR_STRING.sub(replace, text)


def sources(root, folders):
    """Every C++ file below the named folders of root, sorted."""
    found = []
    for folder in folders:
        for path in (Path(root) / folder).rglob("*"):
            if path.suffix in SOURCE_SUFFIXES and path.is_file():
                found.append(path)
    return sorted(found)


def line_of(text, position):
    """The line number (from 1) of a position in a text."""
    return text.count("\n", 0, position) + 1


def write_tree(root, files):
    """Writes {relative path: text} below root, for self-tests."""
    for name, text in files.items():
        path = Path(root) / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def main(name, find_problems, self_test):
    """Runs a check on the repository, or its self-test with --self-test; exits 1 on problems."""
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        print(f"{name}: self-test passed")
        return
    if len(sys.argv) > 2:
        sys.exit(f"usage: {sys.argv[0]} [root | --self-test]")
    root = Path(sys.argv[1]) if len(sys.argv) == 2 else Path(__file__).resolve().parent.parent
    problems = find_problems(root)
    for problem in problems:
        print(problem)
    if problems:
        sys.exit(f"{name}: {len(problems)} problem{'s' if len(problems) > 1 else ''}")
    print(f"{name}: ok")
