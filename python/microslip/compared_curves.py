"""Curves of several results in one picture: creep curves of contacts, sweeps, wheels and wheelsets over what varies, conicities."""

import os

import numpy as np

from microslip.conicity_picture import draw_over_displacement
from microslip.creep_curve_picture import CREEPAGES
from microslip.creep_curve_picture import FORCES as CREEP_FORCES
from microslip.picture_style import (INK2, LINES, LOOKS, THEORIES, bodies_of, names_above, new_figure, open_axes, put_title, shown, the,
                                     unit_for, vanishing)
from microslip.result_file import ResultError
from microslip.sweep_picture import curves_of_grid, label_of_quantity, quantities_of
from microslip.wheel_rail_pictures import plot_states, varied

# Dashes and markers of results whose colours tell something else.
DASHES = ("-", "--", "-.", ":")
WITH_POINTS = "; with --points POINTS.csv results of `solve` of two bodies and of `sweep` are drawn together"


def names_of(results):
    """What results are called: their titles, or where these are the same or none their files, result.h5 by its folder."""
    titles = [result.attribute("title", "") for result in results]
    if all(titles) and len(set(titles)) == len(titles):
        return titles
    paths = [str(result.path) for result in results]
    return [os.path.dirname(path) if os.path.basename(path) == "result.h5" and os.path.dirname(path) else path for path in paths]


def compared_curves(results):
    """The figure of results of one kind whose curves are over the same."""
    require_one_kind(results)
    kind = results[0].attribute("kind")
    if kind not in CURVES_OF_KIND:
        raise ResultError(f"{results[0].path}: of kind '{kind}' two results are compared, by their fields: give --compare once")
    figure = CURVES_OF_KIND[kind](results)
    names_above(figure.axes[0], most=2, fontsize="small")
    return figure


def require_one_kind(results):
    """Refuses results of several kinds."""
    kinds = [result.attribute("kind") for result in results]
    for result, kind in zip(results, kinds):
        if kind != kinds[0]:
            raise ResultError(f"{result.path}: is of kind '{kind}', {results[0].path} of kind '{kinds[0]}': results of one kind are "
                              f"compared{WITH_POINTS}")


def is_swept(result):
    """Returns whether a result is of many states."""
    kind = result.attribute("kind")
    group = {"wheel_rail": "wheel", "wheelset": "wheelset"}.get(kind)
    return kind in ("sweep", "conicity") or (group is not None and len(result.array(f"/{group}/force_x", finite=False)) > 1)


def require_same(results, whats, way):
    """Refuses results whose axes differ."""
    for result, what in zip(results, whats):
        if what != whats[0]:
            raise ResultError(f"{result.path}: is over {what}, {results[0].path} over {whats[0]}; {way}")


def panels_of(what, count, height=2.6):
    """A figure with a panel for each quantity, one below the other."""
    figure = new_figure(7.0, 1.6 + height * count)
    put_title(figure, what)
    panels = np.atleast_1d(figure.subplots(count, sharex=True))
    for axes in panels:
        open_axes(axes)
        axes.axhline(0, color=INK2, linewidth=0.8)
    return figure, panels


def creep_curves(results):
    """Of contacts: a panel for each force that any has; colours tell the results, dashes the theories."""
    for result in results:
        if "creep_curve" not in result:
            raise ResultError(f"{result.path}: has no creep curve; steady cases of two bodies have one")
    over = [result.group_attribute("/creep_curve", "variable") for result in results]
    require_same(results, over, "sweep both over one creepage with `microslip sweep` and compare these")
    title, _, factor, unit, _ = CREEPAGES[over[0]]
    curves = [(name, colour, theory, result.arrays([f"/creep_curve/{theory}/{part}" for part in ("value", *CREEP_FORCES)]))
              for name, result, colour in zip(names_of(results), results, LINES * len(results))
              for theory in THEORIES if f"creep_curve/{theory}" in result]
    largest = max(np.abs(values[1:]).max() for *_, values in curves)
    scale, force_unit = unit_for(largest, "N")
    forces = [part for part in (1, 2) if not all(vanishing(values[part], largest) for *_, values in curves)] or [1]
    figure, panels = panels_of("Creep curves compared", len(forces))
    for axes, part in zip(panels, forces):
        for name, colour, theory, values in curves:
            axes.plot(factor * values[0], scale * shown(values[part], largest), color=colour, linestyle=LOOKS[theory][1], linewidth=1.8,
                      label=f"{name}, {THEORIES[theory]}")
        axes.set_ylabel(f"{list(CREEP_FORCES.values())[part - 1]} on {the(bodies_of(results[0])[0])} [{force_unit}]")
    panels[-1].set_xlabel(f"{title} [{unit}]")
    return figure


