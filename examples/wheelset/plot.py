"""Draws what `wheelset` or `wheelset_on_profiles` wrote: plot.py FOLDER [PICTURE], by default FOLDER/wheelset.png. Colours
and letters are those of microslip's pictures, from its Python package."""

import os
import sys

import numpy as np
from microslip.picture_style import INK, INK2, INK3, RED, SIZES_OF_LINES, names_above, new_figure, open_axes, style

FIRST, SECOND = INK, RED
CLEARANCE = 7.0  # mm, flange_clearance in wheelset.hpp


def label(axes, title, x, y):
    axes.set_title(title, pad=20 if axes.get_legend_handles_labels()[0] else None)
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    open_axes(axes)
    names_above(axes, fontsize="small")


def read(path):
    return np.genfromtxt(path, delimiter=",", skip_header=1, unpack=True)


def draw_run(axes, time, lateral, colour, title):
    axes.plot(time, 1e3 * lateral, color=colour, linewidth=0.8)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axhline(side, color=INK3, linestyle=":", linewidth=1)
    label(axes, title, "time [s]", "lateral displacement [mm]")
    axes.set_xlim(0, time[-1])
    axes.set_ylim(-10, 10)


def draw_cycle(axes, lateral, yaw):
    last = slice(-200, None)  # the last second
    axes.plot(1e3 * lateral[last], 1e3 * yaw[last], color=SECOND)
    for side in (-CLEARANCE, CLEARANCE):
        axes.axvline(side, color=INK3, linestyle=":", linewidth=1)
    label(axes, "Limit cycle, the last second", "lateral displacement [mm]", "yaw to the left [mrad]")


def draw_amplitudes(axes, ratio, small, large):
    axes.plot(ratio, 1e3 * large, "s", color=FIRST, markersize=5, fillstyle="none", label="from 7 mm")
    axes.plot(ratio, 1e3 * small, "o", color=SECOND, markersize=3.5, label="from 0.1 mm")
    axes.axhline(CLEARANCE, color=INK3, linestyle=":", linewidth=1)
    axes.axvline(1, color=INK3, linestyle="--", linewidth=1)
    axes.text(ratio[0], CLEARANCE, "flange", color=INK3, va="bottom", size="small")
    label(axes, "Amplitude that is left after 15 s", "speed over critical speed [-]", "amplitude [mm]")
    axes.set_ylim(0, 10)


def draw_motion(axes, folder):
    time, below, _, above, _ = read(os.path.join(folder, "motion.csv"))
    axes.plot(time, 1e3 * below, color=FIRST, linewidth=1, label="50 m/s, from 5 mm")
    axes.plot(time, 1e3 * above, color=SECOND, linewidth=0.8, label="66 m/s, from 1 mm")
    label(axes, "Below and above the critical speed", "time [s]", "lateral displacement [mm]")
    axes.set_xlim(0, time[-1])


def draw_wheel_forces(axes, shift, folder):
    time, y, _, left, _, right, _ = read(os.path.join(folder, "cycle.csv"))
    axes.plot(time, 1e-3 * left, color=FIRST, linewidth=1, label="left wheel")
    axes.plot(time, 1e-3 * right, color=SECOND, linewidth=1, linestyle="--", label="right wheel")
    label(axes, "Hunting at 66 m/s: force on the rail, outwards", "", "Y [kN]")
    axes.set_xlim(time[0], time[-1])
    shift.plot(time, 1e3 * y, color=INK2, linewidth=1.2)
    label(shift, "", "time [s]", "lateral [mm]")


def draw_bifurcation(axes, folder):
    speed, up, down = read(os.path.join(folder, "bifurcation.csv"))
    axes.plot(speed, 1e3 * down, "s-", color=FIRST, markersize=5, fillstyle="none", linewidth=0.8, label="speed decreasing")
    axes.plot(speed, 1e3 * up, "o-", color=SECOND, markersize=3.5, linewidth=0.8, label="speed increasing")
    label(axes, "Amplitude after 8 s at each speed", "speed [m/s]", "amplitude [mm]")
    axes.set_ylim(0, 8)


def draw_curves(axes, ratio, folder):
    radius, deficiency, y, _, _, outer, _ = read(os.path.join(folder, "curves.csv"))
    values = np.unique(deficiency)
    for one, colour, marker in zip(values, SIZES_OF_LINES(np.linspace(0, 1, len(values))), "osD^"):
        chosen = deficiency == one
        axes.plot(radius[chosen], 1e3 * y[chosen], marker + "-", color=colour, markersize=3.5, linewidth=1, label=f"{1e3 * one:.0f} mm")
        ratio.plot(radius[chosen], outer[chosen], marker + "-", color=colour, markersize=3.5, linewidth=1)
    axes.set_xscale("log")
    axes.set_xticks([200, 300, 500, 1000, 1500], ["200", "300", "500", "1000", "1500"])
    axes.minorticks_off()
    label(axes, "Curves to the left, by cant deficiency", "", "lateral [mm]")
    label(ratio, "", "radius [m]", "Y/Q of the\nouter wheel")


def draw_on_profiles(folder):
    figure = new_figure(10, 7)
    panels = figure.subplot_mosaic([["motion", "amplitudes"], ["forces", "curves"], ["shift", "ratio"]], height_ratios=(1.7, 1.2, 0.8))
    panels["shift"].sharex(panels["forces"])
    panels["ratio"].sharex(panels["curves"])
    draw_motion(panels["motion"], folder)
    draw_bifurcation(panels["amplitudes"], folder)
    draw_wheel_forces(panels["forces"], panels["shift"], folder)
    draw_curves(panels["curves"], panels["ratio"], folder)
    for above in ("forces", "curves"):
        panels[above].tick_params(labelbottom=False)
    return figure


def draw_conical(folder):
    time, y_below, _, y_above, psi_above = read(os.path.join(folder, "runs.csv"))
    figure = new_figure(10, 6.4)
    axes = figure.subplots(2, 2)
    draw_run(axes[0, 0], time, y_below, FIRST, "0.9 of the critical speed, from 4 mm")
    draw_run(axes[1, 0], time, y_above, SECOND, "1.1 of the critical speed, from 0.1 mm")
    draw_amplitudes(axes[0, 1], *read(os.path.join(folder, "amplitudes.csv")))
    draw_cycle(axes[1, 1], y_above, psi_above)
    return figure


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    picture = sys.argv[2] if len(sys.argv) > 2 else os.path.join(folder, "wheelset.png")
    part = picture + ".part.png"
    with style():
        figure = draw_conical(folder) if os.path.exists(os.path.join(folder, "runs.csv")) else draw_on_profiles(folder)
        figure.savefig(part)
    os.replace(part, picture)


if __name__ == "__main__":
    main()
