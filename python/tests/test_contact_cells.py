"""The geometry of the pictures: cells, strips and boundaries are exact, arrows are spread evenly."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from microslip.contact_cells import ADHESION, EXTERIOR, SLIP, ContactCells, every, read_cells
from microslip.result_file import ResultFile
from tests.synthetic_results import fastsim


def cells_of(mx, my, a=6.0, b=4.0, backward=False, creepage=(0.001, 0.0005, 0.2)):
    """Cells of a synthetic case, lengths in mm."""
    fields = fastsim(1e-3 * a, 1e-3 * b, mx, my, creepage, 24e3, backward)
    names = ("area", "bound", "px", "py", "sx", "sy", "state")
    return ContactCells(1e3 * fields["x"], 1e3 * fields["y"], *(fields[name] for name in names), (a, b))


def area_of(corners):
    """Area of axis-parallel rectangles."""
    return np.sum((corners[:, 1, 0] - corners[:, 0, 0]) * (corners[:, 2, 1] - corners[:, 1, 1]))


class ContactCellsTest(unittest.TestCase):
    def test_rectangles_fill_every_row_from_edge_to_edge(self):
        for mx, my in ((1, 1), (1, 7), (7, 1), (10, 10)):
            cells = cells_of(mx, my)
            corners, index = cells.rectangles()
            self.assertEqual(len(corners), mx * my)
            for row, y in enumerate(cells.row_y):
                edge = cells.a * np.sqrt(1 - (y / cells.b) ** 2)
                mine = corners[index[:, 0] == row]
                self.assertAlmostEqual(mine[:, :, 0].max(), edge, places=12)
                self.assertAlmostEqual(mine[:, :, 0].min(), -edge, places=12)
                self.assertAlmostEqual(area_of(mine), 2 * edge * 2 * cells.b / my, places=11)

    def test_rectangles_tend_to_the_ellipse(self):
        wrong = [abs(area_of(cells_of(n, n).rectangles()[0]) / (np.pi * 6 * 4) - 1) for n in (20, 80)]
        self.assertLess(wrong[1], wrong[0] / 4)
        self.assertLess(wrong[1], 2e-3)

    def test_strips_cover_the_cells_of_their_state(self):
        cells = cells_of(12, 9)
        corners, index = cells.rectangles()
        for state in (ADHESION, SLIP):
            mine = corners[cells.state[tuple(index.T)] == state]
            self.assertAlmostEqual(area_of(cells.strips(state)), area_of(mine), places=10)
            self.assertLess(len(cells.strips(state)), len(mine))

    def test_boundary_has_adhesion_on_one_side_and_slip_on_the_other(self):
        for backward in (False, True):
            cells = cells_of(12, 9, backward=backward)
            segments = np.array(cells.boundary())
            self.assertGreater(len(segments), 9)
            for start, end in segments:
                along = (end - start) / np.hypot(*(end - start))
                across = 1e-6 * np.array([-along[1], along[0]])
                for middle in (0.01, 0.5, 0.99):
                    point = start + middle * (end - start)
                    sides = {self.state_at(cells, point + across), self.state_at(cells, point - across)}
                    self.assertEqual(sides, {ADHESION, SLIP})

    def test_boundary_has_the_length_that_a_pixel_count_finds(self):
        # On a fine raster, neighbours in different states are counted as boundary of one pixel's length.
        cells = cells_of(12, 9)
        x, y = (np.linspace(-half, half, 401) + 1e-7 for half in (6, 4))
        raster = np.array([[self.state_at(cells, (one, other)) for one in x] for other in y])

        def changes(here, there):
            return np.sum((here * there) == ADHESION * SLIP)

        counted = (changes(raster[:, :-1], raster[:, 1:]) * (y[1] - y[0])
                   + changes(raster[:-1], raster[1:]) * (x[1] - x[0]))
        drawn = sum(np.hypot(*np.subtract(end, start)) for start, end in cells.boundary())
        self.assertAlmostEqual(drawn, counted, delta=0.01 * counted)

    @staticmethod
    def state_at(cells, point):
        row = int((point[1] + cells.b) / cells.height)
        if not 0 <= row < len(cells.row_y):
            return EXTERIOR
        i = np.argmin(np.abs(cells.x[row] - point[0]))
        return int(cells.state[row, i]) if abs(cells.x[row, i] - point[0]) <= cells.widths[row, i] / 2 else EXTERIOR

    def test_fitted_leading_cells_have_their_own_length(self):
        # A regular row of cells 1 long; the leading one begins at its neighbour's end and is .6 long.
        x, y = np.array([[4.5, 3.3, 2.5, 1.5, 0.5]] * 2), np.array([[0.0] * 5, [1.0] * 5])
        area, state = np.array([[1, 0.6, 1, 1, 1]] * 2), np.array([[EXTERIOR, SLIP, SLIP, ADHESION, SLIP]] * 2)
        cells = ContactCells(x, y, area, *([np.zeros((2, 5))] * 5), state, (2, 1))
        corners, index = cells.rectangles()
        np.testing.assert_allclose(corners[0, :2, 0], (3, 3.6))
        np.testing.assert_allclose(area_of(cells.strips(SLIP)), 2 * (1.6 + 1))
        self.assertEqual(sorted({segment[0][0] for segment in cells.boundary()}), [1, 2])

    def test_no_boundary_where_all_slides_or_all_sticks(self):
        self.assertEqual(cells_of(10, 10, creepage=(0.5, 0, 0)).boundary(), [])
        stuck = cells_of(10, 10)
        stuck.state[:] = ADHESION
        self.assertEqual(stuck.boundary(), [])
        self.assertEqual(len(stuck.strips(ADHESION)), 10)

    def test_arrows_are_few_on_fine_grids_and_all_on_coarse_ones(self):
        for n in (40, 160):
            chosen = cells_of(n, n).sample()
            self.assertLessEqual(chosen.any(axis=1).sum(), 20)
            self.assertLessEqual(chosen.sum(axis=1).max(), 20)
            self.assertGreater(chosen.sum(), 100)
        self.assertTrue(cells_of(5, 5).sample().all())

    def test_arrows_are_symmetric(self):
        chosen = cells_of(37, 53).sample()
        np.testing.assert_array_equal(chosen.sum(axis=1), chosen.sum(axis=1)[::-1])

    def test_every_shares_the_remainder(self):
        np.testing.assert_array_equal(every(10, 3), [0, 3, 6, 9])
        np.testing.assert_array_equal(every(9, 4), [0, 4, 8])
        np.testing.assert_array_equal(every(8, 4), [1, 5])
        np.testing.assert_array_equal(every(4, 0.5), [0, 1, 2, 3])
        np.testing.assert_array_equal(every(3, 100), [1])

    def test_fine_grids_are_sampled_when_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "fine.h5"
            with h5py.File(path, "w") as file:
                file["/hertz/a"], file["/hertz/b"] = 6e-3, 4e-3
                for name, value in fastsim(6e-3, 4e-3, 1000, 30, (0.001, 0, 0), 24e3).items():
                    file[f"/fastsim2/fields/{name}"] = value
            with ResultFile(path) as result:
                cells = read_cells(result, "fastsim2")
        self.assertEqual(cells.x.shape[0], 30)
        self.assertLessEqual(cells.x.shape[1], 400)
        whole = area_of(cells_of(1000, 30).rectangles()[0])
        self.assertAlmostEqual(area_of(cells.rectangles()[0]), whole, delta=0.003 * whole)


if __name__ == "__main__":
    unittest.main()
