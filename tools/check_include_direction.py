#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A module includes only itself and modules above it; the core includes the standard library alone.

For every file of include/hodograph/<module>/ and src/<module>/:
  1. `#include "hodograph/<other>/..."` only where <other> is <module> or stands above it in
     check_support.MODULES; nothing but interop includes interop;
  2. any other quoted include names a file beside it (or below), in the same module;
  3. in the core's modules, an include in angle brackets is a standard header (no '.' or '/'),
     but for the compiler's vector intrinsics (<immintrin.h>, <arm_neon.h>) in src/;
  4. a module's folder is in the list.
"""

import re
import tempfile
from pathlib import Path

from check_support import CORE_MODULES, MODULES, blank, line_of, main, sources, write_tree

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
_INTRINSICS = ("immintrin.h", "arm_neon.h")


def find_problems(root):
    problems = []
    for folder in ("include/hodograph", "src"):
        base = Path(root) / folder
        for path in sources(root, [folder]):
            module = path.relative_to(base).parts[0]
            name = path.relative_to(root)
            if module not in MODULES:
                problems.append(f"{name}: '{module}' is not in the list of modules")
                continue
            text = blank(path.read_text(encoding="utf-8"), strings=False)
            for match in _INCLUDE.finditer(text):
                problem = _problem(path, base, module, folder == "src", *match.groups())
                if problem:
                    problems.append(f"{name}:{line_of(text, match.start())}: {problem}")
    return problems


def _problem(path, base, module, in_src, quoted, angled):
    if angled is not None:
        if angled.startswith("hodograph/"):
            return f'<{angled}> should be "{angled}"'
        standard = "." not in angled and "/" not in angled
        if module in CORE_MODULES and not standard and not (in_src and angled in _INTRINSICS):
            return f"the core depends on the standard library alone, not on <{angled}>"
        return None
    if not quoted.startswith("hodograph/"):
        target = (path.parent / quoted).resolve()
        if (base / module).resolve() not in target.parents:
            return f'"{quoted}" is neither public ("hodograph/...") nor in this module'
        return None
    parts = quoted.split("/")
    other = parts[1] if len(parts) > 2 else ""
    if other not in MODULES:
        return f'"{quoted}" is in no module'
    if MODULES.index(other) > MODULES.index(module):
        return f"{module}/ must not include {other}/, which stands below it"
    return None


def self_test():
    with tempfile.TemporaryDirectory() as root:
        write_tree(root, {
            "include/hodograph/curve/good.hpp":
                '#include <vector>\n#include "hodograph/algebra/a.hpp"\n// #include "hodograph/io/x.hpp"\n',
            "include/hodograph/io/good.hpp": "#include <nlohmann/json.hpp>\n",
            "src/path/kernels/good.cpp": '#include <immintrin.h>\n#include "kernel.hpp"\n',
        })
        assert find_problems(root) == [], find_problems(root)
        write_tree(root, {
            "include/hodograph/algebra/bad.hpp":
                '#pragma once\n#include "hodograph/curve/good.hpp"\n#include <boost/rational.hpp>\n',
            "include/hodograph/extras/bad.hpp": "",
            "src/frame/bad.cpp": '#include "../path/kernels/kernel.hpp"\n#include "hodograph/all.hpp"\n',
        })
        problems = find_problems(root)
        assert len(problems) == 5, problems
        assert problems[0] == ("include/hodograph/algebra/bad.hpp:2: algebra/ must not include "
                               "curve/, which stands below it"), problems[0]


if __name__ == "__main__":
    main("include direction", find_problems, self_test)
