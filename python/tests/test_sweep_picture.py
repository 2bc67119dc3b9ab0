"""The picture of a sweep shows the numbers of its file."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from microslip import plot
from microslip.result_file import ResultError, ResultFile
from tests.figures import figures_written_by


def write_sweep(path, shape=None, more=None):
    """Fx = 1000 x + k, of a word with two values, k = 0 and 1, and x; the last case has none. `more` are moments."""
    x, k = np.tile(np.linspace(0, 3, 4), 2), np.repeat([0, 1], 4)
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "sweep", "title": "a test", "version": "0.2.0", "commit": "abc", "parameters": "a.word\na.x"})
        file["parameters/a.x"] = x
        file["parameters/a.word"] = [b"one", b"two"][0:1] * 4 + [b"two"] * 4
        file["parameters/a.x"].attrs["unit"] = "m"
        file["contact/fx"] = np.append((1000 * x + k)[:-1], np.nan)
        file["contact/fx"].attrs["unit"] = "N"
        if shape:
            file["shape"] = np.array(shape)
        for name, values in (more or {}).items():
            file[name] = values
            file[name].attrs["unit"] = "N m"


class SweepPictureTest(unittest.TestCase):
    def picture(self, shape, more=None):
        """The axes of the picture."""
        return figures_written_by(write_sweep, shape, more)["sweep.png"].axes

    def test_a_grid_has_a_line_for_each_combination(self):
        (axes,) = self.picture((2, 4))
        self.assertEqual([line.get_label() for line in axes.lines], ["a.word = one", "a.word = two"])
        np.testing.assert_array_equal(axes.lines[1].get_xdata(), [0, 1e3, 2e3, 3e3])
        np.testing.assert_allclose(axes.lines[1].get_ydata(), [0.001, 1.001, 2.001, np.nan])
        self.assertEqual(axes.get_ylabel(), "$F_x$ on body 1 [kN]")

    def test_rounding_is_no_curve(self):
        _, moments = self.picture((2, 4), {"contact/mz": 1e-14 * np.arange(8)})
        self.assertEqual({value for line in moments.lines for value in line.get_ydata()}, {0.0})

    def test_a_list_has_points_over_its_first_number(self):
        (axes,) = self.picture(None)
        np.testing.assert_allclose(axes.lines[0].get_ydata()[:3], [0, 1, 2])
        self.assertEqual(axes.get_xlabel(), "a.x [mm]")

    def test_without_a_quantity_there_is_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "s.h5"
            with h5py.File(path, "w") as file:
                file.attrs.update({"kind": "sweep", "parameters": "a.x"})
            with ResultFile(path) as result, self.assertRaisesRegex(ResultError, "has no quantities"):
                plot.pictures(result)


if __name__ == "__main__":
    unittest.main()
