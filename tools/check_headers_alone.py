#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public header compiles alone, twice in one file, without a warning.

The compiler is $CXX, or c++; further flags come from $CXXFLAGS. Headers that need a library which
is not installed fail: this check is for machines with every component's library.
"""

import os
import shlex
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check_support import LIBRARY_FLAGS, main, sources, write_tree

_FLAGS = ["-std=c++20", "-fsyntax-only", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic",
          "-Wshadow", "-Wconversion", "-Werror", "-x", "c++", "-"]


def find_problems(root):
    include = Path(root) / "include"
    command = [*shlex.split(os.environ.get("CXX", "c++")),
               *shlex.split(os.environ.get("CXXFLAGS", "")), "-I", str(include), *LIBRARY_FLAGS, *_FLAGS]

    def problem_of(path):
        name = path.relative_to(include)
        done = subprocess.run(command, input=f'#include "{name}"\n#include "{name}"\n',
                              capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return None
        first = [line for line in done.stderr.splitlines() if "error" in line]
        return f"include/{name} does not compile alone: {(first or [done.stderr])[0]}"

    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        return [p for p in pool.map(problem_of, sources(root, ["include"])) if p]


def self_test():
    with tempfile.TemporaryDirectory() as root:
        write_tree(root, {
            "include/hodograph/a/good.hpp": "#pragma once\n#include <vector>\nstd::vector<int> f();\n",
            "include/hodograph/a/leaning.hpp": "#pragma once\nstd::vector<int> g();\n",
            "include/hodograph/a/unguarded.hpp": "struct Twice {};\n",
        })
        problems = find_problems(root)
        assert len(problems) == 2, problems
        assert "leaning.hpp" in problems[0] and "unguarded.hpp" in problems[1], problems


if __name__ == "__main__":
    main("headers alone", find_problems, self_test)
