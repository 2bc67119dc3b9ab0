"""A field over a contact as a surface to turn and zoom, for notebooks and as a separate page (Debian: python3-plotly)."""

import numpy as np
from matplotlib.colors import to_hex

from microslip.field_picture import FieldOfContacts
from microslip.picture_style import THEORIES, label_of
from microslip.result_file import ResultError, ResultFile
from microslip.solved_contacts import KINDS, read_contacts


def view(path, field="traction", theory=None, patch=None):
    """An interactive view of a field of a result file with fields, of two bodies or of wheels on rails: a figure of plotly,
    which notebooks show by themselves and `write_html("view.html")` writes as a page that needs no network. `field`: as in
    `plot --field`; of two bodies `theory`: exact, fastsim2, ..., by default the best one that has the field; of wheels on
    rails `patch`: "patch 2", "left wheel, patch 1", by default the one with the largest values. ResultError for other files
    and without plotly."""
    try:
        from plotly import graph_objects
    except ImportError:
        raise ResultError("interactive views need plotly: install python3-plotly") from None
    with ResultFile(path) as result:
        kind = result.attribute("kind")
        if kind not in KINDS:
            raise ResultError(f"{path}: kind '{kind}' has no fields to view; these kinds have: {', '.join(KINDS)}")
        contacts = chosen(result, read_contacts(result), theory, patch)
        shown = FieldOfContacts(result, contacts, field)
        title = f"{shown.heading()}: {result.attribute('title', 'rolling contact')}"
    name = list(shown.values)[-1]
    if kind != "rolling_contact":
        name = max(shown.values, key=lambda key: abs(shown.values[key]).max())
    return figure_of(graph_objects, shown, name, f"{title}, {label_of(name)}")


def chosen(result, contacts, theory, patch):
    """The contacts of a theory or the patch that is asked for; all if none is."""
    of_theories = set(contacts) <= set(THEORIES)
    what, asked, other = ("theory", theory, patch) if of_theories else ("patch", patch, theory)
    if other is not None:
        raise ResultError(f"{result.path}: choose by {what}=, one of: {', '.join(contacts)}")
    if asked is not None and asked not in contacts:
        raise ResultError(f"{result.path}: no {what} '{asked}', there are: {', '.join(contacts)}")
    return {key: one for key, one in contacts.items() if asked in (None, key)}


def figure_of(graph_objects, field, theory, title):
    """The surfaces of all parts of the contact, their outlines on the ground."""
    grid = field.cells[theory]
    label = plain(field.label())
    steps = np.linspace(0, 1, 9)
    scale = {"colorscale": [(step, to_hex(field.colours(step))) for step in steps], "cmin": field.scale.vmin, "cmax": field.scale.vmax}
    figure = graph_objects.Figure()
    for number, (x, y, height) in enumerate(grid.surface(field.values[theory], field.vanishes)):
        figure.add_trace(graph_objects.Surface(x=x, y=y, z=height, colorbar={"title": label}, showscale=number == 0, **scale,
                                               hovertemplate="x %{x:.3g} mm<br>y %{y:.3g} mm<br>%{z:.4g}<extra></extra>"))
    for part in grid.outline.parts:
        figure.add_trace(graph_objects.Scatter3d(x=part[:, 0], y=part[:, 1], z=0 * part[:, 0], mode="lines", showlegend=False,
                                                 line={"color": "black", "width": 3}, hoverinfo="skip"))
    longest = max(grid.a, grid.b)
    shape = {"x": max(grid.a / longest, 0.2), "y": max(grid.b / longest, 0.2), "z": 0.6}
    figure.update_layout(title=plain(title), scene={"xaxis_title": "x [mm]", "yaxis_title": "y [mm]", "zaxis_title": label,
                                                    "aspectmode": "manual", "aspectratio": shape})
    return figure


def plain(text):
    """Text without the signs of TeX, as plotly shows it."""
    for old, new in ((r"\mathbf{p}", "p"), (r"\mathbf{s}", "s"), ("$10^{-3}$", "1e-3"), ("p_n", "p<sub>n</sub>"), ("$", ""),
                     ("p_x", "p<sub>x</sub>"), ("p_y", "p<sub>y</sub>"), ("s_x", "s<sub>x</sub>"), ("s_y", "s<sub>y</sub>"),
                     ("u_x", "u<sub>x</sub>"), ("u_y", "u<sub>y</sub>")):
        text = text.replace(old, new)
    return text
