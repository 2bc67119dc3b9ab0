"""The picture of equivalent conicity shows the numbers of its file, with the standard's band and gaps at jumps."""

import unittest

import h5py
import numpy as np

from tests.figures import figures_written_by


def write_conicity(path, gauges, sides=1):
    """Conicities of 0.06 and 0.2, the last one unknown; a rolling radius difference that jumps by 1 mm at 2 mm, where points of
    contact move by 18 mm; the right side like the left one unless there are two sides."""
    lateral = np.array([-4e-3, 0, 2e-3, 2e-3 + 1e-9, 4e-3])
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "conicity", "title": "wheel on rail", "version": "0.2.0", "commit": "abc"})
        file["amplitude"], file["gauges"] = np.array([1e-3, 2e-3, 3e-3]), np.array(gauges)
        for number in range(len(gauges)):
            file[f"gauge_{number}/conicity"] = np.array([0.06, 0.2, np.nan])
            curve = f"gauge_{number}/curve"
            file[f"{curve}/lateral"] = lateral
            file[f"{curve}/rolling_radius_difference"] = np.array([-2e-3, 0, 1e-3, 2e-3, 3e-3])
            file[f"{curve}/contact_angle_difference"] = np.radians([-2, 0, 1, 5, 6])
            file[f"{curve}/vertical"] = np.array([1e-4, 0, 1e-4, 1e-4, 2e-4])
            for side in ("left", "right"):
                for body in ("rail", "wheel"):
                    file[f"{curve}/{side}_{body}_y"] = np.array([4e-3, 0, -2e-3, -20e-3, -22e-3])
                    file[f"{curve}/{side}_{body}_z"] = np.zeros(5)
        for side in ("left", "right")[:sides]:
            for body in ("rail", "wheel"):
                file[f"profiles/{side}_{body}/y"] = np.linspace(-0.03, 0.03, 61)
                file[f"profiles/{side}_{body}/z"] = np.zeros(61)


class ConicityPictureTest(unittest.TestCase):
    def panels(self, gauges, picture="conicity.png", sides=1):
        return figures_written_by(write_conicity, gauges, sides)[picture].axes

    def test_conicity_over_the_amplitude_in_millimetres(self):
        line = self.panels([1.435])[0].lines[0]
        np.testing.assert_allclose(line.get_xdata(), [1, 2, 3])
        np.testing.assert_allclose(line.get_ydata(), [0.06, 0.2, np.nan])

    def test_the_band_is_half_the_conicity_but_at_most_a_twentieth(self):
        vertices = self.panels([1.435])[0].collections[0].get_paths()[0].vertices
        for point in ([1, 0.03], [1, 0.09], [2, 0.15], [2, 0.25]):
            self.assertTrue(np.any(np.all(np.isclose(vertices, point), axis=1)), point)

    def test_several_gauges_have_a_line_each_and_no_band(self):
        axes = self.panels([1.43, 1.435, 1.44])[0]
        self.assertEqual(len(axes.lines), 3)
        self.assertEqual(len(axes.collections), 0)
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()],
                         ["gauge 1430.00 mm", "gauge 1435.00 mm", "gauge 1440.00 mm"])

    def test_a_jump_is_a_gap_whose_ends_are_marked(self):
        radii = self.panels([1.435])[1]
        curve, ends, jump = radii.lines
        self.assertEqual(np.count_nonzero(np.isnan(curve.get_ydata())), 1)
        np.testing.assert_allclose(ends.get_ydata(), [1, 2])
        np.testing.assert_allclose(jump.get_xdata(), [2, 2])

    def test_points_that_touch_are_joined_and_jumps_are_bold(self):
        axes = self.panels([1.435], "contact_points.png")[0]
        (lines,) = axes.collections
        segments, widths = np.array(lines.get_segments()), np.array(lines.get_linewidths())
        np.testing.assert_allclose(segments[:, 1, 1] - segments[:, 0, 1], 25)
        np.testing.assert_allclose(np.sort(segments[widths > 1][:, 0, 0]), [-20, -2])

    def test_unequal_sides_have_a_panel_each(self):
        labels = [axes.get_xlabel() for axes in self.panels([1.435], "contact_points.png", sides=2)]
        self.assertEqual(labels.count("y of both profiles [mm], to the field side"), 2)


if __name__ == "__main__":
    unittest.main()
