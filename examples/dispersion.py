# SPDX-License-Identifier: MIT
"""How the errors of a guidance system disperse a climb: many climbs between perturbed ends, answered
by worker processes under Dask, one of which is killed half-way, and compared with the serial run.

    python3 examples/dispersion.py                     # 10^5 climbs, two workers
    python3 examples/dispersion.py --kind fit --count 10000
    python3 examples/dispersion.py --requests climbs.jsonl    # only writes them, for hodograph batch
"""

import argparse
import hashlib
import json
import os
import signal
import time

import numpy as np

import hodograph
from hodograph import scale_out


def climbs(count):
    """Climbs at 0.1 rad to a gate 3 km away; positions known to 5 m and 20 m, headings to 10 mrad."""
    random = np.random.default_rng(20260101)
    for i in range(count):
        begin, end = random.normal(0, 5, 3), random.normal(0, 20, 3)
        headings = random.normal(0, 0.01, 2)
        yield json.dumps({
            "request": "climb", "id": i, "climb_angle": 0.1,
            "begin": {"position": list(begin), "heading": headings[0]},
            "end": {"position": list(end + [3000, 400, 360]), "heading": 0.4 + headings[1]}})


def fits(count):
    """Fits to a millimetre of a helix whose radius, pitch and phase are uncertain."""
    random = np.random.default_rng(20260101)
    for i in range(count):
        radius, pitch, phase = random.normal([10, 3, 0], [0.1, 0.05, 0.02])
        yield json.dumps({
            "request": "fit", "id": i, "to": 6, "tolerance": 1e-3,
            "formula": f"{radius}*cos(t + {phase}), {radius}*sin(t + {phase}), {pitch}*t"})


class Study:
    """The lengths of the answers, and a fingerprint of every byte of them."""

    def __init__(self):
        self.lengths, self.faults, self.digest = [], 0, hashlib.sha256()

    def add(self, line):
        self.digest.update(line.encode() + b"\n")
        answer = json.loads(line)
        if answer["ok"]:
            self.lengths.append(answer["result"]["arc_length"])
        else:
            self.faults += 1

    def text(self):
        quantiles = np.quantile(self.lengths, [0.01, 0.5, 0.99])
        return (f"{len(self.lengths)} paths, {self.faults} without; length "
                f"{np.mean(self.lengths):.4f} +- {np.std(self.lengths):.4f}, 1 % "
                f"{quantiles[0]:.4f}, median {quantiles[1]:.4f}, 99 % {quantiles[2]:.4f}; SHA-256 "
                f"{self.digest.hexdigest()[:16]}")


def run(answers, count, name, halfway=None):
    study, begin = Study(), time.perf_counter()
    for i, line in enumerate(answers):
        if halfway and i == count // 2:
            halfway()
        study.add(line)
    seconds = time.perf_counter() - begin
    print(f"{name}: {seconds:.1f} s, {count / seconds:.0f}/s\n  {study.text()}", flush=True)
    return study


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    arguments.add_argument("--kind", choices=["climb", "fit"], default="climb")
    arguments.add_argument("--count", type=int, default=100_000)
    arguments.add_argument("--workers", type=int, default=2)
    arguments.add_argument("--chunk", type=int, default=500)
    arguments.add_argument("--requests", metavar="FILE", help="write the requests, and stop")
    chosen = arguments.parse_args()
    made = climbs if chosen.kind == "climb" else fits
    count = chosen.count
    if chosen.requests:
        with open(chosen.requests, "w", encoding="utf-8") as file:
            file.writelines(line + "\n" for line in made(count))
        return 0

    serial = run(hodograph.answer_lines(made(count), jobs=1, text=True), count, "one thread")
    threads = run(hodograph.answer_lines(made(count), jobs=chosen.workers, text=True), count,
                  f"{chosen.workers} threads")
    with scale_out.local_cluster(chosen.workers) as client:
        def kill_one():
            victim = next(iter(client.run(os.getpid).values()))
            os.kill(victim, signal.SIGKILL)
            print(f"  (killed worker {victim})", flush=True)

        cluster = run(scale_out.answer_lines(made(count), client, text=True, chunk=chosen.chunk),
                      count, f"{chosen.workers} workers", kill_one)
    same = serial.digest.digest() == threads.digest.digest() == cluster.digest.digest()
    print("equal, byte for byte" if same else "DIFFERENT")
    return 0 if same else 1


if __name__ == "__main__":
    raise SystemExit(main())
