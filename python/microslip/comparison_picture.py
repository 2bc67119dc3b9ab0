"""Two result files of rolling contacts side by side: what differs in their inputs, sizes of the tractions, a cut, totals."""

import textwrap

import matplotlib
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.compared_curves import names_of
from microslip.contact_cells import EXTERIOR
from microslip.cut_picture import nearest_row
from microslip.field_picture import field_values
from microslip.picture_style import (ACROSS, ALONG, INK3, LINE, SIZES, THEORIES, bodies_of, names_above, new_figure, number,
                                     open_axes, put_title, quantity, shown, the, unit_for)
from microslip.result_file import ResultError
from microslip.solved_contacts import by_theory, label_along_x

TOTALS = (("fx", "$F_x$", "N"), ("fy", "$F_y$", "N"), ("mz", "$M_z$", "N m"), ("slip_area", "slip area", "mm²"),
          ("frictional_power", "frictional power", "W"))
# So many inputs that differ are named.
MOST_INPUTS = 4


def main_theory(result):
    """The best theory of a file: the exact one if it is there."""
    theories = [theory for theory in reversed(THEORIES) if f"{theory}/fields" in result]
    if not theories:
        raise ResultError(f"{result.path}: no results of a theory ({', '.join(THEORIES)})")
    return theories[0]


def comparison_picture(first, second):
    """The figure: two maps to one scale, the middle rows of both, a table of totals with differences."""
    results = {"A": first, "B": second}
    theories = {key: main_theory(result) for key, result in results.items()}
    contacts = {key: by_theory(result)[theories[key]] for key, result in results.items()}
    cells = {key: contact.cells for key, contact in contacts.items()}
    values = {key: field_values(result, contacts[key], "traction") for key, result in results.items()}
    largest = max(value[cells[key].inside].max(initial=0) for key, value in values.items())
    factor, unit = unit_for(largest, "Pa")
    scale = Normalize(0, factor * largest or 1)
    figure = new_figure(11.5, 7.6)
    maps, rest = figure.subfigures(2, 1, height_ratios=(1.2, 1))
    put_title(maps, "\n".join(["Comparison of two rolling contacts", *different_inputs(first, second)]))
    panels = maps.subplots(1, 2, sharex=True, sharey=True)
    half_x, half_y = (1.12 * max(getattr(grid, axis) for grid in cells.values()) for axis in ("a", "b"))
    for axes, key, name in zip(panels, results, names_of([first, second])):
        axes.set_aspect("equal" if cells[key].true_to_scale() else "auto")
        cells[key].draw(axes, factor * values[key], cmap=SIZES, norm=scale)
        cells[key].draw_outline(axes)
        axes.set_xlim(-half_x, half_x)
        axes.set_ylim(-half_y, half_y)
        axes.set_title(textwrap.fill(f"{key}: {name}, {THEORIES[theories[key]]}", 44))
        axes.set_xlabel(label_along_x(results[key]))
    panels[0].set_ylabel("y [mm]")
    maps.colorbar(ScalarMappable(norm=scale, cmap=SIZES), ax=panels, label=rf"size of the traction $|\mathbf{{p}}|$ [{unit}]",
                  shrink=0.9, pad=0.02)
    cut, table = rest.subplots(1, 2, width_ratios=(1, 1.05))
    draw_cuts(cut, cells, the(bodies_of(first)[0]))
    draw_totals(table, results, theories)
    return figure


def different_inputs(first, second):
    """The inputs that differ, in a line; none if there are none."""
    inputs = [result.scalars_of("/inputs") for result in (first, second)]
    names = [name for name in inputs[0] if name in inputs[1] and inputs[0][name] != inputs[1][name]]
    texts = []
    for name in names[:MOST_INPUTS]:
        unit = first.unit(f"/inputs/{name}") if isinstance(inputs[0][name], float) else "-"
        values = [number(one[name]) if isinstance(one[name], float) else one[name] for one in inputs]
        texts.append(f"{name.replace('/', '.')} = {values[0]} (A), {values[1]} (B)" + (f" {unit}" if unit != "-" else ""))
    more = len(names) - MOST_INPUTS
    return ["; ".join(texts) + (f", and {more} more" if more > 0 else "")] if texts else []


def draw_cuts(axes, cells, body):
    """px and py along the rows nearest to y = 0."""
    open_axes(axes)
    for name, colour, label in (("px", ALONG, "$p_x$"), ("py", ACROSS, "$p_y$"), ("bound", INK3, "$g$, the bound")):
        for (key, grid), style in zip(cells.items(), ("-", "--")):
            row = nearest_row(grid, 0)
            inside = grid.state[row] != EXTERIOR
            axes.plot(grid.x[row, inside], getattr(grid, name)[row, inside], style, color=colour, linewidth=1.8, label=f"{key}: {label}")
    axes.set_xlabel("x [mm], along the row nearest to y = 0")
    axes.set_ylabel(f"traction on {body} [MPa]")
    names_above(axes, most=3, fontsize="small")


def draw_totals(axes, results, theories):
    """A table of totals and the differences B - A."""
    axes.axis("off")
    rows = []
    forces = max(abs(result.number(f"/{theories[key]}/{name}")) for key, result in results.items() for name in ("fx", "fy"))
    for name, label, unit in TOTALS:
        one, other = (result.number(f"/{theories[key]}/{name}") for key, result in results.items())
        if unit == "N":
            one, other = (float(shown(value, forces)) for value in (one, other))
        factor, printed = (1e6, unit) if unit == "mm²" else unit_for(max(abs(one), abs(other)), unit)
        rows.append([label] + [quantity(factor * value, printed) for value in (one, other, other - one)])
    heads = [f"on {the(bodies_of(results['A'])[0])}", "A", "B", "B \N{MINUS SIGN} A"]
    table = axes.table(cellText=rows, colLabels=heads, cellLoc="right", edges="horizontal", bbox=(0, 0.1, 1, 0.86),
                       colWidths=(0.31, 0.23, 0.23, 0.23))
    table.auto_set_font_size(False)
    table.set_fontsize(0.92 * matplotlib.rcParams["legend.fontsize"])
    for cell in table.get_celld().values():
        cell.set_edgecolor(LINE)
