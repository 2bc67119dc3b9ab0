"""Arrays of any layout and type of real numbers give the same numbers; masked values are refused."""

import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled, wheel_on_rail


def read_only(values):
    """A copy that cannot be written to."""
    made = values.copy()
    made.flags.writeable = False
    return made


def non_contiguous(values):
    """Every other column of a wider array."""
    wide = np.full((values.shape[0], 2 * values.shape[1]), np.nan)
    wide[:, ::2] = values
    return wide[:, ::2]


LAYOUTS = {
    "non-contiguous": non_contiguous, "reversed twice": lambda values: values[::-1, ::-1].copy()[::-1, ::-1],
    "read-only": read_only, "Fortran-ordered": np.asfortranarray, "a list": np.ndarray.tolist,
    "masked, no value masked": lambda values: np.ma.array(values, mask=np.zeros_like(values, bool)),
    "big-endian": lambda values: values.astype(">f8"),
}


class ArraysTest(unittest.TestCase):
    def setUp(self):
        self.hertz, self.pair = wheel_on_rail()
        self.grid = microslip.ElementGrid.across_ellipse(self.hertz.a, self.hertz.b, 8, 6, 3)
        self.gap = microslip.hertzian_gap(self.hertz.gap, self.grid)
        self.pressure = self.hertz.pressure(self.grid.x[None, :], self.grid.y[:, None])
        self.steel = microslip.Material.from_young(210e9, 0.28)
        self.xi = np.linspace(1e-4, 2e-3, 6).reshape(2, 3)
        normal = microslip.NormalProblem(self.pair, self.grid)
        tangential = microslip.TangentialProblem(self.pair, self.grid)
        points = np.array([[0.0, 1e-3, 2e-3], [3e-3, 4e-3, 5e-3]])
        field = microslip.InteriorField(self.steel, 1, self.grid, pn=self.pressure)
        self.functions = {
            "gap": (self.gap, lambda values: normal.solve(values, normal_force=80e3).pressure),
            "bound": (0.3 * self.pressure, lambda values: tangential.solve(values, (1e-3, 0, 0)).px),
            "pn": (self.pressure, lambda values: microslip.InteriorField(self.steel, 1, self.grid, pn=values).at(0, 0, 1e-3).zz),
            "longitudinal": (self.xi, lambda values: microslip.Fastsim2().solve_batch(contact(), values).fx),
            "x": (points, lambda values: field.at(values, 0, 1e-3).zz),
        }

    def test_layouts_give_the_same_numbers(self):
        for name, (values, function) in self.functions.items():
            wanted = function(values)
            for layout, made in LAYOUTS.items():
                with self.subTest(f"{name}, {layout}"):
                    np.testing.assert_array_equal(function(made(values)), wanted)

    def test_single_precision_is_its_numbers_in_double_precision(self):
        for name, (values, function) in self.functions.items():
            with self.subTest(name):
                single = values.astype(np.float32)
                np.testing.assert_array_equal(function(single), function(single.astype(float)))

    def test_integers_are_numbers(self):
        for kind in (np.int32, np.int64, np.uint8):
            whole = np.arange(self.gap.size, dtype=kind).reshape(self.gap.shape)
            for name in ("gap", "bound"):
                function = self.functions[name][1]
                np.testing.assert_array_equal(function(whole), function(whole.astype(float)))
            batch = self.functions["longitudinal"][1]
            np.testing.assert_array_equal(batch(np.array([[0, 1]], kind)), batch(np.array([[0.0, 1.0]])))

    def test_masked_values_are_refused(self):
        for name, (values, function) in self.functions.items():
            mask = np.zeros_like(values, bool)
            mask[0, 1] = True
            with self.subTest(name), self.assertRaisesRegex(microslip.Error, f"{name}: has masked values; fill them in first"):
                function(np.ma.array(values, mask=mask))


load_tests = load_tests_if_compiled([ArraysTest])
