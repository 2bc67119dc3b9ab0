"""Pictures that the compiled module computes for: their numbers are those of the solvers."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import microslip
from microslip import plot
from microslip.result_file import ResultError, ResultFile
from tests.compiled import load_tests_if_compiled
from tests.test_case_files import CASE


class ComputedPicturesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = Path(folder.name) / "result.h5"
        cls.result = microslip.solve_case(microslip.parse_case(CASE))
        cls.result.write(cls.path)

    def chosen(self, **wanted):
        (figure,) = plot.figures(self.path, **wanted).values()
        return figure

    def test_creep_curves_are_those_of_both_theories(self):
        axes = self.chosen(spins=[0.0, 2.0]).axes[0]
        self.assertEqual(len(axes.lines), 4)
        contact = self.result.contact
        for line, solver in zip(axes.lines[2:], (microslip.EllipticContactSolver(16, 16), microslip.Fastsim2(20, 20))):
            creepage, force = line.get_xydata()[45]
            contact.creepage = (1e-3 * creepage, 0, 2.0)
            solved = solver.solve(contact)
            self.assertAlmostEqual(force, getattr(solved, "forces", solved).fx / 300, places=6)

    def test_spins_are_chosen_if_none_are_given(self):
        labels = [line.get_label() for line in self.chosen(spins=[]).axes[0].lines]
        self.assertEqual(len(labels), 6)
        self.assertIn("exact theory, spin 0 1/m", labels)

    def test_convergence_shows_second_order(self):
        axes = self.chosen(convergence=True).axes[0]
        lines = {line.get_label(): line.get_xydata() for line in axes.lines}
        slopes = {name: np.polyfit(*np.log(lines[name]).T, 1)[0] for name in ("second order, $F_x$", "classical, $F_x$")}
        self.assertLess(slopes["second order, $F_x$"], -1.6)
        self.assertGreater(slopes["classical, $F_x$"], -1.5)

    def test_tractions_on_the_regular_grid_have_the_forces(self):
        from microslip.computed_pictures import tractions_on_grid
        with ResultFile(self.path) as result:
            grid, (px, py, pn) = tractions_on_grid(result)
        area = grid.dx * grid.dy
        self.assertAlmostEqual((px * area).sum() / self.result.exact.forces.fx, 1, places=9)
        self.assertAlmostEqual((pn * area).sum() / 1e3, 1, places=9)
        moment = (grid.x[None, :] * py - grid.y[:, None] * px).sum() * area
        self.assertAlmostEqual(moment, self.result.exact.forces.mz, delta=0.02 * 300 * self.result.hertz.a)

    def test_stresses_have_hertzs_maximum(self):
        title = self.chosen(stresses=0.0).axes[0].get_title()
        peak = float(title.split("wheel ")[1].split()[0])
        # Without traction .62 p0 for nu = .3; traction raises it a little.
        self.assertAlmostEqual(peak / (1e-6 * self.result.hertz.peak_pressure), 0.65, delta=0.04)

    def test_what_cannot_be_computed_is_named(self):
        with h5py.File(self.path, "a") as file:
            del file["/inputs/friction_law"]
            file["/inputs/friction_law"] = "polach"
        try:
            with self.assertRaisesRegex(ResultError, "'polach'.*needs coulomb"):
                self.chosen(convergence=True)
        finally:
            with h5py.File(self.path, "a") as file:
                del file["/inputs/friction_law"]
                file["/inputs/friction_law"] = "coulomb"


load_tests = load_tests_if_compiled([ComputedPicturesTest])
