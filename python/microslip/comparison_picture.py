"""Two result files of rolling contacts side by side: sizes of the tractions, a cut through both, their totals."""

from matplotlib.cm import ScalarMappable

from microslip.contact_cells import EXTERIOR, read_cells
from microslip.cut_picture import nearest_row
from microslip.field_picture import colours_of, draw_field, field_values
from microslip.picture_style import BLACK, BLUE, THEORIES, VERMILION, new_figure, open_axes, quantity
from microslip.result_file import ResultError

TOTALS = (("fx", "$F_x$", 1e-3, "kN"), ("fy", "$F_y$", 1e-3, "kN"), ("mz", "$M_z$", 1, "N m"),
          ("slip_area", "slip area", 1e6, "mm²"), ("frictional_power", "frictional power", 1, "W"))


def main_theory(result):
    """The best theory of a file: the exact one if it is there."""
    theories = [theory for theory in reversed(THEORIES) if theory in result]
    if not theories:
        raise ResultError(f"{result.path}: no results of a theory ({', '.join(THEORIES)})")
    return theories[0]


def comparison_picture(first, second):
    """The figure: two maps to one scale, the middle rows of both, a table of totals with differences."""
    results = {"A": first, "B": second}
    theories = {key: main_theory(result) for key, result in results.items()}
    cells = {key: read_cells(result, theories[key]) for key, result in results.items()}
    values = {key: field_values(result, theories[key], "traction") for key, result in results.items()}
    colours = colours_of("traction", cells, values)
    figure = new_figure(11.5, 8.2)
    figure.suptitle("Comparison of two rolling contacts")
    maps, rest = figure.subfigures(2, 1, height_ratios=(1.15, 1))
    panels = maps.subplots(1, 2, sharex=True, sharey=True)
    half_x, half_y = (1.12 * max(getattr(grid, axis) for grid in cells.values()) for axis in ("a", "b"))
    for axes, key in zip(panels, results):
        draw_field(axes, cells[key], values[key], colours)
        axes.set_xlim(-half_x, half_x)
        axes.set_ylim(-half_y, half_y)
        axes.set_aspect("equal" if cells[key].true_to_scale() else "auto")
        axes.set_title(f"{key}: {results[key].attribute('title', 'rolling contact')}, {THEORIES[theories[key]]}")
        axes.set_xlabel(f"x [mm], rolling to the {'left' if results[key].text('/inputs/direction') == 'backward' else 'right'}")
    panels[0].set_ylabel("y [mm]")
    maps.colorbar(ScalarMappable(norm=colours[1], cmap=colours[0]), ax=panels, label=r"size of the traction $|\mathbf{p}|$ [MPa]",
                  shrink=0.9, pad=0.02)
    cut, table = rest.subplots(1, 2, width_ratios=(1.1, 1))
    draw_cuts(cut, cells)
    draw_totals(table, results, theories)
    return figure


def draw_cuts(axes, cells):
    """px and py along the rows nearest to y = 0."""
    open_axes(axes)
    for (key, grid), style in zip(cells.items(), ("-", "--")):
        row = nearest_row(grid, 0)
        inside = grid.state[row] != EXTERIOR
        for values, colour, label in ((grid.px, BLUE, "$p_x$"), (grid.py, VERMILION, "$p_y$"), (grid.bound, BLACK, "$g$")):
            axes.plot(grid.x[row, inside], values[row, inside], style, color=colour, linewidth=1.8, label=f"{key}: {label}")
    axes.set_xlabel("x [mm], along the row nearest to y = 0")
    axes.set_ylabel("traction on the wheel [MPa]")
    axes.legend(loc="best", ncols=2, fontsize=8, frameon=True, framealpha=0.8, edgecolor="none")


def draw_totals(axes, results, theories):
    """A table of totals and the differences B - A."""
    axes.axis("off")
    rows = []
    for name, label, factor, unit in TOTALS:
        one, other = (factor * results[key].number(f"/{theories[key]}/{name}") for key in results)
        rows.append([label, quantity(one, unit), quantity(other, unit), quantity(other - one, unit)])
    table = axes.table(cellText=rows, colLabels=["on the wheel", "A", "B", "B \N{MINUS SIGN} A"], loc="center", cellLoc="right")
    table.auto_set_font_size(False)
    table.set_fontsize(9)
    table.scale(1, 1.5)
