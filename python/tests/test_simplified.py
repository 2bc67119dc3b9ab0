"""FASTSIM and FASTSIM2: full sliding, small creepages, symmetry, derivatives by differences, batches equal to single calls."""

import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled


def numbers(forces):
    return forces.fx, forces.fy, forces.mz, forces.adhesion_area, forces.slip_area


class SolverTest(unittest.TestCase):
    def test_the_readmes_example(self):
        forces = microslip.Fastsim2().solve(contact())
        np.testing.assert_allclose(numbers(forces)[:3], (-13306.6, -14161.3, -15.19), rtol=4e-4)
        self.assertIs(forces.status, microslip.Status.ok)

    def test_small_creepages_follow_linear_theory(self):
        for creepage, force in (((1e-8, 0, 0), "fx"), ((0, 1e-8, 0), "fy")):
            c = microslip.creepage_coefficients(contact().a / contact().b, 0.28)
            slope = {"fx": c.c11, "fy": c.c22}[force]
            expected = -contact().shear_modulus * contact().a * contact().b * slope * 1e-8
            solver = microslip.Fastsim2(mx=40, my=40)
            self.assertAlmostEqual(getattr(solver.solve(contact(creepage)), force) / expected, 1, delta=0.01)

    def test_full_sliding_gives_mu_fn(self):
        for solver in (microslip.Fastsim(7, 3), microslip.Fastsim2(), microslip.Fastsim2(bound="elliptic")):
            forces = solver.solve(contact((1.0, 0, 0)))
            self.assertAlmostEqual(forces.fx / -24e3, 1, places=12)
            self.assertEqual(forces.adhesion_area, 0)

    def test_backward_rolling_is_the_mirror_image(self):
        forward, backward = microslip.Fastsim2(), microslip.Fastsim2(direction="backward")
        one, other = forward.solve(contact((0.001, 0.0005, 0.3))), backward.solve(contact((-0.001, 0.0005, -0.3)))
        np.testing.assert_allclose(numbers(one), np.array(numbers(other)) * (-1, 1, -1, 1, 1), rtol=1e-12)

    def test_creepages_as_numbers(self):
        solver, made = microslip.Fastsim2(), contact()
        self.assertEqual(numbers(solver.solve(made, 1e-3, -2e-3, 0.1)), numbers(solver.solve(contact((1e-3, -2e-3, 0.1)))))
        self.assertEqual(tuple(made.creepage), (0.0018, 0.0006, 0.4))

    def test_derivatives_are_those_of_differences(self):
        solver, at, step = microslip.Fastsim2(), np.array([0.0008, 0.0003, 0.2]), 1e-7
        found = solver.differentiate(contact(at))
        self.assertEqual(found.jacobian.shape, (3, 4))
        for i in range(3):
            more, less = (solver.solve(contact(), *(at + side * step * np.eye(3)[i])) for side in (1, -1))
            for row, name in enumerate(("fx", "fy", "mz")):
                slope = (getattr(more, name) - getattr(less, name)) / (2 * step)
                self.assertAlmostEqual(found.jacobian[row, i], slope, delta=1e-4 * abs(found.jacobian[row]).max())

    def test_fields_add_up_to_the_forces(self):
        solved = microslip.Fastsim2(12, 9).fields(contact())
        fields = solved.fields
        self.assertEqual((fields.px.shape, solved.grid.mx, solved.grid.my), ((9, 12), 12, 9))
        for p, force in ((fields.px, solved.fx), (fields.py, solved.fy)):
            self.assertAlmostEqual((fields.area * p).sum() / force, 1, places=12)
        self.assertTrue(np.all(np.hypot(fields.px, fields.py) <= fields.bound * (1 + 1e-12)))
        self.assertEqual(set(np.unique(fields.state)), {microslip.CellState.adhesion, microslip.CellState.slip})
        self.assertTrue(np.all(np.diff(fields.x, axis=1) > 0) and np.all(np.diff(fields.y[:, 0]) > 0))

    def test_fields_outlive_their_result_and_are_read_only(self):
        px = microslip.Fastsim2(50, 50).fields(contact()).fields.px
        self.assertLess(px.sum(), 0)
        with self.assertRaises(ValueError):
            px[0, 0] = 1

    def test_a_patch_with_the_rows_of_an_ellipse(self):
        made, solver = contact((0.002, 0, 0)), microslip.Fastsim2(20, 20)
        fields = solver.fields(made).fields
        edge = made.a * np.sqrt(1 - (fields.y[:, 0] / made.b) ** 2)
        pressure = fields.bound / 0.3
        c = microslip.creepage_coefficients(made.a / made.b, made.poisson_ratio)
        lengths = [8 * made.a / (3 * made.shear_modulus * k) for k in (c.c11, c.c22)]
        third = np.pi * made.a * np.sqrt(made.a / made.b) / (4 * made.shear_modulus * c.c23)
        patch = solver.patch_fields(fields.y[:, 0], edge, -edge, pressure, row_width=2 * made.b / 20,
                                    flexibilities=(*lengths, third), friction=0.3, creepage=(0.002, 0, 0))
        np.testing.assert_allclose(patch.fields.px, fields.px, rtol=1e-9, atol=1e-3)
        with self.assertRaisesRegex(microslip.Error, r"leading has shape \(3,\): must be \(20,\)"):
            solver.patch_fields(fields.y[:, 0], edge[:3], -edge, pressure, row_width=1e-3, flexibilities=(1, 1, 1),
                                friction=0.3, creepage=(0, 0, 0))

    def test_invalid_input_is_a_status(self):
        made = contact()
        made.a = -1
        forces = microslip.Fastsim2().solve(made)
        self.assertIs(forces.status, microslip.Status.invalid_input)
        self.assertTrue(np.isnan(forces.fx))

    def test_options_out_of_range(self):
        for wrong, text in (({"mx": 0}, "mx = 0"), ({"bound": "flat"}, 'bound = "flat"'),
                            ({"flexibility": "tree"}, "did you mean three"), ({"direction": ""}, "direction")):
            with self.assertRaisesRegex(microslip.Error, text):
                microslip.Fastsim2(**wrong)


