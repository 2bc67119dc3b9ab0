"""The profiles of a folder laid over one another: wheels at their tape circle, rails at gauge point and top."""

from itertools import count, takewhile

import numpy as np

from microslip.picture_style import INK3, RAIL, SIZES_OF_LINES, WHEEL, heading, new_figure, open_axes, put_title

MOST_NAMES = 24  # in a legend
ORIGINS = {"wheel": ("y [mm] from the tape line, to the field side", "z [mm] from the tape circle, up"),
           "rail": ("y [mm] from the gauge point, to the field side", "z [mm] from the top, up")}


def profiles_pictures(result):
    """The picture of a result file of kind profiles, by file name."""
    groups = list(takewhile(lambda group: f"{group[1:]}/y" in result, (f"/profiles/{k:04}" for k in count())))
    by_role = {role: [group for group in groups if result.text(f"{group}/role") == role] for role in ORIGINS}
    roles = [role for role, members in by_role.items() if members]
    figure = new_figure(10, 4.2 * len(roles))
    put_title(figure, heading(" and ".join(f"{len(by_role[role])} {role}{'s' if len(by_role[role]) > 1 else ''}" for role in roles),
                              result))
    for role, axes in zip(roles, figure.subplots(len(roles), 1, squeeze=False)[:, 0]):
        draw_profiles(axes, result, role, by_role[role])
    return {"profiles.png": figure}


def draw_profiles(axes, result, role, groups):
    """Curves to scale, in the order of their names from light to dark."""
    open_axes(axes)
    axes.axvline(0, color=INK3, linewidth=0.8, linestyle="--")
    axes.axhline(0, color=INK3, linewidth=0.8, linestyle="--")
    shades = SIZES_OF_LINES(np.linspace(0, 1, len(groups))) if len(groups) > 1 else [WHEEL if role == "wheel" else RAIL]
    for group, shade in zip(groups, shades):
        y, z = result.arrays([f"{group}/y", f"{group}/z"])
        axes.plot(1e3 * y, 1e3 * z, color=shade, linewidth=1, label=result.text(f"{group}/file"))
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel(ORIGINS[role][0])
    axes.set_ylabel(ORIGINS[role][1])
    handles, names = axes.get_legend_handles_labels()
    if len(names) > MOST_NAMES:
        kept = np.unique(np.linspace(0, len(names) - 1, MOST_NAMES).round().astype(int))
        handles, names = [handles[k] for k in kept], [names[k] for k in kept]
        axes.text(0.01, 0.02, f"{len(kept)} of {len(groups)} are named", transform=axes.transAxes, fontsize=9, va="bottom")
    axes.legend(handles, names, loc="center left", bbox_to_anchor=(1.01, 0.5))
