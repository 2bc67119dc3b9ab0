"""Sweeps from Python: the same file on threads, on executors and after an interruption."""

import concurrent.futures
import tempfile
import unittest
from pathlib import Path

import h5py

import microslip
from tests.compiled import load_tests_if_compiled

SPECIFICATION = """
[grid]
load.normal_force = [-1, 40e3, 80e3]
motion.creepage_longitudinal = { from = 1e-4, to = 4e-3, count = 10 }
[case.body1]
rolling_radius = 0.46
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[case.body2]
rolling_radius = inf
transverse_radius = 0.3
young_modulus = 210e9
poisson_ratio = 0.28
[case.load]
[case.friction]
coefficient = 0.3
[case.motion]
rolling_speed = 30
[case.solution]
theory = "exact"
grid = [10, 10]
"""


def contents(path):
    """All datasets of a result file."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, part: found.update({name: part[()].tolist() if part.dtype == object else part[()].tobytes()})
                        if isinstance(part, h5py.Dataset) else None)
    return found


class DyingExecutor(concurrent.futures.ThreadPoolExecutor):
    """Takes some tasks only."""

    def __init__(self, tasks):
        super().__init__(1)
        self.left = tasks

    def submit(self, *arguments):
        self.left -= 1
        return super().submit(*arguments) if self.left >= 0 else super().submit(self.fail)

    @staticmethod
    def fail():
        raise RuntimeError("the worker died")


class SweepTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.spec = Path(self.folder.name) / "s.toml"
        self.spec.write_text(SPECIFICATION)
        self.expected = self.path("threads.h5")
        report = microslip.sweep(self.spec, self.expected, threads=2)
        self.assertEqual((report.cases, report.failed, report.from_checkpoint), (30, 10, 0))

    def path(self, name):
        """Path in the test's folder."""
        return Path(self.folder.name) / name

    def test_executors_find_the_same_bits(self):
        for executor in (concurrent.futures.ThreadPoolExecutor(3), concurrent.futures.ProcessPoolExecutor(2)):
            with executor:
                report = microslip.sweep(self.spec, self.path("e.h5"), executor=executor)
            self.assertEqual((report.cases, report.failed), (30, 10))
            self.assertEqual(contents(self.path("e.h5")), contents(self.expected))
        self.assertEqual(sorted(one.name for one in Path(self.folder.name).iterdir()), ["e.h5", "s.toml", "threads.h5"])

    def test_goes_on_where_an_executor_ended(self):
        with DyingExecutor(12) as executor, self.assertRaisesRegex(RuntimeError, "the worker died"):
            microslip.sweep(self.spec, self.path("d.h5"), executor=executor)
        self.assertFalse(self.path("d.h5").exists())
        report = microslip.sweep(self.spec, self.path("d.h5"))
        self.assertEqual(report.from_checkpoint, 12)
        self.assertEqual(contents(self.path("d.h5")), contents(self.expected))

    def test_a_second_sweep_on_one_output_is_refused(self):
        messages = []

        class Nested(concurrent.futures.ThreadPoolExecutor):
            """Begins another sweep before its first task."""

            def submit(executor, *arguments):
                if not messages:
                    try:
                        microslip.sweep(self.spec, self.path("n.h5"))
                    except microslip.Error as error:
                        messages.append(str(error))
                return super().submit(*arguments)

        with Nested(1) as executor:
            microslip.sweep(self.spec, self.path("n.h5"), executor=executor)
        self.assertIn("another sweep of this process writes to it", messages[0])

    def test_bad_input_is_named(self):
        with self.assertRaises(FileNotFoundError):
            microslip.sweep(self.path("nowhere.toml"), self.path("x.h5"))
        self.spec.write_text(SPECIFICATION.replace("load.normal_force", "load.normal_forse"))
        with self.assertRaisesRegex(microslip.Error, "did you mean normal_force?"):
            microslip.sweep(self.spec, self.path("x.h5"))


load_tests = load_tests_if_compiled([SweepTest])

if __name__ == "__main__":
    unittest.main()
