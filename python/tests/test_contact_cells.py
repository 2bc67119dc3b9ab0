"""The geometry of the pictures: outlines are true, cells reach them, arrows are spread evenly."""

import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

from microslip.contact_cells import ADHESION, EXTERIOR, SLIP, ContactCells, read_cells
from microslip.picture_style import new_figure
from microslip.result_file import ResultFile
from tests.synthetic_results import fastsim


def cells_of(mx, my, a=6.0, b=4.0, backward=False, creepage=(0.001, 0.0005, 0.2)):
    """Cells of a synthetic case, lengths in mm."""
    fields = fastsim(1e-3 * a, 1e-3 * b, mx, my, creepage, 24e3, backward)
    names = ("area", "bound", "px", "py", "sx", "sy", "state")
    return ContactCells(1e3 * fields["x"], 1e3 * fields["y"], *(fields[name] for name in names), (a, b))


def area_of(curve):
    """The area within a closed curve."""
    x, y = curve.T
    return abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) / 2


def square_cells(n, a=6.0, b=4.0, pressed=None):
    """Cells of a square grid under Hertz's pressure, or another one, without tractions."""
    x, y = np.meshgrid(np.linspace(-1.2 * a, 1.2 * a, n), np.linspace(-1.2 * b, 1.2 * b, n))
    pressure = np.sqrt(np.clip(1 - (x / a) ** 2 - (y / b) ** 2, 0, None)) if pressed is None else pressed(x, y)
    return ContactCells(x, y, np.ones(x.shape), *([np.zeros(x.shape)] * 5), (pressure > 0).astype(int), pressure=pressure)


class OutlineTest(unittest.TestCase):
    def test_the_pressure_tells_where_hertzs_ellipse_ends(self):
        for n, error in ((15, 0.02), (31, 0.004), (63, 0.001)):
            (curve,) = square_cells(n).outline.parts
            self.assertAlmostEqual(area_of(curve) / (np.pi * 6 * 4), 1, delta=error)
            self.assertLess(np.abs((curve[:, 0] / 6) ** 2 + (curve[:, 1] / 4) ** 2 - 1).max(), 8 * error)

    def test_patches_apart_have_outlines_of_their_own(self):
        def pressed(x, y):
            return np.sqrt(np.clip(np.maximum(1 - (x + 3) ** 2 - y**2, 4 - (x - 3) ** 2 - y**2), 0, None))

        curves = square_cells(81, pressed=pressed).outline.parts
        areas = sorted(area_of(curve) / np.pi for curve in curves)
        np.testing.assert_allclose(areas, [1, 4], rtol=0.02)

    def test_rows_that_join_are_one_patch(self):
        def pressed(x, y):  # two discs joined by a bridge
            discs = np.maximum(4 - (x + 2.5) ** 2 - y**2, 4 - (x - 2.5) ** 2 - y**2)
            return np.sqrt(np.clip(np.maximum(discs, 1 - y**2), 0, None)) * (np.abs(x) < 4.6)

        (curve,) = square_cells(101, pressed=pressed).outline.parts
        self.assertGreater(area_of(curve), 2 * np.pi * 4)

    def test_a_single_element_and_a_single_row_have_an_outline(self):
        for n in (1, 4):
            x = np.linspace(0, 1, n)[None, :]
            cells = ContactCells(x, 0 * x, np.ones(x.shape), *([0 * x] * 5), np.ones(x.shape), pressure=np.ones(x.shape), size=(1.0, 1.0))
            (curve,) = cells.outline.parts
            self.assertGreater(area_of(curve), 0)

    def test_backward_rows_and_descending_rows_are_as_others(self):
        one = square_cells(21)
        areas = []
        for turn in (np.s_[:, ::-1], np.s_[::-1]):
            fields = [getattr(one, name)[turn] for name in ("x", "y", "bound", "bound", "px", "py", "sx", "sy", "state")]
            fields[2] = np.ones(one.x.shape)
            cells = ContactCells(*fields, pressure=one.pressure[turn])
            areas.append(area_of(cells.outline.parts[0]))
        np.testing.assert_allclose(areas, area_of(one.outline.parts[0]), rtol=1e-9)


