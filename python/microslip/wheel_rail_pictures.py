"""Pictures of a wheel on a rail: patches on the rail head, unrolled and in space; the gap; of a sweep contact points and forces."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgba
from matplotlib.patches import Patch

from microslip.contact_points_picture import draw_contact_points
from microslip.lateral_axis import lateral_axis
from microslip.interior_picture import interior_picture, interior_points
from microslip.picture_style import (ACROSS, ALONG, INK, INK2, INK3, MAGENTA, RAIL, RAIL_FILL, ROLLING, SIZES, SLIDES,
                                     STICKS, WHEEL, WHEEL_FILL, halo, heading, names_above, new_figure, number, open_axes,
                                     put_title, shown, unit_for, with_unit)
from microslip.profile_tractions_picture import profile_tractions_picture
from microslip.rolling_contact_pictures import name_areas
from microslip.solved_contacts import patch_cells

LENGTHS = {"m": ("mm", 1e3)}
# Sweeps of more states are drawn without dots.
MOST_MARKED = 120
# What lies around the patches on pictures of the rail head [mm].
MARGIN = 3.0
# What is drawn of the bodies below and above the rail's top, and beside its highest point [mm].
DEEP, HIGH, BESIDE = 34.0, 30.0, 62.0
# Of sticks and slides, in parts of a picture's width.
WIDTH_OF_A_WORD = 0.07
# The height that stands for the largest pressure on pictures in space [mm].
HIGHEST = 6.0


def wheel_rail_pictures(result):
    """The pictures of a result file of kind wheel_rail, by file name."""
    if len(result.array("/wheel/force_x", finite=False)) > 1:
        return {"contact_points.png": contact_points_picture(result), "forces.png": forces_picture(result)}
    figures = {"gap.png": gap_picture(result)}
    if "fields" in result:
        rail = RailHead(result)
        cells = read_patches(result, rail)
        figures["patches.png"] = patches_picture(result, cells)
        figures["rail_head.png"] = rail_head_picture(result, rail, cells)
        wheel = [1e3 * values for values in result.arrays(["/outlines/wheel/y", "/outlines/wheel/z"])]
        figures["tractions_on_profiles.png"] = profile_tractions_picture(result, rail, wheel, cells)
        figures.update(interior_pictures(result, len(cells)))
    return figures


def interior_pictures(result, patches):
    """Von Mises' stress at the points that the case asks for, inside the bodies at each patch."""
    return {f"interior_{k + 1}.png": interior_picture(heading(f"Patch {k + 1}, von Mises' stress inside the bodies", result),
                                                      [interior_points(result, f"/interior/{k}")])
            for k in range(patches) if f"interior/{k}/von_mises" in result}


class RailHead:
    """The rail's outline in track axes [mm], and the length u along it, to the left from the point that lies highest."""

    def __init__(self, result):
        y, z = (1e3 * values for values in result.arrays(["/outlines/rail/y", "/outlines/rail/z"]))
        if result.text("/inputs/wheel/side") == "right":  # outlines run to the field side
            y, z = y[::-1], z[::-1]
        length = np.concatenate(([0], np.cumsum(np.hypot(np.diff(y), np.diff(z)))))
        self.y, self.z, self.u = y, z, length - length[np.argmax(z)]

    def nearest(self, y, z):
        """The length u of the point nearest to one near the surface."""
        return self.u[np.argmin(np.hypot(self.y - y, self.z - z))]

    def at(self, u):
        """y and z, and the normal's y and z, at lengths u."""
        y, z = np.interp(u, self.u, self.y), np.interp(u, self.u, self.z)
        step = 0.05
        ahead, behind = ([np.interp(u + side, self.u, values) for values in (self.y, self.z)] for side in (step, -step))
        slope = np.array(ahead) - np.array(behind)
        slope /= np.hypot(*slope)
        return y, z, -slope[1], slope[0]


def read_patches(result, rail):
    """The cells of each patch, x along the track and y the length along the rail."""
    place = result.arrays([f"/patches/place_{axis}" for axis in "xyz"])
    return [patch_cells(result, f"/fields/{k}", (x, rail.nearest(y, z))) for k, (x, y, z) in enumerate(1e3 * np.array(place).T)]


