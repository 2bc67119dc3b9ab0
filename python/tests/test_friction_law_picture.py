"""The picture of a friction law: curves and points of the result file, in units that suit them."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from microslip.friction_law_picture import friction_law_picture
from microslip.result_file import ResultFile


class FrictionLawPictureTest(unittest.TestCase):
    def drawn(self, **datasets):
        """The axes of the picture of a file with these datasets."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "result.h5"
            with h5py.File(path, "w") as file:
                file.attrs["kind"] = "rolling_contact"
                for name, values in datasets.items():
                    file[f"friction_law/{name}"] = np.asarray(values, dtype=float)
            with ResultFile(path) as result:
                return friction_law_picture(result).axes[0]

    def test_a_law_is_one_curve(self):
        axes = self.drawn(slip_velocity=[0, 1, 2], coefficient=[[0.5, 0.3, 0.2]])
        (curve,) = axes.lines
        np.testing.assert_array_equal(curve.get_xydata(), [[0, 0.5], [1, 0.3], [2, 0.2]])
        self.assertIn("[m/s]", axes.get_xlabel())
        self.assertIsNone(axes.get_legend())

    def test_a_table_has_a_curve_and_its_points_for_each_pressure_and_temperature(self):
        axes = self.drawn(slip_velocity=[0, 0.1, 0.2], coefficient=[[0.3, 0.4, 0.3], [0.2, 0.3, 0.2]], pressure=[1e8, 9e8], temperature=[20, 20],
                          slip_velocity_of_table=[0, 0.2], coefficient_of_table=[[0.3, 0.3], [0.2, 0.2]])
        self.assertEqual(len(axes.lines), 4)
        np.testing.assert_allclose(axes.lines[3].get_xydata(), [[0, 0.2], [200, 0.2]])
        self.assertIn("[mm/s]", axes.get_xlabel())
        self.assertEqual([text.get_text() for text in axes.get_legend().get_texts()], ["100 MPa, 20 °C", "900 MPa, 20 °C"])
        self.assertEqual([line.get_color() for line in axes.lines[:2]], [line.get_color() for line in axes.lines[2:]])


if __name__ == "__main__":
    unittest.main()
