"""Stresses inside the bodies: equilibrium at the surface, Hertz's maximum, planes equal to sums, measures of stress."""

import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled, wheel_on_rail


class InteriorTest(unittest.TestCase):
    def setUp(self):
        self.steel = microslip.Material(80e9, 0.3)
        self.grid = microslip.ElementGrid.across_ellipse(1e-3, 1e-3, 24, 24)
        inside = np.clip(1 - (self.grid.x[None, :] ** 2 + self.grid.y[:, None] ** 2) / 1e-6, 0, None)
        self.pressure = 1e9 * np.sqrt(inside)
        self.field = microslip.InteriorField(self.steel, 1, self.grid, pn=self.pressure)

    def test_surface_stresses_balance_the_tractions(self):
        field = microslip.InteriorField(self.steel, 2, self.grid, px=0.3 * self.pressure, py=0.1 * self.pressure,
                                        pn=self.pressure)
        states = field.at(self.grid.x[None, :], self.grid.y[:, None], 0)
        for stress, part in ((states.xz, 0.3), (states.yz, 0.1), (states.zz, 1)):
            np.testing.assert_allclose(stress, -part * self.pressure, atol=1e-5 * 1e9)

    def test_the_largest_shear_stress_is_hertzs(self):
        # Johnson 1985, (3.46): 0.31 p0 at 0.48 a below the surface, nu = 0.3.
        peak = microslip.InteriorLayers(self.field).find_largest(np.linspace(2e-4, 1e-3, 9), "tresca")
        self.assertAlmostEqual(peak.value / 2 / 1e9, 0.310, delta=0.002)
        self.assertAlmostEqual(peak.depth / 1e-3, 0.48, delta=0.01)

    def test_planes_are_the_sums(self):
        layers = microslip.InteriorLayers(self.field, margin=2)
        plane = layers.at_depth(3e-4)
        sums = self.field.at(layers.grid.x[None, :], layers.grid.y[:, None], 3e-4)
        self.assertEqual(plane.von_mises.shape, (28, 28))
        for name in ("ux", "uz", "xx", "yy", "zz", "xy", "xz", "yz"):
            wanted = getattr(sums, name)
            np.testing.assert_allclose(getattr(plane, name), wanted, atol=1e-10 * abs(wanted).max())

    def test_measures_belong_together(self):
        states = self.field.at([0, 2e-4], [0, 3e-4], [4e-4, 5e-4])
        principal = states.principal
        self.assertEqual(principal.shape, (2, 3))
        np.testing.assert_allclose(states.tresca, principal[:, 0] - principal[:, 2])
        np.testing.assert_allclose(states.hydrostatic, principal.mean(axis=1))
        deviator = principal - principal.mean(axis=1, keepdims=True)
        np.testing.assert_allclose(states.von_mises, np.sqrt(1.5 * (deviator**2).sum(axis=1)))

    def test_from_any_solution_in_one_call(self):
        hertz, pair = wheel_on_rail()
        steel = microslip.Material.from_young(210e9, 0.28)
        grid = microslip.ElementGrid.across_ellipse(hertz.a, hertz.b, 24, 24, 4)
        patch = microslip.RollingProblem(contact(), gap=microslip.hertzian_gap(hertz.gap, grid), grid=grid)
        z = np.array([-3e-3, -1e-3, 1e-3, 3e-3])
        found = [solution.interior_states(steel, steel, [-1e-3, 0, 1e-3], [0, 1e-3], z).von_mises for solution in (
            microslip.Solver(theory="exact", grid=24).solve(contact()),
            microslip.Solver(theory="exact", grid=24, discretisation="classical").solve(contact()),
            microslip.Solver(theory="exact").solve(patch))]
        self.assertEqual(found[0].shape, (4, 2, 3))
        for other in found[1:]:
            np.testing.assert_allclose(other, found[0], rtol=0.03)
        along = microslip.Solver(theory="exact", grid=24).solve(contact()).interior_states(steel, steel, 0.0, 0.0, 0.0)
        self.assertAlmostEqual(along.zz.item() / -hertz.peak_pressure, 1, delta=0.02)
        with self.assertRaisesRegex(microslip.Error, "pressure"):
            microslip.Fastsim2().fields(contact()).interior_states(steel, steel, 0.0, 0.0, 1e-3)
        with self.assertRaisesRegex(microslip.Error, "z = "):
            microslip.Solver(theory="exact").solve(patch).interior_states(steel, steel, 0.0, 0.0, np.nan)

    def test_fields_on_any_grid(self):
        solved = microslip.Solver(theory="exact", grid=20).solve(contact())
        grid = microslip.ElementGrid(160, 120, -8e-3, -7.5e-3, 1e-4, 1.25e-4)
        px = solved.sampled("px", grid)
        self.assertEqual(px.shape, (120, 160))
        self.assertAlmostEqual(px.sum() * grid.dx * grid.dy / solved.fx, 1, delta=0.03)
        np.testing.assert_allclose(solved.sampled("px", solved.grid)[10, 5:10], solved.fields.px[10, 5:10])
        with self.assertRaisesRegex(microslip.Error, "px"):
            solved.sampled("pz", grid)
        with self.assertRaisesRegex(microslip.Error, "temperature1.*does not have it"):
            solved.sampled("temperature1", grid)

    def test_shapes_and_ranges_are_checked(self):
        with self.assertRaisesRegex(microslip.Error, r"pn has shape \(3,\): must be \(24, 24\)"):
            microslip.InteriorField(self.steel, 1, self.grid, pn=[1, 2, 3])
        with self.assertRaisesRegex(microslip.Error, "body = 3"):
            microslip.InteriorField(self.steel, 3, self.grid)
        with self.assertRaisesRegex(microslip.Error, "depth"):
            self.field.at(0, 0, -1)
        with self.assertRaisesRegex(microslip.Error, "did you mean tresca"):
            microslip.InteriorLayers(self.field).find_largest([1e-4], "tresco")


load_tests = load_tests_if_compiled([InteriorTest])