def frame_of(patches):
    """Limits of x and u around all patches."""
    left, right, low, high = np.transpose([cells.outline.limits() for cells in patches])
    return (left.min() - MARGIN, right.max() + MARGIN), (low.min() - MARGIN, high.max() + MARGIN)


def patches_picture(result, patches):
    """Pressure, and adhesion with slip, on the unrolled rail head."""
    x, u = frame_of(patches)
    wide = u[1] - u[0] > 1.3 * (x[1] - x[0])
    scale = (9 if wide else 4.4) / (u[1] - u[0])
    height = scale * (x[1] - x[0])
    figure = new_figure(10.5, (2 * height + 2.4) if wide else height + 1.8, layout="compressed")
    texts = [patch_text(result, k, len(cells.outline.parts)) for k, cells in enumerate(patches)]
    put_title(figure, "\n".join([heading("Patches on the unrolled rail head", result), *texts]))
    pressure, areas = figure.subplots(2, 1) if wide else figure.subplots(1, 2)
    highest = max(cells.pressure.max() for cells in patches)
    scale_of_stress, unit = unit_for(1e6 * highest, "Pa")
    colours = Normalize(0, 1e6 * scale_of_stress * highest or 1)
    longest = max(np.hypot(cells.px, cells.py).max() for cells in patches)
    for k, cells in enumerate(patches):
        for axes in (pressure, areas):
            axes.set_aspect("equal")
        cells.draw(pressure, 1e6 * scale_of_stress * cells.pressure, turned=True, cmap=SIZES, norm=colours)
        cells.draw_outline(pressure, turned=True, linewidth=1)
        cells.draw_areas(areas, turned=True)
        cells.draw_boundary(areas, turned=True)
        cells.draw_outline(areas, turned=True, linewidth=1)
        draw_tractions(areas, cells, longest, max(one.arrows_apart() for one in patches))
        if cells.outline.limits()[3] - cells.outline.limits()[2] > WIDTH_OF_A_WORD * (u[1] - u[0]):
            name_areas(areas, cells, turned=True)
        for part in cells.outline.parts:
            top = part[np.argmax(part[:, 0])]
            pressure.annotate(f"patch {k + 1}", (top[1], top[0]), xytext=(0, 4), textcoords="offset points", ha="center", size="small")
    figure.colorbar(ScalarMappable(norm=colours, cmap=SIZES), ax=pressure, label=f"pressure [{unit}]", shrink=0.9)
    tractions = f"Friction on the wheel, at most {with_unit(1e6 * longest, 'Pa')}"
    for axes, title in ((pressure, "Pressure"), (areas, tractions)):
        axes.set_title(title, pad=18)
        axes.set_xlim(u[1], u[0])
        axes.set_ylim(*x)
        axes.set_aspect("equal")
        axes.set_ylabel("x [mm], forward")
        axes.axvline(0, color=INK3, linestyle=":", linewidth=1)
        lateral_axis(axes, result, "along the rail's surface from its highest point [mm]" if axes is areas or not wide else "")
    return figure


def draw_tractions(axes, cells, longest, apart):
    """Arrows of the tractions on an unrolled rail head, `apart` [mm] from each other."""
    if longest > 0:
        x, u, along, across = cells.arrows(cells.px, cells.py, longest, apart)
        axes.quiver(u, x, across, along, angles="xy", scale_units="xy", scale=longest / cells.arrow_length(apart), pivot="mid",
                    width=0.0022, color=INK, zorder=4)


def patch_text(result, k, parts):
    """Force and creepages of a patch, in a line."""
    force, xi, eta, phi = (result.array(f"/patches/{name}", finite=False)[k]
                           for name in ("normal_force", "creepage_longitudinal", "creepage_lateral", "spin"))
    which = f"patch {k + 1}" + (f" ({parts} parts)" if parts > 1 else "")
    return (f"{which}:  $F_n$ = {with_unit(force, 'N')},  $\\xi$ = {number(1e3 * xi)},  $\\eta$ = {number(1e3 * eta)} "
            f"$\\cdot\\,10^{{-3}}$,  $\\phi$ = {number(phi)} 1/m")


