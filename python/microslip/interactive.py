"""A field over a contact as a surface to turn and zoom, for notebooks and as a page of its own (Debian: python3-plotly)."""

from microslip.contact_cells import read_cells
from microslip.field_picture import FieldOfTheories
from microslip.picture_style import THEORIES
from microslip.result_file import ResultError, ResultFile


def view(path, field="traction", theory=None):
    """An interactive view of a field of a result file of one rolling contact: a figure of plotly, which notebooks show by
    themselves and `write_html("view.html")` writes as a page that needs no network. `field`: as in `plot --field`; `theory`:
    exact, fastsim2, ...; by default the best one that has the field. ResultError for other files and without plotly."""
    try:
        from plotly import graph_objects
    except ImportError:
        raise ResultError("interactive views need plotly: install python3-plotly") from None
    with ResultFile(path) as result:
        if result.attribute("kind") != "rolling_contact":
            raise ResultError(f"{path}: kind '{result.attribute('kind')}': interactive views are of two bodies, what solve makes of a case with [body1] and [body2]")
        if theory is not None and theory not in result:
            raise ResultError(f"{path}: no theory '{theory}', there are: {', '.join(one for one in THEORIES if one in result)}")
        cells = {one: read_cells(result, one) for one in THEORIES if one in result and theory in (None, one)}
        shown = FieldOfTheories(result, cells, field)
        title = f"{shown.heading()}: {result.attribute('title', 'rolling contact')}"
    name = list(shown.values)[-1]
    return figure_of(graph_objects, shown, name, f"{title}, {THEORIES[name]}")


def figure_of(graph_objects, field, theory, title):
    """The surfaces of all parts of the contact, their outlines on the ground."""
    grid = field.cells[theory]
    label = plain(field.label())
    scale = {"colorscale": "Viridis" if field.colours.startswith("viridis") else "PuOr", "cmin": field.scale.vmin, "cmax": field.scale.vmax,
             "reversescale": field.colours.endswith("_r")}
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
    """Without the signs of TeX, as plotly shows it."""
    for old, new in ((r"\mathbf{p}", "p"), (r"\mathbf{s}", "s"), ("$10^{-3}$", "1e-3"), ("p_n", "p<sub>n</sub>"), ("$", ""),
                     ("p_x", "p<sub>x</sub>"), ("p_y", "p<sub>y</sub>"), ("s_x", "s<sub>x</sub>"), ("s_y", "s<sub>y</sub>"),
                     ("u_x", "u<sub>x</sub>"), ("u_y", "u<sub>y</sub>")):
        text = text.replace(old, new)
    return text
