"""Results with arrays as labelled tables: pandas' data frames and xarray's datasets.

A result's arrays share a shape (...); some have further dimensions, as those of the patches of a wheel. Inputs that vary are
arrays like these. Numbers and words that a whole result has, inputs among them, go along. Units come from the texts of the
properties, `shape (...) [N]`.
"""

import enum
import re

import numpy as np


def members_of(result):
    """(name, value, text) of every property of a result."""
    for kind in reversed(type(result).__mro__):
        for name, member in vars(kind).items():
            if isinstance(member, property):
                yield name, getattr(result, name), member.__doc__ or ""


def unit_in(text, motion):
    """The unit that the text of a property names; of two the second belongs to shifts. None: it has several, or none."""
    units = re.findall(r"\[([^\]]+)\]", text)
    if len(units) == 2 and "of a shift" in text and motion:
        return units[motion == "shift"]
    return units[0] if len(units) == 1 else None


def inputs_of(result, text):
    """(name, value, unit) of what a result was computed from, whose text lists the units, `a [m], b [m]`."""
    units = dict(re.findall(r"(\w+) \[([^\]]+)\]", text))
    return [(name, value, units.get(name)) for name, value in result.inputs.items()]


def parts_of(result, motion=None):
    """(name, value, unit or None) of every array of a result and of every number and word, those of results within it too:
    first what it was computed from."""
    inputs, found = [], []
    motion = getattr(result, "motion", motion)
    for name, value, text in members_of(result):
        if name == "inputs":
            inputs += inputs_of(result, text)
        elif name == "creepage":
            inputs += [(f"creepage_{part}" if part != "spin" else part, getattr(value, part), unit)
                       for part, unit in (("longitudinal", "-"), ("lateral", "-"), ("spin", "1/m"))]
        elif hasattr(value, "to_dataframe"):
            found += parts_of(value, motion)
        elif isinstance(value, enum.Enum):
            found.append((name, value.name, None))
        elif isinstance(value, (np.ndarray, float, int, str)):
            found.append((name, value, unit_in(text, motion)))
    return inputs + found


def arrays_and_scalars(result):
    """Both apart, the arrays with those that have the shape first; further ones have more dimensions."""
    parts = parts_of(result)
    arrays = [part for part in parts if isinstance(part[1], np.ndarray)]
    dimensions = min(array.ndim for _, array, _ in arrays)
    shape = next(array.shape for _, array, _ in arrays if array.ndim == dimensions)
    return arrays, [part for part in parts if not isinstance(part[1], np.ndarray)], shape


def origin_of(result):
    """Description of the result, and the version that computed it."""
    import microslip
    return {"result": type(result).__name__, "version": microslip.__version__}


def words_of(name):
    """The words of codes that an array of this name holds, in the order of the codes; or None."""
    import microslip
    kinds = {"status": microslip.Status, "state": microslip.CellState}
    return [code.name for code in kinds[name]] if name in kinds else None


def imported(package):
    try:
        return __import__(package)
    except ImportError as error:
        raise ImportError(f"this needs {package}, which is not installed (Debian: python3-{package}); to_dict() needs "
                          "numpy only") from error


def to_dataframe(result):
    """A pandas.DataFrame with a row for each element of the arrays, in the order of their flat index, and a column for
    each array; one with further dimensions has a column for each of their elements, as `patch_fx_0`. Codes are words.
    In `attrs`: `units` of columns and scalars, `scalars`, `result`, `version`."""
    pandas = imported("pandas")
    arrays, scalars, shape = arrays_and_scalars(result)
    columns, units = {}, {name: unit for name, _, unit in scalars if unit}
    for name, array, unit in arrays:
        words = words_of(name)
        flat = array.reshape(int(np.prod(shape)), -1)
        for further in np.ndindex(array.shape[len(shape):]):
            label = "_".join([name, *map(str, further)])
            column = flat[:, np.ravel_multi_index(further, array.shape[len(shape):])] if further else flat[:, 0]
            columns[label] = pandas.Categorical.from_codes(column, words) if words else column
            if unit:
                units[label] = unit
    frame = pandas.DataFrame(columns)
    frame.attrs.update(origin_of(result), units=units, scalars={name: value for name, value, _ in scalars})
    return frame


def to_xarray(result):
    """An xarray.Dataset with a variable for each array, on dimensions dim_0, dim_1, ... that they share (row and element
    of a field), and one without dimensions for what all share; `units` among the attributes, of codes flag_values and
    flag_meanings as by the CF conventions. Attributes of the dataset: `result`, `version`."""
    xarray = imported("xarray")
    arrays, scalars, shape = arrays_and_scalars(result)
    is_field = {"x", "y", "area"} <= {name for name, _, _ in arrays}
    shared = ["row", "element"] if is_field and len(shape) == 2 else [f"dim_{k}" for k in range(len(shape))]
    variables = {name: ((), value, {"units": unit} if unit else {}) for name, value, unit in scalars}
    for name, array, unit in arrays:
        owner = "patch" if name.startswith("patch_") else name
        further = [f"{owner}_{k}" if array.ndim > len(shape) + 1 else owner for k in range(array.ndim - len(shape))]
        words = words_of(name)
        attributes = {"units": unit} if unit else {}
        if words:
            attributes = {"flag_values": list(range(len(words))), "flag_meanings": " ".join(words)}
        variables[name] = (shared + further, array.copy(), attributes)
    dataset = xarray.Dataset(variables, attrs=origin_of(result))
    return dataset.set_coords(["x", "y"]) if is_field else dataset
