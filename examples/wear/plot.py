"""Draws what wear.py wrote: plot.py FOLDER [PICTURE], by default FOLDER/wear.png."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import SIZES_OF_LINES

SECOND, GREY = "#a3182b", "#67747f"


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
    axes.set_title("Profiles of the wheel", fontsize=10, loc="left")


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
    axes.set_title("What is worn off, along the normal", fontsize=10, loc="left")


def draw_course(axes, distance, rate, thickness, height):
    axes.step(distance, rate, where="post", color=GREY)
    axes.set_xlabel("distance [km]")
    axes.set_ylabel("wear rate [mm$^2$ per 1000 km]", color=GREY)
    axes.set_ylim(0, None)
    axes.set_title("Wear rate and flange", fontsize=10, loc="left")
    other = axes.twinx()
    other.plot(distance, height - height[0], color=SECOND, label="height")
    other.plot(distance, thickness - thickness[0], color=SECOND, linestyle="--", label="thickness")
    other.set_ylabel("change of the flange [mm]", color=SECOND)
    other.legend(frameon=False, fontsize=8, loc="center right")


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    picture = Path(sys.argv[2]) if len(sys.argv) > 2 else folder / "wear.png"
    profiles = read_profiles(folder)
    distance, rate, height, thickness, _ = np.genfromtxt(folder / "wear.csv", delimiter=",", skip_header=1, unpack=True)
    norm = matplotlib.colors.Normalize(0, distance[-1])
    colours = [SIZES_OF_LINES(norm(km)) for km, _ in profiles]
    figure, axes = plt.subplots(3, 1, figsize=(8, 9), layout="constrained", height_ratios=(1.1, 1, 1))
    draw_profiles(axes[0], profiles, colours)
    draw_depths(axes[1], profiles, colours)
    draw_course(axes[2], distance, rate, thickness, height)
    figure.colorbar(matplotlib.cm.ScalarMappable(norm, SIZES_OF_LINES), ax=axes[:2], label="distance [km]")
    part = picture.with_suffix(".part.png")
    figure.savefig(part, dpi=130)
    part.replace(picture)


if __name__ == "__main__":
    main()
