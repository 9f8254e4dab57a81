#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Collects the C++ programs of the documents, so that one compilation serves all.

    collect_programs.py SOURCE OUT

Every ```cpp block of README.md and docs/ is a whole program. Its headers are included once; the rest stands in a
namespace of its own in OUT/documentation_programs.cpp, whose main runs the block with the given number. What the
```text block after it says becomes OUT/documentation_<number>.txt. Prints the number and the place of each.
"""

import re
import sys
from pathlib import Path

_BLOCK = re.compile(r"^```cpp\n(.*?)^```\n(?:\s*^```text\n(.*?)^```)?", re.MULTILINE | re.DOTALL)


def write(path, text):
    if not path.exists() or path.read_text(encoding="utf-8") != text:  # compiled only when it changed
        path.write_text(text, encoding="utf-8")


def main():
    source, out = Path(sys.argv[1]), Path(sys.argv[2])
    includes, bodies, places = [], [], []
    for page in [source / "README.md", *sorted((source / "docs").rglob("*.md"))]:
        text = page.read_text(encoding="utf-8")
        for block in _BLOCK.finditer(text):
            number = len(bodies)
            lines = block[1].splitlines()
            line = text.count("\n", 0, block.start()) + 2
            place = f"{page.relative_to(source)}:{line}"
            if not re.search(r"^int main\(\) \{", block[1], re.MULTILINE):
                sys.exit(f"{place}: a block of C++ is a whole program")
            includes += [one for one in lines if one.startswith("#include") and one not in includes]
            body = [one if not one.startswith("#include") else "" for one in lines]
            end = len(body) - 1 - body[::-1].index("}")  # main ends the program
            body[end] = "return 0; }"
            body = [re.sub(r"^int main\(\)", "int run()", one) for one in body]
            bodies.append(f'namespace program_{number} {{\n#line {line} "{page}"\n' + "\n".join(body)
                          + f"\n}}  // namespace program_{number}\n")
            places.append(place)
            write(out / f"documentation_{number}.txt", block[2] or "")
    cases = "".join(f"    case {i}:\n      return program_{i}::run();\n" for i in range(len(bodies)))
    write(out / "documentation_programs.cpp",
          "#include <cstdlib>\n" + "\n".join(includes) + "\n" + "\n".join(bodies)
          + '#line 1 "documentation_programs.cpp"\nint main(int, char** arguments) {\n'
          f"  switch (std::atoi(arguments[1])) {{\n{cases}    default:\n      return 2;\n  }}\n}}\n")
    print(";".join(f"{number}={place}" for number, place in enumerate(places)), end="")


if __name__ == "__main__":
    main()
