"""The grid of a contact area to draw: elements in adhesion or slip within the outline of the contact."""

import math

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import PathPatch

from microslip.contact_outline import ellipse, outline_of_rows, strip
from microslip.picture_style import ORANGE, SKY_BLUE

EXTERIOR, ADHESION, SLIP = 0, 1, 2
HATCH = {"hatch": "////", "edgecolor": "#8a5f00"}
# Finer grids are sampled: a picture has no pixels to show more.
MOST_CELLS = 400
# Along the longer side of an image.
PIXELS = 1000
# Arrows along the contact's longer axis.
MOST_ARROWS = 20
# Contacts slimmer than this are drawn with different scales along x and y.
SLIMMEST_TRUE_TO_SCALE = 1 / 8
# Rings and rays of the mesh of a surface.
RINGS, RAYS = 36, 145
# Elements so near to the edge do not tell the smooth factor of fields that vanish there.
NEAR_EDGE = 0.97


class ContactCells:
    """Fields on a grid. Lengths in mm, tractions in MPa, relative slip in 1e-3; arrays (rows, cells of a row).

    The outline of the contact is the ellipse of the semi-axes, or with pressures where these vanish.
    """

    def __init__(self, x, y, area, bound, px, py, sx, sy, state, semi_axes=None, pressure=None, size=None):
        self.x, self.y, self.bound, self.px, self.py = x, y, bound, px, py
        self.sx, self.sy, self.state, self.pressure = sx, sy, state, pressure
        self.row_y = y[:, 0]
        self.inside = state != EXTERIOR
        rows, columns = x.shape
        self.is_regular = size is not None  # elements of one size on a grid
        if size:
            self.apart, self.height = np.full(rows, size[0]), size[1]
        else:
            self.height = abs(self.row_y[-1] - self.row_y[0]) / (rows - 1) if rows > 1 else 2 * semi_axes[1]
            self.apart = (np.abs(x[:, 0] - x[:, -1]) / (columns - 1) if columns > 1
                          else 2 * semi_axes[0] * np.sqrt(np.clip(1 - (self.row_y / semi_axes[1]) ** 2, 0, None)))
        # Cells of a row are as long as they are apart, but for one that is fitted to the leading edge: its area tells.
        self.widths = self.apart[:, None] * area / np.median(area, axis=1, keepdims=True)
        self.outline = ellipse(*semi_axes) if semi_axes is not None else self.outline_of_pressure()
        left, right, low, high = self.outline.limits()
        self.a, self.b = (right - left) / 2 or self.apart.max(), (high - low) / 2 or self.height
        self.shown = self.inside & self.outline.contain(x, y)

    def outline_of_pressure(self):
        """Where the pressure vanishes; a single row of a regular grid has that of its elements."""
        if self.is_regular and len(self.x) == 1:
            return strip(self.x[self.inside], self.apart[0], self.row_y[0], self.height)
        return outline_of_rows(self.x, self.row_y, self.height, self.widths, self.pressure, self.inside)

    def spans(self, state, row):
        """Intervals along x in which the cells of a row are in a state, neighbours joined."""
        inside = np.concatenate(([False], self.state[row] == state, [False])).astype(np.int8)
        steps = np.diff(inside)
        for first, last in zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1):
            ends = [self.x[row, i] + side * self.widths[row, i] / 2 for i in (first, last) for side in (-1, 1)]
            yield min(ends), max(ends)

    def nearest(self, x, y):
        """Indices (row, cell) of the cells in contact that are nearest to all pairs of x and y: arrays (len(y), len(x))."""
        rows = np.flatnonzero(self.inside.any(axis=1))
        nearest = rows[np.argmin(np.abs(self.row_y[rows] - y[:, None]), axis=1)]
        best = np.full((len(y), len(x)), np.inf)
        row_of, cell_of = np.zeros(best.shape, dtype=int), np.zeros(best.shape, dtype=int)
        for row in rows:  # of its row and of both next to it
            lines = np.flatnonzero(np.abs(nearest - row) <= 1)
            cell, away = self._nearest_in_row(row, x)
            aside = np.clip(np.abs(y[lines] - self.row_y[row]) / self.height - 0.5, 0, None)
            distance = np.hypot(away[None, :], aside[:, None])
            closer = distance < best[lines]
            for target, values in ((best, distance), (row_of, np.full_like(cell_of[lines], row)),
                                   (cell_of, np.broadcast_to(cell, distance.shape))):
                target[lines] = np.where(closer, values, target[lines])
        return row_of, cell_of

    def _nearest_in_row(self, row, x):
        """The cells of a row that hold positions or are nearest to them, and how far away they are, in widths."""
        cells = np.flatnonzero(self.inside[row])
        cells = cells[np.argsort(self.x[row, cells])]
        middle, half = self.x[row, cells], self.widths[row, cells] / 2
        borders = (middle[:-1] + half[:-1] + middle[1:] - half[1:]) / 2
        found = np.searchsorted(borders, x)
        return cells[found], np.clip(np.abs(x - middle[found]) / (2 * half[found]) - 0.5, 0, None)

    def pixels(self):
        """Positions x and y of an image of the contact, some points beyond its outline."""
        left, right, low, high = self.outline.limits()
        along, across = (np.linspace(*ends, PIXELS) for ends in ((left, right), (low, high)))
        return along, across

    def draw(self, axes, values, turned=False, **how):
        """Values of the cells as flat colours up to the outline; turned: x upwards, y to the right."""
        if not self.inside.any():
            return
        x, y = self.pixels()
        image = np.ma.masked_invalid(values[self.nearest(x, y)])
        extent = (x[0], x[-1], y[0], y[-1])
        if turned:
            image, extent = image.T, (*extent[2:], *extent[:2])
        drawn = axes.imshow(image, extent=extent, origin="lower", interpolation="nearest", aspect=axes.get_aspect(), **how)
        drawn.set_clip_path(self.path(turned), axes.transData)

    def draw_outline(self, axes, turned=False, **how):
        """The outline as a line, or with a facecolor as an area."""
        how = {"fill": "facecolor" in how, "edgecolor": "black", "linewidth": 1.2, "zorder": 3, **how}
        axes.add_patch(PathPatch(self.path(turned), **how))

    def draw_areas(self, axes, turned=False):
        """Slip hatched over the whole contact, adhesion over it."""
        self.draw_outline(axes, turned, facecolor=ORANGE, zorder=1, linewidth=0, **HATCH)
        adhesion = np.where(self.state == ADHESION, 1.0, np.nan)
        self.draw(axes, adhesion, turned, cmap=ListedColormap([SKY_BLUE]), zorder=1.5)

    def draw_boundary(self, axes, turned=False):
        """The line between adhesion and slip, with a white rim."""
        if not self.has_boundary():
            return
        x, y = self.pixels()
        adheres = (self.state[self.nearest(x, y)] == ADHESION).astype(float)
        coordinates = (y, x, adheres.T) if turned else (x, y, adheres)
        for colour, width in (("white", 3.2), ("black", 1.8)):
            lines = axes.contour(*coordinates, levels=[0.5], colors=colour, linewidths=width, zorder=2.5)
            for line in lines.collections:
                line.set_clip_path(self.path(turned), axes.transData)

    def path(self, turned=False):
        """The outline as a path."""
        return self.outline.turned() if turned else self.outline.path

    def has_boundary(self):
        """Returns whether there are adhesion and slip."""
        return bool((self.state == ADHESION).any() and (self.state == SLIP).any())

    def surface(self, values, vanishes):
        """Values on meshes from the middle of each part of the contact to its outline: arrays x, y, values of rings and rays.

        Between the cells they are interpolated, of fields that vanish at the edge what is left when the root of the
        distance, as of Hertz's pressure, is divided out. On regular grids, whose contacts may have any shape, the mesh is
        the grid; beyond the contact values are 0 or no numbers.
        """
        if self.is_regular and min(self.x.shape) > 1:
            return [self._surface_on_grid(values, vanishes)]
        return [self._surface_of(StarMesh(part), values, vanishes) for part in self.outline.parts]

    def _surface_on_grid(self, values, vanishes):
        rows, columns = (np.flatnonzero(self.inside.any(axis=axis)) for axis in (1, 0))
        part = tuple(slice(max(found.min(initial=count) - 1, 0), found.max(initial=0) + 2)
                     for found, count in zip((rows, columns), self.x.shape))
        return self.x[part], self.y[part], np.where(self.inside, values, 0.0 if vanishes else np.nan)[part]

    def _surface_of(self, mesh, values, vanishes):
        place = mesh.place(self.x, self.y)
        mine = self.inside & (place < (NEAR_EDGE if vanishes else 1.0))
        if not mine.any():
            mine = self.inside & (place <= max(1.5, place[self.inside].min()))  # a splinter may have no centre of a cell
        factor = np.sqrt(np.clip(1 - place**2, 1 - NEAR_EDGE**2, None)) if vanishes else np.ones(place.shape)
        smooth = self._interpolated(values / factor, mine, mesh.x, mesh.y)
        return mesh.x, mesh.y, smooth * mesh.edge_factor() if vanishes else smooth

    def _interpolated(self, values, mine, x, y):
        """Along rows and between them; beyond the outermost cells as there."""
        rows = np.flatnonzero(mine.any(axis=1))
        rows = rows[np.argsort(self.row_y[rows])]
        at = np.interp(y, self.row_y[rows], np.arange(len(rows)))
        lower = np.minimum(at.astype(int), len(rows) - 1)
        result = np.zeros(x.shape)
        for number, row in enumerate(rows):
            cells = np.flatnonzero(mine[row])
            cells = cells[np.argsort(self.x[row, cells])]
            for points, share in ((lower == number, 1 - (at - lower)), (lower == number - 1, at - lower)):
                result[points] += share[points] * np.interp(x[points], self.x[row, cells], values[row, cells])
        return result

    def true_to_scale(self):
        """Returns whether one scale along x and y shows the contact well."""
        return SLIMMEST_TRUE_TO_SCALE <= self.a / self.b <= 1 / SLIMMEST_TRUE_TO_SCALE

    def sample(self):
        """A mask of cells for arrows: far enough apart to be read, but at least 5 along each axis."""
        along = 5 if self.true_to_scale() else MOST_ARROWS
        apart_x, apart_y = (min(self._arrows_apart(), 2 * axis / along) for axis in (self.a, self.b))
        chosen = np.zeros(self.state.shape, dtype=bool)
        for row in every(len(self.row_y), apart_y / self.height):
            chosen[row, every(self.state.shape[1], apart_x / self.apart[row])] = True
        return chosen & self.shown

    def _arrows_apart(self):
        return 2 * max(self.a, self.b) / MOST_ARROWS

    def arrow_length(self):
        """A length for the longest arrow [mm] that suits the arrows' distance."""
        spacing = max(self._arrows_apart(), min(self.apart.max(), self.height))
        return min(1.35 * spacing, 0.15 * 2 * max(self.a, self.b))


