"""The forces of a sweep over one of its parameters."""

import math

import numpy as np

from microslip.picture_style import INK, INK3, SERIES, heading, new_figure, number, open_axes, put_title, shown, unit_for
from microslip.result_file import ResultError

# What is drawn, of which there are the first three.
FORCES = ("contact/fx", "contact/fy", "contact/mz", "wheel/force_x", "wheel/force_y", "wheel/moment_z", "wheelset/force_x",
          "wheelset/force_y", "wheelset/moment_z")
COLOURS = SERIES
MOST_LINES = 12


def sweep_pictures(result):
    """Draw one panel for each force: of a grid lines over the parameter with most numbers, one for each combination of the
    others; of a list or a sample points over its first parameter."""
    forces = ([name for name in FORCES if name in result] or result.numbers_of(("contact", "wheel", "wheelset", "left", "right")))[:3]
    if not forces:
        raise ResultError(f"{result.path}: has no quantities")
    names = result.attribute("parameters").split("\n")
    figure = new_figure(9, 1 + 2.6 * len(forces))
    panels = np.atleast_1d(figure.subplots(len(forces), sharex=True))
    draw = draw_grid if "shape" in result else draw_points
    columns = [result.array(name, finite=False) for name in forces]
    largest = max(np.nanmax(np.abs(values), initial=0) for values in columns)
    for axes, name, values in zip(panels, forces, columns):
        open_axes(axes)
        if name in FORCES:
            values = shown(values, largest)
        factor, unit = unit_for(np.nanmax(np.abs(values), initial=0), result.unit(name))
        axis = draw(axes, result, names, factor * values)
        axes.set_ylabel(f"{name} [{unit}]")
    panels[-1].set_xlabel(f"{axis} [{scale_of(result, axis)[1]}]")
    if panels[0].get_legend_handles_labels()[0]:
        panels[-1].legend(*panels[0].get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(0.0, -0.2), ncols=2, fontsize="small")
    put_title(figure, heading("Sweep", result))
    return {"sweep.png": figure}


def is_logarithmic(values):
    """Returns whether positive values have rather constant ratios than constant differences."""
    if len(values) < 4 or values.min() <= 0 or values.max() < 20 * values.min():
        return False
    return np.ptp(np.diff(np.log(values))) < np.ptp(np.diff(values)) / np.abs(np.diff(values)).max() * math.log(10)


def draw_grid(axes, result, names, force):
    """Lines; of very many combinations some, evenly chosen, as the title says. Returns the parameter along the axis."""
    shape = result.array("shape")
    numbers = [place for place, one in enumerate(names) if result.is_number(f"parameters/{one}") and shape[place] > 1]
    if not numbers:
        raise ResultError(f"{result.path}: no parameter of the grid has two numbers")
    along = max(numbers, key=lambda place: (shape[place], place))  # of equals the last, which varies fastest
    name = names[along]
    force = np.moveaxis(force.reshape(shape), along, -1).reshape(-1, shape[along])
    at = np.moveaxis(np.arange(force.size).reshape(shape), along, -1).reshape(-1, shape[along])  # numbers of the cases
    x = scale_of(result, name)[0] * result.array(f"parameters/{name}")[at[0]]
    lines = np.unique(np.linspace(0, len(force) - 1, MOST_LINES).round().astype(int))
    for count, line in enumerate(lines):
        label = ", ".join(f"{one} = {parameter_text(result, one, at[line, 0])}" for place, one in enumerate(names)
                          if one != name and shape[place] > 1)
        axes.plot(x, force[line], color=COLOURS[count % len(COLOURS)], linestyle="-" if count < len(COLOURS) else "--", label=label)
    if len(lines) < len(force):
        axes.set_title(f"{len(lines)} of {len(force)} combinations")
    if is_logarithmic(x):
        axes.set_xscale("log")
    return name


def parameter_text(result, name, case):
    """A parameter of a case for a legend."""
    value = result.entry(f"parameters/{name}", case)
    if not isinstance(value, float):
        return value
    factor, unit = scale_of(result, name)
    return number(factor * value) + ("" if unit in ("-", "SI") else f" {unit}")


def scale_of(result, name):
    """The factor and the unit in which a parameter is shown; files of before say only that it is SI."""
    values = result.array(f"parameters/{name}", finite=False)
    finite = np.abs(values[np.isfinite(values)])
    return unit_for(finite.max(initial=0), result.unit(f"parameters/{name}"))


def draw_points(axes, result, names, force):
    """A point for each case. Returns the parameter along the axis."""
    name = next((one for one in names if result.is_number(f"parameters/{one}")), None)
    if name is None:
        raise ResultError(f"{result.path}: no parameter is a number")
    axes.plot(scale_of(result, name)[0] * result.array(f"parameters/{name}"), force, ".", markersize=3, color=INK)
    axes.axhline(0, color=INK3, linewidth=0.8)
    return name