def sweeps(results):
    """Of sweeps: a panel for each force that all have; colours tell the combinations, dashes the results."""
    quantities = [name for name in quantities_of(results[0]) if all(name in result for result in results)]
    if not quantities:
        raise ResultError(f"{results[1].path}: has no quantity of {results[0].path}; sweep both with the same output.quantities")
    grids = [curves_of_grid(result, quantities) for result in results]
    require_same(results, [grid.name for grid in grids], "sweep both over the same, and compare with measured points by --points")
    figure, panels = panels_of("Sweeps compared", len(quantities))
    largest = max(np.nanmax(np.abs(grid.values[name]), initial=0) for grid in grids for name in quantities)
    colours = {label: LINES[k % len(LINES)] for k, label in enumerate(dict.fromkeys(label for grid in grids for label in grid.labels()))}
    for axes, quantity in zip(panels, quantities):
        scale, unit = unit_for(max(np.nanmax(np.abs(grid.values[quantity]), initial=0) for grid in grids), results[0].unit(quantity))
        for name, grid, dashes in zip(names_of(results), grids, DASHES * len(results)):
            for label, values in zip(grid.labels(), grid.values[quantity]):
                axes.plot(grid.x, scale * shown(values, largest), color=colours[label], linestyle=dashes, linewidth=1.6,
                          label=", ".join(part for part in (name, label) if part))
        axes.set_ylabel(label_of_quantity(quantity, unit))
    grids[0].put_axis(panels[-1], results[0])
    return figure


def states(results, quantities):
    """Of wheels and wheelsets over what a sweep of states varies: a panel for each of (names, label, unit, dashes)."""
    for result in results:
        if not is_swept(result):
            raise ResultError(f"{result.path}: is of one state; of such results two are compared, by their fields: give --compare once")
    axes_of = [varied(result) for result in results]
    require_same(results, [label for label, _ in axes_of], "sweep both over the same")
    figure, panels = panels_of("Forces compared", len(quantities), 2.3)
    for axes, (label, unit, parts) in zip(panels, quantities):
        values = [[result.array(path, finite=False) for path, _, _ in parts] for result in results]
        scale, printed = unit_for(max(np.nanmax(np.abs(one), initial=0) for of_result in values for one in of_result), unit)
        for name, (_, at), of_result, colour in zip(names_of(results), axes_of, values, LINES * len(results)):
            for one, (_, dashes, word) in zip(of_result, parts):
                plot_states(axes, at, scale * one, dashes, color=colour, label=", ".join(part for part in (name, word) if part))
        axes.set_ylabel(f"{label} [{printed}]")
    panels[-1].set_xlabel(axes_of[0][0])
    return figure


def wheels(results):
    """Forces and T-gamma."""
    return states(results, [("$F_x$, forward", "N", [("/wheel/force_x", "-", "")]),
                            ("$F_y$, to the left", "N", [("/wheel/force_y", "-", "")]),
                            (r"$T\gamma$ with spin", "N", [("/wheel/t_gamma_with_spin", "-", "")])])


def wheelsets(results):
    """Forces of both wheels."""
    return states(results, [(label, "N", [(f"/left/wheel/{name}", "-", "left wheel"), (f"/right/wheel/{name}", "--", "right wheel")])
                            for name, label in (("force_y", "$F_y$, to the left"), ("force_z", "$F_z$, up"))])


def conicities(results):
    """Equivalent conicity at the first gauge, and the rolling radius difference that it follows from."""
    figure = new_figure(7.0, 8.4)
    put_title(figure, "Equivalent conicity compared")
    conicity, *others = figure.subplots(4, 1, height_ratios=(2.2, 1, 1, 1))
    for name, result, colour in zip(names_of(results), results, LINES * len(results)):
        conicity.plot(1e3 * result.array("/amplitude"), result.array("/gauge_0/conicity", finite=False), color=colour, linewidth=1.6,
                      label=name)
        draw_over_displacement(others, result, "/gauge_0/curve", colour)
    conicity.set_xlabel("amplitude [mm]")
    conicity.set_ylabel("equivalent conicity [-]")
    conicity.set_ylim(bottom=0)
    others[-1].set_xlabel("lateral displacement [mm], to the left")
    for axes in (conicity, *others):
        open_axes(axes)
    return figure


CURVES_OF_KIND = {"rolling_contact": creep_curves, "sweep": sweeps, "wheel_rail": wheels, "wheelset": wheelsets, "conicity": conicities}