def rail_head_picture(result, rail, patches):
    """The rail head in space: the pressure drawn as a height over it, and where the patches adhere and slip."""
    x, u = frame_of(patches)
    u = max(u[0] - MARGIN, rail.u[0]), min(u[1] + MARGIN, rail.u[-1])
    largest = max(cells.pressure.max() for cells in patches) or 1
    scale, unit = unit_for(1e6 * largest, "Pa")
    figure = new_figure(9, 9.4, layout="none")
    figure.text(0.06, 0.965, heading("Patches on the rail head", result), size=matplotlib.rcParams["figure.titlesize"], weight="bold")
    field_is_left = result.text("/inputs/wheel/side") == "left"
    panels = [figure.add_axes((0.03, bottom, 0.86, 0.44), projection="3d", computed_zorder=False) for bottom in (0.52, 0.06)]
    pressed, areas = panels
    for axes, title, top in ((pressed, "Pressure, drawn as a height, too", 0.935), (areas, "Where it sticks and where it slides", 0.49)):
        draw_rail_head(axes, x, u, rail, field_is_left)
        figure.text(0.06, top, title)
    for order, cells in enumerate(sorted(patches, key=lambda one: -one.outline.limits()[2]), start=2):
        draw_pressure(pressed, rail, cells, largest, order)
        draw_states(areas, rail, cells, order)
    bar = figure.add_axes((0.89, 0.6, 0.02, 0.28))
    figure.colorbar(ScalarMappable(norm=Normalize(0, 1e6 * scale * largest), cmap=SIZES), cax=bar, label=f"pressure [{unit}]")
    areas.legend(handles=[Patch(label="sticks", facecolor=STICKS), Patch(label="slides", facecolor=SLIDES)], loc="upper right",
                 bbox_to_anchor=(0.97, 0.5), bbox_transform=figure.transFigure)
    return figure


def draw_rail_head(axes, x, u, rail, field_is_left):
    """The rail's surface, seen from behind and from the gauge side, with the rolling direction and a length on it."""
    grid_x, grid_u = np.meshgrid(np.linspace(*x, 41), np.linspace(*u, 181))
    y, z, _, _ = rail.at(grid_u)
    axes.plot_surface(grid_x, y, z, color=RAIL_FILL, shade=False, rstride=1, cstride=1, linewidth=0, clip_on=False, antialiased=False, zorder=1)
    for edge in (0, -1):
        axes.plot(grid_x[:, edge], y[:, edge], z[:, edge], color=RAIL, linewidth=1.2, clip_on=False, zorder=1.5)
        axes.plot(grid_x[edge], y[edge], z[edge], color=RAIL, linewidth=0.8, clip_on=False, zorder=1.5)
    axes.set_box_aspect((np.ptp(grid_x), np.ptp(y), np.ptp(z)), zoom=1.62)
    axes.set_axis_off()
    axes.view_init(elev=38, azim=-152 if field_is_left else 152)
    field, gauge = (u[1], u[0]) if field_is_left else (u[0], u[1])
    inwards = 1.5 if field_is_left else -1.5
    tip = np.array([[x[0] + 2, x[0] + 9], [x[0] + 7.4, x[0] + 9]]), np.array([[0, 0], [0.7, 0]])
    for along, aside in zip(*tip):
        for side in (1, -1):
            y, z, _, _ = rail.at(field - inwards + side * aside)
            axes.plot(along, y, z, color=ROLLING, linewidth=2, clip_on=False, zorder=1.8)
    y, z, _, _ = rail.at(field)
    axes.text(x[0] + 5, y + 0.6 * inwards, z, "rolls", color=ROLLING, weight="bold", ha="right", va="bottom", zorder=1.8)
    for at, name in ((field, "field side"), (gauge, "gauge side")):
        name_y, name_z, _, _ = rail.at(at)
        axes.text(x[0] - 1, name_y, name_z - 1.8, name, color=INK2, ha="left" if at == field else "center", va="top", zorder=1.8)
    middle = (u[0] + u[1]) / 2
    line = rail.at(np.linspace(middle - 5, middle + 5, 20))
    axes.plot(np.full(20, x[0] + 0.8), line[0], line[1] + 0.02, color=INK2, linewidth=2, clip_on=False, zorder=1.8)
    axes.text(x[0] - 1.5, line[0][10], line[1][10] - 1, "10 mm", color=INK2, ha="center", va="top", zorder=1.8)


