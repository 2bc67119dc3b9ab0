"""Pictures that the compiled module computes for: their numbers are those of the solvers."""

import copy
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from microslip import plot
from microslip.result_file import ResultError, ResultFile
from tests.compiled import load_tests_if_compiled
from tests.figures import title_of
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
        for line, solver in zip(axes.lines[2:], (microslip.Solver(theory="exact", grid=16), microslip.Fastsim2(20, 20))):
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
        title = self.chosen(stresses=0.0).axes[0].get_title(loc="left")
        peak = float(re.search(r"largest for all y: .*? ([\d.]+) MPa at", title)[1])
        # Without traction 0.62 p0 for nu = 0.3; traction raises it a little.
        self.assertAlmostEqual(peak / (1e-6 * self.result.hertz.peak_pressure), 0.65, delta=0.04)

    def solved(self, *changes):
        """The path of a result of the case with changes of its text."""
        text = CASE
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new, 1)
        case = microslip.parse_case(text)
        path = self.path.with_name("changed.h5")
        microslip.solve_case(case).write(path)
        return case, path

    def curves(self, path):
        """The figure of creep curves without spin, and Fx at a creepage by each theory."""
        (figure,) = plot.figures(path, spins=[0.0]).values()
        lines = figure.axes[0].lines
        return figure, {line.get_label().split(",")[0]: line.get_xydata()[40] for line in lines}

    def check_curves(self, case, path):
        """The curves are those of the case's solvers. Returns the figure's title."""
        figure, points = self.curves(path)
        limit = case.contact.friction.static_coefficient * case.contact.normal_force
        contact = copy.copy(case.contact)
        contact.dissimilarity = 0.0  # which the simplified theory does not have
        exact = case.method.replace(theory="exact", grid=16)
        simplified = microslip.Method(grid=20, slope_reduction=case.method.slope_reduction)
        for name, method, problem in (("exact theory", exact, case.problem), ("FASTSIM2", simplified, microslip.RollingProblem(contact))):
            creepage, force = points[name]
            moved = problem.replace(creepage_longitudinal=1e-3 * creepage, creepage_lateral=0, spin=0)
            self.assertAlmostEqual(force, microslip.Solver(method).solve(moved).fx / limit, places=6)
        return title_of(figure), points

    def test_creep_curves_are_of_the_case_with_all_it_says(self):
        plain = self.curves(self.path)[1]
        changes = {
            "viscoelastic": ("[body2]", "creep_ratio = 2.0\ncreep_time = 5e-4\n[body2]"),
            "unlike": ("young_modulus = 210e9", "young_modulus = 20e9"),
            "layered": ("[load]", "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\n[load]"),
            "slope": ("[8, 8]", "[8, 8]\nslope_reduction = {initial = 0.5}"),
            "falling": ("coefficient = 0.3", 'law = "exponential"\nkinetic_coefficient = 0.1\ndrop = 0.2\n'
                        "half_velocity = 0.002"),
        }
        for name, change in changes.items():
            with self.subTest(name):
                title, points = self.check_curves(*self.solved(change))
                changed = "FASTSIM2" if name == "slope" else "exact theory"
                self.assertGreater(abs(points[changed][1] - plain[changed][1]), 1e-3)
                self.assertEqual("elastic bodies of K = 0" in title, name in ("viscoelastic", "unlike"))
                self.assertEqual("no layer" in title, name == "layered")

    def test_convergence_without_a_limit_is_refused(self):
        for change in (("[body2]", "creep_ratio = 2.0\ncreep_time = 5e-4\n[body2]"),
                       ("[load]", "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\n[load]")):
            _, path = self.solved(change)
            with self.assertRaisesRegex(ResultError, "this picture compares second order with classical elements, and needs similar elastic bodies"):
                plot.figures(path, convergence=True)

    def test_convergence_is_at_the_creepage_found(self):
        _, path = self.solved(("creepage_longitudinal = 0.001", "force_longitudinal = -150.0"))
        (figure,) = plot.figures(path, convergence=True).values()
        limit = re.search(r"\$F_x\$ = (\S+) N", figure.axes[0].get_title(loc="left"))
        self.assertAlmostEqual(float(limit[1].replace("\N{MINUS SIGN}", "-")), -150, delta=5)

    def test_what_is_not_steady_is_refused(self):
        _, path = self.solved(("[motion]", '[motion]\nkind = "transient"'))
        with self.assertRaisesRegex(ResultError, "needs steady rolling"):
            plot.figures(path, spins=[0.0])
        _, path = self.solved(("[motion]", "[motion]\nstep = 1e-5"))
        with self.assertRaisesRegex(ResultError, "without motion.step"):
            plot.figures(path, convergence=True)


load_tests = load_tests_if_compiled([ComputedPicturesTest])
