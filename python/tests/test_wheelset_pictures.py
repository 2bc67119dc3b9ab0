"""The pictures of a wheelset show the numbers of their file."""

import unittest

import h5py
import numpy as np

from tests.figures import figures_written_by


def write_wheelset(path, states):
    """A file of kind wheelset."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "wheelset", "title": "both", "version": "0.1.0", "commit": "abc"})
        for name in ("force_x", "roll", "pitch_velocity"):
            file[f"wheelset/{name}"] = np.linspace(1, 2, states)
        for side, size in (("left", 1e3), ("right", 2e3)):
            for name in ("force_y", "force_z"):
                file[f"{side}/wheel/{name}"] = size * np.linspace(1, 2, states)
        file["states/lateral"] = np.linspace(0, 5e-3, states)
        file["states/lateral"].attrs["unit"] = "m"
        file["states"].attrs["varied"] = "lateral"


class WheelsetPicturesTest(unittest.TestCase):
    def figures(self, states):
        return figures_written_by(write_wheelset, states)

    def test_only_sweeps_have_a_picture(self):
        self.assertEqual(self.figures(1), {})
        self.assertEqual(list(self.figures(4)), ["wheelset.png"])

    def test_curves_are_those_of_the_file(self):
        lateral, vertical, roll, pitch = self.figures(4)["wheelset.png"].axes
        for axes in (lateral, vertical):
            left, right = axes.get_lines()[::2]  # dots, each with a line below them
            np.testing.assert_allclose(left.get_ydata(), np.linspace(1, 2, 4))
            np.testing.assert_allclose(right.get_ydata(), np.linspace(2, 4, 4))
        np.testing.assert_allclose(roll.get_lines()[0].get_xdata(), np.linspace(0, 5, 4))
        np.testing.assert_allclose(roll.get_lines()[0].get_ydata(), 1e3 * np.linspace(1, 2, 4))
        np.testing.assert_allclose(pitch.get_lines()[0].get_ydata(), np.linspace(1, 2, 4))


if __name__ == "__main__":
    unittest.main()
