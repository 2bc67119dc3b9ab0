"""A field of a rolling contact as a map or as a surface, theories or patches side by side."""

import difflib
import math

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.contact_cells import MOST_CELLS
from microslip.picture_style import INK2, SIGNED, SIZES, bodies_of, heading, label_of, new_figure, put_title, the, unit_for
from microslip.result_file import ResultError
from microslip.rolling_contact_pictures import contact_panels
from microslip.solved_contacts import is_shift, rolls_backward, tells_direction

# A sign that is smaller than this share of the other does not count.
ONE_SIGN = 0.02
# Name: title with {} for body 1, unit in SI, the datasets it is made of, whether it falls to zero at the edge.
FIELDS = {
    "pressure": ("pressure $p_n$", "Pa", ("pressure",), True),
    "bound": ("traction bound $g$", "Pa", ("bound",), True),
    "traction": (r"size of the traction $|\mathbf{{p}}|$", "Pa", ("px", "py"), True),
    "px": ("traction on {} $p_x$", "Pa", ("px",), True),
    "py": ("traction on {} $p_y$", "Pa", ("py",), True),
    "slip": (r"size of the slip $|\mathbf{{s}}|$", "-", ("sx", "sy"), False),
    "sx": ("slip of {} $s_x$", "-", ("sx",), False),
    "sy": ("slip of {} $s_y$", "-", ("sy",), False),
    "power": ("frictional power", "W/m²", ("px", "py", "sx", "sy"), True),
    "gap": ("distance of the bodies", "m", ("gap",), False),
    "ux": ("displacement difference $u_x$", "m", ("ux",), False),
    "uy": ("displacement difference $u_y$", "m", ("uy",), False),
    "friction_work": ("work of friction per metre rolled and area", "N/m²", ("friction_work",), True),
    "wear_depth": ("depth that a passage wears off", "m", ("wear_depth",), True),
    "shear_excess": ("traction beyond the yield strength in shear", "Pa", ("shear_excess",), False),
}


# Fields that are zero where it sticks.
OF_SLIP = ("slip", "sx", "sy", "power")
# Fields that cells have themselves, with what makes SI units of theirs.
OF_CELLS = {"pressure": 1e6, "bound": 1e6, "px": 1e6, "py": 1e6, "sx": 1e-3, "sy": 1e-3}


def check_field(name):
    """Throws for a field that pictures do not know."""
    if name not in FIELDS:
        matches = difflib.get_close_matches(name, FIELDS, 1)
        hint = f"; did you mean '{matches[0]}'?" if matches else ""
        raise ResultError(f"field '{name}' is unknown, known: {', '.join(FIELDS)}{hint}")


def has_field(result, contact, name):
    """Returns whether the file has what a field of a contact is made of."""
    parts = FIELDS[name][2]
    if contact.folder is None:
        return all(part in OF_CELLS for part in parts) and (name != "power" or contact.speed is not None)
    return all(f"{contact.folder}/{part}" in result for part in parts)


def field_values(result, contact, name):
    """The values of a field at a contact's cells, in SI."""
    if contact.folder is None:
        arrays = [OF_CELLS[part] * getattr(contact.cells, part) for part in FIELDS[name][2]]
    else:
        paths = [f"{contact.folder}/{part}" for part in FIELDS[name][2]]
        strides = [math.ceil(count / MOST_CELLS) for count in result.shape(paths[0])]
        arrays = result.arrays(paths, dimensions=2, strides=strides)
    if name == "power":
        if is_shift(result):
            raise ResultError(f"{result.path}: a shift takes no time and has no frictional power")
        px, py, sx, sy = arrays
        return -contact.speed * (px * sx + py * sy)
    return arrays[0] if len(arrays) == 1 else np.hypot(*arrays)


