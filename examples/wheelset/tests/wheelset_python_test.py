"""The wheelset in Python finds what the one in C++ prints. Environment: MICROSLIP_C, the library; WHEELSET, the program."""

import os
import re
import subprocess
import sys
import unittest

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import wheelset


class WheelsetTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.law = wheelset.ContactLaw(os.environ["MICROSLIP_C"])
        cls.printed = subprocess.run([os.environ["WHEELSET"]], capture_output=True, text=True, check=True).stdout

    def number(self, pattern):
        return float(re.search(pattern, self.printed).group(1))

    def test_critical_speed(self):
        wanted = self.number(r"Critical speed: ([\d.]+) m/s")
        self.assertAlmostEqual(wheelset.critical_speed(self.law), wanted, delta=6e-4)

    def test_growth_in_the_nonlinear_run(self):
        speed = wheelset.critical_speed(self.law)
        for ratio in ("0.80", "1.20"):
            wanted = self.number(rf"[\d.]+ +{ratio} +\S+ +(\S+)")
            states = wheelset.run(wheelset.Wheelset(self.law, float(ratio) * speed), 1e-6, 3)
            self.assertAlmostEqual(wheelset.growth_of_run(states[:, wheelset.LATERAL]), wanted, delta=6e-5)

    def test_a_refusal_has_words(self):
        with self.assertRaisesRegex(RuntimeError, "out of range"):
            self.law.hertz(wheelset.Bodies(), 1.0)


if __name__ == "__main__":
    unittest.main()
