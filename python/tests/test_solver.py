"""Problem, method and solver: the exact theory's documented case, forces given, shifts, steps, derivatives by differences, accuracy, batches."""

import copy
import pickle
import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled
from tests.test_case_files import CASE, EXAMPLES


class SolverTest(unittest.TestCase):
    def setUp(self):
        self.solver = microslip.Solver(theory="exact", grid=12)

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
        classical = microslip.Solver(theory="exact", grid=40, discretisation="classical").solve(contact()).forces.fx
        self.assertAlmostEqual(second / classical, 1, delta=0.02)

    def test_forces_given_are_reached(self):
        solved = self.solver.solve(microslip.RollingProblem(contact(), force_longitudinal=-10e3, force_lateral=2e3))
        self.assertAlmostEqual(solved.forces.fx / -10e3, 1, places=5)
        self.assertAlmostEqual(solved.forces.fy / 2e3, 1, places=5)
        again = self.solver.solve(contact(tuple(solved.creepage)))
        self.assertAlmostEqual(again.forces.fx / -10e3, 1, places=3)

    def test_a_force_beyond_friction_has_no_solution(self):
        self.assertIs(self.solver.solve(microslip.RollingProblem(contact(), force_longitudinal=-30e3)).forces.status, microslip.Status.no_solution)

    def test_transient_rolling_tends_to_the_steady_state(self):
        steady = microslip.Solver(theory="exact", grid=12, discretisation="classical").solve(contact())
        rolled = self.solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=40))
        self.assertEqual(len(rolled.history), 40)
        forces = [step.forces.fx for step in rolled.history]
        self.assertGreater(forces[0], 0.5 * forces[-1])
        self.assertAlmostEqual(forces[-1] / steady.forces.fx, 1, delta=0.02)

    def test_a_small_shift_follows_cattaneo(self):
        # Johnson 1985, (7.42): tangential displacement of a circular contact without slip, F (2 - nu)/(8 G a) for each body.
        pair = microslip.CombinedMaterial(80e9, 0.25)
        circle = microslip.hertz_from_ellipse(5e-3, 5e-3, pair, 50e3)
        made = microslip.EllipticContact(circle.a, circle.b, 80e9, 0.25, 50e3, 0.3)
        shifted = microslip.Solver(theory="exact", grid=24).solve(microslip.RollingProblem(made, kind="shift", shift_longitudinal=1e-8))
        self.assertAlmostEqual(shifted.forces.fx / (-1e-8 * 8 * 80e9 * 5e-3 / (2 * 1.75)), 1, delta=0.02)

    def test_derivatives_are_those_of_differences(self):
        at, step = np.array([0.0009, 0.0003, 0.2]), 1e-8
        solver = microslip.Solver(theory="exact", grid=12, tolerance=1e-11)
        found = solver.differentiate(contact(at))
        self.assertEqual(found.jacobian.shape, (3, 3))
        more, less = (solver.solve(contact(at + side * step * np.eye(3)[0])).forces for side in (1, -1))
        self.assertAlmostEqual(found.jacobian[0, 0] / ((more.fx - less.fx) / (2 * step)), 1, delta=1e-3)
        self.assertEqual(found.by_load.shape, (3,))

    def test_derivatives_of_dissimilar_bodies(self):
        pair = microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))
        solver = microslip.Solver(theory="exact", grid=8, tolerance=1e-11)
        problem = microslip.RollingProblem(contact(), bodies=pair)
        found, step = solver.differentiate(problem), 1e-8
        at = problem.creepage_longitudinal
        more, less = (solver.solve(problem.replace(creepage_longitudinal=at + side * step)).forces for side in (1, -1))
        self.assertAlmostEqual(found.jacobian[0, 0] / ((more.fx - less.fx) / (2 * step)), 1, delta=1e-3)

    def test_a_tolerance_has_the_range_that_case_files_have(self):
        for bad in (0.55, 0.11, 9e-15, float("nan")):
            with self.assertRaisesRegex(microslip.Error, r"tolerance = .*: must be in \[1e-14, 0.1\]"):
                microslip.Solver(theory="exact", grid=12, tolerance=bad)
        microslip.Solver(theory="exact", grid=12, tolerance=0.1)

    def test_the_gap_is_zero_in_contact(self):
        for discretisation in ("second_order", "classical"):
            solver = microslip.Solver(theory="exact", grid=12, discretisation=discretisation)
            solved, gap = solver.solve(contact()), solver.deformed_gap(contact())
            self.assertEqual(gap.shape, solved.fields.pressure.shape)
            self.assertLess(abs(gap[5:7, 6]).max(), 1e-10)
            self.assertGreater(gap[0, 0], 1e-7)

    def test_the_gap_has_the_grid_of_the_solution_whatever_the_options(self):
        falling = microslip.FrictionLaw.exponential(0.2, (0.1, 0.5))
        unlike = microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))
        bilinear = {"elements": "bilinear", "discretisation": "classical"}
        for options, changes in (({}, {"friction": falling}), ({}, {"bodies": unlike}), ({}, {"direction": "backward"}), (bilinear, {})):
            solver, made = microslip.Solver(theory="exact", grid=(12, 10), **options), microslip.RollingProblem(contact(), **changes)
            self.assertEqual(solver.deformed_gap(made).shape, solver.solve(made).fields.x.shape, (options, changes))

    def test_the_gap_of_a_shift_has_the_shape_of_its_results(self):
        shift = microslip.RollingProblem(contact(), kind="shift", shift_longitudinal=1e-6)
        solved, gap = self.solver.solve(shift), self.solver.deformed_gap(shift)
        self.assertEqual(gap.shape, solved.fields.pressure.shape)

    def test_a_batch_is_its_single_calls(self):
        xi = np.linspace(1e-4, 3e-3, 9)
        for threads in (1, 2):
            batch = self.solver.solve_batch(contact(), xi, friction=[[0.2], [0.4]], threads=threads)
            self.assertEqual((batch.forces.fx.shape, batch.residual.shape, batch.newton_steps.shape), ((2, 9),) * 3)
            single = microslip.Solver(theory="exact", grid=12).solve(contact((xi[4], 0.0006, 0.4), 0.4))
            self.assertEqual(batch.forces.fy[1, 4], single.forces.fy)
            self.assertTrue(np.all(batch.forces.status == microslip.Status.ok))

    def test_a_batch_of_dissimilar_bodies_has_their_constants(self):
        steel, aluminium = (microslip.Material.from_young(*constants) for constants in ((210e9, 0.28), (70e9, 0.33)))
        pair = microslip.combine(steel, aluminium)
        solver = microslip.Solver(theory="exact", grid=8)
        like = microslip.RollingProblem(a=0.006, b=0.005, bodies=pair, normal_force=80e3, friction=0.3, rolling_speed=2.0)
        batch = solver.solve_batch(like, [0, 1e-3])
        self.assertEqual(batch.forces.fx[1], solver.solve(like.replace(creepage_longitudinal=1e-3)).forces.fx)
        self.assertNotEqual(batch.forces.fx[0], 0)
        creep = microslip.MaterialCreep(0.5, 1e-4)
        rubber = like.replace(bodies=microslip.viscoelastic(steel, creep, steel, creep, 2.0))
        for constants in ({"shear_modulus": 80e9}, {"poisson_ratio": [0.2, 0.3]}):
            with self.assertRaisesRegex(microslip.Error, "bodies have their own"):
                solver.solve_batch(rubber, 1e-3, **constants)

    def test_layers_are_those_of_case_files(self):
        roller = microslip.read_case(EXAMPLES / "rubber_roller.toml")
        self.assertEqual(len(roller.body2.layers), 1)
        steel = microslip.Material.from_young(210e9, 0.28)
        young = microslip.young_modulus_of_shore_a(60)
        self.assertAlmostEqual(microslip.shore_a_of_young_modulus(young), 60, places=9)
        rubber = microslip.ViscoelasticMaterial(microslip.Material.from_young(young, 0.499), [(0.15, 0.5e-3), (0.1, 20e-3)], [])
        cover = microslip.LayeredBody(steel, [microslip.BodyLayer(15e-3, rubber)])
        bodies = microslip.LayeredBodies(microslip.LayeredBody(steel), cover, 5.0)
        self.assertEqual(roller.problem.bodies, bodies)
        problem = microslip.RollingProblem(bodies=bodies, gap=microslip.GapCurvatures(0.5 * (1 / 0.1 + 1 / 0.15), 0), normal_force=10e3,
                                           friction=0.6, force_longitudinal=-400, rolling_speed=5)
        self.assertEqual(roller.problem, problem)
        solver = microslip.Solver(theory="exact", grid=16)
        with self.subTest("the same numbers in a batch"):
            like = problem.replace(creepage_longitudinal=-0.02)
            batch = solver.solve_batch(like, [-0.02, -0.01])
            self.assertEqual(batch.forces.fx[0], solver.solve(like).fx)
        nip = microslip.nip_of(like, solver.solve(like), 0.1, 0.15)
        self.assertAlmostEqual(nip.hysteresis_power + nip.slip_power,
                               nip.body1.drive * 5.05 + nip.body2.drive * 4.95, delta=1e-6 * nip.slip_power)
        with self.assertRaisesRegex(microslip.Error, "bodies with layers have their own"):
            solver.solve_batch(like, -0.02, shear_modulus=1e6)
        with self.assertRaisesRegex(microslip.Error, 'layers: needs theory="exact"'):
            microslip.Solver(theory="fastsim2").solve(like)

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
            problem = microslip.RollingProblem(case.contact, **keywords)
            solved = microslip.Solver(theory="exact", grid=8, discretisation="classical").solve(problem)
            self.assertIs(solved.status, microslip.Status.ok, solved.reason)
            self.assertAlmostEqual(solved.fx / microslip.Solver(case.method).solve(case.problem).fx, 1, places=10)
            self.assertEqual(solved.fields.temperature1 is None, "thermal" not in keywords)
            forces.add(solved.fx)
        self.assertEqual(len(forces), 4)
        with self.assertRaisesRegex(microslip.Error, "thermal_change: needs the thermal data of both bodies"):
            self.solver.solve(microslip.RollingProblem(contact(), temperature_effect=microslip.TemperatureEffect(-0.2, 20.0, 300.0)))
        with self.assertRaisesRegex(microslip.Error, "conductivity"):
            microslip.ThermalBody(20.0, -50.0, 7850.0, 450.0)

    def test_options_out_of_range(self):
        with self.assertRaisesRegex(microslip.Error, r"Method: grid = 0 \[-\]: must be in \[1, 2000\]"):
            microslip.Solver(theory="exact", grid=(0, 12))
        with self.assertRaisesRegex(microslip.Error, "did you mean classical"):
            microslip.Solver(discretisation="clasical")
        falling = contact(friction=microslip.FrictionLaw.polach(0.3, 0.5, 1))
        self.assertIs(self.solver.solve(falling).forces.status, microslip.Status.ok)
        self.assertIs(self.solver.differentiate(falling).solution.status,
                      microslip.Status.invalid_input)


