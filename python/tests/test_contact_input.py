"""CONTACT's input files: totals in its units, fields in SI, refused cases, errors with line and field."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from tests.compiled import load_tests_if_compiled

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


WHEEL = """ 1 MODULE
 1203000
 0022033
 0000231
 999 100 30 1 1e-7
 0.3 0.3
 0.28 0.28 82000. 82000.
 0.4 0.4 1. 90d 8. 4.
 -1. 200. 0. 0.
 'rail.prr' 0 1. 0.
 0 0 0 0 0 0
 200. -100. 100.
 'wheel.prw' 0 1. 0.
 0 0 0.16 0 0 0
 100. 0 0 0 0 -1.01
 0 MODULE
"""


def write_profile(path, kind, y, z):
    """A profile in Simpack's format, in mm."""
    points = "\n".join(f"{a} {b}" for a, b in zip(y, z))
    path.write_text(f"header.begin\n version = 1\n type = {kind}\nheader.end\nspline.begin\n units.len.f = 1000.\n"
                    f" point.begin\n{points}\n point.end\nspline.end\n")


class ContactInputTest(unittest.TestCase):
    def test_a_wheel_has_patches(self):
        y = np.linspace(-20, 20, 401)
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_profile(folder / "rail.prr", 0, y, 0 * y)
            write_profile(folder / "wheel.prw", 1, y[::-1], np.sqrt(1e4 - y**2) - 100)
            (folder / "a.inp").write_text(WHEEL)
            [case] = microslip.run_contact_input(folder / "a.inp")
        self.assertEqual((case.outcome, case.totals, case.grid), ("solved", None, None))
        [patch] = case.patches
        np.testing.assert_allclose(patch.track, (0, 200, 0), atol=1e-6)
        force = np.array(case.force_on_rail)
        np.testing.assert_allclose((patch.totals.fx, patch.totals.fn), force[[0, 2]], rtol=1e-6)
        area = patch.grid.dx * patch.grid.dy
        self.assertAlmostEqual(patch.normal.pressure.sum() * area / patch.totals.fn, 1, places=9)
        self.assertAlmostEqual(patch.tangential.px.sum() * area / patch.totals.fx, 1, places=6)
        self.assertAlmostEqual(patch.cksi, (1.01 - 1) / 1.005, places=4)
        self.assertEqual((patch.previous, case.wheel_height), ([], 0.16))

    def test_the_example_runs(self):
        cases = list(microslip.run_contact_input(EXAMPLES / "sphere_on_plane.inp"))
        self.assertEqual([case.number for case in cases], list(range(1, len(cases) + 1)))
        for case in cases:
            self.assertEqual((case.outcome, case.status, case.reasons), ("solved", microslip.Status.ok, []))
            grid, totals = case.grid, case.totals
            force = (case.normal.pressure * grid.dx * grid.dy).sum()
            self.assertAlmostEqual(totals.fn / force, 1, places=9)
            self.assertEqual(case.tangential.px.shape, (grid.my, grid.mx))
            self.assertEqual(totals.slip, np.count_nonzero(case.tangential.state == microslip.CellState.slip))
            self.assertAlmostEqual(1e3 * case.tangential.forces.mz, totals.mz, delta=1e-9 * totals.fn)

    def test_what_is_not_supported_is_refused(self):
        text = (EXAMPLES / "sphere_on_plane.inp").read_text()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "odd.inp"
            path.write_text(text.replace("200100", "250100", 1))  # KPEC with the force given
            first = next(iter(microslip.run_contact_input(path)))
        self.assertEqual((first.outcome, first.totals, first.normal), ("refused", None, None))
        self.assertTrue(first.reasons)

    def test_errors_have_line_and_field(self):
        with self.assertRaisesRegex(FileNotFoundError, "nowhere.inp"):
            microslip.run_contact_input("nowhere.inp")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "short.inp"
            path.write_text("  3  MODULE\n  203100\n")
            with self.assertRaisesRegex(microslip.Error, r"short\.inp:"):
                list(microslip.run_contact_input(path))


load_tests = load_tests_if_compiled([ContactInputTest])
