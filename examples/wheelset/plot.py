"""Draws what `wheelset` wrote: plot.py FOLDER [PICTURE], by default FOLDER/wheelset.png."""

import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

BLUE, ORANGE, GREY = "#0072b2", "#d55e00", "#777777"
CLEARANCE = 7.0  # mm, flange_clearance in wheelset.hpp


def read(path):
    return np.genfromtxt(path, delimiter=",", skip_header=1, unpack=True)


def draw_run(axes, time, lateral, colour, title):
    axes.plot(time, 1e3 * lateral, color=colour, linewidth=0.8)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axhline(side, color=GREY, linestyle=":", linewidth=1)
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("lateral displacement [mm]")
    axes.set_xlim(0, time[-1])
    axes.set_ylim(-10, 10)


def draw_cycle(axes, lateral, yaw):
    last = slice(-200, None)  # the last second
    axes.plot(1e3 * lateral[last], 1e3 * yaw[last], color=ORANGE)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axvline(side, color=GREY, linestyle=":", linewidth=1)
    axes.set_title("Limit cycle, the last second", fontsize=10, loc="left")
    axes.set_xlabel("lateral displacement [mm]")
    axes.set_ylabel("yaw to the left [mrad]")


def draw_amplitudes(axes, ratio, small, large):
    axes.plot(ratio, 1e3 * large, "s", color=BLUE, markersize=5, fillstyle="none", label="from 7 mm")
    axes.plot(ratio, 1e3 * small, "o", color=ORANGE, markersize=3.5, label="from 0.1 mm")
    axes.axhline(CLEARANCE, color=GREY, linestyle=":", linewidth=1)
    axes.axvline(1, color=GREY, linestyle="--", linewidth=1)
    axes.text(ratio[0], CLEARANCE, "flange", color=GREY, va="bottom", fontsize=8)
    axes.set_title("Amplitude that is left after 15 s", fontsize=10, loc="left")
    axes.set_xlabel("speed over critical speed [-]")
    axes.set_ylabel("amplitude [mm]")
    axes.set_ylim(0, 10)
    axes.legend(loc="center right", frameon=False, fontsize=8)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(folder, "wheelset.png")
    time, y_below, _, y_above, psi_above = read(os.path.join(folder, "runs.csv"))
    figure, axes = plt.subplots(2, 2, figsize=(10, 6.4), layout="constrained")
    draw_run(axes[0, 0], time, y_below, BLUE, "0.9 of the critical speed, from 4 mm")
    draw_run(axes[1, 0], time, y_above, ORANGE, "1.1 of the critical speed, from 0.1 mm")
    draw_amplitudes(axes[0, 1], *read(os.path.join(folder, "amplitudes.csv")))
    draw_cycle(axes[1, 1], y_above, psi_above)
    part = picture + ".part.png"
    figure.savefig(part, dpi=130)
    os.replace(part, picture)


if __name__ == "__main__":
    main()
