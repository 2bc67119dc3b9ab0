"""The creep curve through a case: forces over one creepage, the others held."""

import numpy as np

from microslip.picture_style import (BLACK, BLUE, GREY, THEORIES, VERMILION, bodies_of, heading, new_figure, number, open_axes,
                                     put_title, the, unit_for, with_unit)
from microslip.result_file import ResultError

# Name of the varied creepage: title, symbol, factor from SI, unit for an axis and behind a number.
CREEPAGES = {
    "creepage_longitudinal": (r"longitudinal creepage $\xi$", r"$\xi$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "creepage_lateral": (r"lateral creepage $\eta$", r"$\eta$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "spin": (r"spin $\phi$", r"$\phi$", 1, "1/m", " 1/m"),
}
FORCES = {"fx": ("$F_x$", BLUE), "fy": ("$F_y$", VERMILION)}
# For the last theory of a picture, and for those before it.
LINE_STYLES = {True: "-", False: "--"}
POINT_MARKERS = {"fastsim": "s", "fastsim_half_step": "^", "fastsim2": "o", "fastrip": "v", "table": "P", "exact": "D"}


def creep_curve_picture(result, theories):
    """Fx and Fy over the varied creepage by each theory, with the case itself and the Coulomb limit."""
    varied = result.group_attribute("/creep_curve", "variable")
    if varied not in CREEPAGES:
        raise ResultError(f"{result.path}: /creep_curve has variable '{varied}', known: {', '.join(CREEPAGES)}")
    title, _, factor, unit, _ = CREEPAGES[varied]
    limit = result.number("/creep_curve/limit")
    figure = new_figure(7.2, 5.4 if len(theories) == 1 else 6.4)
    axes = figure.subplots()
    open_axes(axes)
    curves = {theory: result.arrays([f"/creep_curve/{theory}/{name}" for name in ("value", *FORCES)]) for theory in theories}
    scale, force_unit = unit_for(max(np.abs(values[1:]).max() for values in curves.values()), "N")
    limit *= scale
    extremes = []
    for theory in theories:
        value, *forces = curves[theory]
        for (label, colour), force in zip(FORCES.values(), forces):
            if len(theories) > 1:
                label += f", {THEORIES[theory]}"
            axes.plot(factor * value, scale * force, LINE_STYLES[theory == theories[-1]], color=colour, linewidth=2,
                      label=label)
            extremes += [scale * force.min(), scale * force.max()]
    mark_points(axes, result, theories, varied, scale)
    mark_limits(axes, limit, extremes, with_unit(limit / scale, "N"))
    axes.axhline(0, color=BLACK, linewidth=0.8)
    if limit == 0:
        axes.set_ylim(-1, 1)  # no friction, no force
    low, high = axes.get_ylim()
    axes.set_ylim(low - 0.03 * (high - low), high + 0.03 * (high - low))  # lines stand off the frame
    axes.set_xlabel(f"{title} [{unit}]")
    axes.set_ylabel(f"force on {the(bodies_of(result)[0])} [{force_unit}]")
    if limit > 0:
        relative = axes.secondary_yaxis("right", functions=(lambda force: force / limit, lambda ratio: ratio * limit))
        relative.set_ylabel(r"force / ($\mu F_n$) [-]")
    put_title(figure, heading("Creep curve", result, theories))
    who = " and ".join(THEORIES[theory] for theory in theories)
    axes.set_title(f"{who}, held: {held_creepages(result, varied)}")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2)
    return figure


def creepage_of_case(result, name):
    """Returns it as given, or as found where a force is prescribed."""
    return result.number(f"/creep_curve/{name}")


def mark_points(axes, result, theories, varied, scale):
    """The case itself as each theory has it; the last one's as filled markers."""
    here = CREEPAGES[varied][2] * creepage_of_case(result, varied)
    largest = max(abs(result.number(f"/{theory}/{name}")) for theory in theories for name in FORCES)
    for theory in theories:
        for name, (label, colour) in FORCES.items():
            force = result.number(f"/{theory}/{name}")
            look = {"markersize": 8, "markerfacecolor": colour, "markeredgecolor": BLACK}
            if theory != theories[-1]:
                look = {"markersize": 13, "markerfacecolor": "none", "markeredgecolor": colour, "markeredgewidth": 2}
            who = "this case" if len(theories) == 1 else f"this case, {THEORIES[theory]}"
            axes.plot([here], [scale * force], POINT_MARKERS[theory], linestyle="none", zorder=5,
                      label=f"{who}: {label} = {with_unit(force, 'N', largest)}", **look)


def mark_limits(axes, limit, extremes, text):
    """Dashed lines at the Coulomb limit, on the sides where the forces come near it."""
    label = rf"$\pm\mu F_n$ = {text}"
    if limit == 0:
        return
    for side in (-limit, limit):
        if max(extreme / side for extreme in extremes) > 0.5:
            axes.axhline(side, color=GREY, linestyle="--", linewidth=1.5, label=label)
            label = None


def held_creepages(result, varied):
    """The creepages that the curve keeps, as text."""
    texts = []
    for name, (_, symbol, factor, _, unit) in CREEPAGES.items():
        value = factor * creepage_of_case(result, name)
        if name != varied:
            texts.append(f"{symbol} = {number(value)}" + (unit if value else ""))
    return ",  ".join(texts)
