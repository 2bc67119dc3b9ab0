"""A wheelset with S1002 profiles on 60E1 rails, in Python: the model of profiled_wheelset.hpp with microslip.WheelsetOnTrack.

    profiled_wheelset.py PROFILES     PROFILES: the folder of s1002.prw and 60e1.prr

prints the critical speed by eigenvalues, what becomes of a disturbance below and above it, and the time that it took.
"""

import sys
import time
from pathlib import Path

import microslip
import numpy as np
from numpy.linalg import eigvals

from radau import Radau
from sign_change import sign_change

LATERAL, HEIGHT, ROLL, YAW, LATERAL_RATE, HEIGHT_RATE, ROLL_RATE, YAW_RATE, ROTATION = range(9)
NAMES = ("lateral", "vertical", "roll", "yaw", "lateral_velocity", "vertical_velocity", "roll_velocity", "yaw_velocity",
         "pitch_velocity")
SCALE = (1e-3, 1e-5, 1e-5, 1e-3, 1e-2, 1e-3, 1e-3, 1e-2, 1e-2)


def contact_on(profiles):
    """Both contacts of S1002 on 60E1 with 1:40 and a gauge of 1435 mm."""
    return microslip.WheelsetOnTrack(
        track=microslip.Track(gauge=1.435, cant=1 / 40), rail=microslip.read_profile(Path(profiles) / "60e1.prr"),
        wheelset=microslip.Wheelset(nominal_radius=0.46), wheel=microslip.read_profile(Path(profiles) / "s1002.prw"))


class ProfiledWheelset:
    """Equations of motion z' = f(z) with their Jacobian, as in profiled_wheelset.hpp on straight track; SI units."""

    mass, roll_inertia, rolling_inertia = 1200.0, 800.0, 100.0
    lateral_stiffness, yaw_stiffness = 5e5, 2e6
    axle_load = 120e3

    def __init__(self, contact, speed):
        self.contact, self.speed, self.contact_time = contact, speed, 0.0

    def numbers(self, z):
        return {"forward_velocity": self.speed, **{name: float(value) for name, value in zip(NAMES, z)}}

    def timed(self, call, **given):
        begin = time.perf_counter()
        found = call(**given)
        self.contact_time += time.perf_counter() - begin
        return found

    def standing(self, displacement):
        """Height and roll in equilibrium, rolling freely."""
        found = self.timed(self.contact.solve, lateral=displacement, forward_velocity=self.speed, vertical_force=self.axle_load)
        return np.array([displacement, found.vertical, found.roll, 0, 0, 0, 0, 0, found.pitch_velocity])

    def inertia(self):
        return np.array([self.mass, self.mass, self.roll_inertia, self.roll_inertia, self.rolling_inertia])

    def axle(self, z):
        """Along the axle, in track axes."""
        return np.array([-np.sin(z[YAW]), np.cos(z[YAW]) * np.cos(z[ROLL]), np.cos(z[YAW]) * np.sin(z[ROLL])])

    def rates(self, z):
        found = self.timed(self.contact.solve, **self.numbers(z))
        moment = np.array([found.moment_x, found.moment_y, found.moment_z])
        spin = self.rolling_inertia * z[ROTATION]
        forces = np.array([found.force_y - self.lateral_stiffness * z[LATERAL], found.force_z - self.axle_load,
                           moment[0] + spin * z[YAW_RATE], moment[2] - spin * z[ROLL_RATE] - self.yaw_stiffness * z[YAW],
                           self.axle(z) @ moment])
        return np.concatenate([z[LATERAL_RATE:ROTATION], forces / self.inertia()])

    def jacobian(self, z):
        result = self.timed(self.contact.differentiate, **self.numbers(z))
        by = result.jacobian[:, [result.variables.index(name) for name in NAMES]]
        forces = np.array([by[1], by[2], by[3], by[5], self.axle(z) @ by[3:6]])
        spin = self.rolling_inertia * z[ROTATION]
        forces[0, LATERAL] -= self.lateral_stiffness
        forces[2, YAW_RATE] += spin
        forces[2, ROTATION] += self.rolling_inertia * z[YAW_RATE]
        forces[3, ROLL_RATE] -= spin
        forces[3, ROTATION] -= self.rolling_inertia * z[ROLL_RATE]
        forces[3, YAW] -= self.yaw_stiffness
        return np.vstack([np.eye(9)[LATERAL_RATE:ROTATION], forces / self.inertia()[:, None]])


def growth_rate(contact, speed):
    """The largest real part of the eigenvalues below 50 Hz in the middle of the track [1/s]."""
    wheelset = ProfiledWheelset(contact, speed)
    values = eigvals(wheelset.jacobian(wheelset.standing(0.0)))
    return values[np.abs(values.imag) < 100 * np.pi].real.max()


def critical_speed(contact):
    """The speed at which the growth rate changes its sign [m/s]."""
    return sign_change(lambda speed: growth_rate(contact, speed), 20, 120, 1e-3)


def run(wheelset, displacement, duration, step=1e-3):
    """States at equal steps, and the integrator."""
    integrator = Radau(SCALE, 1e-6)
    states = [wheelset.standing(displacement)]
    for _ in range(round(duration / step)):
        states.append(integrator.advance(states[-1], step, wheelset.rates, wheelset.jacobian))
    return np.array(states), integrator


def main():
    contact = contact_on(sys.argv[1])
    print(f"Critical speed: {critical_speed(contact):.3f} m/s by eigenvalues")
    for speed, displacement, duration in ((55.0, 5e-3, 4), (66.0, 1e-3, 4)):
        wheelset, before = ProfiledWheelset(contact, speed), time.perf_counter()
        states, integrator = run(wheelset, displacement, duration)
        passed = time.perf_counter() - before
        print(f"From {1e3 * displacement:.0f} mm at {speed:.0f} m/s after {duration} s: "
              f"{1e3 * np.abs(states[-1000:, LATERAL]).max():.3f} mm; {passed / duration:.2f} s per simulated second, "
              f"{wheelset.contact_time / passed:.1%} of it the contacts; {integrator.halvings} steps halved, "
              f"{integrator.jumps} on jumps of the forces")


if __name__ == "__main__":
    main()
