"""Figures 4 and 5 of the FASTSIM2 paper: discretisation errors over the 3,220 cases, computed beside published."""

import numpy as np

from microslip.picture_style import (GRID, INK, INK3, LOOKS, SIZES_OF_LINES, THEORIES, new_figure, open_axes, put_title,
                                     round_up)

# Rms error of the simplified theory itself (table 1 of the paper, parabolic bound, three flexibilities).
THEORY_ERROR = {"fx": 0.026, "fy": 0.039}
FORCES = {"fx": "$F_x$", "fy": "$F_y$"}
# Group: marker.
MARKERS = {
    "fastsim": "o",
    "fastsim_half_step": "^",
    "fastsim2": "s",
}


def fastsim2_table2_pictures(result):
    """The pictures of a result file of kind fastsim2-table2, by file name."""
    grids = result.array("/grids").astype(int)
    return {"fastsim2_figure4.png": distributions(result, grids), "fastsim2_figure5.png": convergence(result, grids)}


def distributions(result, grids):
    """Figure 4: share of the cases whose error in Fy is below a value, one line per grid."""
    figure = new_figure(10, 4.6)
    put_title(figure, "Discretisation error in $F_y$: share of the cases below it (note the two scales)")
    figure.get_layout_engine().set(wspace=0.04)
    panels = figure.subplots(1, 2, sharey=True)
    colours = SIZES_OF_LINES(np.linspace(0, 0.92, len(grids)))
    for axes, algorithm in zip(panels, ("fastsim", "fastsim2")):
        errors = result.array(f"/{algorithm}/error_fy", dimensions=2)
        open_axes(axes)
        share = 100 * np.arange(1, errors.shape[1] + 1) / errors.shape[1]
        for grid, row, colour in zip(grids, errors, colours):
            axes.step(row, share, where="post", color=colour, linewidth=1.8, label=f"{grid} × {grid}")
        axes.set_xlim(0, round_up(np.quantile(errors[min(1, len(grids) - 1)], 0.95)))
        axes.set_ylim(0, 100)
        axes.set_xlabel(r"$|\Delta F_y|\,/\,(\mu F_n)$ [-]")
        axes.set_title(THEORIES[algorithm])
    panels[0].set_ylabel("share of the cases [%]")
    panels[1].legend(title="cells", loc="lower right", frameon=True, framealpha=0.9, edgecolor="none")
    return figure


def convergence(result, grids):
    """Figure 5: rms errors over the number of cells along each axis."""
    figure = new_figure(10, 5)
    put_title(figure, "Rms of the discretisation error over the cases")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, (force, label) in zip(panels, FORCES.items()):
        open_axes(axes)
        for algorithm, marker in MARKERS.items():
            computed = result.array(f"/{algorithm}/rms_{force}")
            colour, dashes = LOOKS[algorithm]
            axes.loglog(grids, computed, color=colour, linestyle=dashes, marker=marker, markersize=5, linewidth=1.6,
                        label=THEORIES[algorithm])
        for algorithm in ("fastsim", "fastsim2"):
            axes.loglog(grids, result.array(f"/published/{algorithm}/rms_{force}"), color=LOOKS[algorithm][0],
                        marker=MARKERS[algorithm], markersize=10, markerfacecolor="none", linestyle="none",
                        label=f"{THEORIES[algorithm]}, published")
        axes.axhline(THEORY_ERROR[force] / 10, color=INK, linewidth=1.2,
                     label="a tenth of the theory's own error")
        axes.set_xticks(grids, [str(grid) for grid in grids])
        axes.minorticks_off()
        axes.set_xlabel("cells along each axis, mx = my")
        axes.set_title(f"error in {label}")
    slopes(panels, result, grids)
    panels[0].set_ylabel(r"rms $|\Delta F|\,/\,(\mu F_n)$ [-]")
    panels[0].legend(loc="lower left")
    return figure


def slopes(panels, result, grids):
    """Triangles with the slopes of first and second order, above FASTSIM's and FASTSIM2's lines."""
    left, right = grids[-1] / 4, grids[-1] / 2
    for axes, force in zip(panels, FORCES):
        for algorithm, order in (("fastsim", 1), ("fastsim2", 2)):
            rms = np.interp(left, grids, result.array(f"/{algorithm}/rms_{force}"))
            high, low = 2.2 * rms, 2.2 * rms / (right / left) ** order
            axes.fill([left, right, right], [high, high, low], facecolor=GRID, edgecolor=INK3, linewidth=1)
            axes.annotate(str(order), (right, (high * low) ** 0.5), xytext=(4, 0), textcoords="offset points",
                          va="center", size="small")
            axes.annotate("1", ((left * right) ** 0.5, high), xytext=(0, 3), textcoords="offset points", ha="center",
                          size="small")
