"""Pictures of a wheelset: of one state the patches of both wheels, of a sweep forces, roll and rolling speed."""

import numpy as np

from microslip.picture_style import (INK, RED, heading, names_above, new_figure, number, open_axes, put_title, unit_for,
                                     with_unit)
from microslip.pressure_picture import pressure_picture
from microslip.solved_contacts import patch_cells
from microslip.wheel_rail_pictures import plot_states, varied


def wheelset_pictures(result):
    """The pictures of a result file of kind wheelset, by file name."""
    if len(result.array("/wheelset/force_x", finite=False)) > 1:
        return {"wheelset.png": wheelset_picture(result)}
    grids, titles = [], []
    for side in ("left", "right"):
        for k, force in enumerate(result.array(f"/{side}/patches/normal_force") if f"{side}/patches" in result else ()):
            if f"{side}/fields/{k}" in result:
                grids.append(patch_cells(result, f"/{side}/fields/{k}"))
                angle = float(result.array(f"/{side}/patches/angle")[k])
                titles.append(f"{side} wheel, patch {k + 1}\n$F_n$ = {with_unit(force, 'N')}, at {number(np.degrees(angle))} degrees")
    return {"patches.png": pressure_picture(heading("Pressure and tractions on the wheels", result), grids, titles)} if grids else {}


def wheelset_picture(result):
    """Over what a sweep varies."""
    label, values = varied(result)
    figure = new_figure(9.4, 6.4)
    put_title(figure, heading("Forces on a wheelset", result))
    axes = figure.subplots(2, 2, sharex=True).ravel()
    for one, force, text in ((axes[0], "force_y", "lateral force, to the left"), (axes[1], "force_z", "vertical force")):
        of_sides = {side: result.array(f"/{side}/wheel/{force}", finite=False) for side in ("left", "right")}
        scale, unit = unit_for(max(np.nanmax(np.abs(forces), initial=0) for forces in of_sides.values()), "N")
        for (side, forces), colour, dashes in zip(of_sides.items(), (INK, RED), ("-", "--")):
            plot_states(one, values, scale * forces, dashes, color=colour, label=f"{side} wheel")
        one.set_ylabel(f"{text} [{unit}]")
        names_above(one)
    for one, name, factor, text in ((axes[2], "roll", 1e3, "roll [mrad]"), (axes[3], "pitch_velocity", 1, "pitch velocity [rad/s]")):
        plot_states(one, values, factor * result.array(f"/wheelset/{name}", finite=False), "-", color=INK, label=None)
        one.set_ylabel(text)
        one.set_xlabel(label)
    for one in axes:
        open_axes(one)
    return figure