def raised(rail, u, height):
    """Points at heights over the rail's surface."""
    y, z, normal_y, normal_z = rail.at(u)
    return y + height * normal_y, z + height * normal_z


def draw_pressure(axes, rail, cells, largest, order):
    """The pressure as a height, the largest one 6 mm high."""
    for x, u, pressure in cells.surface(cells.pressure, vanishes=True):
        colours = SIZES(np.clip(pressure / largest, 0, 1))
        axes.plot_surface(x, *raised(rail, u, HIGHEST / largest * pressure), facecolors=colours, rstride=1, cstride=1, linewidth=0,
                          clip_on=False, antialiased=False, shade=False, zorder=order)


def draw_states(axes, rail, cells, order):
    """Adhesion and slip as colours of the surface, outlined."""
    for (x, u, sticks), part in zip(cells.surface(cells.stickiness(), vanishes=False), cells.outline.parts):
        colours = np.where(sticks[..., None] > 0, to_rgba(STICKS), to_rgba(SLIDES))
        axes.plot_surface(x, *raised(rail, u, 0), facecolors=colours, rstride=1, cstride=1, linewidth=0, clip_on=False, antialiased=False, shade=False,
                          zorder=order)
        axes.plot(part[:, 0], *raised(rail, part[:, 1], 0), color=INK, linewidth=1, clip_on=False, zorder=order + 0.5)


def envelope(y, z, at, upper):
    """The highest or lowest z of a curve over positions; not a number where it has none."""
    low, high = np.minimum(y[:-1], y[1:]), np.maximum(y[:-1], y[1:])
    best = np.full(len(at), -np.inf if upper else np.inf)
    pick = np.maximum if upper else np.minimum
    for k in np.flatnonzero(high > low):
        inside = slice(*np.searchsorted(at, (low[k], high[k])))
        share = (at[inside] - y[k]) / (y[k + 1] - y[k])
        best[inside] = pick(best[inside], z[k] + share * (z[k + 1] - z[k]))
    return np.where(np.isfinite(best), best, np.nan)


def gap_picture(result):
    """Both bodies cut open across the track, and below the vertical distance between them with its minima; seen forward."""
    (rail_y, rail_z), (wheel_y, wheel_z) = (
        [1e3 * values for values in result.arrays([f"/outlines/{body}/y", f"/outlines/{body}/z"])] for body in ("rail", "wheel"))
    at = np.linspace(rail_y.min(), rail_y.max(), 4001)
    gap = envelope(wheel_y, wheel_z, at, False) - envelope(rail_y, rail_z, at, True)
    top_y = rail_y[np.argmax(rail_z)]
    figure = new_figure(7.6, 7.4)
    put_title(figure, heading("Wheel and rail cut open, seen forward", result))
    shape, distance = figure.subplots(2, 1, height_ratios=(2.1, 1), sharex=True)
    draw_section(shape, (rail_y - top_y, rail_z), (wheel_y - top_y, wheel_z))
    shape.set_ylabel("z [mm], up")
    distance.plot(at - top_y, gap, color=INK, linewidth=1.6)
    distance.axhline(0, color=INK2, linewidth=0.8)
    found = [k for k in minima(gap, 25) if gap[k] < 1.0]
    distance.plot(at[found] - top_y, gap[found], "o", color=ROLLING, markersize=5)
    for k in found:
        distance.annotate(f"{number(1e3 * gap[k])} µm", (at[k] - top_y, gap[k]), xytext=(0, -6), textcoords="offset points", ha="center",
                          va="top", size="small", path_effects=halo())
    mark_patches(result, shape, distance, top_y)
    deepest = np.nanmin(gap) if np.isfinite(gap).any() else 0
    distance.set_ylim(min(3.4 * deepest, -0.15), 0.8)
    distance.set_box_aspect(0.3)
    distance.set_ylabel("distance of the\nbodies [mm]")
    lateral_axis(shape, result, "")
    distance.set_xlabel("across the track from the rail's highest point [mm]")
    for axes in (shape, distance):
        open_axes(axes)
    return figure


