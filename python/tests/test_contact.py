"""Contacts, creepages and creepage coefficients: conversions, assignment, text."""

import math
import unittest

import microslip
import numpy as np
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

    def test_a_speed_is_asked_for_where_friction_depends_on_it(self):
        numbers = (6e-3, 5e-3, 82e9, 0.28, 80e3)
        with self.assertRaisesRegex(microslip.Error, "rolling_speed: must be given"):
            microslip.EllipticContact(*numbers, microslip.FrictionLaw.polach(0.3, 0.4, 0.6))
        self.assertEqual(microslip.EllipticContact(*numbers, microslip.FrictionLaw.polach(0.3, 0.4, 0.6), rolling_speed=20.0).rolling_speed, 20)
        self.assertEqual(microslip.EllipticContact(*numbers, 0.3).rolling_speed, 1)

    def test_text(self):
        self.assertEqual(repr(microslip.Creepage(0.001)), "Creepage(longitudinal=0.001, lateral=0.0, spin=0.0)")
        self.assertIn("status=ok", repr(microslip.Fastsim2().solve(contact())))

    def test_coefficients_of_the_circle(self):
        # Kalker 1990, table E.3, a/b = 1, nu = 0.25.
        c = microslip.creepage_coefficients(1, 0.25)
        for found, printed in zip((c.c11, c.c22, c.c23, c.c33), (4.12, 3.67, 1.47, 1.19)):
            self.assertAlmostEqual(found, printed, places=12)
        computed = microslip.creepage_coefficients(1, 0.25, "computed")
        self.assertAlmostEqual(computed.c11, 4.12, delta=0.02)


class WarningsTest(unittest.TestCase):
    """Numbers that look like other units."""

    def test_a_contact_has_texts(self):
        plausible, in_millimetres = contact(), contact()
        in_millimetres.a, in_millimetres.b = 1e3 * plausible.a, 1e3 * plausible.b
        self.assertEqual(plausible.warnings, [])
        [text] = in_millimetres.warnings
        self.assertIn("peak pressure", text)
        self.assertIn("check units, lengths in m, moduli in Pa, forces in N", text)
        in_millimetres.a = math.nan
        self.assertEqual(in_millimetres.warnings, [])

    def test_arrays_have_codes(self):
        like, names = contact(), list(microslip.warning_texts())
        moduli = np.array([82e9, 82e3, -1.0])
        many = microslip.Fastsim2().solve_batch(like, shear_modulus=moduli, a=[[like.a], [1e3 * like.a]],
                                                  b=[[like.b], [1e3 * like.b]])
        self.assertEqual(many.warning_code.shape, (2, 3))
        self.assertEqual(many.warning_code.dtype, np.uint32)

        def found(code):
            return {name for bit, name in enumerate(names) if code >> bit & 1}

        self.assertEqual(found(many.warning_code[0, 0]), set())
        self.assertEqual(found(many.warning_code[0, 1]), {"soft_material", "extreme_pressure"})
        self.assertEqual(found(many.warning_code[1, 0]), {"faint_pressure"})
        self.assertEqual(found(many.warning_code[0, 2]), set())  # invalid_input says enough


load_tests = load_tests_if_compiled([ContactTest, WarningsTest])