class FrequencyResponseTest(unittest.TestCase):
    def test_of_endless_waves_is_the_jacobian(self):
        solver = microslip.Solver(theory="exact", grid=12)
        derivatives, response = solver.differentiate(contact()), solver.respond(contact(), [0.0, 300.0])
        self.assertEqual((response.by_creepage.shape, response.by_load.shape), ((2, 3, 3), (2, 3)))
        np.testing.assert_array_equal(response.wavenumber, [0, 300])
        np.testing.assert_allclose(response.by_creepage[0].real, derivatives.jacobian, rtol=1e-3, atol=1e-4 * abs(derivatives.jacobian).max())
        np.testing.assert_array_equal(response.by_creepage[0].imag, np.zeros((3, 3)))
        self.assertLess(abs(response.by_creepage[1, 0, 0]), 0.9 * abs(response.by_creepage[0, 0, 0]))
        self.assertEqual(pickle.loads(pickle.dumps(response)), response)

    def test_roughness(self):
        response = microslip.Solver(theory="exact").respond(contact(), [0.0, 300.0], roughness=True)
        self.assertEqual((response.by_roughness.shape, response.load_by_roughness.shape), ((2, 3), (2,)))
        self.assertAlmostEqual(response.load_by_roughness[0] / response.normal_stiffness, 1, delta=5e-3)
        self.assertGreater(response.work_by_load[0].real, 0)
        self.assertEqual(pickle.loads(pickle.dumps(response)), response)

    def test_force_element(self):
        wavenumber = np.append(0, np.geomspace(5, 1000, 30))
        steady = contact()
        response = microslip.Solver(theory="exact").respond(steady, wavenumber)
        element = microslip.ForceElement(response, steady.normal_force, 10)
        self.assertLess(element.error, 0.02)
        np.testing.assert_allclose(element.response(wavenumber[5])[:, :3], response.by_creepage[5], atol=0.02 * abs(response.by_creepage).max())
        xi, eta, phi = steady.creepage.longitudinal, steady.creepage.lateral, steady.creepage.spin
        np.testing.assert_allclose(element.step(1e-3, xi, eta, phi, steady.normal_force)[0], response.solution.forces.fx)
        kept = copy.copy(element)
        once = element.step(1e-3, 1.1 * xi, eta, phi, steady.normal_force)
        self.assertEqual(kept.step(1e-3, 1.1 * xi, eta, phi, steady.normal_force), once)
        again = pickle.loads(pickle.dumps(element))
        self.assertEqual(again.step(1e-3, xi, eta, phi, steady.normal_force), element.step(1e-3, xi, eta, phi, steady.normal_force))
        self.assertEqual(microslip.ForceElement.from_text(element.text()).text(), element.text())
        self.assertRaises(microslip.Error, microslip.ForceElement, response, steady.normal_force, 60)
        self.assertRaisesRegex(microslip.Error, "normal_force", microslip.ForceElement, response, 0.0, 10)
        self.assertRaisesRegex(microslip.Error, "lateral", element.step, 1e-3, xi, np.nan, phi, steady.normal_force)

    def test_remington_filter(self):
        self.assertAlmostEqual(microslip.remington_filter(6e-3, 1.0, 0.0), 1, places=12)
        self.assertLess(microslip.remington_filter(6e-3, 1.0, 300.0), 1)

    def test_contact_filter(self):
        self.assertEqual(microslip.contact_filter(5e-3, 3e-3, 0.0), 1)
        self.assertAlmostEqual(microslip.contact_filter(5e-3, 3e-3, np.pi / 5e-3), 0, places=12)

    def test_refuses_what_has_none(self):
        with self.assertRaisesRegex(microslip.Error, "exact"):
            microslip.Solver(theory="fastsim2").respond(contact(), [1.0])


