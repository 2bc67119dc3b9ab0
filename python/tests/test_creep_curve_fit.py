"""Fits of measured creep curves: the document of the program as a dict, and the case that it makes."""

import unittest
from pathlib import Path

import microslip
from tests.compiled import load_tests_if_compiled

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


class CreepCurveFitTest(unittest.TestCase):
    def fit(self, **named):
        return microslip.fit_creep_curve(EXAMPLES / "creep_curve.csv", EXAMPLES / "creep_curve.toml", **named)

    def test_parameters_with_intervals_and_a_case(self):
        fit = self.fit(model="polach")
        self.assertEqual((fit["model"], fit["points"], fit["runs"]), ("polach", 72, ["morning", "evening"]))
        level = fit["parameters"]["friction.static_coefficient of morning"]
        self.assertLess(level["interval"][0], level["value"])
        self.assertGreater(level["interval"][1], level["value"])
        self.assertEqual(microslip.parse_case(fit["case"]).title, "Wet rail")

    def test_a_formula_has_no_case(self):
        self.assertIsNone(self.fit(model="polach_formula")["case"])

    def test_unknown_names(self):
        with self.assertRaisesRegex(ValueError, "did you mean reduced_slope"):
            self.fit(model="reduced_slop")
        with self.assertRaises(FileNotFoundError):
            microslip.fit_creep_curve("missing.csv", EXAMPLES / "creep_curve.toml")


load_tests = load_tests_if_compiled([CreepCurveFitTest])
