#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The commands of the documents do what the documents say.

    commands_test.py PROGRAM [page...]

Every `hodograph` command of docs/ is run, page by page, in a folder that holds the files of examples/ and data/.
In a ```console block what is printed is compared line by line, ... standing for any lines. Below an indented
`$ hodograph` command stand lines of what it prints, in order, with numbers to three digits. Where nothing stands below, it must succeed. (Those of README.md
are run by tests/cli; those of requests.md are examples of the shell.)
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_CONSOLE = re.compile(r"^```console\n(.*?)^```", re.MULTILINE | re.DOTALL)
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")
_AS_FAR = 1e-3  # optimal solutions differ in the last digits printed from one linear solver to another
_SKIPPED = {"requests.md"}


class Wrong(Exception):
    pass


def run(command, folder, program):
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    done = subprocess.run(["sh", "-c", command], cwd=folder, env=environment, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
    return done.returncode, done.stdout.splitlines()


def matches(wanted, printed):
    """Whether the lines are those wanted, where ... is any number of lines."""
    if not wanted:
        return not printed
    if wanted[0] == "...":
        return any(matches(wanted[1:], printed[i:]) for i in range(len(printed) + 1))
    return bool(printed) and wanted[0].rstrip() == printed[0].rstrip() and matches(
        wanted[1:], printed[1:])


def same(wanted, printed):
    """Whether two lines agree: their words exactly, their numbers as far as solvers do elsewhere."""
    if wanted == printed:
        return True
    if _NUMBER.sub("#", wanted) != _NUMBER.sub("#", printed):
        return False
    return all(abs(float(a) - float(b)) <= _AS_FAR * abs(float(a))
               for a, b in zip(_NUMBER.findall(wanted), _NUMBER.findall(printed)))


def in_order(wanted, printed):
    """The first line wanted that is not printed after those before it, or None."""
    at = 0
    for line in wanted:
        if line.strip() == "...":
            continue
        found = [i for i in range(at, len(printed)) if same(line.strip(), printed[i].strip())]
        if not found:
            return line
        at = found[0] + 1
    return None


def steps_of(text):
    """(exact, command, lines) of a page, in its order."""
    found = []
    for block in _CONSOLE.finditer(text):
        for part in re.split(r"^\$ ", block[1], flags=re.MULTILINE)[1:]:
            command, _, rest = re.sub(r"\\\n\s*", "", part).partition("\n")
            found.append((block.start(), True, command, rest.splitlines()))
    lines = _CONSOLE.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text).splitlines(keepends=True)
    position = index = 0
    while index < len(lines):
        match = re.match(r"( {4,})(\$ )?(hodograph .*)$", lines[index].rstrip("\n"))
        here = position
        position += len(lines[index])
        index += 1
        if not match:
            continue
        command = match[3]
        while command.endswith("\\"):
            command = command[:-1] + lines[index].strip()
            position += len(lines[index])
            index += 1
        shown = []
        while match[2] and index < len(lines) and lines[index].startswith(match[1]) and not re.match(
                r" {4,}\$ ", lines[index]):
            shown.append(lines[index].strip())
            position += len(lines[index])
            index += 1
        found.append((here, False, command, shown))
    return [step[1:] for step in sorted(found, key=lambda step: step[0])]


def check(page, program):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for example in (_ROOT / "examples").iterdir():
            if example.is_file():
                shutil.copy(example, folder)
        (folder / "data").symlink_to(_ROOT / "data")
        steps = steps_of(page.read_text(encoding="utf-8"))
        for exact, command, lines in steps:
            code, printed = run(command, folder, program)
            said = "\n".join(printed)
            refused = any(line.startswith("hodograph: ") for line in lines)
            if exact and lines and not matches(lines, printed):
                raise Wrong(f"$ {command}\nprints\n{said}\nnot\n" + "\n".join(lines))
            missing = None if exact else in_order(lines, printed)
            if missing is not None:
                raise Wrong(f"$ {command}\nprints\n{said}\nwithout\n{missing}")
            if code != 0 and not refused and not lines:
                raise Wrong(f"$ {command}\nexits with {code}:\n{said}")
        return len(steps)


def main():
    program = Path(sys.argv[1]).resolve()
    named = [Path(name).resolve() for name in sys.argv[2:]]
    total, status = 0, 0
    for page in named or sorted((_ROOT / "docs").rglob("*.md")):
        if page.name in _SKIPPED:
            continue
        try:
            total += check(page, program)
        except Wrong as problem:
            print(f"{page.relative_to(_ROOT)}: {problem}\n")
            status = 1
    if not named and total < 15:
        print(f"only {total} commands were found")
        status = 1
    print(f"{total} commands run")
    return status


if __name__ == "__main__":
    sys.exit(main())
