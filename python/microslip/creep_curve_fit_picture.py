"""Measured creep curves with fitted ones and their bands, or with those of a case."""

import numpy as np
from matplotlib.ticker import StrMethodFormatter

from microslip.picture_style import BLUE, GREEN, GREY, ORANGE, SKY_BLUE, VERMILION, heading, new_figure, open_axes, put_title

COLOURS = (BLUE, VERMILION, GREEN, ORANGE, SKY_BLUE, GREY)
CONDITIONS = ("run", "rolling_speed", "normal_force")


def creep_curve_fit_pictures(result):
    """The picture of a result file of kind creep_curve_fit, by file name."""
    return {"creep_curve_fit.png": creep_curve_fit_picture(result)}


def measured_points_pictures(result):
    """The picture of a result file of kind measured_points, by file name."""
    return {"measured_points.png": measured_points_picture(result)}


def creep_curve_fit_picture(result):
    """Points over the logarithm of the creepage; each curve with the 95 % bands of the curve and of further points; below the
    deviations of the points."""
    figure, curves, deviations = panels("Fitted creep curves", result)
    for k in range(int(result.number("/curves"))):
        colour, group = COLOURS[k % len(COLOURS)], f"/curve_{k}"
        conditions = [result.number(f"{group}/{name}") for name in CONDITIONS]
        draw_points(curves, deviations, result, conditions, colour)
        draw_curve(curves, result, group, colour, label_of(result, conditions), k == 0)
    curves.set_ylim(bottom=min(0, float(np.min(result.array("/points/coefficient")))))
    curves.legend(loc="best")
    return figure


def measured_points_picture(result):
    """Points with the curve of a case through what it has at their creepages; below the deviations of the points."""
    figure, curves, deviations = panels("Measured points", result)
    every = list(zip(*result.arrays([f"/points/{name}" for name in CONDITIONS])))
    if "/curves" in result:
        draw_sweep(curves, deviations, result, every)
        every = []
    for k, conditions in enumerate(sorted(set(every), key=every.index)):
        colour = COLOURS[k % len(COLOURS)]
        creepage, computed = draw_points(curves, deviations, result, conditions, colour)
        order = np.argsort(creepage)
        curves.plot(100 * creepage[order], computed[order], color=colour, linewidth=1.6, label=label_of(result, conditions))
    curves.set_title(f"rms {result.number('/rms'):.4f}, bias {result.number('/bias'):.4f}")
    curves.set_ylim(bottom=min(0, float(np.min(result.array("/points/coefficient")))))
    curves.legend(loc="best")
    return figure


def draw_sweep(curves, deviations, result, every):
    """The curves of a sweep, each with the points of the run of its number."""
    for k in range(int(result.number("/curves"))):
        colour, group = COLOURS[k % len(COLOURS)], f"/curve_{k}"
        for conditions in sorted({one for one in every if one[0] == k}):
            draw_points(curves, deviations, result, conditions, colour)
        creepage, computed = result.arrays([f"{group}/creepage", f"{group}/coefficient"])
        name = result.text("/runs").split("\n")[k]
        label = f"{name + ': ' if name else ''}rms {result.number(group + '/rms'):.4f}"
        curves.plot(100 * creepage, computed, color=colour, linewidth=1.6, label=label)


def panels(what, result):
    """A figure with its axes for curves and for deviations."""
    figure = new_figure(9, 7)
    put_title(figure, heading(what, result))
    curves, deviations = figure.subplots(2, 1, height_ratios=(3, 1), sharex=True)
    deviations.axhline(0, color=GREY, linewidth=0.8)
    curves.set_xscale("log")
    curves.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    curves.set_ylabel("adhesion coefficient [-]")
    deviations.set_ylabel("measured - computed [-]")
    deviations.set_xlabel("creepage [%]")
    for axes in (curves, deviations):
        open_axes(axes)
    return figure, curves, deviations


def draw_points(curves, deviations, result, conditions, colour):
    """The points of a run, speed and load. Returns their creepages and what is computed there."""
    creepage, measured, computed = result.arrays([f"/points/{name}" for name in ("creepage", "coefficient", "fitted")])
    here = np.all([values == value for values, value in zip(result.arrays([f"/points/{name}" for name in CONDITIONS]), conditions)],
                  axis=0)
    creepage, measured, computed = creepage[here], measured[here], computed[here]
    curves.plot(100 * creepage, measured, "o", color=colour, markersize=3.5, alpha=0.6)
    deviations.plot(100 * creepage, measured - computed, "o", color=colour, markersize=3, alpha=0.6)
    return creepage, computed


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
