"""Pictures of a wheel on a rail: patches on the rail head, unrolled and in space; the gap; of a sweep contact points and forces."""

import matplotlib
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize, to_rgba
from matplotlib.patches import Patch

from microslip.contact_cells import ADHESION, EXTERIOR
from microslip.contact_points_picture import draw_contact_points
from microslip.field_picture import SEQUENTIAL
from microslip.interior_picture import interior_picture, interior_points
from microslip.picture_style import (BLACK, BLUE, GREEN, GREY, ORANGE, SKY_BLUE, VERMILION, heading, new_figure, number, open_axes,
                                     put_title, unit_for, with_unit)
from microslip.profile_tractions_picture import profile_tractions_picture
from microslip.solved_contacts import patch_cells

LENGTHS = {"m": ("mm", 1e3)}
# What lies around the patches on pictures of the rail head [mm].
MARGIN = 6.0
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
    x = (x[0] + MARGIN / 2, x[1] + 0.15 * (x[1] - x[0]))  # space for the texts
    wide = u[1] - u[0] > 1.3 * (x[1] - x[0])
    scale = (9 if wide else 5) / (u[1] - u[0])
    height = scale * (x[1] - x[0])
    figure = new_figure(10.5 if wide else 12.5, (2 * height + 2.2) if wide else height + 1.6, layout="compressed")
    put_title(figure, heading("Patches on the unrolled rail head", result))
    pressure, areas = figure.subplots(2, 1) if wide else figure.subplots(1, 2)
    highest = max(cells.pressure.max() for cells in patches)
    scale_of_stress, unit = unit_for(1e6 * highest, "Pa")
    colours = Normalize(0, 1e6 * scale_of_stress * highest or 1)
    longest = max(np.hypot(cells.px, cells.py).max() for cells in patches) or 1
    for k, cells in enumerate(patches):
        for axes in (pressure, areas):
            axes.set_aspect("equal")
        cells.draw(pressure, 1e6 * scale_of_stress * cells.pressure, turned=True, cmap=SEQUENTIAL, norm=colours)
        cells.draw_outline(pressure, turned=True, linewidth=0.8)
        cells.draw_areas(areas, turned=True)
        cells.draw_boundary(areas, turned=True)
        cells.draw_outline(areas, turned=True, linewidth=0.8)
        draw_tractions(areas, cells, longest)
        pressure.annotate(patch_text(result, k), (np.mean(cells.outline.limits()[2:]), x[1]), ha="center", va="top",
                          xytext=(0, -4), textcoords="offset points", fontsize=8)
    figure.colorbar(ScalarMappable(norm=colours, cmap=SEQUENTIAL), ax=pressure, label=f"pressure [{unit}]", shrink=0.8)
    areas.legend(handles=[Patch(label="adhesion", facecolor=SKY_BLUE), Patch(label="slip", facecolor=ORANGE)], loc="upper right",
                 ncols=2, frameon=True, edgecolor="none")
    tractions = f"Adhesion, slip, and tractions on the wheel, at most {with_unit(1e6 * longest, 'Pa')}"
    for axes, title in ((pressure, "Pressure"), (areas, tractions)):
        axes.set_title(title)
        axes.set_xlim(u[1], u[0])
        axes.set_ylim(*x)
        axes.set_aspect("equal")
        axes.set_ylabel("x [mm], forward")
        axes.axvline(0, color=GREY, linestyle=":", linewidth=1)
    for axes in (areas,) if wide else (pressure, areas):
        axes.set_xlabel("length along the rail's surface from its highest point [mm], to the left")
    return figure


def draw_tractions(axes, cells, longest):
    """Arrows some 1.5 mm apart, about the contact's middle."""
    inside = cells.state != EXTERIOR
    chosen = np.zeros(inside.shape, dtype=bool)
    if inside.any():
        rows, columns = (max(1, round(1.5 / size)) for size in (cells.height, np.median(cells.apart)))
        row, column = (int(np.median(indices)) for indices in np.nonzero(inside))
        chosen[row % rows::rows, column % columns::columns] = True
    chosen &= cells.shown
    axes.quiver(cells.y[chosen], cells.x[chosen], cells.py[chosen], cells.px[chosen], angles="xy", scale_units="xy",
                scale=longest / 2.0, width=0.003, color=BLACK, zorder=3)


def patch_text(result, k):
    """Force and creepages of a patch."""
    force, xi, eta, phi = (result.array(f"/patches/{name}", finite=False)[k]
                           for name in ("normal_force", "creepage_longitudinal", "creepage_lateral", "spin"))
    return (f"$F_n$ = {with_unit(force, 'N')}\n$\\xi$ = {number(1e3 * xi)}, $\\eta$ = {number(1e3 * eta)} $\\cdot 10^{{-3}}$\n"
            f"$\\phi$ = {number(phi)} /m")


