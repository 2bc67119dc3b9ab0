"""The creep curve through a case: forces over one creepage, the others held."""

import numpy as np

from microslip.picture_style import (INK2, INK3, LOOKS, THEORIES, bodies_of, halo, heading, names_above, new_figure, number,
                                     open_axes, put_title, the, unit_for, vanishing, with_unit)
from microslip.result_file import ResultError

# Name of the varied creepage: title, symbol, factor from SI, unit for an axis and behind a number.
CREEPAGES = {
    "creepage_longitudinal": (r"longitudinal creepage $\xi$", r"$\xi$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "creepage_lateral": (r"lateral creepage $\eta$", r"$\eta$", 1e3, r"$10^{-3}$", r"$\,\cdot\,10^{-3}$"),
    "spin": (r"spin $\phi$", r"$\phi$", 1, "1/m", " 1/m"),
}
FORCES = {"fx": "$F_x$", "fy": "$F_y$"}
# Room for the forces' names at the ends of the curves, in parts of the axis.
ROOM_FOR_NAMES = 0.03


def creep_curve_picture(result, theories):
    """Fx and Fy over the varied creepage by each theory, with the case itself and the Coulomb limit."""
    varied = result.group_attribute("/creep_curve", "variable")
    if varied not in CREEPAGES:
        raise ResultError(f"{result.path}: /creep_curve has variable '{varied}', known: {', '.join(CREEPAGES)}")
    title, _, factor, unit, _ = CREEPAGES[varied]
    limit = result.number("/creep_curve/limit")
    figure = new_figure(7.0, 4.9)
    axes = figure.subplots()
    open_axes(axes)
    curves = {theory: result.arrays([f"/creep_curve/{theory}/{name}" for name in ("value", *FORCES)]) for theory in theories}
    scale, force_unit = unit_for(max(np.abs(values[1:]).max() for values in curves.values()), "N")
    limit *= scale
    extremes = []
    for theory in theories:
        colour, dashes = LOOKS[theory]
        value, *forces = curves[theory]
        for force in forces:
            if vanishing(force, np.abs(forces).max()):
                continue  # by symmetry
            axes.plot(factor * value, scale * force, linestyle=dashes, color=colour, linewidth=1.8,
                      label=THEORIES[theory] if THEORIES[theory] not in axes.get_legend_handles_labels()[1] else None)
            extremes += [scale * force.min(), scale * force.max()]
    axes.axhline(0, color=INK2, linewidth=0.8)
    mark_limits(axes, limit, extremes, with_unit(limit / scale, "N"))
    if limit == 0:
        axes.set_ylim(-1, 1)  # no friction, no force
    low, high = axes.get_ylim()
    axes.set_ylim(low - 0.06 * (high - low), high + 0.06 * (high - low))  # lines stand off the frame, with words between
    name_forces(axes, factor, scale, curves[theories[-1]])
    mark_points(axes, result, theories, varied, scale)
    axes.set_xlabel(f"{title} [{unit}]")
    axes.set_ylabel(f"force on {the(bodies_of(result)[0])} [{force_unit}]")
    if limit > 0:
        relative = axes.secondary_yaxis("right", functions=(lambda force: force / limit, lambda ratio: ratio * limit))
        relative.set_ylabel(r"force / ($\mu F_n$) [-]")
    put_title(figure, f"{heading('Creep curve', result, theories)}\nheld: {held_creepages(result, varied)}\n"
                      + "\n".join(forces_of_case(result, theory) for theory in theories))
    names_above(axes)
    return figure


def name_forces(axes, factor, scale, curve):
    """The name of each force at the end of its curves."""
    value, *forces = curve
    side = 1 if value[-1] > value[0] else -1
    low, high = axes.get_xlim()
    axes.set_xlim(*((low, high + ROOM_FOR_NAMES * (high - low)) if side > 0 else (low - ROOM_FOR_NAMES * (high - low), high)))
    for name, force in zip(FORCES.values(), forces):
        if vanishing(force, np.abs(forces).max()):
            continue
        axes.annotate(name, (factor * value[-1], scale * force[-1]), xytext=(5 * side, 0), textcoords="offset points", va="center",
                      ha="left" if side > 0 else "right", size="large", path_effects=halo())


def forces_of_case(result, theory):
    """Both forces of the case itself by a theory, as text."""
    forces = {name: result.number(f"/{theory}/{name}") for name in FORCES}
    largest = max(map(abs, forces.values()))
    who = f"this case by {THEORIES[theory]}: " if theory != "exact" else "this case by the exact theory: "
    return who + ",  ".join(f"{FORCES[name]} = {with_unit(force, 'N', largest)}" for name, force in forces.items())


def creepage_of_case(result, name):
    """Returns it as given, or as found where a force is prescribed."""
    return result.number(f"/creep_curve/{name}")


def mark_points(axes, result, theories, varied, scale):
    """The case itself as each theory has it."""
    here = CREEPAGES[varied][2] * creepage_of_case(result, varied)
    axes.axvline(here, color=INK3, linewidth=0.9, linestyle=":")
    right = here > np.mean(axes.get_xlim())
    axes.annotate("this case", (here, 0.985), xycoords=("data", "axes fraction"), xytext=(-4 if right else 4, 0),
                  textcoords="offset points", ha="right" if right else "left", va="top", color=INK2, size="small", path_effects=halo())
    for theory in theories:
        forces = [result.number(f"/{theory}/{name}") for name in FORCES]
        for force in forces:
            if vanishing(force, np.abs(forces).max()) and any(forces):
                continue
            axes.plot([here], [scale * force], "o", markersize=5, zorder=5, markerfacecolor="white",
                      markeredgecolor=LOOKS[theory][0], markeredgewidth=1.4)


def mark_limits(axes, limit, extremes, text):
    """Dotted lines at the Coulomb limit, on the sides where the forces come near it."""
    if limit == 0:
        return
    for side in (-limit, limit):
        if max(extreme / side for extreme in extremes) > 0.5:
            axes.axhline(side, color=INK3, linestyle=(0, (1, 2)), linewidth=1.3)
            sign = "\N{MINUS SIGN}" if side < 0 else ""
            axes.annotate(rf"what friction can bear, {sign}$\mu F_n$ = {sign}{text}", (0.015, side), xycoords=("axes fraction", "data"),
                          xytext=(0, -3 if side < 0 else 3), textcoords="offset points", va="top" if side < 0 else "bottom",
                          color=INK2, size="small", path_effects=halo())


def held_creepages(result, varied):
    """The creepages that the curve keeps, as text."""
    texts = []
    for name, (_, symbol, factor, _, unit) in CREEPAGES.items():
        value = factor * creepage_of_case(result, name)
        if name != varied:
            texts.append(f"{symbol} = {number(value)}" + (unit if value else ""))
    return ",  ".join(texts)
