# SPDX-License-Identifier: MIT
"""The names that optional components bring, each from an extension module of its own.

They are loaded when one of their names is first used: nobody pays for a library he does not use,
and a build without it still has everything else.
"""

from __future__ import annotations

import importlib
from typing import Any

#: extension module: (what it needs to be built, the public names in it)
MODULES: dict[str, tuple[str, tuple[str, ...]]] = {
    "_certify": ("Arb", ()),
    "_orbit": ("Boost", ()),
    "_rational": ("FLINT and Clp", ()),
    "_control": ("Ipopt", ()),
    "_cad": ("OpenCASCADE", ()),
}

_HOME = {name: module for module, (_, names) in MODULES.items() for name in names}

NAMES = tuple(_HOME)


def load(name: str) -> Any:
    """The object called ``name``, or AttributeError with what is missing."""
    module = _HOME.get(name)
    if module is None:
        raise AttributeError(f"module 'hodograph' has no attribute {name!r}")
    try:
        return getattr(importlib.import_module(f"hodograph.{module}"), name)
    except ModuleNotFoundError as error:
        raise AttributeError(
            f"hodograph.{name} needs a build with {MODULES[module][0]}; this one was made without"
        ) from error
