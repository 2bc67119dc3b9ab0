"""Style of all pictures: colours that colour-blind readers can tell apart, font sizes, axes, numbers as text."""

import math
import textwrap

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

BLACK = "#000000"
GREY = "#767676"
ORANGE = "#E69F00"
SKY_BLUE = "#56B4E9"
GREEN = "#009E73"
BLUE = "#0072B2"
VERMILION = "#D55E00"

SETTINGS = {
    "font.size": 10,
    "axes.titlesize": 10,
    "figure.titlesize": 12,
    "legend.fontsize": 9,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "legend.frameon": False,
    "hatch.linewidth": 0.6,
    "savefig.dpi": 150,
}

# The groups that a theory's results may stand in, and what pictures call them.
THEORIES = {
    "fastsim": "FASTSIM",
    "fastsim_half_step": "FASTSIM, half first step",
    "fastsim2": "FASTSIM2",
    "fastrip": "FaStrip",
    "table": "creep-force table",
    "exact": "exact theory",
}


# What forces are smaller than, in parts of the largest one, is rounding.
NOISE = 1e-9
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
# Prefixes that engineers use with these units, and the least number that they write with the first of them.
PREFIXES_OF = {"Pa": ("Mk", 0.1), "m": ("mµn", 1.0), "N": ("Mkmµn", 1.0)}
# Letters in a line of a title, in inches of the figure's width.
LETTERS_PER_INCH = 9.5


def label_of(contact):
    """Name of a contact of a result file in pictures: the theory that solved it, or the patch."""
    return THEORIES.get(contact, contact)


def heading(what, result, theories=()):
    """A figure's title: what it shows, the case's title, and which theory is of simpler bodies than the case's."""
    lines = [": ".join(part for part in (what, result.attribute("title", "rolling contact")) if part)]
    lines += [f"{THEORIES[theory]}: {result.assumption(theory)}" for theory in theories if result.assumption(theory)]
    return "\n".join(lines)


def put_title(figure, text):
    """The title of a figure, broken into lines that fit its width."""
    width = max(24, int(LETTERS_PER_INCH * figure.get_figwidth()))
    figure.suptitle("\n".join(part for line in text.split("\n") for part in (textwrap.wrap(line, width) or [""])))


def bodies_of(result):
    """Names of both bodies in pictures: those of a wheel on a rail if body 2 is straight where it rolls and body 1 is not."""
    if result.attribute("kind", "") in ("wheel_rail", "wheelset"):
        return "wheel", "rail"
    if any(f"/inputs/body{body}/rolling_radius" not in result for body in (1, 2)):
        return "body 1", "body 2"
    upper, lower = (float(result.array(f"/inputs/body{body}/rolling_radius", dimensions=0, finite=False)) for body in (1, 2))
    across = float(result.array("/inputs/body2/transverse_radius", dimensions=0, finite=False))
    if np.isfinite(upper) and np.isinf(lower):
        return ("wheel", "rail") if np.isfinite(across) and upper > 0 else ("body 1", "body 2")
    if np.isfinite(upper) and np.isfinite(lower):
        return ("upper roller", "lower roller") if min(upper, lower) > 0 else ("roller", "ring")[:: 1 if upper > 0 else -1]
    return "body 1", "body 2"


def the(body):
    """A body in a sentence."""
    return body if body.startswith("body") else f"the {body}"


def unit_for(largest, unit):
    """The factor and the name of the unit that numbers up to a largest one are written in: 35 N, 14 kN, 0.3 MPa."""
    base = unit.split("/")[0].split(" ")[0]
    letters, least = PREFIXES_OF.get(base, ("MkmµnG", 1.0))
    if base not in ("Pa", "m", "N", "W", "J") or (base == "m" and unit != base):
        return 1.0, unit
    usable = [(size, letter) for size, letter in PREFIXES if letter in letters and (letter or base != "m")]
    size, letter = next(((size, letter) for size, letter in usable
                         if abs(largest) >= (least if letter == letters[0] else 1) * size * (1 - 1e-9)), usable[-1])
    if not largest or not np.isfinite(largest):
        size, letter = next(((size, letter) for size, letter in usable if size == {"Pa": 1e6, "m": 1e-3}.get(base, 1.0)))
    return 1 / size, letter + unit


def shown(values, largest, noise=NOISE):
    """Numbers without what is rounding compared with the largest one, which becomes 0."""
    return np.where(np.abs(values) < noise * abs(largest), 0.0, values)


def with_unit(value, unit, largest=None):
    """A number in SI with a unit that suits it, e.g. 12.30 kN; what is rounding beside `largest` is 0."""
    factor, name = unit_for(value if abs(value) > NOISE * abs(largest or 0) else largest or 0, unit)
    return quantity(factor * float(shown(value, largest or 0)), name)


def new_figure(width, height, layout="constrained"):
    """An empty figure of a size in inches, drawn without a window system. Layout `compressed` suits equal scales."""
    figure = Figure(figsize=(width, height), layout=layout)
    FigureCanvasAgg(figure)
    return figure


def open_axes(axes):
    """Removes the frame's upper and right side and draws a faint grid."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(True, color="0.9", linewidth=0.6)
    axes.set_axisbelow(True)


def number(value):
    """A number with up to four digits and a true minus sign."""
    return f"{value:.4g}".replace("-", "\N{MINUS SIGN}")


def quantity(value, unit):
    """A number with four digits and its unit, e.g. 12.30 kN; what is zero but for rounding is 0."""
    text = f"{value:#.4g}".rstrip(".") if abs(value) > 1e-9 else "0"
    return text.replace("-", "\N{MINUS SIGN}") + " " + unit


def round_down(value):
    """The largest of 1, 2, 5 times a power of ten that is not above a positive value."""
    decade = 10.0 ** math.floor(math.log10(value))
    return max(step * decade for step in (1, 2, 5) if step * decade <= value * (1 + 1e-12))


def round_up(value):
    """The smallest of 1, 2, 5, 10 times a power of ten that is not below a positive value."""
    decade = 10.0 ** math.floor(math.log10(value))
    return min(step * decade for step in (1, 2, 5, 10) if step * decade >= value * (1 - 1e-12))
