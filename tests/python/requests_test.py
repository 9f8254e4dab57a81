# SPDX-License-Identifier: MIT
"""hodograph.answer and answer_lines: the answers of `hodograph batch`, byte for byte."""

import json
import locale
import os
import pathlib
import re
import subprocess
import sys
import threading
import unittest

import numpy as np

import hodograph

PROGRAM = pathlib.Path(hodograph.__file__).parents[2] / "hodograph"
DOCUMENT = pathlib.Path(__file__).parents[2] / "docs" / "requests.md"
SLOW = ("ascend", "follow", "swarm", "plan", "sweep")  # their own tests run them


def documented():
    """The requests of docs/requests.md that take no time."""
    blocks = re.findall(r"```json request\n(.*?)```", DOCUMENT.read_text(encoding="utf-8"), re.S)
    lines = [json.dumps(json.loads(block)) for block in blocks]
    return [line for line in lines if json.loads(line)["request"] not in SLOW]


def climb(i, **changes):
    return {"request": "climb", "id": i,
            "begin": {"position": [0, 0, 0], "heading": 0.01 * i},
            "end": {"position": [300 + i, 40, 30], "heading": 0.4}, "climb_angle": 0.0977384} | changes


def program(lines, *options):
    done = subprocess.run([PROGRAM, "batch", *options], input="\n".join(lines) + "\n", text=True,
                          encoding="utf-8", errors="surrogateescape", capture_output=True,
                          timeout=60, check=True)
    return done.stdout.splitlines()


class Answers(unittest.TestCase):
    def test_are_those_of_the_program(self):
        lines = documented()
        self.assertGreater(len(lines), 20)
        lines += [json.dumps(climb(i)) for i in range(40)] + ["", "no json", "  ", '{"request": 1}',
                                                              '{"request": "\udcff"}']
        expected = program(lines)
        for jobs in (1, 3, None):
            self.assertEqual(list(hodograph.answer_lines(lines, jobs=jobs, text=True)), expected)
        self.assertEqual(list(hodograph.answer_lines(lines)), [json.loads(x) for x in expected])
        skipped = program(lines, "--on-fault", "skip")
        self.assertLess(len(skipped), len(expected))
        self.assertEqual(list(hodograph.answer_lines(lines, on_fault="skip", text=True)), skipped)
        for line, answer in zip((x for x in lines if x.strip()), expected):
            self.assertEqual(hodograph.answer(line, on_fault="report"), json.loads(answer))

    def test_of_dictionaries_arrays_and_paths(self):
        path = hodograph.planar_spline([[0, 0], [1, 2], [3, 1]])
        answer = hodograph.answer({"request": "evaluate", "document": path,
                                   "xi": np.array([0.0, 0.5]), "id": np.int64(3)})
        self.assertEqual(answer["id"], 3)
        points = [point["position"][0] for point in answer["result"]["points"]]
        self.assertEqual(points, path.position(np.array([0.0, 0.5])).tolist())
        with self.assertRaisesRegex(TypeError, "a request cannot hold set"):
            hodograph.answer({"request": "orbit", "id": {1}})

    def test_faults_are_raised_or_reported(self):
        with self.assertRaises(hodograph.HodographError) as caught:
            hodograph.answer(climb(0, climb_angle=1.5))
        reported = hodograph.answer(climb(0, climb_angle=1.5), on_fault="report")
        self.assertIs(reported["ok"], False)
        error, fault = caught.exception, reported["fault"]
        self.assertEqual(str(error), fault["sentence"])
        for part in ("code", "index", "quantity", "value", "bound"):
            self.assertEqual(getattr(error, part), fault[part])
        self.assertEqual(fault["code"], "no_interpolant")
        lines = ["", json.dumps(climb(0)), json.dumps(climb(1, climb_angle=1.5))]
        answers = hodograph.answer_lines(lines, on_fault="raise")
        self.assertTrue(next(answers)["ok"])
        with self.assertRaisesRegex(hodograph.HodographError, "^line 3: climb angle 1.5"):
            next(answers)
        for nothing in (float("nan"), float("inf")):
            with self.assertRaisesRegex(hodograph.HodographError, "no JSON"):
                hodograph.answer(climb(0, climb_angle=nothing))

    def test_mistakes_in_the_call_are_named(self):
        with self.assertRaisesRegex(ValueError, "on_fault.*'cry'"):
            hodograph.answer(climb(0), on_fault="cry")
        with self.assertRaisesRegex(ValueError, "on_fault.*'stop'"):
            hodograph.answer_lines([], on_fault="stop")
        for jobs in (0, -1, 1.5, True, 10**6):
            with self.assertRaisesRegex(ValueError, "jobs"):
                hodograph.answer_lines([], jobs=jobs)
        for one in ("{}", b"{}", {}):
            with self.assertRaisesRegex(TypeError, "answer\\(\\)"):
                hodograph.answer_lines(one)
        self.assertEqual(list(hodograph.answer_lines([])), [])

    def test_are_read_ahead_a_little_and_can_be_left(self):
        taken = []

        def endless():
            i = 0
            while True:
                taken.append(i)
                yield climb(i % 30)
                i += 1

        answers = hodograph.answer_lines(endless(), jobs=2)
        self.assertEqual([next(answers)["id"] for _ in range(70)], [i % 30 for i in range(70)])
        self.assertLess(len(taken), 70 + 2 * 64 + 3)
        answers.close()
        self.assertEqual(list(answers), [])

        def failing():
            yield climb(0)
            raise KeyError("the source")

        with self.assertRaisesRegex(KeyError, "the source"):
            list(hodograph.answer_lines(failing()))

    def test_do_not_hold_the_lock_nor_depend_on_the_locale(self):
        expected = hodograph.answer(climb(3))
        done = []
        thread = threading.Thread(
            target=lambda: done.extend(hodograph.answer_lines(climb(3) for _ in range(50))))
        thread.start()
        thread.join(30)
        self.assertEqual(done, [expected] * 50)
        with_comma = [name for name in ("de_DE.UTF-8", "fr_FR.UTF-8") if _is_there(name)]
        for name in with_comma:
            before = locale.setlocale(locale.LC_ALL)
            try:
                locale.setlocale(locale.LC_ALL, name)
                self.assertEqual(hodograph.answer(climb(3)), expected)
            finally:
                locale.setlocale(locale.LC_ALL, before)

    def test_end_with_the_interpreter_and_a_fork(self):
        script = ("import hodograph, json, os, sys\n"
                  "request = json.loads(sys.argv[1])\n"
                  "answers = hodograph.answer_lines((request for _ in range(1000)), jobs=2)\n"
                  "next(answers)\n"
                  "child = os.fork()\n"
                  "if child == 0:\n"
                  "    del answers\n"
                  "    ok = hodograph.answer(request)['ok']\n"
                  "    os._exit(0 if ok else 1)\n"
                  "print(os.waitpid(child, 0)[1])\n")
        done = subprocess.run([sys.executable, "-B", "-c", script, json.dumps(climb(0))], text=True,
                              capture_output=True, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "0\n", ""))


def _is_there(name):
    before = locale.setlocale(locale.LC_ALL)
    try:
        locale.setlocale(locale.LC_ALL, name)
    except locale.Error:
        return False
    finally:
        locale.setlocale(locale.LC_ALL, before)
    return True


if __name__ == "__main__":
    os.environ.setdefault("PYTHONDONTWRITEBYTECODE", "1")
    unittest.main()
