"""A field of two results on the same elements: its values in each, and their difference."""

import copy

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize

from microslip.field_picture import FIELDS, OF_SLIP, check_field, colours_of, field_values, has_field
from microslip.picture_style import SIGNED, bodies_of, label_of, new_figure, put_title, the, unit_for, with_unit
from microslip.result_file import ResultError
from microslip.solved_contacts import is_shift, label_along_x

# Elements are the same if their centres differ by less than this share of the contact's half-length.
SAME_PLACE = 1e-6


def difference_picture(results, all_contacts, name):
    """The figure of a field of two open result files, A and B, with their contacts by name: for each contact A, B to one
    scale of colours, and B - A."""
    check_field(name)
    first = results[0]
    contacts = contacts_in_both(results, all_contacts, name)
    values = {key: [field_values(result, one, name) for result, one in zip(results, pair)] for key, pair in contacts.items()}
    cells = {key: [one.cells for one in pair] for key, pair in contacts.items()}
    either = {key: cells_in_either(*pair) for key, pair in cells.items()}
    of_field = np.concatenate([value[one.inside] for key in contacts for value, one in zip(values[key], cells[key])])
    differences = {key: two - one for key, (one, two) in values.items()}
    largest = {key: np.abs(value[either[key].inside]).max(initial=0) for key, value in differences.items()}
    low, high = min(of_field.min(initial=0), 0), max(of_field.max(initial=0), 0)
    title, unit = FIELDS[name][0].format(the(bodies_of(first)[0])), unit_of(first, name)
    factor, printed = scaled(max(high, -low), unit)
    close, of_difference = scaled(max(largest.values()), unit)
    figure, panels = panels_for(results, either, title)
    colours, scale = colours_of(factor * low, factor * high)
    about_zero = Normalize(*(close * side * (max(largest.values()) or 1 / close) for side in (-1, 1)))
    for row, key in zip(panels, contacts):
        for axes, one, value in zip(row, cells[key], values[key]):
            one.draw(axes, factor * value, vanishes=FIELDS[name][3], of_slip=name in OF_SLIP, cmap=colours, norm=scale)
            one.draw_outline(axes)
        either[key].draw(row[2], close * differences[key], vanishes=FIELDS[name][3], cmap=SIGNED, norm=about_zero)
        either[key].draw_outline(row[2])
        row[0].set_title(f"{label_of(key)}, A")
        row[1].set_title("B")
        row[2].set_title(f"B \N{MINUS SIGN} A, at most {size_text(largest[key], unit)}")
    figure.colorbar(ScalarMappable(norm=scale, cmap=colours), ax=list(panels[:, :2].flat), label=f"{title} [{printed}]", shrink=0.9,
                    pad=0.02)
    figure.colorbar(ScalarMappable(norm=about_zero, cmap=SIGNED), ax=list(panels[:, 2]), label=f"difference [{of_difference}]",
                    shrink=0.9, pad=0.02)
    return figure


def contacts_in_both(results, all_of, name):
    """The contacts of both files that have a field, in pairs. Throws where one file has a patch that the other has not, and
    for elements that are not the same."""
    has = [[key for key, one in contacts.items() if has_field(result, one, name)] for result, contacts in zip(results, all_of)]
    for result, keys in zip(results, has):
        if not keys:
            raise ResultError(f"{result.path}: does not have the field '{name}'")
    keys = [key for key in has[0] if key in has[1]]
    of_patches = results[0].attribute("kind") != "rolling_contact"
    if not keys or (of_patches and has[0] != has[1]):
        raise ResultError(f"{results[1].path}: the field '{name}' is that of {', '.join(has[1])}, in {results[0].path} of "
                          f"{', '.join(has[0])}: there is nothing to compare")
    for key in keys:
        check_elements(results, [contacts[key].cells for contacts in all_of], key)
    return {key: [contacts[key] for contacts in all_of] for key in keys}


def check_elements(results, cells, key):
    """Throws for elements that are not the same."""
    one, two = cells
    where = f"{results[1].path}: {label_of(key)}"
    sizes = ["{} x {}".format(*cell.x.shape[::-1]) for cell in cells]
    if sizes[0] != sizes[1]:
        raise ResultError(f"{where} has {sizes[1]} elements, in {results[0].path} it has {sizes[0]}; differences need the same elements")
    apart = max(np.abs(getattr(two, axis) - getattr(one, axis)).max() for axis in "xy")
    if apart > SAME_PLACE * max(one.a, one.b):
        raise ResultError(f"{where} has elements up to {apart:.2g} mm from those of {results[0].path}; differences need the same elements")


def cells_in_either(one, two):
    """The cells that are in contact in one of two solutions on the same elements."""
    both = copy.copy(one)
    both.state = np.maximum(one.state, two.state)
    both.inside = one.inside | two.inside
    if one.pressure is not None and two.pressure is not None:
        both.pressure = np.maximum(one.pressure, two.pressure)
        both.outline = both.outline_of_pressure()
    return both


def unit_of(result, name):
    """The unit of a field in SI; slip of a shift is a length."""
    unit = FIELDS[name][1]
    return "m" if unit == "-" and is_shift(result) else unit


def scaled(largest, unit):
    """Factor and name of the unit of a scale."""
    return (1e3, "$10^{-3}$") if unit == "-" else unit_for(largest, unit)


def size_text(value, unit):
    """A size of a field as text."""
    return f"{1e3 * value:.3g}" + r"$\,\cdot\,10^{-3}$" if unit == "-" else with_unit(value, unit)


def panels_for(results, cells, title):
    """A figure with three panels in a row for each contact: axes in mm to scale."""
    shapes = [one.b / one.a for one in cells.values()]
    true_to_scale = all(one.true_to_scale() for one in cells.values())
    height = 3.6 * float(np.clip(np.mean(shapes), 0.4, 1.6)) if true_to_scale else 3.6
    figure = new_figure(14, (height + 0.5) * len(cells) + 1.7, layout="compressed")
    titles = [f"{letter}: {result.attribute('title', 'rolling contact')}" for letter, result in zip("AB", results)]
    put_title(figure, "\n".join([title[0].upper() + title[1:], *titles]))
    panels = figure.subplots(len(cells), 3, squeeze=False, sharex="row", sharey="row")
    for row, one in zip(panels, cells.values()):
        left, right, low, high = one.outline.limits()
        for axes in row:
            axes.set_xlim(left - 0.06 * (right - left), right + 0.06 * (right - left))
            axes.set_ylim(low - 0.06 * (high - low), high + 0.06 * (high - low))
            axes.set_aspect("equal" if true_to_scale else "auto")
        row[0].set_ylabel("y [mm]")
    for axes in panels[-1]:
        axes.set_xlabel(label_along_x(results[0]))
    return figure, panels
