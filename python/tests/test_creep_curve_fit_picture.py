"""The picture of a fit shows the points, each curve with its bands, and the deviations."""

import unittest

import h5py
import numpy as np

from tests.figures import figures_written_by


def write_fit(path, runs):
    """Curves of constant 0.3, 0.4, ... with bands of 0.01 and 0.05, points 0.02 above them."""
    creepage = np.array([1e-3, 1e-2, 1e-1])
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "creep_curve_fit", "title": "points", "version": "0.2.0", "commit": "abc"})
        level = np.repeat(0.3 + 0.1 * np.arange(len(runs)), 3)
        number = np.repeat(np.arange(len(runs), dtype=float), 3)
        for name, values in {"creepage": np.tile(creepage, len(runs)), "coefficient": level + 0.02, "fitted": level, "run": number,
                             "rolling_speed": 10 + number, "normal_force": np.full(len(number), 1e5)}.items():
            file[f"points/{name}"] = values
        for k in range(len(runs)):
            curve = np.full(3, 0.3 + 0.1 * k)
            for name, values in {"creepage": creepage, "coefficient": curve, "half_width": np.full(3, 0.01),
                                 "least_point": curve - 0.05, "largest_point": curve + 0.05, "run": float(k),
                                 "rolling_speed": 10.0 + k, "normal_force": 1e5}.items():
                file[f"curve_{k}/{name}"] = values
        file["curves"], file["runs"] = float(len(runs)), "\n".join(runs)


class CreepCurveFitPictureTest(unittest.TestCase):
    def panels(self, runs):
        return figures_written_by(write_fit, runs)["creep_curve_fit.png"].axes

    def test_points_and_curve_over_the_creepage_in_percent(self):
        curves, deviations = self.panels([""])
        points, curve = curves.lines
        self.assertEqual(deviations.get_xlabel(), "creepage [%]")
        np.testing.assert_allclose(points.get_xdata(), [0.1, 1, 10])
        np.testing.assert_allclose(points.get_ydata(), 0.32)
        np.testing.assert_allclose(curve.get_ydata(), 0.3)
        np.testing.assert_allclose(deviations.lines[1].get_ydata(), 0.02)

    def test_both_bands(self):
        curves = self.panels([""])[0]
        heights = sorted(np.ptp(band.get_paths()[0].vertices[:, 1]) for band in curves.collections)
        np.testing.assert_allclose(heights, [0.02, 0.1])
        self.assertEqual([text.get_text() for text in curves.get_legend().get_texts()],
                         ["95 % of further points", "95 % band of the curve", "10 m/s, 100 kN"])

    def test_runs_have_names_and_their_own_points(self):
        curves = self.panels(["dry", "wet"])[0]
        self.assertEqual(len(curves.lines), 4)
        np.testing.assert_allclose(curves.lines[2].get_ydata(), 0.42)
        self.assertEqual([text.get_text() for text in curves.get_legend().get_texts()][2:],
                         ["dry: 10 m/s, 100 kN", "wet: 11 m/s, 100 kN"])


if __name__ == "__main__":
    unittest.main()
