"""Problems on a grid of elements: Hertz by the normal problem, any patch, tangential steps; shapes are checked."""

import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled, wheel_on_rail


class GridProblemsTest(unittest.TestCase):
    def setUp(self):
        self.hertz, self.pair = wheel_on_rail()
        self.grid = microslip.ElementGrid.across_ellipse(self.hertz.a, self.hertz.b, 20, 16, 4)
        self.gap = microslip.hertzian_gap(self.hertz.gap, self.grid)

    def test_the_grid_has_the_ellipse_in_its_middle(self):
        self.assertEqual((self.grid.mx, self.grid.my, self.gap.shape), (28, 24, (24, 28)))
        np.testing.assert_allclose(self.grid.x + self.grid.x[::-1], 0, atol=1e-15)
        self.assertAlmostEqual(20 * self.grid.dx / (2 * self.hertz.a), 1, places=14)
        x, y = self.grid.x[None, :], self.grid.y[:, None]
        np.testing.assert_allclose(self.gap, self.hertz.gap.x * x**2 + self.hertz.gap.y * y**2, rtol=1e-14)

    def test_the_normal_problem_finds_hertz(self):
        problem = microslip.NormalProblem(self.pair, self.grid)
        solved = problem.solve(self.gap, normal_force=80e3)
        self.assertAlmostEqual(solved.peak_pressure / self.hertz.peak_pressure, 1, delta=0.01)
        self.assertAlmostEqual(solved.approach / self.hertz.approach, 1, delta=0.005)
        self.assertFalse(solved.touches_border)
        other = problem.solve(self.gap.ravel(), approach=solved.approach)
        self.assertAlmostEqual(other.normal_force / 80e3, 1, places=6)
        self.assertAlmostEqual((solved.pressure * self.grid.dx * self.grid.dy).sum() / 80e3, 1, places=9)

    def test_loads_and_shapes_are_checked(self):
        problem = microslip.NormalProblem(self.pair, self.grid)
        with self.assertRaisesRegex(microslip.Error, "either normal_force or approach"):
            problem.solve(self.gap)
        with self.assertRaisesRegex(microslip.Error, r"gap has shape \(28, 24\): must be \(24, 28\)"):
            problem.solve(self.gap.T, normal_force=1)
        with self.assertRaisesRegex(microslip.Error, "gap: must be real numbers"):
            problem.solve(self.gap + 0j, normal_force=1)

    def test_a_patch_with_hertzs_gap_is_the_elliptic_contact(self):
        solver = microslip.Solver(theory="exact")
        problem = microslip.RollingProblem(gap=self.gap, grid=self.grid, bodies=self.pair, normal_force=80e3, friction=0.3,
                                           rolling_speed=1.0, creepage_longitudinal=0.0018, creepage_lateral=0.0006, spin=0.4)
        patch = solver.solve(problem)
        exact = microslip.Solver(theory="exact", grid=40).solve(contact())
        self.assertAlmostEqual(patch.forces.fx / exact.forces.fx, 1, delta=0.01)
        self.assertAlmostEqual((patch.fields.px * patch.fields.area).sum() / patch.forces.fx, 1, places=12)
        self.assertEqual(patch.fields.pressure.shape[0], 24)
        law = solver.solve(problem.replace(friction=microslip.FrictionLaw.coulomb(0.3)))
        self.assertEqual(law.forces.fx, patch.forces.fx)
        given = solver.solve(problem.replace(force_longitudinal=-5e3))
        self.assertAlmostEqual(given.forces.fx / -5e3, 1, places=5)

    def test_steps_go_on_from_the_step_before(self):
        bound = 0.3 * self.hertz.pressure(self.grid.x[None, :], self.grid.y[:, None])
        problem = microslip.TangentialProblem(self.pair, self.grid)
        first = problem.solve(bound, (0.0005, 0, 0), kind="transient")
        second = problem.solve(bound, (0.0005, 0, 0), kind="transient", previous=first)
        again = problem.solve(bound, (0.0005, 0, 0), kind="transient")
        self.assertLess(second.forces.fx, 1.5 * first.forces.fx)
        self.assertAlmostEqual(again.forces.fx / first.forces.fx, 1, places=6)
        self.assertEqual((first.px.shape, first.state.dtype), ((24, 28), np.uint8))
        smaller = microslip.ElementGrid.across_ellipse(self.hertz.a, self.hertz.b, 8, 8)
        with self.assertRaisesRegex(microslip.Error, "previous has shape"):
            microslip.TangentialProblem(self.pair, smaller).solve(np.zeros((8, 8)), (0, 0, 0), kind="shift", previous=first)


load_tests = load_tests_if_compiled([GridProblemsTest])
