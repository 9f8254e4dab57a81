#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The type stubs and the lists of public names are those of what was built; a type checker agrees.

Where one differs, tools/make_stubs rewrites them: look at the difference, and tell CHANGELOG.md.
"""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import hodograph

_ROOT = Path(__file__).resolve().parents[2]
_HERE = Path(__file__).resolve().parent
_PACKAGE = Path(os.environ["PYTHONPATH"].split(os.pathsep)[0])


def _run(*command):
    environment = {**os.environ, "MYPYPATH": str(_PACKAGE), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, *map(str, command)], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False, env=environment, cwd="/")


class Lists(unittest.TestCase):
    def test_stubs_and_the_list_of_names_are_what_was_built(self):
        done = _run("-B", _ROOT / "tools" / "python_api.py", "--check")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stdout)

    def test_the_list_of_cpp_names_is_what_the_headers_declare(self):
        done = _run("-B", _ROOT / "tools" / "cpp_api.py", "--check")
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stdout)
        done = _run("-B", _ROOT / "tools" / "cpp_api.py", "--self-test")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_every_public_name_is_documented(self):
        def bare(thing):  # pybind11 puts the signature into the first line
            lines = (thing.__doc__ or "").strip().split("\n")
            lines = lines[1:] if re.match(r"\w+\(.*\) -> ", lines[0]) else lines
            return not "".join(lines).strip()

        nameless = [name for name in hodograph.__all__
                    if callable(getattr(hodograph, name)) and bare(getattr(hodograph, name))]
        self.assertEqual(nameless, [])


class PartialBuilds(unittest.TestCase):
    def test_a_component_that_was_not_built_is_missed_by_name_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            package = Path(folder) / "hodograph"
            package.mkdir()
            for path in (_PACKAGE / "hodograph").iterdir():
                if not path.name.startswith("_cad."):
                    (package / path.name).symlink_to(path)
            script = ("from hodograph import *\nimport hodograph\n"
                      "assert 'save_step' not in hodograph.__all__\n"
                      "try:\n    hodograph.save_step\nexcept AttributeError as error:\n    print(error)\n")
            done = subprocess.run([sys.executable, "-c", script], text=True, check=False,
                                  env={**os.environ, "PYTHONPATH": folder}, cwd="/",
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.assertEqual(done.stdout, "hodograph.save_step needs a build with OpenCASCADE; this "
                                          "one was made without\n")


class Types(unittest.TestCase):
    def test_the_stubs_agree_with_the_modules(self):
        done = _run("-m", "mypy.stubtest", "hodograph", "--concise", "--mypy-config-file",
                    _HERE / "mypy.ini")
        # pybind11's metaclass is nobody's business, nor that it takes any arguments to say that there
        # is no constructor; a module in Python is its own stub, and what it
        # imports is not its.
        own = {path.stem for path in (_PACKAGE / "hodograph").glob("*.pyi")} - {"__init__"}
        listed = "|".join(sorted(own))
        problems = [line for line in done.stdout.splitlines()
                    if not line.endswith("is inconsistent, metaclass differs")
                    and ".__pybind11_" not in line
                    and not line.endswith('stub does not have *args argument "args"')
                    and not (re.match(r"hodograph\.\w+\.\w+", line)
                             and not re.match(rf"hodograph\.({listed})\.", line))]
        self.assertEqual(problems, [], "\n".join(problems))

    def test_a_strict_type_checker_reads_a_program_as_it_is_meant(self):
        program = _HERE / "typed_program.py"
        with tempfile.TemporaryDirectory() as cache:
            done = _run("-m", "mypy", "--strict", "--config-file", _HERE / "mypy.ini",
                        "--cache-dir", cache, program)
        said = []
        for line in done.stdout.splitlines():
            if "Found " in line:
                continue
            match = re.search(r"typed_program\.py:(\d+): (note: Revealed type is \"|error: )(.*)$",
                              line)
            self.assertIsNotNone(match, line)
            kind = "is" if "Revealed" in match[2] else "error"
            said.append((int(match[1]), kind, match[3].rstrip('"') if kind == "is" else match[3]))
        meant = []
        for number, line in enumerate(program.read_text(encoding="utf-8").splitlines(), 1):
            match = re.search(r"  # (is|error): (.*)$", line)
            if match:
                meant.append((number, match[1], match[2]))
        self.assertEqual(said, meant)


if __name__ == "__main__":
    unittest.main()
