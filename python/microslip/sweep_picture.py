"""The forces of a sweep over one of its parameters."""

import math
from dataclasses import dataclass

import numpy as np

from microslip.creep_curve_picture import CREEPAGES
from microslip.picture_style import (INK, INK3, LINES, LOOKS, THEORIES, heading, names_above, new_figure, number, open_axes, put_title, shown,
                                     unit_for)
from microslip.result_file import ResultError

# What is drawn, of which there are the first three, with its symbol.
FORCES = {f"{group}/{name}": f"{symbol} on {body}"
          for group, body, names in (("contact", "body 1", ("fx", "fy", "mz")),
                                     ("wheel", "the wheel", ("force_x", "force_y", "moment_z")),
                                     ("wheelset", "the wheelset", ("force_x", "force_y", "moment_z")))
          for name, symbol in zip(names, ("$F_x$", "$F_y$", "$M_z$"))}
THEORY = "solution.theory"
MOST_LINES = 12


def sweep_pictures(result):
    """Draw one panel for each force: of a grid lines over the parameter with most numbers, one for each combination of the
    others; of a list or a sample points over its first parameter."""
    quantities = quantities_of(result)
    if not quantities:
        raise ResultError(f"{result.path}: has no quantities")
    figure = new_figure(7.0, 1.2 + 2.4 * len(quantities))
    panels = np.atleast_1d(figure.subplots(len(quantities), sharex=True))
    (draw_grid if "shape" in result else draw_points)(panels, result, quantities)
    for axes in panels:
        open_axes(axes)
    names_above(panels[0], most=2, fontsize="small")
    put_title(figure, heading("Sweep", result))
    return {"sweep.png": figure}


def quantities_of(result):
    """Names of what is drawn of a sweep: its forces, or else its first quantities."""
    return ([name for name in FORCES if name in result] or result.numbers_of(("contact", "wheel", "wheelset", "left", "right")))[:3]


def label_of_quantity(name, unit):
    """Label of an axis."""
    return f"{FORCES.get(name, name)} [{unit}]"


def columns_of(result, quantities):
    """The values of quantities; of forces what is rounding beside the largest is 0."""
    columns = {name: result.array(name, finite=False) for name in quantities}
    largest = max(np.nanmax(np.abs(values), initial=0) for values in columns.values())
    return {name: shown(values, largest) if name in FORCES else values for name, values in columns.items()}


def is_logarithmic(values):
    """Returns whether positive values have rather constant ratios than constant differences."""
    if len(values) < 4 or values.min() <= 0 or values.max() < 20 * values.min():
        return False
    return np.ptp(np.diff(np.log(values))) < np.ptp(np.diff(values)) / np.abs(np.diff(values)).max() * math.log(10)


@dataclass(frozen=True)
class GridCurves:
    """Curves of a grid over the parameter with most numbers: x as it is shown, for each combination of the others its theory
    (empty: none varies) and the rest as text, and of each quantity values (combinations, x)."""

    name: str
    x: np.ndarray
    theories: list
    others: list
    values: dict
    combinations: int

    def labels(self):
        """What each curve is of."""
        return [", ".join(part for part in (THEORIES.get(theory, theory), other) if part)
                for theory, other in zip(self.theories, self.others)]

    def put_axis(self, axes, result):
        """The scale and the label along the parameter."""
        if is_logarithmic(self.x):
            axes.set_xscale("log")
        axes.set_xlabel(label_of_parameter(result, self.name))


