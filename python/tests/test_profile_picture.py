"""The picture of a profile shows the numbers of its result file."""

import unittest

import h5py
import numpy as np

from tests.figures import figures_written_by


def write_profile(path, role, kinks=(), dimensions=None):
    """A semicircle of 30 mm radius, upside down for a wheel."""
    angle = np.linspace(np.pi, 0, 91)
    y, z = 0.03 * np.cos(angle), 0.03 * np.sin(angle) * (1 if role == "rail" else -1)
    arrays = {"measured/y": y, "measured/z": z, "curve/y": y, "curve/z": z, "curve/s": 0.03 * (np.pi - angle),
              "curve/angle": np.gradient(z, y), "curve/curvature": np.full(91, 1 / 0.03)}
    with h5py.File(path, "w") as file:
        file.attrs.update(kind="profile", title="semicircle", version="0", commit="0")
        file["role"] = role
        for name, values in arrays.items():
            file[name] = values
        if len(kinks):
            file["kinks/y"], file["kinks/z"] = (y[list(kinks)], z[list(kinks)])
        for name, value in (dimensions or {}).items():
            file[f"dimensions/{name}"] = value


class ProfilePictureTest(unittest.TestCase):
    def figure(self, *arguments, **named):
        return figures_written_by(write_profile, *arguments, **named)["profile.png"]

    def test_a_rail_with_its_gauge_point_and_kinks(self):
        figure = self.figure("rail", kinks=(30, 60), dimensions={"gauge_y": -0.025, "gauge_z": 0.01})
        shape, inclination, bend = figure.axes
        lines = {line.get_label(): line for line in shape.lines}
        self.assertEqual(set(lines), {"points", "spline", "kinks", "gauge point"})
        np.testing.assert_allclose(lines["gauge point"].get_xydata(), [[-25, 10]])
        np.testing.assert_allclose(np.hypot(*lines["spline"].get_xydata().T), 30)
        self.assertEqual(len(lines["kinks"].get_xdata()), 2)
        for axes in (inclination, bend):
            marks = sorted(line.get_xdata()[0] for line in axes.lines[1:])
            np.testing.assert_allclose(marks, [30 * np.pi / 3, 60 * np.pi / 3])
        np.testing.assert_allclose(bend.lines[0].get_ydata(), 1 / 0.03)

    def test_a_rail_shows_how_far_below_the_top_its_gauge_lies(self):
        numbers = {"gauge_y": -0.025, "gauge_z": 0.01, "gauge_height": 0.02, "top_y": 0.0, "top_z": 0.03}
        lines = {line.get_label(): line for line in self.figure("rail", dimensions=numbers).axes[0].lines}
        self.assertEqual(set(lines), {"points", "spline", "gauge point", "top", "20 mm below the top"})
        np.testing.assert_allclose(lines["top"].get_ydata(), 30)
        np.testing.assert_allclose(lines["20 mm below the top"].get_ydata(), 10)

    def test_a_wheel_shows_its_tape_circle_and_thickness(self):
        shape = self.figure("wheel", dimensions={"tape_line": 0.01, "tape_circle": -0.028, "flange_thickness": 0.032}).axes[0]
        lines = {line.get_label(): line for line in shape.lines}
        np.testing.assert_allclose(lines["tape circle"].get_xydata(), [[10, -28]])
        arrow, = (text for text in shape.texts if hasattr(text, "arrow_patch") and text.arrow_patch)
        np.testing.assert_allclose([arrow.xy, arrow.xyann], [[-60, -38], [-28, -38]])

    def test_a_wheel_with_what_there_is_of_its_flange(self):
        figure = self.figure("wheel", dimensions={"tape_line": 0.0, "flange_height": 0.028})
        shape = figure.axes[0]
        self.assertIn("tape line", [line.get_label() for line in shape.lines])
        self.assertEqual([text.get_text() for text in shape.texts], ["Sh 28.00 mm"])
        self.assertIn("wheel: semicircle", figure._suptitle.get_text())
