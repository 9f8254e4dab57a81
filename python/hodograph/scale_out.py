# SPDX-License-Identifier: MIT
"""Requests, and any other function, on the workers of a ``dask.distributed`` cluster.

Results arrive in order and are those of the serial run, bit for bit: each is computed by one worker
alone, and what a worker that died had computed is computed again by another one.
docs/scale-out.md shows a whole study.
"""

from __future__ import annotations

import contextlib
import json
import logging
import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import Any

from . import __version__, requests as _requests
from .errors import HodographError

_LOOK_S = 1.0  # between looks at whether there still are workers


def _distributed():
    try:
        import distributed
    except ImportError as error:
        raise ImportError("hodograph.scale_out needs dask.distributed, which this Python lacks; "
                          "install it (python3-distributed in Debian)") from error
    return distributed


@contextlib.contextmanager
def _silenced(*loggers: str):
    """Closing a cluster that is just replacing a worker cancels that, of which tornado complains."""
    levels = [logging.getLogger(name).level for name in loggers]
    for name in loggers:
        logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for name, level in zip(loggers, levels):
            logging.getLogger(name).setLevel(level)


@contextlib.contextmanager
def local_cluster(workers: int = 2, *, start_s: float = 120.0) -> Iterator[Any]:
    """A client of a cluster of processes on this machine, each with one thread.

    Nothing but localhost is used, no dashboard is served, the workers' files are in a temporary
    directory, and all is gone when the context ends. A worker that dies is replaced.

    Args:
        workers: the number of processes.
        start_s: how long to wait for all of them, in seconds; TimeoutError beyond.

    As always with processes, a script does this under ``if __name__ == "__main__":``.
    """
    distributed = _distributed()
    with tempfile.TemporaryDirectory(prefix="hodograph-", ignore_cleanup_errors=True) as folder:
        cluster = distributed.LocalCluster(
            n_workers=workers, threads_per_worker=1, processes=True, host="127.0.0.1",
            dashboard_address=None, worker_dashboard_address=None, local_directory=folder,
            memory_limit=0, silence_logs=logging.CRITICAL)
        try:
            client = distributed.Client(cluster, timeout=start_s)
            try:
                client.wait_for_workers(workers, timeout=start_s)
                yield client
            finally:
                client.close(timeout=10)
        finally:
            with _silenced("tornado.application", "asyncio"):
                cluster.close(timeout=30)


def _chunk_results(version: str, function: Callable, items: list) -> list:
    """What a worker does."""
    if version != __version__:
        raise RuntimeError(f"the worker has hodograph {__version__}, the client {version}: the "
                           "results might differ")
    return [function(item) for item in items]


def _result(client, future, without_workers_s: float):
    """The result of a future; TimeoutError where there have been no workers for so long."""
    distributed = _distributed()
    deserted_since = None
    while True:
        try:
            return future.result(timeout=_LOOK_S)
        except (TimeoutError, distributed.TimeoutError):
            if future.done():
                return future.result()  # TimeoutError of the function itself
            if client.status != "running":
                raise RuntimeError("the connection to the cluster is lost") from None
            if client.scheduler_info()["workers"]:
                deserted_since = None
                continue
            now = time.monotonic()
            deserted_since = deserted_since or now
            if now - deserted_since > without_workers_s:
                raise TimeoutError(f"the cluster has had no workers for {without_workers_s:g} s") \
                    from None


def map_in_order(function: Callable[[Any], Any], items: Iterable, client, *, chunk: int = 200,
                 ahead: int | None = None, without_workers_s: float = 60.0) -> Iterator[Any]:
    """``map(function, items)`` on a cluster: results in order, as they are taken.

    Args:
        function: of one item; a function of a module that the workers can import, or anything that
            cloudpickle takes. What it raises is raised here, and ends the work.
        items: read as results are taken.
        client: a ``distributed.Client``.
        chunk: how many items one task has.
        ahead: how many tasks are at the workers at a time (default: four a thread). Memory, here
            and there, is that of their items and results.
        without_workers_s: give up (TimeoutError) where there are no workers for so many seconds.

    A worker that dies is no failure as long as the cluster has or gets others; a chunk at which
    several die in turn raises ``distributed.KilledWorker``.
    """
    if chunk < 1 or (ahead is not None and ahead < 1):
        raise ValueError(f"chunk and ahead should be at least 1; got {chunk} and {ahead}")
    return _mapped(function, iter(items), client, chunk, ahead, without_workers_s)


def _mapped(function, items, client, chunk, ahead, without_workers_s):
    if ahead is None:
        ahead = 4 * max(1, sum(client.nthreads().values()))
    futures: deque = deque()
    try:
        while True:
            while len(futures) < ahead and (part := list(islice(items, chunk))):
                futures.append(client.submit(_chunk_results, __version__, function, part,
                                             pure=False))
            if not futures:
                return
            results = _result(client, futures[0], without_workers_s)
            futures.popleft().release()
            yield from results
    finally:
        if futures and client.status == "running":
            client.cancel(list(futures), force=True)


def _answered(line: bytes) -> tuple[str, tuple | None]:
    return _requests.answered(line)


def answer_lines(requests: Iterable[dict | str | bytes], client, *, on_fault: str = "report",
                 text: bool = False, chunk: int = 200, ahead: int | None = None,
                 without_workers_s: float = 60.0) -> Iterator[Any]:
    """The answers to many requests, in order, by the workers of a cluster.

    The same as ``hodograph.answer_lines(requests, on_fault=..., text=...)``, bit for bit; ``chunk``,
    ``ahead`` and ``without_workers_s`` are those of map_in_order. Files that requests name are read
    by the workers.
    """
    if on_fault not in _requests.WAYS:
        raise ValueError(f"on_fault should be one of {', '.join(_requests.WAYS)}; "
                         f"got {on_fault!r}")
    lines = (line for line in map(_requests.request_line, requests) if line.strip())
    answers = map_in_order(_answered, lines, client, chunk=chunk, ahead=ahead,
                           without_workers_s=without_workers_s)
    return _answers(answers, on_fault, text)


def _answers(answers, on_fault, text):
    with contextlib.closing(answers):
        for number, (line, fault) in enumerate(answers, 1):
            if fault is not None and on_fault == "raise":
                sentence, *parts = fault
                raise HodographError(f"request {number}: {sentence}", *parts)
            if fault is None or on_fault == "report":
                yield line if text else json.loads(line)
