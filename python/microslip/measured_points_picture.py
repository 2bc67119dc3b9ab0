"""Measured points beside computed creep curves, of one result or of several; below what the points differ by."""

import numpy as np

from microslip.creep_curve_fit_picture import CONDITIONS, draw_points, label_of, panels
from microslip.picture_style import INK3, LINES, LOOKS

# Of the curves beside one group of points, one after the other.
DASHES = [LOOKS[theory][1] for theory in ("exact", "fastsim2", "table", "fastsim", "fastsim_half_step")]
MARKERS = "osD^v"


def measured_points_pictures(result):
    """The picture of a result file of kind measured_points, by file name."""
    return {"measured_points.png": measured_points_picture(result)}


def measured_points_picture(result):
    """Each curve with its points. Where the points are of one run, speed and load the curves differ by their colour; else
    points and curves of a run, speed and load have one colour, and curves of several results differ by their dashes."""
    figure, curves, deviations = panels("Measured points", result)
    groups = groups_of_curves(result)
    everything = list(dict.fromkeys(one for group in groups for one in group))
    by_points = len(everything) > 1 and all(len(group) == 1 for group in groups)
    drawn = []
    for number, group in enumerate(groups):
        place = everything.index(group[0]) if by_points else number
        colour, dashes = LINES[place % len(LINES)], DASHES[(drawn.count(group) if by_points else number) % len(DASHES)]
        drawn.append(group)
        for one in group:
            marker = MARKERS[everything.index(one) % len(MARKERS)]
            is_new = sum(one in before for before in drawn) == 1
            draw_points(curves if is_new else None, deviations, result, one, colour, number=number, marker=marker,
                        of_points=colour if by_points or len(groups) == 1 else INK3, filled=dashes == DASHES[0])
        creepage, computed = result.arrays([f"/curve_{number}/{name}" for name in ("creepage", "coefficient")])
        curves.plot(100 * creepage, computed, color=colour, linestyle=dashes, linewidth=1.8, label=label_of_curve(result, number, group))
    curves.set_title(f"rms {result.number('/rms'):.4f}, bias {result.number('/bias'):.4f}" if len(groups) == 1 else "")
    curves.set_ylim(bottom=min(0, float(np.min(result.array("/points/coefficient")))))
    curves.legend(loc="lower right", fontsize="small")
    return figure


def groups_of_curves(result):
    """For each curve the runs, speeds and loads of its points."""
    numbers, *conditions = result.arrays([f"/points/{name}" for name in ("curve", *CONDITIONS)])
    every = list(zip(*conditions))
    return [list(dict.fromkeys(one for number, one in zip(numbers, every) if number == curve))
            for curve in range(int(result.number("/curves")))]


def label_of_curve(result, number, group):
    """What a curve is of, with its rms where there are several."""
    name = result.text(f"/curve_{number}/name") or ", ".join(label_of(result, one) for one in group)
    return name if result.number("/curves") == 1 else f"{name}: rms {result.number(f'/curve_{number}/rms'):.4f}"