class AccuracyTest(unittest.TestCase):
    def test_the_limit_is_as_good_as_it_says(self):
        rough = microslip.Solver(theory="exact", accuracy=1e-2).solve(contact())
        fine = microslip.Solver(theory="exact", accuracy=3e-4).solve(contact())
        self.assertLess(fine.grid.dx, rough.grid.dx)
        self.assertLess(abs(rough.forces.fx - fine.forces.fx) / 24e3, rough.estimated_error + fine.estimated_error)
        self.assertLess(rough.estimated_error, 1e-2)

    def test_of_what_is_solved_classically(self):
        pair = microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))
        problem = microslip.RollingProblem(contact(), bodies=pair)
        rough = microslip.Solver(theory="exact", accuracy=0.05).solve(problem)
        fine = microslip.Solver(theory="exact", accuracy=0.01).solve(problem)
        self.assertLessEqual(fine.estimated_error, 0.01)
        self.assertLess(abs(rough.forces.fx - fine.forces.fx) / 24e3, rough.estimated_error + fine.estimated_error)

    def test_a_step_is_refused(self):
        problem = microslip.RollingProblem(contact(), step=1e-3)
        with self.assertRaisesRegex(microslip.Error, "accuracy: needs steady rolling without step"):
            microslip.Solver(theory="exact", accuracy=0.05).solve(problem)

    def test_accuracy_out_of_range(self):
        with self.assertRaisesRegex(microslip.Error, "accuracy"):
            microslip.Solver(theory="exact", accuracy=1)


