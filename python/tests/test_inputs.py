"""The table of inputs, and that defaults of keyword parameters are its defaults."""

import inspect
import re
import unittest

import microslip
from tests.compiled import load_tests_if_compiled


class InputsTest(unittest.TestCase):
    def of(self, kind):
        return {(one["section"], one["key"]): one for one in microslip.inputs(kind)}

    def test_keys_have_units_ranges_and_defaults(self):
        bodies, wheel = self.of("bodies"), self.of("wheel")
        self.assertEqual(bodies["load", "normal_force"]["unit"], "N")
        self.assertTrue(bodies["load", "normal_force"]["needed"])
        self.assertEqual(bodies["solution", "grid"]["default"], 20)
        self.assertEqual(wheel["solution", "tolerance"]["range"], "in [1e-12, 0.01]")
        self.assertEqual(wheel["solution", "theory"]["words"], ["fastsim2", "exact", "table"])
        self.assertTrue(wheel["wheel", "yaw"]["state"])
        self.assertIn(("wheel", "axle_torque"), self.of("wheelset"))
        self.assertEqual(self.of("table")["", "poisson_ratio"]["default"], [0, 0.28, 0.5])
        self.assertTrue(self.of("sweep")["sample", "seed"]["needed"])
        with self.assertRaisesRegex(microslip.Error, "must be bodies, wheel, wheelset, sweep, conicity or table"):
            microslip.inputs("bogie")

    def defaults(self, function):
        """Defaults of the parameters in a docstring's signature."""
        found = re.findall(r"(\w+): [^=,]*(?:\[[^\]]*\])? = ('[^']*'|[-\d.e]+)", function.__doc__.splitlines()[0])
        return {name: value.strip("'") for name, value in found}

    def test_defaults_of_keywords_are_those_of_case_files(self):
        wheel = self.of("wheel") | self.of("conicity")
        count = 0
        for function, sections in ((microslip.WheelRail.__init__, ["solution", "wheel"]), (microslip.Track.__init__, ["track"]),
                                   (microslip.Wheelset.__init__, ["wheelset"]), (microslip.WheelsetOnTrack.__init__, ["solution"]),
                                   (microslip.WheelsetGeometry.__init__, [""]), (microslip.WheelsetGeometry.contact, [""])):
            for name, value in self.defaults(function).items():
                for section in sections:
                    known = wheel.get((section, name))
                    if known is None or known["default"] is None:
                        continue
                    count += 1
                    default = known["default"]
                    self.assertEqual(value if isinstance(default, str) else float(value), default, f"{function} {name}")
        self.assertGreater(count, 10)


load_tests = load_tests_if_compiled([InputsTest])

if __name__ == "__main__":
    unittest.main()
