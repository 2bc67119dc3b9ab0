"""The outline of a contact area: Hertz's ellipse, or where the pressure of rows of elements falls to zero.

Between elements p_n^2 is linear in the distance to the edge to first order, as under Hertz's half-ellipsoid, so that two
elements of a row tell where its contact ends. Between rows with contact from l to r the level (x - l)(r - x), of an ellipse
a quadratic function of y, is interpolated; its zeros are the outline. All lengths in mm.
"""

import contourpy
import numpy as np
from matplotlib.path import Path

# Shares of an element's length by which the contact ends beyond the last centre, at least and at most.
LEAST_REACH, MOST_REACH = 0.02, 1.1
# So many elements at the end of a row tell where it ends; the weight of the outermost one.
FITTED, OUTERMOST = 5, 0.3
ROW_POINTS, POINTS_OF_ROW = 361, 8


class Outline:
    """Closed curves, one around each part of the contact: arrays (n, 2) whose first and last points are the same."""

    def __init__(self, parts):
        self.parts = parts
        codes = [[Path.MOVETO] + [Path.LINETO] * (len(part) - 2) + [Path.CLOSEPOLY] for part in parts]
        self.path = Path(np.concatenate(parts), np.concatenate(codes)) if parts else Path(np.zeros((0, 2)))

    def limits(self):
        """Least and largest x, least and largest y."""
        points = np.concatenate(self.parts) if self.parts else np.zeros((1, 2))
        return (*np.sort(points[:, 0])[[0, -1]], *np.sort(points[:, 1])[[0, -1]])

    def contain(self, x, y):
        """Selects the points that lie inside."""
        points = np.column_stack([np.ravel(x), np.ravel(y)])
        around = np.zeros(len(points), dtype=int)
        for part in self.parts:
            around += Path(part).contains_points(points)
        return (around % 2 == 1).reshape(np.shape(x))

    def turned(self):
        """The path with x and y exchanged."""
        return Path(self.path.vertices[:, ::-1], self.path.codes)


def ellipse(a, b):
    """The outline of an ellipse about the origin."""
    angle = np.linspace(0, 2 * np.pi, 361)
    return Outline([np.column_stack([a * np.cos(angle), b * np.sin(angle)])])


def strip(x, width, y, height):
    """The outline of the elements of a single row: their x and width, the row's y and height."""
    if not len(x):
        return Outline([])
    left, right, low, high = x.min() - width / 2, x.max() + width / 2, y - height / 2, y + height / 2
    return Outline([np.array([(left, low), (right, low), (right, high), (left, high), (left, low)])])


def outline_of_rows(x, row_y, height, widths, pressure, inside):
    """The outline of contact on rows of elements: arrays (rows, elements), rows a height apart."""
    rows = [row_intervals(*row) for row in zip(x, widths, pressure, inside)]
    curves = []
    for one in connected(rows):
        curves += curves_of(one, row_y, height)
    return Outline(curves)


def row_intervals(x, widths, pressure, inside):
    """Intervals of unbroken runs of elements of a row in contact: pairs of ends."""
    cells = np.flatnonzero(inside)
    if x[0] > x[-1]:
        cells = cells[::-1]
    runs = np.split(cells, np.flatnonzero(np.abs(np.diff(cells)) > 1) + 1) if cells.size else []
    ends = []
    for run in runs:
        squares = pressure[run] ** 2
        left = x[run[0]] - reach(x[run], squares, widths[run[0]])
        right = x[run[-1]] + reach(x[run[::-1]], squares[::-1], widths[run[-1]])
        ends.append((left, right))
    return ends


def reach(x, squares, width):
    """Distance of the edge of contact beyond the first of these elements: the zero of a parabola through p_n^2 of the first ones, where
    the outermost one, of which the edge may cut off a part, counts for little."""
    if len(x) == 1 or squares[1] <= squares[0]:
        return width / 2
    apart = abs(x[1] - x[0])
    beyond = squares[0] / (squares[1] - squares[0]) * apart
    if len(x) >= FITTED:
        inwards = -np.abs(x[:FITTED] - x[0])
        fit = np.polyfit(inwards, squares[:FITTED] / squares[FITTED - 1], 2, w=[OUTERMOST] + [1.0] * (FITTED - 1))
        zeros = np.roots(fit)
        zeros = zeros[np.isreal(zeros)].real
        beyond = min(zeros[zeros > -0.5 * apart], default=beyond)
    return np.clip(beyond, LEAST_REACH * apart, MOST_REACH * apart)


