# SPDX-License-Identifier: MIT
"""Builds the wheel: the build backend that pyproject.toml names (PEP 517 and PEP 660).

It runs CMake with the preset `release` for the interpreter that pip runs under, in build/release,
so that a second installation compiles only what changed, and packs the package. It needs no Python
package, so pip needs no network.

Config settings (pip install . --config-settings name=value) or environment variables:

  built=DIR      HODOGRAPH_BUILT      take the extension modules from this build directory and
                                      compile nothing
  build-dir=DIR  HODOGRAPH_BUILD_DIR  build there instead of in build/release
  jobs=N         CMAKE_BUILD_PARALLEL_LEVEL  compile so many files at a time
"""

import base64
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import time
import zipfile
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent
_PACKAGE = _ROOT / "python" / "hodograph"
_SOURCES = ("cli", "cmake", "include", "python", "src")  # what CMake reads without the tests
_SOURCE_FILES = ("CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json", "LICENSE",
                 "README.md", "pyproject.toml")
_HELP = "On Debian 12: tools/install_packages python (from the source tree) installs what is needed."


def _stop(sentence):
    """Ends the build with a sentence that pip shows, and nothing else."""
    print(f"\nhodograph cannot be built: {sentence}", file=sys.stderr, flush=True)
    sys.exit(1)


def _setting(config_settings, name, variable):
    value = (config_settings or {}).get(name) or os.environ.get(variable)
    return value[-1] if isinstance(value, list) else value


def _version():
    header = _ROOT / "include" / "hodograph" / "foundation" / "version.hpp"
    found = re.search(r'define HODOGRAPH_VERSION_STRING "([^"]+)"',
                      header.read_text(encoding="utf-8"))
    assert found, header
    return found.group(1)


