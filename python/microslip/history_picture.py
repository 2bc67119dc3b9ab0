"""Transient rolling: forces and creepages over the distance rolled."""

import numpy as np

from microslip.picture_style import (ACROSS, ALONG, bodies_of, heading, names_above, new_figure, number, open_axes,
                                     put_title, shown, the, unit_for)

# Colour and dashes of components along and across.
LOOKS_OF_COMPONENTS = ((ALONG, "-"), (ACROSS, "--"))
# Numbers that change by less than this share of the largest one are constant.
CONSTANT = 1e-9


def history_picture(result):
    """Forces on body 1 over the distance rolled in mm; creepages below, or as text where they are constant."""
    distance, *values = result.arrays(
        [f"/exact/history/{name}" for name in ("distance", "fx", "fy", "creepage_longitudinal", "creepage_lateral")])
    forces, creepages = values[:2], [1e3 * one for one in values[2:]]
    largest = np.abs(forces).max()
    factor, unit = unit_for(largest, "N")
    changes = [np.ptp(one) > CONSTANT * np.abs(creepages).max() for one in creepages]
    figure = new_figure(7.0, 5.6 if any(changes) else 4.2)
    held = [f"{symbol} = {number(one[0])}" + (r"$\,\cdot\,10^{-3}$" if one[0] else "")
            for symbol, one, changing in zip((r"$\xi$", r"$\eta$"), creepages, changes) if not changing]
    put_title(figure, heading("Transient rolling", result) + (f"\nheld: {',  '.join(held)}" if held else ""))
    panels = np.atleast_1d(figure.subplots(1 + any(changes), sharex=True))
    draw_components(panels[0], distance, [factor * shown(one, largest) for one in forces], ("$F_x$", "$F_y$"), (True, True))
    panels[0].set_ylabel(f"force on {the(bodies_of(result)[0])} [{unit}]")
    if any(changes):
        draw_components(panels[1], distance, creepages, (r"$\xi$", r"$\eta$"), changes)
        panels[1].set_ylabel(r"creepage [$10^{-3}$]")
    panels[-1].set_xlabel("distance rolled [mm]")
    return figure


def draw_components(axes, distance, values, symbols, wanted):
    """The wanted ones of two components over the distance."""
    open_axes(axes)
    for (colour, dashes), value, symbol, one in zip(LOOKS_OF_COMPONENTS, values, symbols, wanted):
        if one:
            axes.plot(1e3 * distance, value, dashes, color=colour, marker="." if len(distance) < 60 else "", linewidth=1.8, label=symbol)
    names_above(axes)
