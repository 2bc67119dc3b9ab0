"""Balances of a result, from what its file holds: forces are sums of tractions, power is force times creepage."""

import numpy as np

from microslip.picture_style import THEORIES, shown, unit_for

# What is smaller, in parts of what it is compared with, is rounding.
ROUNDING = 1e-13


def checks(result):
    """Rows of a table: what is compared, both sides as texts in one unit, and by how much they differ, in parts of the larger one."""
    kind = result.attribute("kind")
    if kind == "rolling_contact":
        return rows(of_two_bodies(result))
    if kind == "wheel_rail":
        return rows(of_wheel(result, ""))
    if kind == "wheelset":
        return rows([*of_wheel(result, "left/"), *of_wheel(result, "right/"), *of_wheelset(result)])
    return []


def rows(balances):
    """Balances (group, name, left sides, right sides, unit, scale) as texts; of several states the one that is furthest apart."""
    found = []
    for group, name, left, right, unit, scale in balances:
        left, right = np.atleast_1d(left), np.atleast_1d(right)
        known = np.isfinite(left) & np.isfinite(right)
        if not known.any():
            continue
        left, right, scale = left[known], right[known], np.broadcast_to(scale, known.shape)[known]
        apart = np.abs(left - right) / np.where(scale > 0, scale, 1)
        worst = int(np.argmax(apart))
        sides = [float(shown(side[worst], scale[worst], ROUNDING)) for side in (left, right)]
        factor, readable = unit_for(max(map(abs, sides)), unit)
        found.append({"group": group, "name": name, "left": f"{factor * sides[0]:.6g}", "right": f"{factor * sides[1]:.6g}", "unit": readable,
                      "apart": f"{apart[worst]:.1e}" if apart[worst] > 0 else "0"})
    return found


def of_two_bodies(result):
    """Equilibrium and energy of each theory with fields."""
    for theory in THEORIES:
        if f"{theory}/fields" not in result:
            continue
        label = THEORIES[theory]
        area, px, py = (result.array(f"{theory}/fields/{name}", dimensions=2, finite=False) for name in ("area", "px", "py"))
        normal = result.number("hertz/normal_force")
        limit = float(np.sum(area * result.array(f"{theory}/fields/bound", dimensions=2, finite=False)))
        if f"{theory}/fields/pressure" in result:
            pressure = result.array(f"{theory}/fields/pressure", dimensions=2, finite=False)
            yield label, "pressures = normal force", np.sum(area * pressure), normal, "N", normal
        for traction, force in ((px, "fx"), (py, "fy")):
            yield label, f"tractions = {force}", np.sum(area * traction), result.number(f"{theory}/{force}"), "N", limit
        if theory == "exact" and "nip/slip_power" not in result and f"{theory}/power_by_creepage" in result:
            power, unit = result.number(f"{theory}/frictional_power"), result.unit(f"{theory}/frictional_power")
            yield label, "power of friction = of the forces", power, result.number(f"{theory}/power_by_creepage"), unit, abs(power)
    if "nip/slip_power" in result:
        yield "nip", "power of drives = slip + hysteresis", *nip_power(result)


def nip_power(result):
    """Power of both drives against slip and hysteresis. Speeds are those of a creepage about the mean: V (1 -+ xi/2)."""
    speed = result.number("inputs/motion/rolling_speed")
    half = 0.5 * speed * result.number("exact/creepage_longitudinal")
    driven = result.number("nip/drive1") * (speed - half) + result.number("nip/drive2") * (speed + half)
    lost = result.number("nip/slip_power") + result.number("nip/hysteresis_power")
    return driven, lost, "W", abs(lost)


def of_wheel(result, side):
    """The wheel's forces from those of its patches, and its load."""
    label = f"{side.rstrip('/')} wheel" if side else "wheel"
    names = ("state", "normal_force", "fx", "fy", "angle", "frictional_power")
    if any(f"{side}patches/{name}" not in result for name in names):
        return
    state, normal, fx, fy, angle, power = (result.array(f"{side}patches/{name}", finite=False) for name in names)
    force = {axis: result.array(f"{side}wheel/force_{axis}", finite=False) for axis in "xyz"}
    cosine, sine = np.cos(angle), np.sin(angle)
    sums = {"x": fx, "y": fy * cosine - normal * sine, "z": normal * cosine + fy * sine}
    for axis, values in sums.items():
        total = np.bincount(state.astype(int), values, minlength=len(force[axis]))
        yield label, f"patches = F{axis}", total, force[axis], "N", np.abs(force["z"])
    whole = result.array(f"{side}wheel/frictional_power", finite=False)
    total = np.bincount(state.astype(int), power, minlength=len(whole))
    yield label, "power of patches = of the wheel", total, whole, "W", np.abs(whole)
    if not side and "states/vertical_force" in result:
        load = result.array("states/vertical_force", finite=False)
        yield label, "Fz = load given", force["z"], load, "N", np.abs(load)


def of_wheelset(result):
    """Both wheels together."""
    vertical = result.array("wheelset/force_z", finite=False)
    for axis in "yz":
        both = sum(result.array(f"{side}/wheel/force_{axis}", finite=False) for side in ("left", "right"))
        yield "wheelset", f"both wheels = F{axis}", both, result.array(f"wheelset/force_{axis}", finite=False), "N", np.abs(vertical)
    if "states/vertical_force" in result:
        load = result.array("states/vertical_force", finite=False)
        yield "wheelset", "Fz = load given", vertical, load, "N", np.abs(load)
