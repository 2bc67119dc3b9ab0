"""Style of all pictures: one colour for one meaning, maps of even lightness, font sizes, axes, numbers as text.

Colours are told apart by colour-blind readers; blue and orange always stand with a line or a word. A picture is drawn in one of
STYLES: sizes in inches are those of the first one, the others scale them.
"""

import math
import textwrap

import matplotlib
import numpy as np
from cycler import cycler
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import Collection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation

from microslip.result_file import ResultError

# Text and lines: of what matters, of labels, of what is minor, of frames and grids.
INK, INK2, INK3, LINE, GRID = "#17212b", "#4a5865", "#67747f", "#c4cbd2", "#dfe3e7"
STICKS, SLIDES, SOFT_STICKS, SOFT_SLIDES = "#4d8fd1", "#cf7a1e", "#dbe9f8", "#fbe6cf"
WHEEL, WHEEL_FILL, RAIL, RAIL_FILL = "#3d5166", "#c3cedb", "#66543f", "#e0d5c6"
ROLLING = "#0b6b78"  # the rolling direction, and points to look at
# Components along and across the rolling direction.
ALONG, ACROSS = "#4b3fb0", "#8a6a00"
# Curves that stand for nothing of the above.
MAGENTA, GREEN = "#a3267f", "#1d9a86"
RED = "#a3182b"
SERIES = (INK, MAGENTA, GREEN, ALONG, ACROSS, RED)
LINES = SERIES[3:] + SERIES[:3]  # those of theories last

# Maps of even steps of lightness: sizes, friction where it sticks and where it slides, and values of both signs.
SIZES = LinearSegmentedColormap.from_list("microslip_sizes", ("#faf9de", "#cfe6be", "#93d6b2", "#5dc0b4", "#2ca6b8", "#1589b0",
                                                              "#1e6ca4", "#22518f", "#243779"))
STICKING = LinearSegmentedColormap.from_list("microslip_sticks", ("#edf5fb", "#d6e7f5", "#bfd9ee", "#a9cbe8", "#94bde2", "#7eafdb",
                                                                  "#69a1d5", "#5493ce", "#3e84c8"))
SLIDING = LinearSegmentedColormap.from_list("microslip_slides", ("#faf3e5", "#f1e2ca", "#e9d2b0", "#e3c096", "#dcae7c", "#d69c63",
                                                                 "#d0894a", "#ca7630", "#c3610d"))
SIZES_OF_LINES = LinearSegmentedColormap.from_list("microslip_sizes_of_lines", SIZES(np.linspace(0.3, 1, 9)))  # seen on white
SIGNED = matplotlib.colormaps["PuOr"]

SETTINGS = {
    "figure.figsize": (6.4, 4.8),
    "font.size": 10,
    "figure.titlesize": 12,
    "figure.titleweight": "bold",
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.titlecolor": INK,
    "axes.labelcolor": INK2,
    "axes.edgecolor": LINE,
    "axes.linewidth": 0.8,
    "axes.prop_cycle": cycler(color=SERIES),
    "grid.color": GRID,
    "grid.linewidth": 0.7,
    "text.color": INK,
    "xtick.color": LINE,
    "ytick.color": LINE,
    "xtick.labelcolor": INK2,
    "ytick.labelcolor": INK2,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "lines.dash_joinstyle": "round",
    "legend.fontsize": 9,
    "legend.frameon": False,
    "hatch.linewidth": 0.6,
    "savefig.dpi": 150,
    "savefig.bbox": "tight",  # no empty margins
    "savefig.pad_inches": 0.08,
}

