#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""`pip install .` as a user runs it, without network: into an environment that sees Debian's NumPy,
into one without NumPy, from the sources and from a source archive, and away again.

The extension modules are those of the build tree (HODOGRAPH_BUILT), so nothing is compiled here.
"""

import os
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
import zipfile
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_BUILT = Path(os.environ["PYTHONPATH"].split(os.pathsep)[0]).parent
_BLOCK = re.compile(r"```python\n(.*?)```\s*```text\n(.*?)```", re.DOTALL)


def _environment(**more):
    clean = {name: value for name, value in os.environ.items()
             if not name.startswith(("PYTHON", "PIP_", "HODOGRAPH", "VIRTUAL_ENV"))}
    return {**clean, "PYTHONDONTWRITEBYTECODE": "1", "HODOGRAPH_BUILT": str(_BUILT),
            "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_CACHE_DIR": "1",
            "PIP_ROOT_USER_ACTION": "ignore", **more}


def _run(*command, **more):
    return subprocess.run([str(part) for part in command], env=_environment(**more), text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, cwd="/")


class Wheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.wheel = cls.pip("wheel", "--no-deps", "-w", cls.folder, "--config-settings",
                            f"built={_BUILT}", _ROOT, HODOGRAPH_BUILT="").folder_file("*.whl")

    @classmethod
    def pip(cls, command, *arguments, python=sys.executable, fails=False, **more):
        done = _run(sys.executable, "-m", "pip", "--python", python, command,
                    *(["--no-index"] if command in ("install", "wheel") else []), *arguments, **more)
        assert (done.returncode != 0) == fails, done.stdout
        done.folder_file = lambda pattern: next(cls.folder.glob(pattern))
        return done

    def environment(self, name, *options):
        _run(sys.executable, "-m", "venv", "--without-pip", *options, self.folder / name)
        python = self.folder / name / "bin" / "python3"
        self.assertTrue(python.exists())
        return python

    def files_of(self, name):
        return set((self.folder / name).rglob("*"))

    def test_installs_runs_the_readme_and_leaves_nothing(self):
        python = self.environment("with", "--system-site-packages")
        before = self.files_of("with")
        self.pip("install", _ROOT, python=python)  # NumPy is found, or this would need a network
        code, expected = _BLOCK.search((_ROOT / "README.md").read_text(encoding="utf-8")).groups()
        done = _run(python, "-c", code)
        self.assertEqual(done.stdout, expected)
        done = _run(python, "-c", "import hodograph; print(hodograph.__version__, hodograph.__file__)")
        self.assertIn(str(self.folder / "with"), done.stdout)
        shown = self.pip("show", "--files", "hodograph", python=python).stdout
        for name in ("Version: " + done.stdout.split()[0], "License: MIT", "Requires: numpy",
                     "hodograph/py.typed", "hodograph/_core.pyi"):
            self.assertIn(name, shown)
        self.pip("check", python=python)
        self.pip("uninstall", "-y", "hodograph", python=python)
        self.assertEqual(self.files_of("with"), before)

    def test_an_editable_installation_points_to_the_build_tree(self):
        python = self.environment("editable", "--system-site-packages")
        self.pip("install", "-e", _ROOT, python=python)
        done = _run(python, "-c", "import hodograph; print(hodograph.__file__)")
        self.assertEqual(Path(done.stdout.strip()), _BUILT / "python" / "hodograph" / "__init__.py")
        self.pip("uninstall", "-y", "hodograph", python=python)
        self.assertNotEqual(_run(python, "-c", "import hodograph").returncode, 0)

    def test_without_numpy_says_what_is_missing(self):
        python = self.environment("without")
        refused = self.pip("install", self.wheel, python=python, fails=True)
        self.assertIn("numpy", refused.stdout)
        self.pip("install", "--no-deps", self.wheel, python=python)
        done = _run(python, "-c", "import hodograph")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("hodograph needs NumPy, which this Python lacks; install it", done.stdout)

    def test_the_wheel_holds_the_package_and_nothing_else(self):
        self.assertRegex(self.wheel.name,
                         r"^hodograph-[\d.]+-cp3\d+-cp3\d+-linux_\w+\.whl$")
        with zipfile.ZipFile(self.wheel) as archive:
            names = {name.split("/", 1)[1] for name in archive.namelist()
                     if name.startswith("hodograph/")}
            built = {path.relative_to(_BUILT / "python" / "hodograph").as_posix()
                     for path in (_BUILT / "python" / "hodograph").rglob("*")
                     if path.is_file() and "__pycache__" not in path.parts}
            self.assertEqual(names, built)
            others = {name for name in archive.namelist() if not name.startswith("hodograph/")}
            self.assertEqual({name.split("/")[1] for name in others},
                             {"METADATA", "WHEEL", "LICENSE", "RECORD"})

    def test_builds_from_a_source_archive(self):
        script = f"import build_backend; print(build_backend.build_sdist({str(self.folder)!r}))"
        done = _run(sys.executable, "-c", script, PYTHONPATH=str(_ROOT / "python"))
        archive = self.folder / done.stdout.strip()
        with tarfile.open(archive) as opened:
            names = opened.getnames()
        stem = archive.name.removesuffix(".tar.gz")
        for name in ("CMakeLists.txt", "PKG-INFO", "include/hodograph/path/path.hpp",
                     "python/src/module.cpp", "python/hodograph/py.typed", "LICENSE"):
            self.assertIn(f"{stem}/{name}", names)
        again = self.folder / "again"
        self.pip("wheel", "--no-deps", "-w", again, archive)
        self.assertEqual([path.name for path in again.iterdir()], [self.wheel.name])

    def test_says_what_is_missing_to_build(self):
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "cmake").symlink_to("/bin/true")

        def refusal(**more):
            return self.pip("wheel", "--no-deps", "-w", self.folder / "none", _ROOT, fails=True,
                            **more).stdout

        nowhere = str(self.folder / "nowhere")
        self.assertIn("cmake is not installed (Debian's package cmake)",
                      refusal(HODOGRAPH_BUILT="", PATH=nowhere))
        self.assertIn("ninja is not installed (Debian's package ninja-build)",
                      refusal(HODOGRAPH_BUILT="", PATH=str(tools)))
        (tools / "ninja").symlink_to("/bin/true")
        self.assertIn("there is no C++ compiler (Debian's package g++)",
                      refusal(HODOGRAPH_BUILT="", PATH=str(tools)))
        self.assertIn("nowhere/python/hodograph holds no extension modules for this Python",
                      refusal(HODOGRAPH_BUILT=nowhere))
        (tools / "c++").symlink_to("/bin/true")
        (tools / "cmake").unlink()
        (tools / "cmake").write_text("#!/bin/sh\necho 'CMake Error: pybind11 not found'\nexit 1\n")
        (tools / "cmake").chmod(0o755)
        said = refusal(HODOGRAPH_BUILT="", HODOGRAPH_BUILD_DIR=str(self.folder / "build"),
                       PATH=f"{tools}:/usr/bin:/bin")
        self.assertIn("CMake Error: pybind11 not found", said)
        self.assertIn("tools/install_packages python", said)


if __name__ == "__main__":
    unittest.main()
