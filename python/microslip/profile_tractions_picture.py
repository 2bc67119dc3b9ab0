"""What wheel and rail press and pull each other with, as arrows on their profiles, seen along the track."""

import numpy as np

from microslip.lateral_axis import lateral_axis
from microslip.picture_style import (ACROSS, ALONG, INK, INK3, RAIL, RAIL_FILL, WHEEL, WHEEL_FILL, heading, names_above,
                                     new_figure, open_axes, put_title, unit_for)

# Lengths in parts of the picture's width: the longest arrow, and how far apart the bodies are drawn.
LONGEST, APART = 0.14, 0.38
# Around the patches [mm], and the least distance of arrows in parts of the width.
MARGIN, ARROWS_APART = 5.0, 0.012


def profile_tractions_picture(result, rail, wheel, patches):
    """The figure: both profiles drawn apart with the force of each row of elements per length of its profile, and its
    components over the length u along the rail. `wheel`: outline y, z in track axes [mm]."""
    lines = [line_loads(cells) for cells in patches]
    u = np.concatenate([at[normal != 0] for at, normal, _, _ in lines])
    largest = max(np.hypot(line[1], line[3]).max(initial=0) for line in lines) or 1.0
    factor, unit = unit_for(1e3 * largest, "N/m")
    figure = new_figure(9, 10)
    put_title(figure, heading("Forces of the rows of elements, on the profiles", result))
    shape, loads = figure.subplots(2, 1, height_ratios=(2.6, 1))
    loads.set_box_aspect(0.33)
    draw_profiles(shape, rail, wheel, u, lines, largest)
    draw_components(loads, lines, 1e3 * factor, unit)
    lateral_axis(shape, result, "across the track from the rail's highest point [mm]")
    lateral_axis(loads, result, "along the rail's surface from its highest point [mm]", named=False)
    return figure


def line_loads(cells):
    """Of each row of elements: its u [mm], and the forces on the wheel per length across the track [N/mm], pressing it up,
    forward and to the left."""
    shares = np.where(cells.inside, cells.widths, 0.0)
    order = np.argsort(cells.row_y)
    return [cells.row_y[order], *((values * shares).sum(axis=1)[order] for values in (cells.pressure, cells.px, cells.py))]


def draw_profiles(axes, rail, wheel, u, lines, largest):
    """The profiles around the patches, the wheel lifted, with arrows that push each body: on the rail down, on the wheel
    up, with the lateral tractions."""
    y, z, _, _ = rail.at(np.linspace(u.min(), u.max(), 50))
    middle, half = (y.min() + y.max()) / 2, (y.max() - y.min()) / 2 + MARGIN
    lift, longest = APART * 2 * half, LONGEST * 2 * half
    zero = rail.y[np.argmax(rail.z)]
    low, high = rail.at(u)[1].max() - 0.45 * half, rail.at(u)[1].max() + lift + 0.45 * half
    for y, z, end, fill, outline in ((rail.y, rail.z, low, RAIL_FILL, RAIL), (wheel[0], wheel[1] + lift, high, WHEEL_FILL, WHEEL)):
        axes.fill_between(y - zero, z, end, where=(z < end) == (end == high), facecolor=fill, edgecolor="none", zorder=1.5)
        axes.plot(y - zero, z, color=outline, linewidth=1.8, zorder=2)
    for at, normal, _, left in ([values[line[1] != 0] for values in line] for line in lines):
        chosen = spread(at, ARROWS_APART * 2 * half)
        y, z, normal_y, normal_z = (values[chosen] for values in rail.at(at))
        force_y = normal[chosen] * normal_y + left[chosen] * normal_z  # the tangent to the left is (normal_z, -normal_y)
        force_z = normal[chosen] * normal_z - left[chosen] * normal_y
        arrows = {"angles": "xy", "scale_units": "xy", "scale": largest / longest, "pivot": "tip", "width": 0.0022, "zorder": 3}
        axes.quiver(y - zero, z + lift, force_y, force_z, color=WHEEL, **arrows)
        axes.quiver(y - zero, z, -force_y, -force_z, color=RAIL, **arrows)
    axes.set_aspect("equal")
    axes.set_xlim(middle + half - zero, middle - half - zero)
    axes.set_ylim(low, high)
    axes.set_ylabel("z [mm], up")
    axes.text(0.01, 0.97, "on the wheel, drawn higher", transform=axes.transAxes, va="top", weight="bold")
    axes.text(0.01, 0.03, "on the rail", transform=axes.transAxes, va="bottom", weight="bold")
    open_axes(axes)


def spread(at, apart):
    """Every so many rows that arrows are not nearer to each other, about the middle row."""
    step = max(1, int(np.ceil(apart / max(np.median(np.diff(at)), 1e-12)))) if len(at) > 1 else 1
    return np.arange(len(at) // 2 % step, len(at), step)


def draw_components(axes, lines, factor, unit):
    """Forces on the wheel per length across the track."""
    labels = (("normal", INK), ("forward", ALONG), ("to the left", ACROSS))
    for number, (at, *forces) in enumerate(lines):
        for force, (label, colour) in zip(forces, labels):
            axes.plot(at, factor * force, color=colour, linewidth=1.4, label=label if number == 0 else None)
    axes.axhline(0, color=INK3, linewidth=0.8)
    axes.set_ylabel(f"force on the wheel per length [{unit}]")
    open_axes(axes)
    names_above(axes)
