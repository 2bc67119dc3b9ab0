"""Transient rolling: forces and creepages over the distance rolled."""

import numpy as np

from microslip.picture_style import BLUE, VERMILION, bodies_of, heading, new_figure, open_axes, put_title, shown, the, unit_for

COMPONENTS = (("x", BLUE), ("y", VERMILION))


def history_picture(result):
    """Forces on body 1 above, creepages below, over the distance rolled in mm."""
    distance, fx, fy, creepage_longitudinal, creepage_lateral = result.arrays(
        [f"/exact/history/{name}" for name in ("distance", "fx", "fy", "creepage_longitudinal", "creepage_lateral")])
    figure = new_figure(7.2, 5.6)
    above, below = figure.subplots(2, 1, sharex=True)
    largest = np.abs([fx, fy]).max()
    factor_of_force, unit = unit_for(largest, "N")
    fx, fy = shown(fx, largest), shown(fy, largest)
    marker = "." if len(distance) < 60 else ""
    for axes, values, factor, symbols in ((above, (fx, fy), factor_of_force, ("$F_x$", "$F_y$")),
                                          (below, (creepage_longitudinal, creepage_lateral), 1e3, (r"$\xi$", r"$\eta$"))):
        open_axes(axes)
        for (_, colour), value, symbol in zip(COMPONENTS, values, symbols):
            axes.plot(1e3 * distance, factor * value, color=colour, marker=marker, linewidth=2, label=symbol)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    above.set_ylabel(f"force on {the(bodies_of(result)[0])} [{unit}]")
    below.set_ylabel(r"creepage [$10^{-3}$]")
    below.set_xlabel("distance rolled [mm]")
    put_title(figure, heading("Transient rolling", result))
    return figure