class BatchTest(unittest.TestCase):
    def test_a_batch_is_its_single_calls(self):
        rng = np.random.default_rng(1)
        xi, eta = rng.normal(0, 1e-3, (2, 700))
        for solver in (microslip.Fastsim2(), microslip.Fastsim(20, 7)):
            for threads in (1, 2, 5):
                batch = solver.solve_batch(contact(), xi, eta, 0.2, threads=threads)
                self.assertEqual((batch.fx.shape, len(batch)), ((700,), 700))
                for i in (0, 255, 256, 699):
                    single = solver.solve(contact(), xi[i], eta[i], 0.2)
                    self.assertEqual(numbers(single), tuple(getattr(batch, name)[i] for name in
                                                            ("fx", "fy", "mz", "adhesion_area", "slip_area")))
                self.assertTrue(np.all(batch.status == microslip.Status.ok))

    def test_everything_broadcasts(self):
        spins, creepages, frictions = np.array([0, 0.5])[:, None, None], np.linspace(0, 2e-3, 5), np.array([[0.1], [0.4]])
        batch = microslip.Fastsim2().solve_batch(contact(), creepages, spin=spins, friction=frictions, normal_force=50e3)
        self.assertEqual(batch.fx.shape, (2, 2, 5))
        made = contact((creepages[3], 0.0006, 0.5), 0.4)
        made.normal_force = 50e3
        self.assertEqual(batch.fy[1, 1, 3], microslip.Fastsim2().solve(made).fy)

    def test_every_field_can_be_an_array(self):
        given = {"a": 5e-3, "b": 4e-3, "shear_modulus": 70e9, "poisson_ratio": 0.3, "normal_force": 60e3, "friction": 0.2,
                 "rolling_speed": 20.0, "longitudinal": 1e-3, "lateral": 2e-3, "spin": 0.3}
        names = ("a", "b", "shear_modulus", "poisson_ratio", "normal_force", "friction")
        expected = microslip.EllipticContact(*(given[name] for name in names), (1e-3, 2e-3, 0.3), 20.0)
        batch = microslip.Fastsim2().solve_batch(contact(), **{name: [value] * 3 for name, value in given.items()})
        self.assertEqual(list(batch.fx), [microslip.Fastsim2().solve(expected).fx] * 3)

    def test_derivatives(self):
        xi = np.linspace(1e-4, 3e-3, 300)
        batch = microslip.Fastsim2().differentiate_batch(contact(), xi)
        self.assertEqual(batch.jacobian.shape, (300, 3, 4))
        single = microslip.Fastsim2().differentiate(contact(), xi[290], 0.0006, 0.4)
        np.testing.assert_array_equal(batch.jacobian[290], single.jacobian)
        self.assertEqual(batch.forces.fx[290], single.forces.fx)

    def test_one_bad_contact_does_not_stop_the_others(self):
        batch = microslip.Fastsim2().solve_batch(contact(), [1e-3, np.nan, 2e-3])
        self.assertEqual(list(batch.status), [0, microslip.Status.invalid_input, 0])
        np.testing.assert_array_equal(np.isnan(batch.fx), [False, True, False])

    def test_an_empty_batch(self):
        self.assertEqual(microslip.Fastsim2().solve_batch(contact(), np.zeros((0, 3))).fx.shape, (0, 3))

    def test_what_is_no_array_of_numbers_is_named(self):
        solver = microslip.Fastsim2()
        for wrong in ("abc", [1j], [True], [None], [[1, 2], [3]], [np.datetime64("2020")]):
            with self.assertRaisesRegex(microslip.Error, "^lateral: "):
                solver.solve_batch(contact(), 1e-3, wrong)
        with self.assertRaisesRegex(microslip.Error, r"spin has shape \(3,\): does not match \(2,\)"):
            solver.solve_batch(contact(), [1, 2], spin=[1, 2, 3])
        with self.assertRaisesRegex(microslip.Error, r"friction = -1 \[-\]"):
            solver.solve_batch(contact(), friction=[0.3, -1])
        with self.assertRaisesRegex(microslip.Error, "threads = -1"):
            solver.solve_batch(contact(), threads=-1)

    def test_integers_and_single_precision_are_numbers(self):
        solver = microslip.Fastsim2()
        for kind in (np.int8, np.uint64, np.float32, np.float16):
            self.assertEqual(solver.solve_batch(contact(), np.ones(2, dtype=kind)).fx[1], solver.solve(contact(), 1, 6e-4, 0.4).fx)


load_tests = load_tests_if_compiled([SolverTest, BatchTest])
