"""Von Mises' stress in wheel and rail below a rolling contact, without and with traction."""

import numpy as np

from microslip.picture_style import INK, INK3, SIZES, new_figure, number, put_title

CASES = {"free": "no traction", "partial": "partial slip", "full": "full sliding"}
LEVEL_STEP = 0.05


def subsurface_pictures(result):
    """The pictures of a result file of kind subsurface, by file name."""
    return {"subsurface.png": draw_section(result)}


def draw_section(result):
    """The plane y = 0: the wheel above the surface, the rail below it."""
    x, depth = 1e3 * result.array("/x"), 1e3 * result.array("/depth")
    a = 1e3 * result.number("/a")
    z = np.concatenate([-depth[::-1], depth])
    fields = {case: section(result, case) for case in CASES}
    largest = max(field.max() for field in fields.values())
    levels = np.arange(0, LEVEL_STEP * (np.ceil(largest / LEVEL_STEP) + 0.5), LEVEL_STEP)
    figure = new_figure(12.4, 4.7, layout="compressed")
    panels = figure.subplots(1, len(CASES), sharey=True)
    for axes, (case, field) in zip(panels, fields.items()):
        fill = axes.contourf(x, z, field, levels=levels, cmap=SIZES)
        axes.contour(x, z, field, levels=levels[::2], colors=INK3, linewidths=0.4)
        axes.axhline(0, color=INK, linewidth=0.8)
        axes.plot([-a, a], [0, 0], color=INK, linewidth=3, solid_capstyle="butt")
        mark_peaks(axes, result, case)
        axes.set_aspect("equal")
        axes.set_title(title(result, case))
        axes.set_xlabel("x [mm], rolling to the right")
    panels[0].set_ylabel("z [mm]")
    for text, height in (("wheel", 0.96), ("rail", 0.04)):
        panels[0].text(0.03, height, text, transform=panels[0].transAxes, va="top" if height > 0.5 else "bottom")
    figure.colorbar(fill, ax=panels, label=r"von Mises' stress / $p_0$ [-]", shrink=0.85, pad=0.02)
    pressure, friction = 1e-6 * result.number("/peak_pressure"), result.number("/friction")
    put_title(figure, "Stresses in wheel and rail, y = 0; crosses: largest below the surface; "
                    rf"$p_0$ = {number(pressure)} MPa, $\mu$ = {number(friction)}")
    return figure


def section(result, case):
    """Both bodies in one array, z ascending. The surface is there twice: each body has a value."""
    wheel, rail = result.arrays([f"/{case}/{body}/von_mises" for body in ("wheel", "rail")], dimensions=2)
    return np.concatenate([rail[::-1], wheel])


def mark_peaks(axes, result, case):
    """Crosses at each body's largest value."""
    for body, side in (("wheel", 1), ("rail", -1)):
        x, _, depth = 1e3 * result.array(f"/{case}/{body}/peak_point")
        for colour, width in (("white", 3), (INK, 1.4)):
            axes.plot(x, side * depth, linestyle="none", marker="x", color=colour, markersize=8, markeredgewidth=width)


def title(result, case):
    """The case, its force and its largest stresses."""
    traction = result.number(f"/{case}/traction")
    force = rf"$F_x$ = {number(traction)} $\mu F_n$" if traction else "$F_x$ = 0"
    wheel, rail = (result.number(f"/{case}/{body}/peak") for body in ("wheel", "rail"))
    return f"{CASES[case]}: {force}\nlargest: wheel {wheel:.3f} $p_0$, rail {rail:.3f} $p_0$"
