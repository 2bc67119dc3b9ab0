"""Pictures of a result file that need more than it holds: the compiled module computes the rest.

Creep curves for several spins by both theories, convergence with finer grids, stresses inside the bodies.
"""

import copy

import numpy as np
from matplotlib.ticker import MaxNLocator

import microslip
from microslip.picture_style import (GREEN, GRID, INK, INK3, LINE, LINES, SIZES, THEORIES, bodies_of, heading, new_figure,
                                     number, open_axes, put_title, shown, the, unit_for, with_unit)
from microslip.result_file import ResultError
from microslip.solved_contacts import label_along_x, read_contacts

CURVE_GRID, CURVE_CELLS = 16, 20  # elements and cells across: a picture needs no more
GRIDS = (8, 12, 16, 24, 32, 48)
LEVELS = 16


def case_of(result):
    """The case that the result file holds. The pictures are of rolling that is steady."""
    case = microslip.parse_case(result.attribute("case_text"), f"{result.path}: case_text")
    if result.text("/inputs/motion/kind") != "steady":
        raise ResultError(f"{result.path}: this picture needs steady rolling")
    if "/inputs/motion/step" in result:
        raise ResultError(f"{result.path}: this picture needs rolling without motion.step")
    if "/inputs/friction/coefficient" in result and result.number("/inputs/friction/coefficient") == 0:
        raise ResultError(f"{result.path}: this picture needs friction")
    return case


def problem_of(result, case):
    """The case's problem with its creepages, as found where a force is given."""
    if "exact" not in result:
        return case.problem
    return case.problem.replace(**{key: result.number(f"/exact/{key}") for key in ("creepage_longitudinal", "creepage_lateral")})


def exact_method(case, **changes):
    """The exact theory with what the case says of it."""
    return case.method.replace(theory="exact", table=None, **{"accuracy": None} | changes)


def simplified_method(case):
    """The case's simplified theory, FASTSIM2 beside another one."""
    said = case.method
    return microslip.Method(theory=said.theory if said.theory.startswith("fast") else "fastsim2", grid=CURVE_CELLS, bound=said.bound,
                            flexibility=said.flexibility, coefficients=said.coefficients, slope_reduction=said.slope_reduction)


def default_spins(contact):
    """No spin, that of linear theory at half and at all of full sliding, rounded."""
    c = microslip.creepage_coefficients(contact.a / contact.b, contact.poisson_ratio)
    area = contact.a * contact.b
    full = contact.friction.static_coefficient * contact.normal_force / (contact.shear_modulus * area**1.5 * c.c23)
    return [0.0] + [float(f"{part * full:.1g}") for part in (0.5, 1.0)]


def creep_curves_picture(result, spins=()):
    """Fx and Fy over the longitudinal creepage for several spins [1/m]: the exact theory and the case's simplified one."""
    case = case_of(result)
    contact = copy.copy(case.contact)
    spins = list(spins) or default_spins(contact)
    limit = contact.friction.static_coefficient * contact.normal_force
    c = microslip.creepage_coefficients(contact.a / contact.b, contact.poisson_ratio)
    far = 3 * limit / (contact.shear_modulus * contact.a * contact.b * c.c11)
    creepages = np.linspace(-far, far, 61)
    method = simplified_method(case)
    simplified = method.theory
    contact.dissimilarity = 0  # which the simplified theory does not have
    curves = {"exact": (exact_method(case, grid=CURVE_GRID), problem_of(result, case)),
              simplified: (method, microslip.RollingProblem(contact, direction=case.problem.direction))}
    forces = {theory: microslip.Solver(how).solve_batch(problem, creepages, 0, np.array(spins)[:, None]).forces
              for theory, (how, problem) in curves.items()}
    figure = new_figure(12.5, 4.8)
    put_title(figure, heading("Creep curves, no lateral creepage", result, forces))
    for axes, name, label in zip(figure.subplots(1, 2, sharex=True), ("fx", "fy"), ("$F_x$", "$F_y$")):
        open_axes(axes)
        for row, (spin, colour) in enumerate(zip(spins, LINES * len(spins))):
            for theory, style in (("exact", "-"), (simplified, "--")):
                force = shown(getattr(forces[theory], name)[row], limit) / limit
                axes.plot(1e3 * creepages, force, style, color=colour, linewidth=2,
                          label=f"{THEORIES[theory]}, spin {number(spin)} 1/m" if name == "fx" else None)
        axes.set_xlabel(r"longitudinal creepage $\xi$ [$10^{-3}$]")
        axes.set_ylabel(rf"{label} on {the(bodies_of(result)[0])} / ($\mu F_n$) [-]")
        low, high = axes.get_ylim()
        axes.set_ylim(min(low, -0.05), max(high, 0.05))  # a force that is zero is a line
    figure.axes[1].legend(*figure.axes[0].get_legend_handles_labels(), loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize="small")
    return figure


