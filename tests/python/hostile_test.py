#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public function, constructor and method with what does not belong there.

The signatures are read off the docstrings. For each overload arguments are found that work; then
each argument in turn is replaced by everything that is wrong: numbers that are none, arrays of
other shapes, types and layouts, other objects. Each extension module is gone over in a process of
its own, so that a crash or a hang is a failure that names the call. What is asked:

- no crash, no hang, and nothing raised but TypeError, ValueError (HodographError) and what says
  that memory or an index does not suffice;
- a HodographError with a sentence and a code;
- no result that is not a number, where no argument is infinite or not a number;
- layouts of the same numbers (strides, read-only, lists) make no difference.
"""

from __future__ import annotations

import argparse
import faulthandler
import math
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
from fractions import Fraction

import numpy as np

import hodograph
import samples

MODULES = ("_core", "_orbit", "_rational", "_control", "_cad", "_requests", "_certify")
ALLOWED = (TypeError, ValueError, IndexError, MemoryError)
SLOW = 120.0  # seconds a call may take, on a busy machine

# Calls that this test leaves out, and why.
LEFT_OUT = {
    "answer_lines": "runs requests until it is told to stop: requests_test",
    "tracking_ascent": "seconds a call, the solver's own limits: control_test",
    "continue_to_period": "up to a minute a call for a far period: orbit_test",
    "largest_free_factor": "seconds a call: surfaces_test",
    "self_distance subdivisions": "the limit of the work itself: 2^31 is asked for, and done",
    "correct_symmetric_orbit": "seconds a call for wild guesses: orbit_test",
    "least_peak_curvature_of_speeds": "most of a second a call: climbs_and_loops_test",
    "follow": "as tracking_ascent",
    "RecedingHorizon.plan": "as tracking_ascent",
    "powered_ascent": "as tracking_ascent",
    "powered_ascent_along_path": "as tracking_ascent",
}

NAN, INF = math.nan, math.inf
FLOATS = [NAN, INF, -INF, 0.0, -0.0, -1.0, 1e308, -1e308, 5e-324, None, "x", "1", True, 10**400,
          [], [1.0, 2.0], np.float32(0.5), np.array(0.5), np.array([0.5]), 1j, b"1", object(), {}]
INTEGERS = [-1, 0, 2**31, 2**32, 2**63, 2**64, -2**63, 10**30, 1.5, NAN, INF, None, "3", True, [],
            np.int8(3), np.array(3), np.array([3]), 1j, object()]
TEXTS = ["", "\0", "x" * 5000, "\ud800", "\u2028", "'\"\\<>&", None, 1, b"bytes", [], object()]
THINGS = [None, 0, 1.5, "x", [], {}, (), object(), np.zeros(3), int, NAN]


def garbage_arrays(good):
    """Arrays that are wrong, or unusual, in place of one that is right."""
    good = np.asarray(good, dtype=float)
    yield from (None, "x", "1", b"x", {}, object(), [], [[]], [[], []], (), NAN, INF, -INF, 1e308,
                0.0, True, 1j, [None], ["a"], [1, [2, 3]], np.array("x"), np.array(object()),
                np.array([1 + 1j]), np.zeros(0), np.zeros((0, 2)), np.zeros((0, 3)),
                np.zeros((2, 0)), np.zeros((1, 1, 1, 1)), np.zeros((3, 4, 5)), [10**400],
                np.array(["1", "2"]), np.array([np.datetime64("2020-01-01")]), range(3), {1, 2})
    for value in (NAN, INF, -INF, 1e308, -1e308, 5e-324, 0.0):
        yield np.full(good.shape, value)
        if good.size > 1:
            one = good.copy()
            one.flat[-1] = value
            yield one
    yield np.concatenate([good.ravel(), [1.0]])
    yield good.ravel()[:-1]
    yield good[None]
    yield good[..., None]
    yield good.T
    yield np.zeros_like(good, dtype=bool)
    yield np.zeros_like(good, dtype=np.uint8)
    yield good.astype(np.float32)
    yield good.astype(object)
    yield -good


def layouts(good):
    """The same numbers, laid out in other ways."""
    good = np.asarray(good, dtype=float)
    yield good.tolist()
    spread = np.full(tuple(2 * n for n in good.shape), 7.0)
    spread[tuple(slice(None, None, 2) for _ in good.shape)] = good
    yield spread[tuple(slice(None, None, 2) for _ in good.shape)]
    if good.ndim:
        yield np.ascontiguousarray(good[::-1])[::-1]
        yield np.asfortranarray(good)
    fixed = good.copy()
    fixed.flags.writeable = False
    yield fixed
    yield good.astype(">f8")
    yield good.astype(np.longdouble)


# -- signatures

def split(text, at=","):
    """The parts between separators that stand in no bracket."""
    parts, depth, begin, quote = [], 0, 0, ""
    for i, c in enumerate(text):
        if quote:
            quote = "" if c == quote else quote
        elif c in "'\"":
            quote = c
        elif c in "([{<":
            depth += 1
        elif c in ")]}" or (c == ">" and text[i - 1] != "-"):
            depth -= 1
        elif c == at and depth == 0:
            parts.append(text[begin:i].strip())
            begin = i + 1
    tail = text[begin:].strip()
    return parts + [tail] if tail else parts


class Parameter:
    def __init__(self, text, keyword):
        left = split(text, "=")
        name, _, kind = left[0].partition(":")
        self.name, self.kind, self.keyword = name.strip(), kind.strip(), keyword
        self.optional = len(left) > 1


def signatures(name, doc):
    """The parameters of every overload."""
    for line in (doc or "").splitlines():
        found = re.match(rf"(?:\d+\. )?{re.escape(name)}\((.*)\) -> ", line)
        if not found or found.group(1) == "*args, **kwargs":
            continue
        keyword, parameters = False, []
        for part in split(found.group(1)):
            if part == "*":
                keyword = True
            elif not part.startswith("*"):
                parameters.append(Parameter(part, keyword))
        yield parameters


# -- arguments that work

class Supply:
    """Values by the name of their class."""

    def __init__(self):
        self.by_name = {}
        heap = [value for root in samples.ROOTS[:1] for value in root()]
        for root in samples.ROOTS[1:]:
            if root is not samples.of_control:
                heap.extend(root())
        if "ReferencePath" in hodograph.__all__:
            path = samples.planar()
            heap += [hodograph.ReferencePath(path), hodograph.FollowStart(0.0, speed=1.0),
                     hodograph.AscentReference.gateway(), hodograph.ascent_starts()[0]]
        while heap:
            value = heap.pop(0)
            module = type(value).__module__ or ""
            if module.startswith("hodograph") and not isinstance(value, Exception):
                known = self.by_name.setdefault(type(value).__name__, [])
                if len(known) >= 4:
                    continue
                known.append(value)
                for name in dir(type(value)):
                    if not name.startswith("_") and not callable(getattr(type(value), name)):
                        heap.append(getattr(value, name))
            elif isinstance(value, (list, tuple)):
                heap.extend(value[:4])

    def choices(self, parameter):
        kind, name = parameter.kind, parameter.name
        optional = re.fullmatch(r"Optional\[(.*)\]", kind)
        if optional:
            kind = optional.group(1)
        listed = re.fullmatch(r"(?:List|Sequence|Iterable)\[(.*)\]", kind)
        union = re.fullmatch(r"Union\[(.*)\]", kind)
        if union:
            kind = split(union.group(1))[0]
            listed = re.fullmatch(r"(?:List|Sequence|Iterable)\[(.*)\]", kind)
        if "ndarray" in kind:
            return "array", [0.5]
        if kind == "float":
            return "float", [0.5, 1.0, 3.0, 0.1, 20.0]
        if kind == "int":
            return "int", [1, 0, 2, 3, 20]
        if kind == "bool":
            return "thing", [True]
        if kind == "str":
            return "text", ["name", "t", "(t, 1, 0)", "+z", "{}", "m"]
        if "PathLike" in kind:
            return "file", [os.path.join(os.getcwd(), "made.obj")]
        if kind == "fractions.Fraction":
            return "fraction", [Fraction(1, 2), Fraction(0), Fraction(2)]
        if kind == "dict":
            return "thing", [{}]
        if kind in ("function", "Callable"):
            return "thing", [lambda *a: None]
        if listed:
            inner = Parameter(f"{name}: {listed.group(1)}", False)
            if inner.kind == "fractions.Fraction":
                return "list", [[Fraction(1), Fraction(0), Fraction(0)]]
            _, values = self.choices(inner)
            return "list", [values[:2], values[:1], values, []]
        found = self.by_name.get(kind.split(".")[-1])
        if found:
            return "thing", found
        kinds = kind.split(".")[-2:]
        for path in (kinds[-1:], kinds):
            value = hodograph
            for part in path:
                value = getattr(value, part, None)
            if value is not None and samples.is_enum(value):
                return "thing", list(value.__members__.values())
        return "thing", [None]


SHAPES = [(), (2,), (3,), (4,), (6,), (5,), (4, 2), (4, 3), (2, 3), (2, 2), (3, 3), (5, 3),
          (4, 4), (1,), (4, 1), (4, 2, 2), (4, 3, 4)]


def array_of(shape, seed=0):
    if shape == ():
        return np.array(0.5)
    grid = np.arange(1.0, 1.0 + np.prod(shape)).reshape(shape)
    bent = grid + 0.3 * np.sin(1.7 * grid + seed)
    return bent / bent.max() if len(shape) == 1 else bent + (3.0 * seed if len(shape) < 2 else 0)


class Hostile:
    def __init__(self, module):
        self.module = module
        self.supply = Supply()
        self.findings = []
        self.calls = self.working = self.overloads = 0
        self.idle = []

    def attempt(self, label, call, arguments, named):
        """What a call gives: (result, None) or (None, exception)."""
        print(label, file=sys.stderr, flush=True)
        faulthandler.dump_traceback_later(SLOW, exit=True)  # a call that hangs ends the process
        began = time.monotonic()
        self.calls += 1
        try:
            result, error = call(*arguments, **named), None
        except BaseException as raised:  # noqa: B902 - judged below
            result, error = None, raised
        took = time.monotonic() - began
        faulthandler.cancel_dump_traceback_later()
        if took > 0.5 * SLOW:
            self.findings.append(f"{label}: took {took:.1f} s")
        if error is not None:
            self.judge(label, error)
        return result, error

    def judge(self, label, error):
        if not isinstance(error, ALLOWED):
            self.findings.append(f"{label}: raised {type(error).__name__}: {str(error)[:200]}")
        elif isinstance(error, hodograph.HodographError):
            if not error.code or len(str(error)) < 8:
                self.findings.append(f"{label}: {error.code!r}, {str(error)!r}")
        elif not str(error):
            self.findings.append(f"{label}: {type(error).__name__} without words")

    def found(self, call, label, parameters):
        """Arguments that work: (values by name, result), or None."""
        required = [p for p in parameters if not p.optional]
        kinds = [self.supply.choices(p) for p in required]
        shapes = {p.name: 0 for p in required}
        picks = {p.name: 0 for p in required}
        values = {}
        for turn in range(90):
            for index, (parameter, (kind, options)) in enumerate(zip(required, kinds)):
                if kind == "array":
                    values[parameter.name] = array_of(SHAPES[shapes[parameter.name]], index)
                else:
                    values[parameter.name] = options[picks[parameter.name] % len(options)]
            result, error = self.attempt(f"{label} (seeking)", call, *self.split(required, values))
            if error is None:
                return values, result
            wanted = re.match(r"(\w+).* should have the shape \(([^)]*)\)", str(error))
            name = wanted.group(1) if wanted else getattr(error, "quantity", "")
            if wanted and name in shapes:
                numbers = [part.strip() for part in wanted.group(2).split(",") if part.strip()]
                shape = tuple(int(n) if n.isdigit() else 4 for n in numbers)
                if shape in SHAPES and SHAPES.index(shape) != shapes[name]:
                    shapes[name] = SHAPES.index(shape)
                    continue
            movable = [p.name for p, (kind, options) in zip(required, kinds)
                       if kind == "array" or len(options) > 1]
            if not movable:
                return None
            moved = name if name in movable else movable[turn % len(movable)]
            if moved in shapes and kinds[[p.name for p in required].index(moved)][0] == "array":
                shapes[moved] = (shapes[moved] + 1) % len(SHAPES)
            else:
                picks[moved] += 1
        return None

    @staticmethod
    def split(parameters, values):
        unnamed = [values[p.name] for p in parameters if not p.keyword]
        return unnamed, {p.name: values[p.name] for p in parameters if p.keyword}

    def wrong(self, parameter, good):
        kind, options = self.supply.choices(parameter)
        if kind == "array":
            return garbage_arrays(good if good is not None else array_of((3,)))
        if kind == "float":
            return FLOATS
        if kind == "int":
            return INTEGERS
        if kind in ("text", "file"):
            return TEXTS + ["/no/such/folder/file.obj", os.getcwd(), "made", ".", "no.obj"][
                :5 if kind == "file" else 0]
        if kind == "fraction":
            return FLOATS + ["1/0", "a", Fraction(10**40, 3), "9" * 50]
        if kind == "list":
            return THINGS + [[None], [[]], [object()] * 3, ["x"], [NAN], [options[0]], "abc",
                             iter([]), [1, 2, 3], {1: 2}]
        return THINGS + [[options[0]]]

    def go_over(self, label, call, doc, name, myself=()):
        for number, parameters in enumerate(signatures(name, doc)):
            if myself or (parameters and parameters[0].name == "self"):
                parameters = parameters[1:]
            text = label if number == 0 else f"{label}#{number + 1}"
            self.overloads += 1
            found = self.found(call, text, parameters)
            if found is None:
                self.idle.append(text)
                found = {p.name: self.supply.choices(p)[1][0] for p in parameters
                         if not p.optional}, None
            else:
                self.working += 1
                self.look(text, found[1])
            values, result = found
            for parameter in parameters:
                self.spoil(text, call, parameters, values, parameter, result)

    def spoil(self, label, call, parameters, values, parameter, result):
        if f"{label} {parameter.name}" in LEFT_OUT:
            return
        good = values.get(parameter.name)
        used = [p for p in parameters if p.name in values or p is parameter]
        # A parameter that is not keyword-only may follow others that are left out.
        for p in used:
            if p.optional and p is parameter:
                p.keyword = True
        for i, value in enumerate(self.wrong(parameter, good)):
            shown = f"{label} {parameter.name}={short(value)}"
            made, _ = self.attempt(shown, call, *self.split(used, {**values, parameter.name: value}))
            if made is not None and is_finite(value):
                self.look(shown, made)
        if self.supply.choices(parameter)[0] == "array" and result is not None and good is not None:
            for value in layouts(good):
                shown = f"{label} {parameter.name} as {short(value)}"
                made, error = self.attempt(shown, call,
                                           *self.split(used, {**values, parameter.name: value}))
                if error is not None:
                    self.findings.append(f"{shown}: {type(error).__name__} {str(error)[:120]}")
                elif not alike(made, result):
                    self.findings.append(f"{shown}: another result")

    def look(self, label, result, depth=3):
        """Nothing in a result may be no number."""
        if isinstance(result, (float, complex)) and result != result:
            self.findings.append(f"{label}: NaN")
        elif isinstance(result, np.ndarray):
            if result.dtype.kind in "fc" and np.isnan(result).any():
                self.findings.append(f"{label}: NaN in an array")
        elif isinstance(result, (list, tuple)) and depth:
            for item in result[:50]:
                self.look(label, item, depth - 1)
        elif type(result).__module__.startswith("hodograph") and depth:
            repr(result)
            for name in dir(type(result)):
                if not name.startswith("_") and not callable(getattr(type(result), name)):
                    self.look(f"{label}.{name}", getattr(result, name), depth - 1)

    def run(self, part, parts):
        """Goes over every `parts`-th public name, from `part` on."""
        names = [n for n in hodograph.__all__
                 if getattr(getattr(hodograph, n), "__module__", "") == f"hodograph.{self.module}"]
        for name in sorted(names)[part::parts]:
            value = getattr(hodograph, name)
            if name in LEFT_OUT or samples.is_enum(value):
                continue
            if not isinstance(value, type):
                self.go_over(name, value, value.__doc__, name)
                continue
            self.go_over(name, value, value.__init__.__doc__, "__init__", (None,))
            for attribute in dir(value):
                method = getattr(value, attribute)
                if attribute.startswith("_") or not callable(method) or isinstance(method, type):
                    continue
                if type(vars(value).get(attribute)).__name__ == "staticmethod":
                    self.go_over(f"{name}.{attribute}", method, method.__doc__, attribute)
                    continue
                for one in self.supply.by_name.get(name, [])[:1]:
                    self.go_over(f"{name}.{attribute}", getattr(one, attribute), method.__doc__,
                                 attribute, (one,))


def short(value):
    if isinstance(value, np.ndarray):
        return f"array{value.shape} {value.dtype} {value.ravel()[:3]}".replace("\n", " ")
    return ascii(value)[:40]


def is_finite(value):
    try:
        return bool(np.all(np.abs(np.asarray(value, dtype=float)) < 1e150))
    except (TypeError, ValueError, OverflowError):
        return not isinstance(value, (list, tuple))


def alike(a, b):
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return np.array_equal(a, b, equal_nan=True)
    if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
        return len(a) == len(b) and all(alike(x, y) for x, y in zip(a, b))
    return type(a) is type(b) and (a == b) is not False


def work(module, part, parts):
    """One process' share; the findings go to standard output."""
    resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    warnings.simplefilter("ignore")  # what NumPy thinks of complex numbers and the like
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        hostile = Hostile(module)
        hostile.run(part, parts)
        os.chdir("/")
    for finding in hostile.findings:
        print("finding:", finding.encode("ascii", "backslashreplace").decode())
    for label in hostile.idle:
        print("idle:", label)
    print(f"calls: {hostile.calls} {hostile.working} {hostile.overloads}", flush=True)


