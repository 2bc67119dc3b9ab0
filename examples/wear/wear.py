"""Wear of a wheel: where it runs, what Archard's law takes off there, smoothing, the profile that is left, and again.

wear.py [FOLDER] [--distance KM] writes FOLDER/wear.csv and FOLDER/profile_KM.prw, by default into results/wear."""

import argparse
import csv
from dataclasses import dataclass
from pathlib import Path

import microslip
import numpy as np

PROFILES = Path(__file__).resolve().parents[1] / "profiles"
SPEED, LOAD, RADIUS = 30.0, 80e3, 0.46  # m/s, N, m
# Dry steel by KTH's map; in service part of the distance is lubricated by rain or grease, and wear is several times less.
STEEL = microslip.SurfaceStrength(hardness=3e9)
BIN = 0.25e-3  # m, along the profile
SMOOTHING = 1e-3  # m, of each pass
PASSES = 4
DEEPEST_STEP = 50e-6  # m that may be worn off before contacts are computed again


@dataclass
class Service:
    """Service of a wheelset: states of its left wheel and the share of the distance that it spends in each."""

    lateral: np.ndarray  # m
    yaw: np.ndarray  # rad
    share: np.ndarray  # -, their sum is 1


def service(positions=31, deviation=2.5e-3, yaw=1.5e-3):
    """Lateral positions that are normally distributed about the track's centre, turned to either side alike."""
    lateral = np.linspace(-7e-3, 7e-3, positions)
    share = np.exp(-0.5 * (lateral / deviation) ** 2)
    share /= 2 * share.sum()
    return Service(np.tile(lateral, 2), np.repeat([-yaw, yaw], positions), np.tile(share, 2))


def pair(wheel, side="left", strength=STEEL):
    """The wheel on a new rail."""
    return microslip.WheelRail(
        track=microslip.Track(gauge=1.435, cant=0.025), rail=microslip.read_profile(PROFILES / "60e1.prr"),
        wheelset=microslip.Wheelset(nominal_radius=RADIUS, flange_back_distance=1.36), wheel=wheel, side=side,
        friction=0.3, strength=strength, fields=True)


def arc(wheel):
    """s [m] at many points of the profile, with y there."""
    s = np.linspace(0, wheel.length, 20 * len(wheel.y))
    return s, wheel.point(s)[0]


def add_strips(depth, centres, width, values):
    """Adds strips of a width about centres [m] to the bins of a depth, each bin by the part that it shares."""
    edges = BIN * np.arange(len(depth) + 1)
    for centre, value in zip(centres, values):
        overlap = np.minimum(edges[1:], centre + width / 2) - np.maximum(edges[:-1], centre - width / 2)
        depth += value * np.maximum(overlap, 0) / BIN


def wear_per_metre(wheel, side="left", of=None, strength=STEEL):
    """Depth [m] that a metre of rolling wears off each bin along the profile, and its integral [m^2] by the patches.

    A row of a patch takes off its depth at each passage, once a turn: h/(2 pi r) per metre."""
    of = of or service()
    contact = pair(wheel, side, strength)
    sign = 1 if side == "left" else -1
    s, y = arc(wheel)
    depth, area = np.zeros(int(np.ceil(wheel.length / BIN))), 0.0
    for lateral, yaw, share in zip(of.lateral, of.yaw, of.share):
        solution = contact.solve(lateral=sign * lateral, yaw=sign * yaw, vertical_force=LOAD, forward_velocity=SPEED)
        if solution.status != microslip.Status.ok:
            raise RuntimeError(f"y = {lateral} m, yaw = {yaw} rad: {solution.status.name}, residual {solution.residual:.2g}")
        for patch, fields in zip(solution.patches, solution.fields):
            worn = microslip.wear_depth(fields, hardness=strength.hardness, rolling_speed=patch.rolling_speed,
                                        wear_map=strength.wear_map).sum(axis=1)
            turns = 1 / (2 * np.pi * patch.rolling_radius)
            middle = s[np.argmin(np.abs(y - patch.wheel_y) + 1e3 * (y < -0.06))]  # not on the flange's back
            add_strips(depth, middle + sign * fields.fields.y[:, 0], fields.grid.dy, share * turns * worn)
            area += share * turns * patch.worn_area
    return depth, area


def smoothed(depth, length=SMOOTHING):
    """The depth after some passes of (1 - length^2 d^2/ds^2)^-1, nearly a Gaussian of the deviation sqrt(2 PASSES)
    length. Nothing flows over the ends: its integral stays, and it stays positive. One pass alone has kinks."""
    n, k = len(depth), (length / BIN) ** 2
    matrix = np.diag(np.full(n, 1 + 2 * k)) - np.diag(np.full(n - 1, k), 1) - np.diag(np.full(n - 1, k), -1)
    matrix[0, 0] = matrix[-1, -1] = 1 + k
    for _ in range(PASSES):
        depth = np.linalg.solve(matrix, depth)
    return depth


def worn(wheel, depth):
    """The profile with a depth taken off along its normal. The wheel lies to the left of its profile."""
    chords = np.hypot(np.diff(wheel.y), np.diff(wheel.z))
    s = np.concatenate(([0], np.cumsum(chords)))
    off, angle = np.interp(s, BIN * (np.arange(len(depth)) + 0.5), depth), wheel.angle(s)
    return microslip.Profile(wheel.y - off * np.sin(angle), wheel.z + off * np.cos(angle), "wheel")


def evolve(distance, wheel=None):
    """Profiles after so many metres, not further apart than DEEPEST_STEP allows: (distance, profile, area per metre)."""
    wheel, travelled = wheel or microslip.read_profile(PROFILES / "s1002.prw"), 0.0
    while True:
        depth, area = wear_per_metre(wheel)
        yield travelled, wheel, area
        if travelled >= distance:
            return
        depth = smoothed(depth)
        step = min(DEEPEST_STEP / depth.max(), distance - travelled)
        wheel, travelled = worn(wheel, step * depth), travelled + step


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", nargs="?", type=Path, default=Path("results/wear"))
    arguments.add_argument("--distance", type=float, default=3000.0, help="km")
    given = arguments.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    rows = []
    print("  distance   wear rate   flange height  thickness  gradient")
    print("        km     mm^2/Mm             mm         mm        mm")
    for travelled, wheel, area in evolve(1e3 * given.distance):
        flange = wheel.wheel_dimensions()
        row = (1e-3 * travelled, 1e12 * area, 1e3 * flange.flange_height, 1e3 * flange.flange_thickness,
               1e3 * flange.flange_gradient)
        rows.append(row)
        print("{:10.1f} {:11.1f} {:15.3f} {:10.3f} {:9.3f}".format(*row))
        wheel.write(given.folder / f"profile_{1e-3 * travelled:.1f}.prw")
    with open(given.folder / "wear.csv", "w", newline="") as file:
        csv.writer(file).writerows([("distance_km", "wear_rate_mm2_per_Mm", "flange_height_mm", "flange_thickness_mm",
                                     "flange_gradient_mm"), *rows])


if __name__ == "__main__":
    main()
