"""Profiles: files and arrays, the curve, the report, dimensions, what is refused."""

import copy
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from tests.compiled import load_tests_if_compiled


def head(radius=0.3, n=201):
    """y and z of an arc with y to the field side and z up [m]."""
    angle = np.linspace(-0.12, 0.12, n)
    return radius * np.sin(angle), radius * np.cos(angle) - radius


def flanged():
    """A tread of 1:40 and a flange of 28 mm."""
    angle = np.linspace(0, np.pi, 101)
    tread = np.linspace(-0.03, 0.06, 181)[1:]
    return (np.concatenate([-0.05 - 0.02 * np.cos(angle), tread]),
            np.concatenate([-7.5e-4 - 0.028 * np.sin(angle), tread / 40]))


class ProfileTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_an_arc_has_its_curvature_and_its_length(self):
        rail = microslip.Profile(*head(), kind="rail")
        s = np.linspace(0.1, 0.9, 50) * rail.length
        np.testing.assert_allclose(rail.curvature(s), -1 / 0.3, rtol=1e-5)
        y, z = rail.point(s)
        np.testing.assert_allclose(np.hypot(y, z + 0.3), 0.3, rtol=1e-9)
        np.testing.assert_allclose(np.tan(rail.angle(s)), -y / (z + 0.3), rtol=1e-6, atol=1e-9)
        self.assertIsInstance(rail.curvature(0.01), float)
        self.assertAlmostEqual(rail.length, 0.3 * 0.24, delta=1e-7)
        np.testing.assert_array_equal(rail.y, head()[0])
        self.assertEqual(rail.kind, "rail")

    def test_the_report_shows_what_was_done(self):
        y, z = head()
        report = microslip.Profile(np.append(y[::-1], y[0]), np.append(z[::-1], z[0]), kind="rail").report
        self.assertEqual((report.points_read, report.points), (202, 201))
        self.assertEqual(len(report.steps), 2)
        for text in ("201 points of 202", "done: turned round", "done: dropped 1 point"):
            self.assertIn(text, repr(report))
        upside_down = microslip.Profile(y, -z, kind="rail").report
        self.assertIn("warning: the head is lower than its sides", repr(upside_down))

    def test_smoothing_takes_waves_off(self):
        y, z = head(n=2001)
        wave = 1e-6 * np.sin(2 * np.pi * y / 1e-3)
        smooth = microslip.Profile(y, z + wave, kind="rail", smoothing_length=4e-3)
        self.assertEqual(smooth.report.smoothing_length, 4e-3)
        np.testing.assert_allclose(smooth.measured_z, z + wave)
        self.assertLess(np.abs(smooth.z - z)[400:-400].max(), 2e-8)

    def test_files_there_and_back(self):
        wheel = microslip.Profile(*flanged(), kind="wheel")
        for name in ("a.prw", "b.whl", "wheel.txt"):
            wheel.write(self.folder / name)
            again = microslip.read_profile(self.folder / name)
            self.assertEqual(again.kind, "wheel")
            np.testing.assert_allclose(again.y, wheel.y, atol=1e-15)
            np.testing.assert_allclose(again.z, wheel.z, atol=1e-15)
        self.assertEqual(again.report.unit, 1e-3)
        self.assertEqual(len(again.report.assumptions), 4)
        given = microslip.read_profile(self.folder / "wheel.txt", kind="wheel", unit=1e-3, y_axis="field", z_axis="up")
        self.assertEqual(given.report.assumptions, [])
        trimmed = microslip.read_profile(self.folder / "a.prw", trim=(-0.03, 0.03), smoothing_length=3e-3)
        self.assertGreaterEqual(trimmed.y[0], -0.0301)

    def test_standards_by_name_and_columns_in_any_order(self):
        thin = microslip.read_profile("S1002", flange_thickness=0.0305)
        self.assertAlmostEqual(thin.wheel_dimensions().flange_thickness, 0.0305, delta=2e-8)
        self.assertAlmostEqual(thin.wheel_dimensions().tape_circle, 0, delta=1e-12)
        rail = microslip.read_profile("54E1")
        self.assertEqual((rail.kind, rail.report.format), ("rail", "EN 13674-1"))
        np.savetxt(self.folder / "swapped.txt", np.column_stack([1e3 * rail.z, np.arange(rail.z.size), -1e3 * rail.y]))
        again = microslip.read_profile(self.folder / "swapped.txt", kind="rail", columns="z,-,y", side="right")
        np.testing.assert_allclose(again.y, rail.y, atol=1e-15)
        with self.assertRaisesRegex(ValueError, 'side = "middle": must be left or right'):
            microslip.read_profile(self.folder / "swapped.txt", side="middle")
        with self.assertRaises(FileNotFoundError):
            microslip.read_profile("S102")

    def test_slices_have_an_extent(self):
        """That of the slices a file names, in a turn that they close as well."""
        self.assertIsNone(microslip.Profile(*head(), kind="rail").extent)
        microslip.Profile(*flanged(), kind="wheel").write(self.folder / "wheel.prw")
        angles = np.radians(np.linspace(-180, 170, 36))
        slices = "".join(f"{angle} 'wheel.prw'\n" for angle in angles)
        (self.folder / "wheel.slcw").write_text(f"0 1\n{angles.size}\n0\n1\n{slices}")
        wheel = microslip.read_profile(self.folder / "wheel.slcw")
        np.testing.assert_allclose(wheel.extent, (angles[0], angles[-1]), atol=1e-12)

    def test_dimensions(self):
        wheel = microslip.Profile(*flanged(), kind="wheel")
        dimensions = wheel.wheel_dimensions()
        self.assertEqual(dimensions.tape_line, 0)
        self.assertAlmostEqual(dimensions.flange_height, 0.02875, delta=1e-7)
        self.assertIsNone(wheel.wheel_dimensions(tape_line=0.2).flange_height)
        rail = microslip.Profile(*head(), kind="rail")
        gauge = rail.gauge_point()
        self.assertFalse(gauge.reaches_height)
        self.assertAlmostEqual(gauge.y, head()[0][0], places=12)
        self.assertAlmostEqual(gauge.top[1], 0, places=12)

    def test_values_are_copied_compared_and_pickled(self):
        rail = microslip.Profile(*head(), kind="rail")
        for other in (copy.copy(rail), copy.deepcopy(rail), pickle.loads(pickle.dumps(rail)),
                      microslip.Profile(*head(), kind="rail")):
            self.assertEqual(other, rail)
            self.assertEqual(other.report, rail.report)
            self.assertEqual(other.curvature(0.02), rail.curvature(0.02))
        self.assertNotEqual(rail, microslip.Profile(*head(0.31), kind="rail"))
        self.assertEqual(rail.to_dict()["kind"], "rail")

    def test_errors_name_field_value_and_range(self):
        y, z = head()
        cases = ((lambda: microslip.Profile(y, z[1:], kind="rail"), r"z has shape \(200,\): must be \(201,\)"),
                 (lambda: microslip.Profile(y, z, kind="wheels"), r'kind = "wheels": must be rail or wheel; did you mean wheel'),
                 (lambda: microslip.Profile(y * 1e3, z * 1e3, kind="rail"), "is the unit of length right"),
                 (lambda: microslip.Profile(y, z + np.nan, kind="rail"), r"z of point 1 = nan \[m\]: must be finite"),
                 (lambda: microslip.Profile(y, z, kind="rail", smoothing_length=-1), r"smoothing_length = -1 \[m\]"),
                 (lambda: microslip.Profile(y, z, kind="rail", trim=(1.0, 2.0)), "no point has y within"),
                 (lambda: microslip.Profile(y, z, kind="rail").wheel_dimensions(), "the profile is of a rail"),
                 (lambda: microslip.Profile(y, z, kind="rail").gauge_point(-1), r"gauge_height = -1 \[m\]: must be positive"),
                 (lambda: microslip.Profile(y, z, kind="rail").write(self.folder / "a.prw"), "is for the profile of a wheel"))
        for call, text in cases:
            with self.assertRaisesRegex(microslip.Error, text):
                call()
        with self.assertRaises(FileNotFoundError):
            microslip.read_profile(self.folder / "none.prr")


load_tests = load_tests_if_compiled([ProfileTest])