def _project():
    if sys.version_info < (3, 11):
        _stop(f"it needs Python 3.11 or newer; this is {platform.python_version()} "
              f"({sys.executable})")
    import tomllib  # new in 3.11
    return tomllib.loads((_ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def _metadata():
    project = _project()
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {_version()}",
             f"Summary: {project['description']}", f"License: {project['license']['text']}",
             "License-File: LICENSE", f"Requires-Python: {project['requires-python']}",
             "Keywords: " + ",".join(project["keywords"])]
    lines += [f"Classifier: {name}" for name in project["classifiers"]]
    lines += [f"Requires-Dist: {name}" for name in project["dependencies"]]
    for extra, names in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {name} ; extra == "{extra}"' for name in names]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join(lines) + "\n" + (_ROOT / project["readme"]).read_text(encoding="utf-8")


# ---- compiling -----------------------------------------------------------------------------------


def _interpreter():
    """The interpreter under any virtual environment: building for it once serves all of them."""
    return os.path.realpath(getattr(sys, "_base_executable", sys.executable))


def _suffix():
    return sysconfig.get_config_var("EXT_SUFFIX")


def _modules(build):
    """The extension modules for this interpreter in a build directory."""
    return sorted((build / "python" / "hodograph").glob(f"*{_suffix()}"))


def _check_tools():
    for tool, package in (("cmake", "cmake"), ("ninja", "ninja-build")):
        if not shutil.which(tool):
            _stop(f"{tool} is not installed (Debian's package {package}). {_HELP}")
    compiler = os.environ.get("CXX", "").split(" ")[0]
    if compiler and not shutil.which(compiler):
        _stop(f"the compiler that CXX names, {compiler}, is not there.")
    if not compiler and not any(shutil.which(name) for name in ("c++", "g++", "clang++")):
        _stop(f"there is no C++ compiler (Debian's package g++). {_HELP}")
    header = Path(sysconfig.get_path("include")) / "Python.h"
    if not header.exists():
        _stop(f"the headers of this Python ({sys.executable}) are missing: {header} (Debian's "
              f"package python3-dev, for /usr/bin/python3). {_HELP}")


def _run(command, log, what):
    """Runs a command, its output in `log` and, with pip -v, on the terminal."""
    with log.open("a", encoding="utf-8") as file:
        process = subprocess.Popen(command, cwd=_ROOT, stdout=subprocess.PIPE, text=True,
                                   stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
        lines = []
        for line in process.stdout:
            file.write(line)
            print(line, end="", flush=True)
            lines.append(line)
    if process.wait() == 0:
        return
    text = "".join(lines)
    hint = f" {_HELP}" if "pybind11" in text or "not found" in text or "Could not find" in text else ""
    _stop(f"{what} failed; the whole output is in {log}.{hint}")


def _build(config_settings):
    """The build directory, with the extension modules in it."""
    built = _setting(config_settings, "built", "HODOGRAPH_BUILT")
    if built:
        build = Path(built).resolve()
        if not _modules(build):
            _stop(f"{build}/python/hodograph holds no extension modules for this Python "
                  f"(*{_suffix()}).")
        return build
    _check_tools()
    build = Path(_setting(config_settings, "build-dir", "HODOGRAPH_BUILD_DIR")
                 or _ROOT / "build" / "release").resolve()
    build.mkdir(parents=True, exist_ok=True)
    log = build.parent / f"{build.name}-wheel.log"
    log.unlink(missing_ok=True)
    cache = build / "CMakeCache.txt"
    fresh = []
    if cache.exists() and f"CMAKE_HOME_DIRECTORY:INTERNAL={_ROOT}\n" not in cache.read_text():
        fresh = ["--fresh"]  # the tree was moved
    _run(["cmake", "--preset", "release", "-B", str(build), *fresh, "-DHODOGRAPH_WITH_PYTHON=ON",
          "-DHODOGRAPH_WITH_IO=ON", "-DHODOGRAPH_WITH_PLANNING=ON",
          f"-DPython_EXECUTABLE={_interpreter()}"], log, "configuring with CMake")
    jobs = _setting(config_settings, "jobs", "CMAKE_BUILD_PARALLEL_LEVEL") or os.cpu_count() or 1
    _run(["cmake", "--build", str(build), "--target", "hodograph_python", "--parallel", str(jobs)],
         log, "compiling")
    if not _modules(build):
        _stop(f"no extension modules for this Python (*{_suffix()}) came out of {build}.")
    return build


# ---- packing -------------------------------------------------------------------------------------


def _tag():
    system = re.sub(r"[^A-Za-z0-9_]", "_", sysconfig.get_platform())
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{system}"


def _stem():
    return f"{_project()['name']}-{_version()}"


def _instant():
    """When files in archives were changed: the same for the same sources, if asked for."""
    given = int(os.environ.get("SOURCE_DATE_EPOCH", "0"))
    return max(given, 315532800)  # 1980, where zip files begin


class _Wheel:
    """A wheel that is written whole or not at all."""

    def __init__(self, folder, name):
        self.name = name
        self._path = Path(folder) / name
        self._draft = self._path.with_suffix(".part")
        self._zip = zipfile.ZipFile(self._draft, "w", zipfile.ZIP_DEFLATED)
        self._record = []

    def add(self, name, data, mode=0o644):
        if isinstance(data, str):
            data = data.encode()
        entry = zipfile.ZipInfo(name, time.gmtime(_instant())[:6])
        entry.external_attr = (0o100000 | mode) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        self._zip.writestr(entry, data)
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self._record.append(f"{name},sha256={digest},{len(data)}")

    def finish(self):
        record = f"{_stem()}.dist-info/RECORD"
        lines = "\n".join([*self._record, f"{record},,"]) + "\n"
        self.add(record, lines)
        self._zip.close()
        self._draft.replace(self._path)
        return self.name


def _information():
    """The files of the dist-info folder, except RECORD."""
    return {"METADATA": _metadata(),
            "WHEEL": f"Wheel-Version: 1.0\nGenerator: hodograph {_version()}\n"
                     f"Root-Is-Purelib: false\nTag: {_tag()}\n",
            "LICENSE": (_ROOT / "LICENSE").read_text(encoding="utf-8")}


def _package_files():
    """The files of the package that are not compiled, relative to it."""
    return sorted(path.relative_to(_PACKAGE) for path in _PACKAGE.rglob("*")
                  if path.suffix in (".py", ".pyi") or path.name == "py.typed")


def _stripped(module):
    """The bytes of an extension module without its debugging symbols."""
    strip = shutil.which("strip")
    if strip:
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / module.name
            command = [strip, "--strip-unneeded", "-o", str(copy), str(module)]
            if subprocess.run(command, capture_output=True, check=False).returncode == 0:
                return copy.read_bytes()
    return module.read_bytes()


def _wheel(folder, config_settings, fill):
    wheel = _Wheel(folder, f"{_stem()}-{_tag()}.whl")
    fill(wheel, _build(config_settings))
    for name, text in _information().items():
        wheel.add(f"{_stem()}.dist-info/{name}", text)
    return wheel.finish()


# ---- what pip calls ------------------------------------------------------------------------------


def get_requires_for_build_wheel(config_settings=None):
    return []


get_requires_for_build_sdist = get_requires_for_build_editable = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = Path(metadata_directory) / f"{_stem()}.dist-info"
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in _information().items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder.name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The wheel with the package, its stubs and its extension modules."""
    def fill(wheel, build):
        for file in _package_files():
            wheel.add(f"hodograph/{file.as_posix()}", (_PACKAGE / file).read_bytes())
        for module in _modules(build):
            wheel.add(f"hodograph/{module.name}", _stripped(module), 0o755)
    return _wheel(wheel_directory, config_settings, fill)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """A wheel that points to the build directory: after a change, build hodograph_python there."""
    return _wheel(wheel_directory, config_settings,
                  lambda wheel, build: wheel.add("hodograph.pth", f"{build / 'python'}\n"))


def build_sdist(sdist_directory, config_settings=None):
    """The sources from which the wheel is built, and nothing else."""
    stem = _stem()
    files = [_ROOT / name for name in _SOURCE_FILES]
    for folder in _SOURCES:
        files += sorted(path for path in (_ROOT / folder).rglob("*")
                        if path.is_file() and "__pycache__" not in path.parts)
    name = f"{stem}.tar.gz"
    information = Path(sdist_directory) / "PKG-INFO"
    information.write_text(_metadata(), encoding="utf-8")

    def plain(entry):
        entry.uid = entry.gid = 0
        entry.uname = entry.gname = ""
        entry.mtime = _instant()
        return entry

    with tarfile.open(Path(sdist_directory) / name, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for path in files:
            archive.add(path, f"{stem}/{path.relative_to(_ROOT)}", filter=plain)
        archive.add(information, f"{stem}/PKG-INFO", filter=plain)
    information.unlink()
    return name
