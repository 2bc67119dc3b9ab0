"""Figures 1 to 8 of the refinement paper: its test of steady rolling, without and with the leading edge's correction."""

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from microslip.picture_style import (ACROSS, ALONG, GREEN, INK, INK3, LOOKS, MAGENTA, RED, SIZES_OF_LINES, SLIDES, STICKS,
                                     new_figure, open_axes, put_title)

FORCE = r"$-F_x\,/\,(\mu F_n)$ [-]"
MARKERS = "o^sDvP"
# Group: label, colour, dashes.
TRACTIONS = {
    "plain_1": (r"$\delta q = \delta x$", INK, "-"),
    "plain_5": (r"$\delta q = 5\,\delta x$", ALONG, "-"),
    "corrected_1": (r"$\delta q = \delta x$, corrected", RED, "-"),
    "corrected_5": (r"$\delta q = 5\,\delta x$, corrected", ALONG, "--"),
}
EDGES = {
    "plain": ("without correction", INK),
    "theta_35": (r"$\theta = 0.35$", ACROSS),
    "theta_50": (r"$\theta = 0.5$", ALONG),
    "theta_65": (r"$\theta = 0.65$", MAGENTA),
    "theta_80": (r"$\theta = 0.8$", GREEN),
    "true_edge": ("true edge", INK3),
}
STATES = {1: ("sticks", STICKS), 2: ("slides", SLIDES)}


def refinement_pictures(result):
    """The pictures of a result file of kind refinement, by file name."""
    return {
        "refinement_figure1.png": draw_creep_curve(result),
        "refinement_figures_2_6.png": draw_steps(result),
        "refinement_figures_3_4.png": draw_tractions(result),
        "refinement_figure5.png": draw_divisions(result),
        "refinement_figures_7_8.png": draw_convergence(result),
    }


def draw_creep_curve(result):
    """Figure 1."""
    figure = new_figure(6.4, 4.4)
    axes = figure.subplots()
    open_axes(axes)
    scaled = result.array("/creep_curve/scaled")
    for group, label, colour, dashes in (("plain", "exact theory", *LOOKS["exact"]),
                                         ("corrected", "exact theory, leading edge corrected", ALONG, (0, (1, 1.4))),
                                         ("fastsim2", "FASTSIM2, 50 × 50 cells", *LOOKS["fastsim2"])):
        axes.plot(scaled, result.array(f"/creep_curve/{group}"), color=colour, linestyle=dashes, linewidth=1.7,
                  label=label)
    axes.plot(0.7, result.number("/limit"), "o", color=INK, markerfacecolor="none", label="the test: limit")
    axes.set_title("Figure 1: longitudinal creepage, 51 elements across")
    axes.set_xlabel("scaled creepage $V_p$ [-]")
    axes.set_ylabel(FORCE)
    axes.set_xlim(0)
    axes.set_ylim(0)
    axes.legend(loc="lower right")
    return figure


def draw_steps(result):
    """Figures 2 and 6."""
    figure = new_figure(11, 4.4)
    panels = figure.subplots(1, 2, sharey=True)
    steps, grids = result.array("/steps/step"), result.array("/steps/grids")
    for axes, group, title in zip(panels, ("plain", "corrected"), ("Figure 2: without the correction at the leading edge",
                                                                   r"Figure 6: with it, $\theta = 0.5$")):
        open_axes(axes)
        for row, across, colour, marker in zip(result.array(f"/steps/{group}", dimensions=2), grids,
                                               SIZES_OF_LINES(np.linspace(0, 1, len(grids))), MARKERS):
            axes.plot(steps, row, color=colour, marker=marker, markersize=5, label=f"{across:.0f} × {across:.0f}")
        axes.axhline(result.number("/limit"), color=INK3, linestyle="--", linewidth=1.2, label="limit")
        axes.set_title(title)
        axes.set_xlabel(r"$\delta q\,/\,\delta x$ [-]")
        axes.set_xlim(0)
    panels[0].set_ylabel(FORCE)
    panels[0].legend(loc="upper left")
    return figure


