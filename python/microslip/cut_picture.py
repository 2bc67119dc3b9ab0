"""A cut through a contact along a row: tractions within their bound above, slip below."""

import numpy as np

from microslip.contact_cells import ADHESION, SLIP
from microslip.picture_style import (BLACK, BLUE, GREEN, GREY, ORANGE, SKY_BLUE, VERMILION, bodies_of, heading, new_figure,
                                     label_of, number, open_axes, put_title, the)
from microslip.result_file import ResultError
from microslip.solved_contacts import label_along_x, slip_unit


def cut_picture(result, contacts, y=0.0):
    """The row nearest to y [mm] by each theory, or of each patch that has one in its frame."""
    reach = {key: one.cells.outline.limits()[2:] for key, one in contacts.items()}
    cells = {key: one.cells for key, one in contacts.items() if reach[key][0] <= y <= reach[key][1]}
    if not cells:
        ranges = dict.fromkeys(f"from {number(low)} to {number(high)} mm" + (f" ({label_of(key)})" if len(reach) > 1 else "")
                               for key, (low, high) in reach.items())
        raise ResultError(f"the cut at y = {number(y)} mm is outside the contact, which goes {', '.join(ranges)}")
    figure = new_figure(5.4 * len(cells), 5.6)
    put_title(figure, heading("Cut along x", result, cells))
    panels = figure.subplots(2, len(cells), sharex=True, sharey="row", squeeze=False, height_ratios=(1.5, 1))
    for column, (key, grid) in enumerate(cells.items()):
        row = nearest_row(grid, y)
        above, below = panels[:, column]
        draw_tractions(above, grid, row)
        draw_slip(below, grid, row)
        for axes in (above, below):
            open_axes(axes)
            shade(axes, grid, row)
        above.set_title(f"{label_of(key)}, y = {number(grid.row_y[row])} mm")
        below.set_xlabel(label_along_x(result))
    panels[0, 0].set_ylabel(f"traction on {the(bodies_of(result)[0])} [MPa]")
    panels[1, 0].set_ylabel(f"slip of {the(bodies_of(result)[0])} [{slip_unit(result)[0]}]")
    for axes in panels[:, -1]:
        axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))
    return figure


def nearest_row(grid, y):
    """The index of the row nearest to y [mm]; of two as near the lower one."""
    return int(np.argmin(np.round(np.abs(grid.row_y - y), 9)))


def draw_tractions(axes, grid, row):
    """px, py and their size as the steps that they are, under the bound."""
    inside = grid.state[row] != 0
    x, bound = grid.x[row, inside], grid.bound[row, inside]
    axes.plot(x, bound, color=BLACK, linewidth=1.2, label=r"$\pm g$, the bound")
    axes.plot(x, -bound, color=BLACK, linewidth=1.2)
    for values, colour, style, label in ((np.hypot(grid.px, grid.py), GREY, "-", r"$|\mathbf{p}|$"), (grid.px, BLUE, "-", "$p_x$"),
                                         (grid.py, VERMILION, "--", "$p_y$")):
        axes.plot(x, values[row, inside], style, color=colour, linewidth=2, marker="." if len(x) <= 40 else "", label=label)


def draw_slip(axes, grid, row):
    """Both components of the slip."""
    inside = grid.state[row] != 0
    for values, colour, style, label in ((grid.sx, BLUE, "-", "$s_x$"), (grid.sy, GREEN, "--", "$s_y$")):
        axes.plot(grid.x[row, inside], values[row, inside], style, color=colour, linewidth=2,
                  marker="." if inside.sum() <= 40 else "", label=label)


def shade(axes, grid, row):
    """Adhesion and slip as coloured ground."""
    for state, colour, label in ((ADHESION, SKY_BLUE, "adhesion"), (SLIP, ORANGE, "slip")):
        for left, right in grid.spans(state, row):
            axes.axvspan(left, right, color=colour, alpha=0.25, linewidth=0, label=label)
            label = None
