#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what can be read off the built Python package: the type stubs python/hodograph/*.pyi and
the list of public names tests/golden/python_api.txt.

    tools/python_api.py            rewrites them (PYTHONPATH names the built package)
    tools/python_api.py --check    says which differ from what was built, and exits 1

The types of the extension modules stand in the first lines of their docstrings, where pybind11 puts
them. They are written as a type checker reads them: whatever NumPy can turn into an array of doubles
goes in, arrays of doubles come out. A C++ type that has no Python name is an error: bind the type
before the functions that use it.
"""

import argparse
import difflib
import enum
import importlib
import importlib.util
import inspect
import keyword
import pkgutil
import re
import sys
import typing
from pathlib import Path

_ROOT = Path(__file__).resolve().parent.parent
_PACKAGE = _ROOT / "python" / "hodograph"
_LIST = _ROOT / "tests" / "golden" / "python_api.txt"
_HEADER = "# SPDX-License-Identifier: MIT\n# Written by tools/make_stubs from the built package; do not edit.\n"
_COLUMNS = 100

# ---- types ---------------------------------------------------------------------------------------

_ARRAY = "NDArray[float64]"
#: what pybind11 writes: (as the type of a parameter, as the type of a result)
_SIMPLE = {
    "numpy.ndarray[numpy.float64]": ("ArrayLike", _ARRAY),
    "numpy.ndarray[numpy.int64]": ("ArrayLike", "NDArray[int64]"),
    "numpy.ndarray[numpy.uint64]": ("ArrayLike", "NDArray[uint64]"),
    "numpy.ndarray[numpy.int32]": ("ArrayLike", "NDArray[int32]"),
    "numpy.ndarray[numpy.uint32]": ("ArrayLike", "NDArray[uint32]"),
    "numpy.ndarray[numpy.uint8]": ("ArrayLike", "NDArray[uint8]"),
    "numpy.ndarray[bool]": ("ArrayLike", "NDArray[bool_]"),
    "numpy.ndarray": ("ArrayLike", "NDArray[Any]"),
    "object": ("Any", "Any"),
    "handle": ("Any", "Any"),
    "function": ("Callable[..., Any]", "Callable[..., Any]"),
    "Callable": ("Callable[..., Any]", "Callable[..., Any]"),
    "dict": ("dict[str, Any]", "dict[str, Any]"),
    "list": ("Sequence[Any]", "list[Any]"),
    "tuple": ("tuple[Any, ...]", "tuple[Any, ...]"),
    "iterator": ("Iterator[Any]", "Iterator[Any]"),
    "Iterator": ("Iterator[Any]", "Iterator[Any]"),
    "Iterable": ("Iterable[Any]", "Iterable[Any]"),
    "Sequence": ("Sequence[Any]", "Sequence[Any]"),
    "iterable": ("Iterable[Any]", "Iterable[Any]"),
    "sequence": ("Sequence[Any]", "Sequence[Any]"),
    "buffer": ("bytes", "bytes"),
    "fractions.Fraction": ("Fraction | float | str", "Fraction"),
    "os.PathLike": ("str | os.PathLike[str]", "Path"),
}
_PLAIN = {"int", "float", "bool", "str", "bytes", "complex", "None", "type"}
_FLOAT_OR_ARRAY = f"float | {_ARRAY}"


class Unreadable(Exception):
    """A type that has no Python name."""


def _split(text, separator=","):
    """The parts of `text` between separators outside brackets and quotes."""
    parts, depth, begin, quote, i = [], 0, 0, "", 0
    while i < len(text):
        c = text[i]
        if quote:
            i += c == "\\"
            if c == quote:
                quote = ""
        elif c in "'\"":
            quote = c
        elif c in "([{<":
            depth += 1
        elif c in ")]}" or (c == ">" and text[i - 1] != "-"):
            depth -= 1
        elif depth == 0 and text.startswith(separator, i):
            parts.append(text[begin:i])
            begin = i + len(separator)
        i += 1
    parts.append(text[begin:])
    return [part.strip() for part in parts if part.strip()]


class _Names:
    """The names that a stub uses, and so must import."""

    def __init__(self, module):
        self.module = module
        self.used = set()  # words in types
        self.foreign = {}  # module: names of other modules of the package

    def type_of(self, text, is_parameter):
        text = text.strip()
        parts = _split(text, "|")
        if len(parts) > 1:
            return " | ".join(dict.fromkeys(self.type_of(part, is_parameter) for part in parts))
        if text in _SIMPLE:
            return self._use(_SIMPLE[text][0 if is_parameter else 1])
        if text in _PLAIN:
            return text
        generic = re.fullmatch(r"([\w.]+)\[(.*)\]", text, re.DOTALL)
        if generic:
            return self._use(self._generic(generic[1], generic[2], is_parameter))
        if re.fullmatch(r"hodograph(\.\w+)+", text):
            return self._own(text)
        if text.startswith("numpy.ndarray["):
            return self._use("ArrayLike" if is_parameter else "NDArray[Any]")
        raise Unreadable(text)

    def _generic(self, name, inside, is_parameter):
        name = name.rpartition(".")[2]
        if name == "ndarray":
            return "ArrayLike" if is_parameter else "NDArray[Any]"
        if name == "Callable":
            arguments, result = _split(inside)
            if arguments != "...":
                arguments = "[" + ", ".join(self.type_of(one, not is_parameter)
                                            for one in _split(arguments[1:-1])) + "]"
            return f"Callable[{arguments}, {self.type_of(result, is_parameter)}]"
        parts = [self.type_of(one, is_parameter) for one in _split(inside)]
        if name in ("Optional", "Union"):
            if name == "Optional":
                parts.append("None")
            return " | ".join(dict.fromkeys(_split(" | ".join(parts), "|")))
        if name in ("List", "list", "Sequence"):
            if not is_parameter:
                return f"list[{parts[0]}]"
            if parts[0] in ("float", "int", "ArrayLike", "Sequence[float]"):
                return "ArrayLike"
            return f"Sequence[{parts[0]}]"
        if name in ("Dict", "dict"):
            return ("Mapping" if is_parameter else "dict") + f"[{', '.join(parts)}]"
        if name in ("Tuple", "tuple"):
            return f"tuple[{', '.join(parts) or '()'}]"
        if name in ("Set", "set"):
            return f"set[{parts[0]}]"
        if name in ("Iterator", "Iterable"):
            return f"{name}[{parts[0]}]"
        if name in ("Annotated", "FixedSize"):
            return parts[0]
        raise Unreadable(f"{name}[{inside}]")

    def _own(self, text):
        parts = text.split(".")
        count = len(parts) - 1
        while ".".join(parts[:count]) not in sys.modules:
            count -= 1
        home, name = ".".join(parts[:count]), ".".join(parts[count:])
        if home != self.module:
            self.foreign.setdefault(home.removeprefix("hodograph"), set()).add(parts[count])
        return name

    def _use(self, text):
        self.used.update(re.findall(r"[A-Za-z_]\w*", text))
        return text

    def imports(self):
        """The lines that import what the stub uses."""
        lines = []
        collections = sorted(self.used & {"Callable", "Iterable", "Iterator", "Mapping", "Sequence"})
        if "os" in self.used:
            lines.append("import os")
        if collections:
            lines.append(f"from collections.abc import {', '.join(collections)}")
        if "Fraction" in self.used:
            lines.append("from fractions import Fraction")
        if "Path" in self.used and self.module == "hodograph._core":
            raise Unreadable("os.PathLike as a result, whose name is taken by hodograph.Path")
        typing = sorted(self.used & {"Any", "ClassVar", "overload"})
        if typing:
            lines.append(f"from typing import {', '.join(typing)}")
        scalars = sorted(self.used & {"float64", "int64", "uint64", "int32", "uint32", "uint8",
                                      "bool_"})
        if scalars:
            lines += ["", f"from numpy import {', '.join(scalars)}"]
        numpy_typing = sorted(self.used & {"ArrayLike", "NDArray"})
        if numpy_typing:
            lines += [] if scalars else [""]
            lines.append(f"from numpy.typing import {', '.join(numpy_typing)}")
        if self.foreign:
            lines.append("")
        for home, names in sorted(self.foreign.items()):
            lines += _import_list(home, sorted(names))
        return lines


def _import_list(home, names):
    line = f"from {home} import {', '.join(names)}"
    if len(line) <= _COLUMNS:
        return [line]
    return [f"from {home} import ("] + [f"    {name}," for name in names] + [")"]


# ---- signatures ----------------------------------------------------------------------------------


class Signature:
    """One overload of a function."""

    def __init__(self, parameters, result):
        self.parameters = parameters  # texts as in Python, with types and defaults
        self.result = result

    def text(self, name):
        return f"def {name}({', '.join(self.parameters)}) -> {self.result}: ..."


def _default(text):
    """A default value as an expression, or ... where it is none."""
    enumerator = re.fullmatch(r"<(\w+)\.(\w+): -?\d+>", text)
    if enumerator:
        return f"{enumerator[1]}.{enumerator[2]}"
    if re.fullmatch(r"(None|True|False|-?[\d.]+(e[+-]?\d+)?|'[^']*'|\[\]|\(\))", text):
        return text
    return "..."


def _signature(line, names, method):
    """The parts of one line that pybind11 wrote: name(parameters) -> result."""
    inside, _, result = line.partition("(")[2].rpartition(") -> ")
    parameters, bare = [], 0
    pieces = _split(inside)
    for index, piece in enumerate(pieces):
        if piece in ("*", "/") or re.fullmatch(r"\*\*?\w+", piece):
            parameters.append(piece + (": Any" if len(piece) > 1 else ""))
            if len(piece) > 1:
                names.used.add("Any")
            continue
        name, _, rest = piece.partition(":")
        type_text, *default = _split(rest, " = ")
        if method and index == 0 and name in ("self", "arg0"):
            parameters.append("self")
            continue
        if keyword.iskeyword(name):
            raise Unreadable(f"the parameter name {name}")
        if re.fullmatch(r"arg\d+", name):
            bare = len(parameters) + 1
        kind = names.type_of(type_text, is_parameter=True)
        text = f"{name}: {kind}"
        if default:
            value = _default(default[0])
            enumerator = re.match(r"([A-Z]\w*)\.", value)
            if enumerator and enumerator[1] not in kind:
                value = "..."
            text += f" = {value}"
        parameters.append(text)
    if bare and not (method and method.startswith("__")):
        parameters.insert(bare, "/")
    return Signature(parameters, names.type_of(result, is_parameter=False))


def _special_cases(signature):
    """The overloads of a vectorised function whose result is known: one number, an array of them."""
    arrays = [i for i, one in enumerate(signature.parameters) if ": ArrayLike" in one]
    if not arrays:
        return []

    def with_type(kind):
        parameters = list(signature.parameters)
        parameters[arrays[0]] = parameters[arrays[0]].replace("ArrayLike", kind)
        return parameters

    many = [re.sub(r" \| None = None$", "", one)
            for one in with_type("Sequence[Any] | NDArray[Any]")]
    return [Signature(with_type("float"), "float"), Signature(many, _ARRAY)]


def _signatures(callable_, names, method="", overloaded=False):
    """The overloads of a bound function, if wanted with those that a type checker tells apart."""
    text = callable_.__doc__ or ""
    lines = text.split("\n")
    if len(lines) > 1 and lines[1].startswith("Overloaded function"):
        found = [re.sub(r"^\d+\. ", "", line) for line in lines if re.match(r"\d+\. \w+\(", line)]
    else:
        found = lines[:1]
    if not found or ") -> " not in found[0]:
        raise Unreadable(f"the docstring {lines[0]!r}, which holds no signature,")
    made = []
    for line in found:
        one = _signature(line, names, method)
        if one.result == _FLOAT_OR_ARRAY and overloaded:
            cases = _special_cases(one)
            if cases:
                names.used.update(("Any", "Sequence"))
                made += cases
                continue
        made.append(one)
    return made


_OTHER = {"__eq__", "__ne__"}  # take any object, says Python
_SKIPPED = {"__doc__", "__module__", "__dict__", "__weakref__", "__getstate__", "__setstate__",
            "__new__", "__members__", "__entries", "__reduce__", "__reduce_ex__", "__annotations__",
            "_pybind11_conduit_v1_"}


def _function_lines(name, function, names, method=""):
    overloads = _signatures(function, names, method, overloaded=True)
    lines = []
    if len(overloads) > 1:
        names.used.add("overload")
    for one in overloads:
        if method in _OTHER:
            one = Signature(["self", "other: object"], "bool")
        elif method.startswith("__") and method != "__init__":
            one.parameters = [re.sub(r"^arg(\d+):", lambda m: "other:" if m[1] == "0" else m[0],
                                     text) for text in one.parameters]
        if method == "__init__":
            one.result = "None"
        if len(overloads) > 1:
            lines.append("@overload")
        lines += _wrapped(one.text(name))
        if method in _OTHER:
            return [line for line in lines if line != "@overload"]
    return lines


def _wrapped(line):
    if len(line) <= _COLUMNS - 4:
        return [line]
    head, _, rest = line.partition("(")
    inside, _, tail = rest.rpartition(") -> ")
    return [f"{head}("] + [f"    {part}," for part in _split(inside)] + [f") -> {tail}"]


# ---- stubs of extension modules ------------------------------------------------------------------


def _is_enum(cls):
    return hasattr(cls, "__members__")


def _enum_lines(cls):
    whole = cls.__qualname__
    lines = [f"class {cls.__name__}:", f"    __members__: ClassVar[dict[str, {whole}]]"]
    lines += [f"    {name}: ClassVar[{whole}]" for name in cls.__members__]
    lines += ["    @property", "    def name(self) -> str: ...",
              "    @property", "    def value(self) -> int: ...",
              "    def __init__(self, value: int) -> None: ...",
              "    def __eq__(self, other: object) -> bool: ...",
              "    def __ne__(self, other: object) -> bool: ...",
              "    def __hash__(self) -> int: ...",
              "    def __int__(self) -> int: ...",
              "    def __index__(self) -> int: ..."]
    return lines


def _class_lines(cls, names):
    if _is_enum(cls):
        names.used.add("ClassVar")
        return _enum_lines(cls)
    bases = [base for base in cls.__bases__ if base.__name__ not in ("pybind11_object", "object")]
    listed = ", ".join(names._own(f"{base.__module__}.{base.__name__}") for base in bases)
    lines = [f"class {cls.__name__}" + (f"({listed})" if listed else "") + ":"]
    for name, member in sorted(cls.__dict__.items(), key=_order):
        if name in _SKIPPED or name.startswith("__pybind11") or type(member).__name__ == "wrapper_descriptor":
            continue
        made = _member_lines(name, member, names)
        if name in ("__copy__", "__deepcopy__"):
            made = [re.sub(r"-> .*: \.\.\.$", f"-> {cls.__qualname__}: ...", line) for line in made]
        lines += [f"    {line}" for line in made]
    if len(lines) == 1:
        lines[0] += " ..."
    return lines


def _order(item):
    name, member = item
    rank = 0 if inspect.isclass(member) else 1 if name == "__init__" else 2
    if rank == 2 and not isinstance(member, property):
        rank = 4 if name.startswith("__") else 3
    return rank, name


def _member_lines(name, member, names):
    if inspect.isclass(member):
        return _class_lines(member, names)
    if name == "__hash__" and member is None:
        names.used.add("ClassVar")
        return ["__hash__: ClassVar[None]  # type: ignore[assignment]"]
    if isinstance(member, property):
        result = _signatures(member.fget, names, method=name)[-1].result
        lines = ["@property", f"def {name}(self) -> {result}: ..."]
        if member.fset is not None:
            kind = _signatures(member.fset, names, method=name)[0].parameters[1].partition(": ")[2]
            lines += [f"@{name}.setter", f"def {name}(self, value: {kind}) -> None: ..."]
        return lines
    if isinstance(member, staticmethod):
        lines = []
        for line in _function_lines(name, member.__func__, names):
            lines += ["@staticmethod", line] if line.startswith("def ") else [line]
        return lines
    if callable(member):
        return _function_lines(name, member, names, method=name)
    names.used.add("ClassVar")
    return [f"{name}: ClassVar[{_value_type(member, names)}]"]


def _value_type(value, names):
    kind = type(value)
    if kind.__module__ == "builtins":
        return kind.__name__
    if kind.__name__ == "ndarray":
        return names._use(_ARRAY)
    return names._own(f"{kind.__module__}.{kind.__name__}")


def _module_stub(module):
    """The stub of an extension module."""
    names = _Names(module.__name__)
    bodies, problems = [], []
    for name, member in sorted(vars(module).items(), key=lambda item: item[0]):
        if name.startswith("__") and name != "__version__":
            continue
        try:
            if inspect.isclass(member):
                if member.__module__ != module.__name__:
                    continue
                bodies.append((0, [""] + _class_lines(member, names)))
            elif inspect.ismodule(member):
                continue
            elif callable(member):
                bodies.append((2, _function_lines(name, member, names)))
            elif _is_enum(type(member)):
                continue  # an enumerator beside its type
            else:
                bodies.append((1, [f"{name}: {_value_type(member, names)}"]))
        except Unreadable as error:
            problems.append(f"{module.__name__}.{name}: {error} has no Python name")
    if problems:
        raise Unreadable("\n".join(problems))
    bodies.sort(key=lambda item: item[0])
    imports = names.imports()
    text = _HEADER + "\n" + "\n".join(imports) + ("\n" if imports else "")
    previous = None
    for kind, lines in bodies:
        if kind != previous:
            text += "\n"
            lines = lines[1:] if lines and not lines[0] else lines
        previous = kind
        text += "\n".join(lines) + "\n"
    return text


def _package_stub(package):
    """__init__.pyi: where every public name is from, also of those that are loaded when used."""
    homes = {}
    for name in package.__all__:
        if name == "__version__":
            homes.setdefault("_core", []).append(name)
            continue
        member = getattr(package, name)
        if inspect.ismodule(member):
            homes.setdefault("", []).append(name)
            continue
        home = getattr(member, "__module__", None) or ""
        for module in _modules(package):
            if vars(module).get(name) is member:
                home = module.__name__
                break
        homes.setdefault(home.removeprefix("hodograph").lstrip("."), []).append(name)
    lines = [_HEADER.rstrip("\n"), ""]
    for home, names in sorted(homes.items()):
        lines += _import_list(f".{home}", [f"{name} as {name}" for name in sorted(names)])
    lines += ["", "__all__ = ["] + [f'    "{name}",' for name in sorted(package.__all__)] + ["]"]
    return "\n".join(lines) + "\n"


# ---- the list of public names --------------------------------------------------------------------


def _python_signature(function):
    """The signature of a function written in Python, in one line."""
    signature = inspect.signature(function)
    parts, kinds = [], [one.kind for one in signature.parameters.values()]
    for one in signature.parameters.values():
        if one.kind is one.KEYWORD_ONLY and "*" not in parts and one.VAR_POSITIONAL not in kinds:
            parts.append("*")
        text = {one.VAR_POSITIONAL: "*", one.VAR_KEYWORD: "**"}.get(one.kind, "") + one.name
        if one.annotation is not one.empty:
            text += f": {_annotation(one.annotation)}"
        if one.default is not one.empty:
            text += f" = {_default(repr(one.default))}"
        parts.append(text)
        if one.kind is one.POSITIONAL_ONLY and kinds.count(one.kind) == len(parts):
            parts.append("/")
    result = signature.return_annotation
    return f"({', '.join(parts)})" + ("" if result is signature.empty
                                      else f" -> {_annotation(result)}")


def _annotation(annotation):
    """A type as it stands in the source."""
    if isinstance(annotation, str):
        return annotation
    if isinstance(annotation, typing.ForwardRef):
        return annotation.__forward_arg__
    return "None" if annotation is None else getattr(annotation, "__name__", str(annotation))


def _list_of_class(qualified, cls):
    lines = []
    if issubclass(cls, BaseException) or not _is_bound(cls):
        lines.append(f"class {qualified}{_python_signature(cls)}")
    else:
        lines.append(f"class {qualified}")
    members = {}
    for base in reversed(cls.__mro__):
        if base.__module__.startswith("hodograph"):
            members.update(vars(base))
    if _is_enum(cls):
        lines = [f"enum {qualified}"]
        return lines + [f"{qualified}.{name}" for name in cls.__members__]
    if issubclass(cls, enum.Enum):
        return lines + [f"{qualified}.{one.name}" for one in cls]
    names = _Names(cls.__module__)
    fields = getattr(cls, "__annotations__", {})
    lines += [f"{qualified}.{name}: {_annotation(kind)}" for name, kind in fields.items()
              if not name.startswith("_")]
    for name, member in sorted(members.items()):
        if (name.startswith("_") and name != "__init__") or name in fields:
            continue
        if type(member).__name__ == "wrapper_descriptor":
            continue
        if inspect.isclass(member):
            lines += _list_of_class(f"{qualified}.{name}", member)
        elif _is_bound(cls):
            if name == "__init__" or not isinstance(member, (property, staticmethod)):
                if not callable(member):
                    lines.append(f"{qualified}.{name}: {_value_type(member, names)}")
                    continue
                function = member
            elif isinstance(member, property):
                result = _signatures(member.fget, names, method=name)[-1].result
                lines.append(f"{qualified}.{name}: {result}")
                continue
            else:
                function = member.__func__
            lines += [_listed(f"{qualified}.{name}", one)
                      for one in _signatures(function, names, method=name)]
        elif isinstance(member, property):
            kind = inspect.signature(member.fget).return_annotation
            lines.append(f"{qualified}.{name}: {_annotation(kind)}")
        elif isinstance(member, (staticmethod, classmethod)):
            lines.append(f"{qualified}.{name}{_python_signature(getattr(cls, name))}")
        elif callable(member) and name != "__init__":
            lines.append(f"{qualified}.{name}{_python_signature(member)}")
    return lines


def _is_bound(cls):
    return any(base.__name__ == "pybind11_object" for base in cls.__mro__)


def _listed(name, signature):
    parameters = [one for one in signature.parameters if one != "self"]
    return f"{name}({', '.join(parameters)}) -> {signature.result}"


def _list_of(namespace, prefix):
    lines = []
    for name in sorted(namespace.__all__):
        member = getattr(namespace, name)
        qualified = f"{prefix}.{name}"
        if inspect.ismodule(member):
            continue
        if inspect.isclass(member):
            lines += _list_of_class(qualified, member)
        elif inspect.isfunction(member):
            lines.append(qualified + _python_signature(member))
        elif callable(member):
            names = _Names(member.__module__ or "hodograph")
            lines += [_listed(qualified, one) for one in _signatures(member, names)]
        else:
            lines.append(f"{qualified}: {type(member).__name__}")
    return lines


def _public_list(package):
    lines = _list_of(package, "hodograph")
    for folder in pkgutil.iter_modules(package.__path__):
        if folder.ispkg and not folder.name.startswith("_"):
            module = importlib.import_module(f"hodograph.{folder.name}")
            if hasattr(module, "__all__"):
                lines += _list_of(module, module.__name__)
    return ("# Every public name of the Python package, with its signature; written by tools/make_stubs. A\n"
            "# change here is a change of the interface: say so in CHANGELOG.md.\n"
            + "\n".join(lines) + "\n")


# ---- all of them ---------------------------------------------------------------------------------


def _modules(package):
    """The modules of the package that were built, extension modules first."""
    found = []
    for module in pkgutil.iter_modules(package.__path__):
        if not module.ispkg:
            found.append(importlib.import_module(f"hodograph.{module.name}"))
    return sorted(found, key=lambda module: (not _is_extension(module), module.__name__))


def _is_extension(module):
    return (module.__file__ or "").endswith(".so")


def texts():
    """{file: what it should hold}."""
    import hodograph
    made = {_PACKAGE / "__init__.pyi": _package_stub(hodograph)}
    problems = []
    for module in _modules(hodograph):
        if _is_extension(module):
            try:
                file = _PACKAGE / (module.__name__.rpartition(".")[2] + ".pyi")
                made[file] = _module_stub(module)
            except Unreadable as error:
                problems.append(str(error))
    if problems:
        raise Unreadable("\n".join(problems))
    made[_LIST] = _public_list(hodograph)
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    arguments = parser.parse_args()
    try:
        wanted = texts()
    except Unreadable as error:
        print(error, file=sys.stderr)
        return 1
    status = 0
    for path, text in wanted.items():
        there = path.read_text(encoding="utf-8") if path.exists() else ""
        if there == text:
            continue
        name = path.relative_to(_ROOT)
        if not arguments.check:
            path.write_text(text, encoding="utf-8")
            print(f"wrote {name}")
            continue
        status = 1
        print(f"{name} is not what was built; run tools/make_stubs and look at the difference:")
        lines = difflib.unified_diff(there.splitlines(), text.splitlines(), "there", "built",
                                     lineterm="", n=0)
        print("\n".join(list(lines)[:60]))
    return status


if __name__ == "__main__":
    sys.exit(main())
