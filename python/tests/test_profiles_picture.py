"""The picture of a folder of profiles shows all of them, wheels apart from rails."""

import unittest

import h5py
import numpy as np

from microslip.profiles_picture import MOST_NAMES
from tests.figures import figures_written_by


def write_profiles(path, roles):
    """Parabolas, each one 1 mm above the one before."""
    y = np.linspace(-0.03, 0.03, 31)
    with h5py.File(path, "w") as file:
        file.attrs.update(kind="profiles", title="measured", version="0", commit="0")
        for k, role in enumerate(roles):
            group = f"profiles/{k:04}"
            file[f"{group}/file"], file[f"{group}/role"] = f"{k}.txt", role
            file[f"{group}/y"], file[f"{group}/z"] = y, 1e-3 * k - y**2


class ProfilesPictureTest(unittest.TestCase):
    def figure(self, roles):
        return figures_written_by(write_profiles, roles)["profiles.png"]

    def test_wheels_and_rails_have_axes_of_their_own(self):
        figure = self.figure(["wheel", "rail", "wheel"])
        wheels, rails = figure.axes
        named = [{line.get_label(): line for line in axes.lines if line.get_label().endswith(".txt")} for axes in (wheels, rails)]
        self.assertEqual([list(lines) for lines in named], [["0.txt", "2.txt"], ["1.txt"]])
        self.assertAlmostEqual(max(named[0]["2.txt"].get_ydata()), 2)
        self.assertIn("tape circle", wheels.get_ylabel())
        self.assertIn("gauge point", rails.get_xlabel())
        self.assertIn("2 wheels and 1 rail: measured", figure._suptitle.get_text())

    def test_a_legend_names_some_of_many(self):
        axes, = self.figure(["rail"] * 60).axes
        self.assertEqual(len(axes.get_legend().get_texts()), MOST_NAMES)
        self.assertEqual([text.get_text() for text in axes.texts], [f"{MOST_NAMES} of 60 are named"])
