"""Equivalent conicity over the amplitude, and what it follows from over the lateral displacement."""

import numpy as np

from microslip.picture_style import BLUE, GREEN, GREY, ORANGE, SKY_BLUE, VERMILION, heading, new_figure, open_axes

COLOURS = (BLUE, VERMILION, GREEN, ORANGE, SKY_BLUE, GREY)
JUMP = 1e-8  # [m], displacements that are closer are the two sides of a jump of the contact


def conicity_pictures(result):
    """The picture of a result file of kind conicity, by file name."""
    amplitude, gauges = 1e3 * result.array("/amplitude"), result.array("/gauges")
    figure = new_figure(9, 8.5)
    figure.suptitle(heading("equivalent conicity", result))
    conicity, *others = figure.subplots(4, 1, height_ratios=(2.2, 1, 1, 1))
    for k, gauge in enumerate(gauges):
        colour, group, label = COLOURS[k % len(COLOURS)], f"/gauge_{k}", f"gauge {1e3 * gauge:.2f} mm"
        values = result.array(f"{group}/conicity", finite=False)
        conicity.plot(amplitude, values, color=colour, linewidth=1.6, label=label)
        if len(gauges) == 1:
            band = np.minimum(0.05, 0.5 * values)
            conicity.fill_between(amplitude, values - band, values + band, color=colour, alpha=0.15, linewidth=0,
                                  label="\N{PLUS-MINUS SIGN}min(0.05, half the conicity), the narrow band of EN 15302")
        draw_over_displacement(others, result, f"{group}/curve", colour)
    conicity.set_xlabel("amplitude [mm]")
    conicity.set_ylabel("equivalent conicity [-]")
    conicity.set_ylim(bottom=0)
    conicity.legend(loc="best")
    others[-1].set_xlabel("lateral displacement [mm], to the left")
    for axes in (conicity, *others):
        open_axes(axes)
    return {"conicity.png": figure}


def draw_over_displacement(axes, result, group, colour):
    """Rolling radius difference, contact angle difference and height; jumps of a contact are gaps with a dotted line."""
    y, radii, angles, height = result.arrays([f"{group}/{name}" for name in (
        "lateral", "rolling_radius_difference", "contact_angle_difference", "vertical")])
    jumps = np.flatnonzero((np.diff(y) < JUMP) & (np.abs(np.diff(radii)) > 1e-5))
    curves = ((1e3 * radii, "rolling radius\ndifference [mm]"), (np.degrees(angles), "contact angle\ndifference [deg]"),
              (1e3 * height, "height [mm]"))
    for one, (values, label) in zip(axes, curves):
        one.plot(np.insert(1e3 * y, jumps + 1, np.nan), np.insert(values, jumps + 1, np.nan), color=colour, linewidth=1.4)
        for jump in jumps:
            one.plot(1e3 * y[jump:jump + 2], values[jump:jump + 2], ":", color=colour, linewidth=1)
        one.set_ylabel(label)