def rail_head_picture(result, rail, patches):
    """The rail head in space: the pressure drawn as a height over it, and where the patches adhere and slip."""
    x, u = frame_of(patches)
    u = max(u[0] - MARGIN, rail.u[0]), min(u[1] + MARGIN, rail.u[-1])
    largest = max(cells.pressure.max() for cells in patches) or 1
    scale, unit = unit_for(1e6 * largest, "Pa")
    figure = new_figure(9, 10)
    put_title(figure, heading("Patches on the rail head", result))
    pressed, areas = panels = figure.subplots(2, 1, subplot_kw={"projection": "3d", "computed_zorder": False})
    for axes, title in ((pressed, "Pressure"), (areas, "Adhesion and slip")):
        draw_rail_head(axes, x, u, rail, result.text("/inputs/wheel/side") == "left")
        axes.set_title(title, y=0.95)
    for order, cells in enumerate(sorted(patches, key=lambda one: -one.outline.limits()[2]), start=2):
        draw_pressure(pressed, rail, cells, largest, order)
        draw_states(areas, rail, cells, order)
    figure.colorbar(ScalarMappable(norm=Normalize(0, 1e6 * scale * largest), cmap=SEQUENTIAL), ax=panels, label=f"pressure [{unit}]",
                    shrink=0.35, pad=0.16, anchor=(0, 0.85))
    areas.legend(handles=[Patch(label="adhesion", facecolor=SKY_BLUE), Patch(label="slip", facecolor=ORANGE)], loc="upper right")
    return figure


def draw_rail_head(axes, x, u, rail, field_is_left):
    """The rail's surface, seen from behind and from the gauge side."""
    grid_x, grid_u = np.meshgrid(np.linspace(*x, 41), np.linspace(*u, 181))
    y, z, _, _ = rail.at(grid_u)
    axes.plot_surface(grid_x, y, z, color=(0.86, 0.87, 0.88), rstride=1, cstride=1, linewidth=0, antialiased=False, zorder=1)
    axes.set_box_aspect((np.ptp(grid_x), np.ptp(y), np.ptp(z)), zoom=1.1)
    axes.set_xlabel("x [mm], forward", labelpad=6)
    axes.set_ylabel("y [mm], to the left", labelpad=14)
    axes.set_zticks([])
    axes.view_init(elev=35, azim=-145 if field_is_left else 145)


def raised(rail, u, height):
    """Points at heights over the rail's surface."""
    y, z, normal_y, normal_z = rail.at(u)
    return y + height * normal_y, z + height * normal_z


def draw_pressure(axes, rail, cells, largest, order):
    """The pressure as a height, the largest one 6 mm high."""
    for x, u, pressure in cells.surface(cells.pressure, vanishes=True):
        colours = matplotlib.colormaps[SEQUENTIAL](np.clip(pressure / largest, 0, 1))
        axes.plot_surface(x, *raised(rail, u, HIGHEST / largest * pressure), facecolors=colours, rstride=1, cstride=1, linewidth=0,
                          antialiased=False, shade=False, zorder=order)


def draw_states(axes, rail, cells, order):
    """Adhesion and slip as colours of the surface, outlined."""
    adheres = (cells.state == ADHESION).astype(float)
    for (x, u, adhesion), part in zip(cells.surface(adheres, vanishes=False), cells.outline.parts):
        colours = np.where(adhesion[..., None] > 0.5, to_rgba(SKY_BLUE), to_rgba(ORANGE))
        axes.plot_surface(x, *raised(rail, u, 0), facecolors=colours, rstride=1, cstride=1, linewidth=0, antialiased=False, shade=False,
                          zorder=order)
        axes.plot(part[:, 0], *raised(rail, part[:, 1], 0), color=BLACK, linewidth=0.6, zorder=order + 0.5)


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
    """Both outlines along the track, and the vertical distance between them with its minima."""
    (rail_y, rail_z), (wheel_y, wheel_z) = (
        [1e3 * values for values in result.arrays([f"/outlines/{body}/y", f"/outlines/{body}/z"])] for body in ("rail", "wheel"))
    at = np.linspace(rail_y.min(), rail_y.max(), 4001)
    gap = envelope(wheel_y, wheel_z, at, False) - envelope(rail_y, rail_z, at, True)
    figure = new_figure(10, 7.5)
    put_title(figure, heading("Wheel and rail, seen forward", result))
    shape, distance = figure.subplots(2, 1, height_ratios=(1.6, 1))
    shape.plot(rail_y, rail_z, color=GREY, linewidth=1.6, label="rail")
    shape.plot(wheel_y, wheel_z, color=BLUE, linewidth=1.6, label="wheel")
    shape.set_aspect("equal", adjustable="datalim")
    middle, top = (rail_y.min() + rail_y.max()) / 2, rail_z.max()
    shape.set_xlim(middle + 65, middle - 65)
    shape.set_ylim(top - 30, top + 34)
    shape.set_ylabel("z [mm], up")
    distance.plot(at, gap, color=BLUE, linewidth=1.4)
    distance.axhline(0, color=BLACK, linewidth=0.8)
    shown = [k for k in minima(gap, 25) if gap[k] < 1.0]
    distance.plot(at[shown], gap[shown], "o", color=VERMILION, markersize=6, label="minima")
    for k in shown:
        distance.annotate(f"{number(1e3 * gap[k])} µm", (at[k], gap[k]), xytext=(0, -14), textcoords="offset points", ha="center",
                          fontsize=8)
    mark_patches(result, shape)
    distance.set_xlim(rail_y.max(), rail_y.min())
    deepest = np.nanmin(gap) if np.isfinite(gap).any() else 0
    distance.set_ylim(min(3 * deepest, -0.15), 0.8)
    distance.set_ylabel("gap [mm]")
    distance.set_xlabel("y [mm], to the left of the track's centre")
    for axes in (shape, distance):
        open_axes(axes)
        axes.legend(loc="center left", bbox_to_anchor=(1.0, 0.5))
    return figure