def convergence_picture(result):
    """Distance of the forces to their limit over the number of elements, log-log, with slopes of first and second order."""
    case = case_of(result)
    contact, problem = case.contact, problem_of(result, case)
    limit = contact.friction.static_coefficient * contact.normal_force
    try:
        best = microslip.Solver(exact_method(case, accuracy=1e-4, discretisation="second_order", elements=None)).solve(problem)
    except microslip.Error as error:
        if "must be classical" not in str(error):
            raise
        raise ResultError(f"{result.path}: this picture compares second order with classical elements, and needs similar "
                          "elastic bodies, Coulomb's law, no layer and no temperatures") from None
    figure = new_figure(7.0, 6)
    axes = figure.subplots()
    open_axes(axes)
    for name, colour in (("second_order", INK), ("classical", GREEN)):
        how = {"discretisation": name} | ({"elements": None} if name == "second_order" else {})
        solved = [microslip.Solver(exact_method(case, grid=n, **how)).solve(problem).forces for n in GRIDS]
        for force, style, marker in (("fx", "-", "o"), ("fy", "--", "s")):
            if abs(getattr(best.forces, force)) < 1e-6 * limit:
                continue  # rounding
            errors = [abs(getattr(one, force) - getattr(best.forces, force)) / limit for one in solved]
            axes.loglog(GRIDS, errors, style, color=colour, marker=marker, linewidth=2,
                        label=f"{name.replace('_', ' ')}, $F_{force[1]}$")
    low, high = axes.get_ylim()
    for order, part in ((1, 0.9), (2, 0.9)):
        top = high * part
        axes.loglog(GRIDS, [top * (GRIDS[0] / n) ** order for n in GRIDS], ":", color=INK3, linewidth=1.2)
        axes.annotate(f" order {order}", (GRIDS[-1], top * (GRIDS[0] / GRIDS[-1]) ** order), ha="left", va="center", color=INK3)
    axes.set_ylim(low, high)
    axes.set_xlim(0.92 * GRIDS[0], 1.25 * GRIDS[-1])
    axes.set_xticks(GRIDS, [str(n) for n in GRIDS])
    axes.minorticks_off()
    axes.axhline(best.estimated_error, color=INK, linewidth=1, linestyle="-.", label=f"estimated error of the limit, {round(2 * contact.a / best.grid.dx)} elements")
    axes.set_xlabel("elements across the ellipse, in each direction [-]")
    axes.set_ylabel(r"distance to the limit / ($\mu F_n$) [-]")
    forces = best.forces
    largest = max(abs(forces.fx), abs(forces.fy), limit)
    axes.set_title(f"limit: $F_x$ = {with_unit(forces.fx, 'N', largest)}, $F_y$ = {with_unit(forces.fy, 'N', largest)}")
    put_title(figure, heading("Exact theory on finer grids", result))
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13), ncols=2, handlelength=3.5)
    return figure


def tractions_on_grid(result, folder="/exact/fields"):
    """The elements of a contact's fields as a regular grid with the tractions (px, py, pn) on it [Pa].

    The leading element of a row has a different length, and rows may begin anywhere; tractions go to the cells that an
    element covers, by their share.
    """
    x, y, area, px, py, pn, state = result.arrays(
        [f"{folder}/{name}" for name in ("x", "y", "area", "px", "py", "pressure", "state")], dimensions=2)
    my, mx = x.shape
    if my < 2 or mx < 2:
        raise ResultError(f"{result.path}: stresses need at least 2 x 2 elements")
    dx, dy = np.ptp(x, axis=1).max() / (mx - 1), (y[-1, 0] - y[0, 0]) / (my - 1)
    # Two columns to spare on each side: a leading element may reach beyond the grid.
    left, columns = x.min() - 2.5 * dx, int(np.ceil(np.ptp(x) / dx - 1e-6)) + 5
    grid = microslip.ElementGrid(columns, my, left + dx / 2, y[0, 0], dx, dy)
    edges = left + dx * np.arange(columns + 1)
    tractions = np.zeros((3, my, columns))
    for row, column in np.argwhere(state != 0):
        half = area[row, column] / dy / 2
        covered = np.clip(np.minimum(edges[1:], x[row, column] + half) - np.maximum(edges[:-1], x[row, column] - half), 0, None)
        tractions[:, row] += np.outer((px[row, column], py[row, column], pn[row, column]), covered / dx)
    return grid, tractions


