"""Case files: what they say, what they give, the result file that pictures are drawn from, errors with line and key."""

import contextlib
import copy
import io
import math
import pickle
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np

import microslip
from microslip import plot
from tests.compiled import load_tests_if_compiled

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CASE = """title = "A ball"
[body1]
rolling_radius = 0.1
transverse_radius = 0.1
young_modulus = 210e9
poisson_ratio = 0.28
[body2]
rolling_radius = inf
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[load]
normal_force = 1e3
[friction]
coefficient = 0.3
[motion]
creepage_longitudinal = 0.001
rolling_speed = 2.0
[solution]
theory = "exact"
grid = [8, 8]
"""


class CaseFilesTest(unittest.TestCase):
    def test_a_case_says_what_its_file_says(self):
        case = microslip.read_case(EXAMPLES / "hertzian_contact.toml")
        self.assertEqual((case.method.theory, case.body1.rolling_radius, case.body2.rolling_radius), ("exact", 0.46, math.inf))
        self.assertAlmostEqual(case.hertz.peak_pressure, 1139.19e6, delta=1e4)
        self.assertEqual(case.contact.a, case.hertz.a)
        self.assertEqual(case.text, (EXAMPLES / "hertzian_contact.toml").read_text())

    def test_results_are_those_of_the_solvers(self):
        case = microslip.parse_case(CASE)
        result = microslip.solve_case(case)
        self.assertEqual(result.exact.forces.fx, microslip.Solver(theory="exact", grid=8).solve(case.contact).forces.fx)
        self.assertEqual(result.simplified.forces.fx, microslip.Fastsim2(8, 8).solve(case.contact).fx)
        self.assertEqual(result.exact.solution.fields.gap.shape, result.exact.solution.fields.pressure.shape)
        self.assertEqual(result.simplified.curve.variable, "creepage_longitudinal")
        self.assertEqual(result.simplified.curve.fx.shape, result.simplified.curve.value.shape)
        self.assertIsNone(result.exact.limit)
        self.assertIs(result.status, microslip.Status.ok)

    def test_stresses_are_at_the_points_of_the_case(self):
        self.assertIsNone(microslip.solve_case(microslip.parse_case(CASE)).interior)
        x, z = [0.0, 5e-5], [-2e-4, 1e-4, 2e-4]
        case = microslip.parse_case(CASE + f"[interior]\nx = {x}\ny = [0.0]\nz = {z}\n")
        result = microslip.solve_case(case)
        self.assertEqual(result.interior.zz.shape, (3, 1, 2))
        inside = result.exact.solution.interior_states(case.body1.material, case.body2.material, x, 0.0, z)
        np.testing.assert_allclose(result.interior.zz, inside.zz, rtol=1e-9)
        self.assertEqual(pickle.loads(pickle.dumps(result)).interior, result.interior)

    def test_damage_is_that_of_the_functions(self):
        self.assertIsNone(microslip.solve_case(microslip.parse_case(CASE)).damage)
        case = microslip.parse_case(CASE + "[material]\nhardness = 2.7e9\n")
        self.assertEqual(case.strength, microslip.SurfaceStrength(hardness=2.7e9))
        result = microslip.solve_case(case)
        damage, solution = result.damage, result.exact.solution
        self.assertEqual(damage.t_gamma, -solution.fx * 0.001)
        self.assertIsNone(damage.fatigue_index)
        self.assertEqual(sorted(damage.fields), ["friction_work", "wear_depth"])
        np.testing.assert_array_equal(damage.fields["friction_work"], microslip.friction_work(solution))
        depth = microslip.wear_depth(solution, hardness=2.7e9, rolling_speed=2.0)
        np.testing.assert_array_equal(damage.fields["wear_depth"], depth)
        self.assertAlmostEqual(damage.wear_depth, depth.sum(axis=1).max(), delta=1e-12 * damage.wear_depth)

    def test_solvers_refuse_what_the_case_cannot_have(self):
        text = CASE.replace("young_modulus = 210e9", "young_modulus = 70e9", 1)
        case = microslip.parse_case(text)
        for change in ({"discretisation": "second_order"}, {"accuracy": 1e-2, "discretisation": "second_order"}):
            with self.assertRaisesRegex(microslip.Error, "discretisation: must be classical for bodies of different"):
                microslip.Solver(case.method.replace(**change)).solve(case.problem)
        with self.assertRaisesRegex(microslip.Error, "discretisation: must be classical for bodies of different"):
            microslip.parse_case(text + 'discretisation = "second_order"\n')

    def test_a_case_of_the_simplified_theory_has_no_exact_result(self):
        result = microslip.solve_case(microslip.parse_case(CASE.replace('"exact"', '"fastsim"')))
        self.assertIsNone(result.exact)

    def test_written_results_can_be_drawn(self):
        result = microslip.solve_case(microslip.parse_case(CASE, "ball.toml"))
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "result.h5"
            result.write(path)
            with h5py.File(path) as file:
                self.assertEqual(file["/exact/fx"][()], result.exact.forces.fx)
                self.assertEqual((file.attrs["kind"], file.attrs["case_text"]), ("rolling_contact", CASE))
            with contextlib.redirect_stdout(io.StringIO()):
                self.assertEqual(plot.main([str(path)]), 0)
            with self.assertRaisesRegex(microslip.Error, "nowhere"):
                result.write(Path(folder) / "nowhere" / "result.h5")

    def test_errors_have_line_and_key(self):
        with self.assertRaisesRegex(microslip.Error, "ball.toml:13: load.normal_forse.*did you mean normal_force"):
            microslip.parse_case(CASE.replace("normal_force", "normal_forse"), "ball.toml")

    def test_missing_files_and_folders_are_pythons_errors(self):
        with tempfile.TemporaryDirectory() as folder:
            for read in (microslip.read_case, microslip.run_contact_input):
                with self.assertRaisesRegex(FileNotFoundError, "nowhere.toml"):
                    read(Path(folder) / "nowhere.toml")
                with self.assertRaisesRegex(IsADirectoryError, Path(folder).name):
                    read(folder)

    def test_the_contact_of_a_case_is_not_changed_silently(self):
        case = microslip.parse_case(CASE)
        for change in ("case.contact.creepage = (0, 0, 1)", "case.contact.creepage.spin = 1.0", "case.contact.friction = 0.1",
                       "case.contact.a = 1e-3", "case.contact.dissimilarity = 0.1"):
            with self.subTest(change), self.assertRaisesRegex(microslip.Error, r"belongs to a case.*copy\.copy\(case\.contact\)"):
                exec(change, {"case": case})
        for made in (copy.copy(case.contact), copy.deepcopy(case.contact), pickle.loads(pickle.dumps(case.contact))):
            self.assertIs(type(made), microslip.EllipticContact)
            self.assertEqual(made, case.contact)
            made.creepage = (0, 0, 1)
            made.creepage.lateral = 0.5
            self.assertEqual(tuple(made.creepage), (0, 0.5, 1))
        self.assertEqual(tuple(case.contact.creepage), (0.001, 0, 0))


load_tests = load_tests_if_compiled([CaseFilesTest])
