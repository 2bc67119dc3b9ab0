"""Friction laws and traction bounds: values at rest, at the half velocity and far out; integrals of the bound."""

import copy
import pickle
import unittest

import numpy as np

import microslip
from tests.compiled import load_tests_if_compiled


class FrictionLawTest(unittest.TestCase):
    def test_terms_fall_to_their_half(self):
        for make in (microslip.FrictionLaw.linear, microslip.FrictionLaw.rational, microslip.FrictionLaw.exponential):
            law = make(0.2, (0.1, 2.0))
            np.testing.assert_allclose(law.coefficient([0, 2.0, 1e9]), [0.3, 0.25, 0.2], rtol=1e-8)
            self.assertEqual((law.static_coefficient, law.terms[0]), (0.30000000000000004, (0.1, 2.0)))

    def test_polach(self):
        law = microslip.FrictionLaw.polach(0.4, 0.5, 0.6)
        self.assertEqual(law.kind, "exponential")
        self.assertAlmostEqual(law.coefficient(1.5), 0.4 * (0.5 * np.exp(-0.9) + 0.5), places=14)

    def test_errors(self):
        with self.assertRaisesRegex(microslip.Error, r"-0\.3"):
            microslip.FrictionLaw.coulomb(-0.3)
        with self.assertRaisesRegex(microslip.Error, r"slip_velocity = -1 \[m/s\]"):
            microslip.FrictionLaw.coulomb(0.3).coefficient(-1)


class FrictionOfOnesOwnTest(unittest.TestCase):
    velocities, coefficients = np.array([0, 0.01, 0.1, 1]), np.array([0.3, 0.4, 0.35, 0.2])

    def contact(self, friction):
        return microslip.EllipticContact(6e-3, 4e-3, 82e9, 0.28, 80e3, friction, (0.003, 0.001, 0.1), rolling_speed=20)

    def test_a_table_has_its_coefficients(self):
        law = microslip.FrictionLaw.table(self.velocities, self.coefficients)
        np.testing.assert_allclose(law.coefficient(self.velocities), self.coefficients, rtol=1e-15)
        self.assertEqual((law.kind, law.static_coefficient, law.kinetic_coefficient, law.peak_coefficient),
                         ("table", 0.3, 0.2, 0.4))
        self.assertEqual((law.slip_velocities, law.coefficients), (list(self.velocities), list(self.coefficients)))
        self.assertIsNone(microslip.FrictionLaw.coulomb(0.3).slip_velocities)

    def test_interpolates_as_scipy_does(self):
        try:
            from scipy.interpolate import PchipInterpolator
        except ImportError:
            self.skipTest("needs scipy")
        law = microslip.FrictionLaw.table(self.velocities, self.coefficients)
        v = np.linspace(0, 1, 201)
        np.testing.assert_allclose(law.coefficient(v), PchipInterpolator(self.velocities, self.coefficients)(v), rtol=1e-13)

    def test_copies_and_pickles_are_equal(self):
        law = microslip.FrictionLaw.table(self.velocities, self.coefficients)
        for other in (copy.deepcopy(law), pickle.loads(pickle.dumps(law))):
            self.assertEqual(law, other)
        self.assertNotEqual(law, microslip.FrictionLaw.table(self.velocities, self.coefficients / 2))
        problem = microslip.RollingProblem(self.contact(law))
        self.assertEqual(pickle.loads(pickle.dumps(problem)).friction, law)

    def test_a_table_of_pressures_and_temperatures_has_their_shape(self):
        coefficients = np.linspace(0.4, 0.1, 24).reshape(3, 2, 4)
        law = microslip.FrictionLaw.table(self.velocities, coefficients, pressures=[1e8, 1e9], temperatures=[20, 100, 400])
        self.assertEqual((law.pressures, law.temperatures), ([1e8, 1e9], [20, 100, 400]))
        self.assertEqual(law.coefficients, list(coefficients.ravel()))
        self.assertEqual(pickle.loads(pickle.dumps(law)), law)
        of_pressure = microslip.FrictionLaw.table(self.velocities, coefficients[0], pressures=[1e8, 1e9])
        solution = microslip.Solver(theory="exact", grid=10).solve(self.contact(of_pressure))
        self.assertLess(abs(solution.fx), 0.4 * 80e3)
        with self.assertRaisesRegex(microslip.Error, "pressures or temperatures needs"):
            microslip.Solver(theory="fastsim2").solve(self.contact(of_pressure))
        with self.assertRaisesRegex(microslip.Error, "coefficients"):
            microslip.FrictionLaw.table(self.velocities, coefficients, pressures=[1e8, 1e9])

    def test_a_function_gives_the_forces_of_the_law_that_it_is(self):
        wanted = microslip.FrictionLaw.exponential(0.2, (0.15, 0.03))
        law = microslip.FrictionLaw.sampled(lambda v: 0.2 + 0.15 * 2 ** (-v / 0.03), fastest=10)
        v = np.geomspace(1e-5, 10, 1001)
        np.testing.assert_allclose(law.coefficient(v), wanted.coefficient(v), rtol=0, atol=1.5e-6)
        for solver in (microslip.Fastsim2(10), microslip.Solver(theory="exact", grid=10)):
            found, expected = (solver.solve(self.contact(friction)) for friction in (law, wanted))
            self.assertAlmostEqual(found.fx, expected.fx, delta=3e-6 * 80e3)

    def test_what_a_function_raises_comes_out(self):
        with self.assertRaises(ZeroDivisionError):
            microslip.FrictionLaw.sampled(lambda v: 0.3 / v, fastest=1)
        with self.assertRaisesRegex(microslip.Error, "coefficient at slip_velocity = 0 m/s"):
            microslip.FrictionLaw.sampled(lambda v: -1.0, fastest=1)
        with self.assertRaisesRegex(microslip.Error, "must not jump"):
            microslip.FrictionLaw.sampled(lambda v: 0.4 if v < 0.3 else 0.2, fastest=1)

    def test_errors_name_the_place(self):
        with self.assertRaisesRegex(microslip.Error, r"slip_velocities\.3 = 0\.5 \[m/s\]: must be above"):
            microslip.FrictionLaw.table([0, 1, 0.5], [0.3, 0.3, 0.3])


class TractionBoundTest(unittest.TestCase):
    def test_both_shapes_carry_mu_fn(self):
        x, y = np.linspace(-1, 1, 401), np.linspace(-2, 2, 401)
        for bound, peak in (("parabolic", 2), ("elliptic", 1.5)):
            g = microslip.traction_bound(bound, 1, 2, 10, 0.3, x, y[:, None])
            self.assertAlmostEqual(g.max(), peak * 3 / (2 * np.pi), places=12)
            self.assertAlmostEqual(g.sum() * (x[1] - x[0]) * (y[1] - y[0]), 3, delta=1e-3)

    def test_a_misspelt_word_gets_the_nearest_one(self):
        with self.assertRaisesRegex(microslip.Error, 'bound = "eliptic".*did you mean elliptic'):
            microslip.traction_bound("eliptic", 1, 2, 10, 0.3, 0, 0)


load_tests = load_tests_if_compiled([FrictionLawTest, FrictionOfOnesOwnTest, TractionBoundTest])
