"""The picture of a creep-force table: lines are the table's forces, points the exact theory's."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from microslip import plot
from microslip.creep_table_picture import creep_table_picture, unit_contact
from tests.compiled import load_tests_if_compiled
from tests.figures import title_of

SHIPPED = Path(microslip.__file__).resolve().parent / "hertz.creep"


class CreepTablePictureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.table = microslip.CreepForceTable(poisson_ratio=0.28)

    def test_lines_are_the_tables_and_points_the_exact_theorys(self):
        axes = creep_table_picture(self.table, axis_ratio=2.0, spins=(0.0, 0.5), elements=12).axes
        contact, exact = unit_contact(2.0, 0.28), microslip.Solver(theory="exact", grid=12)
        for panel, force, place in ((0, "fx", 0), (1, "fy", 1), (2, "mz", 1)):
            lines = {line.get_label(): line.get_xydata() for line in axes[panel].lines}
            for x, value in lines["table, spin 0.5"][::40]:
                contact.creepage = (*np.eye(2)[place] * x, 0.5)
                self.assertAlmostEqual(getattr(self.table.solve(contact), force), value, places=12)
            x, value = lines["exact theory, spin 0.5"][6]
            contact.creepage = (*np.eye(2)[place] * x, 0.5)
            self.assertAlmostEqual(getattr(exact.solve(contact).forces, force), value, places=6)

    def test_says_how_far_it_is_from_the_exact_theory_and_what_is_out_of_range(self):
        inside = title_of(creep_table_picture(self.table, spins=(0.0,), elements=12))
        self.assertIn("largest distance to the exact theory on 12 x 12 elements: 0.00", inside)
        self.assertNotIn("beyond", inside)
        self.assertIn("beyond the table's range", title_of(creep_table_picture(self.table, 0.02, spins=(0.0,), elements=0)))

    def test_the_file_is_drawn(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as printed:
            self.assertEqual(plot.main([str(SHIPPED), "-o", folder, "--axis-ratio=0.5", "--spins=0"]), 0)
            path = Path(folder) / "creep_table.png"
            self.assertEqual(printed.getvalue(), f"{path}\n")
            self.assertEqual(path.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_options_of_other_files_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for path, option, what in ((SHIPPED, "--cut=0", "has only"), (Path(folder) / "r.h5", "--spins=0", "which alone has")):
                with contextlib.redirect_stderr(io.StringIO()) as errors:
                    self.assertEqual(plot.main([str(path), "-o", folder, option]), 2)
                self.assertIn(what, errors.getvalue())


load_tests = load_tests_if_compiled([CreepTablePictureTest])


if __name__ == "__main__":
    unittest.main()
