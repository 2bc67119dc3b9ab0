"""Measured points beside the curves of one result or of several: values, colours and dashes."""

import unittest

import h5py
import numpy as np

from tests.figures import figures_written_by


def write_points(path, curves):
    """Curves of constant 0.3, 0.4, ... beside points 0.02 above them: pairs of a name and of the run of the points."""
    creepage = np.array([1e-3, 1e-2, 1e-1])
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "measured_points", "title": "points", "version": "0.2.0", "commit": "abc"})
        level = np.repeat(0.3 + 0.1 * np.arange(len(curves)), 3)
        run = np.repeat([float(run) for _, run in curves], 3)
        for name, values in {"creepage": np.tile(creepage, len(curves)), "coefficient": level + 0.02, "fitted": level, "run": run,
                             "rolling_speed": 10 + run, "normal_force": np.full(len(run), 1e5),
                             "curve": np.repeat(np.arange(float(len(curves))), 3)}.items():
            file[f"points/{name}"] = values
        for number, (name, _) in enumerate(curves):
            group = f"curve_{number}"
            file[f"{group}/name"], file[f"{group}/creepage"] = name, creepage
            file[f"{group}/coefficient"] = np.full(3, 0.3 + 0.1 * number)
            file[f"{group}/rms"], file[f"{group}/bias"] = 0.02, -0.02
        file["curves"], file["runs"], file["rms"], file["bias"] = float(len(curves)), "dry\nwet", 0.02, -0.02


class MeasuredPointsPictureTest(unittest.TestCase):
    def drawn(self, *curves):
        """Curves and marks of points, and the deviations' axes."""
        above, below = figures_written_by(write_points, curves)["measured_points.png"].axes
        lines = [line for line in above.lines if line.get_linestyle() != "None"]
        return lines, [line for line in above.lines if line.get_linestyle() == "None"], below

    def test_one_case(self):
        (curve,), (points,), deviations = self.drawn(("", 0))
        np.testing.assert_allclose(curve.get_ydata(), 0.3)
        np.testing.assert_allclose(points.get_ydata(), 0.32)
        np.testing.assert_allclose(deviations.lines[1].get_ydata(), 0.02)
        self.assertEqual(curve.get_label(), "dry: 10 m/s, 100 kN")
        self.assertEqual(curve.get_color(), points.get_color())

    def test_two_results_beside_one_run_differ_by_colour_and_dashes(self):
        curves, points, _ = self.drawn(("old", 0), ("new", 0))
        self.assertEqual(len(points), 1, "the points are drawn once")
        self.assertNotEqual(curves[0].get_color(), curves[1].get_color())
        self.assertNotEqual(curves[0].get_linestyle(), curves[1].get_linestyle())
        self.assertEqual([curve.get_label() for curve in curves], ["old: rms 0.0200", "new: rms 0.0200"])

    def test_two_results_beside_two_runs_have_the_colours_of_the_runs(self):
        curves, points, _ = self.drawn(("old, dry", 0), ("old, wet", 1), ("new, dry", 0), ("new, wet", 1))
        self.assertEqual([curve.get_color() for curve in curves], 2 * [line.get_color() for line in points])
        self.assertNotEqual(points[0].get_color(), points[1].get_color())
        self.assertEqual([curve.get_linestyle() for curve in curves], ["-", "-", "--", "--"])


if __name__ == "__main__":
    unittest.main()