# What each style changes. A width of 7 inches becomes a paper's column of 85 mm, one of 14 its page of 170 mm; slides are read
# from afar.
STYLES = {
    "page": {},
    "paper": {"figure.figsize": (3.06, 2.295), "font.size": 7, "figure.titlesize": 7.5, "axes.titlesize": 7, "xtick.labelsize": 6.5,
              "ytick.labelsize": 6.5, "legend.fontsize": 6.5, "axes.linewidth": 0.6, "savefig.dpi": 300},
    "slides": {"figure.figsize": (7.2, 5.4), "font.size": 14, "figure.titlesize": 17, "axes.titlesize": 14, "xtick.labelsize": 13,
               "ytick.labelsize": 13, "legend.fontsize": 13, "axes.linewidth": 1.2, "savefig.dpi": 200},
}


LINE_SCALES = {"page": 1, "paper": 0.6, "slides": 1.3}


def settings_of(style):
    """The settings of matplotlib of one of STYLES."""
    return {**SETTINGS, **STYLES[style]}


def style(name="page"):
    """A context in which figures get a style: `with style("paper"): ...`. Throws for a name that is not in STYLES."""
    if name not in STYLES:
        raise ResultError(f"style '{name}': must be one of {', '.join(STYLES)}")
    return matplotlib.rc_context(settings_of(name))


# The groups that a theory's results may stand in, and what pictures call them.
THEORIES = {
    "fastsim": "FASTSIM",
    "fastsim_half_step": "FASTSIM, half first step",
    "fastsim2": "FASTSIM2",
    "fastrip": "FaStrip",
    "table": "creep-force table",
    "exact": "exact theory",
}
# Colour and dashes of each theory's curves.
LOOKS = {
    "fastsim": (INK3, (0, (1, 1.2))),
    "fastsim_half_step": (INK3, (0, (4, 1.2, 1, 1.2, 1, 1.2))),
    "fastsim2": (MAGENTA, "--"),
    "fastrip": (ALONG, (0, (6, 1.5, 1, 1.5))),
    "table": (GREEN, "-."),
    "exact": (INK, "-"),
}


# What forces are smaller than, in parts of the largest one, is rounding.
NOISE = 1e-9
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "µ"), (1e-9, "n"))
# Prefixes that engineers use with these units, and the least number that they write with the first of them.
PREFIXES_OF = {"Pa": ("Mk", 0.1), "m": ("mµn", 1.0), "N": ("Mkmµn", 1.0)}
# Heights of lines of an explanation, in parts of a title's line at the same size.
LINE_OF_TEXT, LINE_WITH_SYMBOLS = 1.05, 1.3
# Letters in a line of an explanation, in parts of those of a title: without symbols, and with some, whose names are longer than they.
LETTERS_OF_TEXT, LETTERS_OF_SYMBOLS = 1.15, 1.8
# The widest legend above axes, in parts of their share of the figure.
WIDTH_OF_LEGEND = 0.84
# Letters in a line of a title, in inches of the figure's width.
LETTERS_PER_INCH = 9.5
# The longest label of a y-axis, in parts of the axis, and how small it may be made in parts of its size.
LENGTH_OF_LABEL, LEAST_OF_LABEL = 1.25, 0.75


def label_of(contact):
    """Name of a contact of a result file in pictures: the theory that solved it, or the patch."""
    return THEORIES.get(contact, contact)


def heading(what, result, theories=()):
    """A figure's title: what it shows, the case's title, and which theory is of simpler bodies than the case's."""
    lines = [": ".join(part for part in (what, result.attribute("title", "rolling contact")) if part)]
    lines += [f"{THEORIES[theory]}: {result.assumption(theory)}" for theory in theories if result.assumption(theory)]
    return "\n".join(lines)


