"""The grid of a contact area as cells to draw: rows with a spacing of their own, cells in adhesion or slip."""

import math

import numpy as np

EXTERIOR, ADHESION, SLIP = 0, 1, 2
# Finer grids are sampled: a picture has no pixels to show more.
MOST_CELLS = 400
# Arrows along the contact's longer axis.
MOST_ARROWS = 20
# Ellipses slimmer than this are drawn with different scales along x and y.
SLIMMEST_TRUE_TO_SCALE = 1 / 8


class ContactCells:
    """Fields on a grid. Lengths in mm, tractions in MPa, relative slip in 1e-3; arrays (rows, cells of a row)."""

    def __init__(self, x, y, area, bound, px, py, sx, sy, state, semi_axes):
        self.x, self.y, self.bound, self.px, self.py = x, y, bound, px, py
        self.sx, self.sy, self.state = sx, sy, state
        self.a, self.b = semi_axes
        self.row_y = y[:, 0]
        rows, columns = x.shape
        self.height = abs(self.row_y[-1] - self.row_y[0]) / (rows - 1) if rows > 1 else 2 * self.b
        if columns > 1:
            self.apart = np.abs(x[:, 0] - x[:, -1]) / (columns - 1)
        else:
            self.apart = 2 * self.a * np.sqrt(np.clip(1 - (self.row_y / self.b) ** 2, 0, None))
        # Cells of a row are as long as they are apart, but for one that is fitted to the leading edge: its area tells.
        self.widths = self.apart[:, None] * area / np.median(area, axis=1, keepdims=True)
        # Towards the trailing edge x ascends or descends.
        self.backward = -1 if columns > 1 and x[0, 0] > x[0, -1] else 1

    def _rectangle(self, row, first, last):
        """Corners of the cells from one to another in a row."""
        ends = [self.x[row, i] + side * self.widths[row, i] / 2 for i in (first, last) for side in (-1, 1)]
        left, right = min(ends), max(ends)
        low, high = self.row_y[row] - self.height / 2, self.row_y[row] + self.height / 2
        return [(left, low), (right, low), (right, high), (left, high)]

    def rectangles(self):
        """Corners of every cell in the contact area, and which cells they are: arrays (n, 4, 2), (n, 2)."""
        cells = np.argwhere(self.state != EXTERIOR)
        corners = [self._rectangle(row, i, i) for row, i in cells]
        return np.array(corners).reshape(-1, 4, 2), cells

    def _runs(self, row, state):
        """First and last index of each unbroken run of cells in a state."""
        inside = np.concatenate(([False], self.state[row] == state, [False])).astype(np.int8)
        steps = np.diff(inside)
        return zip(np.flatnonzero(steps == 1), np.flatnonzero(steps == -1) - 1)

    def strips(self, state, row=None):
        """Corners of the cells in a state, of one row or all, neighbours in a row joined: array (n, 4, 2)."""
        rows = range(len(self.row_y)) if row is None else [row]
        corners = [self._rectangle(one, first, last) for one in rows for first, last in self._runs(one, state)]
        return np.array(corners).reshape(-1, 4, 2)

    def _crossings(self, row):
        """Edges within a row between adhesion and slip."""
        here, there = self.state[row, :-1], self.state[row, 1:]
        for i in np.flatnonzero((here != there) & (here != EXTERIOR) & (there != EXTERIOR)):
            edge = self.x[row, i] + self.backward * self.widths[row, i] / 2
            yield [(edge, self.row_y[row] - self.height / 2), (edge, self.row_y[row] + self.height / 2)]

    def _steps(self, row):
        """Edges between a row and the next where adhesion meets slip."""
        level = self.row_y[row] + self.height / 2
        for below, above in ((ADHESION, SLIP), (SLIP, ADHESION)):
            for first, last in self._runs(row, below):
                lower = self._rectangle(row, first, last)
                for other_first, other_last in self._runs(row + 1, above):
                    upper = self._rectangle(row + 1, other_first, other_last)
                    left, right = max(lower[0][0], upper[0][0]), min(lower[1][0], upper[1][0])
                    if left < right:
                        yield [(left, level), (right, level)]

    def boundary(self):
        """Line segments along cell edges that separate adhesion from slip."""
        rows = len(self.row_y)
        segments = [segment for row in range(rows) for segment in self._crossings(row)]
        return segments + [segment for row in range(rows - 1) for segment in self._steps(row)]

    def true_to_scale(self):
        """Whether one scale along x and y shows the ellipse well."""
        return SLIMMEST_TRUE_TO_SCALE <= self.a / self.b <= 1 / SLIMMEST_TRUE_TO_SCALE

    def sample(self):
        """A mask of cells for arrows: far enough apart to be read, but at least 5 along each axis."""
        along = 5 if self.true_to_scale() else MOST_ARROWS
        apart_x, apart_y = (min(self._arrows_apart(), 2 * axis / along) for axis in (self.a, self.b))
        chosen = np.zeros(self.state.shape, dtype=bool)
        for row in every(len(self.row_y), apart_y / self.height):
            chosen[row, every(self.state.shape[1], apart_x / self.apart[row])] = True
        return chosen & (self.state != EXTERIOR)

    def _arrows_apart(self):
        return 2 * max(self.a, self.b) / MOST_ARROWS

    def arrow_length(self):
        """A length for the longest arrow [mm] that suits the arrows' distance."""
        spacing = max(self._arrows_apart(), min(self.apart.max(), self.height))
        return min(1.35 * spacing, 0.15 * 2 * max(self.a, self.b))


def every(count, stride):
    """Indices of evenly spaced entries, the remainder shared between both ends; the stride is rounded up."""
    stride = min(count, max(1, math.ceil(stride - 1e-9)))
    return np.arange((count - 1) % stride // 2, count, stride)


def read_cells(result, theory):
    """The cells of one theory's fields in a result file."""
    folder = f"/{theory}/fields"
    names = [f"{folder}/{name}" for name in ("x", "y", "area", "bound", "px", "py", "sx", "sy", "state")]
    strides = [math.ceil(count / MOST_CELLS) for count in result.shape(names[0])]
    x, y, area, bound, px, py, sx, sy, state = result.arrays(names, dimensions=2, strides=strides)
    semi_axes = (1e3 * result.number("/hertz/a"), 1e3 * result.number("/hertz/b"))
    return ContactCells(1e3 * x, 1e3 * y, area, 1e-6 * bound, 1e-6 * px, 1e-6 * py, 1e3 * sx, 1e3 * sy, state, semi_axes)
