"""Draws what `vehicle` wrote: plot.py FOLDER [PICTURE], by default FOLDER/vehicle.png."""

import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

BLUE, ORANGE, GREEN, GREY = "#0072b2", "#d55e00", "#009e73", "#777777"
RADIUS = 300  # m, of the curve in main.cpp


def label(axes, title, x, y):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def read(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        rows = list(csv.reader(file))
    return np.array(rows[1:], float).T


def draw_hunting(axes, folder):
    speed, up, down = read(folder, "hunting.csv")
    axes.plot(speed, 1e3 * down, "s-", color=BLUE, markersize=5, fillstyle="none", linewidth=0.8, label="speed decreasing")
    axes.plot(speed, 1e3 * up, "o-", color=ORANGE, markersize=3.5, linewidth=0.8, label="speed increasing")
    label(axes, "Hunting of a bogie: limit cycles", "speed [m/s]", "amplitude of the leading wheelset [mm]")
    axes.set_ylim(bottom=0)
    axes.legend(loc="upper left", frameon=False, fontsize=8)


def shade_arc(axes, time, curvature):
    arc = time[np.isclose(curvature, 1 / RADIUS)]
    turning = time[curvature > 0]
    axes.axvspan(turning[0], turning[-1], color=GREY, alpha=0.10, linewidth=0)
    axes.axvspan(arc[0], arc[-1], color=GREY, alpha=0.15, linewidth=0)


def draw_forces(axes, data):
    time, curvature = data[:2]
    shade_arc(axes, time, curvature)
    for wheel, (colour, style, name) in enumerate([(BLUE, "-", "wheelset 1, inner"), (ORANGE, "-", "wheelset 1, outer"),
                                                   (BLUE, ":", "wheelset 2, inner"), (ORANGE, ":", "wheelset 2, outer")]):
        axes.plot(time, 1e-3 * data[2 + 3 * wheel], color=colour, linestyle=style, linewidth=1, label=name)
    label(axes, "Lateral forces on the leading bogie's wheels", "time [s]", "force to the left [kN]")
    axes.set_xlim(time[0], time[-1])
    axes.legend(loc="upper right", frameon=False, fontsize=8, ncols=2)
    low, high = axes.get_ylim()
    axes.set_ylim(low, high + 0.35 * (high - low))


def draw_contacts(axes, data, folder):
    time, curvature = data[:2]
    shade_arc(axes, time, curvature)
    at, wheel, y = read(folder, "contacts.csv")
    for number, colour, name in ((0, BLUE, "wheelset 1, inner wheel"), (1, ORANGE, "wheelset 1, outer wheel")):
        axes.plot(at[wheel == number], 1e3 * y[wheel == number], ".", color=colour, markersize=2.5, label=name)
    label(axes, "Where the wheels touch", "time [s]", "y on the wheel's profile [mm]")
    axes.set_xlim(time[0], time[-1])
    axes.annotate("flange", (0.01, 0.02), xycoords="axes fraction", color=GREY, fontsize=8)
    axes.legend(loc="center", frameon=False, fontsize=8, markerscale=3)


def draw_wear(axes, data):
    time, curvature = data[:2]
    arc = np.flatnonzero(np.isclose(curvature, 1 / RADIUS))
    t_gamma = data[4::3][:, arc[len(arc) // 2:]].mean(axis=1)
    places = np.arange(len(t_gamma) // 2)
    axes.bar(places - 0.2, t_gamma[0::2], width=0.38, color=BLUE, label="inner wheel")
    axes.bar(places + 0.2, t_gamma[1::2], width=0.38, color=ORANGE, label="outer wheel")
    axes.set_xticks(places, [f"wheelset {k + 1}" for k in places])
    label(axes, "Wear number in the arc", "", "T-gamma [N]")
    axes.legend(loc="upper right", frameon=False, fontsize=8)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    folder = sys.argv[1]
    figure, axes = plt.subplots(2, 2, figsize=(11, 7.5), layout="constrained")
    data = read(folder, "curve.csv")
    draw_hunting(axes[0, 0], folder)
    draw_forces(axes[0, 1], data)
    draw_contacts(axes[1, 0], data, folder)
    draw_wear(axes[1, 1], data)
    for one in axes.flat:
        one.spines[["top", "right"]].set_visible(False)
        one.grid(alpha=0.25)
    figure.savefig(sys.argv[2] if len(sys.argv) == 3 else os.path.join(folder, "vehicle.png"), dpi=150)


if __name__ == "__main__":
    main()
