"""Figure 3 of the FASTSIM2 paper: differences of FASTSIM2's forces to those of exact theory over the 3,220 cases."""

import numpy as np

from microslip.picture_style import ACROSS, ALONG, new_figure, open_axes, put_title, round_up

FORCES = {"fx": ("$F_x$", ALONG), "fy": ("$F_y$", ACROSS)}
BOUNDS = {"parabolic": ("parabolic bound", "-"), "elliptic": ("elliptic bound", "--")}
FLEXIBILITIES = {"three": "three flexibilities", "one": "one flexibility", "blended": "blended flexibilities"}
# Of the printed 80 % and 95 %.
BOUND_MARKERS = {"parabolic": "o", "elliptic": "s"}


def fastsim2_table1_pictures(result):
    """The picture of a result file of kind fastsim2-table1, by file name."""
    figure = new_figure(12, 4.6)
    put_title(figure, "FASTSIM2 on 640 × 640 cells against exact theory: share of the cases with a smaller difference")
    panels = figure.subplots(1, len(FLEXIBILITIES), sharey=True, sharex=True)
    largest = 0
    for axes, (flexibility, title) in zip(panels, FLEXIBILITIES.items()):
        open_axes(axes)
        for bound in BOUNDS:
            for force in FORCES:
                draw_distribution(axes, result, f"{flexibility}_{bound}", bound, force)
                largest = max(largest, result.number(f"/{flexibility}_{bound}/p95_{force}"))
        axes.set_title(title)
        axes.set_xlabel(r"$|\Delta F|\,/\,(\mu F_n)$ [-]")
    panels[0].set_xlim(0, round_up(largest))
    panels[0].locator_params(axis="x", nbins=5)
    panels[0].set_ylim(0, 100)
    panels[0].set_ylabel("share of the cases [%]")
    panels[0].legend(loc="lower right", frameon=True, framealpha=0.9, edgecolor="none")
    return {"fastsim2_figure3.png": figure}


def draw_distribution(axes, result, variant, bound, force):
    """Draw one line, with the published 80 % and 95 % as open markers where there are any."""
    label, colour = FORCES[force]
    name, dashes = BOUNDS[bound]
    errors = result.array(f"/{variant}/error_{force}")
    share = 100 * np.arange(1, len(errors) + 1) / len(errors)
    axes.step(errors, share, where="post", color=colour, linestyle=dashes, linewidth=1.7, label=f"{label}, {name}")
    if f"/published/{variant}" not in result:
        return
    for percent in (80, 95):
        axes.plot(result.number(f"/published/{variant}/p{percent}_{force}"), percent, color=colour,
                  marker=BOUND_MARKERS[bound], markersize=8, markerfacecolor="none", linestyle="none",
                  label=f"{label}, {name}, published" if percent == 80 else None)
