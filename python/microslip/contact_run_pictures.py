"""Pictures of what `microslip run` wrote: forces over the cases, and pressure and tractions of cases whose elements are stored."""

import numpy as np

from microslip.contact_cells import ADHESION, EXTERIOR
from microslip.field_picture import SEQUENTIAL
from microslip.picture_style import BLACK, BLUE, GREEN, VERMILION, heading, new_figure, open_axes
from microslip.result_file import ResultError

# So many cases have a picture of their own.
MOST_CASES = 12
# So many arrows along each axis of a patch.
MOST_ARROWS = 24
GRID_NAMES = ["x0", "y0", "dx", "dy"]


def contact_run_pictures(result):
    """The pictures of a result file of kind contact_run, by file name."""
    numbers, stored = (result.array(f"/cases/{name}") for name in ("number", "stored_elements"))
    figures = {}
    if len(np.unique(numbers)) > 1:
        figures["forces.png"] = forces_picture(result)
    for case in np.unique(numbers[stored > 0])[:MOST_CASES]:
        contacts = np.flatnonzero((numbers == case) & (stored > 0))
        figures[f"case_{int(case):04}.png"] = case_picture(result, int(case), contacts)
    if not figures:
        raise ResultError(f"{result.path}: one case without elements; digit A > 0 stores them")
    return figures


def forces_picture(result):
    """Forces on body 1 over the cases, of each patch."""
    numbers, patches = (result.array(f"/cases/{name}") for name in ("number", "patch"))
    figure = new_figure(8, 5)
    axes = figure.subplots(2, 1, sharex=True)
    for patch in np.unique(patches):
        chosen = patches == patch
        label = f", patch {int(patch)}" if patch > 0 else ""
        marker = "osD^v<>"[int(patch) % 7]
        for axis, name, colour, symbol in (
            (axes[0], "normal_force", BLACK, "$F_n$"),
            (axes[1], "fx", BLUE, "$F_x$"),
            (axes[1], "fy", VERMILION, "$F_y$"),
        ):
            values = 1e-3 * result.array(f"/cases/{name}", finite=False)[chosen]
            axis.plot(numbers[chosen], values, color=colour, marker=marker, markersize=3, linewidth=1, label=symbol + label)
    axes[0].set_ylabel("normal force in kN")
    axes[1].set_ylabel("forces on body 1 in kN")
    axes[1].set_xlabel("case")
    for axis in axes:
        open_axes(axis)
        axis.legend(fontsize=7)
    figure.suptitle(heading("Forces", result))
    return figure


def case_picture(result, case, contacts):
    """Pressure as colours, tractions as arrows and the elements that adhere outlined, a panel for each contact."""
    figure = new_figure(1 + 4.5 * len(contacts), 5)
    panels = figure.subplots(1, len(contacts), squeeze=False)[0]
    grids = [StoredElements(result, contact) for contact in contacts]
    highest = max(grid.pressure.max() for grid in grids)
    for axes, contact, grid in zip(panels, contacts, grids):
        image = axes.pcolormesh(grid.x_edges, grid.y_edges, grid.shown_pressure, cmap=SEQUENTIAL, vmin=0, vmax=highest)
        adheres = (grid.state == ADHESION).astype(float)
        if 0 < adheres.sum() and min(adheres.shape) > 1:
            axes.contour(grid.x, grid.y, adheres, levels=[0.5], colors=GREEN, linewidths=1)
        draw_tractions(axes, grid)
        axes.set_aspect("equal")
        axes.set_xlabel("x in mm")
        axes.set_ylabel("y in mm")
        patch = int(result.array("/cases/patch")[contact])
        if patch > 0:
            axes.set_title(f"patch {patch}")
    figure.colorbar(image, ax=list(panels), label="pressure in MPa")
    figure.suptitle(heading(f"Case {case}, tractions on body 1, adhesion outlined", result))
    return figure


def draw_tractions(axes, grid):
    """Of every so manyth element."""
    step = max(1, -(-max(grid.pressure.shape) // MOST_ARROWS))
    some = (slice(None, None, step),) * 2
    x, y = np.meshgrid(grid.x, grid.y)
    inside = grid.state[some] != EXTERIOR
    px, py = (values[some][inside] for values in (grid.px, grid.py))
    if np.hypot(px, py).max(initial=0) > 0:
        axes.quiver(x[some][inside], y[some][inside], px, py, color="white", pivot="mid", width=0.003)


class StoredElements:
    """The fields of a contact's stored elements on its grid: mm, MPa; zero at elements that are not stored."""

    def __init__(self, result, contact):
        first, stored, self.mx, self.my = (
            int(result.array(f"/cases/{name}")[contact]) for name in ("first_element", "stored_elements", "mx", "my")
        )
        x0, y0, dx, dy = (1e3 * result.array(f"/cases/{name}", finite=False)[contact] for name in GRID_NAMES)
        self.x, self.y = x0 + dx * np.arange(self.mx), y0 + dy * np.arange(self.my)
        self.x_edges = x0 + dx * (np.arange(self.mx + 1) - 0.5)
        self.y_edges = y0 + dy * (np.arange(self.my + 1) - 0.5)
        chosen = slice(first, first + stored)
        index = result.array("/elements/index")[chosen].astype(int)
        self.state = self.on_grid(index, result.array("/elements/state")[chosen])
        self.pressure, self.px, self.py = (
            self.on_grid(index, 1e-6 * result.array(f"/elements/{name}")[chosen]) for name in ("pressure", "px", "py")
        )
        self.shown_pressure = np.ma.masked_where(self.state == EXTERIOR, self.pressure)

    def on_grid(self, index, values):
        """Values of the elements stored as an array by rows of the grid."""
        grid = np.zeros(self.mx * self.my)
        grid[index] = values
        return grid.reshape(self.my, self.mx)