class RollingProblemTest(unittest.TestCase):
    def setUp(self):
        steel = microslip.Material.from_young(210e9, 0.28)
        self.pair = microslip.combine(steel, steel)
        self.keywords = {"a": 6e-3, "b": 5e-3, "bodies": self.pair, "normal_force": 80e3, "friction": 0.3, "rolling_speed": 20.0}
        self.problem = microslip.RollingProblem(**self.keywords, creepage_longitudinal=1e-3, spin=0.4)
        self.solver = microslip.Solver(theory="exact", grid=12)

    def test_it_is_what_a_contact_makes(self):
        made = microslip.EllipticContact(6e-3, 5e-3, self.pair.shear_modulus, self.pair.poisson_ratio, 80e3, 0.3, (1e-3, 0, 0.4), 20.0)
        self.assertEqual(self.problem, microslip.RollingProblem(made))
        self.assertEqual(self.solver.solve(self.problem), self.solver.solve(made))

    def test_it_is_what_a_case_file_says(self):
        case = microslip.parse_case(CASE)
        self.assertEqual(microslip.Solver(case.method).solve(case.problem).fx, microslip.solve_case(case).exact.forces.fx)
        contact = case.contact
        self.assertAlmostEqual(microslip.Solver(case.method).solve(contact).fx / microslip.Solver(case.method).solve(case.problem).fx, 1,
                               places=10)

    def test_what_is_missing_is_an_error_as_in_a_case_file(self):
        for key, text in (("rolling_speed", "rolling_speed is missing"), ("normal_force", "needs either normal_force or approach"),
                          ("friction", "friction is missing"), ("bodies", "bodies is missing"), ("b", "b is missing")):
            with self.assertRaisesRegex(microslip.Error, f"^RollingProblem: {text}"):
                microslip.RollingProblem(**{name: value for name, value in self.keywords.items() if name != key})
        with self.assertRaisesRegex(microslip.Error, "either a and b or gap"):
            microslip.RollingProblem(**self.keywords, gap=microslip.GapCurvatures(1.0, 1.0))

    def test_numbers_out_of_range_and_unknown_names_are_errors(self):
        for changes, text in (({"rolling_speed": -1}, r"rolling_speed = -1 \[m/s\]: must be positive"),
                              ({"spinn": 0.1}, "spinn is no keyword of it; did you mean spin"),
                              ({"kind": "stedy"}, "did you mean steady"),
                              ({"step": [1, 2]}, "step: must be a number, not a list"),
                              ({"approach": 1e-5, "normal_force": 1.0}, "needs either"),
                              ({"rotation": 0.1}, "rotation: needs"),
                              ({"memory_speed": -1}, "memory_speed = -1"),
                              ({"grid": microslip.ElementGrid(2, 2, 0, 0, 1, 1)}, "needs either a and b or gap")):
            with self.assertRaisesRegex(microslip.Error, "^RollingProblem: .*" + text):
                self.problem.replace(**changes)
        with self.assertRaisesRegex(TypeError, "bodies cannot be 3"):
            self.problem.replace(bodies=3)

    def test_keywords_in_place_of_others(self):
        by_force = self.problem.replace(force_longitudinal=-5e3)
        self.assertEqual((by_force.creepage_longitudinal, by_force.force_longitudinal, by_force.spin), (None, -5e3, 0.4))
        self.assertAlmostEqual(self.solver.solve(by_force).fx, -5e3, places=1)
        self.assertEqual(by_force.replace(creepage_longitudinal=1e-3), self.problem)
        shift = self.problem.replace(kind="shift", rotation=1e-4)
        self.assertEqual((shift.rolling_speed, shift.spin, shift.rotation, shift.a), (None, None, 1e-4, 6e-3))
        self.assertIsNone(self.problem.replace(approach=1e-5).normal_force)

    def test_curvatures_and_a_gap_on_a_grid_are_solved(self):
        hertz = microslip.hertz_from_ellipse(6e-3, 5e-3, self.pair, 80e3)
        by_ellipse = self.solver.solve(self.problem).fx
        by_curvatures = self.problem.replace(gap=hertz.gap)
        self.assertIsNone(by_curvatures.a)
        self.assertAlmostEqual(self.solver.solve(by_curvatures).fx / by_ellipse, 1, places=6)
        batch = self.solver.solve_batch(by_curvatures, 1e-3, normal_force=[40e3, 80e3]).forces
        self.assertAlmostEqual(batch.fx[0] / self.solver.solve(by_curvatures.replace(normal_force=40e3)).fx, 1, places=12)
        grid = microslip.ElementGrid.across_ellipse(6e-3, 5e-3, 40, 40, 6)
        on_grid = by_curvatures.replace(gap=microslip.hertzian_gap(hertz.gap, grid), grid=grid)
        self.assertAlmostEqual(self.solver.solve(on_grid).fx / by_ellipse, 1, delta=0.01)
        with self.assertRaisesRegex(microslip.Error, "gap has shape"):
            on_grid.replace(gap=[1.0, 2.0, 3.0])

    def test_problems_and_methods_are_values(self):
        hertz = microslip.hertz_from_ellipse(6e-3, 5e-3, self.pair, 80e3)
        grid = microslip.ElementGrid.across_ellipse(6e-3, 5e-3, 4, 4, 1)
        heat = microslip.ThermalBody(20.0, 50.0, 7850.0, 450.0)
        for value in (self.problem, self.problem.replace(gap=microslip.hertzian_gap(hertz.gap, grid), grid=grid, thermal=(heat, heat)),
                      microslip.Method(theory="fastsim", grid=(8, 6), slope_reduction=(0.5, 1, 0)), microslip.Method()):
            for made in (copy.copy(value), copy.deepcopy(value), pickle.loads(pickle.dumps(value))):
                self.assertEqual(made, value)
            self.assertNotEqual(value, self.problem.replace(spin=0.5))
        self.assertEqual(repr(microslip.Method(theory="exact", grid=(8, 6))), "Method(theory='exact', grid=(8, 6))")
        self.assertIn("a=0.006, b=0.005, normal_force=80000.0", repr(self.problem).replace(f"bodies={self.problem.bodies!r}, ", ""))


