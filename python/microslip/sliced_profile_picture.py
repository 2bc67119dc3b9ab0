"""The surface of a profile that varies, made of slices: in space, and sections of it."""

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.picture_style import INK, SIZES_OF_LINES, heading, new_figure, open_axes, put_title

# Lines of equal v, sections and stations that are drawn at most.
MOST_LINES, MOST_SECTIONS, MOST_STATIONS = 120, 60, 300


def sliced_profile_pictures(result):
    """The picture of a result file of kind sliced_profile, by file name."""
    u, slices = (result.array(f"/{name}/u") for name in ("surface", "slices"))
    y, z = (1e3 * values for values in result.arrays(["/surface/y", "/surface/z"], dimensions=2, finite=False))
    is_wheel = result.text("/role") == "wheel"
    scale, label = (180 / np.pi, "angle around the axle [deg]") if is_wheel else (1e3, "u [mm], along the track")
    figure = new_figure(13, 6.2)
    put_title(figure, heading(f"{result.text('/role').capitalize()} of {len(slices)} slices", result))
    left, right = figure.subfigures(1, 2, width_ratios=(1.25, 1))
    height = Normalize(np.nanmin(z), np.nanmax(z))
    draw_surface(left.add_subplot(projection="3d"), scale * u, y, z, label, height)
    left.colorbar(ScalarMappable(norm=height, cmap=SIZES_OF_LINES), ax=left.axes, label="z [mm], up", shrink=0.6, pad=0.08)
    axes = right.subplots()
    along = Normalize(scale * u[0], scale * u[-1])
    draw_sections(axes, scale * u, scale * slices, y, z, along)
    right.colorbar(ScalarMappable(norm=along, cmap=SIZES_OF_LINES), ax=axes, label=label, shrink=0.8)
    return {"surface.png": figure}


def strided(values, most):
    """So many of the indices at most, both ends among them."""
    return np.unique(np.linspace(0, len(values) - 1, min(len(values), most)).round().astype(int))


def draw_surface(axes, u, y, z, label, height):
    """The surface; where it is interrupted there is none. Lengths along the track are not to the scale of the others."""
    stations, lines = strided(u, MOST_STATIONS), strided(y[0], MOST_LINES)
    chosen = np.ix_(stations, lines)
    along = np.broadcast_to(u[stations, None], y[chosen].shape)
    colours = SIZES_OF_LINES(height(np.nan_to_num(z[chosen])))
    axes.plot_surface(along, y[chosen], z[chosen], facecolors=colours, rstride=1, cstride=1, linewidth=0, antialiased=False, shade=False)
    wide, high = np.nanmax(y) - np.nanmin(y), np.nanmax(z) - np.nanmin(z)
    axes.set_box_aspect((2.0, 1.0, max(high / wide, 0.15)), zoom=0.78)
    axes.set_xlabel(label, labelpad=12)
    axes.set_ylabel("y [mm], to the field side", labelpad=5)
    axes.set_zticks([])
    axes.view_init(elev=35, azim=-115)


def draw_sections(axes, u, slices, y, z, along):
    """Sections at slices, to scale."""
    at_slices = np.searchsorted(u, slices - 1e-9 * max(np.ptp(slices), 1e-12)).clip(0, len(u) - 1)
    for k in at_slices[strided(at_slices, MOST_SECTIONS)]:
        axes.plot(y[k], z[k], color=SIZES_OF_LINES(along(u[k])), linewidth=1)
    axes.set_aspect("equal", adjustable="datalim")
    axes.set_xlabel("y [mm], to the field side")
    axes.set_ylabel("z [mm], up")
    axes.set_title("Sections at the slices" if len(slices) <= MOST_SECTIONS else f"Sections at {MOST_SECTIONS} of the slices",
                   color=INK)
    open_axes(axes)
