"""Draws docs/images/wheelset_axes.svg: python3 docs/drawings/wheelset_axes.py [FILE]."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import numpy as np
from axes_and_signs import BLACK, MOTION, QUIET, RAIL, WHEEL, arrow, bare, label, turn
from matplotlib import pyplot
from matplotlib.patches import Circle, Polygon, Rectangle

PROFILES = Path(__file__).parent.parent.parent / "examples" / "profiles"
ORIGIN, AXLE = 105, 135  # where the profiles' origins and the axle are drawn; a true track is wider and a wheel larger


def profile(name):
    """y to the field side and z up [mm] of a Simpack file with z down."""
    rows = [line.split() for line in (PROFILES / name).read_text().splitlines()]
    points = []
    for row in rows:
        try:
            points.append([float(number) for number in row])
        except ValueError:
            continue
    points = np.array([point for point in points if len(point) == 2])
    return points[points[:, 0].argsort(kind="stable")] * (1, -1) if name.endswith("prw") else points * (1, -1)


def dimension(axes, start, end, y, text, below=False):
    """A horizontal measure with arrows at both ends."""
    middle = (start + end) / 2
    arrow(axes, (middle, y), (start, y), QUIET, 1.2, size=10)
    arrow(axes, (middle, y), (end, y), QUIET, 1.2, size=10)
    label(axes, middle, y + (-6 if below else 6), text, QUIET, fontsize=10)


def from_behind(axes):
    """Both wheels on both rails, seen along x."""
    bare(axes, (-205, 205), (-72, 172))
    axes.set_title("Seen from behind, along $+x$ (not to scale)", fontsize=12)
    wheel, rail = profile("s1002.prw"), profile("60e1.prr")
    for side in (-1, 1):  # left is negative in the picture
        x = side * (ORIGIN + wheel[:, 0])
        outline = np.vstack([np.column_stack([x, wheel[:, 1]]), [[x[-1], AXLE + 16], [x[0], AXLE + 16]]])
        axes.add_patch(Polygon(outline, facecolor=WHEEL, edgecolor=BLACK, linewidth=1.2))
        axes.add_patch(Polygon(np.column_stack([side * (ORIGIN + rail[:, 0]), rail[:, 1] - 0.3]), facecolor=RAIL,
                               edgecolor=BLACK, linewidth=1.2))
    axes.add_patch(Rectangle((-185, AXLE - 4), 370, 8, facecolor=WHEEL, edgecolor=BLACK, linewidth=1))
    for side, name in ((-1, "left"), (1, "right")):
        label(axes, side * 140, 60, name, fontweight="bold")
    back, gauge = ORIGIN - 70, ORIGIN - 36
    dimension(axes, -back, back, 62, "flange back distance")
    for side in (-1, 1):
        axes.plot([side * gauge, side * gauge], [-46, -14], color=QUIET, linewidth=0.8, linestyle="--")
        axes.plot([side * gauge], [-14], "o", color=QUIET, markersize=4)
    dimension(axes, -gauge, gauge, -46, "gauge, 14 mm below the tops", below=True)
    axes.plot([ORIGIN + 66, 200], [AXLE, AXLE], color=QUIET, linewidth=0.8, linestyle="--")
    axes.plot([ORIGIN + 60, 200], [0, 0], color=QUIET, linewidth=0.8, linestyle="--")
    arrow(axes, (193, 67), (193, AXLE), QUIET, 1.2, size=10)
    arrow(axes, (193, 67), (193, 0), QUIET, 1.2, size=10)
    label(axes, 188, 85, "nominal radius", QUIET, fontsize=10, rotation=90)
    arrow(axes, (0, 0), (-34, 0), BLACK, 1.6)
    arrow(axes, (0, 0), (0, 38), BLACK, 1.6)
    axes.add_patch(Circle((0, 0), 4.5, facecolor="white", edgecolor=BLACK, linewidth=1.4, zorder=6))
    axes.plot([-3, 3], [-3, 3], [-3, 3], [3, -3], color=BLACK, linewidth=1.4, zorder=7)
    for x, z, name in ((-38, 5, "$y$"), (6, 40, "$z$"), (9, -8, "$x$")):
        label(axes, x, z, name, fontsize=13)
    turn(axes, (0, AXLE), 24, 235, 130, MOTION)
    label(axes, -40, AXLE + 23, "roll > 0", MOTION)
    label(axes, 108, -61, "profile: origin, $y$ to the field, $z$ up", fontsize=10)
    axes.plot([-ORIGIN], [0], "o", color=BLACK, markersize=4, zorder=8)
    label(axes, -130, -61, r"$\delta>0$ rises to the left", fontsize=10)


def from_above(axes):
    """Yaw, velocity, curve."""
    bare(axes, (-7, 7), (-7.6, 7.6))
    axes.set_title("Seen from above", fontsize=12)
    for x in (-3, 3):
        axes.add_patch(Rectangle((x - 0.25, -7), 0.5, 13.5, facecolor=RAIL, edgecolor=BLACK, linewidth=0.8))
    angle = np.radians(9)
    ahead, left = np.array([-np.sin(angle), np.cos(angle)]), np.array([-np.cos(angle), -np.sin(angle)])
    for side in (-1, 1):
        corners = [3 * side * left + 0.3 * u * left + 1.9 * v * ahead for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
        axes.add_patch(Polygon(corners, facecolor=WHEEL, edgecolor=BLACK, linewidth=1.2))
    axes.plot(*np.transpose([-3.4 * left, 3.4 * left]), color=BLACK, linewidth=3)
    arrow(axes, (0, 0), (0, 4.6), BLACK, 1.6)
    arrow(axes, (0, 0), (-1.9, 0), BLACK, 1.6)
    label(axes, 0.5, 4.5, "$x$", fontsize=13)
    label(axes, -2.1, 0.55, "$y$", fontsize=13)
    turn(axes, (0, 0), 3.4, 78, 108, MOTION)
    label(axes, 1.5, 2.6, "yaw > 0", MOTION)
    arrow(axes, (0, -5.6), (0, -2.4), MOTION, 2.4)
    label(axes, 0, -6.2, "forward velocity", MOTION)
    arrow(axes, (5.6, -3), (4.7, 5), QUIET, 2, curve=0.15)
    label(axes, 5.5, 6.1, "curvature > 0", QUIET)


def contact(axes):
    """The axes of CONTACT."""
    bare(axes, (-6, 6), (-6.5, 6.5))
    axes.set_title("CONTACT, module 1, from behind", fontsize=12)
    arrow(axes, (0, 3), (3.4, 3), BLACK, 1.6)
    arrow(axes, (0, 3), (0, -0.6), BLACK, 1.6)
    axes.add_patch(Circle((0, 3), 0.35, facecolor="white", edgecolor=BLACK, linewidth=1.4, zorder=6))
    axes.plot([-0.23, 0.23], [2.77, 3.23], [-0.23, 0.23], [3.23, 2.77], color=BLACK, linewidth=1.4, zorder=7)
    for x, y, name in ((3.8, 3, "$y$"), (0.5, -0.6, "$z$"), (-0.7, 3.5, "$x$")):
        label(axes, x, y, name, fontsize=13)
    label(axes, 0, -2.4, r"x, roll, $\delta$: the same sign")
    label(axes, 0, -3.6, "y, z, yaw, pitch, curvature: the opposite")
    label(axes, 0, -4.8, "right side: solved as it is; left side mirrored")


def main():
    """Writes the drawing; the same bytes each time."""
    target = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent / "images" / "wheelset_axes.svg"
    matplotlib.rcParams.update({"font.size": 11, "svg.hashsalt": "wheelset_axes", "mathtext.fontset": "dejavusans"})
    figure = pyplot.figure(figsize=(12, 10.5), layout="constrained")
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.35, 1))
    from_behind(upper.subplots())
    left, right = lower.subplots(1, 2)
    from_above(left)
    contact(right)
    figure.savefig(target, metadata={"Date": None} if str(target).endswith("svg") else None)


if __name__ == "__main__":
    main()
