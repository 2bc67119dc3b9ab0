"""Wheel and rail in the axes of their profiles, drawn apart, with the points that touch joined by lines."""

import numpy as np
from matplotlib.collections import LineCollection

from microslip.picture_style import RAIL, SIZES_OF_LINES, WHEEL, open_axes

ABOVE = 25.0  # [mm], by which the wheel is drawn higher


def draw_contact_points(axes, rail, wheel, on_rail, on_wheel, values, widths):
    """The profiles and the points on them are pairs of y and z [mm]; lines are coloured by `values`. Returns the lines."""
    (rail_y, rail_z), (wheel_y, wheel_z) = rail, wheel
    axes.plot(rail_y, rail_z, color=RAIL, linewidth=1.8)
    axes.plot(wheel_y, wheel_z + ABOVE, color=WHEEL, linewidth=1.8)
    ends = [np.column_stack(on_rail), np.column_stack(on_wheel) + [0, ABOVE]]
    lines = LineCollection(np.stack(ends, axis=1), array=values, cmap=SIZES_OF_LINES, linewidths=widths)
    axes.add_collection(lines)
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlim(max(wheel_y.min(), min(rail_y.min(), -48)) - 2, rail_y.max() + 6)
    low = max(rail_z.min(), rail_z.max() - 22)
    axes.set_ylim(low - 2, np.interp(rail_y.max(), wheel_y, wheel_z) + ABOVE + 12)
    axes.text(0.01, 0.97, f"wheel, drawn {ABOVE:.0f} mm higher", color=WHEEL, transform=axes.transAxes, va="top")
    axes.set_xlabel("y of both profiles [mm], to the field side")
    axes.set_ylabel("z [mm], up")
    open_axes(axes)
    return lines
