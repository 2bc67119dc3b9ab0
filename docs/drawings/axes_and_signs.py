"""Draws docs/images/axes_and_signs.svg: python3 docs/drawings/axes_and_signs.py [FILE]."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

import numpy as np
from matplotlib import pyplot
from matplotlib.patches import Circle, Ellipse, FancyArrowPatch, Polygon, Rectangle

MOTION, FORCE, QUIET, BLACK = "#0072B2", "#D55E00", "#767676", "#000000"
WHEEL, RAIL, CONTACT = "#E8EEF4", "#EFE9DF", "#F4F4F4"
CENTRE, RADIUS = 4.0, 4.22
EDGE = (RADIUS**2 - CENTRE**2) ** 0.5


def arrow(axes, tail, head, colour, width=2.0, curve=0.0, size=14):
    """An arrow from tail to head; `curve` bends it to the right of its way."""
    axes.add_patch(FancyArrowPatch(tail, head, arrowstyle="-|>", mutation_scale=size, linewidth=width, color=colour,
                                   shrinkA=0, shrinkB=0, connectionstyle=f"arc3,rad={curve}", zorder=5))


def turn(axes, centre, radius, start, end, colour, width=2.0):
    """An arrow along a circle between two angles in degrees."""
    angles = np.radians(np.linspace(start, end - 12 * np.sign(end - start), 60))
    axes.plot(centre[0] + radius * np.cos(angles), centre[1] + radius * np.sin(angles), color=colour, linewidth=width,
              solid_capstyle="butt", zorder=5)
    points = [(centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle))
              for angle in (angles[-1], np.radians(end))]
    arrow(axes, *points, colour, width)


def label(axes, x, y, text, colour=BLACK, **how):
    """Text, centred unless told."""
    axes.text(x, y, text, color=colour, **{"ha": "center", "va": "center", "zorder": 6, **how})


def bare(axes, xlim, ylim):
    """Axes without a frame, with one scale."""
    axes.set_xlim(*xlim)
    axes.set_ylim(*ylim)
    axes.set_aspect("equal")
    axes.axis("off")


def bodies(axes):
    """Wheel, flattened on the rail."""
    angles = np.linspace(0, 2 * np.pi, 721)
    outline = np.column_stack([RADIUS * np.cos(angles), np.maximum(CENTRE + RADIUS * np.sin(angles), 0)])
    axes.add_patch(Polygon(outline, facecolor=WHEEL, edgecolor=BLACK, linewidth=1.4))
    axes.add_patch(Rectangle((-7.2, -2.3), 14.4, 2.3, facecolor=RAIL, edgecolor="none"))
    axes.plot([-7.2, 7.2], [0, 0], color=BLACK, linewidth=1.4)
    axes.plot([-EDGE, EDGE], [0, 0], color=BLACK, linewidth=4, solid_capstyle="butt")
    label(axes, -1.9, 5.6, "body 1: wheel", fontweight="bold")
    label(axes, -5.6, -1.9, "body 2: rail", fontweight="bold")


def side_view(axes):
    """Wheel over rail, seen from its right side."""
    bare(axes, (-7.4, 7.4), (-2.4, 9.6))
    bodies(axes)
    axes.set_title("Side view, a braked wheel ($\\xi>0$)", fontsize=12)
    axes.plot([0], [CENTRE], "o", color=BLACK, markersize=5)
    arrow(axes, (0, CENTRE), (2.4, CENTRE), MOTION, 2.4)
    label(axes, 2.75, CENTRE, "$v$", MOTION, fontsize=13)
    turn(axes, (0, CENTRE), 1.0, 150, 35, MOTION)
    label(axes, -0.35, CENTRE + 0.55, r"$\omega$", MOTION, fontsize=13)
    arrow(axes, (-2.6, 9.0), (2.6, 9.0), QUIET, 7, size=30)
    label(axes, 3.0, 9.0, "rolling direction,\nspeed $V$", QUIET, ha="left")
    arrow(axes, (0, 0), (0, 1.9), BLACK, 1.6)
    arrow(axes, (0, 0), (5.1, 0), BLACK, 1.6)
    label(axes, 0.3, 1.85, "$z$", fontsize=13)
    label(axes, 5.3, 0.3, "$x$", fontsize=13)
    axes.add_patch(Circle((0, 0), 0.2, facecolor="white", edgecolor=BLACK, linewidth=1.4, zorder=6))
    axes.plot([-0.13, 0.13], [-0.13, 0.13], [-0.13, 0.13], [0.13, -0.13], color=BLACK, linewidth=1.4, zorder=7)
    label(axes, -0.42, 0.38, "$y$", fontsize=13)
    for sign, name in ((1, "leading\nedge"), (-1, "trailing\nedge")):
        axes.plot([sign * EDGE] * 2, [-1.35, 0], color=QUIET, linewidth=1, linestyle="--")
        label(axes, sign * EDGE, -1.8, name, fontsize=10)
    flow(axes)


def flow(axes):
    """Particles that pass the contact, and the forces that slip causes."""
    angles = np.radians([330, 308])
    points = [(1.09 * RADIUS * np.cos(angle), CENTRE + 1.09 * RADIUS * np.sin(angle)) for angle in angles]
    arrow(axes, *points, QUIET, 1.6, curve=-0.1)
    label(axes, 4.2, 1.35, "particles of\nthe wheel", QUIET, fontsize=10, ha="left")
    arrow(axes, (6.9, -0.55), (3.9, -0.55), QUIET, 1.6)
    label(axes, 5.4, -0.95, "particles of the rail", QUIET, fontsize=10)
    arrow(axes, (-0.7, 0.62), (-3.1, 0.62), FORCE, 2.6)
    label(axes, -5.3, 0.62, "$F_x<0$ on the wheel", FORCE, fontsize=11)
    arrow(axes, (-3.1, -0.5), (-0.7, -0.5), FORCE, 2.6)
    label(axes, -5.3, -0.5, "$-F_x$ on the rail", FORCE, fontsize=11)


def velocities(axes):
    """Why xi is what it is: velocities in the moving frame."""
    bare(axes, (-0.6, 10.6), (-2.4, 9.6))
    axes.set_title("Velocities at the contact, in the frame that moves with it", fontsize=12)
    rows = ((7.4, 5.0, "particle of the wheel: $-\\omega R$", QUIET), (5.4, 7.2, "particle of the rail: $-v$", QUIET))
    for height, length, text, colour in rows:
        arrow(axes, (9.2, height), (9.2 - length, height), colour, 3)
        label(axes, 9.2, height + 0.55, text, colour, ha="right")
    for x in (9.2 - rows[0][1], 9.2 - rows[1][1]):
        axes.plot([x, x], [3.3, 7.6], color=QUIET, linewidth=1, linestyle="--")
    arrow(axes, (9.2 - rows[1][1], 3.5), (9.2 - rows[0][1], 3.5), MOTION, 3)
    label(axes, 4.6, 3.5, "wheel over rail: $w_x V=v-\\omega R$", MOTION, ha="left")
    label(axes, 5, 1.6, r"$\xi=\dfrac{v-\omega R}{V}$", MOTION, fontsize=15)
    label(axes, 5, -0.2, r"$\xi>0$, braked: $F_x<0$ holds the wheel back", FORCE)
    label(axes, 5, -0.9, r"$\xi<0$, driven: $F_x>0$ pushes the wheel on", FORCE)


def top_view(axes, title):
    """The contact from above, with its frame and edges."""
    bare(axes, (-4.0, 4.6), (-3.1, 3.2))
    axes.set_title(title, fontsize=12)
    axes.add_patch(Ellipse((0, 0), 5.2, 3.8, facecolor=CONTACT, edgecolor=BLACK, linewidth=1.2))
    angles = np.linspace(-np.pi / 2, np.pi / 2, 200)
    axes.plot(2.6 * np.cos(angles), 1.9 * np.sin(angles), color=BLACK, linewidth=4, solid_capstyle="butt")
    arrow(axes, (0, 0), (3.9, 0), BLACK, 1.2, size=11)
    arrow(axes, (0, 0), (0, 2.8), BLACK, 1.2, size=11)
    label(axes, 4.2, 0, "$x$", fontsize=13)
    label(axes, 0.35, 2.8, "$y$", fontsize=13)


def creepages(panels):
    """Motion of the wheel over the rail, and the force on the wheel."""
    top_view(panels[0], "longitudinal creepage $\\xi>0$")
    arrow(panels[0], (-1.7, 0.75), (1.7, 0.75), MOTION, 3)
    arrow(panels[0], (1.7, -0.75), (-1.7, -0.75), FORCE, 3)
    label(panels[0], 0, -2.7, r"$F_x\approx-G\,ab\,C_{11}\,\xi$", FORCE)
    label(panels[0], 2.75, 1.75, "leading\nedge", fontsize=10, ha="left")
    label(panels[0], -2.5, 1.75, "trailing\nedge", fontsize=10, ha="right")

    top_view(panels[1], "lateral creepage $\\eta>0$")
    arrow(panels[1], (-0.9, -1.2), (-0.9, 1.2), MOTION, 3)
    arrow(panels[1], (0.9, 1.2), (0.9, -1.2), FORCE, 3)
    label(panels[1], 0, -2.7, r"$F_y\approx-G\,ab\,C_{22}\,\eta$", FORCE)

    top_view(panels[2], "spin $\\phi>0$")
    for x, y in ((-1.9, 0), (-0.95, 0), (0.95, 0), (1.9, 0), (0, 1.3), (0, -1.3), (0, 0.65), (0, -0.65)):
        arrow(panels[2], (x + 0.26 * y, y - 0.26 * x), (x - 0.26 * y, y + 0.26 * x), MOTION, 1.8, size=9)
    turn(panels[2], (0, 0), 1.45, 20, 70, MOTION, 2.6)
    turn(panels[2], (0, 0), 1.45, 160, 110, FORCE, 2.6)
    arrow(panels[2], (0.85, -0.3), (0.85, -1.6), FORCE, 3)
    label(panels[2], -1.85, 1.0, "$M_z$", FORCE)
    label(panels[2], 1.3, -0.85, "$F_y$", FORCE)
    label(panels[2], 0, -2.7, r"$F_y\approx-G\,(ab)^{3/2}C_{23}\,\phi$,  $M_z\approx-G\,(ab)^2C_{33}\,\phi$", FORCE)


def main():
    """Writes the drawing; the same bytes each time."""
    target = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent / "images" / "axes_and_signs.svg"
    matplotlib.rcParams.update({"font.size": 11, "svg.hashsalt": "axes_and_signs", "mathtext.fontset": "dejavusans"})
    figure = pyplot.figure(figsize=(12, 8.8), layout="constrained")
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.25, 1))
    left, right = upper.subplots(1, 2, width_ratios=(1.25, 1))
    side_view(left)
    velocities(right)
    creepages(lower.subplots(1, 3))
    lower.suptitle("Top view: blue, motion of the wheel over the rail; orange, force on the wheel", fontsize=12)
    figure.savefig(target, metadata={"Date": None} if str(target).endswith("svg") else None)


if __name__ == "__main__":
    main()
