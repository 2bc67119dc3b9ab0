"""A field of a rolling contact as a map or as a surface, theories side by side."""

import math

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize

from microslip.contact_cells import EXTERIOR, MOST_CELLS
from microslip.picture_style import THEORIES, new_figure
from microslip.result_file import ResultError
from microslip.rolling_contact_pictures import contact_panels

ANGLES = np.linspace(0, 2 * np.pi, 181)
SEQUENTIAL, DIVERGING = "viridis", "PuOr"
# Name: title, unit, factor from SI, the datasets it is made of, whether it has two signs.
FIELDS = {
    "pressure": ("pressure $p_n$", "MPa", 1e-6, ("pressure",), False),
    "bound": ("traction bound $g$", "MPa", 1e-6, ("bound",), False),
    "traction": (r"size of the traction $|\mathbf{p}|$", "MPa", 1e-6, ("px", "py"), False),
    "px": ("traction on the wheel $p_x$", "MPa", 1e-6, ("px",), True),
    "py": ("traction on the wheel $p_y$", "MPa", 1e-6, ("py",), True),
    "slip": (r"size of the slip $|\mathbf{s}|$", r"$10^{-3}$", 1e3, ("sx", "sy"), False),
    "sx": ("slip of the wheel $s_x$", r"$10^{-3}$", 1e3, ("sx",), True),
    "sy": ("slip of the wheel $s_y$", r"$10^{-3}$", 1e3, ("sy",), True),
    "power": ("frictional power", "MW/m²", 1e-6, ("px", "py", "sx", "sy"), False),
    "gap": ("distance of the bodies", "µm", 1e6, ("gap",), False),
    "ux": ("displacement difference $u_x$", "µm", 1e6, ("ux",), True),
    "uy": ("displacement difference $u_y$", "µm", 1e6, ("uy",), True),
}


def field_values(result, theory, name):
    """The values of a field at a theory's cells, in the units of FIELDS; None if the theory does not have it."""
    if name not in FIELDS:
        raise ResultError(f"field '{name}' is unknown, known: {', '.join(FIELDS)}")
    _, _, factor, parts, _ = FIELDS[name]
    paths = [f"/{theory}/fields/{part}" for part in parts]
    if any(path not in result for path in paths):
        return None
    strides = [math.ceil(count / MOST_CELLS) for count in result.shape(paths[0])]
    arrays = result.arrays(paths, dimensions=2, strides=strides)
    if name == "power":
        px, py, sx, sy = arrays
        return -factor * result.number("/inputs/rolling_speed") * (px * sx + py * sy)
    return factor * (arrays[0] if len(arrays) == 1 else np.hypot(*arrays))


def with_field(result, cells, name):
    """The theories that have a field, with its values."""
    values = {theory: field_values(result, theory, name) for theory in cells}
    values = {theory: value for theory, value in values.items() if value is not None}
    if not values:
        raise ResultError(f"{result.path}: no theory has the field '{name}'")
    return values


def colours_of(name, cells, values):
    """Colour map and scale, the same for all theories: about zero for fields with two signs."""
    inside = [value[cells[theory].state != EXTERIOR] for theory, value in values.items()]
    largest = max((abs(part).max() for part in inside if part.size), default=0) or 1
    return (DIVERGING, Normalize(-largest, largest)) if FIELDS[name][4] else (SEQUENTIAL, Normalize(0, largest))


def narrowed(scale, values):
    """A scale without the sign that does not occur."""
    lowest, highest = (pick([pick(value) for value in values.values()]) for pick in (np.min, np.max))
    far = scale.vmax
    return Normalize(-far if lowest < -0.05 * far else 0, far if highest > 0.05 * far else 0)


def draw_field(axes, grid, value, colours):
    """One theory's cells in the colours of their values."""
    cmap, scale = colours
    corners, index = grid.rectangles()
    axes.add_collection(PolyCollection(corners, array=value[tuple(index.T)], cmap=cmap, norm=scale, edgecolors="face",
                                       linewidths=0.4))


def field_map(result, cells, name):
    """The figure of a field as a map."""
    values = with_field(result, cells, name)
    chosen = {theory: cells[theory] for theory in values}
    title, unit, *_ = FIELDS[name]
    colours = colours_of(name, chosen, values)
    figure, panels = contact_panels(result, chosen, title[0].upper() + title[1:])
    for axes, (theory, value) in zip(panels, values.items()):
        draw_field(axes, chosen[theory], value, colours)
        axes.set_title(THEORIES[theory])
    figure.colorbar(ScalarMappable(norm=colours[1], cmap=colours[0]), ax=panels, label=f"{title} [{unit}]", shrink=0.8, pad=0.02)
    return figure


def field_surface(result, cells, name):
    """The figure of a field as a surface over the contact."""
    values = with_field(result, cells, name)
    title, unit, *_ = FIELDS[name]
    cmap, scale = colours_of(name, cells, values)
    heights = narrowed(scale, values)
    figure = new_figure(6.2 * len(values), 5.2)
    figure.suptitle(f"{title[0].upper() + title[1:]}: {result.attribute('title', 'rolling contact')}")
    backward = result.text("/inputs/direction") == "backward"
    for number, (theory, value) in enumerate(values.items(), start=1):
        axes = figure.add_subplot(1, len(values), number, projection="3d")
        grid = cells[theory]
        shown = np.where(grid.state == EXTERIOR, np.nan, value)
        axes.plot_surface(grid.x, grid.y, shown, facecolors=matplotlib.colormaps[cmap](scale(np.nan_to_num(shown))), rstride=1,
                          cstride=1, edgecolor=(0, 0, 0, 0.3), linewidth=0.3, shade=False)
        axes.plot(grid.a * np.cos(ANGLES), grid.b * np.sin(ANGLES), heights.vmin, color="0.4", linewidth=1)
        axes.set_xlim(-1.05 * grid.a, 1.05 * grid.a)
        axes.set_ylim(-1.05 * grid.b, 1.05 * grid.b)
        axes.set_zlim(heights.vmin, heights.vmax)
        axes.set_xlabel(f"x [mm], rolling {'against' if backward else 'along'} x")
        axes.set_ylabel("y [mm]")
        axes.set_zlabel(f"{title} [{unit}]")
        axes.set_box_aspect((grid.a, grid.b, 0.7 * max(grid.a, grid.b)) if grid.true_to_scale() else (1, 1, 0.7))
        axes.view_init(elev=32, azim=-125)
        axes.set_title(THEORIES[theory])
    return figure