def curves_of_grid(result, quantities):
    """The curves of a grid; of very many combinations some, evenly chosen."""
    if "shape" not in result:
        raise ResultError(f"{result.path}: has curves only as a grid; a list or a sample has points")
    names, shape = result.attribute("parameters").split("\n"), result.array("shape")
    numbers = [place for place, one in enumerate(names) if result.is_number(f"parameters/{one}") and shape[place] > 1]
    if not numbers:
        raise ResultError(f"{result.path}: no parameter of the grid has two numbers")
    along = max(numbers, key=lambda place: (shape[place], place))  # of equals the last, which varies fastest
    name = names[along]
    at = np.moveaxis(np.arange(np.prod(shape)).reshape(shape), along, -1).reshape(-1, shape[along])  # numbers of the cases
    x = scale_of(result, name)[0] * result.array(f"parameters/{name}")[at[0]]
    lines = np.unique(np.linspace(0, len(at) - 1, MOST_LINES).round().astype(int))
    varying = [one for place, one in enumerate(names) if one != name and shape[place] > 1]
    others = [", ".join(parameter_text(result, one, at[line, 0]) for one in varying if one != THEORY) for line in lines]
    theories = [result.entry(f"parameters/{THEORY}", at[line, 0]) if THEORY in varying else "" for line in lines]
    values = {quantity: column[at[lines]] for quantity, column in columns_of(result, quantities).items()}
    return GridCurves(name, x, theories, others, values, len(at))


def draw_grid(panels, result, quantities):
    """Lines: colours tell the combinations, dashes the theories, if these vary; if nothing else does they have their colours."""
    grid = curves_of_grid(result, quantities)
    kinds = list(dict.fromkeys(grid.others))
    for axes, quantity in zip(panels, quantities):
        factor, unit = unit_for(np.nanmax(np.abs(grid.values[quantity]), initial=0), result.unit(quantity))
        for values, label, theory, other in zip(grid.values[quantity], grid.labels(), grid.theories, grid.others):
            place = kinds.index(other)
            colour, dashes = LINES[place % len(LINES)], "-" if place < len(LINES) else "--"
            if theory in LOOKS:
                colour, dashes = LOOKS[theory] if len(kinds) == 1 else (colour, LOOKS[theory][1])
            axes.plot(grid.x, factor * values, color=colour, linestyle=dashes, linewidth=1.6, label=label)
        axes.set_ylabel(label_of_quantity(quantity, unit))
        if len(grid.others) < grid.combinations:
            axes.set_title(f"{len(grid.others)} of {grid.combinations} combinations")
    grid.put_axis(panels[-1], result)


def parameter_text(result, name, case):
    """A parameter of a case for a legend."""
    value = result.entry(f"parameters/{name}", case)
    symbol = CREEPAGES[name.split(".")[-1]][1] if is_creepage(name) else name
    if not isinstance(value, float):
        return f"{symbol} = {value}"
    factor, unit = scale_of(result, name)
    return f"{symbol} = {number(factor * value)}" + ("" if unit in ("-", "SI") else f" {unit}")


def is_creepage(name):
    """Returns whether a parameter is a creepage, which has words and a symbol."""
    return name.startswith("motion.") and name.split(".")[-1] in CREEPAGES


def label_of_parameter(result, name):
    """Label of an axis."""
    words = CREEPAGES[name.split(".")[-1]][0] if is_creepage(name) else name
    return f"{words} [{scale_of(result, name)[1]}]"


def scale_of(result, name):
    """The factor and the unit in which a parameter is shown; files of before say only that it is SI."""
    values = result.array(f"parameters/{name}", finite=False)
    finite = np.abs(values[np.isfinite(values)])
    return unit_for(finite.max(initial=0), result.unit(f"parameters/{name}"))


def draw_points(panels, result, quantities):
    """A point for each case."""
    names = result.attribute("parameters").split("\n")
    name = next((one for one in names if result.is_number(f"parameters/{one}")), None)
    if name is None:
        raise ResultError(f"{result.path}: no parameter is a number")
    for axes, (quantity, values) in zip(panels, columns_of(result, quantities).items()):
        factor, unit = unit_for(np.nanmax(np.abs(values), initial=0), result.unit(quantity))
        axes.plot(scale_of(result, name)[0] * result.array(f"parameters/{name}"), factor * values, ".", markersize=3, color=INK)
        axes.axhline(0, color=INK3, linewidth=0.8)
        axes.set_ylabel(label_of_quantity(quantity, unit))
    panels[-1].set_xlabel(label_of_parameter(result, name))
