"""The picture of stresses below a rolling contact shows the numbers of its file."""

import unittest

import h5py
import numpy as np

from microslip.result_file import ResultError, ResultFile
from microslip.subsurface_pictures import CASES, section
from tests.figures import figures_of, written_for


def write_subsurface(path):
    """Stresses that grow with the depth, in the rail by 1 more."""
    x, depth = np.linspace(-9e-3, 9e-3, 7), np.linspace(0, 9e-3, 5)
    stress = np.tile(1e2 * depth[:, None], (1, len(x)))
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "subsurface", "title": "stresses", "version": "0.1.0", "commit": "abc"})
        file["a"], file["peak_pressure"], file["friction"] = 6e-3, 1e9, 0.4
        file["x"], file["depth"] = x, depth
        for number, case in enumerate(CASES):
            file[f"{case}/traction"] = number / 2
            for body, more in (("wheel", 0), ("rail", 1)):
                file[f"{case}/{body}/von_mises"] = stress + more
                file[f"{case}/{body}/peak"] = 0.9 + more
                file[f"{case}/{body}/peak_point"] = np.array([1e-3 * (number - more), 0, 2e-3])


class SubsurfacePicturesTest(unittest.TestCase):
    def setUp(self):
        self.path = written_for(self, write_subsurface)

    def panels(self):
        return figures_of(self.path)["subsurface.png"].axes[:len(CASES)]

    def test_the_wheel_is_above_the_rail(self):
        with ResultFile(self.path) as result:
            field = section(result, "free")
        self.assertEqual(field.shape, (10, 7))
        np.testing.assert_allclose(field[:, 0], [1.9, 1.675, 1.45, 1.225, 1, 0, 0.225, 0.45, 0.675, 0.9])

    def test_crosses_mark_the_largest_values(self):
        for number, axes in enumerate(self.panels()):
            crosses = {(round(line.get_xdata()[0], 9), round(line.get_ydata()[0], 9)) for line in axes.lines
                       if line.get_marker() == "x"}
            self.assertEqual(crosses, {(number, 2), (number - 1, -2)})

    def test_titles_have_force_and_largest_values(self):
        titles = [axes.get_title(loc="left") for axes in self.panels()]
        self.assertIn("no traction: $F_x$ = 0\n", titles[0])
        self.assertIn(r"$F_x$ = 0.5 $\mu F_n$", titles[1])
        for text in titles:
            self.assertIn("wheel 0.900 $p_0$, rail 1.900 $p_0$", text)

    def test_a_body_that_is_missing_is_named(self):
        with h5py.File(self.path, "a") as file:
            del file["full/rail/von_mises"]
        with self.assertRaisesRegex(ResultError, "full/rail/von_mises"):
            self.panels()


if __name__ == "__main__":
    unittest.main()
