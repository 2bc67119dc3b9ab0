"""Measured creep curves with fitted ones and their bands."""

import numpy as np
from matplotlib.ticker import StrMethodFormatter

from microslip.picture_style import INK2, LINES, heading, new_figure, open_axes, put_title

CONDITIONS = ("run", "rolling_speed", "normal_force")


def creep_curve_fit_pictures(result):
    """The picture of a result file of kind creep_curve_fit, by file name."""
    return {"creep_curve_fit.png": creep_curve_fit_picture(result)}


def creep_curve_fit_picture(result):
    """Points over the logarithm of the creepage; each curve with the 95 % bands of the curve and of further points; below the
    deviations of the points."""
    figure, curves, deviations = panels("Fitted creep curves", result)
    for k in range(int(result.number("/curves"))):
        colour, group = LINES[k % len(LINES)], f"/curve_{k}"
        conditions = [result.number(f"{group}/{name}") for name in CONDITIONS]
        draw_points(curves, deviations, result, conditions, colour)
        draw_curve(curves, result, group, colour, label_of(result, conditions), k == 0)
    curves.set_ylim(bottom=min(0, float(np.min(result.array("/points/coefficient")))))
    curves.legend(loc="lower right", fontsize="small")
    return figure


def panels(what, result):
    """A figure with its axes for curves and for deviations."""
    figure = new_figure(7, 6.2)
    put_title(figure, heading(what, result))
    curves, deviations = figure.subplots(2, 1, height_ratios=(3, 1), sharex=True)
    deviations.axhline(0, color=INK2, linewidth=0.8)
    curves.set_xscale("log")
    curves.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    curves.set_ylabel("adhesion coefficient [-]")
    deviations.set_ylabel("measured \N{MINUS SIGN}\ncomputed [-]")
    deviations.set_xlabel("creepage [%]")
    for axes in (curves, deviations):
        open_axes(axes)
    return figure, curves, deviations


def draw_points(curves, deviations, result, conditions, colour, number=None, marker="o", of_points=None, filled=True):
    """The points of a run, speed and load, and what they differ by from a curve: the fitted one, or that of a number. Without
    `curves` the differences alone."""
    creepage, measured, computed = result.arrays([f"/points/{name}" for name in ("creepage", "coefficient", "fitted")])
    here = np.all([values == value for values, value in zip(result.arrays([f"/points/{name}" for name in CONDITIONS]), conditions)],
                  axis=0)
    if number is not None:
        here &= result.array("/points/curve") == number
    creepage, measured, computed = creepage[here], measured[here], computed[here]
    if curves is not None:
        curves.plot(100 * creepage, measured, marker, color=of_points or colour, markersize=3.5, alpha=0.6)
    deviations.plot(100 * creepage, measured - computed, marker, color=colour, markersize=3, alpha=0.6,
                    fillstyle="full" if filled else "none")


def label_of(result, conditions):
    """What a curve is of: its run, speed and load."""
    run, speed, force = conditions
    name = result.text("/runs").split("\n")[int(run)]
    text = f"{speed:.4g} m/s, {force / 1e3:.4g} kN"
    return f"{name}: {text}" if name else text


def draw_curve(axes, result, group, colour, label, explained):
    """A curve with its bands; the first one's are in the legend."""
    x, y, half, least, largest = result.arrays(
        [f"{group}/{name}" for name in ("creepage", "coefficient", "half_width", "least_point", "largest_point")])
    axes.fill_between(100 * x, least, largest, color=colour, alpha=0.12, linewidth=0,
                      label="95 % of further points" if explained else None)
    axes.fill_between(100 * x, y - half, y + half, color=colour, alpha=0.35, linewidth=0,
                      label="95 % band of the curve" if explained else None)
    axes.plot(100 * x, y, color=colour, linewidth=1.6, label=label)
