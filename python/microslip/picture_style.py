"""What all pictures share: colours that colour-blind readers can tell apart, font sizes, axes, numbers as text."""

import math

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
    "exact": "exact theory",
}


def heading(what, result, theories=()):
    """A figure's title: what it shows, the case's title, and which theory is of simpler bodies than the case's."""
    lines = [f"{what}: {result.attribute('title', 'rolling contact')}"]
    lines += [f"{THEORIES[theory]}: {result.assumption(theory)}" for theory in theories if result.assumption(theory)]
    return "\n".join(lines)


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