class MethodTest(unittest.TestCase):
    def test_what_is_left_out_is_as_in_case_files(self):
        method = microslip.Method()
        for one in microslip.inputs("bodies"):
            if one["section"] == "solution" and one["default"] is not None and one["key"] not in ("discretisation", "elements", "coupling",
                                                                                                 "slip_start", "bound", "flexibility"):
                self.assertEqual(getattr(method, one["key"]), one["default"], one["key"])
        self.assertIsNone(method.bound)  # the best for the problem

    def test_a_solver_has_it(self):
        method = microslip.Method(theory="exact", grid=12, tolerance=1e-8)
        self.assertEqual(microslip.Solver(method).method, method)
        self.assertEqual(microslip.Solver(theory="exact", grid=12, tolerance=1e-8).method, method)
        self.assertEqual(method.replace(tolerance=None), microslip.Method(theory="exact", grid=12))

    def test_simplified_theories_and_tables_solve_the_same_problem(self):
        problem = microslip.RollingProblem(contact())
        exact = microslip.Solver(theory="exact", grid=24).solve(problem).fx
        for theory in ("fastsim", "fastsim_half_step", "fastsim2", "fastrip", "table"):
            self.assertAlmostEqual(microslip.Solver(theory=theory).solve(problem).fx / exact, 1, delta=0.1)
        self.assertEqual(microslip.Solver(theory="fastsim2", grid=10).solve(problem).fx, microslip.Fastsim2(10, 10).fields(contact()).fx)
        table = microslip.CreepForceTable()
        self.assertEqual(microslip.Solver(theory="table", table=table).solve(problem).fx, table.solve(contact()).fx)
        with self.assertRaisesRegex(microslip.Error, 'table: needs theory="table"'):
            microslip.Method(table=table)

    def test_what_it_cannot_honour_is_an_error(self):
        with self.assertRaisesRegex(microslip.Error, 'kind: needs theory="exact"'):
            microslip.Solver().solve(microslip.RollingProblem(contact(), kind="transient"))
        with self.assertRaisesRegex(microslip.Error, "tolerence is no keyword of it; did you mean tolerance"):
            microslip.Method(tolerence=1e-3)


load_tests = load_tests_if_compiled([SolverTest, FrequencyResponseTest, AccuracyTest, RollingProblemTest, MethodTest])
