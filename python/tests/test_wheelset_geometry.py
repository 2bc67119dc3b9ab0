"""A rigid wheelset on rails from Python: closed forms of cones and arcs, maps, sides that differ, refusals."""

import tempfile
import unittest
from pathlib import Path

import microslip
import numpy as np
from tests.compiled import load_tests_if_compiled

PROFILES = Path(__file__).resolve().parents[2] / "examples" / "profiles"
CONE, DISTANCE, RADIUS = 0.05, 1.5, 0.46


def head():
    """A round head of 0.3 m."""
    y = np.linspace(-0.03, 0.03, 401)
    return microslip.Profile(y, np.sqrt(0.09 - y**2) - 0.3, "rail")


def cone(inclination=CONE):
    y = np.linspace(-0.06, 0.06, 13)
    return microslip.Profile(y, inclination * y, "wheel")


def cones(**options):
    """Cones on round heads 1.5 m apart."""
    given = {"track": microslip.Track(rail_origin=(0.75, 0.0)), "rail": head(), "wheelset": microslip.Wheelset(), "wheel": cone()}
    return microslip.WheelsetGeometry(**{**given, **options})


def s1002(**options):
    """S1002 on 60E1 with 1:40."""
    rail, wheel = (microslip.read_profile(PROFILES / name) for name in ("60e1.prr", "s1002.prw"))
    return microslip.WheelsetGeometry(track=microslip.Track(gauge=1.435, cant=0.025), rail=rail, wheelset=microslip.Wheelset(),
                                      wheel=wheel, **options)


def varied_rail(folder):
    """60E1 in two slices along the track."""
    file = Path(folder) / "rail.slcs"
    file.write_text(f"0 1000\n2\n0\n1\n0 '{PROFILES}/60e1.prr'\n1 '{PROFILES}/60e1.prr'\n")
    return microslip.read_profile(file)


