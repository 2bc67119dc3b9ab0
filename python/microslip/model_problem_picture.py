"""The 1-D model problem of the FASTSIM2 paper (F20): displacement and slip, exact and by three strategies."""

import numpy as np

from microslip.picture_style import ACROSS, GRID, INK, INK3, LOOKS, new_figure, open_axes, put_title

CASES = {
    "case1": "case 1: parabolic bound, small spin",
    "case2": "case 2: parabolic bound, large spin",
    "case3": "case 3: elliptic bound",
}
# Group: name, colour, marker, its size; FASTSIM takes the first step, FASTSIM2 the last one.
STRATEGIES = {
    "backward_euler": ("backward Euler", LOOKS["fastsim"][0], "^", 6),
    "theta_method": ("theta method", ACROSS, "D", 5),
    "tracked": ("tracked boundaries", LOOKS["fastsim2"][0], "o", 5),
}


def model_problem_pictures(result):
    """The picture of a result file of kind model-problem, by file name."""
    figure = new_figure(12, 7)
    put_title(figure, "1-D model problem: du/dx = s $-$ w, |u| bounded, particles enter at x = 0")
    panels = figure.subplots(2, len(CASES), sharex=True)
    for column, (case, title) in enumerate(CASES.items()):
        draw_case(panels[:, column], result, case)
        panels[0, column].set_title(title)
        panels[1, column].set_xlabel("x [-]")
    panels[0, 0].set_ylabel("displacement u [-]")
    panels[1, 0].set_ylabel("slip s [-]")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    panels[1, 0].legend(handles, labels, loc="best")
    return {"model_problem.png": figure}


def draw_case(panels, result, case):
    """Displacement above, slip below."""
    x, u, bound = result.arrays([f"/{case}/{name}" for name in ("x_exact", "u_exact", "u_max")])
    s = result.arrays([f"/{case}/x_exact", f"/{case}/s_exact"], finite=False)[1]
    for axes in panels:
        open_axes(axes)
    panels[0].fill_between(x, -bound, bound, color=GRID, alpha=0.6, linewidth=0)
    panels[0].plot(x, bound, "--", color=INK3, linewidth=1.2, label="bound on |u|")
    panels[0].plot(x, -bound, "--", color=INK3, linewidth=1.2)
    for axes, exact in zip(panels, (u, s)):
        axes.plot(x, exact, color=INK, linewidth=1.6, label="exact")
    slips = [np.quantile(s[np.isfinite(s)], (0.02, 0.98))]
    for strategy, (name, colour, marker, size) in STRATEGIES.items():
        x, u, s = result.arrays([f"/{case}/{strategy}/{quantity}" for quantity in ("x", "u", "s")])
        slips.append(s)
        for axes, computed in zip(panels, (u, s)):
            axes.plot(x, computed, color=colour, marker=marker, markersize=size, markerfacecolor="none",
                      markeredgewidth=1.4, linewidth=0.8, linestyle=":", label=name)
    show_slip_within(panels[1], np.concatenate(slips))


def show_slip_within(axes, values):
    """Limits the slip axis: with the elliptic bound the exact slip is infinite at the trailing edge."""
    margin = 0.06 * (values.max() - values.min()) or 1
    axes.set_ylim(values.min() - margin, values.max() + margin)
