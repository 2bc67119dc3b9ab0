"""Von Mises' stress at blocks of points inside the bodies: planes as maps, lines as curves."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.picture_style import INK, SIZES, new_figure, open_axes, put_title, unit_for

# So many planes of a block of points are drawn.
MOST_PLANES = 3


def interior_picture(title, blocks):
    """The figure of blocks of points, each of arrays x, y, z [m] and the stress [Pa]; z > 0 in body 1."""
    panels = [panel for block in blocks for panel in panels_of(block)][:2 * MOST_PLANES]
    highest = max(panel["stress"].max() for panel in panels)
    scale, unit = unit_for(highest, "Pa")
    colours = Normalize(0, scale * highest or 1)
    figure = new_figure(4.6 * len(panels) + 1.2, 4.6)
    put_title(figure, title)
    drawn = figure.subplots(1, len(panels), squeeze=False)[0]
    has_maps = False
    for axes, panel in zip(drawn, panels):
        has_maps |= draw_panel(axes, panel, scale, unit, colours)
    if has_maps:
        figure.colorbar(ScalarMappable(norm=colours, cmap=SIZES), ax=list(drawn), label=f"von Mises' stress [{unit}]", shrink=0.85)
    return figure


def interior_points(result, folder):
    """x, y, z and von Mises' stress of all points that a case asks for."""
    x, y, z = (result.array(f"{folder}/{name}") for name in "xyz")
    z, y, x = np.meshgrid(z, y, x, indexing="ij")
    return [values.ravel() for values in (x, y, z, result.array(f"{folder}/von_mises", dimensions=3))]


def panels_of(block):
    """Planes y = const of a block of points with three directions, nearest to the middle first; of others the block.
    Each body has separate panels: stresses jump at the surface."""
    z = block[2]
    inside = [z >= 0, z < 0]
    if all(np.count_nonzero(which) > 1 for which in inside):
        return [panel for which in inside for panel in panels_of([values[which] for values in block])]
    x, y, z, stress = block
    lines = [1e3 * np.unique(np.round(values, 12)) for values in (x, y, z)]
    if all(len(line) > 1 for line in lines):
        planes = sorted(np.unique(np.round(y, 12)), key=abs)[:MOST_PLANES]
        return [panel_of(*(values[np.isclose(y, plane, atol=1e-12)] for values in block)) for plane in planes]
    return [panel_of(x, y, z, stress)]


def panel_of(x, y, z, stress):
    """The directions in which the points differ, and what they have in common."""
    coordinates = {"x": 1e3 * x, "y": 1e3 * y, "z": 1e3 * z}
    free = [name for name, values in coordinates.items() if np.ptp(values) > 0] or ["z"]
    body = f"body {1 if z[0] >= 0 else 2}"
    held = ", ".join([body] + [f"{name} = {values[0]:.4g} mm" for name, values in coordinates.items() if name not in free])
    return {"free": free, "at": [coordinates[name] for name in free], "stress": stress, "held": held}


def draw_panel(axes, panel, scale, unit, colours):
    """A map or a curve; whether it is a map."""
    axes.set_title(panel["held"])
    axes.set_xlabel(f"{panel['free'][0]} [mm]")
    if len(panel["free"]) == 1:
        open_axes(axes)
        along = panel["at"][0]
        axes.plot(along, scale * panel["stress"], ".-", color=INK)
        axes.set_ylabel(f"von Mises' stress [{unit}]")
        return False
    rows = [np.unique(np.round(values, 9)) for values in panel["at"]]
    order = np.lexsort((panel["at"][0], panel["at"][1]))
    values = scale * panel["stress"][order]
    axes.set_ylabel(f"{panel['free'][1]} [mm]" + (", > 0 in body 1" if panel["free"][1] == "z" else ""))
    if values.size == rows[0].size * rows[1].size:
        levels = np.linspace(0, colours.vmax, 25)
        axes.contourf(*rows, values.reshape(rows[1].size, rows[0].size), levels=levels, norm=colours, cmap=SIZES)
    else:
        axes.scatter(*panel["at"], c=scale * panel["stress"], norm=colours, cmap=SIZES, s=9)
    axes.set_aspect("equal" if 0.2 < np.ptp(rows[0]) / np.ptp(rows[1]) < 5 else "auto")
    return True
