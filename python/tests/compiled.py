"""The compiled module for its tests; without it they are skipped, and the pictures' tests run alone."""

import importlib.util
import math
import unittest

import microslip

is_compiled = importlib.util.find_spec("microslip._core") is not None


def load_tests_if_compiled(cases):
    """A load_tests function for a file of tests that all need the compiled module."""
    def load_tests(loader, _tests, _pattern):
        suite = unittest.TestSuite()
        for case in cases:
            suite.addTests(loader.loadTestsFromTestCase(case if is_compiled else unittest.skip("not compiled")(case)))
        return suite
    return load_tests


def wheel_on_rail():
    """Hertz's contact and the combined material of the README's example."""
    steel = microslip.Material.from_young(210e9, 0.28)
    pair = microslip.combine(steel, steel)
    gap = microslip.gap_curvatures(0.46, math.inf, math.inf, 0.3)
    return microslip.hertz_from_load(gap, pair, 80e3), pair


def contact(creepage=(0.0018, 0.0006, 0.4), friction=0.3):
    """The README's example."""
    hertz, pair = wheel_on_rail()
    return microslip.EllipticContact(hertz.a, hertz.b, pair.shear_modulus, pair.poisson_ratio, 80e3, friction, creepage, rolling_speed=1.0)