def stresses_pictures(result, y=0.0):
    """Stresses below the contact by the exact theory, or below each patch of wheels on rails, by file name."""
    contacts = read_contacts(result)
    if set(contacts) <= set(THEORIES):
        if "exact" not in contacts:
            raise ResultError(f"{result.path}: stresses need the exact theory")
        return {"stresses.png": stresses_picture(result, contacts["exact"], "", y)}
    return {f"stresses_{key.replace(', ', '_').replace(' ', '_')}.png": stresses_picture(result, contact, f", {key}", y)
            for key, contact in contacts.items()}


def material_of(result, body):
    """The material of a body; on rails both bodies are of one."""
    section = f"/inputs/body{body}" if f"/inputs/body{body}" in result else "/inputs/material"
    poisson_ratio = result.number(f"{section}/poisson_ratio")
    if f"{section}/young_modulus" in result:
        return microslip.Material.from_young(result.number(f"{section}/young_modulus"), poisson_ratio)
    return microslip.Material(result.number(f"{section}/shear_modulus"), poisson_ratio)


def stresses_picture(result, contact, which, y):
    """Von Mises' and the largest shear stress below a contact in the plane of y [mm], the wheel above, the rail below."""
    grid, (px, py, pn) = tractions_on_grid(result, contact.folder)
    left, right, *_ = contact.cells.outline.limits()
    a, b, middle = 1e-3 * contact.cells.a, 1e-3 * contact.cells.b, 1e-3 * (left + right) / 2
    size = np.sqrt(a * b)
    x, depth = middle + np.linspace(-2 * a, 2 * a, 101), np.linspace(0.75 * grid.dx, 1.6 * size, 46)
    measures = {"von_mises": "von Mises' stress", "tresca": "Tresca's stress, twice the largest shear"}
    sections, peaks = {}, {}
    for body in (1, 2):
        field = microslip.InteriorField(material_of(result, body), body, grid, px=px, py=py, pn=pn)
        sections[body] = field.at(x, 1e-3 * y, depth[:, None])
        layers = microslip.InteriorLayers(field)
        for measure in measures:
            peaks[body, measure] = layers.find_largest(np.linspace(0.75 * grid.dx, size, 10), measure)
    largest_of_all = max(peak.value for peak in peaks.values())
    scale, unit = unit_for(largest_of_all, "Pa")
    # To one scale where both directions are of one size.
    to_scale = 1 / 3 < 4 * a / (3.2 * size) < 3
    figure = new_figure(12, 2.2 + 4.4 * (0.8 * size / a if to_scale else 1), layout="compressed" if to_scale else "constrained")
    bodies = bodies_of(result)
    put_title(figure, heading(f"Stresses in {bodies[0]} and {bodies[1]}{which}, y = {number(y)} mm", result)
              + f"\nhatched: nearer to the surface than 3/4 of an element, {with_unit(depth[0], 'm')}, not resolved")
    for axes, (measure, text) in zip(figure.subplots(1, 2, sharey=True), measures.items()):
        axes.axhspan(-1e3 * depth[0], 1e3 * depth[0], facecolor=GRID, hatch="xxxx", edgecolor=LINE, linewidth=0)
        draw_section(figure, axes, x, depth, {body: scale * getattr(states, measure) for body, states in sections.items()}, unit)
        axes.plot([left, right], [0, 0], color=INK, linewidth=3, solid_capstyle="butt")
        axes.set_aspect("equal" if to_scale else "auto")
        largest = [f"{who} {with_unit(peaks[body, measure].value, 'Pa')} at {with_unit(peaks[body, measure].depth, 'm')}"
                   for body, who in zip((1, 2), bodies)]
        axes.set_title("\n".join([text, "largest for all y: " + largest[0], largest[1]]))
        scale_text = "" if to_scale else "\n(not to the scale of z)"
        axes.set_xlabel(f"{label_along_x(result)}{scale_text}")
        axes.locator_params(axis="x", nbins=7)
    figure.axes[0].set_ylabel(f"z [mm]: {bodies[0]} above, {bodies[1]} below")
    return figure


def draw_section(figure, axes, x, depth, values, unit):
    """Both bodies' stresses as filled contours with a common scale."""
    levels = MaxNLocator(LEVELS).tick_values(0, max(value.max() for value in values.values()))
    for body, side in ((1, 1), (2, -1)):
        fill = axes.contourf(1e3 * x, side * 1e3 * depth, values[body], levels=levels, cmap=SIZES)
        axes.contour(1e3 * x, side * 1e3 * depth, values[body], levels=levels[::3], colors=INK3, linewidths=0.4)
    figure.colorbar(fill, ax=axes, label=f"[{unit}]", shrink=0.8, pad=0.02)
