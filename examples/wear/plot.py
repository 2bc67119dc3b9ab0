"""Draws what wear.py wrote: plot.py FOLDER [PICTURE], by default FOLDER/wear.png. Colours and letters are those of
microslip's pictures."""

import sys
from pathlib import Path

import microslip
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from microslip.picture_style import INK, RED, SIZES_OF_LINES, names_above, new_figure, open_axes, style


def read_profiles(folder):
    """(km, profile) in the order of the distance."""
    found = {float(path.stem.split("_")[1]): path for path in Path(folder).glob("profile_*.prw")}
    return [(km, microslip.read_profile(found[km])) for km in sorted(found)]


def draw_profiles(axes, profiles, colours):
    for (_, wheel), colour in zip(profiles, colours):
        axes.plot(1e3 * wheel.y, 1e3 * wheel.z, color=colour, linewidth=1)
    axes.set_aspect("equal")
    axes.set_xlim(-72, 62)
    axes.set_ylabel("z [mm], up")
    axes.set_title("Profiles of the wheel")


def depth_between(new, old):
    """y and depth [mm] of what lies between two profiles with the same points in the same order."""
    s = np.concatenate(([0], np.cumsum(np.hypot(np.diff(new.y), np.diff(new.z)))))
    angle = new.angle(s)
    return 1e3 * new.y, 1e3 * ((old.z - new.z) * np.cos(angle) - (old.y - new.y) * np.sin(angle))


def draw_depths(axes, profiles, colours):
    new = profiles[0][1]
    for (_, wheel), colour in zip(profiles[1:], colours[1:]):
        axes.plot(*depth_between(new, wheel), color=colour, linewidth=1)
    axes.set_xlim(-72, 62)
    axes.set_xlabel("y [mm], to the field side")
    axes.set_ylabel("depth [mm]")
    axes.set_title("What is worn off, along the normal")


def draw_course(axes, other, distance, rate, thickness, height):
    axes.step(distance, rate, where="post", color=INK)
    axes.set_ylabel("wear rate\n[mm² per 1000 km]")
    axes.set_ylim(0, None)
    axes.set_title("Wear rate and flange")
    other.plot(distance, height - height[0], color=INK, label="height")
    other.plot(distance, thickness - thickness[0], color=RED, linestyle="--", label="thickness")
    other.set_ylabel("change of the\nflange [mm]")
    other.set_xlabel("distance [km]")
    names_above(other, fontsize="small")


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "wear.png"
    profiles = read_profiles(folder)
    distance, rate, height, thickness, _ = np.genfromtxt(folder / "wear.csv", delimiter=",", skip_header=1, unpack=True)
    norm = Normalize(0, distance[-1])
    colours = [SIZES_OF_LINES(norm(km)) for km, _ in profiles]
    part = picture.with_suffix(".part.png")
    with style():
        figure = new_figure(7.0, 8.6)
        axes = figure.subplots(4, 1, height_ratios=(0.9, 1.2, 0.8, 0.8))
        draw_profiles(axes[0], profiles, colours)
        draw_depths(axes[1], profiles, colours)
        draw_course(axes[2], axes[3], distance, rate, thickness, height)
        for one in axes:
            open_axes(one)
        figure.colorbar(ScalarMappable(norm, SIZES_OF_LINES), ax=axes[:2], label="distance [km]")
        figure.savefig(part)
    part.replace(picture)


if __name__ == "__main__":
    main()