def draw_section(axes, rail, wheel):
    """Rail and wheel as filled bodies with their names, cut off below and above by wavy lines; pairs of y and z [mm]."""
    top = rail[1].max()
    low, high = max(rail[1].min(), top - DEEP), top + HIGH
    for (y, z), end, fill, outline in ((rail, low, RAIL_FILL, RAIL), (wheel, high, WHEEL_FILL, WHEEL)):
        across = np.linspace(y[-1], y[0], 300)
        wave = end + 0.5 * np.sin(0.6 * across)
        axes.fill(np.concatenate((y, across)), np.concatenate((z, wave)), facecolor=fill, edgecolor="none", zorder=1.5)
        axes.plot(y, z, color=outline, linewidth=1.6, zorder=2)
        axes.plot(across, wave, color=INK2, linewidth=0.6, zorder=2)
    axes.set_aspect("equal")
    left, right = max(rail[0].max(), min(wheel[0].max(), BESIDE)), min(rail[0].min(), max(wheel[0].min(), -BESIDE))
    axes.set_xlim(left + 3, right - 3)
    axes.set_ylim(low - 2, high + 2)
    for y, z, name in ((0.0, top - 0.6 * DEEP, "Rail"), (0.0, top + 0.55 * HIGH, "Wheel")):
        axes.text(y, z, name, ha="center", va="center", weight="bold", size="large", zorder=3)


def minima(values, reach):
    """Indices of values that are the least ones so far around; what is not a number counts as large."""
    filled = np.concatenate([np.full(reach, np.inf), np.where(np.isnan(values), np.inf, values), np.full(reach, np.inf)])
    least = np.lib.stride_tricks.sliding_window_view(filled, 2 * reach + 1).min(axis=1)
    found = np.flatnonzero((values == least) & np.isfinite(values))
    return [k for k, before in zip(found, np.concatenate(([-2 * reach], found))) if k - before > reach]


def mark_patches(result, shape, distance, top_y):
    """Each part of each patch as a thick line on the rail, with its width shaded below; without fields the origins of patches."""
    if "patches" not in result:
        return
    rail = RailHead(result)
    if "fields" in result:
        patches = read_patches(result, rail)
        parts = [(k, part[:, 1].min(), part[:, 1].max()) for k, cells in enumerate(patches) for part in cells.outline.parts]
    else:
        y, z = (1e3 * values for values in result.arrays(["/patches/place_y", "/patches/place_z"]))
        parts = [(k, *[rail.nearest(*place)] * 2) for k, place in enumerate(zip(y, z))]
    for k, first, last in parts:
        y, z, normal_y, normal_z = rail.at(np.linspace(first, last, 30))
        shape.plot(y - top_y, z, "-" if last > first else "o", color=ROLLING, linewidth=4.5, solid_capstyle="butt", zorder=4)
        at, up = (normal_y[15], normal_z[15])
        shape.annotate(f"patch {k + 1}", (y[15] - top_y, z[15]), xytext=(y[15] - top_y - 9 * at, z[15] - 9 * up), ha="center", va="center",
                       color=ROLLING, size="small", weight="bold", zorder=5, path_effects=halo())
        if last > first:
            distance.axvspan(y.min() - top_y, y.max() - top_y, color=ROLLING, alpha=0.12, linewidth=0)


def varied(result):
    """The number that a sweep varies first: name, values and unit as pictures show them."""
    name = result.group_attribute("states", "varied").split(", ")[0]
    values = result.array(f"/states/{name}")
    unit = result.unit(f"/states/{name}")
    printed, factor = LENGTHS.get(unit, (unit, 1))
    return f"{name.replace('_', ' ')} [{printed}]", factor * values