class StarMesh:
    """Points on rings within a closed curve, each a smaller picture of it about its middle; the rings crowd at the curve."""

    def __init__(self, curve):
        self.middle = (curve.max(axis=0) + curve.min(axis=0)) / 2
        self.scale = (curve.max(axis=0) - curve.min(axis=0)) / 2
        away = (curve - self.middle) / self.scale
        angle, radius = np.arctan2(away[:, 1], away[:, 0]), np.hypot(*away.T)
        order = np.argsort(angle)
        self._angle, self._radius = angle[order], radius[order]
        self.rings = np.sin(np.linspace(0, np.pi / 2, RINGS))[:, None]
        rays = np.linspace(-np.pi, np.pi, RAYS)
        reach = self._reach(rays)
        self.x = self.middle[0] + self.scale[0] * self.rings * reach * np.cos(rays)
        self.y = self.middle[1] + self.scale[1] * self.rings * reach * np.sin(rays)

    def _reach(self, angle):
        """The distance of the curve, in the scale of its half widths."""
        return np.interp(angle, self._angle, self._radius, period=2 * np.pi)

    def place(self, x, y):
        """The ring of points: 0 in the middle, 1 on the curve."""
        across, up = (x - self.middle[0]) / self.scale[0], (y - self.middle[1]) / self.scale[1]
        return np.hypot(across, up) / self._reach(np.arctan2(up, across))

    def edge_factor(self):
        """sqrt(1 - ring^2): Hertz's pressure in parts of its largest one."""
        return np.broadcast_to(np.sqrt(np.clip(1 - self.rings**2, 0, None)), self.x.shape)


