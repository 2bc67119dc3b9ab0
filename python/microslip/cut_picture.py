"""A cut through a contact along a row: tractions within their bound above, slip below."""

import numpy as np

from microslip.contact_cells import ADHESION, SLIP
from microslip.picture_style import (ACROSS, ALONG, INK, INK3, LOOKS, SLIDES, STICKS, bodies_of, halo, heading, label_of,
                                     names_above, new_figure, number, open_axes, put_title, the, vanishing)
from microslip.result_file import ResultError
from microslip.solved_contacts import label_along_x, slip_unit


# Spans that are shorter, in parts of the contact, have no word in them.
LEAST_NAMED = 0.12


def cut_picture(result, contacts, y=0.0):
    """The row nearest to y [mm] by each theory, or of each patch that has one in its frame."""
    reach = {key: one.cells.outline.limits()[2:] for key, one in contacts.items()}
    cells = {key: one.cells for key, one in contacts.items() if reach[key][0] <= y <= reach[key][1]}
    if not cells:
        ranges = dict.fromkeys(f"from {number(low)} to {number(high)} mm" + (f" ({label_of(key)})" if len(reach) > 1 else "")
                               for key, (low, high) in reach.items())
        raise ResultError(f"the cut at y = {number(y)} mm is outside the contact, which goes {', '.join(ranges)}")
    figure = new_figure(4.6 * len(cells) + 0.6, 5.6)
    put_title(figure, heading("Cut along x", result, cells))
    panels = figure.subplots(2, len(cells), sharex=True, sharey="row", squeeze=False, height_ratios=(1.5, 1))
    for column, (key, grid) in enumerate(cells.items()):
        row = nearest_row(grid, y)
        above, below = panels[:, column]
        draw_tractions(above, grid, row)
        draw_slip(below, grid, row)
        for axes in (above, below):
            open_axes(axes)
            shade(axes, grid, row, named=axes is above)
        above.set_title(f"{label_of(key)}, y = {number(grid.row_y[row])} mm", color=LOOKS.get(key, (INK,))[0], pad=24)
        names_above(above)
        names_above(below)
        below.set_xlabel(label_along_x(result))
    panels[0, 0].set_ylabel(f"traction on {the(bodies_of(result)[0])} [MPa]")
    panels[1, 0].set_ylabel(f"slip of {the(bodies_of(result)[0])} [{slip_unit(result)[0]}]")
    return figure


def nearest_row(grid, y):
    """The index of the row nearest to y [mm]; of two as near the lower one."""
    return int(np.argmin(np.round(np.abs(grid.row_y - y), 9)))


def draw_tractions(axes, grid, row):
    """px, py and their size as the steps that they are, under the bound; without a component that is zero by symmetry."""
    inside = grid.state[row] != 0
    x, bound = grid.x[row, inside], grid.bound[row, inside]
    axes.plot(x, bound, color=INK3, linewidth=1.2, linestyle=":", label=r"$\pm g$, the bound")
    axes.plot(x, -bound, color=INK3, linewidth=1.2, linestyle=":")
    size = np.hypot(grid.px, grid.py)
    curves = [(values, *look) for values, look in ((grid.px, (ALONG, "-", "$p_x$")), (grid.py, (ACROSS, "--", "$p_y$")))
              if not vanishing(values[row, inside], size.max())]
    if len(curves) == 2:
        curves.insert(0, (size, INK, "-", r"$|\mathbf{p}|$"))
    for values, colour, style, label in curves:
        axes.plot(x, values[row, inside], style, color=colour, linewidth=1.8, marker="." if len(x) <= 40 else "", label=label)


def draw_slip(axes, grid, row):
    """Both components of the slip, or the one that is not zero by symmetry."""
    inside = grid.state[row] != 0
    largest = np.hypot(grid.sx, grid.sy).max(initial=0)
    for values, colour, style, label in ((grid.sx, ALONG, "-", "$s_x$"), (grid.sy, ACROSS, "--", "$s_y$")):
        if not vanishing(values[row, inside], largest):
            axes.plot(grid.x[row, inside], values[row, inside], style, color=colour, linewidth=1.8,
                      marker="." if inside.sum() <= 40 else "", label=label)


def shade(axes, grid, row, named=True):
    """Where it sticks and where it slides as coloured ground, with the words in it."""
    left, right, _, _ = grid.outline.limits()
    for state, colour, word in ((ADHESION, STICKS, "sticks"), (SLIP, SLIDES, "slides")):
        for first, last in grid.spans(state, row):
            axes.axvspan(first, last, color=colour, alpha=0.22, linewidth=0)
            if named and last - first > LEAST_NAMED * (right - left):
                axes.annotate(word, ((first + last) / 2, 0.02), xycoords=("data", "axes fraction"), ha="center", va="bottom", weight="bold",
                              size="small", path_effects=halo())