def contact_points_picture(result):
    """Wheel and rail in the axes of their profiles, drawn apart, with points that touch joined."""
    label, values = varied(result)
    (rail_y, rail_z), (wheel_y, wheel_z) = (
        [1e3 * part for part in result.arrays([f"/profiles/{body}/y", f"/profiles/{body}/z"])] for body in ("rail", "wheel"))
    if "patches" in result:
        state = result.array("/patches/state").astype(int)
        on_rail, on_wheel = (1e3 * values for values in result.arrays(["/patches/rail_y", "/patches/wheel_y"]))
        force = result.array("/patches/normal_force", finite=False)
    else:
        state, on_rail, on_wheel, force = np.zeros(0, dtype=int), np.zeros(0), np.zeros(0), np.zeros(0)
    width = 0.4 + 1.6 * np.nan_to_num(force / max(np.nanmax(force, initial=0), 1e-300))
    figure = new_figure(7.6, 4.4)
    put_title(figure, heading("Contact points", result))
    axes = figure.subplots()
    lines = draw_contact_points(axes, (rail_y, rail_z), (wheel_y, wheel_z), (on_rail, envelope_at(rail_y, rail_z, on_rail, True)),
                                (on_wheel, envelope_at(wheel_y, wheel_z, on_wheel, False)), values[state], width)
    axes.text(0, -18, "rail; lines as strong as the normal force", color=RAIL, ha="center")
    figure.colorbar(lines, ax=axes, label=label, shrink=0.8)
    return figure


def envelope_at(y, z, points, upper):
    """`envelope` at points in any order."""
    order = np.argsort(points)
    found = np.empty(len(points))
    found[order] = envelope(y, z, points[order], upper)
    return found


def plot_states(axes, values, results, dashes, color, label):
    """A result over the states of a sweep: a line, or where they are few dots, since nothing is known between them."""
    if len(values) >= MOST_MARKED:
        axes.plot(values, results, dashes, color=color, label=label)
        return
    axes.plot(values, results, "o" if dashes == "-" else "s", color=color, markersize=3.5, fillstyle="full" if dashes == "-" else "none",
              label=label)
    axes.plot(values, results, dashes, color=color, linewidth=0.8, alpha=0.4)


def forces_picture(result):
    """Forces on the wheel, their split on patches, contact angles, T-gamma and power over what a sweep varies."""
    label, values = varied(result)
    figure = new_figure(7.0, 8.6)
    put_title(figure, heading("Forces on the wheel", result))
    forces, loads, angles, wear = figure.subplots(4, 1, sharex=True)
    both = {name: result.array(f"/wheel/{name}", finite=False) for name in ("force_x", "force_y")}
    largest = max(np.nanmax(np.abs(one), initial=0) for one in both.values())
    scale, unit = unit_for(largest, "N")
    for (name, force), colour, dashes, text in zip(both.items(), (ALONG, ACROSS), ("-", "--"), ("$F_x$, forward", "$F_y$, to the left")):
        plot_states(forces, values, scale * shown(force, largest), dashes, color=colour, label=text)
    forces.set_ylabel(f"force [{unit}]")
    for name, colour, dashes, text in (("t_gamma", INK, "-", r"$T\gamma$"), ("t_gamma_with_spin", MAGENTA, "--", r"$T\gamma$ with spin")):
        plot_states(wear, values, result.array(f"/wheel/{name}", finite=False), dashes, color=colour, label=text)
    wear.set_ylabel(r"$T\gamma$ [N]")
    power = wear.twinx()
    # Often proportional to T-gamma with spin: a broad pale line below it.
    power.plot(values, 1e-3 * result.array("/wheel/frictional_power", finite=False), color=SLIDES, linewidth=5, alpha=0.4)
    wear.set_zorder(power.get_zorder() + 1)
    wear.patch.set_visible(False)
    power.set_ylabel("frictional power [kW]", color=SLIDES)
    power.spines["top"].set_visible(False)
    if "patches" in result:
        at = values[result.array("/patches/state").astype(int)]
        size = 3.5 if len(values) < MOST_MARKED else 2
        loads.plot(at, 1e-3 * result.array("/patches/normal_force", finite=False), "o", color=INK, markersize=size)
        angles.plot(at, np.degrees(result.array("/patches/angle", finite=False)), "o", color=INK, markersize=size)
    loads.set_ylabel("$F_n$ of each\npatch [kN]")
    angles.set_ylabel("contact\nangle [deg]")
    wear.set_xlabel(label)
    for axes in (forces, loads, angles, wear):
        open_axes(axes)
    for axes in (forces, wear):
        names_above(axes)
    return figure


