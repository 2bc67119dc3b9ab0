"""Equivalent conicity over the amplitude, and what it follows from over the lateral displacement."""

import numpy as np

from microslip.contact_points_picture import draw_contact_points
from microslip.picture_style import LINES, RAIL, heading, names_above, new_figure, open_axes, put_title

JUMP = 1e-8  # [m], displacements that are closer are the two sides of a jump of the contact


APART = 0.25e-3  # [m], of the displacements whose points of contact are joined


def conicity_pictures(result):
    """The pictures of a result file of kind conicity, by file name."""
    return {"conicity.png": conicity_picture(result), "contact_points.png": contact_points_picture(result)}


def conicity_picture(result):
    """Conicity over the amplitude; rolling radius difference, contact angle difference and height over the displacement."""
    amplitude, gauges = 1e3 * result.array("/amplitude"), result.array("/gauges")
    figure = new_figure(7.0, 8.2)
    put_title(figure, heading("Equivalent conicity", result))
    conicity, *others = figure.subplots(4, 1, height_ratios=(2.2, 1, 1, 1))
    for k, gauge in enumerate(gauges):
        colour, group, label = LINES[k % len(LINES)], f"/gauge_{k}", f"gauge {1e3 * gauge:.2f} mm"
        values = result.array(f"{group}/conicity", finite=False)
        conicity.plot(amplitude, values, color=colour, linewidth=1.6, label=label)
        if len(gauges) == 1:
            band = np.minimum(0.05, 0.5 * values)
            conicity.fill_between(amplitude, values - band, values + band, color=colour, alpha=0.15, linewidth=0,
                                  label="\N{PLUS-MINUS SIGN}min(0.05, half of it), narrow band of EN 15302")
        draw_over_displacement(others, result, f"{group}/curve", colour)
    conicity.set_xlabel("amplitude [mm]")
    conicity.set_ylabel("equivalent conicity [-]")
    conicity.set_ylim(bottom=0)
    names_above(conicity, most=2, fontsize="small")
    others[-1].set_xlabel("lateral displacement [mm], to the left")
    for axes in (conicity, *others):
        open_axes(axes)
    return figure


def jumps_of(y, radii):
    """Indices of the displacements after which the contact jumps."""
    return np.flatnonzero((np.diff(y) < JUMP) & (np.abs(np.diff(radii)) > 1e-5))


def draw_over_displacement(axes, result, group, colour):
    """Rolling radius difference, contact angle difference and height; where a contact jumps, a gap with both ends marked and a
    dotted line from top to bottom."""
    y, radii, angles, height = result.arrays([f"{group}/{name}" for name in (
        "lateral", "rolling_radius_difference", "contact_angle_difference", "vertical")])
    jumps = jumps_of(y, radii)
    ends = np.sort(np.concatenate((jumps, jumps + 1)))
    curves = ((1e3 * radii, "rolling radius\ndifference [mm]"), (np.degrees(angles), "contact angle\ndifference [deg]"),
              (1e3 * height, "height [mm]"))
    for one, (values, label) in zip(axes, curves):
        one.plot(np.insert(1e3 * y, jumps + 1, np.nan), np.insert(values, jumps + 1, np.nan), color=colour, linewidth=1.4)
        one.plot(1e3 * y[ends], values[ends], "o", color=colour, markersize=3)
        lines = [one.axvline(1e3 * y[jump], linestyle=":", color=colour, linewidth=0.8) for jump in jumps]
        one.set_ylabel(label)
        if lines and one is axes[0]:
            one.legend(lines[:1], ["contact jumps"], loc="upper left", frameon=True, edgecolor="none", fontsize="small")


def contact_points_picture(result):
    """Points of contact of the left wheel, and of the right one if it or its rail is another, over the displacement at the first
    gauge; lines at both ends of a jump are bold."""
    sides = [side for side in ("left", "right") if f"profiles/{side}_rail" in result]
    figure = new_figure(7.6, 4.0 * len(sides) + 0.4)
    put_title(figure, heading("Contact points of the left wheel" if len(sides) == 1 else "Contact points of both wheels", result))
    y, radii = result.arrays([f"/gauge_0/curve/{name}" for name in ("lateral", "rolling_radius_difference")])
    jumps = jumps_of(y, radii)
    even = np.unique(np.searchsorted(y, np.arange(y[0], y[-1], APART)))
    shown = np.unique(np.concatenate((even, jumps, jumps + 1)))
    at_jump = np.isin(shown, np.concatenate((jumps, jumps + 1)))
    for axes, side in zip(np.atleast_1d(figure.subplots(len(sides), 1)), sides):
        curves = [[1e3 * part for part in result.arrays([f"/profiles/{side}_{body}/{axis}" for axis in "yz"])]
                  for body in ("rail", "wheel")]
        points = [[1e3 * part[shown] for part in result.arrays([f"/gauge_0/curve/{side}_{body}_{axis}" for axis in "yz"])]
                  for body in ("rail", "wheel")]
        lines = draw_contact_points(axes, *curves, *points, 1e3 * y[shown], np.where(at_jump, 1.8, 0.8))
        axes.text(0, -18, f"{side} rail; bold at both ends of a jump", color=RAIL, ha="center")
        figure.colorbar(lines, ax=axes, label="lateral displacement [mm], to the left", shrink=0.8)
    return figure
