"""Hunting of a wheelset, in Python: the model of wheelset.hpp with FASTSIM2 and its Jacobian by the C interface.

    wheelset.py PATH/libmicroslip_c.so

prints the critical speed by eigenvalues, growth rates by eigenvalues and in the nonlinear run, what becomes of a
disturbance below and above the critical speed, and the time that it took.
"""

import ctypes
import sys
import time

import numpy as np
from numpy.linalg import eigvals

from radau import Radau
from sign_change import sign_change

LATERAL, YAW, LATERAL_RATE, YAW_RATE, ROTATION = range(5)


class Contact(ctypes.Structure):
    """microslip_contact"""
    _fields_ = [(name, ctypes.c_double) for name in (
        "a", "b", "shear_modulus", "poisson_ratio", "normal_force", "rolling_speed", "creepage_longitudinal",
        "creepage_lateral", "spin", "friction")] + [
        ("friction_law", ctypes.c_int), ("friction_drop", ctypes.c_double * 2),
        ("friction_half_velocity", ctypes.c_double * 2)]


class Forces(ctypes.Structure):
    """microslip_forces"""
    _fields_ = [(name, ctypes.c_double) for name in ("fx", "fy", "mz", "adhesion_area", "slip_area")] + [
        ("status", ctypes.c_int)]


class Derivatives(ctypes.Structure):
    """microslip_derivatives"""
    _fields_ = [("forces", Forces), ("jacobian", ctypes.c_double * 4 * 3)]


class Bodies(ctypes.Structure):
    """microslip_bodies"""
    _fields_ = [(name, ctypes.c_double * 2) for name in (
        "rolling_radius", "transverse_radius", "young_modulus", "poisson_ratio")]


class Hertz(ctypes.Structure):
    """microslip_hertz"""
    _fields_ = [(name, ctypes.c_double) for name in (
        "a", "b", "approach", "peak_pressure", "stiffness", "shear_modulus", "poisson_ratio", "dissimilarity")]


class ContactLaw:
    """FASTSIM2 with derivatives; Hertz besides."""

    def __init__(self, path):
        self.library = ctypes.CDLL(path)
        self.library.microslip_code_text.restype = ctypes.c_char_p
        self.library.microslip_hertz_from_load.argtypes = [
            ctypes.POINTER(Bodies), ctypes.c_double, ctypes.POINTER(Hertz), ctypes.c_void_p]
        self.library.microslip_fastsim2_differentiate.argtypes = [
            ctypes.c_void_p, ctypes.c_size_t, ctypes.POINTER(Contact), ctypes.POINTER(Derivatives)]
        self.library.microslip_fastsim2_destroy.argtypes = [ctypes.c_void_p]
        self.handle = ctypes.c_void_p()
        self.demand(self.library.microslip_fastsim2_create(None, ctypes.byref(self.handle), None))

    def __del__(self):
        self.library.microslip_fastsim2_destroy(self.handle)

    def demand(self, code):
        if code != 0:
            raise RuntimeError(self.library.microslip_code_text(code).decode())

    def hertz(self, bodies, load):
        found = Hertz()
        self.demand(self.library.microslip_hertz_from_load(bodies, load, found, None))
        return found

    def differentiate(self, contacts, found):
        self.demand(self.library.microslip_fastsim2_differentiate(self.handle, len(contacts), contacts, found))


