"""Pictures of one rolling contact: tractions, adhesion and slip areas, creep curve. Theories stand side by side."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from microslip.contact_cells import HATCH, SLIP, is_line_contact, read_cells
from microslip.creep_curve_picture import creep_curve_picture
from microslip.friction_law_picture import friction_law_picture
from microslip.history_picture import history_picture
from microslip.nip_picture import nip_picture
from microslip.interior_picture import interior_picture, interior_points
from microslip.picture_style import (BLACK, GREY, ORANGE, SKY_BLUE, THEORIES, bodies_of, heading, new_figure, number, put_title,
                                     quantity, round_down, the, unit_for, with_unit)
from microslip.result_file import ResultError
from microslip.solved_contacts import rolls_backward, slip_unit, tells_direction

# The light part of a map of one hue: black arrows stand out on all of it.
BOUND_COLOURS = ListedColormap(matplotlib.colormaps["YlGnBu"](np.linspace(0.1, 0.58, 256)))


def rolling_contact_pictures(result):
    """The pictures of a result file of kind rolling_contact, by file name."""
    theories = [theory for theory in THEORIES if theory in result]
    if not theories:
        raise ResultError(f"{result.path}: no results of a theory ({', '.join(THEORIES)})")
    cells = {theory: read_cells(result, theory) for theory in theories if f"{theory}/fields" in result}  # tables have none
    figures = {}
    is_line = "exact" in cells and is_line_contact(result, "exact")
    if cells and not is_line:
        figures = {"tractions.png": tractions_picture(result, cells), "areas.png": areas_picture(result, cells)}
    if "creep_curve" in result:
        with_curve = [theory for theory in theories if f"creep_curve/{theory}" in result]
        figures["creep_curve.png"] = creep_curve_picture(result, with_curve)
    if "friction_law" in result:
        figures["friction_law.png"] = friction_law_picture(result)
    if "nip" in result:
        figures["nip.png"] = nip_picture(result, cells["exact"])
    if "exact/history" in result:
        figures["history.png"] = history_picture(result)
    if "interior/von_mises" in result:
        figures["interior.png"] = interior_picture(heading("Von Mises' stress inside the bodies", result), [interior_points(result, "/interior")])
    return figures


def tractions_picture(result, cells):
    """Traction vectors on body 1 over the traction bound."""
    figure, panels = contact_panels(result, cells, f"Tractions on {the(bodies_of(result)[0])}")
    highest = max(grid.bound.max() for grid in cells.values())
    factor, unit = unit_for(1e6 * highest, "Pa")
    scale = Normalize(0, 1e6 * factor * highest or 1)
    longest = max(np.hypot(grid.px, grid.py).max() for grid in cells.values())
    for axes, (theory, grid) in zip(panels, cells.items()):
        grid.draw(axes, 1e6 * factor * grid.bound, cmap=BOUND_COLOURS, norm=scale)
        grid.draw_boundary(axes)
        draw_arrows(axes, cells, grid, (grid.px, grid.py), grid.sample(), longest,
                    lambda size: f"traction {number(1e6 * factor * size)} {unit}")
        axes.set_title(totals(result, theory))
        if grid.has_boundary():
            line = Line2D([], [], color=BLACK, linewidth=2, label="between adhesion\nand slip")
            axes.legend(handles=[line], loc="lower right")
    figure.colorbar(ScalarMappable(norm=scale, cmap=BOUND_COLOURS), ax=panels, label=f"traction bound [{unit}]", shrink=0.8, pad=0.02)
    return figure


def areas_picture(result, cells):
    """Adhesion and slip areas with the slip of body 1 over body 2."""
    figure, panels = contact_panels(result, cells, "Adhesion and slip areas")
    longest = max(np.hypot(grid.sx, grid.sy).max() for grid in cells.values())
    for axes, (theory, grid) in zip(panels, cells.items()):
        grid.draw_areas(axes)
        grid.draw_boundary(axes)
        draw_arrows(axes, cells, grid, (grid.sx, grid.sy), grid.sample() & (grid.state == SLIP), longest,
                    lambda size: f"slip {number(size)}{slip_unit(result)[1]}")
        axes.set_title(THEORIES[theory])
        axes.legend(handles=area_patches(result, theory), loc="lower right")
    return figure


def area_patches(result, theory):
    """Legend entries with the size of each area."""
    sizes = {name: 1e6 * result.number(f"/{theory}/{name}_area") for name in ("adhesion", "slip")}
    whole = sum(sizes.values())
    looks = {"adhesion": {"facecolor": SKY_BLUE}, "slip": {"facecolor": ORANGE, **HATCH}}
    return [Patch(label=f"{name} {quantity(size, 'mm²')} ({100 * size / whole if whole else 0:.1f} %)", **looks[name])
            for name, size in sizes.items()]


def contact_panels(result, cells, what):
    """A figure with one panel per theory or patch: axes in mm, the ellipse's outline and the rolling direction."""
    true_to_scale = all(grid.true_to_scale() for grid in cells.values())
    limits = np.abs([grid.outline.limits() for grid in cells.values()])
    half_x, half_y = 1.1 * limits[:, :2].max(), 1.42 * limits[:, 2:].max()
    if true_to_scale:
        half_x, half_y = max(half_x, half_y / 1.25), max(half_y, half_x / 1.6)
    width = 4.8
    height = width * (half_y / half_x if true_to_scale else 1)
    figure = new_figure(width * len(cells) + 1.7, height + 1.5, layout="compressed")
    put_title(figure, heading(what, result, cells))
    panels = figure.subplots(1, len(cells), sharey=True, squeeze=False)[0]
    for axes, one in zip(panels, cells.values()):
        axes.set_xlim(-half_x, half_x)
        axes.set_ylim(-half_y, half_y)
        axes.set_aspect("equal" if true_to_scale else "auto")
        axes.set_xlabel("x [mm]" if true_to_scale else "x [mm] (not to the scale of y)")
        one.draw_outline(axes)
        if tells_direction(result):
            rolling_arrow(axes, rolls_backward(result))
    panels[0].set_ylabel("y [mm]")
    return figure, panels


