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
        exact = microslip.Solver(theory="exact", grid=8).solve_batch(contact(), [1e-3, 2e-3])
        np.testing.assert_array_equal(exact.to_dataframe().fx, exact.forces.fx)
        np.testing.assert_array_equal(exact.to_dataframe().residual, exact.residual)
        derivatives = microslip.Fastsim2().differentiate_batch(contact(), [1e-3, 2e-3])
        np.testing.assert_array_equal(derivatives.to_dataframe().jacobian_2_3, derivatives.jacobian[:, 2, 3])

    def test_inputs_and_units_go_along(self):
        frame = map_of_forces().to_dataframe()
        np.testing.assert_array_equal(frame.creepage_longitudinal, [1e-3, 2e-3, 3e-3] * 2)
        np.testing.assert_array_equal(frame.spin, [0.0] * 3 + [0.4] * 3)
        self.assertEqual(frame.attrs["scalars"]["normal_force"], contact().normal_force)
        self.assertEqual(frame.attrs["scalars"]["friction"], contact().friction.static_coefficient)
        for name, unit in (("fx", "N"), ("mz", "N m"), ("spin", "1/m"), ("a", "m"), ("shear_modulus", "Pa")):
            self.assertEqual(frame.attrs["units"][name], unit)
        self.assertEqual((frame.attrs["result"], frame.attrs["version"]), ("ForceArrays", microslip.__version__))

    def test_states_of_wheels_are_inputs(self):
        frame = wheel_rail().solve_batch(lateral=[0.0, 1e-3], vertical_force=80e3, forward_velocity=30.0).to_dataframe()
        np.testing.assert_array_equal(frame.lateral, [0.0, 1e-3])
        self.assertEqual((frame.attrs["scalars"]["vertical_force"], frame.attrs["units"]["vertical_force"]), (80e3, "N"))

    def test_a_solution_has_its_fields_and_totals(self):
        solution = microslip.Solver(theory="exact", grid=(8, 6)).solve(contact())
        frame = solution.to_dataframe()
        self.assertEqual(len(frame), solution.fields.px.size)
        self.assertAlmostEqual((frame.area * frame.px).sum() / solution.fx, 1, delta=1e-12)
        scalars = frame.attrs["scalars"]
        self.assertEqual((scalars["fx"], scalars["creepage_lateral"], scalars["status"]), (solution.fx, solution.creepage.lateral, "ok"))
        self.assertEqual((frame.attrs["units"]["fx"], frame.attrs["units"]["frictional_power"]), ("N", "W"))

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

    def test_inputs_that_all_share_have_no_dimensions(self):
        data = map_of_forces().to_xarray()
        self.assertEqual((data.normal_force.dims, data.normal_force.attrs["units"], float(data.normal_force)), ((), "N", contact().normal_force))
        self.assertEqual((data.spin.dims, data.spin.attrs["units"]), (("dim_0", "dim_1"), "1/m"))
        self.assertEqual(data.attrs["result"], "ForceArrays")

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
        self.assertEqual(repr(microslip.Solver(theory="exact", grid=(8, 6))), "Solver(Method(theory='exact', grid=(8, 6)))")


load_tests = load_tests_if_compiled([DataFrameTest, DatasetTest, CodesTest])

if __name__ == "__main__":
    unittest.main()
