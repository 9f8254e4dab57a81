#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the documentation site, without network and without warnings.

    tools/build_docs.py [build directory] [folder]       default: build/release build/docs

The build directory holds the Python package. Into the folder: pages/ (the pages of docs/ as Sphinx
reads them, with the pictures that their Python blocks and the gallery draw, and the Python interface
from the docstrings), cpp/ (Doxygen's), html/ (the site; open html/index.html).
"""

import ast
import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from check_support import MODULES

_ROOT = Path(__file__).resolve().parent.parent
_DOCS = _ROOT / "docs"
_MATHJAX = Path("/usr/share/javascript/mathjax")
_MATHJAX_PARTS = ("MathJax.js", "config/TeX-AMS_CHTML.js", "extensions", "jax/element", "jax/input/TeX",
                  "jax/output/CommonHTML", "fonts/HTML-CSS/TeX/woff")
_LINK = re.compile(r"(?<!!)\[((?:[^\]\\`]|\\.|`[^`]*`)*)\]\(([^)\s]+)\)")
_FENCE = re.compile(r"^( *)(```+|~~~+)[^\n]*\n.*?^\1\2 *$", re.MULTILINE | re.DOTALL)
_PYTHON = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def fail(sentence):
    sys.exit(f"documentation: {sentence}")


# ---- Doxygen -------------------------------------------------------------------------------------


def build_cpp(folder):
    """Doxygen's pages; {header: its page}."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    tags = folder / "tags.xml"
    settings = (_DOCS / "Doxyfile").read_text(encoding="utf-8")
    settings += f"OUTPUT_DIRECTORY = {folder}\nHTML_OUTPUT = cpp\nGENERATE_TAGFILE = {tags}\n"
    done = subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=_ROOT, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0 or "warning" in done.stdout or "error" in done.stdout:
        fail(f"Doxygen complains:\n{done.stdout[:4000]}")
    pages = {}
    for compound in xml.parse(tags).getroot().findall("compound[@kind='file']"):
        path = "/" + (compound.findtext("path") or "") + compound.findtext("name")
        pages["include/" + path.rpartition("/include/")[2]] = compound.findtext("filename")
    if "include/hodograph/path/path.hpp" not in pages:
        fail("Doxygen's list of files is not as it was: links to headers would be lost")
    tags.unlink()
    (folder / "cpp" / "index.html").write_text(  # Doxygen's own is empty
        '<!DOCTYPE html>\n<meta charset="utf-8">\n<title>Hodograph</title>\n'
        '<meta http-equiv="refresh" content="0; url=../cpp_api.html">\n', encoding="utf-8")
    return pages


def summary_of(header):
    """The first paragraph of the comment at the head of a header."""
    lines = []
    for line in header.read_text(encoding="utf-8").splitlines()[1:]:
        text = line.removeprefix("//").strip()
        if not line.startswith("//") or not text:
            break
        lines.append(text)
    return " ".join(lines)


def write_cpp_interface(folder, headers):
    """cpp_api.md: every public header, module by module, with a link to Doxygen's page."""
    modules = {}
    for header in headers:
        modules.setdefault(header.split("/")[2], []).append(header)
    lines = ["# C++ interface", "",
             "Every public header, in the order in which modules may include each other; the links lead to "
             "what it declares. `#include <hodograph/MODULE/HEADER>`; all names are in the namespace "
             "`hodograph`.", ""]
    for module in [name for name in MODULES if name in modules]:
        lines += [f"## {module}", "", "| header | |", "|---|---|"]
        for header in sorted(modules[module]):
            text = re.sub(r"([*_<|\[\]$])", r"\\\1", summary_of(_ROOT / header))
            name = header.removeprefix(f"include/hodograph/{module}/")
            lines.append(f'| <a class="reference external" href="cpp/{headers[header]}">'
                         f"<code>{name}</code></a> | {text} |")
        lines.append("")
    (folder / "cpp_api.md").write_text("\n".join(lines), encoding="utf-8")


# ---- pages ---------------------------------------------------------------------------------------


def outside_fences(text, change):
    """The text with `change` applied to what is not a code block."""
    parts, position = [], 0
    for fence in _FENCE.finditer(text):
        parts += [change(text[position:fence.start()]), fence.group(0)]
        position = fence.end()
    return "".join(parts) + change(text[position:])


def linked(text, page, headers):
    """Links that leave docs/: to a header, Doxygen's page; to anything else, its name."""
    up = "../" * (len(page.relative_to(_DOCS).parts) - 1)

    def replace(match):
        label, target = match.groups()
        if re.match(r"[a-z]+:|#", target):
            return match.group(0)
        file, _, _ = target.partition("#")
        place = (page.parent / file).resolve()
        if not place.exists():
            if "pictures/" not in file:
                fail(f"{page.relative_to(_ROOT)} links to {target}, which is not there")
        if place.is_relative_to(_DOCS) and not place.is_dir():
            return match.group(0)
        name = place.relative_to(_ROOT).as_posix()
        html = re.sub(r"`([^`]*)`", r"<code>\1</code>", label.replace("<", "&lt;"))
        if name == "tests/golden/python_api.txt":
            return f"[{label}]({up}python_api.rst)"
        if name == "tests/golden/cpp_api.txt":
            return f"[{label}]({up}cpp_api.md)"
        if name in headers:
            return f'<a class="reference external" href="{up}cpp/{headers[name]}">{html}</a>'
        if name.startswith("include/") and name.endswith(".hpp"):
            fail(f"{page.relative_to(_ROOT)} links to {name}, which has no page")
        return label

    return outside_fences(text, lambda part: _LINK.sub(replace, part))


def with_toctree(text):
    """An index page with its links as Sphinx's table of contents, one a heading, which a reader of the
    page does not see: it stands in the sidebar."""
    introduction, *sections = re.split(r"^(?=## )", text, flags=re.MULTILINE)
    trees, seen = "", set()
    for part in sections:
        title = part.partition("\n")[0]
        targets = [target.partition("#")[0] for _, target in _LINK.findall(part)]
        targets = [file for file in dict.fromkeys(targets) if file.endswith((".md", ".rst"))
                   and not file.startswith("..") and file not in seen]
        seen.update(targets)
        caption = "" if _LINK.search(title) else f":caption: {title.removeprefix('## ')}\n"
        if targets:
            trees += ("\n```{toctree}\n:hidden:\n:titlesonly:\n" + caption + "\n" + "\n".join(targets)
                      + "\n```\n")
    return introduction + trees + "\n" + "".join(sections)


def write_pages(folder, headers):
    shutil.rmtree(folder, ignore_errors=True)
    skipped = ("Doxyfile", "doxygen.sed")
    for path in sorted(_DOCS.rglob("*")):
        if not path.is_file() or path.name in skipped or "__pycache__" in path.parts:
            continue
        copy = folder / path.relative_to(_DOCS)
        copy.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix != ".md":
            shutil.copyfile(path, copy)
            continue
        text = linked(path.read_text(encoding="utf-8"), path, headers)
        if path.name == "index.md":
            text = with_toctree(text)
        copy.write_text(text, encoding="utf-8")


def draw_pictures(folder):
    """Runs the Python blocks of the pages; what they draw goes into pictures/ beside the page."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
    for page in sorted(folder.rglob("*.md")):
        blocks = _PYTHON.findall(page.read_text(encoding="utf-8"))
        if not any("savefig" in block for block in blocks):
            continue
        pictures = page.parent / "pictures"
        pictures.mkdir(exist_ok=True)
        names = {}
        with contextlib.chdir(pictures), contextlib.redirect_stdout(io.StringIO()):
            for block in blocks:
                exec(compile(block, str(page), "exec"), names)
        pyplot.close("all")


def draw_gallery(folder, environment):
    script = _DOCS / "gallery" / "build.py"
    if script.exists():
        done = subprocess.run([sys.executable, "-B", str(script), str(folder / "gallery-made")],
                              env=environment, check=False, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
        if done.returncode != 0:
            fail(f"the gallery cannot be drawn:\n{done.stdout[-4000:]}")
        made = folder / "gallery-made"
        for picture in made.rglob("*.png"):
            target = folder / "gallery" / "pictures" / picture.name
            target.parent.mkdir(parents=True, exist_ok=True)
            picture.replace(target)
        shutil.rmtree(made)


# ---- the Python interface ------------------------------------------------------------------------


def escaped(text):
    """Text in which nothing is reStructuredText but what stands between backquotes, which is code."""
    parts = re.split(r"(``[^`]+``|`[^`]+`)", text)
    for i, part in enumerate(parts):
        if i % 2 == 1:
            parts[i] = f"``{part.strip('`').strip()}``"
        else:
            parts[i] = re.sub(r"([\\*`|])", r"\\\1", re.sub(r"(\w)_(?!\w)", r"\1\\_", part))
    for i in range(1, len(parts), 2):  # code must end where a word does
        if re.match(r"\w", parts[i + 1]):
            parts[i + 1] = "\\ " + parts[i + 1]
        if re.search(r"\w$", parts[i - 1]):
            parts[i - 1] += "\\ "
    return "".join(parts)


def signatures(stub):
    """{name or Class.name: [the text between name and colon, ...]} of a stub or module."""
    found = {}

    def visit(body, prefix):
        for node in body:
            if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
                arguments = ast.unparse(node.args)
                arguments = re.sub(r"^self(, /)?(, )?", "", arguments) if prefix else arguments
                result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
                kind = {ast.unparse(one) for one in node.decorator_list}
                found.setdefault(prefix + node.name, []).append((f"({arguments}){result}", kind))
            elif isinstance(node, ast.ClassDef):
                found.setdefault(prefix + node.name, [])
                visit(node.body, prefix + node.name + ".")

    visit(ast.parse(stub.read_text(encoding="utf-8")).body, "")
    return found


def documentation_of(thing):
    """The docstring's lines without pybind11's signatures."""
    lines = (thing.__doc__ or "").expandtabs().strip().split("\n")
    lines = [line for line in lines if not re.match(r"(\d+\. )?\w+\(.*\) -> ", line)
             and not line.startswith("Overloaded function")]
    indent = min((len(line) - len(line.lstrip()) for line in lines[1:] if line.strip()), default=0)
    lines = lines[:1] + [line[indent:] for line in lines[1:]]
    return "\n".join(lines).strip().split("\n")


def block(lines, indent):
    """Lines as they stand, as a line block."""
    space = " " * indent
    out = []
    for line in lines:
        if line.strip():
            out.append(f"{space}| {escaped(line)}")
        elif out and out[-1]:
            out.append("")
    return out + [""]


def write_python_interface(folder):
    """python_api.rst: every public name with its signature and docstring."""
    import hodograph
    known = {}
    for stub in [*(_ROOT / "python" / "hodograph").glob("*.py"),
                 *(_ROOT / "python" / "hodograph").glob("*.pyi")]:
        known.update(signatures(stub))
    lines = ["Python interface", "================", "",
             "Every public name of the package ``hodograph``, in the order of the alphabet. "
             "``NDArray`` are NumPy's arrays, ``ArrayLike`` is whatever NumPy makes one of.", "",
             ".. py:currentmodule:: hodograph", ""]
    classes, functions = [], []
    for name in sorted(hodograph.__all__):
        thing = getattr(hodograph, name)
        if isinstance(thing, type):
            classes.append((name, thing))
        elif callable(thing):
            functions.append((name, thing))
    lines += ["Functions", "---------", ""]
    for name, thing in functions:
        made = known.get(name) or [("(...)", set())]
        lines += [f".. py:function:: {name}{made[0][0]}"]
        lines += [f"                 {name}{text}" for text, _ in made[1:]] + [""]
        lines += block(documentation_of(thing), 3)
    lines += ["Types", "-----", ""]
    for name, thing in classes:
        made = known.get(f"{name}.__init__")
        lines += [f".. py:class:: {name}" + (made[0][0].partition(" -> ")[0] if made else ""), ""]
        lines += block(documentation_of(thing), 3)
        if hasattr(thing, "__members__"):
            for entry in thing.__members__:
                text = (getattr(thing, "__entries", {}) or {}).get(entry, (None, None))[1]
                lines += [f"   .. py:attribute:: {entry}", ""] + block([text or ""], 6)
            continue
        for member in sorted(set(dir(thing))):
            if member.startswith("_") or f"{name}.{member}" not in known:
                continue
            made = known[f"{name}.{member}"]
            got = getattr(thing, member)
            if isinstance(got, type):  # a type inside a type
                lines += [f"   .. py:class:: {member}", ""] + block(documentation_of(got), 6)
                lines += [f"      .. py:attribute:: {entry}\n"
                          for entry in getattr(got, "__members__", {})]
                continue
            if any("property" in kind for _, kind in made):
                result = made[0][0].rpartition(" -> ")[2]
                lines += [f"   .. py:property:: {member}", f"      :type: {result}", ""]
            else:
                static = "      :staticmethod:" if "staticmethod" in made[0][1] else ""
                lines += [f"   .. py:method:: {member}{made[0][0]}"]
                lines += [f"                  {member}{text}" for text, _ in made[1:]]
                lines += [static, ""] if static else [""]
            lines += block(documentation_of(got), 6)
    (folder / "python_api.rst").write_text("\n".join(lines) + "\n", encoding="utf-8")


# ---- all of it -----------------------------------------------------------------------------------


def main():
    build = Path(sys.argv[1] if len(sys.argv) > 1 else "build/release").resolve()
    out = Path(sys.argv[2] if len(sys.argv) > 2 else "build/docs").resolve()
    package = build / "python"
    if not (package / "hodograph").is_dir():
        fail(f"{package}/hodograph is not there; build it first: tools/build release hodograph_python")
    sys.path.insert(0, str(package))
    pages, html, extra = out / "pages", out / "html", out / "extra"
    environment = {**os.environ, "PYTHONPATH": str(package), "HODOGRAPH_SOURCE": str(_ROOT),
                   "HODOGRAPH_SITE_EXTRA": str(extra), "PYTHONDONTWRITEBYTECODE": "1"}
    headers = build_cpp(extra)
    write_pages(pages, headers)
    draw_pictures(pages)
    draw_gallery(pages, environment)
    write_cpp_interface(pages, headers)
    write_python_interface(pages)
    for part in _MATHJAX_PARTS:
        source, target = _MATHJAX / part, pages / "_static" / "mathjax" / part
        target.parent.mkdir(parents=True, exist_ok=True)
        if source.is_dir():
            shutil.copytree(source, target, dirs_exist_ok=True)
        else:
            shutil.copyfile(source, target)
    shutil.rmtree(html, ignore_errors=True)
    done = subprocess.run(["sphinx-build", "-q", "-W", "--keep-going",
                           "-d", str(out / "doctrees"), "-b", "html", str(pages),
                           str(html)], env=environment, check=False)
    if done.returncode != 0:
        fail("Sphinx complains")
    print(f"{html}/index.html")


if __name__ == "__main__":
    main()
