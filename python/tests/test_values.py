"""Objects as values: text, equality, copies, pickles with their version, dicts, tables in notebooks."""

import copy
import pickle
import unittest

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled, wheel_on_rail
from tests.test_case_files import CASE


ROLLER = """
[body1]
rolling_radius = 0.1
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[body2]
rolling_radius = 0.15
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[[body2.layers]]
thickness = 0.015
hardness = 60
poisson_ratio = 0.49
[load]
normal_force = 1e4
[friction]
coefficient = 0.5
[motion]
rolling_speed = 2.0
[solution]
theory = "exact"
grid = 16
"""


def unlike():
    """Combined aluminium and steel, K > 0."""
    return microslip.combine(microslip.Material.from_young(70e9, 0.33), microslip.Material.from_young(210e9, 0.28))


def rubber():
    """A material that relaxes."""
    return microslip.ViscoelasticMaterial(microslip.Material.from_young(4e6, 0.49), [(0.2, 1e-3), microslip.PronyTerm(0.1, 0.1)], [])


def covered():
    """Rubber on a rigid core."""
    return microslip.LayeredBody(microslip.Material.from_young(np.inf, 0.3), [microslip.BodyLayer(0.01, rubber())])


def values():
    """An object of every class of values, by the name of its class."""
    hertz, pair = wheel_on_rail()
    steel = microslip.Material.from_young(210e9, 0.28)
    solver = microslip.Solver(theory="exact", grid=(8, 6))
    solved = solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=2))
    grid = microslip.ElementGrid.across_ellipse(hertz.a, hertz.b, 8, 6, 3)
    gap = microslip.hertzian_gap(hertz.gap, grid)
    normal = microslip.NormalProblem(pair, grid).solve(gap, normal_force=80e3)
    tangential = microslip.TangentialProblem(pair, grid).solve(0.3 * normal.pressure, (1e-3, 0, 0))
    field = microslip.InteriorField(steel, 1, grid, pn=normal.pressure)
    result = microslip.solve_case(microslip.parse_case(CASE))
    roller = microslip.solve_case(microslip.parse_case(ROLLER))
    made = [
        microslip.Creepage(1e-3, -2e-4, 0.1), steel, pair, unlike(), hertz.gap, hertz,
        microslip.line_contact_from_load(1.0, pair, 1e6), contact(), contact(friction=microslip.FrictionLaw.polach(0.3, 0.4, 0.6)),
        microslip.FrictionLaw.rational(0.1, (0.2, 0.5), (0.1, 0.4)), microslip.creepage_coefficients(1, 0.25),
        microslip.MaterialCreep(1.0, 1e-3), microslip.InterfaceLayer(1e-14), microslip.InterfaceLayer(1e-14, 1e8, -2e9),
        microslip.Bodies(unlike(), microslip.InterfaceLayer(1e-14)),
        microslip.viscoelastic(steel, microslip.MaterialCreep(1.0, 1e-3), steel, microslip.MaterialCreep(0, 0), 10.0),
        rubber(), microslip.PronyTerm(0.2, 1e-3), microslip.BodyLayer(0.01, rubber()), covered(), microslip.LayeredBodies(covered(), covered(), 2.0),
        microslip.ThermalBody(20.0, 50.0, 7850.0, 450.0), microslip.TemperatureEffect(-0.1, 100.0, 600.0),
        microslip.Fastsim2().solve(contact()), microslip.Fastsim2().differentiate(contact()), microslip.Fastsim2(6, 5).fields(contact()),
        solved, solved.history[0], solver.differentiate(contact()), microslip.Solver(theory="exact", accuracy=0.05).solve(contact()),
        grid, normal, tangential, field.at([0, 1e-3], 0, 1e-3),
        microslip.InteriorLayers(field).find_largest(np.linspace(1e-3, 5e-3, 5)), result.exact.curve, result.exact.discretisation_error,
        result, result.exact, result.simplified, microslip.Fastsim2().solve_batch(contact(), [[1e-4, 1e-3]], spin=[[0.0], [0.4]]),
        microslip.Fastsim2().differentiate_batch(contact(), [1e-4, 1e-3]), solver.solve_batch(contact(), [1e-4, 1e-3]),
        roller, roller.exact.nip, roller.exact.nip.body2, roller.exact.free_roller1, roller.exact.peaks, roller.exact.peaks.layers[0],
        roller.exact.peaks.interfaces[0], microslip.parse_case(CASE), microslip.parse_case(CASE).body1, microslip.RollingProblem(contact()), microslip.Method(grid=8),
    ]
    return [(type(one).__name__, one) for one in made]


class ValuesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.values = values()

    def test_copies_and_pickles_are_equal(self):
        for name, value in self.values:
            with self.subTest(name):
                for made in (copy.copy(value), copy.deepcopy(value), *(pickle.loads(pickle.dumps(value, p)) for p in (2, 5))):
                    self.assertIsNot(made, value)
                    self.assertIs(type(made), type(value))
                    self.assertEqual(made, value)
                    self.assertEqual(repr(made), repr(value))
                    np.testing.assert_equal(made.to_dict(), value.to_dict())  # a field that copies and == do not know

    def test_values_differ(self):
        for name, value in self.values:
            for other_name, other in self.values:
                self.assertEqual(value == other, value is other, f"{name}, {other_name}")
        one, other = contact(), contact()
        self.assertEqual(one, other)
        other.friction = 0.31
        self.assertNotEqual(one, other)
        self.assertNotEqual(contact(), "a contact")

    def test_a_changed_copy_leaves_the_original_alone(self):
        one = contact()
        for other in (copy.copy(one), copy.deepcopy(one)):
            other.creepage.spin = 9.0
            self.assertEqual(one.creepage.spin, 0.4)

    def test_texts_name_the_fields(self):
        for name, value in self.values:
            self.assertRegex(repr(value), rf"^{name}\(\w+=")
        self.assertIn("dissimilarity=0.0", repr(contact()))
        self.assertRegex(repr(microslip.Solver(theory="exact", grid=4).solve(contact())), r"status=ok, fx=-1\d{4}\.")

    def test_dicts_have_every_field(self):
        for name, value in self.values:
            with self.subTest(name):
                fields = value.to_dict()
                properties = [key for cls in type(value).__mro__ for key, member in vars(cls).items() if isinstance(member, property)]
                self.assertEqual(sorted(fields), sorted(set(properties)))
                self.assertGreater(len(fields), 1)
        self.assertEqual(contact().to_dict()["creepage"], {"longitudinal": 0.0018, "lateral": 0.0006, "spin": 0.4})
        solved = microslip.Solver(theory="exact", grid=4).solve(contact())
        fields = solved.to_dict()
        self.assertEqual(fields["fx"], solved.fx)
        fields["fields"]["px"][:] = 0  # a copy of one's own
        self.assertGreater(abs(solved.fields.px).max(), 0)

    def test_pickles_of_other_versions_are_refused(self):
        for name, value in self.values:
            version, state = value.__getstate__()
            with self.subTest(name), self.assertRaisesRegex(microslip.Error, f"{name}: .*version {version + 1}: must be {version}"):
                type(value).__new__(type(value)).__setstate__((version + 1, state))

    def test_pickles_with_other_fields_are_refused(self):
        version, state = microslip.Creepage().__getstate__()
        for changed, text in (({**state, "slip": 1.0}, "fields that are not known"), ({"lateral": 0.0}, "lacks longitudinal"),
                              (None, "no pickled state")):
            with self.assertRaisesRegex(microslip.Error, f"Creepage: .*{text}"):
                microslip.Creepage.__new__(microslip.Creepage).__setstate__((version, changed))

    def test_pickled_fields_live_on(self):
        solved = microslip.Solver(theory="exact", grid=6).solve(contact())
        again = pickle.loads(pickle.dumps(solved))
        np.testing.assert_array_equal(again.fields.px, solved.fields.px)
        np.testing.assert_array_equal(again.fields.state, solved.fields.state)
        self.assertIs(again.status, microslip.Status.ok)

    def test_notebooks_show_tables(self):
        solved = microslip.Solver(theory="exact", grid=6).solve(contact())
        html = solved._repr_html_()
        for text in ("<table>", "Fx", f"{solved.fx:.6g}", "longitudinal force on body 1", "<td>N m</td>"):
            self.assertIn(text, html)
        self.assertNotIn("temperature", html)
        hertz, _ = wheel_on_rail()
        self.assertIn(f"{hertz.peak_pressure:.6g}", hertz._repr_html_())
        failed = microslip.Solver(theory="exact", grid=6).solve(microslip.EllipticContact(-1, 1, 1e9, 0.3, 1, 0.3))
        self.assertIn("a = -1 [m]: must be positive and finite", failed._repr_html_())


