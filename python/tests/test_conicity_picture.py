"""The picture of equivalent conicity shows the numbers of its file, with the standard's band and gaps at jumps."""

import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib
import numpy as np

from microslip import plot
from microslip.picture_style import SETTINGS
from microslip.result_file import ResultFile


def write_conicity(path, gauges):
    """Conicities of .06 and .2, the last one unknown; a rolling radius difference that jumps by 1 mm at 2 mm."""
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


class ConicityPictureTest(unittest.TestCase):
    def panels(self, gauges):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "result.h5"
            write_conicity(path, gauges)
            with ResultFile(path) as result, matplotlib.rc_context(SETTINGS):
                return plot.pictures(result)["conicity.png"].axes

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

    def test_a_jump_is_a_gap_with_a_dotted_line(self):
        radii = self.panels([1.435])[1]
        curve, jump = radii.lines
        self.assertEqual(np.count_nonzero(np.isnan(curve.get_ydata())), 1)
        np.testing.assert_allclose(jump.get_ydata(), [1, 2])


if __name__ == "__main__":
    unittest.main()
