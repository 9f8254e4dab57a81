#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What do a million evaluations cost from Python, against the same in C++?

    bench/python_evaluate.py [build directory]      default: build/release

Both take turns on one path of degree 17 with 1000 segments, in this process and in
bench/python_evaluate.cpp; C++ allocates its results for every run, as Python must, or keeps the memory.
Ratios are of medians.
"""

import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

_COUNT = 1_000_000
_TURNS = 15


def main():
    build = Path(sys.argv[1] if len(sys.argv) > 1 else "build/release").resolve()
    sys.path.insert(0, str(build / "python"))
    import numpy as np

    import hodograph

    with tempfile.TemporaryDirectory() as folder:
        document = Path(folder) / "path.json"
        rival = subprocess.Popen([str(build / "bench" / "python_evaluate"), str(document)], text=True,
                                 stdin=subprocess.PIPE, stdout=subprocess.PIPE)

        def cpp(question):
            rival.stdin.write(question + "\n")
            rival.stdin.flush()
            return float(rival.stdout.readline())

        cpp("position")  # by now the document is there
        path = hodograph.load_document(str(document)).path
        part = np.arange(_COUNT) / _COUNT
        xi = path.xi_begin + (path.xi_end - path.xi_begin) * part
        s = path.arc_length() * part
        questions = {"position": lambda: path.position(xi),
                     "state": lambda: hodograph.evaluate(path, xi),
                     "point at arc length": lambda: path.point_at_arc_length(s)}

        def python(question):
            begin = time.perf_counter()
            questions[question]()
            return time.perf_counter() - begin

        print(f"{_COUNT} points, ns a point   C++  memory kept   Python   Python/C++")
        for question in questions:
            seconds = {"fresh": [], "kept": [], "python": []}
            for _ in range(_TURNS):
                seconds["fresh"].append(cpp(question))
                seconds["kept"].append(cpp(question + ", memory kept"))
                seconds["python"].append(python(question))
            a, b, c = (1e9 / _COUNT * statistics.median(all) for all in seconds.values())
            print(f"  {question:22} {a:8.1f} {b:12.1f} {c:8.1f} {c / a:9.2f}x (kept: {c / b:.2f}x)")
        rival.stdin.close()
        rival.wait()


if __name__ == "__main__":
    main()