class Wheelset:
    """Equations of motion z' = f(z) with their Jacobian, as in wheelset.hpp; SI units."""

    mass, yaw_inertia, rolling_inertia = 1200.0, 800.0, 100.0
    radius, half_gauge, conicity = 0.46, 0.75, 0.1
    lateral_stiffness, yaw_stiffness = 2e5, 1e6
    wheel_load, rail_head_radius, friction = 60e3, 0.3, 0.3
    flange_clearance, flange_stiffness = 7e-3, 1e7

    def __init__(self, law, speed):
        self.law, self.speed = law, speed
        flat = float("inf")
        hertz = law.hertz(Bodies((self.radius, flat), (flat, self.rail_head_radius), (210e9, 210e9), (0.28, 0.28)),
                          self.wheel_load)
        one = Contact(hertz.a, hertz.b, hertz.shear_modulus, hertz.poisson_ratio, self.wheel_load, speed, 0, 0, 0,
                      self.friction)
        self.contacts, self.found = (Contact * 2)(one, one), (Derivatives * 2)()
        self.jacobians = [np.ctypeslib.as_array(found.jacobian) for found in self.found]

    def creepages(self, side, z):
        """xi, eta, phi and their derivatives with respect to the state; side is 1 for the left wheel and -1 for the right one."""
        v, rolling = self.speed, self.radius + side * self.conicity * z[LATERAL]
        turning = v / self.radius + z[ROTATION]
        creepages = ((v - side * self.half_gauge * z[YAW_RATE] - turning * rolling) / v,
                     z[LATERAL_RATE] / v - z[YAW], z[YAW_RATE] / v - side * self.conicity / self.radius)
        by = np.zeros((3, 5))
        by[0, LATERAL], by[0, YAW_RATE] = -turning * side * self.conicity / v, -side * self.half_gauge / v
        by[0, ROTATION] = -rolling / v
        by[1, LATERAL_RATE], by[1, YAW], by[2, YAW_RATE] = 1 / v, -1, 1 / v
        return creepages, by, rolling

    def rates(self, z):
        """f(z)."""
        return self.differentiated(z)[0]

    def jacobian(self, z):
        return self.differentiated(z)[1]

    def differentiated(self, z):
        """f(z) and its Jacobian."""
        wheels = [self.creepages(side, z) for side in (1, -1)]
        for contact, (creepages, _, _) in zip(self.contacts, wheels):
            contact.creepage_longitudinal, contact.creepage_lateral, contact.spin = creepages
        self.law.differentiate(self.contacts, self.found)
        rate, jacobian = np.zeros(5), np.zeros((5, 5))
        rate[LATERAL], rate[YAW] = z[LATERAL_RATE], z[YAW_RATE]
        jacobian[LATERAL, LATERAL_RATE] = jacobian[YAW, YAW_RATE] = 1
        for k, side in enumerate((1, -1)):
            _, by, rolling = wheels[k]
            forces = self.found[k].forces
            lever = np.zeros((5, 3))
            lever[LATERAL_RATE, 1] = 1 / self.mass
            lever[YAW_RATE, 0], lever[YAW_RATE, 2] = -side * self.half_gauge / self.yaw_inertia, 1 / self.yaw_inertia
            lever[ROTATION, 0] = -rolling / self.rolling_inertia
            rate += lever @ (forces.fx, forces.fy, forces.mz)
            jacobian += lever @ self.jacobians[k][:, :3] @ by
            jacobian[ROTATION, LATERAL] -= side * self.conicity / self.rolling_inertia * forces.fx
        self.add_springs(z, rate, jacobian)
        return rate, jacobian

    def add_springs(self, z, rate, jacobian):
        beyond = max(0.0, abs(z[LATERAL]) - self.flange_clearance)
        flange = np.copysign(self.flange_stiffness * beyond, z[LATERAL])
        rate[LATERAL_RATE] -= (self.lateral_stiffness * z[LATERAL] + flange) / self.mass
        rate[YAW_RATE] -= self.yaw_stiffness * z[YAW] / self.yaw_inertia
        stiffness = self.lateral_stiffness + (self.flange_stiffness if beyond > 0 else 0)
        jacobian[LATERAL_RATE, LATERAL] -= stiffness / self.mass
        jacobian[YAW_RATE, YAW] -= self.yaw_stiffness / self.yaw_inertia


def growth_rate(law, speed):
    """The largest real part of the eigenvalues of f's Jacobian in the middle of the track [1/s]."""
    return eigvals(Wheelset(law, speed).jacobian(np.zeros(5))).real.max()


def critical_speed(law):
    """The speed at which the growth rate changes its sign [m/s]."""
    return sign_change(lambda speed: growth_rate(law, speed), 5, 200, 1e-6)


def run(wheelset, displacement, duration, step=1e-3):
    """States at equal steps."""
    integrator = Radau((1e-3, 1e-3, 1e-2, 1e-2, 1e-2))
    states = [np.array([displacement, 0, 0, 0, 0.0])]
    for _ in range(round(duration / step)):
        states.append(integrator.advance(states[-1], step, wheelset.rates, wheelset.jacobian))
    return np.array(states)


def peaks(lateral, step=1e-3):
    """Times and values of the extreme values, by a parabola through three points."""
    before, here, after = lateral[:-2], lateral[1:-1], lateral[2:]
    at = np.flatnonzero((here - before) * (after - here) <= 0)
    slope, curvature = (after - before)[at] / 2, (after - 2 * here + before)[at]
    shift = -slope / curvature
    return (at + 1 + shift) * step, here[at] + slope * shift / 2


def growth_of_run(lateral, start=1.0):
    """Growth rate of the peaks after `start` [s], by least squares [1/s]."""
    times, values = peaks(lateral)
    late = times >= start
    return np.polyfit(times[late], np.log(np.abs(values[late])), 1)[0]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: wheelset.py PATH/libmicroslip_c.so")
    law = ContactLaw(sys.argv[1])
    critical = critical_speed(law)
    print(f"Critical speed: {critical:.3f} m/s by eigenvalues")
    for ratio in (0.8, 1.2):
        small = run(Wheelset(law, ratio * critical), 1e-6, 3)
        print(f"{ratio:.1f} of it: growth rate {growth_rate(law, ratio * critical):.4f} 1/s by eigenvalues, "
              f"{growth_of_run(small[:, LATERAL]):.4f} 1/s in the nonlinear run")
    for ratio, displacement in ((0.9, 4e-3), (1.1, 1e-4)):
        before = time.perf_counter()
        lateral = run(Wheelset(law, ratio * critical), displacement, 10)[:, LATERAL]
        passed = (time.perf_counter() - before) / 10
        print(f"{ratio:.1f} of it, from {1e3 * displacement:.1f} mm after 10 s: {1e3 * abs(lateral[-1000:]).max():.3f} mm; "
              f"{1e3 * passed:.0f} ms per simulated second")


if __name__ == "__main__":
    main()
