"""Contacts, creepages and creepage coefficients: conversions, assignment, text."""

import unittest

import microslip
from tests.compiled import contact, load_tests_if_compiled


class ContactTest(unittest.TestCase):
    def test_numbers_stand_for_laws_and_creepages(self):
        made = contact()
        self.assertEqual(made.friction.static_coefficient, 0.3)
        self.assertEqual(tuple(made.creepage), (0.0018, 0.0006, 0.4))
        made.friction, made.creepage = microslip.FrictionLaw.coulomb(0.4), microslip.Creepage(lateral=0.001)
        self.assertEqual(made.friction.static_coefficient, 0.4)
        made.creepage.spin = 0.2
        self.assertEqual(tuple(made.creepage), (0, 0.001, 0.2))

    def test_wrong_types_are_named(self):
        made = contact()
        with self.assertRaisesRegex(TypeError, "friction: .*'dry'"):
            made.friction = "dry"
        with self.assertRaisesRegex(TypeError, "creepage: "):
            made.creepage = (1, 2)

    def test_text(self):
        self.assertEqual(repr(microslip.Creepage(0.001)), "Creepage(longitudinal=0.001, lateral=0.0, spin=0.0)")
        self.assertIn("status=ok", repr(microslip.Fastsim2().solve(contact())))

    def test_coefficients_of_the_circle(self):
        # Kalker 1990, table E.3, a/b = 1, nu = .25.
        c = microslip.creepage_coefficients(1, 0.25)
        for found, printed in zip((c.c11, c.c22, c.c23, c.c33), (4.12, 3.67, 1.47, 1.19)):
            self.assertAlmostEqual(found, printed, places=12)
        computed = microslip.creepage_coefficients(1, 0.25, "computed")
        self.assertAlmostEqual(computed.c11, 4.12, delta=0.02)


load_tests = load_tests_if_compiled([ContactTest])
