#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the gallery: every script's picture and numbers, and the pages around them.

    docs/gallery/build.py OUTDIR            pictures and pages into OUTDIR, for the site
    docs/gallery/build.py --pages           rewrites the pages beside this file, without pictures
    docs/gallery/build.py --check           whether they are what the scripts say now

The pages are in the repository, so that a change of a number is a visible difference; the pictures
are not. With `--only NAME...` OUTDIR gets the pictures of these scripts alone.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib
import io
import re
import sys
from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

import matplotlib  # noqa: E402

matplotlib.use("Agg")

_PICTURE_DPI = 130

#: page: (title, what stands above its figures)
PAGES = {
    "phodcos": ("Coordinate systems along curves",
                "The figures of *PHODCOS: Pythagorean Hodograph-based Differentiable Coordinate "
                "System*, computed anew."),
    "helical": ("Helical paths",
                "The figures of *Helical polynomial curves interpolating G¹ data with prescribed "
                "axes and pitch angles*, computed anew."),
    "planning": ("Path planning in the plane",
                 "The figures of *Path planning with Pythagorean-hodograph curves for unmanned or "
                 "autonomous vehicles*, computed anew. Where the paper does not print its "
                 "coordinates, the figure shows data of the same kind."),
    "rational": ("Rational curves",
                 "The paper *Rational framing motions and spatial rational Pythagorean hodograph "
                 "curves* has no figures. Its examples, drawn."),
    "loops": ("Closed loops",
              "The figures of *Spatial C² closed loops of prescribed arc length defined by "
              "Pythagorean-hodograph curves*, computed anew."),
    "own": ("More", "What the papers do not show."),
}


@dataclass
class Made:
    """What a script gave."""

    name: str
    title: str
    caption: str
    numbers: str
    figure: object


def scripts() -> list[str]:
    """The names of all scripts, page by page, in the order of their figures."""
    def order(name: str) -> tuple:
        page, _, rest = name.partition("_")
        number = re.match(r"\d+", rest)
        return list(PAGES).index(page), int(number[0]) if number else 0, rest
    found = [path.stem for path in FOLDER.glob("*_*.py")]
    return sorted((name for name in found if name.partition("_")[0] in PAGES), key=order)


def make(name: str) -> Made:
    """Runs one script."""
    script = importlib.import_module(name)
    title, _, caption = script.__doc__.strip().partition("\n\n")
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        figure = script.draw()
    return Made(name, title, caption, printed.getvalue(), figure)


def section(made: Made) -> str:
    """A figure in its page."""
    numbers = f"\n```text\n{made.numbers.rstrip()}\n```\n" if made.numbers else ""
    return (f"## {made.title}\n\n![{made.title}](pictures/{made.name}.png)\n\n{made.caption}\n"
            f"{numbers}\nScript: [{made.name}.py]({made.name}.py)\n")


def anchor(title: str) -> str:
    """Where a heading is in its page, as GitHub and the site have it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def pages(made: list[Made]) -> dict[str, str]:
    """All pages, by file name."""
    note = "<!-- Made by build.py from the scripts beside it: change those. -->\n\n"
    texts = {}
    index = ["# Gallery\n", "Every figure is made by a short script that computes with `hodograph` "
             "and draws with\n[`hodograph.plots`](../python.md#plots). The tests run all of them "
             "and compare the numbers below the\npictures.\n"]
    for page, (title, introduction) in PAGES.items():
        here = [each for each in made if each.name.partition("_")[0] == page]
        if not here:
            continue
        texts[f"{page}.md"] = (note + f"# {title}\n\n{introduction}\n\n"
                               + "\n".join(section(each) for each in here))
        index.append(f"## [{title}]({page}.md)\n")
        index += [f"- [{each.title}]({page}.md#{anchor(each.title)})" for each in here]
        index.append("")
    texts["index.md"] = note + "\n".join(index)
    return texts


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, metavar="OUTDIR")
    parser.add_argument("--pages", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", nargs="+", metavar="NAME")
    given = parser.parse_args()
    if (given.folder is not None) + given.pages + given.check != 1:
        parser.error("give a folder, --pages or --check")
    done = []
    for name in given.only or scripts():
        each = make(name)
        if given.folder is not None:
            pictures = given.folder / "pictures"
            pictures.mkdir(parents=True, exist_ok=True)
            each.figure.savefig(pictures / f"{name}.png", dpi=_PICTURE_DPI)
        each.figure = None
        done.append(each)
    if given.only:
        return 0
    texts = pages(done)
    if given.check:
        stale = [name for name, text in texts.items()
                 if not (FOLDER / name).exists() or (FOLDER / name).read_text("utf-8") != text]
        for name in stale:
            print(f"docs/gallery/{name} is not what the scripts say; run docs/gallery/build.py "
                  "--pages", file=sys.stderr)
        return 1 if stale else 0
    for name, text in texts.items():
        (FOLDER if given.pages else given.folder).joinpath(name).write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
