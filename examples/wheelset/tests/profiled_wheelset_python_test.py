"""The wheelset on real profiles in Python. Environment: PROFILES, the folder of the profiles."""

import os
import sys
import unittest

import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import profiled_wheelset as model
from wheelset import growth_of_run


class ProfiledWheelsetTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.contact = model.contact_on(os.environ["PROFILES"])

    def test_jacobian_is_that_of_the_rates(self):
        wheelset = model.ProfiledWheelset(self.contact, 40.0)
        z = wheelset.standing(2e-3)
        z[model.YAW], z[model.LATERAL_RATE], z[model.ROLL_RATE], z[model.YAW_RATE] = 5e-4, 0.01, 0.01, 0.02
        jacobian = wheelset.jacobian(z)
        for k, step in enumerate((1e-8, 1e-8, 1e-8, 1e-7, 1e-6, 1e-6, 1e-6, 1e-6, 1e-6)):
            change = step * np.eye(9)[k]
            difference = (wheelset.rates(z + change) - wheelset.rates(z - change)) / (2 * step)
            np.testing.assert_allclose(jacobian[:, k], difference, rtol=0, atol=5e-3 * np.abs(difference).max())

    def test_grows_as_the_eigenvalues_say(self):
        # 66 m/s is above the critical speed, 50 m/s below it, as in C++.
        self.assertLess(model.growth_rate(self.contact, 50.0), 0)
        wanted = model.growth_rate(self.contact, 66.0)
        self.assertGreater(wanted, 0)
        states, integrator = model.run(model.ProfiledWheelset(self.contact, 66.0), 1e-6, 0.8)
        self.assertAlmostEqual(growth_of_run(states[:, model.LATERAL], 0.2), wanted, delta=0.02)
        self.assertLess(integrator.jacobians, 10)


if __name__ == "__main__":
    unittest.main()
