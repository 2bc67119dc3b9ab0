"""Pictures of a wheelset over a sweep: forces of both wheels, roll, rolling speed."""

from microslip.picture_style import BLACK, BLUE, VERMILION, heading, new_figure, open_axes, put_title
from microslip.wheel_rail_pictures import varied


def wheelset_pictures(result):
    """The pictures of a result file of kind wheelset, by file name: none of a single state."""
    if len(result.array("/wheelset/force_x", finite=False)) < 2:
        return {}
    return {"wheelset.png": wheelset_picture(result)}


def wheelset_picture(result):
    """Over what a sweep varies."""
    label, values = varied(result)
    figure = new_figure(9, 6.4)
    put_title(figure, heading("Forces on a wheelset", result))
    axes = figure.subplots(2, 2, sharex=True).ravel()
    for one, force, text in ((axes[0], "force_y", "lateral force, to the left [kN]"), (axes[1], "force_z", "vertical force [kN]")):
        for side, colour in (("left", BLUE), ("right", VERMILION)):
            one.plot(values, 1e-3 * result.array(f"/{side}/wheel/{force}", finite=False), ".-", color=colour, label=f"{side} wheel")
        one.set_ylabel(text)
        one.legend(loc="best")
    for one, name, factor, text in ((axes[2], "roll", 1e3, "roll [mrad]"), (axes[3], "pitch_velocity", 1, "pitch velocity [rad/s]")):
        one.plot(values, factor * result.array(f"/wheelset/{name}", finite=False), ".-", color=BLACK)
        one.set_ylabel(text)
        one.set_xlabel(label)
    for one in axes:
        open_axes(one)
    return figure
