"""A wheel of Exudyn by microslip: a user function of a RigidBodySpringDamper between the track and a wheelset.

Not run in Exudyn, which could not be had here: python/tests call it with the arguments that Exudyn's manual names.

    wheel = Wheel("examples/profiles/60e1.prr", "examples/profiles/s1002.prw", side="left")
    mbs.AddObject(RigidBodySpringDamper(markerNumbers=[track, wheelset], stiffness=np.zeros((6, 6)), damping=np.zeros((6, 6)),
                                        springForceTorqueUserFunction=wheel.user_function))

The marker `track` is midway between the rails at their tops, x along the track, y to the left, z up; `wheelset` in the
middle of the axle, y along it to the left. Left and right wheel have a connector each.
"""

import microslip
import numpy as np


def rotation(angles):
    """Rx(a0) Ry(a1) Rz(a2): axes of the second marker in those of the first."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(angles), np.sin(angles)
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return about_x @ about_y @ about_z


class Wheel:
    """A wheel on a rail; what else it takes goes to microslip.WheelRail."""

    def __init__(self, rail, wheel, side, track=None, wheelset=None, **options):
        track, wheelset = track or microslip.Track(gauge=1.435), wheelset or microslip.Wheelset(nominal_radius=0.46, flange_back_distance=1.36)
        self.contact = microslip.WheelRail(track=track, rail=microslip.read_profile(rail), wheelset=wheelset,
                                           wheel=microslip.read_profile(wheel), side=side, **{"friction": 0.3, **options})
        self.radius = wheelset.nominal_radius
        self.half_base = (wheelset.flange_back_distance / 2 - wheelset.flange_back_position) * (-1 if side == "right" else 1)
        self.status = None

    def load(self, position, axle, velocity, angular_velocity):
        """Force and moment on the wheelset about its centre, in track axes; a function of these numbers alone."""
        roll, yaw = np.arctan2(axle[2], axle[1]), np.arcsin(np.clip(-axle[0], -1, 1))
        ahead = np.array([np.cos(yaw), np.cos(roll) * np.sin(yaw), np.sin(roll) * np.sin(yaw)])
        up = np.array([0, -np.sin(roll), np.cos(roll)])
        found = self.contact.solve(
            longitudinal=position[0], lateral=position[1], vertical=position[2] - self.radius, roll=roll, yaw=yaw,
            forward_velocity=velocity[0], lateral_velocity=velocity[1], vertical_velocity=velocity[2],
            roll_velocity=ahead @ angular_velocity, pitch_velocity=axle @ angular_velocity, yaw_velocity=up @ angular_velocity)
        self.status = found.status
        if found.status == microslip.Status.invalid_input:  # far off the track: no load, and the status says so
            return np.zeros(6)
        force = np.array([found.force_x, found.force_y, found.force_z])
        moment = np.array([found.moment_x, found.moment_y, found.moment_z])
        return np.concatenate([force, moment + np.cross(self.half_base * axle, force)])

    def user_function(self, mbs, t, item, displacement, rotation_angles, velocity, angular_velocity, *unused):
        """springForceTorqueUserFunction: relative numbers of the second marker, in the axes of the first. A connector's
        force pulls the second marker back, so it is the opposite of the load."""
        axle = rotation(np.asarray(rotation_angles, float))[:, 1]
        load = self.load(np.asarray(displacement, float), axle, np.asarray(velocity, float), np.asarray(angular_velocity, float))
        return list(-load)
