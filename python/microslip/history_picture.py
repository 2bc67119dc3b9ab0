"""Transient rolling: forces and creepages over the distance rolled."""

from microslip.picture_style import BLUE, VERMILION, new_figure, open_axes

COMPONENTS = (("x", BLUE), ("y", VERMILION))


def history_picture(result):
    """Forces on body 1 in kN above, creepages below, over the distance rolled in mm."""
    distance, fx, fy, creepage_longitudinal, creepage_lateral = result.arrays(
        [f"/exact/history/{name}" for name in ("distance", "fx", "fy", "creepage_longitudinal", "creepage_lateral")])
    figure = new_figure(7.2, 5.6)
    above, below = figure.subplots(2, 1, sharex=True)
    marker = "." if len(distance) < 60 else ""
    for axes, values, factor, symbols in ((above, (fx, fy), 1e-3, ("$F_x$", "$F_y$")),
                                          (below, (creepage_longitudinal, creepage_lateral), 1e3, (r"$\xi$", r"$\eta$"))):
        open_axes(axes)
        for (_, colour), value, symbol in zip(COMPONENTS, values, symbols):
            axes.plot(1e3 * distance, factor * value, color=colour, marker=marker, linewidth=2, label=symbol)
        axes.legend(loc="best", frameon=True, framealpha=0.9, edgecolor="none")
    above.set_ylabel("force on the wheel [kN]")
    below.set_ylabel(r"creepage [$10^{-3}$]")
    below.set_xlabel("distance rolled [mm]")
    figure.suptitle(f"Transient rolling: {result.attribute('title', 'rolling contact')}")
    return figure