def draw_tractions(result):
    """Figures 3 and 4."""
    figure = new_figure(11, 4.4)
    panels = figure.subplots(1, 2, sharey=True)
    x, bound = result.arrays(["/fields/x", "/fields/bound"])
    for axes, groups, title in zip(panels, (("plain_5", "plain_1"), ("plain_1", "corrected_1", "corrected_5")),
                                   ("Figure 3: without the correction at the leading edge", "Figure 4: with it")):
        open_axes(axes)
        axes.plot(1e3 * x, bound, color=INK3, linewidth=1, linestyle=":", label="traction bound")
        for group in groups:
            label, colour, dashes = TRACTIONS[group]
            axes.plot(1e3 * x, -result.array(f"/fields/{group}/px"), color=colour, linestyle=dashes, linewidth=1.5,
                      label=label)
        axes.set_title(title)
        axes.set_xlabel("$x$ [mm], rolling to the right")
        axes.legend(loc="upper right")
    panels[0].set_ylabel(r"$-p_x\,/\,(\mu p_0)$ at $y = 0$ [-]")
    panels[0].set_ylim(0, 1.35)
    return figure


def draw_divisions(result):
    """Figure 5."""
    figure = new_figure(7.4, 6.4)
    panels = figure.subplots(1, 2, sharey=True)
    x, y = result.array("/fields/x"), result.array("/fields/y")
    half_x, half_y = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    extent = 1e3 * np.array([x[0] - half_x, x[-1] + half_x, y[0] - half_y, y[-1] + half_y])
    colours = ListedColormap([colour for _, colour in STATES.values()])
    for axes, group, title in zip(panels, ("plain_1", "corrected_1"), ("without the correction", "with it")):
        state = result.array(f"/fields/{group}/state", dimensions=2)
        axes.imshow(np.ma.masked_equal(state, 0), origin="lower", extent=extent, aspect="auto", cmap=colours, vmin=0.5,
                    vmax=2.5, interpolation="nearest")
        axes.set_title(f"{title}\n{slip_ahead(state)} elements of slip ahead of adhesion")
        axes.set_xlabel("$x$ [mm], rolling to the right")
    panels[0].set_ylabel("$y$ [mm]")
    put_title(figure, r"Figure 5: element divisions, $\delta q = \delta x$")
    panels[0].legend(handles=[Patch(color=colour, label=label) for label, colour in STATES.values()], loc="lower left")
    panels[0].set_ylim(1.25 * extent[2], 1.05 * extent[3])
    return figure


def slip_ahead(state):
    """Number of elements of slip with adhesion behind them in their row."""
    return int(np.sum((state == 2) & np.logical_or.accumulate(state == 1, axis=1)))


def draw_convergence(result):
    """Figures 7 and 8."""
    figure = new_figure(11, 4.6)
    load, force = figure.subplots(1, 2)
    grids = result.array("/load/grids")
    for group, label, colour, marker in (("tight", "tight grid", ALONG, "o"),
                                         ("shifted", "shifted by half an element", MAGENTA, "^")):
        load.loglog(grids, result.array(f"/load/{group}"), color=colour, marker=marker, markersize=5, label=label)
        load.loglog(grids, result.array(f"/load/bilinear_{group}"), color=colour, marker=marker, markersize=5,
                    linestyle=":", fillstyle="none", label=f"{label}, bilinear")
    draw_order(load, grids, 2, 0.3 * result.array("/load/shifted")[0])
    load.set_title("Figure 7: normal force, approach given")
    load.set_ylabel(r"$|\Delta F_n|\,/\,F_n$ [-]")
    load.set_xlabel("elements across [-]")
    load.legend(loc="upper right")
    size = 1 / result.array("/edge/grids")
    for (group, (label, colour)), marker in zip(EDGES.items(), MARKERS):
        force.plot(size, result.array(f"/edge/{group}"), color=colour, marker=marker, markersize=5, label=label)
        force.plot(size, result.array(f"/edge/bilinear_{group}"), color=colour, marker=marker, markersize=5,
                   linestyle=":", fillstyle="none")
    force.axhline(result.number("/limit"), color=INK3, linestyle="--", linewidth=1.2, label="limit")
    force.set_title(r"Figure 8: longitudinal force, $\delta q = \delta x$; dotted: bilinear elements")
    force.set_ylabel(FORCE)
    force.set_xlabel("1 / elements across [-]")
    force.set_xlim(0)
    force.legend(loc="upper left", ncols=2)
    low, high = force.get_ylim()
    force.set_ylim(low, high + 0.35 * (high - low))
    for axes in (load, force):
        open_axes(axes)
    return figure


def draw_order(axes, grids, order, start):
    """A line that falls with an order."""
    falling = start * (grids / grids[0]) ** -order
    axes.loglog(grids, falling, color=INK3, linestyle=":", linewidth=1)
    axes.annotate(f"order {order:g}", (grids[-1], falling[-1]), xytext=(-12, 0), textcoords="offset points",
                  ha="right", va="center", color=INK3, size="small")