class SplinterTest(unittest.TestCase):
    def test_parts_without_the_centre_of_a_cell_have_a_surface(self):
        def crescent(x, y):
            return np.sqrt(np.clip(0.2**2 - (np.hypot(x, y + 3) - 4) ** 2, 0, None)) * (y > -1)

        cells = square_cells(25, pressed=crescent)
        self.assertEqual(len(cells.outline.parts), 4)
        for vanishes in (True, False):
            for _, _, values in cells.surface(np.ones(cells.x.shape), vanishes):
                self.assertTrue(np.isfinite(values).all())


class ContactCellsTest(unittest.TestCase):
    def test_values_at_the_centres_are_those_of_the_cells(self):
        cells = cells_of(12, 9)
        values = np.random.default_rng(1).normal(size=cells.x.shape)
        np.testing.assert_allclose(cells.at(values, cells.x, cells.y, vanishes=False), values, rtol=1e-12)

    def test_hertzs_pressure_is_the_half_ellipsoid_everywhere(self):
        for cells in (cells_of(12, 9), cells_of(10, 30, 2.0, 9.0)):
            pressure = np.sqrt(1 - (cells.x / cells.a) ** 2 - (cells.y / cells.b) ** 2)
            x, y = cells.lattice(0.17)
            exact = np.sqrt(1 - (x / cells.a) ** 2 - (y / cells.b) ** 2)
            np.testing.assert_allclose(cells.at(pressure, x, y, vanishes=True), exact, atol=2e-3)

    def test_the_border_is_where_the_states_change(self):
        cells = cells_of(24, 24)
        (x, y, sticks, _), = cells.borders()
        for row in range(4, 20):
            line = np.argmin(abs(y - cells.row_y[row]))
            changes = np.flatnonzero(np.diff(np.sign(sticks[line][abs(x) < cells.a * np.sqrt(1 - (y[line] / cells.b) ** 2)])))
            states = np.flatnonzero(np.diff(cells.state[row]))
            if len(states) != 1:
                continue
            inside = x[abs(x) < cells.a * np.sqrt(1 - (y[line] / cells.b) ** 2)]
            self.assertEqual(len(changes), 1)
            between = cells.x[row, states[0]:states[0] + 2].mean()
            self.assertLess(abs(inside[changes[0]] - between), 1.5 * cells.apart[row])

    def test_images_show_values_up_to_the_outline(self):
        figure = new_figure(6, 6)
        axes = figure.subplots()
        cells = cells_of(12, 9)
        axes.set_xlim(-7, 7)
        axes.set_ylim(-5, 5)
        cells.draw(axes, np.ones(cells.x.shape), cmap="gray", vmin=0, vmax=4)
        axes.set_axis_off()
        figure.canvas.draw()
        pixels = np.asarray(figure.canvas.buffer_rgba())[..., 0]
        coloured = np.argwhere(pixels < 200)
        left, top = axes.transData.inverted().transform([coloured[:, 1].min(), 0])[0], coloured[:, 0].min()
        self.assertAlmostEqual(left, -6, delta=0.05)
        x, y = axes.transData.inverted().transform(np.column_stack([coloured[:, 1], pixels.shape[0] - coloured[:, 0]])).T
        self.assertLess(((x / 6) ** 2 + (y / 4) ** 2).max(), 1.03)
        scale = np.prod(axes.transData.transform([1, 1]) - axes.transData.transform([0, 0]))
        self.assertAlmostEqual(len(coloured) / scale, np.pi * 6 * 4, delta=0.02 * np.pi * 6 * 4)
        self.assertGreater(top, 0)

    def test_spans_cover_the_cells_of_their_state(self):
        cells = cells_of(12, 9)
        for state in (ADHESION, SLIP):
            for row in range(9):
                covered = sum(right - left for left, right in cells.spans(state, row))
                self.assertAlmostEqual(covered, cells.widths[row, cells.state[row] == state].sum(), places=10)

    def test_fitted_leading_cells_have_their_own_length(self):
        # A regular row of cells 1 long; the leading one begins at its neighbour's end and is 0.6 long.
        x, y = np.array([[4.5, 3.3, 2.5, 1.5, 0.5]] * 2), np.array([[0.0] * 5, [1.0] * 5])
        area, state = np.array([[1, 0.6, 1, 1, 1]] * 2), np.array([[EXTERIOR, SLIP, SLIP, ADHESION, SLIP]] * 2)
        cells = ContactCells(x, y, area, *([np.zeros((2, 5))] * 5), state, (2, 1))
        np.testing.assert_allclose(list(cells.spans(SLIP, 0)), [(2, 3.6), (0, 1)])

    def test_surfaces_of_hertzs_pressure_are_half_ellipsoids(self):
        cells = square_cells(31)
        ((x, y, height),) = cells.surface(cells.pressure, vanishes=True)
        exact = np.sqrt(np.clip(1 - (x / 6) ** 2 - (y / 4) ** 2, 0, None))
        np.testing.assert_allclose(height, exact, atol=0.05)
        np.testing.assert_allclose(height[-1], 0, atol=1e-7)

    def test_surfaces_of_linear_fields_are_planes(self):
        cells = square_cells(31)
        ((x, y, height),) = cells.surface(2 * cells.x - cells.y + 3, vanishes=False)
        inner = slice(0, 30)
        np.testing.assert_allclose(height[inner], (2 * x - y + 3)[inner], atol=0.6)

    def test_no_boundary_where_all_slides_or_all_sticks(self):
        self.assertFalse(cells_of(10, 10, creepage=(0.5, 0, 0)).has_boundary())
        self.assertTrue(cells_of(10, 10).has_boundary())

    def test_arrows_are_as_many_on_fine_grids_as_on_coarse_ones(self):
        counts = [len(cells_of(n, n).lattice()[0]) for n in (5, 40, 160)]
        self.assertEqual(len(set(counts)), 1)
        self.assertGreater(counts[0], 60)
        self.assertLess(counts[0], 400)

    def test_arrows_stand_in_mirror_images(self):
        x, y = cells_of(37, 53).lattice()
        for mirrored in ((-x, y), (x, -y)):
            self.assertEqual(set(zip(*np.round(mirrored, 9) + 0.0)), set(zip(*np.round((x, y), 9) + 0.0)))

    def test_arrows_of_slip_stand_where_it_slides(self):
        cells = cells_of(40, 40)
        x, y, *_ = cells.arrows(cells.sx, cells.sy, np.hypot(cells.sx, cells.sy).max(), only=SLIP)
        self.assertGreater(len(x), 10)
        near = [np.argmin(np.hypot(cells.x - one, cells.y - other)) for one, other in zip(x, y)]
        self.assertGreater(np.mean(cells.state.flat[near] == SLIP), 0.9)

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


