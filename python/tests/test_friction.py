"""Friction laws and traction bounds: values at rest, at the half velocity and far out; integrals of the bound."""

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


load_tests = load_tests_if_compiled([FrictionLawTest, TractionBoundTest])
