"""A wheel on a rail from Python: numbers and arrays, both sides, both theories, refusals."""

import copy
import pickle
import unittest

import microslip
import numpy as np
from tests.compiled import load_tests_if_compiled
from tests.railway_pair import PROFILES, s1002_on_60e1

STATE = {"lateral": 0.0061, "yaw": 0.002, "vertical_force": 80e3, "forward_velocity": 30.0}


def wheel_rail(**options):
    """S1002 on 60E1."""
    return s1002_on_60e1(microslip.WheelRail, **options)


class WheelRailTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pair = wheel_rail()

    def test_a_solution_has_forces_and_patches(self):
        solution = self.pair.solve(**STATE)
        self.assertEqual(solution.status, microslip.Status.ok)
        self.assertAlmostEqual(solution.force_z, 80e3, delta=1)
        self.assertEqual(len(solution.patches), solution.patch_count)
        self.assertGreaterEqual(len(solution.patches), 2)
        angles = [patch.angle for patch in solution.patches]
        self.assertEqual(angles, sorted(angles, reverse=True))
        # What the patches bear adds up to what the wheel bears.
        force_z = sum(p.normal_force * np.cos(p.angle) + p.fy * np.sin(p.angle) for p in solution.patches)
        self.assertAlmostEqual(force_z, solution.force_z, delta=1)
        self.assertAlmostEqual(sum(p.fx for p in solution.patches), solution.force_x, delta=1)
        self.assertAlmostEqual(sum(p.t_gamma for p in solution.patches), solution.t_gamma, delta=1e-9 * solution.t_gamma)

    def test_right_is_the_mirror_image_of_left(self):
        left = self.pair.solve(**STATE)
        right = wheel_rail(side="right").solve(**{**STATE, "lateral": -STATE["lateral"], "yaw": -STATE["yaw"]})
        self.assertEqual(left.force_x, right.force_x)
        self.assertEqual(left.force_y, -right.force_y)
        self.assertEqual([p.angle for p in left.patches], [-p.angle for p in right.patches])

    def test_batches_are_what_single_calls_are(self):
        lateral, yaw = np.linspace(-4e-3, 6e-3, 6), np.array([[0.0], [2e-3]])
        many = self.pair.solve_batch(lateral=lateral, yaw=yaw, vertical_force=80e3, forward_velocity=30.0)
        self.assertEqual(many.force_y.shape, (2, 6))
        self.assertEqual(len(many), 12)
        one = self.pair.solve(lateral=lateral[4], yaw=2e-3, vertical_force=80e3, forward_velocity=30.0)
        self.assertEqual(many.force_y[1, 4], one.force_y)
        self.assertEqual(many.status[1, 4], one.status)
        count = int(many.patch_count[1, 4])
        self.assertEqual(count, len(one.patches))
        np.testing.assert_array_equal(many.patch_fx[1, 4, :count], [p.fx for p in one.patches])
        self.assertTrue(np.isnan(many.patch_fx[1, 4, count:]).all())
        again = self.pair.solve_batch(lateral=lateral, yaw=yaw, vertical_force=80e3, forward_velocity=30.0, threads=1)
        np.testing.assert_array_equal(many.force_x, again.force_x)

    def test_fields_of_the_exact_theory_add_up(self):
        for side, sign in (("left", 1), ("right", -1)):
            exact = wheel_rail(theory="exact", grid=16, shape="flat", side=side)
            solution = exact.solve(**{**STATE, "lateral": sign * STATE["lateral"], "yaw": sign * STATE["yaw"]})
            self.assertEqual(len(solution.fields), len(solution.patches))
            for patch, fields in zip(solution.patches, solution.fields):
                self.assertAlmostEqual((fields.fields.area * fields.fields.py).sum(), patch.fy, delta=1e-6 * patch.normal_force)
                self.assertTrue((np.diff(fields.fields.y[:, 0]) > 0).all())

    def test_fields_of_fastsim2_are_there_where_they_are_asked_for(self):
        self.assertEqual(self.pair.solve(**STATE).fields, [])
        solution = wheel_rail(fields=True).solve(**STATE)
        self.assertEqual(solution.force_y, self.pair.solve(**STATE).force_y)
        steel = microslip.Material.from_young(210e9, 0.28)
        for patch, fields in zip(solution.patches, solution.fields):
            # Rows of equal width in one plane, in place of rows that lean by the turn of the surface.
            self.assertAlmostEqual((fields.fields.area * fields.fields.pressure).sum() / patch.normal_force, 1,
                                   delta=2e-3 + 1 - np.cos(patch.turn))
            self.assertAlmostEqual((fields.fields.area * microslip.friction_work(fields)).sum() * patch.rolling_speed
                                   / patch.frictional_power, 1, delta=0.03)
            stress = fields.interior_states(steel, steel, 0.0, 0.0, [-0.1, 0.1])
            self.assertTrue((np.asarray(stress.zz) < 0).all())

    def test_damage_needs_the_strength(self):
        weak = self.pair.solve(**STATE)
        self.assertEqual([weak.worn_area, weak.patches[0].wear_depth, weak.patches[0].fatigue_index], [None] * 3)
        strength = microslip.SurfaceStrength(hardness=3e9, shear_yield_strength=300e6)
        pair = wheel_rail(strength=strength, fields=True)
        solution = pair.solve(**STATE)
        self.assertAlmostEqual(solution.worn_area, sum(p.worn_area for p in solution.patches), delta=1e-15 * solution.worn_area)
        for patch, fields in zip(solution.patches, solution.fields):
            depth = microslip.wear_depth(fields, hardness=3e9, rolling_speed=patch.rolling_speed)
            self.assertAlmostEqual(depth.sum(axis=1).max(), patch.wear_depth, delta=1e-12 * patch.wear_depth)
            self.assertAlmostEqual(patch.fatigue_index, microslip.surface_fatigue_index(
                patch.traction_coefficient, patch.peak_pressure, 300e6), places=12)
            self.assertEqual(patch.shakedown_limit, microslip.point_shakedown_limit(patch.traction_coefficient))
            self.assertEqual(microslip.shear_excess(fields, 300e6).shape, depth.shape)
            self.assertAlmostEqual(patch.nadal_limit, microslip.nadal_limit(abs(patch.angle), patch.friction), places=12)
        many = pair.solve_batch(**{**STATE, "lateral": [0.0, STATE["lateral"]]})
        self.assertEqual(many.worn_area[1], solution.worn_area)
        self.assertEqual(pickle.loads(pickle.dumps(solution)), solution)
        self.assertEqual(pickle.loads(pickle.dumps(strength)), strength)

    def test_derivatives_are_those_of_the_forces(self):
        for options in ({"side": "left"}, {"side": "right"}):
            pair = wheel_rail(tolerance=1e-11, **options)
            state = {**STATE, "lateral": 0.002}
            found = pair.differentiate(**state)
            self.assertEqual(found.solution, pair.solve(**state))
            self.assertEqual(found.jacobian.shape, (len(found.results), len(found.variables)))
            for name, step in (("lateral", 1e-8), ("yaw", 2e-7), ("pitch_velocity", 4e-5), ("deviation_vertical", 1e-8),
                               ("deflection_roll", 1e-8), ("vertical_force", 1.0)):
                at = state.get(name, 30.0 / 0.46 if name == "pitch_velocity" else 0.0)
                high, low = (pair.solve(**{**state, name: at + sign * step}) for sign in (1, -1))
                for result in found.results:
                    wanted = (getattr(high, result) - getattr(low, result)) / (2 * step)
                    row = 1 + np.abs(found.jacobian[found.results.index(result)]).max()
                    # What the height leaves of the prescribed force, over the step.
                    left = 1e-11 * state["vertical_force"] / step if result == "force_z" else 0
                    self.assertAlmostEqual(found.derivative(result, name), wanted, delta=1e-4 * abs(wanted) + 1e-5 * row + left)
                    column = found.jacobian[:, found.variables.index(name)]
                    self.assertEqual(found.derivative(result, name), column[found.results.index(result)])
            self.assertEqual(found.derivative("force_y", "vertical"), 0)
        with self.assertRaisesRegex(microslip.Error, "did you mean lateral"):
            found.derivative("force_y", "latteral")
        with self.assertRaisesRegex(microslip.Error, "did you mean force_y"):
            found.derivative("forcey", "lateral")
        self.assertEqual(pickle.loads(pickle.dumps(found)).jacobian.tolist(), found.jacobian.tolist())

    def test_derivatives_come_in_batches(self):
        lateral, yaw = np.linspace(-4e-3, 4e-3, 3), np.array([[0.0], [2e-3]])
        many = self.pair.differentiate_batch(lateral=lateral, yaw=yaw, vertical=[-2.5e-4, -2.5e-4, 0.05], forward_velocity=30.0)
        self.assertEqual(many.jacobian.shape, (2, 3, 7, 31))
        self.assertEqual(many.solution.force_y.shape, (2, 3))
        one = self.pair.differentiate(lateral=lateral[1], yaw=2e-3, vertical=-2.5e-4, forward_velocity=30.0)
        np.testing.assert_array_equal(many.jacobian[1, 1], one.jacobian)
        np.testing.assert_array_equal(many.derivative("moment_y", "yaw"), many.jacobian[..., 4, one.variables.index("yaw")])
        self.assertTrue((many.jacobian[:, 2] == 0).all())
        self.assertTrue((many.solution.status[:, 2] == microslip.Status.no_contact).all())

    def test_pitch_velocity_is_that_of_pure_rolling_by_default(self):
        given = self.pair.solve(**STATE, pitch_velocity=30.0 / 0.46)
        self.assertEqual(given.force_x, self.pair.solve(**STATE).force_x)
        braked = self.pair.solve(**STATE, pitch_velocity=29.7 / 0.46)
        self.assertGreater(braked.patches[0].creepage_longitudinal, given.patches[0].creepage_longitudinal)

    def test_heights_are_given_or_found(self):
        found = self.pair.solve(**STATE)
        given = self.pair.solve(**{key: value for key, value in STATE.items() if key != "vertical_force"}, vertical=found.vertical)
        self.assertAlmostEqual(given.force_z, found.force_z, delta=1e-3 * found.force_z)
        above = self.pair.solve(vertical=0.05, forward_velocity=30.0)
        self.assertEqual(above.status, microslip.Status.no_contact)
        self.assertEqual(above.patches, [])

    def test_friction_may_depend_on_the_inclination(self):
        plain = self.pair.solve(**STATE)
        self.assertEqual(wheel_rail(friction=([-1.0, 1.0], [0.3, 0.3])).solve(**STATE).force_x, plain.force_x)
        self.assertEqual(wheel_rail(friction=microslip.FrictionLaw.coulomb(0.3)).solve(**STATE).force_x, plain.force_x)
        with self.assertRaisesRegex(microslip.Error, "friction: must be a coefficient or Coulomb's law here"):
            wheel_rail(friction=microslip.FrictionLaw.linear(0.2, (0.1, 1.0)))
        greased = wheel_rail(friction=([0.2, 0.4], [0.3, 0.05])).solve(**STATE)
        self.assertNotEqual(greased.force_x, plain.force_x)

    def test_solutions_are_values_and_show_themselves(self):
        solution = self.pair.solve(**STATE)
        self.assertEqual(pickle.loads(pickle.dumps(solution)), solution)
        self.assertEqual(copy.copy(solution), solution)
        self.assertIn("force_y=", repr(solution))
        self.assertIn("t_gamma", solution._repr_html_())
        self.assertIn("patch 2", solution._repr_html_())
        self.assertEqual(microslip.Track(gauge=1.5), microslip.Track(gauge=1.5))
        self.assertIn("angle=", repr(solution.patches[0]))

    def test_the_level_table_has_the_shipped_table_or_another_one(self):
        own = wheel_rail(theory="table")
        given = wheel_rail(theory="table", table=microslip.CreepForceTable(poisson_ratio=0.28))
        found = own.solve(**STATE)
        self.assertEqual(found.status, microslip.Status.ok)
        self.assertEqual(given.solve(**STATE).force_y, found.force_y)
        self.assertNotEqual(self.pair.solve(**STATE).force_y, found.force_y)
        self.assertAlmostEqual(found.force_z, STATE["vertical_force"], delta=1e-5 * STATE["vertical_force"])
        self.assertEqual(wheel_rail(theory="table").solve_batch(**STATE).force_y, found.force_y)
        with self.assertRaisesRegex(microslip.Error, "table: needs theory=\"table\""):
            wheel_rail(table=microslip.CreepForceTable(poisson_ratio=0.28))

    def test_wheel_and_rail_may_have_layers(self):
        layer = microslip.BodyLayer(1e-4, microslip.Material.from_young(2e9, 0.4))
        options = {"theory": "exact", "shape": "flat", "grid": 8}
        plain = wheel_rail(**options).solve(**STATE)
        for body in ("wheel", "rail"):
            layered = wheel_rail(**options, **{f"{body}_layers": [layer]}).solve(**STATE)
            self.assertEqual(layered.status, microslip.Status.ok)
            self.assertLess(layered.vertical, plain.vertical - 1e-6)  # it sinks in further
            both = wheel_rail(**options, wheel_layers=[layer], rail_layers=[layer]).solve(**STATE)
            self.assertLess(both.vertical, layered.vertical)
        steel = microslip.BodyLayer(1e-4, microslip.Material.from_young(210e9, 0.28))
        same = wheel_rail(**options, rail_layers=[steel]).solve(**STATE)
        self.assertAlmostEqual(same.vertical, plain.vertical, delta=1e-3 * abs(plain.vertical))
        soft = microslip.BodyLayer(1e-4, microslip.ViscoelasticMaterial(layer.material.instantaneous, [microslip.PronyTerm(0.5, 1e-3)]))
        for text, wrong in (("theory exact", {"rail_layers": [layer]}),
                            ("curved or flat", {"rail_layers": [layer], "theory": "exact"}),
                            ("must be elastic", {"wheel_layers": [soft], **options}),
                            (r"rail.layers\[0\].thickness", {"rail_layers": [microslip.BodyLayer(-1.0, steel.material)], **options})):
            with self.assertRaisesRegex(microslip.Error, text):
                wheel_rail(**wrong)

    def test_what_makes_no_sense_is_refused(self):
        for text, call in (("did you mean lateral", lambda: self.pair.solve(latteral=0.0, vertical_force=1e3)),
                           ("either of them", lambda: self.pair.solve(lateral=0.0)),
                           ("forward_velocity: must be given", lambda: self.pair.solve(vertical_force=1e3)),
                           ("either of them", lambda: self.pair.solve(vertical=0.0, vertical_force=1e3)),
                           ("solve_batch takes arrays", lambda: self.pair.solve(lateral=[0.0, 1.0], forward_velocity=20.0, vertical_force=1e3)),
                           ("gauge", lambda: wheel_rail(track=microslip.Track(gauge=-1.0))),
                           ("must be left or right", lambda: wheel_rail(side="lefft")),
                           ("must be fastsim2, exact or table", lambda: wheel_rail(theory="fastsim")),
                           ("friction", lambda: wheel_rail(friction=-0.1)),
                           ("rail", lambda: wheel_rail(rail=microslip.read_profile(PROFILES / "s1002.prw")))):
            with self.assertRaisesRegex(microslip.Error, text):
                call()
        self.assertEqual(self.pair.solve(**{**STATE, "lateral": float("nan")}).status, microslip.Status.invalid_input)


load_tests = load_tests_if_compiled([WheelRailTest])
