"""Creep curves of a creep-force table with points of the exact theory: what a table is worth at an ellipse."""

import numpy as np

import microslip
from microslip.picture_style import INK3, SERIES, new_figure, number, open_axes, put_title

LINE_COLOURS = SERIES
LINE_POINTS, EXACT_POINTS = 121, 9
FAR = 3  # times the creepage at which linear theory slides fully


def unit_contact(axis_ratio, poisson_ratio):
    """The contact whose creepages are scaled ones: G = 1, a b = 1, mu Fn = 1."""
    root = np.sqrt(axis_ratio)
    return microslip.EllipticContact(a=root, b=1 / root, shear_modulus=1.0, poisson_ratio=poisson_ratio, normal_force=1.0,
                                     friction=1.0)


def creep_table_picture(table, axis_ratio=1.0, poisson_ratio=0.28, spins=(0.0, 0.5, 1.0), elements=24):
    """Fx over the longitudinal creepage, Fy and Mz over the lateral one, for scaled spins, as a figure: lines by a
    CreepForceTable, points by the exact theory on so many elements across the ellipse (0: none). Scaled are creepages with
    G a b/(mu Fn) and the spin with G (a b)^(3/2)/(mu Fn)."""
    contact = unit_contact(axis_ratio, poisson_ratio)
    c = microslip.creepage_coefficients(axis_ratio, poisson_ratio, "computed")
    exact = microslip.Solver(theory="exact", grid=elements) if elements else None
    panels = (("longitudinal", "fx", np.linspace(0, FAR / c.c11, LINE_POINTS), r"$\xi$", r"$F_x / (\mu F_n)$"),
              ("lateral", "fy", np.linspace(-FAR / c.c22, FAR / c.c22, LINE_POINTS), r"$\eta$", r"$F_y / (\mu F_n)$"),
              ("lateral", "mz", np.linspace(-FAR / c.c22, FAR / c.c22, LINE_POINTS), r"$\eta$", r"$M_z / (\mu F_n \sqrt{ab})$"))
    step = (LINE_POINTS - 1) // (EXACT_POINTS - 1)
    figure = new_figure(12, 4.8)
    worst, statuses = 0.0, set()
    for axes, (creepage, force, values, symbol, label) in zip(figure.subplots(1, 3), panels):
        open_axes(axes)
        axes.axhline(0, color=INK3, linewidth=0.8)
        for spin, colour in zip(spins, LINE_COLOURS * len(spins)):
            found = table.solve_batch(contact, **{creepage: values}, spin=float(spin))
            statuses.update(map(int, found.status.flat))
            line = getattr(found, force)
            axes.plot(values, line, color=colour, linewidth=2, label=f"table, spin {number(spin)}")
            if exact is None:
                continue
            some = values[::step]
            points = getattr(exact.solve_batch(contact, **{creepage: some}, spin=float(spin)).forces, force)
            worst = max(worst, np.abs(points - line[::step]).max())
            axes.plot(some, points, "o", color=colour, markersize=5, markerfacecolor="none",
                      label=f"exact theory, spin {number(spin)}")
        axes.set_xlabel(rf"{symbol} $G a b / (\mu F_n)$ [-]")
        axes.set_ylabel(f"{label} [-]")
    figure.axes[1].legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=len(spins), frameon=False)
    lines = [f"Creep-force table: a/b = {number(axis_ratio)}, Poisson's ratio {number(poisson_ratio)}; "
             r"spins scaled with $G (a b)^{3/2} / (\mu F_n)$"]
    if exact is not None:
        lines.append(f"largest distance to the exact theory on {elements} x {elements} elements: {worst:.4f}")
    if statuses != {int(microslip.Status.ok)}:
        lines.append("beyond the table's range: its forces are those of limits")
    put_title(figure, "\n".join(lines))
    return figure