def regular_cells(rows, columns, inside):
    """Cells of a regular grid of elements 0.5 x 2 mm in contact where `inside` of x and y holds."""
    x, y = np.meshgrid(0.5 * np.arange(columns), 2.0 * np.arange(rows))
    pressure = np.where(inside(x, y), 100.0, 0.0)
    return ContactCells(x, y, np.ones(x.shape), *([np.zeros(x.shape)] * 5), (pressure > 0).astype(int), pressure=pressure, size=(0.5, 2.0))


class RegularGridTest(unittest.TestCase):
    def test_a_single_row_ends_with_its_elements(self):
        cells = regular_cells(1, 9, lambda x, y: (x >= 1) & (x <= 3))
        self.assertEqual(cells.outline.limits(), (0.75, 3.25, -1.0, 1.0))
        self.assertEqual(regular_cells(1, 9, lambda x, y: x > 99).outline.limits(), (0, 0, 0, 0))

    def test_a_surface_is_the_grid_around_the_contact(self):
        cells = regular_cells(7, 9, lambda x, y: (abs(x - 2) <= 1) & (abs(y - 6) <= 2))
        for vanishes, beyond in ((True, 0), (False, np.nan)):
            ((x, y, height),) = cells.surface(cells.pressure, vanishes)
            self.assertEqual((x[0, 0], x[-1, -1], y[0, 0], y[-1, -1]), (0.5, 3.5, 2, 10), "one element more on each side")
            np.testing.assert_array_equal(height[1:-1, 1:-1], 100)
            for edge in (height[0], height[-1], height[:, 0], height[:, -1]):
                np.testing.assert_array_equal(edge, beyond)


if __name__ == "__main__":
    unittest.main()
