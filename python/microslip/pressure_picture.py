"""Pressures of contacts side by side, up to their outlines, with the tractions on body 1 as arrows."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.picture_style import INK, SIZES, halo, new_figure, number, put_title, unit_for


def pressure_picture(title, grids, titles):
    """The figure of contacts with one scale of colours and of arrows; `titles` of the panels."""
    wide = max(grid.a / grid.b for grid in grids)
    figure = new_figure(1.6 + (4.6 if wide < 1.6 else 6) * len(grids), 5.2 if wide < 1.6 else 4.0)
    put_title(figure, title)
    panels = figure.subplots(1, len(grids), squeeze=False)[0]
    highest = max(grid.pressure.max() for grid in grids)
    longest = max(np.hypot(grid.px, grid.py).max() for grid in grids)
    scale, unit = unit_for(1e6 * highest, "Pa")
    scale *= 1e6
    colours = Normalize(0, scale * highest or 1)
    for axes, grid, text in zip(panels, grids, titles):
        draw_panel(axes, grid, scale, colours, longest)
        axes.set_title(f"{text}\n$|\\mathbf{{p}}|$ at most {number(scale * np.hypot(grid.px, grid.py).max())} {unit}")
    panels[0].set_ylabel("y [mm]")
    figure.colorbar(ScalarMappable(norm=colours, cmap=SIZES), ax=list(panels), label=f"pressure [{unit}]", shrink=0.85)
    return figure


def draw_panel(axes, grid, scale, colours, longest):
    """A contact within its limits."""
    left, right, low, high = grid.outline.limits()
    axes.set_xlim(left - 0.1 * grid.a, right + 0.1 * grid.a)
    axes.set_ylim(low - 0.1 * grid.b, high + 0.1 * grid.b)
    axes.set_aspect("equal" if grid.true_to_scale() else "auto")
    axes.set_xlabel("x [mm]" if grid.true_to_scale() else "x [mm] (not to the scale of y)")
    grid.draw(axes, scale * grid.pressure, cmap=SIZES, norm=colours)
    grid.draw_boundary(axes)
    grid.draw_outline(axes)
    if longest > 0:
        axes.quiver(*grid.arrows(grid.px, grid.py, longest), color=INK, pivot="mid", angles="uv", scale_units="width",
                    scale=longest / 0.07, width=0.005, zorder=4, path_effects=halo(1.6))
