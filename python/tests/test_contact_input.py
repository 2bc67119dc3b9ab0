"""CONTACT's input files: totals in its units, fields in SI, refused cases, errors with line and field."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from tests.compiled import load_tests_if_compiled

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


class ContactInputTest(unittest.TestCase):
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
