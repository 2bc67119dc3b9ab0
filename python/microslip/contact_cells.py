"""The grid of a contact area to draw: elements in adhesion or slip within the outline of the contact."""

import math

import numpy as np
from matplotlib.colors import Normalize, to_rgba
from matplotlib.patches import PathPatch

from microslip.contact_outline import Outline, ellipse, outline_of_rows, strip
from microslip.picture_style import INK, SLIDING, SOFT_SLIDES, SOFT_STICKS, STICKING

EXTERIOR, ADHESION, SLIP = 0, 1, 2
# Finer grids are sampled: a picture has no pixels to show more.
MOST_CELLS = 400
# Along the longer side of an image.
PIXELS = 600
# Arrows along the contact's longer axis.
MOST_ARROWS = 16
# The longest arrow in parts of the axes' width, where x and y have different scales.
LONGEST_IN_WIDTH = 0.055
# Shorter ones, in parts of the longest, are left out.
LEAST_ARROW = 0.02
# Areas that are smaller, in parts of the contact, have no word in them.
LEAST_NAMED = 0.08
# Contacts slimmer than this are drawn with different scales along x and y.
SLIMMEST_TRUE_TO_SCALE = 1 / 8
# Rings and rays of the mesh of a surface.
RINGS, RAYS = 36, 145
# Elements so near to the edge do not tell the smooth factor of fields that vanish there.
NEAR_EDGE = 0.97
# A part of a contact more of whose elements lie beyond its star's edge is no star about its middle.
MOST_BEYOND = 0.03
# By which the border between adhesion and slip is smoothed, in elements.
SMOOTHED = 0.7
# Limits of the field whose zero is the border between adhesion and slip.
LEAST_STICKINESS, MOST_STICKINESS = 0.05, 4.0


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

    def images(self, values, vanishes):
        """Values between the cells as images of the contact's parts: x and y of pixels, values, and the part's outline.

        They are those of `surface`: linear between cells, of fields that vanish at the edge beside the root of the distance.
        """
        for outline in [self.outline] if self.is_regular else [Outline([part]) for part in self.outline.parts]:
            left, right, low, high = outline.limits()
            x, y = np.linspace(left, right, PIXELS), np.linspace(low, high, PIXELS)
            yield x, y, self.at(values, *np.meshgrid(x, y), vanishes, outline), outline

    def at(self, values, x, y, vanishes, outline=None):
        """Values at points of the contact, or of a part of it that an outline tells; of a single row they hold across it."""
        outline = outline or self.outline
        if not self.inside.any():  # nothing touches, or there is no friction
            return np.zeros(np.shape(x))
        if self.is_regular or len(outline.parts) != 1:
            return self._interpolated(values, self.inside, x, y)
        mesh = StarMesh(outline.parts[0])
        place = mesh.place(self.x, self.y)
        here = self.inside & outline.contain(self.x, self.y)
        if not vanishes or (here & (place > 1)).sum() > MOST_BEYOND * here.sum():
            return self._interpolated(values, here if here.any() else self.inside, x, y)
        smooth = self._smooth_factor(values, place, x, y)
        return smooth * np.sqrt(np.clip(1 - mesh.place(x, y) ** 2, 0, None))

    def draw(self, axes, values, turned=False, vanishes=True, of_slip=False, **how):
        """Values between the cells as colours up to the outline; turned: x upwards, y to the right. `of_slip`: they are zero where
        it sticks, and may jump at the border."""
        if not self.inside.any():
            return
        if of_slip and self.has_boundary():
            images = self._images_of_slip(values)
        else:
            images = self.images(values, vanishes)
        for x, y, image, outline in images:
            self._show(axes, x, y, image, outline, turned, **how)

    def _images_of_slip(self, values):
        for x, y, sticks, outline in self.borders():
            slides = self.inside & (self.state == SLIP) & outline.contain(self.x, self.y)
            image = self._interpolated(values, slides, *np.meshgrid(x, y)) if slides.any() else np.zeros(sticks.shape)
            yield x, y, np.where(sticks > 0, 0.0, image), outline

    def _show(self, axes, x, y, image, outline, turned, **how):
        extent = (x[0], x[-1], y[0], y[-1])
        if turned:
            image, extent = np.swapaxes(image, 0, 1), (*extent[2:], *extent[:2])
        drawn = axes.imshow(image, extent=extent, origin="lower", interpolation="bilinear", aspect=axes.get_aspect(), **how)
        drawn.set_clip_path(outline.turned() if turned else outline.path, axes.transData)

    def draw_outline(self, axes, turned=False, **how):
        """The outline as a line, or with a facecolor as an area."""
        how = {"fill": "facecolor" in how, "edgecolor": INK, "linewidth": 1.2, "zorder": 3, **how}
        axes.add_patch(PathPatch(self.path(turned), **how))

    def draw_areas(self, axes, turned=False, sizes=None, largest=1.0):
        """Where it sticks blue, where it slides orange: both soft, or with sizes of a field from 0 to the largest darker ones."""
        if not self.inside.any():
            return
        norm = Normalize(0, largest or 1)
        for (x, y, sticks, outline), (_, _, size, _) in zip(self.borders(), self.images(
                np.zeros(self.x.shape) if sizes is None else sizes, sizes is not None)):
            blue, orange = ((np.array(to_rgba(colour)) for colour in (SOFT_STICKS, SOFT_SLIDES)) if sizes is None
                            else (colours(norm(size)) for colours in (STICKING, SLIDING)))
            self._show(axes, x, y, np.where(sticks[..., None] > 0, blue, orange), outline, turned, zorder=1.5)

    def stickiness(self):
        """A field that is positive in adhesion and negative in slip, and about linear across the border: what is left of the bound
        in adhesion, the slip in slip, both in parts of what they are on either side of the border."""
        rest = np.where(self.state == ADHESION, self.bound - np.hypot(self.px, self.py), 0.0)
        slip = np.where(self.state == SLIP, np.hypot(self.sx, self.sy), 0.0)
        borders = self.state[:, 1:] + self.state[:, :-1] == ADHESION + SLIP
        here = np.zeros(self.state.shape, dtype=bool)
        here[:, 1:] |= borders & self.inside[:, 1:] & self.inside[:, :-1]
        here[:, :-1] |= borders & self.inside[:, 1:] & self.inside[:, :-1]
        scaled = []
        for size, state in ((rest, ADHESION), (slip, SLIP)):
            unit = np.median(size[here & (self.state == state)]) if (here & (self.state == state)).any() else size.max(initial=0)
            scaled.append(np.clip(size / (unit or 1.0), LEAST_STICKINESS, MOST_STICKINESS))
        return np.where(self.state == ADHESION, scaled[0], -scaled[1])

    def borders(self):
        """Images of stickiness, as of `images`, without the steps of a part of an element that rows make in its zero line."""
        for x, y, sticks, outline in self.images(self.stickiness(), False):
            across, along = (SMOOTHED * size / (line[1] - line[0] or 1.0)
                             for size, line in ((self.height, y), (float(np.median(self.apart)), x)))
            yield x, y, blurred(blurred(sticks, across).T, along).T, outline

    def draw_boundary(self, axes, turned=False):
        """The line between adhesion and slip, with a white rim."""
        if not self.has_boundary():
            return
        for x, y, sticks, outline in self.borders():
            if not sticks.min() < 0 < sticks.max():
                continue  # a part that all sticks or all slides
            coordinates = (y, x, sticks.T) if turned else (x, y, sticks)
            for colour, width in (("white", 3.6), (INK, 1.9)):
                lines = axes.contour(*coordinates, levels=[0.0], colors=colour, linewidths=width, zorder=2.5)
                for line in lines.collections:
                    line.set_clip_path(outline.turned() if turned else outline.path, axes.transData)

    def middles_of(self, state):
        """Points x, y in adhesion or slip that are farthest from the area's edge, where a word stands: one in each part of the
        contact, none in small areas."""
        for part in self.outline.parts:
            outline = Outline([part])
            left, right, low, high = outline.limits()
            x, y = (points.ravel() for points in np.meshgrid(np.linspace(left, right, 41), np.linspace(low, high, 41)))
            inside = outline.contain(x, y)
            there = inside & ((self.at(self.stickiness(), x, y, False, outline) > 0) == (state == ADHESION))
            if there.sum() * (right - left) * (high - low) > LEAST_NAMED * inside.sum() * 4 * self.a * self.b:
                # Words are broader than high: distances along x count for less.
                away = np.min(((x[there, None] - x[~there]) / (2 * self.a)) ** 2 + ((y[there, None] - y[~there]) / self.b) ** 2, axis=1)
                best = np.argmax(away)
                yield x[there][best], y[there][best]

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
        if not vanishes:
            return mesh.x, mesh.y, self._interpolated(values, self._within(place, 1.0), mesh.x, mesh.y)
        return mesh.x, mesh.y, self._smooth_factor(values, place, mesh.x, mesh.y) * mesh.edge_factor()

    def _within(self, place, ring):
        """The cells within a ring; a splinter may have no centre of a cell, and has those next to it."""
        mine = self.inside & (place < ring)
        return mine if mine.any() else self.inside & (place <= max(1.5, place[self.inside].min()))

    def _smooth_factor(self, values, place, x, y):
        """What is left of values that vanish at the edge when the root of the distance is divided out."""
        factor = np.sqrt(np.clip(1 - place**2, 1 - NEAR_EDGE**2, None))
        return self._interpolated(values / factor, self._within(place, NEAR_EDGE), x, y)

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

    def lattice(self, apart=None):
        """Points within the outline, evenly spread about its middle: `apart` [mm], or far enough to be read, but at least 5 along
        each axis; arrays of x and y."""
        along = 5 if self.true_to_scale() else MOST_ARROWS
        left, right, low, high = self.outline.limits()
        lines = []
        for first, last, axis in ((left, right, self.a), (low, high, self.b)):
            stride = apart or min(self.arrows_apart(), 2 * axis / along)
            each_side = math.ceil(axis / stride) - 1
            lines.append((first + last) / 2 + stride * np.arange(-each_side, each_side + 1))
        x, y = (values.ravel() for values in np.meshgrid(*lines))
        inside = self.outline.contain(x, y)
        return x[inside], y[inside]

    def arrows(self, along, across, longest, apart=None, only=None):
        """Arrows of a field's components that lie within the outline: arrays x, y of their middles, and the components there.

        `longest` of the field is drawn as long as `arrow_length(apart)`, arrows stand as in `lattice`. `only` SLIP leaves out
        the points that stick.
        """
        x, y = self.lattice(apart)
        found = [self.at(values, x, y, only != SLIP) for values in (along, across)]
        keep = np.hypot(*found) > LEAST_ARROW * longest
        if only == SLIP and self.has_boundary():
            keep &= self.at(self.stickiness(), x, y, False) < 0
        if longest > 0:
            lengths = [self.arrow_length(apart)] * 2 if self.true_to_scale() else [2.3 * LONGEST_IN_WIDTH * axis for axis in (self.a, self.b)]
            for side in (-0.5, 0.5):
                ends = [at + side * length / longest * size for at, length, size in zip((x, y), lengths, found)]
                keep &= self.outline.contain(*ends)
        return x[keep], y[keep], found[0][keep], found[1][keep]

    def arrows_apart(self):
        """The distance of arrows that suits the contact's size [mm]."""
        return 2 * max(self.a, self.b) / MOST_ARROWS

    def arrow_length(self, apart=None):
        """A length for the longest arrow [mm] that suits the arrows' distance."""
        return 1.35 * (apart or self.arrows_apart())


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


def blurred(image, width):
    """Columns of an image under a bell curve of a standard deviation in pixels, which goes on beyond its ends as there."""
    reach = int(3 * width)
    if reach < 1:
        return image
    bell = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2)
    longer = np.pad(image, ((reach, reach), (0, 0)), mode="edge")
    return sum(weight * longer[start:start + len(image)] for start, weight in enumerate(bell / bell.sum()))


def cells_of(fields, semi_axes=None):
    """The cells of a solution's fields, arrays (rows, cells of a row) in SI; `semi_axes` [m] of an ellipse, else the pressures
    tell where the contact ends. For other pictures: draw, draw_areas, draw_boundary, draw_outline, arrows."""
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