def rolling_arrow(axes, backward):
    """The big arrow above the contact that shows the rolling direction."""
    tail, head = (0.72, 0.28) if backward else (0.28, 0.72)
    axes.annotate("", xy=(head, 0.945), xytext=(tail, 0.945), xycoords="axes fraction",
                  arrowprops={"arrowstyle": "simple,head_length=1.1,head_width=1.5,tail_width=0.95",
                              "mutation_scale": 16, "facecolor": GREY, "edgecolor": "none"})
    axes.text(0.5, 0.943, "rolling direction", transform=axes.transAxes, ha="center", va="center", fontsize=9,
              color="white", fontweight="bold")


def draw_arrows(axes, cells, grid, vectors, chosen, longest, key_text):
    """Vectors as arrows at the chosen cells, to one scale for all theories, with a key."""
    if longest <= 0 or not chosen.any():
        return
    length = max(other.arrow_length() for other in cells.values())
    if not grid.true_to_scale():
        scaling = {"angles": "uv", "scale_units": "width", "scale": longest / 0.08}
    else:
        scaling = {"angles": "xy", "scale_units": "xy", "scale": longest / length}
    drawn = axes.quiver(grid.x[chosen], grid.y[chosen], vectors[0][chosen], vectors[1][chosen], pivot="middle",
                        color=BLACK, units="dots", width=2.2, headwidth=4, headlength=5, headaxislength=4.5,
                        minlength=0.6, zorder=4, **scaling)
    key = round_down(longest)
    axes.quiverkey(drawn, 0.12, 0.06, key, key_text(key), labelpos="E", coordinates="axes",
                   fontproperties={"size": 9})


def totals(result, theory):
    """A theory's name and its total forces, for a title."""
    fx, fy, mz = (result.number(f"/{theory}/{name}") for name in ("fx", "fy", "mz"))
    largest = max(abs(fx), abs(fy))
    moment = largest * np.sqrt(result.number("/hertz/a") * result.number("/hertz/b"))
    return (f"{THEORIES[theory]}\n$F_x$ = {with_unit(fx, 'N', largest)},  $F_y$ = {with_unit(fy, 'N', largest)},  "
            f"$M_z$ = {with_unit(mz, 'N m', max(abs(mz), 1e-3 * moment))}")
