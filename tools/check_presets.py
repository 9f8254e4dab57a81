#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Presets are the one way to build this project: what documents and scripts say agrees with
CMakePresets.json.

  1. Every `--preset NAME` (and `tools/build NAME`, `tools/run_tests NAME`) in the documents,
     the Makefile, tools/ and .ci/ names a preset that exists and is not hidden.
  2. No document tells the reader to configure the project without one (`cmake -B`, `cmake -S`,
     `cmake ..`).
"""

import json
import re
import tempfile
from pathlib import Path

from check_support import main, write_tree

_PRESET = re.compile(
    r"(?:--preset[ =]|\btools/build (?:--configure )?|\btools/run_tests )(\w[\w.-]*)")
_PLAIN = re.compile(r"\bcmake (?:-[SBG]\b|\.)")


def find_problems(root):
    root = Path(root)
    presets = json.loads((root / "CMakePresets.json").read_text(encoding="utf-8"))
    known = {p["name"] for p in presets["configurePresets"] if not p.get("hidden")}
    documents = [*root.glob("*.md"), *(root / "docs").rglob("*.md")]
    scripts = [root / "Makefile", *(root / ".ci").glob("*"),
               *(p for p in (root / "tools").glob("*") if p.suffix in ("", ".sh"))]
    problems = []
    for path in [*documents, *scripts]:
        if not path.is_file():
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            place = f"{path.relative_to(root)}:{number}"
            for name in _PRESET.findall(line):
                if name not in known:
                    problems.append(f"{place}: there is no preset '{name}'")
            if path in documents and _PLAIN.search(line):
                problems.append(f"{place}: configures without a preset")
    return problems


def self_test():
    with tempfile.TemporaryDirectory() as root:
        files = {
            "CMakePresets.json": '{"configurePresets": [{"name": "common", "hidden": true}, '
                                 '{"name": "release"}]}',
            "README.md": "cmake --preset release\ncmake --build --preset release\n",
            "Makefile": "run:\n\ttools/build release\n",
        }
        write_tree(root, files)
        assert find_problems(root) == [], find_problems(root)
        write_tree(root, {"README.md": "cmake --preset common\ncmake -B build\n",
                          "Makefile": "run:\n\ttools/build relaese\n"})
        assert len(find_problems(root)) == 3, find_problems(root)


if __name__ == "__main__":
    main("presets", find_problems, self_test)