def every(count, stride):
    """Indices of evenly spaced entries, the remainder shared between both ends; the stride is rounded up."""
    stride = min(count, max(1, math.ceil(stride - 1e-9)))
    return np.arange((count - 1) % stride // 2, count, stride)


def cells_of(fields, semi_axes=None):
    """The cells of a solution's fields, arrays (rows, cells of a row) in SI; `semi_axes` [m] of an ellipse, else the pressures
    tell where the contact ends. For other pictures: draw, draw_areas, draw_boundary, draw_outline, sample."""
    names = ("x", "y", "area", "bound", "px", "py", "sx", "sy")
    x, y, area, bound, px, py, sx, sy = (np.asarray(getattr(fields, name), dtype=float) for name in names)
    axes = None if semi_axes is None else [1e3 * axis for axis in semi_axes]
    pressure = 1e-6 * np.asarray(fields.pressure) if semi_axes is None else None
    return ContactCells(1e3 * x, 1e3 * y, area, 1e-6 * bound, 1e-6 * px, 1e-6 * py, 1e3 * sx, 1e3 * sy,
                        np.asarray(fields.state).astype(int), axes, pressure)


def read_cells(result, theory):
    """The cells of one theory's fields in a result file. Their outline is Hertz's ellipse where his theory holds."""
    folder = f"/{theory}/fields"
    names = [f"{folder}/{name}" for name in ("x", "y", "area", "bound", "px", "py", "sx", "sy", "state")]
    strides = [math.ceil(count / MOST_CELLS) for count in result.shape(names[0])]
    x, y, area, bound, px, py, sx, sy, state = result.arrays(names, dimensions=2, strides=strides)
    semi_axes = pressure = size = None
    if theory == "exact" and result.assumption("hertz"):
        pressure = 1e-6 * result.array(f"{folder}/pressure", dimensions=2, strides=strides)
    else:
        semi_axes = (1e3 * result.number("/hertz/a"), 1e3 * result.number("/hertz/b"))
    if is_line_contact(result, theory):
        width = result.array(f"{folder}/width", dimensions=2).max()
        size = (1e3 * strides[1] * width, 1e3 * area.max() / width)
    return ContactCells(1e3 * x, 1e3 * y, area, 1e-6 * bound, 1e-6 * px, 1e-6 * py, 1e3 * sx, 1e3 * sy, state, semi_axes, pressure,
                        size)


def is_line_contact(result, theory):
    """Whether a theory's elements are strips across rollers."""
    return theory == "exact" and "hertz/b" not in result
