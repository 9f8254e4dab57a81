# SPDX-License-Identifier: MIT
"""hodograph.scale_out: two workers on this machine, one of them killed half-way, give the serial
results, bit for bit."""

import os
import signal
import subprocess
import sys
import tempfile
import unittest
import unittest.mock
import warnings

import hodograph
from hodograph import scale_out


def requests(count):
    for i in range(count):
        if i % 10 == 9:
            yield {"request": "fit", "id": i, "tolerance": 1e-3, "to": 3,
                   "formula": f"cos(t), sin(t), {0.3 + i / count}*t"}
        else:
            yield {"request": "climb", "id": i,
                   "begin": {"position": [0, 0, 0], "heading": 0.001 * (i % 101)},
                   "end": {"position": [300 + i % 37, 40, 31 + i % 9], "heading": 0.4},
                   "climb_angle": 0.0977384}
        if i % 50 == 7:
            yield "no json"


def length(xy):
    """A function of the library on arrays, as any user may write it."""
    path = hodograph.planar_spline(xy)
    return path.arc_length(), hodograph.to_json(path)


class OnTwoWorkers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        warnings.simplefilter("ignore", ResourceWarning)  # of distributed, about its own sockets
        cls.folder = os.getcwd()
        os.chdir(tempfile.gettempdir())
        cls.context = scale_out.local_cluster(2)
        cls.client = cls.context.__enter__()

    @classmethod
    def tearDownClass(cls):
        cls.context.__exit__(None, None, None)
        os.chdir(cls.folder)

    def test_a_killed_worker_changes_nothing(self):
        lines = list(requests(300))
        serial = list(hodograph.answer_lines(lines, jobs=1, text=True))
        processes = list(self.client.run(os.getpid).values())
        self.assertEqual(len(set(processes)), 2)
        answers = []
        for answer in scale_out.answer_lines(lines, self.client, text=True, chunk=5):
            answers.append(answer)
            if len(answers) == len(serial) // 2:
                os.kill(processes[0], signal.SIGKILL)
        self.assertEqual(answers, serial)

    def test_any_function_runs_there(self):
        items = [[[0, 0], [1, 2], [3, 1 + 0.1 * i]] for i in range(25)]
        results = list(scale_out.map_in_order(length, iter(items), self.client, chunk=4, ahead=3))
        self.assertEqual(results, [length(item) for item in items])
        with self.assertRaisesRegex(hodograph.HodographError, "point") as caught:
            list(scale_out.map_in_order(length, [[[0, 0]]], self.client))
        self.assertTrue(caught.exception.code)

    def test_faults_are_treated_as_asked(self):
        lines = list(requests(60))
        for way in ("report", "skip"):
            self.assertEqual(
                list(scale_out.answer_lines(lines, self.client, on_fault=way, chunk=7)),
                list(hodograph.answer_lines(lines, on_fault=way)))
        with self.assertRaisesRegex(hodograph.HodographError, "^request 9: this is no JSON"):
            list(scale_out.answer_lines(lines[:3] * 2 + ["", lines[0], lines[1], "no json"],
                                        self.client, on_fault="raise"))
        with self.assertRaisesRegex(ValueError, "on_fault"):
            scale_out.answer_lines([], self.client, on_fault="cry")
        with self.assertRaisesRegex(ValueError, "chunk"):
            scale_out.answer_lines([], self.client, chunk=0)
        self.assertEqual(list(scale_out.answer_lines([], self.client)), [])

    def test_work_that_is_left_is_cancelled(self):
        def endless():
            while True:
                yield from requests(5)

        answers = scale_out.answer_lines(endless(), self.client, chunk=3)
        first = [next(answers) for _ in range(4)]
        answers.close()
        self.assertEqual([one.get("id") for one in first], [0, 1, 2, 3])
        self.assertEqual(len(list(scale_out.answer_lines(requests(5), self.client))), 5)


class WithoutWorkers(unittest.TestCase):
    def test_no_workers_is_no_hang(self):
        import distributed
        with tempfile.TemporaryDirectory() as folder, distributed.LocalCluster(
                n_workers=0, host="127.0.0.1", dashboard_address=None, local_directory=folder) as \
                cluster, distributed.Client(cluster) as client:
            with unittest.mock.patch.object(scale_out, "_LOOK_S", 0.1), \
                    self.assertRaisesRegex(TimeoutError, "no workers for 0.2 s"):
                list(scale_out.answer_lines(requests(3), client, without_workers_s=0.2))

    def test_without_dask_the_sentence_says_what_to_install(self):
        script = ("import sys\n"
                  "sys.modules['distributed'] = None\n"
                  "from hodograph import scale_out\n"
                  "try:\n"
                  "    with scale_out.local_cluster(): pass\n"
                  "except ImportError as error:\n"
                  "    print(error)\n")
        done = subprocess.run([sys.executable, "-B", "-c", script], text=True, capture_output=True,
                              timeout=60, check=True)
        self.assertIn("python3-distributed", done.stdout)


if __name__ == "__main__":
    unittest.main()