def connected(rows):
    """Parts of the contact: for each the intervals of every row that belong to it. Intervals of neighbouring rows that
    overlap belong to one part."""
    part_of, members = {}, {}
    for number, intervals in enumerate(rows):
        for mine in intervals:
            node = (number, mine)
            part_of[node], members[node] = node, [node]
            below = rows[number - 1] if number else ()
            for other in [(number - 1, one) for one in below if one[0] < mine[1] and one[1] > mine[0]]:
                here, there = part_of[node], part_of[other]
                if here != there:
                    for moved in members.pop(there):
                        part_of[moved] = here
                        members[here].append(moved)
    return [[[one for place, one in part if place == number] for number in range(len(rows))] for part in members.values()]


def curves_of(rows, row_y, height):
    """The closed curves around a part, given by its intervals in each row."""
    ends = np.array([end for row in rows for end in row])
    left, right = ends.min(), ends.max()
    margin = 0.05 * (right - left)
    x = np.linspace(left - margin, right + margin, ROW_POINTS)
    used = [number for number, row in enumerate(rows) if row]
    first, last = used[0], used[-1]
    ascending = 1 if len(row_y) < 2 or row_y[1] > row_y[0] else -1
    levels = padded([row_level(rows[number], x) for number in range(first, last + 1)])
    fine = np.arange((len(levels) - 3) * POINTS_OF_ROW + 1) / POINTS_OF_ROW  # from the second row to the one before the last
    y = row_y[first] + ascending * height * (fine - 1)
    level = between_rows(levels, fine)
    order = slice(None) if ascending > 0 else slice(None, None, -1)
    lines = contourpy.contour_generator(x, y[order], level[order]).lines(0.0)
    return [line for line in lines if len(line) > 3 and np.allclose(line[0], line[-1])]


def row_level(intervals, x):
    """(x - l)(r - x) of the interval with the largest; of a row without contact nothing."""
    return np.max([(x - left) * (right - x) for left, right in intervals], axis=0) if intervals else None


def padded(levels):
    """Levels of all rows and of two more at either end, extrapolated so that contact ends before the next row."""
    filled = list(levels)
    for number, level in enumerate(filled):
        if level is None:  # contact on either side: none here
            filled[number] = -np.abs(filled[number - 1])
    return np.array([*beyond(filled[::-1])[::-1], *smoothed(filled), *beyond(filled)])


def smoothed(levels):
    """Levels without the scatter from row to row; cubics across rows remain unchanged."""
    result = list(levels)
    for number in range(2, len(levels) - 2):
        before, around, after = levels[number - 2], levels[number - 1:number + 2], levels[number + 2]
        result[number] = (10 * around[1] + 4 * (around[0] + around[2]) - before - after) / 16
    return result


def beyond(levels):
    """Two more rows behind the last one."""
    last, here = levels[-1], list(levels[-3:])
    for _ in range(2):
        if len(here) == 1:
            more = here[-1] - 4 * last.max()
        elif len(here) == 2:
            more = 2 * here[-1] - here[-2]
        else:
            more = 3 * here[-1] - 3 * here[-2] + here[-3]
        here.append(more - max(0, more.max() + 0.02 * last.max()))
    return here[-2:]


def between_rows(levels, at):
    """Cubic interpolation, exact for quadratic functions, at row numbers that begin with the second row."""
    index = np.minimum(at.astype(int), len(levels) - 4)
    t = (at - index)[:, None]
    before, here, there, after = (levels[index + k] for k in range(4))
    curved = 2 * before - 5 * here + 4 * there - after
    return here + t / 2 * (there - before + t * (curved + t * (3 * (here - there) + after - before)))
