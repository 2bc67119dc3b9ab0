"""A friction law: the coefficient over the slip velocity, a curve for each pressure and temperature of a table."""

import numpy as np

from microslip.picture_style import INK, SIZES_OF_LINES, heading, new_figure, number, open_axes, put_title

# Slip velocities below a metre in a second are shown in mm/s.
FAST = 1.0


def friction_law_picture(result):
    """mu(v) with the points of a table."""
    velocities = result.array("/friction_law/slip_velocity")
    curves = result.array("/friction_law/coefficient", dimensions=2)
    factor, unit = (1, "m/s") if velocities[-1] >= FAST else (1e3, "mm/s")
    figure = new_figure(7.0, 4.6)
    axes = figure.subplots()
    open_axes(axes)
    labels, colours = labels_of(result, len(curves)), colours_of(len(curves))
    for curve, label, colour in zip(curves, labels, colours):
        axes.plot(factor * velocities, curve, color=colour, linewidth=2, label=label)
    if "friction_law/slip_velocity_of_table" in result:
        nodes = result.array("/friction_law/slip_velocity_of_table")
        for points, colour in zip(result.array("/friction_law/coefficient_of_table", dimensions=2), colours):
            axes.plot(factor * nodes, points, "o", color=colour, markersize=5)
    axes.set_xlim(0, factor * velocities[-1])
    axes.set_ylim(0, 1.08 * curves.max() or 1)
    axes.set_xlabel(f"slip velocity v [{unit}]")
    axes.set_ylabel(r"coefficient of friction $\mu$ [-]")
    if any(labels):
        axes.legend(loc="lower right")
    put_title(figure, heading("Friction law", result))
    return figure


def labels_of(result, count):
    """What each curve is of; nothing where the law depends on the slip velocity alone."""
    texts = [[] for _ in range(count)]
    for name, factor, unit in (("pressure", 1e-6, "MPa"), ("temperature", 1, "°C")):
        if f"friction_law/{name}" in result:
            for text, value in zip(texts, np.atleast_1d(result.array(f"/friction_law/{name}"))):
                text.append(f"{number(factor * value)} {unit}")
    return [", ".join(text) or None for text in texts]


def colours_of(count):
    """One colour, or shades from the first curve to the last."""
    return [INK] if count == 1 else [SIZES_OF_LINES(k / (count - 1)) for k in range(count)]
