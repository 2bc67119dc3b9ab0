"""The wear example: nothing is lost between the patches and the profile, both sides are alike, volume is work."""

import os
import sys
import unittest

import microslip
import numpy as np

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
import wear


def area_between(old, new):
    """Of the polygon along one profile and back along the other one [m^2], by Gauss."""
    y, z = np.concatenate((old.y, new.y[::-1])), np.concatenate((old.z, new.z[::-1]))
    return abs(np.sum(y * np.roll(z, -1) - z * np.roll(y, -1))) / 2


class WearTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.wheel = microslip.read_profile(wear.PROFILES / "s1002.prw")
        cls.service = wear.service(positions=9)
        cls.depth, cls.area = wear.wear_per_metre(cls.wheel, of=cls.service)

    def test_shares_add_up(self):
        self.assertAlmostEqual(wear.service().share.sum(), 1, places=12)

    def test_bins_hold_what_the_patches_wear_off(self):
        self.assertAlmostEqual(self.depth.sum() * wear.BIN / self.area, 1, places=9)

    def test_depth_is_where_the_patches_are(self):
        one = wear.Service(np.array([0.0]), np.array([1.5e-3]), np.array([1.0]))
        depth, _ = wear.wear_per_metre(self.wheel, of=one)
        worn = wear.BIN * np.count_nonzero(depth)
        patches = wear.pair(self.wheel).solve(lateral=0.0, yaw=1.5e-3, vertical_force=wear.LOAD, forward_velocity=wear.SPEED)
        rows = [np.count_nonzero(microslip.friction_work(fields).sum(axis=1)) for fields in patches.fields]
        lengths = [count * fields.grid.dy for count, fields in zip(rows, patches.fields)]
        self.assertAlmostEqual(worn, sum(lengths), delta=4 * wear.BIN * len(lengths))
        self.assertGreater(worn, 5e-3)

    def test_smoothing_keeps_the_volume(self):
        smooth = wear.smoothed(self.depth)
        self.assertAlmostEqual(smooth.sum() / self.depth.sum(), 1, places=12)
        self.assertGreaterEqual(smooth.min(), 0)
        self.assertLess(smooth.max(), self.depth.max())
        self.assertLess(np.abs(np.diff(smooth)).max(), np.abs(np.diff(self.depth)).max() / 3)

    def test_the_profile_loses_what_is_worn_off(self):
        smooth = wear.smoothed(self.depth)
        for deepest in (5e-6, 50e-6):
            depth = smooth * deepest / smooth.max()
            new = wear.worn(self.wheel, depth)
            lost = area_between(self.wheel, new) / (depth.sum() * wear.BIN)
            self.assertAlmostEqual(lost, 1, delta=2e-3 + 100 * deepest)  # depths of curved parts overlap or gape
            self.assertLess(new.wheel_dimensions().flange_thickness, self.wheel.wheel_dimensions().flange_thickness)
            self.assertLess(new.z.min(), self.wheel.z.max())

    def test_both_sides_wear_alike(self):
        depth, area = wear.wear_per_metre(self.wheel, "right", self.service)
        self.assertAlmostEqual(area / self.area, 1, places=12)
        np.testing.assert_allclose(depth, self.depth, atol=1e-12 * self.depth.max())

    def test_volume_is_work_where_one_coefficient_holds(self):
        k = 6e-4
        strength = microslip.SurfaceStrength(hardness=3e9, wear_map=microslip.WearMap(slow=k, medium=k, fast=k, seizure=k))
        _, area = wear.wear_per_metre(self.wheel, of=self.service, strength=strength)
        many = wear.pair(self.wheel).solve_batch(lateral=self.service.lateral, yaw=self.service.yaw, vertical_force=wear.LOAD,
                                                 forward_velocity=wear.SPEED)
        work = np.nansum(self.service.share[:, None] * many.patch_frictional_power / many.patch_rolling_speed
                         / (2 * np.pi * many.patch_rolling_radius))
        # The simplified theory's bound is not quite mu p.
        self.assertAlmostEqual(area / (k / (0.3 * 3e9) * work), 1, delta=0.1)

    def test_a_wheel_that_wears_stays_a_wheel(self):
        steps = list(wear.evolve(20e3))
        distances = [travelled for travelled, _, _ in steps]
        self.assertEqual((distances[0], distances[-1]), (0.0, 20e3))
        heights = [wheel.wheel_dimensions().flange_height for _, wheel, _ in steps]
        self.assertEqual(heights, sorted(heights))  # the tread wears, the tip does not
        for _, wheel, area in steps:
            self.assertFalse(wheel.report.warnings)
            self.assertGreater(area, 0)


if __name__ == "__main__":
    unittest.main()
