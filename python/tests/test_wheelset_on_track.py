"""A wheelset on its track from Python: what it finds, derivatives, refusals."""

import pickle
import unittest

import microslip
import numpy as np
from tests.compiled import load_tests_if_compiled
from tests.railway_pair import PROFILES, s1002_on_60e1

STATE = {"lateral": 0.003, "yaw": 0.001, "forward_velocity": 30.0}


def wheelset(**options):
    """S1002 on 60E1."""
    return s1002_on_60e1(microslip.WheelsetOnTrack, **{"tolerance": 1e-9, **options})


class WheelsetOnTrackTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.pair = wheelset()

    def test_the_load_is_borne_and_the_wheelset_rolls_freely(self):
        solution = self.pair.solve(**STATE, vertical_force=120e3)
        self.assertEqual(solution.status, microslip.Status.ok)
        self.assertAlmostEqual(solution.force_z, 120e3, delta=1e-3)
        self.assertAlmostEqual(solution.left.force_z + solution.right.force_z, solution.force_z, delta=1e-6)
        self.assertAlmostEqual(solution.moment_x, 0, delta=1e-3)
        self.assertAlmostEqual(solution.moment_y * np.cos(STATE["yaw"]), 0, delta=50)
        self.assertAlmostEqual(solution.pitch_velocity, 30 / 0.46, delta=0.01 * 30 / 0.46)
        driven = self.pair.solve(**STATE, vertical_force=120e3, axle_torque=2e3)
        self.assertGreater(driven.pitch_velocity, solution.pitch_velocity)
        self.assertAlmostEqual(driven.force_x, 2e3 / 0.46, delta=0.02 * 2e3 / 0.46)

    def test_what_is_found_can_be_given(self):
        found = self.pair.solve(**STATE, vertical_force_left=70e3, vertical_force_right=50e3)
        self.assertAlmostEqual(found.left.force_z, 70e3, delta=1e-3)
        given = self.pair.solve(**STATE, vertical=found.vertical, roll=found.roll, pitch_velocity=found.pitch_velocity)
        self.assertEqual(given.force_y, found.force_y)
        self.assertEqual(given.right.force_z, found.right.force_z)

    def test_each_wheel_is_that_of_wheel_rail(self):
        found = self.pair.solve(**STATE, vertical_force=120e3)
        right = microslip.WheelRail(track=microslip.Track(gauge=1.435, cant=0.05),
                                    rail=microslip.read_profile(PROFILES / "60e1.prr"),
                                    wheelset=microslip.Wheelset(nominal_radius=0.46, flange_back_distance=1.36),
                                    wheel=microslip.read_profile(PROFILES / "s1002.prw"), side="right")
        alone = right.solve(**STATE, vertical=found.vertical, roll=found.roll, pitch_velocity=found.pitch_velocity)
        self.assertEqual(alone.force_y, found.right.force_y)

    def test_layers_are_those_of_both_wheels(self):
        layer = microslip.BodyLayer(1e-4, microslip.Material.from_young(2e9, 0.4))
        options = {"theory": "exact", "shape": "flat", "grid": 8}
        plain, coated = (s1002_on_60e1(microslip.WheelsetOnTrack, **options, **layers).solve(forward_velocity=20.0, vertical_force=160e3)
                         for layers in ({}, {"wheel_layers": [layer]}))
        self.assertEqual(coated.status, microslip.Status.ok)
        for side in ("left", "right"):
            self.assertLess(getattr(coated, side).patches[0].peak_pressure, getattr(plain, side).patches[0].peak_pressure)

    def test_profiles_of_both_sides_change_places_in_a_mirror(self):
        new = microslip.read_profile(PROFILES / "60e1.prr")
        other = microslip.Profile(new.y, new.z - 0.2 * new.y**2, "rail")  # with a rounder head
        left, right = wheelset(rail=other, right_rail=new), wheelset(right_rail=other)
        a = left.solve(lateral=0.002, yaw=0.001, forward_velocity=30.0, vertical_force=120e3)
        b = right.solve(lateral=-0.002, yaw=-0.001, forward_velocity=30.0, vertical_force=120e3)
        alike = self.pair.solve(lateral=0.002, yaw=0.001, forward_velocity=30.0, vertical_force=120e3)
        self.assertAlmostEqual(a.force_y, -b.force_y, delta=1e-6 * abs(a.force_y))
        self.assertAlmostEqual(a.roll, -b.roll, delta=1e-9)
        self.assertGreater(abs(a.force_y - alike.force_y), 2e-3 * abs(a.force_y))

    def test_wear_and_fields_are_those_of_the_wheels(self):
        turned = {**STATE, "yaw": 0.004, "vertical_force": 120e3}
        found = wheelset(strength=microslip.SurfaceStrength(hardness=2.7e9), fields=True).solve(**turned)
        plain = self.pair.solve(**turned)
        for wheel, without in ((found.left, plain.left), (found.right, plain.right)):
            self.assertAlmostEqual(wheel.worn_area, sum(patch.worn_area for patch in wheel.patches), delta=1e-20)
            self.assertGreater(wheel.worn_area, 0)
            self.assertEqual(len(wheel.fields), len(wheel.patches))
            self.assertIsNone(without.worn_area)
            self.assertEqual(without.fields, [])
            self.assertEqual(wheel.force_y, without.force_y)

    def test_derivatives_have_names(self):
        result = self.pair.differentiate(**STATE, vertical_force=120e3)
        self.assertEqual(result.jacobian.shape, (len(result.results), len(result.variables)))
        self.assertEqual(result.solution, self.pair.differentiate(**STATE, vertical_force=120e3).solution)
        for by, step in (("lateral", 1e-7), ("yaw", 1e-7), ("vertical_force", 10.0), ("axle_torque", 10.0)):
            state = {"axle_torque": 0.0, "vertical_force": 120e3, **STATE}
            low, high = (self.pair.solve(**{**state, by: state[by] + side * step}) for side in (-1, 1))
            for of in ("force_y", "moment_z", "roll", "pitch_velocity"):
                difference = (getattr(high, of) - getattr(low, of)) / (2 * step)
                self.assertAlmostEqual(result.derivative(of, by), difference, delta=2e-3 * abs(difference) + 1e-4 * abs(
                    result.jacobian[:, result.variables.index(by)]).max() * (1 if of in ("force_y", "moment_z") else 0) + 1e-12)
        self.assertEqual(result.derivative("force_y", "vertical"), 0)

    def test_what_concerns_one_wheel_has_a_side(self):
        level = self.pair.solve(**STATE, vertical_force=120e3)
        raised = self.pair.solve(**STATE, vertical_force=120e3, right_deviation_vertical=1.5e-3)
        self.assertAlmostEqual(raised.roll - level.roll, -1e-3, delta=3e-5)

    def test_solutions_are_values_and_show_themselves(self):
        solution = self.pair.solve(**STATE, vertical_force=120e3)
        self.assertEqual(pickle.loads(pickle.dumps(solution)), solution)
        self.assertIn("roll=", repr(solution))
        self.assertIn("left: force_y", solution._repr_html_())

    def test_what_makes_no_sense_is_refused(self):
        for text, given in (("did you mean lateral", {"latteral": 0.0, "vertical_force": 1e5}),
                            ("either of them must be given", {"forward_velocity": 20.0}),
                            ("forward_velocity: must be given", {"vertical_force": 1e5}),
                            ("is found from the load", {"roll": 0.0, "vertical_force": 1e5}),
                            ("only either of them", {"pitch_velocity": 60.0, "axle_torque": 0.0, "vertical_force": 1e5}),
                            ("only both of them", {"vertical_force_left": 1e5}),
                            ("needs vertical_force", {"roll_moment": 1e5, "vertical": 0.0}),
                            ("must be a number", {"lateral": [0.0, 1.0], "vertical_force": 1e5})):
            with self.assertRaisesRegex(microslip.Error, text):
                self.pair.solve(**given)
        with self.assertRaisesRegex(microslip.Error, "rail"):
            wheelset(rail=microslip.read_profile(PROFILES / "s1002.prw"))
        self.assertEqual(self.pair.solve(lateral=0.3, forward_velocity=20.0, vertical_force=1e5).status, microslip.Status.no_contact)
        self.assertEqual(self.pair.solve(lateral=float("nan"), forward_velocity=20.0, vertical_force=1e5).status, microslip.Status.invalid_input)
        self.assertEqual(self.pair.solve(**STATE, vertical_force=1e5, axle_torque=1e5).status, microslip.Status.no_solution)


load_tests = load_tests_if_compiled([WheelsetOnTrackTest])
