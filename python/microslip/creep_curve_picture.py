"""The creep curve through a case: forces over one creepage, the others held."""

from microslip.picture_style import (BLACK, BLUE, GREY, THEORIES, VERMILION, new_figure, number, open_axes,
                                     quantity)
from microslip.result_file import ResultError

# Name of the varied creepage: title, symbol, factor from SI, unit for an axis and behind a number.
CREEPAGES = {
    "creepage_longitudinal": (r"longitudinal creepage $\xi$", r"$\xi$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "creepage_lateral": (r"lateral creepage $\eta$", r"$\eta$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "spin": (r"spin $\phi$", r"$\phi$", 1, "1/m", " 1/m"),
}
FORCES = {"fx": ("$F_x$", BLUE), "fy": ("$F_y$", VERMILION)}
POINT_MARKERS = {"fastsim": "s", "fastsim_half_step": "^", "fastsim2": "o", "exact": "D"}


def creep_curve_picture(result, theories):
    """Fx and Fy in kN over the varied creepage, with the case itself and the Coulomb limit."""
    varied = result.group_attribute("/creep_curve", "variable")
    if varied not in CREEPAGES:
        raise ResultError(f"{result.path}: /creep_curve has variable '{varied}', known: {', '.join(CREEPAGES)}")
    title, _, factor, unit, _ = CREEPAGES[varied]
    limit = 1e-3 * result.number("/inputs/friction_coefficient") * result.number("/inputs/normal_force")
    value, *forces = result.arrays([f"/creep_curve/{name}" for name in ("value", *FORCES)])
    figure = new_figure(7.2, 4.8)
    axes = figure.subplots()
    open_axes(axes)
    for (label, colour), force in zip(FORCES.values(), forces):
        axes.plot(factor * value, 1e-3 * force, color=colour, linewidth=2, label=label)
    mark_points(axes, result, theories, factor)
    mark_limits(axes, limit, [1e-3 * extreme for force in forces for extreme in (force.min(), force.max())])
    axes.axhline(0, color=BLACK, linewidth=0.8)
    axes.set_xlabel(f"{title} [{unit}]")
    axes.set_ylabel("force on the wheel [kN]")
    relative = axes.secondary_yaxis("right", functions=(lambda force: force / limit, lambda ratio: ratio * limit))
    relative.set_ylabel(r"force / ($\mu F_n$) [-]")
    figure.suptitle(f"Creep curve: {result.attribute('title', 'rolling contact')}")
    axes.set_title(f"{curve_theory(result, theories)}, held: {held_creepages(result, varied)}")
    axes.legend(loc="best", frameon=True, framealpha=0.9, edgecolor="none")
    return figure


def mark_points(axes, result, theories, factor):
    """The case itself: on the curve, and as the other theories have it."""
    here = factor * result.number("/creep_curve/point_value")
    own = result.text("/inputs/theory")
    for theory in theories:
        for name, (label, colour) in FORCES.items():
            source = f"/creep_curve/point_{name}" if theory == own else f"/{theory}/{name}"
            force = 1e-3 * result.number(source)
            look = {"markersize": 8, "markerfacecolor": colour, "markeredgecolor": BLACK}
            if theory != own:
                look = {"markersize": 13, "markerfacecolor": "none", "markeredgecolor": colour, "markeredgewidth": 2}
            who = "this case" if len(theories) == 1 else f"this case, {THEORIES[theory]}"
            axes.plot([here], [force], POINT_MARKERS[theory], zorder=5,
                      label=f"{who}: {label} = {quantity(force, 'kN')}", **look)


def mark_limits(axes, limit, extremes):
    """Dashed lines at the Coulomb limit, on the sides where the forces come near it."""
    label = rf"$\pm\mu F_n$ = {quantity(limit, 'kN')}"
    for side in (-limit, limit):
        if max(extreme / side for extreme in extremes) > 0.5:
            axes.axhline(side, color=GREY, linestyle="--", linewidth=1.5, label=label)
            label = None


def held_creepages(result, varied):
    """The creepages that the curve keeps, as text."""
    texts = []
    for name, (_, symbol, factor, _, unit) in CREEPAGES.items():
        value = factor * result.number(f"/inputs/{name}")
        if name != varied:
            texts.append(f"{symbol} = {number(value)}" + (unit if value else ""))
    return ",  ".join(texts)


def curve_theory(result, theories):
    """Name of the theory that the curve was computed with."""
    return THEORIES.get(result.text("/inputs/theory"), THEORIES[theories[0]])
