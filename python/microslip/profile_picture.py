"""The profile of a wheel or rail: its curve with the points, inclination and curvature along it."""

import numpy as np

from microslip.picture_style import (GREEN, INK2, INK3, LINE, RAIL, RED, WHEEL, heading, new_figure, open_axes,
                                     put_title)


def profile_pictures(result):
    """The picture of a result file of kind profile, by file name."""
    y, z, s, angle, curvature = result.arrays([f"/curve/{name}" for name in ("y", "z", "s", "angle", "curvature")])
    figure = new_figure(7.0, 7.4)
    put_title(figure, heading(result.text("/role"), result))
    shape, inclination, bend = figure.subplots(3, 1, height_ratios=(1.9, 1, 1))
    colour = WHEEL if result.text("/role") == "wheel" else RAIL
    draw_shape(shape, result, y, z, colour)
    inclination.plot(1e3 * s, np.degrees(np.unwrap(angle)), color=colour, linewidth=1.4)
    inclination.set_ylabel("inclination [deg]")
    bend.plot(1e3 * s, curvature, color=colour, linewidth=1)
    bend.set_ylabel("curvature [1/m]")
    bend.set_ylim(*robust_range(curvature))
    bend.set_xlabel("length along the curve from the gauge side [mm]")
    for axes in (inclination, bend):
        open_axes(axes)
        axes.set_xlim(0, 1e3 * s[-1])
        mark_kinks(axes, result, y, z, s)
    return {"profile.png": figure}


def draw_shape(axes, result, y, z, colour):
    """The curve to scale, the points it was laid through or smoothed from, kinks, and what is measured on it."""
    open_axes(axes)
    points = result.arrays(["/measured/y", "/measured/z"])
    axes.plot(*(1e3 * values for values in points), ".", color=LINE, markersize=5, label="points")
    axes.plot(1e3 * y, 1e3 * z, color=colour, linewidth=1.4, label="spline")
    if "kinks" in result:
        axes.plot(*(1e3 * values for values in result.arrays(["/kinks/y", "/kinks/z"])), "D", color=RED,
                  markersize=6, markerfacecolor="none", label="kinks")
    if "dimensions/tape_line" in result:
        mark_tape_line(axes, result)
    if "dimensions/gauge_y" in result:
        mark_gauge_point(axes, result)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("y [mm], to the field side")
    axes.set_ylabel("z [mm], up")
    # A rail's inside and a wheel's upper side are free.
    axes.legend(loc="lower center" if "dimensions/gauge_y" in result else "upper left", fontsize="small")
    axes.text(0.01, 0.02, dimensions_text(result), transform=axes.transAxes, color=INK2, va="bottom", size="small")


RING = {"linestyle": "none", "marker": "o", "color": GREEN, "markersize": 7, "markerfacecolor": "none", "markeredgewidth": 1.6}
TAPE_TO_BACK, BELOW_TAPE = 70, 10  # [mm] of EN 15313


def mark_tape_line(axes, result):
    """The line 70 mm from the flange's back, the tread there, and the flange's thickness 10 mm towards the tip."""
    tape = 1e3 * result.number("/dimensions/tape_line")
    axes.axvline(tape, color=GREEN, linestyle="--", linewidth=1, label="tape line")
    if "dimensions/tape_circle" not in result:
        return
    tread = 1e3 * result.number("/dimensions/tape_circle")
    axes.plot([tape], [tread], label="tape circle", **RING)
    if "dimensions/flange_thickness" in result:
        back = tape - TAPE_TO_BACK
        axes.annotate("", (back, tread - BELOW_TAPE), (back + 1e3 * result.number("/dimensions/flange_thickness"), tread - BELOW_TAPE),
                      arrowprops={"arrowstyle": "<->", "color": GREEN, "shrinkA": 0, "shrinkB": 0})


def mark_gauge_point(axes, result):
    """The point that protrudes most between the top and the gauge's height below it, with both heights."""
    axes.plot(*([1e3 * result.number(f"/dimensions/gauge_{axis}")] for axis in "yz"), label="gauge point", **RING)
    if "dimensions/gauge_height" in result:
        top, height = (1e3 * result.number(f"/dimensions/{name}") for name in ("top_z", "gauge_height"))
        axes.axhline(top, color=GREEN, linestyle=":", linewidth=1, label="top")
        axes.axhline(top - height, color=GREEN, linestyle="--", linewidth=1, label=f"{height:g} mm below the top")


def dimensions_text(result):
    """The flange's dimensions in a line, or where the gauge point lies, as far as the file has them."""
    names = {"flange_height": "Sh", "flange_thickness": "Sd", "flange_gradient": "qR", "gauge_y": "gauge point y", "gauge_z": "z"}
    return ", ".join(f"{symbol} {1e3 * result.number(f'/dimensions/{name}'):.2f} mm" for name, symbol in names.items()
                     if f"dimensions/{name}" in result)


def robust_range(values):
    """Limits that show all but the two percent at either end of noisy or nearly singular values, with a margin."""
    low, high = np.quantile(values, (0.02, 0.98))
    margin = 0.3 * (high - low) or 1.0
    return low - margin, high + margin


def mark_kinks(axes, result, y, z, s):
    """A line where the direction of the curve jumps."""
    if "kinks" not in result:
        return
    for kink_y, kink_z in zip(*result.arrays(["/kinks/y", "/kinks/z"])):
        axes.axvline(1e3 * s[np.argmin(np.hypot(y - kink_y, z - kink_z))], color=INK3, linestyle=":", linewidth=1)
