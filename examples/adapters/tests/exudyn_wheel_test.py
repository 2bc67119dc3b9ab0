"""The adapter for Exudyn as its manual calls a springForceTorqueUserFunction: the load of the library on a wheelset that is
turned and rolled, in any order of calls."""

import pathlib
import random
import sys
import unittest

import microslip
import numpy as np

FOLDER = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(FOLDER))

import exudyn_wheel  # noqa: E402

PROFILES = FOLDER.parent / "profiles"
RADIUS, HALF_BASE = 0.46, 1.36 / 2 + 0.07


def running(k):
    """A state of a wheelset with its height given."""
    return {"longitudinal": 2.0 * k, "lateral": 1.3e-3 * (k % 9 - 4), "vertical": -1.5e-4 - 2e-5 * (k % 5), "roll": 1e-4 * (k % 3),
            "yaw": 1e-3 * (k % 4), "forward_velocity": 20.0, "lateral_velocity": 0.01 * (k % 5), "vertical_velocity": 0.02,
            "roll_velocity": 0.01, "pitch_velocity": 20 / RADIUS * (1 + 1e-3 * (k % 3)), "yaw_velocity": 0.02 * (k % 2)}


def axes_of(state):
    """Axes of the wheelset: of the track turned by yaw, then by roll."""
    (cy, sy), (cr, sr) = [(np.cos(a), np.sin(a)) for a in (state["yaw"], state["roll"])]
    return np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]]) @ np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])


def tait_bryan(matrix):
    """Angles of Rx Ry Rz."""
    return [np.arctan2(-matrix[1, 2], matrix[2, 2]), np.arcsin(matrix[0, 2]), np.arctan2(-matrix[0, 1], matrix[0, 0])]


def call(wheel, state, rolled=0.4):
    """As Exudyn calls: mbs, t, item, relative displacement, rotation, velocity, angular velocity, and the connector's data."""
    axes = axes_of(state)
    rolling = np.array([[np.cos(rolled), 0, np.sin(rolled)], [0, 1, 0], [-np.sin(rolled), 0, np.cos(rolled)]])
    position = [state["longitudinal"], state["lateral"], RADIUS + state["vertical"]]
    velocity = [state[name] for name in ("forward_velocity", "lateral_velocity", "vertical_velocity")]
    omega = axes @ [state[name] for name in ("roll_velocity", "pitch_velocity", "yaw_velocity")]
    zeros, unit = np.zeros((6, 6)), np.eye(3)
    return wheel.user_function(None, 0.0, 7, position, tait_bryan(axes @ rolling), velocity, omega, zeros, zeros, unit, unit,
                               np.zeros(6))


class ExudynWheelTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.wheels = {side: exudyn_wheel.Wheel(PROFILES / "60e1.prr", PROFILES / "s1002.prw", side) for side in ("left", "right")}

    def test_the_connector_bears_the_librarys_load(self):
        for side, wheel in self.wheels.items():
            contact = microslip.WheelRail(track=microslip.Track(gauge=1.435), rail=microslip.read_profile(PROFILES / "60e1.prr"),
                                          wheelset=microslip.Wheelset(nominal_radius=RADIUS, flange_back_distance=1.36),
                                          wheel=microslip.read_profile(PROFILES / "s1002.prw"), side=side, friction=0.3)
            largest = 0
            for k in range(9):
                found = contact.solve(**running(k))
                force = np.array([found.force_x, found.force_y, found.force_z])
                axle = axes_of(running(k))[:, 1] * (HALF_BASE if side == "left" else -HALF_BASE)
                moment = np.array([found.moment_x, found.moment_y, found.moment_z]) + np.cross(axle, force)
                np.testing.assert_allclose(call(wheel, running(k)), -np.concatenate([force, moment]), atol=1e-6 * (1 + force[2]))
                largest = max(largest, force[2])
            self.assertGreater(largest, 10e3)

    def test_the_order_of_calls_changes_no_digit(self):
        first = {(side, k): call(self.wheels[side], running(k)) for side in self.wheels for k in range(9)}
        order = 3 * list(first)
        random.Random(5).shuffle(order)
        for side, k in order:
            self.assertEqual(call(self.wheels[side], running(k)), first[side, k])

    def test_every_state_has_an_answer(self):
        wheel = self.wheels["left"]
        self.assertEqual(call(wheel, {**running(1), "vertical": 0.01}), [0.0] * 6)
        self.assertEqual(wheel.status, microslip.Status.no_contact)
        for lateral in (0.02, 0.2, -0.9):
            self.assertTrue(np.isfinite(call(wheel, {**running(1), "lateral": lateral, "vertical": -1e-3})).all())
        self.assertEqual(call(wheel, {**running(1), "lateral": 3.0}), [0.0] * 6)
        self.assertEqual(wheel.status, microslip.Status.invalid_input)


if __name__ == "__main__":
    unittest.main()
