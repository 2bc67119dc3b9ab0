"""Materials and Hertz: closed forms, inverses of each other, errors with field and range."""

import math
import unittest

import numpy as np

import microslip
from tests.compiled import load_tests_if_compiled, wheel_on_rail


class MaterialTest(unittest.TestCase):
    def test_two_equal_bodies_keep_their_constants(self):
        steel = microslip.Material.from_young(210e9, 0.28)
        pair = microslip.combine(steel, steel)
        self.assertAlmostEqual(steel.shear_modulus, 210e9 / 2.56, delta=1)
        self.assertEqual((pair.shear_modulus, pair.poisson_ratio, pair.dissimilarity), (steel.shear_modulus, 0.28, 0))
        self.assertEqual(pair.contact_modulus, pair.shear_modulus / 0.72)

    def test_the_other_order_reverses_the_dissimilarity(self):
        steel, rubber = microslip.Material(80e9, 0.28), microslip.Material(1e6, 0.4)
        one, other = microslip.combine(steel, rubber), microslip.combine(rubber, steel)
        self.assertLess(one.dissimilarity, 0)
        self.assertEqual(one.dissimilarity, -other.dissimilarity)

    def test_errors_name_field_value_and_range(self):
        with self.assertRaisesRegex(microslip.Error, r"poisson_ratio = 0\.62 \[-\]: must be in \[0, 0\.5\]"):
            microslip.Material.from_young(210e9, 0.62)
        self.assertTrue(issubclass(microslip.Error, ValueError))
        with self.assertRaises(TypeError):
            microslip.Material.from_young("steel", 0.28)


class HertzTest(unittest.TestCase):
    def test_a_ball_on_a_plane(self):
        steel = microslip.Material(80e9, 0.25)
        pair = microslip.combine(steel, steel)
        hertz = microslip.hertz_from_load(microslip.GapCurvatures(0.5 / 0.1, 0.5 / 0.1), pair, 1e3)
        # Johnson 1985, (3.3): a^3 = 3 F R/(4 E*).
        self.assertAlmostEqual(hertz.a / (0.75 * 1e3 * 0.1 / pair.contact_modulus) ** (1 / 3), 1, places=12)
        self.assertEqual(hertz.a, hertz.b)

    def test_load_approach_and_ellipse_belong_together(self):
        hertz, pair = wheel_on_rail()
        for other in (microslip.hertz_from_approach(hertz.gap, pair, hertz.approach),
                      microslip.hertz_from_ellipse(hertz.a, hertz.b, pair, hertz.normal_force)):
            for name in ("a", "b", "normal_force", "approach", "peak_pressure", "stiffness"):
                self.assertAlmostEqual(getattr(other, name) / getattr(hertz, name), 1, places=11)

    def test_pressure_takes_numbers_and_arrays(self):
        hertz, _ = wheel_on_rail()
        self.assertIsInstance(hertz.pressure(0, 0), float)
        self.assertEqual(hertz.pressure(0, 0), hertz.peak_pressure)
        x, y = np.linspace(-hertz.a, hertz.a, 201), np.linspace(-hertz.b, hertz.b, 201)
        pressure = hertz.pressure(x[None, :], y[:, None])
        self.assertEqual(pressure.shape, (201, 201))
        force = pressure.sum() * (x[1] - x[0]) * (y[1] - y[0])
        self.assertAlmostEqual(force / hertz.normal_force, 1, delta=1e-3)

    def test_line_contact(self):
        _, pair = wheel_on_rail()
        line = microslip.line_contact_from_load(1 / 0.92, pair, 1e6)
        self.assertAlmostEqual(line.peak_pressure, 2e6 / (math.pi * line.half_width), delta=1)
        again = microslip.line_contact_from_half_width(line.curvature, pair, line.half_width)
        self.assertAlmostEqual(again.force_per_length / 1e6, 1, places=12)
        np.testing.assert_allclose(line.pressure([0, line.half_width]), [line.peak_pressure, 0])

    def test_shapes_that_do_not_go_together_are_named(self):
        hertz, _ = wheel_on_rail()
        with self.assertRaisesRegex(microslip.Error, r"y has shape \(4,\).*\(3,\)"):
            hertz.pressure(np.zeros(3), np.zeros(4))


load_tests = load_tests_if_compiled([MaterialTest, HertzTest])
