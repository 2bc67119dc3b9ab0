"""Pictures of what `microslip run` wrote: forces over the cases, the fields of cases whose elements are stored, stresses inside
the bodies where points were asked for."""

import numpy as np
from matplotlib.ticker import MaxNLocator

from microslip.contact_cells import EXTERIOR, ContactCells
from microslip.cut_picture import shade
from microslip.interior_picture import interior_picture
from microslip.picture_style import (ACROSS, ALONG, INK, INK3, heading, names_above, new_figure, number, open_axes,
                                     put_title, shown, unit_for)
from microslip.pressure_picture import pressure_picture
from microslip.result_file import ResultError
from microslip.solved_contacts import SolvedContact

# So many cases have a separate picture.
MOST_CASES = 12
SHIFT = 1  # of cases/motion
GRID_NAMES = ["x0", "y0", "dx", "dy"]
# Forces and changes of a force that are smaller than this part of the normal force are what a solver leaves.
STEADY = 1e-5


def contact_run_pictures(result):
    """The pictures of a result file of kind contact_run, by file name."""
    numbers, stored = (result.array(f"/cases/{name}") for name in ("number", "stored_elements"))
    figures = {"forces.png": forces_picture(result)}
    for case in np.unique(numbers[stored > 0])[:MOST_CASES]:
        contacts = np.flatnonzero((numbers == case) & (stored > 0))
        figures[f"case_{int(case):04}.png"] = case_picture(result, int(case), contacts)
    if "/cases/stored_points" in result:
        points = result.array("/cases/stored_points")
        for case in np.unique(numbers[points > 0])[:MOST_CASES]:
            contact = np.flatnonzero((numbers == case) & (points > 0))[0]
            figures[f"stresses_{int(case):04}.png"] = stresses_picture(result, int(case), contact)
    return figures


def forces_picture(result):
    """Forces on body 1 over the cases, of each patch."""
    numbers, patches = (result.array(f"/cases/{name}") for name in ("number", "patch"))
    figure = new_figure(7.0, 5.6)
    panels = figure.subplots(2, 1, sharex=True)
    drawn = ((panels[0], "normal_force", INK, "$F_n$"), (panels[1], "fx", ALONG, "$F_x$"), (panels[1], "fy", ACROSS, "$F_y$"))
    values = {name: result.array(f"/cases/{name}", finite=False) for _, name, _, _ in drawn}
    largest = {axes: max(np.nanmax(np.abs(values[name]), initial=0) for one, name, _, _ in drawn if one is axes) for axes in panels}
    for patch in np.unique(patches):
        chosen = patches == patch
        label = f", patch {int(patch)}" if patch > 0 else ""
        for axes, name, colour, symbol in drawn:
            scale, _ = unit_for(largest[axes], "N")
            forces = scale * shown(values[name][chosen], max(largest.values()), STEADY)
            axes.plot(numbers[chosen], forces, "osD^v<>"[int(patch) % 7], color=colour, markersize=4, label=symbol + label)
            axes.plot(numbers[chosen], forces, color=colour, linewidth=0.8, alpha=0.4)
    for axes, what in zip(panels, ("normal force", "force on body 1")):
        axes.set_ylabel(f"{what} [{unit_for(largest[axes], 'N')[1]}]")
        open_axes(axes)
        axes.ticklabel_format(useOffset=False)
        names_above(axes)
        show_noise_as_a_line(axes)
    panels[1].set_xlabel("case")
    panels[1].set_xlim(numbers.min() - 0.5, numbers.max() + 0.5)
    panels[1].xaxis.set_major_locator(MaxNLocator(integer=True))
    put_title(figure, heading("Forces", result))
    return figure


def show_noise_as_a_line(axes):
    """Draws values that change by rounding only as a line in the middle."""
    low, high = axes.dataLim.intervaly
    far = max(abs(low), abs(high))
    if np.isfinite(far) and high - low < STEADY * far:
        axes.set_ylim(low - 0.1 * far, high + 0.1 * far)
    elif far == 0:
        axes.set_ylim(-1, 1)


def case_picture(result, case, contacts):
    """Pressure with the tractions as arrows, a panel for each contact; of a grid of one row curves along x."""
    grids = [stored_cells(result, contact) for contact in contacts]
    if all(grid.x.shape[0] == 1 for grid in grids):
        return curves_picture(result, case, contacts, grids)
    patches = [int(result.array("/cases/patch")[contact]) for contact in contacts]
    titles = [(f"patch {patch}\n" if patch > 0 else "") + forces_text(result, contact) for patch, contact in zip(patches, contacts)]
    return pressure_picture(heading(f"Case {case}, pressure and tractions on body 1", result), grids, titles)


def forces_text(result, contact):
    """The forces of a contact for a title."""
    values = {symbol: float(result.array(f"/cases/{name}", finite=False)[contact])
              for symbol, name in (("F_n", "normal_force"), ("F_x", "fx"), ("F_y", "fy"))}
    largest = max(abs(value) for value in values.values())
    scale, unit = unit_for(largest, "N")
    return ",  ".join(f"${symbol}$ = {number(float(scale * shown(value, largest, STEADY)))} {unit}" for symbol, value in values.items())