class FieldOfContacts:
    """A field of each contact that has it, in a unit that suits its size, with one scale of colours for all."""

    def __init__(self, result, contacts, name):
        check_field(name)
        values = {key: field_values(result, one, name) for key, one in contacts.items() if has_field(result, one, name)}
        if not values:
            there = [known for known in FIELDS if any(has_field(result, one, known) for one in contacts.values())]
            raise ResultError(f"{result.path}: does not have the field '{name}', but {', '.join(there)}")
        title, unit, _, self.vanishes = FIELDS[name]
        self.title = title.format(the(bodies_of(result)[0]))
        self.cells = {key: contacts[key].cells for key in values}
        inside = np.concatenate([value[self.cells[key].inside] for key, value in values.items()])
        low, high = (min(inside.min(initial=0), 0), max(inside.max(initial=0), 0))
        if unit == "-" and is_shift(result):
            unit = "m"  # of slip
        factor, self.unit = (1e3, "$10^{-3}$") if unit == "-" else unit_for(max(high, -low), unit)
        self.values = {key: factor * value for key, value in values.items()}
        self.colours, self.scale = colours_of(factor * low, factor * high)

    def label(self):
        """Label of a scale."""
        return f"{self.title} [{self.unit}]"

    def heading(self):
        """Title of a figure."""
        return self.title[0].upper() + self.title[1:]


def colours_of(low, high):
    """Colour map and scale for values from low <= 0 to high >= 0: about zero only if both signs occur."""
    far = max(high, -low) or 1.0
    if -low < ONE_SIGN * far:
        return SIZES, Normalize(0, far)
    if high < ONE_SIGN * far:
        return SIZES.reversed(), Normalize(-far, 0)
    return SIGNED, Normalize(-far, far)


def field_map(result, contacts, name):
    """The figure of a field as a map."""
    field = FieldOfContacts(result, contacts, name)
    figure, panels = contact_panels(result, field.cells, field.heading())
    for axes, (key, value) in zip(panels, field.values.items()):
        field.cells[key].draw(axes, value, vanishes=field.vanishes, of_slip=name in OF_SLIP, cmap=field.colours, norm=field.scale)
        axes.set_title(label_of(key))
    figure.colorbar(ScalarMappable(norm=field.scale, cmap=field.colours), ax=panels, label=field.label(), shrink=0.8, pad=0.02)
    return figure


def field_surface(result, contacts, name):
    """The figure of a field as a surface over the contact."""
    field = FieldOfContacts(result, contacts, name)
    if any(cells.is_regular and min(cells.x.shape) == 1 for cells in field.cells.values()):
        raise ResultError(f"{result.path}: a single row of elements has no surface; --field and --cut show it")
    figure = new_figure(5.0 * len(field.values) + 1, 4.6, layout="none")
    put_title(figure, heading(field.heading(), result, field.cells))
    along_x = f"x [mm], rolling {'against' if rolls_backward(result) else 'along'} x" if tells_direction(result) else "x [mm]"
    share = 0.9 / len(field.values)
    panels = [figure.add_axes((number * share, 0.0, share, 0.96), projection="3d") for number in range(len(field.values))]
    surfaces = {key: field.cells[key].surface(value, field.vanishes) for key, value in field.values.items()}
    heights = [height for meshes in surfaces.values() for *_, height in meshes]
    low, high = min(0, *map(np.nanmin, heights)), max(0, *map(np.nanmax, heights))
    for axes, (key, meshes) in zip(panels, surfaces.items()):
        grid = field.cells[key]
        for x, y, height in meshes:
            colours = field.colours(field.scale(np.nan_to_num(height)))
            axes.plot_surface(x, y, height, facecolors=colours, rstride=1, cstride=1, linewidth=0, antialiased=False, shade=False)
            axes.plot_wireframe(x, y, height, rstride=6, cstride=9, color=(0, 0, 0, 0.25), linewidth=0.5)
        for part in grid.outline.parts:
            axes.plot(*part.T, 0, color=INK2, linewidth=1)
        left, right, front, back = grid.outline.limits()
        axes.set_xlim(left, right)
        axes.set_ylim(front, back)
        axes.set_zlim(low, high if high > low else low + 1)
        axes.set_xlabel(along_x, labelpad=4)
        axes.set_ylabel("y [mm]", labelpad=4)
        axes.set_box_aspect((grid.a, grid.b, 0.7 * max(grid.a, grid.b)) if min(grid.a, grid.b) > 0.3 * max(grid.a, grid.b)
                            else (1, 1, 0.7), zoom=0.98)
        axes.tick_params(axis="x", labelrotation=0, pad=1)
        axes.locator_params(nbins=6)
        axes.view_init(elev=32, azim=-125)
        axes.text2D(0.12, 0.86, label_of(key), transform=axes.transAxes)
    bar = figure.add_axes((0.915, 0.2, 0.014, 0.55))
    figure.colorbar(ScalarMappable(norm=field.scale, cmap=field.colours), cax=bar, label=field.label())
    return figure
