"""Results as tables of pandas and datasets of xarray."""

import unittest
from importlib.util import find_spec

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled
from tests.test_wheel_rail import wheel_rail


def map_of_forces():
    return microslip.Fastsim2().solve_batch(contact(), [1e-3, 2e-3, 3e-3], spin=[[0.0], [0.4]])


@unittest.skipUnless(find_spec("pandas"), "pandas is not installed")
class DataFrameTest(unittest.TestCase):
    def test_a_row_for_each_contact(self):
        forces = map_of_forces()
        frame = forces.to_dataframe()
        self.assertEqual(len(frame), 6)
        np.testing.assert_array_equal(frame.fy, forces.fy.ravel())
        self.assertEqual(set(frame.status), {"ok"})

    def test_results_within_results_and_further_dimensions(self):
        exact = microslip.EllipticContactSolver(8, 8).solve_batch(contact(), [1e-3, 2e-3])
        np.testing.assert_array_equal(exact.to_dataframe().fx, exact.forces.fx)
        np.testing.assert_array_equal(exact.to_dataframe().residual, exact.residual)
        derivatives = microslip.Fastsim2().differentiate_batch(contact(), [1e-3, 2e-3])
        np.testing.assert_array_equal(derivatives.to_dataframe().jacobian_2_3, derivatives.jacobian[:, 2, 3])

    def test_fields_and_their_states(self):
        fields = microslip.Fastsim2(6, 4).fields(contact()).fields
        frame = fields.to_dataframe()
        self.assertEqual(len(frame), 24)
        self.assertAlmostEqual((frame.area * frame.px).sum(), (fields.area * fields.px).sum())
        self.assertLessEqual(set(frame.state), {"exterior", "adhesion", "slip"})


@unittest.skipUnless(find_spec("xarray"), "xarray is not installed")
class DatasetTest(unittest.TestCase):
    def test_dimensions_and_units(self):
        forces = map_of_forces()
        data = forces.to_xarray()
        self.assertEqual(data.fx.dims, ("dim_0", "dim_1"))
        np.testing.assert_array_equal(data.mz, forces.mz)
        self.assertEqual((data.mz.attrs["units"], data.status.attrs["flag_meanings"].split()[0]), ("N m", "ok"))

    def test_patches_of_wheels_share_a_dimension(self):
        states = wheel_rail().solve_batch(lateral=[0.0, 1e-3], vertical_force=80e3, forward_velocity=30.0)
        data = states.to_xarray()
        self.assertEqual(data.force_x.dims, ("dim_0",))
        self.assertEqual(data.patch_fx.dims, ("dim_0", "patch"))

    def test_fields_have_places(self):
        fields = microslip.Fastsim2(6, 4).fields(contact()).fields
        data = fields.to_xarray()
        self.assertEqual((data.px.dims, set(data.coords)), (("row", "element"), {"x", "y"}))


class CodesTest(unittest.TestCase):
    def test_codes_are_words_in_texts(self):
        self.assertEqual((str(microslip.Status.ok), f"{microslip.CellState.slip:>6}"), ("ok", "  slip"))

    def test_solvers_show_their_grid(self):
        self.assertEqual(repr(microslip.Fastsim2(8, 6)), "Fastsim2(8, 6)")
        self.assertEqual(repr(microslip.EllipticContactSolver(8, 6)), "EllipticContactSolver(8, 6)")


load_tests = load_tests_if_compiled([DataFrameTest, DatasetTest, CodesTest])

if __name__ == "__main__":
    unittest.main()
