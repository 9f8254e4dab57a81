# SPDX-License-Identifier: MIT
"""The requests of ``hodograph batch``, answered inside the interpreter.

docs/requests.md describes each request. The answers are those of the program, byte for byte.
"""

from __future__ import annotations

import atexit
import importlib
import json
import weakref
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from ._core import Path, to_json
from .errors import HodographError

WAYS = ("report", "skip", "raise")
_pools: weakref.WeakSet = weakref.WeakSet()


def _module():
    try:
        return importlib.import_module("hodograph._requests")
    except ModuleNotFoundError as error:
        raise ImportError("hodograph.answer needs a build with the program (CLI11 and "
                          "nlohmann-json); this one was made without") from error


@atexit.register
def _close_pools() -> None:
    for pool in list(_pools):
        pool.close()


def _plain(value: Any) -> Any:
    """What JSON has for arrays, numbers of NumPy, and paths (their documents)."""
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Path):
        return json.loads(to_json(value))
    raise TypeError(f"a request cannot hold {type(value).__name__}")


def request_line(request: dict | str | bytes) -> bytes:
    """A request as one line of ``hodograph batch``, without its end.

    Dictionaries may hold arrays, and paths where a ``document`` is wanted.
    """
    if isinstance(request, bytes):
        return request
    if isinstance(request, str):
        return request.encode("utf-8", "surrogateescape")
    return json.dumps(request, default=_plain).encode("ascii")


def answered(line: bytes) -> tuple[str, tuple | None]:
    """The answer to one line as text, and the parts of its fault or None."""
    return _module().answered(line)


def _error(fault: tuple, place: str = "") -> HodographError:
    sentence, code, index, quantity, value, bound = fault
    return HodographError(place + sentence, code, index, quantity, value, bound)


def _check(on_fault: str, ways: tuple[str, ...]) -> None:
    if on_fault not in ways:
        raise ValueError(f"on_fault should be one of {', '.join(ways)}; got {on_fault!r}")


def answer(request: dict | str | bytes, *, on_fault: str = "raise") -> dict:
    """The answer to one request: ``{"request": ..., "ok": True, "result": {...}}``.

    Args:
        request: a dictionary, or its JSON text; docs/requests.md describes the members of each
            kind. Arrays may stand for lists, and a Path for a path document.
        on_fault: "raise": HodographError where it cannot be answered; "report": the answer then
            is ``{"ok": False, "fault": {...}}``.

    Numbers are bit for bit those of ``hodograph batch``; what is infinite is None.
    """
    _check(on_fault, ("raise", "report"))
    text, fault = answered(request_line(request))
    if fault is not None and on_fault == "raise":
        raise _error(fault)
    return json.loads(text)


def answer_lines(requests: Iterable[dict | str | bytes], *, jobs: int | None = None,
                 on_fault: str = "report", text: bool = False) -> Iterator[Any]:
    """The answers to many requests, in their order, by several threads.

    Args:
        requests: dictionaries or lines, such as an open file; blank lines are passed over. They are
            read as answers are taken, a few dozen a thread ahead.
        jobs: threads that answer (default: one a core); the answers do not depend on it.
        on_fault: what becomes of a request that cannot be answered: "report": its answer is
            ``{"ok": False, "fault": {...}}``; "skip": it has none; "raise": HodographError, which
            names the line.
        text: the lines of ``hodograph batch`` as they are, instead of dictionaries.

    Returns an iterator; close() it, or take all, to end its threads early.
    """
    _check(on_fault, WAYS)
    module = _module()
    if jobs is None:
        jobs = module.all_cores()
    if isinstance(jobs, bool) or not isinstance(jobs, (int, np.integer)) \
            or not 1 <= jobs <= module.most_jobs:
        raise ValueError(f"jobs should be a whole number from 1 to {module.most_jobs}; got {jobs!r}")
    if isinstance(requests, (str, bytes, dict)):
        raise TypeError("requests should be an iterable of requests; for one there is answer()")
    return _answers(module, requests, int(jobs), on_fault, text)


def _answers(module, requests, jobs, on_fault, text):
    pool = module.LinePool(jobs)
    _pools.add(pool)
    places: list[int] = []  # of the lines in flight, for the sentences of "raise"
    places_read = 0

    def taken(result):
        nonlocal places_read
        line, fault = result
        if on_fault == "raise":
            place = places[places_read]
            places_read += 1
            if places_read > 4096:
                del places[:places_read]
                places_read = 0
            if fault is not None:
                raise _error(fault, f"line {place}: ")
        elif fault is not None and on_fault == "skip":
            return None
        return line if text else json.loads(line)

    try:
        for number, request in enumerate(requests, 1):
            line = request_line(request)
            if not line.strip():
                continue
            while not pool.has_room() or pool.ready():
                one = taken(pool.take())
                if one is not None:
                    yield one
            if on_fault == "raise":
                places.append(number)
            pool.submit(line)
        pool.finish()
        while (last := pool.take()) is not None:
            one = taken(last)
            if one is not None:
                yield one
    finally:
        pool.close()
        _pools.discard(pool)
