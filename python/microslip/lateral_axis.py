"""An axis across the track as seen forward: distances from a point of the rail without signs, both sides by name."""

from microslip.picture_style import INK2, number


def lateral_axis(axes, result, label, named=True):
    """Labels the axis along which y grows to the left, zero at a point of the rail; `named` writes field and gauge side above."""
    if not axes.xaxis_inverted():
        axes.invert_xaxis()
    axes.xaxis.set_major_formatter(lambda value, _: number(abs(value)))
    axes.set_xlabel(label)
    names = ("\N{LEFTWARDS ARROW} field side", "gauge side \N{RIGHTWARDS ARROW}")
    if result.text("/inputs/wheel/side") == "right":
        names = ("\N{LEFTWARDS ARROW} gauge side", "field side \N{RIGHTWARDS ARROW}")
    for name, at, align in zip(names if named else (), (0, 1), ("left", "right")):
        axes.text(at, 1.02, name, transform=axes.transAxes, ha=align, va="bottom", color=INK2, size="small", weight="bold")
