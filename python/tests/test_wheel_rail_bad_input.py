"""Bad input of a wheel on a rail from Python: numbers that are none in each field, alone and in arrays; wheels that do not touch."""

import math
import unittest
from pathlib import Path

import microslip
import numpy as np
from tests.compiled import load_tests_if_compiled

PROFILES = Path(__file__).resolve().parents[2] / "examples" / "profiles"
STATE = {"lateral": 0.001, "vertical_force": 50e3, "forward_velocity": 20.0}
NUMBERS = ("lateral", "roll", "yaw", "forward_velocity", "lateral_velocity", "vertical_velocity", "roll_velocity", "pitch_velocity",
           "yaw_velocity", "curvature", "deflection_longitudinal", "deflection_lateral", "deflection_vertical", "deflection_roll",
           "deflection_yaw", "deflection_longitudinal_velocity", "deflection_lateral_velocity", "deflection_vertical_velocity",
           "deflection_roll_velocity", "deflection_pitch_velocity", "deflection_yaw_velocity", "deviation_lateral",
           "deviation_vertical", "deviation_roll", "deviation_lateral_velocity", "deviation_vertical_velocity",
           "deviation_roll_velocity", "longitudinal", "pitch", "vertical_force")


def wheel_rail(**options):
    """S1002 on 60E1."""
    given = {"track": microslip.Track(cant=0.025), "rail": microslip.read_profile(PROFILES / "60e1.prr"),
             "wheelset": microslip.Wheelset(), "wheel": microslip.read_profile(PROFILES / "s1002.prw")}
    return microslip.WheelRail(**{**given, **options})


class WheelRailBadInputTest(unittest.TestCase):
    def test_numbers_that_are_none_are_invalid_input(self):
        for theory in ("fastsim2", "exact"):
            pair = wheel_rail(theory=theory)
            for name in NUMBERS:
                for bad in (math.nan, math.inf):
                    solution = pair.solve(**{**STATE, name: bad})
                    self.assertEqual(solution.status, microslip.Status.invalid_input, f"{name} = {bad}")
                    self.assertEqual(len(solution.patches), 0)

    def test_in_arrays_they_spoil_no_other_state(self):
        pair = wheel_rail()
        good = pair.solve(**STATE).force_y
        for name in NUMBERS:
            value = STATE.get(name, 20.0 / 0.46 if name == "pitch_velocity" else 0.0)
            many = pair.solve_batch(**{**STATE, name: np.array([value, math.nan, value])})
            self.assertEqual(many.status[1], microslip.Status.invalid_input, name)
            np.testing.assert_array_equal(many.force_y[[0, 2]], good)

    def test_bodies_are_refused_by_name(self):
        for bad in (math.nan, math.inf):
            for name in ("gauge", "gauge_height", "cant"):
                with self.assertRaisesRegex(microslip.Error, name):
                    wheel_rail(track=microslip.Track(**{name: bad}))
            for name in ("nominal_radius", "flange_back_distance", "flange_back_position", "tape_circle"):
                with self.assertRaisesRegex(microslip.Error, name):
                    wheel_rail(wheelset=microslip.Wheelset(**{name: bad}))
            with self.assertRaisesRegex(microslip.Error, "friction"):
                wheel_rail(friction=bad)

    def test_wheels_beside_the_rail_touch_nothing(self):
        pair = wheel_rail()
        for lateral in (-0.75, -0.2, 0.2):
            self.assertEqual(pair.solve(**{**STATE, "lateral": lateral}).status, microslip.Status.no_contact)

    def test_forces_that_pull_or_vanish_are_invalid(self):
        pair = wheel_rail()
        for force in (0.0, -1e3):
            self.assertEqual(pair.solve(**{**STATE, "vertical_force": force}).status, microslip.Status.invalid_input)

    def test_at_rest_and_backward(self):
        pair = wheel_rail()
        still = pair.solve(lateral=0.001, vertical_force=50e3, forward_velocity=0.0, pitch_velocity=0.0)
        self.assertAlmostEqual(still.force_x, 0.0, places=6)
        forward, backward = (pair.solve(**{**STATE, "forward_velocity": v}) for v in (20.0, -20.0))
        self.assertAlmostEqual(backward.force_x, -forward.force_x, delta=1e-3)
        self.assertAlmostEqual(backward.force_y, forward.force_y, delta=1e-3)


load_tests = load_tests_if_compiled([WheelRailBadInputTest])
