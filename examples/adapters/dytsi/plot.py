"""Draws limit cycles that critical_speed wrote: plot.py PICTURE CYCLES.csv... A file is named after its law; `LAW-steel.csv`
is the law with the shear modulus of steel."""

import pathlib
import re
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

LAWS = {"dytsi": ("Shen, Hedrick & Elkins", "#0072b2", "s"), "shen_hedrick_elkins": ("Shen, Hedrick & Elkins", "#0072b2", "s"),
        "fastsim2": ("FASTSIM2", "#d55e00", "o"), "table": ("creep-force table", "#009e73", "^")}
LEAST = 3e-3  # least_amplitude in stability.hpp [m]


def draw(axes, file):
    """Amplitudes over the speed, with the linear critical speed as a line from the axis."""
    label, colour, marker = LAWS[file.stem.removesuffix("-steel")]
    linear = float(re.search(r"critical speed ([\d.]+)", file.read_text()).group(1))
    speed, amplitude = np.genfromtxt(file, delimiter=",", skip_header=2, unpack=True)
    lives = amplitude >= LEAST
    axes.plot(speed[lives], 1e3 * amplitude[lives], marker + "-", color=colour, markersize=4, linewidth=1, fillstyle="none",
              label=f"{label}: {speed[lives].min():.1f}, {linear:.1f} m/s")
    axes.plot([speed[lives].min()] * 2, [0, 1e3 * amplitude[lives][0]], ":", color=colour, linewidth=1)
    axes.plot([linear], [0], marker, color=colour, clip_on=False, zorder=5)


def main():
    picture, *files = map(pathlib.Path, sys.argv[1:])
    steel = [file for file in files if file.stem.endswith("-steel")]
    groups = [("DYTSI's shear modulus, 144 GPa", [file for file in files if file not in steel])]
    groups += [("Shear modulus of steel, 82.7 GPa", steel)] if steel else []
    figure, panels = plt.subplots(len(groups), 1, figsize=(7.5, 3.4 * len(groups)), sharex=True, squeeze=False)
    for axes, (title, members) in zip(panels[:, 0], groups):
        for file in members:
            draw(axes, file)
        axes.set_title(title, loc="left", fontsize=10)
        axes.set_ylabel("amplitude [mm]")
        axes.set_ylim(0, 10)
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(title="law: nonlinear, linear critical speed", frameon=False, fontsize=8, title_fontsize=8, loc="lower center")
    panels[-1, 0].set_xlabel("speed [m/s]")
    figure.tight_layout()
    figure.savefig(picture, dpi=150)


if __name__ == "__main__":
    main()
