"""Draws what `wheelset` or `wheelset_on_profiles` wrote: plot.py FOLDER [PICTURE], by default FOLDER/wheelset.png."""

import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

FIRST, SECOND, GREEN, GREY = "#17212b", "#a3182b", "#1d9a86", "#67747f"
CLEARANCE = 7.0  # mm, flange_clearance in wheelset.hpp


def label(axes, title, x, y):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def read(path):
    return np.genfromtxt(path, delimiter=",", skip_header=1, unpack=True)


def draw_run(axes, time, lateral, colour, title):
    axes.plot(time, 1e3 * lateral, color=colour, linewidth=0.8)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axhline(side, color=GREY, linestyle=":", linewidth=1)
    label(axes, title, "time [s]", "lateral displacement [mm]")
    axes.set_xlim(0, time[-1])
    axes.set_ylim(-10, 10)


def draw_cycle(axes, lateral, yaw):
    last = slice(-200, None)  # the last second
    axes.plot(1e3 * lateral[last], 1e3 * yaw[last], color=SECOND)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axvline(side, color=GREY, linestyle=":", linewidth=1)
    label(axes, "Limit cycle, the last second", "lateral displacement [mm]", "yaw to the left [mrad]")


def draw_amplitudes(axes, ratio, small, large):
    axes.plot(ratio, 1e3 * large, "s", color=FIRST, markersize=5, fillstyle="none", label="from 7 mm")
    axes.plot(ratio, 1e3 * small, "o", color=SECOND, markersize=3.5, label="from 0.1 mm")
    axes.axhline(CLEARANCE, color=GREY, linestyle=":", linewidth=1)
    axes.axvline(1, color=GREY, linestyle="--", linewidth=1)
    axes.text(ratio[0], CLEARANCE, "flange", color=GREY, va="bottom", fontsize=8)
    label(axes, "Amplitude that is left after 15 s", "speed over critical speed [-]", "amplitude [mm]")
    axes.set_ylim(0, 10)
    axes.legend(loc="center right", frameon=False, fontsize=8)


def draw_motion(axes, folder):
    time, below, _, above, _ = read(os.path.join(folder, "motion.csv"))
    axes.plot(time, 1e3 * below, color=FIRST, linewidth=1, label="50 m/s, from 5 mm")
    axes.plot(time, 1e3 * above, color=SECOND, linewidth=0.8, label="66 m/s, from 1 mm")
    label(axes, "Below and above the critical speed", "time [s]", "lateral displacement [mm]")
    axes.set_xlim(0, time[-1])
    axes.set_ylim(-8, 10)
    axes.legend(loc="upper left", frameon=False, fontsize=8, ncols=2)


def draw_wheel_forces(axes, folder):
    time, y, _, left, _, right, _ = read(os.path.join(folder, "cycle.csv"))
    axes.plot(time, 1e-3 * left, color=FIRST, linewidth=1, label="left wheel")
    axes.plot(time, 1e-3 * right, color=SECOND, linewidth=1, label="right wheel")
    label(axes, "Hunting at 66 m/s: force on the rail, outwards", "time [s]", "Y [kN]")
    axes.set_xlim(time[0], time[-1])
    axes.set_ylim(-30, 270)
    shift = axes.twinx()
    shift.plot(time, 1e3 * y, color=GREY, linewidth=1, linestyle="--")
    shift.set_ylabel("lateral displacement [mm], dashed", color=GREY)
    shift.set_ylim(-20, 20)
    axes.legend(loc="upper left", frameon=False, fontsize=8, ncols=2)


def draw_bifurcation(axes, folder):
    speed, up, down = read(os.path.join(folder, "bifurcation.csv"))
    axes.plot(speed, 1e3 * down, "s-", color=FIRST, markersize=5, fillstyle="none", linewidth=0.8, label="speed decreasing")
    axes.plot(speed, 1e3 * up, "o-", color=SECOND, markersize=3.5, linewidth=0.8, label="speed increasing")
    label(axes, "Amplitude after 8 s at each speed", "speed [m/s]", "amplitude [mm]")
    axes.set_ylim(0, 8)
    axes.legend(loc="lower right", frameon=False, fontsize=8)


def draw_curves(axes, folder):
    radius, deficiency, y, _, _, outer, _ = read(os.path.join(folder, "curves.csv"))
    ratio = axes.twinx()
    colours = dict(zip(np.unique(deficiency), (GREY, GREEN, FIRST, SECOND)))
    for one, colour in colours.items():
        chosen = deficiency == one
        axes.plot(radius[chosen], 1e3 * y[chosen], "o-", color=colour, markersize=3, linewidth=1, label=f"{1e3 * one:.0f} mm")
        ratio.plot(radius[chosen], outer[chosen], "s--", color=colour, markersize=3, fillstyle="none", linewidth=0.8)
    axes.set_xscale("log")
    axes.set_xticks([200, 300, 500, 1000, 1500], ["200", "300", "500", "1000", "1500"])
    axes.minorticks_off()
    label(axes, "Curves to the left, by cant deficiency", "radius [m]", "lateral displacement [mm], full")
    ratio.set_ylabel("Y/Q of the outer wheel, dashed")
    axes.set_ylim(-7, 3)
    ratio.set_ylim(-0.45, 0.3)
    axes.legend(loc="upper center", frameon=False, fontsize=8, ncols=4)


def draw_on_profiles(folder):
    figure, axes = plt.subplots(2, 2, figsize=(10, 6.4), layout="constrained")
    draw_motion(axes[0, 0], folder)
    draw_bifurcation(axes[0, 1], folder)
    draw_wheel_forces(axes[1, 0], folder)
    draw_curves(axes[1, 1], folder)
    return figure


def draw_conical(folder):
    time, y_below, _, y_above, psi_above = read(os.path.join(folder, "runs.csv"))
    figure, axes = plt.subplots(2, 2, figsize=(10, 6.4), layout="constrained")
    draw_run(axes[0, 0], time, y_below, FIRST, "0.9 of the critical speed, from 4 mm")
    draw_run(axes[1, 0], time, y_above, SECOND, "1.1 of the critical speed, from 0.1 mm")
    draw_amplitudes(axes[0, 1], *read(os.path.join(folder, "amplitudes.csv")))
    draw_cycle(axes[1, 1], y_above, psi_above)
    return figure


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(folder, "wheelset.png")
    figure = draw_conical(folder) if os.path.exists(os.path.join(folder, "runs.csv")) else draw_on_profiles(folder)
    part = picture + ".part.png"
    figure.savefig(part, dpi=130)
    os.replace(part, picture)


if __name__ == "__main__":
    main()
