"""Draws limit cycles that critical_speed wrote: plot.py PICTURE CYCLES.csv... A file is named after its law; `LAW-steel.csv`
is the law with the shear modulus of steel. Colours and letters are those of microslip's pictures, from its Python package."""

import pathlib
import re
import sys

import numpy as np
from microslip.picture_style import ALONG, LOOKS, THEORIES, new_figure, open_axes, style

SHEN_HEDRICK_ELKINS = ("Shen, Hedrick & Elkins", (ALONG, ":"), "s")
LAWS = {"dytsi": SHEN_HEDRICK_ELKINS, "shen_hedrick_elkins": SHEN_HEDRICK_ELKINS,
        **{theory: (THEORIES[theory], LOOKS[theory], marker) for theory, marker in (("fastsim2", "o"), ("table", "^"))}}
LEAST = 3e-3  # least_amplitude in stability.hpp [m]


def draw(axes, file):
    """Amplitudes over the speed, with the linear critical speed as a line from the axis."""
    label, (colour, dashes), marker = LAWS[file.stem.removesuffix("-steel")]
    linear = float(re.search(r"critical speed ([\d.]+)", file.read_text()).group(1))
    speed, amplitude = np.genfromtxt(file, delimiter=",", skip_header=2, unpack=True)
    lives = amplitude >= LEAST
    axes.plot(speed[lives], 1e3 * amplitude[lives], marker, linestyle=dashes, color=colour, markersize=4, linewidth=1.4, fillstyle="none",
              label=f"{label}: {speed[lives].min():.1f}, {linear:.1f} m/s")
    axes.plot([speed[lives].min()] * 2, [0, 1e3 * amplitude[lives][0]], "-", color=colour, linewidth=0.8)
    axes.plot([linear], [0], marker, color=colour, clip_on=False, zorder=5)


def main():
    picture, *files = map(pathlib.Path, sys.argv[1:])
    steel = [file for file in files if file.stem.endswith("-steel")]
    groups = [("DYTSI's shear modulus, 144 GPa", [file for file in files if file not in steel])]
    groups += [("Shear modulus of steel, 82.7 GPa", steel)] if steel else []
    with style():
        figure = new_figure(7.0, 3.1 * len(groups))
        panels = figure.subplots(len(groups), 1, sharex=True, squeeze=False)
        for axes, (title, members) in zip(panels[:, 0], groups):
            for file in members:
                draw(axes, file)
            axes.set_title(title)
            axes.set_ylabel("amplitude [mm]")
            axes.set_ylim(0, 10)
            open_axes(axes)
            axes.legend(title="law: nonlinear, linear critical speed", fontsize="small", title_fontsize="small", loc="lower center")
        panels[-1, 0].set_xlabel("speed [m/s]")
        figure.savefig(picture)


if __name__ == "__main__":
    main()
