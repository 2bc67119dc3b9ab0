"""The contacts whose fields a result file holds: that of two bodies by each theory, those of a wheel on a rail patch by patch."""

import math
from dataclasses import dataclass

from microslip.contact_cells import MOST_CELLS, ContactCells, read_cells
from microslip.picture_style import THEORIES
from microslip.result_file import ResultError

# Kinds of files that hold fields of contacts, and what makes them.
MAKERS = "a case with [body1] and [body2], or of one state of a wheel on a rail"


@dataclass(frozen=True)
class StoredContact:
    """Fields of a contact in a file: what pictures call it, the folder they are in, their cells, the speed of rolling [m/s]."""

    label: str
    folder: str
    cells: ContactCells
    rolling_speed: float


def stored_contacts(result, theories=THEORIES):
    """All contacts of a file whose fields it has; of two bodies those by some theories. ResultError where it has none."""
    kind = result.attribute("kind")
    if kind == "wheel_rail":
        contacts = patches(result)
    elif kind == "rolling_contact":
        contacts = [StoredContact(THEORIES[theory], f"/{theory}/fields", read_cells(result, theory), result.number("/inputs/rolling_speed"))
                    for theory in THEORIES if theory in theories and f"{theory}/fields" in result]
    else:
        raise ResultError(f"{result.path}: kind '{kind}' has no fields of a contact; files of kind rolling_contact and wheel_rail do, "
                          f"which solve makes of {MAKERS}. Without options plot draws all pictures of this file")
    if not contacts:
        raise ResultError(f"{result.path}: has no fields of a contact: a sweep of states and theory = \"table\" have none")
    return contacts


def patches(result):
    """The patches of a wheel on a rail, each from its origin: x forward, y to the left along the surface of the rail."""
    if "fields" not in result:
        return []
    speeds = result.array("/patches/rolling_speed", finite=False)
    return [StoredContact(f"patch {k + 1}", f"/fields/{k}", read_patch(result, k), float(speed)) for k, speed in enumerate(speeds)]


def read_patch(result, k, x0=0.0, y0=0.0):
    """The cells of a patch, moved by x0 and y0 [mm]."""
    folder = f"/fields/{k}"
    names = [f"{folder}/{name}" for name in ("x", "y", "area", "bound", "px", "py", "sx", "sy", "state", "pressure")]
    strides = [math.ceil(count / MOST_CELLS) for count in result.shape(names[0])]
    x, y, area, bound, px, py, sx, sy, state, pressure = result.arrays(names, dimensions=2, strides=strides)
    return ContactCells(1e3 * x + x0, 1e3 * y + y0, 1e6 * area, 1e-6 * bound, 1e-6 * px, 1e-6 * py, 1e3 * sx, 1e3 * sy, state,
                        pressure=1e-6 * pressure)


def theories_of(contacts):
    """The theories that contacts of two bodies are by, as files call them."""
    return [theory for theory in THEORIES if any(contact.folder == f"/{theory}/fields" for contact in contacts)]


def rolls_backward(result):
    """Whether the contact rolls against x; a wheel on a rail never does."""
    return "/inputs/direction" in result and result.text("/inputs/direction") == "backward"