class DissimilarityTest(unittest.TestCase):
    """Aluminium on steel: K couples pressure and tractions; nothing computes it without."""

    def setUp(self):
        self.pair = unlike()
        gap = microslip.gap_curvatures(0.05, np.inf, 0.05, np.inf)
        self.hertz = microslip.hertz_from_load(gap, self.pair, 1e3)

    def made(self, xi, **options):
        return microslip.EllipticContact.from_hertz(self.hertz, self.pair, 0.3, (xi, 0, 0), **options)

    def test_all_interfaces_agree_and_differ_from_similar_bodies(self):
        text = CASE.replace("210e9", "70e9", 1).replace("0.28", "0.33", 1).replace("0.1\n", "0.05\n")
        for xi in (0.0, 3e-4, 1e-3):
            with self.subTest(xi):
                found = microslip.Solver(theory="exact", grid=12).solve(self.made(xi)).fx
                given = microslip.EllipticContact(self.hertz.a, self.hertz.b, self.pair.shear_modulus, self.pair.poisson_ratio,
                                                  1e3, 0.3, (xi, 0, 0))
                self.assertEqual(microslip.Solver(theory="exact", grid=12).solve(microslip.RollingProblem(given, bodies=self.pair)).fx, found)
                case = microslip.parse_case(text.replace("creepage_longitudinal = 0.001", f"creepage_longitudinal = {xi}")
                                            .replace("rolling_speed = 2.0", "rolling_speed = 1.0").replace("[8, 8]", "[12, 12]"))
                self.assertEqual(case.contact.dissimilarity, self.pair.dissimilarity)
                self.assertAlmostEqual(microslip.Solver(theory="exact", grid=12).solve(case.contact).fx / found, 1, places=9)
                self.assertAlmostEqual(microslip.solve_case(case).exact.solution.fx / found, 1, places=9)
                similar = microslip.Solver(theory="exact", grid=12).solve(given).fx
                self.assertGreater(abs(found - similar), 10)

    def test_batches_have_a_column(self):
        batch = microslip.Solver(theory="exact", grid=8).solve_batch(self.made(0), 3e-4, dissimilarity=[0, self.pair.dissimilarity])
        alone = microslip.Solver(theory="exact", grid=8).solve(self.made(3e-4)).fx
        self.assertEqual(batch.forces.fx[1], alone)
        self.assertNotEqual(batch.forces.fx[0], alone)

    def test_a_contact_out_of_range_names_its_field(self):
        contact = self.made(1e-3)
        contact.check()
        contact.a = -1
        with self.assertRaisesRegex(microslip.Error, r"^a = -1 \[m\]: must be positive"):
            contact.check()
        self.assertRegex(microslip.Solver(theory="exact", grid=4).solve(contact).reason, r"^a = -1 \[m\]: must be positive")

    def test_what_cannot_honour_it_refuses_it(self):
        grid = microslip.ElementGrid.across_ellipse(self.hertz.a, self.hertz.b, 8, 8, 3)
        with self.assertRaisesRegex(microslip.Error, r"dissimilarity = 0\.\d+ \[-\]: must be 0"):
            microslip.TangentialProblem(self.pair, grid)
        for solver in (microslip.Fastsim(), microslip.Fastsim2()):
            forces = solver.solve(self.made(1e-3))
            self.assertIs(forces.status, microslip.Status.invalid_input)
            self.assertTrue(np.isnan(forces.fx))
            batch = solver.solve_batch(self.made(1e-3), dissimilarity=[0, 0.1])
            self.assertEqual(batch.status.tolist(), [microslip.Status.ok, microslip.Status.invalid_input])
            self.assertTrue(np.isnan(batch.fx[1]))
            with self.assertRaisesRegex(microslip.Error, r"dissimilarity = 0\.\d+ \[-\]: must be 0 in the simplified theory"):
                self.made(1e-3).check_simplified()
            self.assertRegex(solver.fields(self.made(1e-3)).reason, r"dissimilarity = 0\.\d+ \[-\]: must be 0 in the simplified theory")

    def test_the_normal_problem_is_right_for_any(self):
        grid = microslip.ElementGrid.across_ellipse(self.hertz.a, self.hertz.b, 16, 16, 3)
        normal = microslip.NormalProblem(self.pair, grid).solve(microslip.hertzian_gap(self.hertz.gap, grid), normal_force=1e3)
        self.assertAlmostEqual(normal.approach / self.hertz.approach, 1, delta=0.01)


load_tests = load_tests_if_compiled([ValuesTest, DissimilarityTest])
