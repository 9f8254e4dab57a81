#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public type and free function of the C++ folders below is bound in Python under its name, or
stands in python/left_out.txt with the reason; and what stands there is neither bound nor unknown.

    tools/check_python_names.py [--self-test]

A name is bound where a string of python/src is just it, or a class or function of python/hodograph
has it. The public names are those that tools/cpp_api.py finds in the headers.
"""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import cpp_api  # noqa: E402

_ROOT = Path(__file__).resolve().parent.parent
_FOLDERS = ("foundation", "curve", "path", "frame", "construction", "certify", "surface")
_LEFT_OUT = _ROOT / "python" / "left_out.txt"

_HEADER = re.compile(r"\[(\w+/[\w.]+)\]")
_MEMBER = re.compile(r"[A-Z]\w*(::\w+)*: ")
_TYPE = re.compile(r"(?:^|> )(?:class|struct|enum class|enum|concept|using) (\w+)")
_FUNCTION = re.compile(r"(?:^|[\s*&])(\w+)\(")
_KEYWORDS = {"requires", "decltype", "noexcept", "explicit", "max", "min"}


def public_names(listing):
    """{header: names of its types and free functions} of a list as tools/cpp_api.py writes it."""
    names, header = {}, None
    for line in listing.splitlines():
        found = _HEADER.match(line)
        if found:
            header = found[1] if found[1].split("/")[0] in _FOLDERS else None
        elif header and line and not line.startswith("#") and not _MEMBER.match(line):
            kind = _TYPE.search(line)
            if kind:
                names.setdefault(header, set()).add(kind[1])
                continue
            called = [name for name in _FUNCTION.findall(line) if name not in _KEYWORDS]
            if called and not called[0].startswith("operator") and "operator" not in line:
                names.setdefault(header, set()).add(called[0])
    return names


def bound_names(sources, modules):
    """What the extension modules and the package define."""
    texts = set(re.findall(r'"([A-Za-z_]\w*)"', sources))
    return texts | set(re.findall(r"^(?:class|def) (\w+)", modules, re.MULTILINE))


def left_out(text):
    """[(line number, header, names)] of the list."""
    entries = []
    for number, line in enumerate(text.splitlines(), 1):
        line, _, why = line.partition("#")
        if line.strip():
            header, *names = line.split()
            entries.append((number, header, names, bool(why.strip())))
    return entries


def findings(names, bound, entries):
    """What is wrong, a line each."""
    wrong, excused = [], {}
    for number, header, listed, has_reason in entries:
        place = f"python/left_out.txt:{number}: {header}"
        if not has_reason:
            wrong.append(f"{place}: a reason follows after #")
        if header not in names:
            wrong.append(f"{place}: has no public names")
            continue
        if listed == ["*"]:
            excused.setdefault(header, set()).update(names[header])
            continue
        for name in listed:
            if name not in names[header]:
                wrong.append(f"{place}: {name} is no public name of it")
            elif name in bound:
                wrong.append(f"{place}: {name} is bound; take it out of the list")
        excused.setdefault(header, set()).update(listed)
    for header in sorted(names):
        for name in sorted(names[header] - bound - excused.get(header, set())):
            wrong.append(f"include/hodograph/{header}: {name} is neither bound in Python nor in "
                         "python/left_out.txt")
    return wrong


def _self_test():
    listing = ("# head\n[path/a.hpp]\nstruct A\nA: double x\nA::B: int y\nenum class E { a, b }\n"
               "template <class A, std::size_t n> requires std::same_as<A, double> "
               "Result<double> f(const Path<A, n>& path)\nusing P = int\n"
               "bool operator==(const A&, const A&)\n[io/b.hpp]\nvoid g()\n")
    names = public_names(listing)
    assert names == {"path/a.hpp": {"A", "E", "f", "P"}}, names
    entries = left_out("path/a.hpp  P E  # why\npath/a.hpp f\npath/a.hpp q # why\n")
    wrong = findings(names, bound_names('m.def("f", ...)', "class A:\n"), entries)
    assert len(wrong) == 3, wrong
    assert findings(names, {"A"}, left_out("path/a.hpp * # all"))== []
    assert len(findings(names, {"A"}, [])) == 3
    print("check_python_names: self-test passed")


def main(arguments):
    if arguments == ["--self-test"]:
        _self_test()
        return 0
    sources = "\n".join(file.read_text(encoding="utf-8")
                        for file in sorted((_ROOT / "python" / "src").rglob("*.cpp")))
    modules = "\n".join(file.read_text(encoding="utf-8")
                        for file in sorted((_ROOT / "python" / "hodograph").glob("*.py")))
    wrong = findings(public_names(cpp_api.text_of(_ROOT / "include" / "hodograph")), bound_names(sources, modules),
                     left_out(_LEFT_OUT.read_text(encoding="utf-8")))
    for line in wrong:
        print(line)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