def curves_picture(result, case, contacts, grids):
    """Pressure, bound and tractions along the only row; adhesion and slip as coloured ground."""
    figure = new_figure(1.6 + 5.6 * len(contacts), 4.4)
    panels = figure.subplots(1, len(contacts), squeeze=False, sharey=True)[0]
    scale, unit = unit_for(1e6 * max(grid.pressure.max() for grid in grids), "Pa")
    for axes, contact, grid in zip(panels, contacts, grids):
        open_axes(axes)
        x = grid.x[0]
        for values, label, colour, style in ((grid.pressure, "$p_n$", INK3, "-"), (grid.bound, "$g$, the bound", INK, ":"),
                                             (grid.px, "$p_x$", ALONG, "-"), (grid.py, "$p_y$", ACROSS, "--")):
            axes.plot(x, 1e6 * scale * values[0], style, color=colour, label=label, linewidth=1.8)
        shade(axes, grid, 0)
        left, right, *_ = grid.outline.limits()
        axes.set_xlim(left - 0.15 * grid.a, right + 0.15 * grid.a)
        axes.set_xlabel("x [mm]")
        axes.set_title(forces_text(result, contact), pad=22)
        names_above(axes)
    panels[0].set_ylabel(f"pressure and traction on body 1 [{unit}]")
    put_title(figure, heading(f"Case {case}, along the row of elements", result))
    return figure


def stored_cells(result, contact):
    """The stored elements of a contact on its grid; zero at elements that are not stored."""
    first, stored, mx, my = (int(result.array(f"/cases/{name}")[contact])
                             for name in ("first_element", "stored_elements", "mx", "my"))
    x0, y0, dx, dy = (1e3 * result.array(f"/cases/{name}", finite=False)[contact] for name in GRID_NAMES)
    x, y = np.meshgrid(x0 + dx * np.arange(mx), y0 + dy * np.arange(my))
    chosen = slice(first, first + stored)
    index = result.array("/elements/index")[chosen].astype(int)

    def on_grid(name, scale):
        grid = np.zeros(mx * my)
        grid[index] = scale * result.array(f"/elements/{name}", finite=False)[chosen]
        return grid.reshape(my, mx)

    fields = [on_grid(name, 1e-6) for name in ("bound", "px", "py")] + [on_grid(name, 1e3) for name in ("sx", "sy")]
    pressure, state = on_grid("pressure", 1e-6), on_grid("state", 1)
    return ContactCells(x, y, np.full(x.shape, dx * dy), *fields, np.where(pressure > 0, state, EXTERIOR), pressure=pressure, size=(dx, dy))


class CaseOfRun:
    """A case of a run as a result file of its own, as far as pictures of fields ask for: title, motion and `contacts`."""

    def __init__(self, result, number, motion):
        self.path, self._result, self._number, self._motion = result.path, result, number, motion
        self.contacts = {}

    def attribute(self, name, default=None):
        """A root attribute of the run as text; the title has the case's number."""
        value = self._result.attribute(name, default)
        return f"{value}, case {self._number}" if name == "title" else value

    def __contains__(self, name):
        return name == "/inputs/motion/kind"

    def text(self, _):
        """The kind of motion."""
        return "shift" if self._motion == SHIFT else "steady"

    @staticmethod
    def assumption(_):
        """None."""
        return ""


def cases_of_run(result):
    """The first cases whose elements are stored, by number."""
    numbers, patches, stored = (result.array(f"/cases/{name}") for name in ("number", "patch", "stored_elements"))
    motions = result.array("/cases/motion") if "/cases/motion" in result else np.zeros(len(numbers))
    cases = {}
    for contact in np.flatnonzero(stored > 0):
        number = int(numbers[contact])
        if number not in cases and len(cases) == MOST_CASES:
            break
        case = cases.setdefault(number, CaseOfRun(result, number, int(motions[contact])))
        name = f"patch {int(patches[contact])}" if patches[contact] > 0 else "contact"
        case.contacts[name] = SolvedContact(None, stored_cells(result, contact), None)
    if not cases:
        raise ResultError(f"{result.path}: stores the elements of no case; A = 1 or 2 stores them")
    return cases


def stresses_picture(result, case, contact):
    """Von Mises' stress at the points of a case, block by block."""
    first, stored = (int(result.array(f"/cases/{name}")[contact]) for name in ("first_point", "stored_points"))
    chosen = slice(first, first + stored)
    x, y, z, stress, block = (result.array(f"/interior/{name}", finite=False)[chosen] for name in ("x", "y", "z", "von_mises", "block"))
    blocks = [tuple(values[block == one] for values in (x, y, z, stress)) for one in np.unique(block)]
    return interior_picture(heading(f"Case {case}, von Mises' stress inside the bodies", result), blocks)
