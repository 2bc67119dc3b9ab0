"""The pictures of the refinement paper's test show the numbers of their file."""

import unittest

import h5py
import numpy as np

from microslip.refinement_pictures import EDGES, slip_ahead
from tests.figures import figures_of, written_for

LIMIT = 0.7


def write_refinement(path):
    """Forces with an error in proportion to step and element size, tractions of Carter's kind, a bound that slides."""
    grids, steps = np.array([10, 20, 40], dtype=np.int32), np.array([0.5, 1.0, 2.0])
    x, y = np.linspace(-5e-3, 5e-3, 12), np.linspace(-0.02, 0.02, 8)
    bound = np.sqrt(np.clip(1 - (x / 5e-3) ** 2, 0, None))
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "refinement", "title": "refinement", "version": "0.1.0", "commit": "abc"})
        file["limit"] = LIMIT
        file["creep_curve/scaled"] = np.linspace(0, 2, 9)
        for group in ("plain", "corrected", "fastsim2"):
            file[f"creep_curve/{group}"] = np.tanh(file["creep_curve/scaled"][()])
        file["steps/grids"], file["steps/step"] = grids, steps
        file["steps/plain"] = LIMIT + 0.1 * steps / grids[:, None]
        file["steps/corrected"] = LIMIT - 0.05 / grids[:, None] + 0 * steps
        file["fields/x"], file["fields/y"], file["fields/bound"] = x, y, bound
        for group in ("plain_1", "plain_5", "corrected_1", "corrected_5"):
            file[f"fields/{group}/px"] = -bound * np.where(x < 0, 1, 0.5)
            state = np.tile(np.where(x < 0, 2, 1).astype(np.uint8), (len(y), 1))
            state[3, -1] = 2
            file[f"fields/{group}/state"] = state
        file["load/grids"], file["edge/grids"] = grids, grids
        for group in ("tight", "shifted"):
            file[f"load/{group}"] = grids**-2.0
            file[f"load/bilinear_{group}"] = 1.8 * grids**-2.0
        for number, group in enumerate(EDGES):
            file[f"edge/{group}"] = LIMIT + 0.1 * (number - 3) / grids
            file[f"edge/bilinear_{group}"] = LIMIT + 0.12 * (number - 3) / grids


class RefinementPicturesTest(unittest.TestCase):
    def setUp(self):
        self.path = written_for(self, write_refinement)

    def figures(self):
        return figures_of(self.path)

    def test_there_are_pictures_for_all_eight_figures(self):
        self.assertEqual(sorted(self.figures()), ["refinement_figure1.png", "refinement_figure5.png",
                                                  "refinement_figures_2_6.png", "refinement_figures_3_4.png",
                                                  "refinement_figures_7_8.png"])

    def test_steps_have_a_line_for_each_grid_and_the_limit(self):
        figure = self.figures()["refinement_figures_2_6.png"]
        with h5py.File(self.path) as file:
            for axes, group in zip(figure.axes, ("plain", "corrected")):
                for line, force in zip(axes.lines, file[f"steps/{group}"]):
                    np.testing.assert_array_equal(line.get_ydata(), force)
                self.assertEqual(set(axes.lines[-1].get_ydata()), {LIMIT})

    def test_tractions_are_in_millimetres_and_positive(self):
        axes = self.figures()["refinement_figures_3_4.png"].axes[0]
        for line in axes.lines:
            self.assertAlmostEqual(np.max(line.get_xdata()), 5)
            self.assertGreaterEqual(np.min(line.get_ydata()), 0)

    def test_lines_of_figure_8_meet_in_the_limit(self):
        axes = self.figures()["refinement_figures_7_8.png"].axes[1]
        for line in axes.lines[:len(EDGES)]:
            slope, start = np.polyfit(*line.get_xydata().T, 1)
            self.assertAlmostEqual(start, LIMIT, places=10)

    def test_slip_ahead_of_adhesion_is_counted(self):
        self.assertEqual(slip_ahead(np.array([[2, 2, 1, 2, 0], [2, 2, 2, 2, 2], [0, 1, 1, 2, 2]])), 3)
        title = self.figures()["refinement_figure5.png"].axes[0].get_title(loc="left")
        self.assertIn("1 elements of slip", title)


if __name__ == "__main__":
    unittest.main()
