"""The exact theory: its documented case, forces given, shifts, steps, derivatives by differences, accuracy, batches."""

import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled
from tests.test_case_files import CASE


class EllipticContactSolverTest(unittest.TestCase):
    def setUp(self):
        self.solver = microslip.EllipticContactSolver(12, 12)

    def test_fields_add_up_to_the_forces(self):
        solved = self.solver.solve(contact())
        fields = solved.fields
        self.assertEqual((fields.px.shape, fields.pressure.shape, fields.ux.shape), ((solved.grid.my, solved.grid.mx),) * 3)
        self.assertAlmostEqual((fields.area * fields.px).sum() / solved.forces.fx, 1, places=12)
        self.assertAlmostEqual((fields.area * fields.pressure).sum() / 80e3, 1, places=9)
        self.assertAlmostEqual(solved.frictional_power / solved.power_by_creepage, 1, delta=0.01)
        self.assertLess(solved.residual, 1e-6)

    def test_both_discretisations_tend_to_one_limit(self):
        second = self.solver.solve(contact()).forces.fx
        classical = microslip.EllipticContactSolver(40, 40, discretisation="classical").solve(contact()).forces.fx
        self.assertAlmostEqual(second / classical, 1, delta=0.02)

    def test_forces_given_are_reached(self):
        solved = self.solver.solve(contact(), force_x=-10e3, force_y=2e3)
        self.assertAlmostEqual(solved.forces.fx / -10e3, 1, places=5)
        self.assertAlmostEqual(solved.forces.fy / 2e3, 1, places=5)
        again = self.solver.solve(contact(tuple(solved.creepage)))
        self.assertAlmostEqual(again.forces.fx / -10e3, 1, places=3)

    def test_a_force_beyond_friction_has_no_solution(self):
        self.assertIs(self.solver.solve(contact(), force_x=-30e3).forces.status, microslip.Status.no_solution)

    def test_transient_rolling_tends_to_the_steady_state(self):
        steady = microslip.EllipticContactSolver(12, 12, discretisation="classical").solve(contact())
        rolled = self.solver.solve(contact(), motion="transient", steps=40)
        self.assertEqual(len(rolled.history), 40)
        forces = [step.forces.fx for step in rolled.history]
        self.assertGreater(forces[0], 0.5 * forces[-1])
        self.assertAlmostEqual(forces[-1] / steady.forces.fx, 1, delta=0.02)

    def test_a_small_shift_follows_cattaneo(self):
        # Johnson 1985, (7.42): tangential displacement of a circular contact without slip, F (2 - nu)/(8 G a) for each body.
        pair = microslip.CombinedMaterial(80e9, 0.25)
        circle = microslip.hertz_from_ellipse(5e-3, 5e-3, pair, 50e3)
        made = microslip.EllipticContact(circle.a, circle.b, 80e9, 0.25, 50e3, 0.3, (1e-8, 0, 0))
        shifted = microslip.EllipticContactSolver(24, 24).solve(made, motion="shift")
        self.assertAlmostEqual(shifted.forces.fx / (-1e-8 * 8 * 80e9 * 5e-3 / (2 * 1.75)), 1, delta=0.02)

    def test_derivatives_are_those_of_differences(self):
        at, step = np.array([0.0009, 0.0003, 0.2]), 1e-8
        solver = microslip.EllipticContactSolver(12, 12, tolerance=1e-11)
        found = solver.differentiate(contact(at))
        self.assertEqual(found.jacobian.shape, (3, 3))
        more, less = (solver.solve(contact(at + side * step * np.eye(3)[0])).forces for side in (1, -1))
        self.assertAlmostEqual(found.jacobian[0, 0] / ((more.fx - less.fx) / (2 * step)), 1, delta=1e-3)

    def test_a_tolerance_has_the_range_that_case_files_have(self):
        for bad in (0.55, 0.11, 9e-15, float("nan")):
            with self.assertRaisesRegex(microslip.Error, r"tolerance = .*: must be in \[1e-14, 0.1\]"):
                microslip.EllipticContactSolver(12, 12, tolerance=bad)
        microslip.EllipticContactSolver(12, 12, tolerance=0.1)

    def test_the_gap_is_zero_in_contact(self):
        for discretisation in ("second_order", "classical"):
            solver = microslip.EllipticContactSolver(12, 12, discretisation=discretisation)
            solved, gap = solver.solve(contact()), solver.deformed_gap(contact())
            self.assertEqual(gap.shape, solved.fields.pressure.shape)
            self.assertLess(abs(gap[5:7, 6]).max(), 1e-10)
            self.assertGreater(gap[0, 0], 1e-7)

    def test_the_gap_has_the_grid_of_the_solution_whatever_the_options(self):
        falling = microslip.FrictionLaw.exponential(0.2, (0.1, 0.5))
        unlike = microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))
        for options, made in (({}, contact(friction=falling)), ({"bodies": unlike}, contact()),
                              ({"direction": "backward"}, contact()), ({"elements": "bilinear", "discretisation": "classical"}, contact())):
            solver = microslip.EllipticContactSolver(12, 10, **options)
            self.assertEqual(solver.deformed_gap(made).shape, solver.solve(made).fields.x.shape, options)

    def test_the_gap_of_a_shift_has_the_shape_of_its_results(self):
        solved, gap = self.solver.solve(contact(), motion="shift"), self.solver.deformed_gap(contact(), motion="shift")
        self.assertEqual(gap.shape, solved.fields.pressure.shape)

    def test_a_batch_is_its_single_calls(self):
        xi = np.linspace(1e-4, 3e-3, 9)
        for threads in (1, 2):
            batch = self.solver.solve_batch(contact(), xi, friction=[[0.2], [0.4]], threads=threads)
            self.assertEqual((batch.forces.fx.shape, batch.residual.shape, batch.newton_steps.shape), ((2, 9),) * 3)
            single = microslip.EllipticContactSolver(12, 12).solve(contact((xi[4], 0.0006, 0.4), 0.4))
            self.assertEqual(batch.forces.fy[1, 4], single.forces.fy)
            self.assertTrue(np.all(batch.forces.status == microslip.Status.ok))

    def test_a_batch_of_dissimilar_bodies_has_their_constants(self):
        steel, aluminium = (microslip.Material.from_young(*constants) for constants in ((210e9, 0.28), (70e9, 0.33)))
        pair = microslip.combine(steel, aluminium)
        solver = microslip.EllipticContactSolver(8, 8, bodies=pair)
        like = microslip.EllipticContact(0.006, 0.005, pair.shear_modulus, pair.poisson_ratio, 80e3, 0.3)
        batch = solver.solve_batch(like, [0, 1e-3])
        like.creepage.longitudinal = 1e-3
        self.assertEqual(batch.forces.fx[1], solver.solve(like).forces.fx)
        self.assertNotEqual(batch.forces.fx[0], 0)
        for constants in ({"shear_modulus": 80e9}, {"poisson_ratio": [0.2, 0.3]}):
            with self.assertRaisesRegex(microslip.Error, "bodies have their own"):
                solver.solve_batch(like, 1e-3, **constants)

    def test_options_reach_the_case_files(self):
        # A case with everything that the exact theory takes, and the same solver made by hand.
        steel = microslip.Material.from_young(210e9, 0.28)
        heat = ("bulk_temperature = 20.0\nconductivity = 50.0\ndensity = 7850.0\nheat_capacity = 450.0\n")
        text = CASE.replace("[body2]", heat + "[body2]").replace("[load]", heat + "[load]").replace("grid", 'discretisation = "classical"\ngrid')
        rubber = text.replace(heat, "creep_ratio = 0.5\ncreep_time = 1e-4\n", 1).replace(heat, "")
        layer = text.replace(heat, "").replace("[load]", "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\n[load]")
        effect = text.replace("coefficient = 0.3", "coefficient = 0.3\nthermal_change = -0.2\nthermal_begin = 20.0\nthermal_range = 300.0")
        body = microslip.ThermalBody(20.0, 50.0, 7850.0, 450.0)
        pair = microslip.combine(steel, steel)
        options = {
            text: {"thermal": (body, body)},
            effect: {"thermal": (body, body), "temperature_effect": microslip.TemperatureEffect(-0.2, 20.0, 300.0)},
            rubber: {"bodies": microslip.viscoelastic(steel, microslip.MaterialCreep(0.5, 1e-4), steel, microslip.MaterialCreep(0.0, 0.0), 2.0)},
            layer: {"bodies": microslip.Bodies(pair, microslip.InterfaceLayer(1e-14))},
        }
        forces = set()
        for case_text, keywords in options.items():
            case = microslip.parse_case(case_text)
            solved = microslip.EllipticContactSolver(8, 8, discretisation="classical", **keywords).solve(case.contact)
            self.assertIs(solved.status, microslip.Status.ok, solved.reason)
            self.assertAlmostEqual(solved.fx / case.exact_solver().solve(case.contact).fx, 1, places=10)
            self.assertEqual(solved.fields.temperature1 is None, "thermal" not in keywords)
            forces.add(solved.fx)
        self.assertEqual(len(forces), 4)
        with self.assertRaisesRegex(microslip.Error, "thermal_change: needs the thermal data of both bodies"):
            microslip.EllipticContactSolver(temperature_effect=microslip.TemperatureEffect(-0.2, 20.0, 300.0))
        with self.assertRaisesRegex(microslip.Error, "conductivity"):
            microslip.ThermalBody(20.0, -50.0, 7850.0, 450.0)

    def test_options_out_of_range(self):
        with self.assertRaisesRegex(microslip.Error, "mx = 0"):
            microslip.EllipticContactSolver(0, 12)
        with self.assertRaisesRegex(microslip.Error, "did you mean classical"):
            microslip.EllipticContactSolver(discretisation="clasical")
        falling = contact(friction=microslip.FrictionLaw.polach(0.3, 0.5, 1))
        self.assertIs(self.solver.solve(falling).forces.status, microslip.Status.ok)
        self.assertIs(self.solver.differentiate(falling).solution.status,
                      microslip.Status.invalid_input)


class AccurateContactSolverTest(unittest.TestCase):
    def test_the_limit_is_as_good_as_it_says(self):
        rough = microslip.AccurateContactSolver(1e-2).solve(contact())
        fine = microslip.AccurateContactSolver(3e-4).solve(contact())
        self.assertGreater(fine.elements, rough.elements)
        self.assertLess(abs(rough.forces.fx - fine.forces.fx) / 24e3, rough.error + fine.error)
        self.assertLess(rough.error, 1e-2)

    def test_what_is_solved_classically_is_refused(self):
        pair = microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))
        with self.assertRaisesRegex(microslip.Error, "accuracy: needs steady rolling without step, of second order"):
            microslip.AccurateContactSolver(0.05, bodies=pair).solve(contact())

    def test_accuracy_out_of_range(self):
        with self.assertRaisesRegex(microslip.Error, "accuracy"):
            microslip.AccurateContactSolver(1)


load_tests = load_tests_if_compiled([EllipticContactSolverTest, AccurateContactSolverTest])
