"""Pictures of one rolling contact: tractions, adhesion and slip areas, creep curve. Theories stand side by side."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.contact_cells import ADHESION, LONGEST_IN_WIDTH, SLIP, is_line_contact, read_cells
from microslip.creep_curve_picture import creep_curve_picture
from microslip.friction_law_picture import friction_law_picture
from microslip.history_picture import history_picture
from microslip.nip_picture import nip_picture
from microslip.interior_picture import interior_picture, interior_points
from microslip.picture_style import (INK, LOOKS, ROLLING, SLIDING, STICKING, THEORIES, bodies_of, halo, heading, new_figure,
                                     number, put_title, quantity, round_down, the, unit_for, with_unit)
from microslip.result_file import ResultError
from microslip.solved_contacts import rolls_backward, slip_unit, tells_direction


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
    """Tractions as arrows and as colours: blue where it sticks, orange where it slides, darker where they are larger."""
    wheel = the(bodies_of(result)[0])
    figure, panels = contact_panels(result, cells, f"Tractions on {wheel}")
    longest = max(np.hypot(grid.px, grid.py).max() for grid in cells.values())
    factor, unit = unit_for(1e6 * longest, "Pa")
    for axes, (theory, grid) in zip(panels, cells.items()):
        grid.draw_areas(axes, sizes=np.hypot(grid.px, grid.py), largest=longest)
        grid.draw_boundary(axes)
        draw_arrows(axes, cells, grid, grid.arrows(grid.px, grid.py, longest), longest,
                    lambda size: f"{number(1e6 * factor * size)} {unit}")
        name_areas(axes, grid)
        axes.set_title(totals(result, theory), color=LOOKS[theory][0])
    bars_of_areas(figure, panels, Normalize(0, 1e6 * factor * longest or 1), f"friction per area [{unit}], on {wheel}")
    return figure


def areas_picture(result, cells):
    """Adhesion and slip areas with the slip of body 1 over body 2."""
    figure, panels = contact_panels(result, cells, "Adhesion and slip areas")
    longest = max(np.hypot(grid.sx, grid.sy).max() for grid in cells.values())
    for axes, (theory, grid) in zip(panels, cells.items()):
        grid.draw_areas(axes)
        grid.draw_boundary(axes)
        draw_arrows(axes, cells, grid, grid.arrows(grid.sx, grid.sy, longest, only=SLIP), longest,
                    lambda size: f"slip {number(size)}{slip_unit(result)[1]}")
        name_areas(axes, grid)
        axes.set_title(f"{THEORIES[theory]}\n{sizes_of_areas(result, theory)}", color=LOOKS[theory][0])
    return figure


def sizes_of_areas(result, theory):
    """How large both areas are."""
    sizes = {name: 1e6 * result.number(f"/{theory}/{name}_area") for name in ("adhesion", "slip")}
    whole = sum(sizes.values())
    return ", ".join(f"{quantity(size, 'mm²')} ({100 * size / whole if whole else 0:.1f} %) {word}"
                     for size, word in zip(sizes.values(), ("stick", "slide")))


def bars_of_areas(figure, panels, norm, label):
    """Two bars of colours beside each other: friction where it sticks and where it slides."""
    slides = figure.colorbar(ScalarMappable(norm=norm, cmap=SLIDING), ax=list(panels), shrink=0.75, pad=0.01, aspect=22, label=label)
    sticks = figure.colorbar(ScalarMappable(norm=norm, cmap=STICKING), ax=list(panels), shrink=0.75, pad=0.01, aspect=22)
    sticks.ax.set_yticks([])
    for bar, word in ((sticks, "sticks"), (slides, "slides")):
        bar.ax.set_xlabel(word, rotation=90, size="small")
        bar.outline.set_visible(False)


def name_areas(axes, grid, turned=False):
    """The words sticks and slides in the middle of their areas, where these are large."""
    for state, word in ((ADHESION, "sticks"), (SLIP, "slides")):
        for middle in grid.middles_of(state):
            axes.text(*(middle[::-1] if turned else middle), word, ha="center", va="center", weight="bold", zorder=6,
                      path_effects=halo(3))


def contact_panels(result, cells, what):
    """A figure with one panel per theory or patch: axes in mm, the ellipse's outline and the rolling direction."""
    true_to_scale = all(grid.true_to_scale() for grid in cells.values())
    limits = np.abs([grid.outline.limits() for grid in cells.values()])
    half_x, half_y = 1.1 * limits[:, :2].max(), 1.16 * limits[:, 2:].max()
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
    """The arrow in the corner above the contact that shows the rolling direction."""
    tail, head = (0.17, 0.03) if backward else (0.03, 0.17)
    axes.annotate("", xy=(head, 0.95), xytext=(tail, 0.95), xycoords="axes fraction",
                  arrowprops={"arrowstyle": "-|>", "color": ROLLING, "linewidth": 2, "mutation_scale": 13, "shrinkA": 0, "shrinkB": 0})
    axes.text(0.19, 0.95, "rolls", transform=axes.transAxes, va="center", color=ROLLING, weight="bold")


def draw_arrows(axes, cells, grid, arrows, longest, key_text):
    """Arrows x, y with their components, to one scale for all theories, with a key in the corner below the contact."""
    if longest <= 0 or not len(arrows[0]):
        return
    length = max(other.arrow_length() for other in cells.values())
    if not grid.true_to_scale():
        scaling = {"angles": "uv", "scale_units": "width", "scale": longest / LONGEST_IN_WIDTH}
    else:
        scaling = {"angles": "xy", "scale_units": "xy", "scale": longest / length}
    drawn = axes.quiver(*arrows, pivot="middle", color=INK, units="width", width=0.0045, headwidth=3.6, headlength=4.2,
                        headaxislength=3.9, minlength=0.6, zorder=4, **scaling)
    key = round_down(longest)
    axes.quiverkey(drawn, 0.7, 0.05, key, key_text(key), labelpos="E", coordinates="axes",
                   fontproperties={"size": matplotlib.rcParams["legend.fontsize"]})


def totals(result, theory):
    """A theory's name and its total forces, for a title."""
    fx, fy, mz = (result.number(f"/{theory}/{name}") for name in ("fx", "fy", "mz"))
    largest = max(abs(fx), abs(fy))
    moment = largest * np.sqrt(result.number("/hertz/a") * result.number("/hertz/b"))
    return (f"{THEORIES[theory]}\n$F_x$ = {with_unit(fx, 'N', largest)},  $F_y$ = {with_unit(fy, 'N', largest)}\n"
            f"$M_z$ = {with_unit(mz, 'N m', max(abs(mz), 1e-3 * moment))}")
