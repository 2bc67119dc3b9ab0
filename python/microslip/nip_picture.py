"""A nip of rollers along x, in the row of the largest pressure: pressure and tractions above, slip below."""

import numpy as np

from microslip.cut_picture import draw_slip, shade
from microslip.picture_style import (ALONG, INK, INK2, INK3, bodies_of, heading, names_above, new_figure, number, open_axes,
                                     put_title, quantity, the, unit_for)
from microslip.solved_contacts import label_along_x, slip_unit


def nip_picture(result, grid):
    """The exact theory's cells with what the rollers' user asks of them in the title."""
    row = int(np.argmax(grid.bound.max(axis=1)))
    figure = new_figure(7.0, 5.8)
    put_title(figure, f"{heading('Nip', result)}\n{results(result)}")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1.7, 1))
    draw_pressure(above, result, grid, row)
    draw_slip(below, grid, row)
    for axes in (above, below):
        open_axes(axes)
        shade(axes, grid, row, named=axes is above)
        axes.axhline(0, color=INK2, linewidth=0.8)
        names_above(axes)
    below.set_xlabel(label_along_x(result))
    below.set_ylabel(f"slip [{slip_unit(result)[0]}]")
    return figure


def draw_pressure(axes, result, grid, row):
    """Pressure and px within its bound, as the steps that they are."""
    inside = grid.state[row] != 0
    x = grid.x[row, inside]
    pressure, bound, px = (1e6 * values[row, inside] for values in (grid.pressure, grid.bound, grid.px))
    factor, unit = unit_for(pressure.max(), "Pa")
    marker = "." if len(x) <= 40 else ""
    axes.plot(x, factor * pressure, color=INK, linewidth=2, marker=marker, label="$p_n$, pressure")
    axes.plot(x, factor * bound, color=INK3, linewidth=1.2, linestyle=":", label=r"$\pm g$, the bound")
    axes.plot(x, -factor * bound, color=INK3, linewidth=1.2, linestyle=":")
    axes.plot(x, factor * px, color=ALONG, linewidth=2, marker=marker, label=f"$p_x$, traction on {the(bodies_of(result)[0])}")
    axes.margins(y=0.12)  # room for words
    axes.set_ylabel(f"pressure and traction [{unit}]")


def results(result):
    """Width and indentation, and how fast a roller without torque turns."""
    def millimetres(name):
        return quantity(1e3 * result.number(name), "mm")

    text = f"width {millimetres('/nip/width')}, indentation {millimetres('/nip/indentation')}"
    for one, other in ((1, 2), (2, 1)):
        if f"nip/speed_ratio{one}" in result:
            percent = 100 * (result.number(f"/nip/speed_ratio{one}") - 1)
            text += f"\n{the(bodies_of(result)[one - 1])} without torque turns {number(abs(percent))} % {'faster' if percent > 0 else 'slower'}"
    return text