def put_title(figure, text):
    """The title of a figure, or of a part of one, at its left: the first line in bold, the others below it as its explanation, broken to the width."""
    size = FontProperties(size=matplotlib.rcParams["figure.titlesize"]).get_size_in_points()
    letters = LETTERS_PER_INCH * figure.bbox.width / figure.dpi * SETTINGS["figure.titlesize"] / size
    first, *others = text.split("\n")
    title = textwrap.wrap(first, max(24, int(letters))) or [""]
    below = [part for line in others
             for part in textwrap.wrap(line, max(24, int(letters * (LETTERS_OF_SYMBOLS if "$" in line else LETTERS_OF_TEXT))))]
    height = sum(LINE_WITH_SYMBOLS if "$" in line else LINE_OF_TEXT for line in below) * matplotlib.rcParams["font.size"] / size
    figure.suptitle("\n".join(title + [" "] * math.ceil(height + 0.2 * bool(below))), x=0.008, ha="left")
    if below:
        explanation = Annotation("\n".join(below), (0, 1), xycoords=figure._suptitle, va="top", color=INK2, annotation_clip=False,
                                 xytext=(0, -1.25 * size * len(title)), textcoords="offset points")
        explanation.set_in_layout(False)
        figure.add_artist(explanation)


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
    """An empty figure, drawn without a window system, of a size in inches that the style in force scales. Layout `compressed`
    suits equal scales."""
    scale = matplotlib.rcParams["figure.figsize"][0] / SETTINGS["figure.figsize"][0]
    figure = Figure(figsize=(scale * width, scale * height), layout=layout)
    FigureCanvasAgg(figure)
    return figure


def names_above(axes, most=4, **how):
    """A legend above the axes, in as many columns as fit their width."""
    handles, labels = axes.get_legend_handles_labels()
    grid = axes.get_subplotspec().get_gridspec()
    width = WIDTH_OF_LEGEND * axes.figure.bbox.width / grid.ncols
    for columns in range(min(most, len(handles)), 0, -1):
        legend = axes.legend(handles, labels, loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncols=columns, borderaxespad=0.1,
                             handlelength=2.6, columnspacing=1.4, **how)
        if legend.get_window_extent(axes.figure.canvas.get_renderer()).width <= width:
            break


def scale_lines(figure, style_name):
    """Makes the lines and marks of a figure thinner or bolder, as its style's letters are smaller or larger."""
    factor = LINE_SCALES[style_name]
    if factor == 1:
        return
    for artist in figure.findobj(lambda one: isinstance(one, (Line2D, Patch, Collection))):
        artist.set_linewidth(factor * np.asarray(artist.get_linewidth()))
        if isinstance(artist, Line2D):
            artist.set_markersize(factor * artist.get_markersize())
            artist.set_markeredgewidth(factor * artist.get_markeredgewidth())


def in_two_lines(label):
    """A label broken at the space next to its middle; as it is without one, or where it has two lines already."""
    spaces = [k for k, letter in enumerate(label) if letter == " " and label[:k].count("$") % 2 == 0]
    if "\n" in label or not spaces:
        return label
    place = min(spaces, key=lambda k: abs(k - len(label) / 2))
    return f"{label[:place]}\n{label[place + 1:]}"


def fit_labels(figure):
    """Breaks labels of y-axes that are longer than their axes by a quarter, and makes those smaller that still are."""
    figure.draw_without_rendering()
    for axes in (one for one in figure.axes if one.name != "3d"):
        label = axes.yaxis.label
        longest = LENGTH_OF_LABEL * axes.bbox.height
        if label.get_window_extent().height > longest:
            label.set_text(in_two_lines(label.get_text()))
            share = longest / max(label.get_window_extent().height, 1)
            label.set_fontsize(label.get_size() * min(1, max(share, LEAST_OF_LABEL)))


def adapt(figure, style_name):
    """Makes of a figure what its style asks for."""
    scale_lines(figure, style_name)
    if style_name != "page":
        fit_labels(figure)


def vanishing(values, largest):
    """Returns whether a curve is nothing but rounding beside the largest value, as a component that is zero by symmetry."""
    return bool(np.nanmax(np.abs(values), initial=0) <= NOISE * abs(largest))


def halo(width=2.6):
    """A white rim around text or lines that stand on colours."""
    return [withStroke(linewidth=width, foreground="white")]


def open_axes(axes):
    """Removes the frame's upper and right side and draws a faint grid."""
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(True)
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
