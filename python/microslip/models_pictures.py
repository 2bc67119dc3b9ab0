"""Models beside the exact theory: their errors, a panel for each number, a row for each model."""

from pathlib import Path

import numpy as np

from microslip.picture_style import GRID, SERIES, new_figure, open_axes, put_title

MARKERS = "osD^v<"
ROW = 0.28  # inches


def models_pictures(result):
    """The picture of a result file of kind models, by file name."""
    groups = [f"/panels/{k}" for k in range(1, 100) if f"/panels/{k}" in result]
    names = result.text(f"{groups[0]}/models").split("\n")
    figure = new_figure(4.2 + 2.4 * len(groups), 1.6 + ROW * len(names))
    put_title(figure, result.attribute("title"))
    panels = figure.subplots(1, len(groups), sharey=True, squeeze=False)[0]
    for axes, group in zip(panels, groups):
        draw_errors(axes, result, group)
    panels[0].set_yticks(range(len(names)), names)
    panels[0].set_ylim(len(names) - 0.5, -0.5)
    panels[-1].legend(loc="upper left", bbox_to_anchor=(1.02, 1))
    return {f"{Path(result.path).stem}.png": figure}


def draw_errors(axes, result, group):
    """Draw one panel."""
    open_axes(axes)
    series = result.text(f"{group}/series").split("\n")
    errors = result.array(f"{group}/errors", dimensions=2, finite=False)
    rows = np.arange(len(errors))
    axes.hlines(rows, np.nanmin(errors, axis=1), np.nanmax(errors, axis=1), color=GRID, linewidth=3, zorder=1)
    for k, name in enumerate(series):
        axes.plot(errors[:, k], rows, color=SERIES[k % len(SERIES)], marker=MARKERS[k % len(MARKERS)], markersize=4.5,
                  linestyle="none", label=name, zorder=2)
    axes.set_xscale("log")
    axes.grid(axis="x")
    axes.tick_params(axis="y", length=0)
    axes.set_title(result.text(f"{group}/title"))
    axes.set_xlabel("error [-]")