class EveryCall(unittest.TestCase):
    def go(self, module, part=0, parts=1):
        if not any(getattr(getattr(hodograph, n), "__module__", "") == f"hodograph.{module}"
                   for n in hodograph.__all__):
            return
        with tempfile.TemporaryFile("w+") as log:
            try:
                done = subprocess.run(
                    [sys.executable, "-B", __file__, "--module", module, "--part", str(part),
                     "--parts", str(parts)], stdout=subprocess.PIPE, stderr=log, text=True,
                    timeout=900, check=False, env={**os.environ, "PYTHONPATH": os.pathsep.join(
                        p for p in sys.path if p)})
                ended, printed = f"ended with {done.returncode}", done.stdout
            except subprocess.TimeoutExpired as late:
                ended, printed = "did not end", (late.stdout or b"").decode()
            log.seek(0)
            lines = log.read().splitlines()
            lines = [line for line in lines if " " not in line[:1] and "hread 0x" not in line]
        findings = [line for line in printed.splitlines() if line.startswith("finding:")]
        if "calls:" not in printed:
            findings.append(f"the process {ended} in: {lines[-1:]}")
        self.assertEqual(findings, [], "\n".join(findings[:60]))
        calls, working, overloads = map(int, printed.split("calls:")[1].split())
        self.assertGreater(calls, 10 * overloads)
        self.assertGreaterEqual(working, 0.6 * overloads, printed)

    def test_core(self):
        for part in range(4):
            with self.subTest(part=part):
                self.go("_core", part, 4)

    def test_orbit(self):
        self.go("_orbit")

    def test_rational(self):
        self.go("_rational")

    def test_control(self):
        self.go("_control")

    def test_cad(self):
        self.go("_cad")

    def test_requests(self):
        self.go("_requests")

    def test_certify(self):
        self.go("_certify")


if __name__ == "__main__":
    if "--module" in sys.argv:
        parser = argparse.ArgumentParser()
        parser.add_argument("--module", required=True)
        parser.add_argument("--part", type=int, default=0)
        parser.add_argument("--parts", type=int, default=1)
        given = parser.parse_args()
        work(given.module, given.part, given.parts)
    else:
        unittest.main()
