"""The contacts of a result file whose fields pictures show: one contact by several theories, or the patches of wheels on rails."""

import math
from dataclasses import dataclass
from typing import Optional

from microslip.contact_cells import MOST_CELLS, ContactCells, read_cells
from microslip.picture_style import THEORIES
from microslip.result_file import ResultError


@dataclass(frozen=True)
class SolvedContact:
    """A contact with fields: the group they stand in, or None if they are those of the cells alone; the cells to draw, the
    rolling speed [m/s] if it is known."""

    folder: Optional[str]
    cells: ContactCells
    speed: Optional[float]


def read_contacts(result):
    """The contacts of an open result file by theory, or as `patch 1`, `left wheel, patch 1`."""
    contacts = KINDS[result.attribute("kind")](result)
    if not contacts:
        raise ResultError(f"{result.path}: has no fields; a case of one state, without [sweep] and by another theory than a creep-force "
                          "table, writes them")
    return contacts


def by_theory(result):
    """Contacts of two bodies: one by each theory."""
    speed = 1 if is_shift(result) else result.number("/inputs/motion/rolling_speed")
    return {theory: SolvedContact(f"/{theory}/fields", read_cells(result, theory), speed)
            for theory in THEORIES if f"{theory}/fields" in result}


def patches_of_wheel(result, side="", who=""):
    """The patches of the wheel in a group `side` of the file."""
    if f"{side}/patches" not in result:
        return {}
    speeds = result.array(f"{side}/patches/rolling_speed", finite=False)
    folders = {k: f"{side}/fields/{k}" for k in range(len(speeds))}
    return {f"{who}patch {k + 1}": SolvedContact(folder, patch_cells(result, folder), speeds[k])
            for k, folder in folders.items() if folder in result}


def patches_of_wheelset(result):
    """The patches of both wheels."""
    return {name: contact for side in ("left", "right")
            for name, contact in patches_of_wheel(result, f"/{side}", f"{side} wheel, ").items()}


# The kinds of result files that have such contacts, each with what reads them.
KINDS = {"rolling_contact": by_theory, "wheel_rail": patches_of_wheel, "wheelset": patches_of_wheelset}


def patch_cells(result, folder, at=(0.0, 0.0)):
    """The cells of a patch in its frame, or with its origin at x and y [mm]."""
    names = ("x", "y", "area", "bound", "px", "py", "sx", "sy", "state", "pressure")
    strides = [math.ceil(count / MOST_CELLS) for count in result.shape(f"{folder}/x")]
    x, y, area, bound, px, py, sx, sy, state, pressure = result.arrays([f"{folder}/{name}" for name in names], dimensions=2,
                                                                      strides=strides)
    return ContactCells(1e3 * x + at[0], 1e3 * y + at[1], 1e6 * area, 1e-6 * bound, 1e-6 * px, 1e-6 * py, 1e3 * sx, 1e3 * sy, state,
                        pressure=1e-6 * pressure)


def rolls_backward(result):
    """Returns whether body 1 rolls against x."""
    if "/inputs/motion/direction" in result:
        return result.text("/inputs/motion/direction") == "backward"
    return "/states/forward_velocity" in result and bool(result.array("/states/forward_velocity")[0] < 0)


def is_shift(result):
    """Returns whether the bodies do not roll; slip is a length then."""
    return "/inputs/motion/kind" in result and result.text("/inputs/motion/kind") == "shift"


def tells_direction(result):
    """Returns whether the bodies roll, in a direction that the file tells: that of CONTACT's cases is not in their file."""
    return not is_shift(result) and result.attribute("kind") != "contact_run"


def label_along_x(result):
    """Label of an axis in mm, with the direction of rolling."""
    return f"x [mm], rolling to the {'left' if rolls_backward(result) else 'right'}" if tells_direction(result) else "x [mm]"


def slip_unit(result):
    """Unit of the slip of ContactCells: for an axis, and as it follows a number."""
    return ("mm", " mm") if is_shift(result) else (r"$10^{-3}$", r"$\,\cdot\,10^{-3}$")
