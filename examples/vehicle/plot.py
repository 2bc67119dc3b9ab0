"""Draws what `vehicle` wrote: plot.py FOLDER [PICTURE], by default FOLDER/vehicle.png. Colours and letters are those of
microslip's pictures, from its Python package."""

import csv
import os
import sys

import numpy as np
from microslip.picture_style import INK, INK2, INK3, RED, names_above, new_figure, open_axes, style

RADIUS = 300  # m, of the curve in main.cpp


def label(axes, title, x, y):
    axes.set_title(title, pad=20)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    open_axes(axes)
    names_above(axes, fontsize="small")


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        rows = list(csv.reader(file))
    return np.array(rows[1:], float).T


def draw_hunting(axes, folder):
    speed, up, down = read(folder, "hunting.csv")
    axes.plot(speed, 1e3 * down, "s--", color=INK, markersize=5, fillstyle="none", linewidth=0.8, label="speed decreasing")
    axes.plot(speed, 1e3 * up, "o-", color=RED, markersize=3.5, linewidth=0.8, label="speed increasing")
    label(axes, "Hunting of a bogie: limit cycles", "speed [m/s]", "amplitude of wheelset 1 [mm]")
    axes.set_ylim(bottom=0)


def shade_arc(axes, time, curvature):
    arc = time[np.isclose(curvature, 1 / RADIUS)]
    turning = time[curvature > 0]
    axes.axvspan(turning[0], turning[-1], color=INK3, alpha=0.10, linewidth=0)
    axes.axvspan(arc[0], arc[-1], color=INK3, alpha=0.15, linewidth=0)


def draw_forces(axes, data):
    time, curvature = data[:2]
    shade_arc(axes, time, curvature)
    for wheel, (colour, style, name) in enumerate([(INK, "-", "1, inner"), (RED, "-", "1, outer"),
                                                   (INK, ":", "2, inner"), (RED, ":", "2, outer")]):
        axes.plot(time, 1e-3 * data[2 + 3 * wheel], color=colour, linestyle=style, linewidth=1, label=name)
    label(axes, "Lateral forces on the wheels of wheelsets 1 and 2", "time [s]", "force to the left [kN]")
    axes.set_xlim(time[0], time[-1])


def draw_contacts(axes, data, folder):
    time, curvature = data[:2]
    shade_arc(axes, time, curvature)
    at, wheel, y = read(folder, "contacts.csv")
    for number, colour, name in ((0, INK, "inner wheel"), (1, RED, "outer wheel")):
        axes.plot(at[wheel == number], 1e3 * y[wheel == number], ".", color=colour, markersize=2.5, label=name)
    label(axes, "Where the wheels of wheelset 1 touch", "time [s]", "y on the wheel's profile [mm]")
    axes.set_xlim(time[0], time[-1])
    axes.annotate("flange", (0.01, 0.02), xycoords="axes fraction", color=INK2, size="small")


def draw_wear(axes, data):
    time, curvature = data[:2]
    arc = np.flatnonzero(np.isclose(curvature, 1 / RADIUS))
    t_gamma = data[4::3][:, arc[len(arc) // 2:]].mean(axis=1)
    places = np.arange(len(t_gamma) // 2)
    axes.bar(places - 0.2, t_gamma[0::2], width=0.38, color=INK, label="inner wheel")
    axes.bar(places + 0.2, t_gamma[1::2], width=0.38, color=RED, label="outer wheel")
    axes.set_xticks(places, [f"wheelset {k + 1}" for k in places])
    label(axes, "Wear number in the arc", "", r"$T\gamma$ [N]")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[1]
    data = read(folder, "curve.csv")
    with style():
        figure = new_figure(10, 6.8)
        axes = figure.subplots(2, 2)
        draw_hunting(axes[0, 0], folder)
        draw_forces(axes[0, 1], data)
        draw_contacts(axes[1, 0], data, folder)
        draw_wear(axes[1, 1], data)
        figure.savefig(sys.argv[2] if len(sys.argv) == 3 else os.path.join(folder, "vehicle.png"))


if __name__ == "__main__":
    main()