def minima(values, reach):
    """Indices of values that are the least ones so far around; what is not a number counts as large."""
    filled = np.concatenate([np.full(reach, np.inf), np.where(np.isnan(values), np.inf, values), np.full(reach, np.inf)])
    least = np.lib.stride_tricks.sliding_window_view(filled, 2 * reach + 1).min(axis=1)
    found = np.flatnonzero((values == least) & np.isfinite(values))
    return [k for k, before in zip(found, np.concatenate(([-2 * reach], found))) if k - before > reach]


def mark_patches(result, axes):
    """The origin of each patch with its normal."""
    if "patches" not in result:
        return
    y, z, angle = result.arrays(["/patches/place_y", "/patches/place_z", "/patches/angle"])
    for k, (one_y, one_z, one_angle) in enumerate(zip(1e3 * y, 1e3 * z, angle)):
        axes.annotate(f"patch {k + 1}", (one_y, one_z), xytext=(one_y + 14 * np.sin(one_angle), one_z - 14 * np.cos(one_angle)),
                      fontsize=9, ha="center", va="center", color=VERMILION,
                      arrowprops={"arrowstyle": "-|>", "color": VERMILION, "linewidth": 1.2})


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
    figure = new_figure(9, 5)
    put_title(figure, heading("Contact points", result))
    axes = figure.subplots()
    lines = draw_contact_points(axes, (rail_y, rail_z), (wheel_y, wheel_z), (on_rail, envelope_at(rail_y, rail_z, on_rail, True)),
                                (on_wheel, envelope_at(wheel_y, wheel_z, on_wheel, False)), values[state], width)
    axes.text(0, -18, "rail; lines as strong as the normal force", color=GREY, ha="center")
    figure.colorbar(lines, ax=axes, label=label, shrink=0.8)
    return figure


def envelope_at(y, z, points, upper):
    """`envelope` at points in any order."""
    order = np.argsort(points)
    found = np.empty(len(points))
    found[order] = envelope(y, z, points[order], upper)
    return found


def forces_picture(result):
    """Forces on the wheel, their split on patches, contact angles, T-gamma and power over what a sweep varies."""
    label, values = varied(result)
    figure = new_figure(10, 9)
    put_title(figure, heading("Forces on the wheel", result))
    forces, loads, angles, wear = figure.subplots(4, 1, sharex=True)
    both = {name: result.array(f"/wheel/{name}", finite=False) for name in ("force_x", "force_y")}
    scale, unit = unit_for(max(np.nanmax(np.abs(one), initial=0) for one in both.values()), "N")
    for (name, force), colour, text in zip(both.items(), (BLUE, VERMILION), ("$F_x$, forward", "$F_y$, to the left")):
        forces.plot(values, scale * force, ".-", color=colour, label=text)
    forces.set_ylabel(f"force [{unit}]")
    wear.plot(values, result.array("/wheel/t_gamma", finite=False), ".-", color=BLUE, label=r"$T\gamma$")
    wear.plot(values, result.array("/wheel/t_gamma_with_spin", finite=False), ".--", color=SKY_BLUE, label=r"$T\gamma$ with spin")
    wear.set_ylabel(r"$T\gamma$ [N]")
    power = wear.twinx()
    # Often proportional to T-gamma with spin: a broad pale line below it.
    power.plot(values, 1e-3 * result.array("/wheel/frictional_power", finite=False), color=ORANGE, linewidth=5, alpha=0.4)
    wear.set_zorder(power.get_zorder() + 1)
    wear.patch.set_visible(False)
    power.set_ylabel("frictional power [kW]", color=ORANGE)
    power.spines["top"].set_visible(False)
    if "patches" in result:
        at = values[result.array("/patches/state").astype(int)]
        loads.plot(at, 1e-3 * result.array("/patches/normal_force", finite=False), "o", color=GREEN, markersize=4)
        angles.plot(at, np.degrees(result.array("/patches/angle", finite=False)), "o", color=BLACK, markersize=4)
    loads.set_ylabel("$F_n$ of each patch [kN]")
    angles.set_ylabel("contact angle [deg]")
    wear.set_xlabel(label)
    for axes in (forces, loads, angles, wear):
        open_axes(axes)
    for axes, right in ((forces, 1.0), (wear, 1.12)):
        axes.legend(loc="center left", bbox_to_anchor=(right, 0.5))
    return figure