class WheelsetGeometryTest(unittest.TestCase):
    def test_profiles_that_vary_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            rail = varied_rail(folder)
            for right in ({}, {"right_rail": rail}):
                with self.assertRaisesRegex(ValueError, "rail.slcs|60e1.prr: WheelsetGeometry needs the same profile all along"):
                    cones(rail=head() if right else rail, **right)
            with self.assertRaisesRegex(ValueError, "a profile's file needs the same profile all along"):
                rail.write(Path(folder) / "written.prr")
            self.assertFalse((Path(folder) / "written.prr").exists())

    def test_cones_have_the_difference_of_their_inclination(self):
        lateral, yaw = np.array([-4e-3, 0.0, 2e-3]), np.array([[0.0], [0.01]])
        found = cones().contact(lateral, yaw, roll="none")
        self.assertEqual(found.rolling_radius_difference.shape, (2, 3))
        self.assertEqual(len(found), 6)
        np.testing.assert_allclose(found.rolling_radius_difference[0], 2 * CONE * lateral, atol=1e-9)
        np.testing.assert_allclose(found.contact_angle_difference[0], 0, atol=1e-12)
        np.testing.assert_allclose(found.left_contact_angle[0], np.arctan(CONE), atol=1e-12)
        np.testing.assert_allclose(found.right_contact_angle[0], -np.arctan(CONE), atol=1e-12)
        np.testing.assert_allclose(found.left_wheel_y[0] - found.right_wheel_y[0], -2 * lateral, atol=1e-9)
        np.testing.assert_allclose(found.left_place_y[0], -found.right_place_y[0], atol=1e-9)
        self.assertTrue((found.roll == 0).all())
        self.assertTrue((found.left_place_x[1] < 0).any() or (found.left_place_x[1] > 0).any())
        self.assertTrue((np.sign(cones().contact(lateral).roll) == np.sign(lateral)).all())

    def test_cones_have_their_inclination_as_conicity(self):
        pair, amplitude = cones(contact_distance=DISTANCE), np.linspace(1e-3, 5e-3, 5)
        np.testing.assert_allclose(pair.equivalent_conicity(amplitude, roll="none"), CONE, rtol=1e-6)
        klingel = 2 * np.pi * np.sqrt(DISTANCE * RADIUS / (2 * CONE))
        self.assertAlmostEqual(pair.wavelength(3e-3, roll="none"), klingel, delta=1e-5 * klingel)
        self.assertAlmostEqual(pair.nonlinearity_parameter(roll="none"), 0, delta=1e-3)
        wanted = 2 * CONE * 4e-3 * 500 / (DISTANCE * RADIUS)
        self.assertAlmostEqual(pair.radial_steering_index(4e-3, 500.0, roll="none"), wanted, delta=1e-5 * wanted)

    def test_maps_over_gauge_and_amplitude(self):
        pair = s1002()
        amplitude, gauge = np.array([1e-3, 3e-3, 6e-3]), np.array([[1.432], [1.435]])
        found = pair.equivalent_conicity(amplitude, gauge=gauge, threads=2)
        self.assertEqual(found.shape, (2, 3))
        np.testing.assert_array_equal(found, pair.equivalent_conicity(amplitude, gauge=gauge, threads=1))
        self.assertEqual(found[1, 2], pair.equivalent_conicity(amplitude)[2])
        self.assertGreater(found[0, 1], found[1, 1])  # a narrower track is stiffer
        self.assertEqual(pair.nonlinearity_parameter(gauge=gauge).shape, (2, 1))
        by_hand = np.diff(pair.equivalent_conicity([2e-3, 4e-3]))[0] / 2e-3
        self.assertAlmostEqual(pair.nonlinearity_parameter(), by_hand, delta=1e-6 * abs(by_hand))

    def test_a_curve_is_what_conicity_is_found_from(self):
        pair = s1002()
        curve = pair.curve(-6e-3, 6e-3)
        self.assertTrue((np.diff(curve.lateral) >= 0).all())
        self.assertGreater(len(curve), 120)
        difference = microslip.RollingRadiusDifference(curve.lateral, curve.rolling_radius_difference)
        self.assertAlmostEqual(difference.equivalent_conicity(3e-3), pair.equivalent_conicity(3e-3), delta=1e-6)
        np.testing.assert_allclose(difference.at(curve.lateral[3:5]), curve.rolling_radius_difference[3:5], atol=1e-12)
        self.assertTrue(np.isnan(difference.at(0.02)))
        self.assertTrue(np.isnan(pair.equivalent_conicity(0.06)))  # a wheel leaves its rail

    def test_sides_may_differ(self):
        one, other = cones(right_wheel=cone(0.1)), cones(wheel=cone(0.1), right_wheel=cone())
        lateral = np.array([-2e-3, 0.0, 3e-3])
        np.testing.assert_allclose(one.contact(lateral).rolling_radius_difference,
                                   -other.contact(-lateral).rolling_radius_difference, atol=1e-10)

    def test_a_table_has_closed_forms(self):
        lateral = np.linspace(-0.01, 0.01, 2001)
        cubic = microslip.RollingRadiusDifference(lateral, 0.1 * lateral + 900 * lateral**3)
        self.assertGreater(cubic.equivalent_conicity(6e-3), cubic.equivalent_conicity(1e-3))
        self.assertGreater(cubic.nonlinearity_parameter(), 0)
        steep = microslip.RollingRadiusDifference([-0.01, 0.01], [-0.004, 0.004])
        self.assertAlmostEqual(steep.equivalent_conicity(2e-3, 1.2, 0.4), 0.2, delta=1e-6)
        self.assertAlmostEqual(steep.radial_steering_index(5e-3, 300.0), 0.002 * 300 / (1.5 * 0.46))

    def test_no_contact_is_a_status_and_not_a_number(self):
        found = s1002().contact([0.0, 0.3])
        self.assertEqual(found.status.tolist(), [microslip.Status.ok, microslip.Status.no_contact])
        self.assertTrue(np.isnan(found.left_rolling_radius[1]) and not np.isnan(found.left_rolling_radius[0]))

    def test_what_makes_no_sense_is_refused(self):
        for text, call in (("must be equilibrium or none", lambda: cones().contact(0.0, roll="non")),
                           ("contact_distance", lambda: cones(contact_distance=-1.0)),
                           ("rail", lambda: cones(rail=cone())),
                           ("gauge", lambda: s1002().equivalent_conicity(1e-3, gauge=-1.0)),
                           ("amplitude", lambda: s1002().equivalent_conicity([1e-3, -2e-3])),
                           ("curve_radius", lambda: s1002().radial_steering_index(1e-3, -5.0)),
                           ("does not match", lambda: s1002().contact([0.0, 1e-3, 2e-3], [0.0, 1e-3])),
                           ("from must be", lambda: s1002().curve(0.0, 0.0)),
                           ("ascend", lambda: microslip.RollingRadiusDifference([0.0, -1.0], [0.0, 0.0])),
                           ("rolling radius difference = nan", lambda: microslip.RollingRadiusDifference([0.0, 1.0], [np.nan, 0.0]))):
            with self.assertRaisesRegex(microslip.Error, text):
                call()


load_tests = load_tests_if_compiled([WheelsetGeometryTest])
