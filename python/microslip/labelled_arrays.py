"""Results with arrays as labelled tables: pandas' data frames and xarray's datasets.

A result's arrays share a shape (...); some have further dimensions, as those of the patches of a wheel. Units come from
the texts of the properties, `shape (...) [N]`.
"""

import re

import numpy as np


def arrays_of(result):
    """(name, array, unit or None) of every property of a result that is an array, those of results within it too."""
    found = []
    for kind in reversed(type(result).__mro__):
        for name, member in vars(kind).items():
            if not isinstance(member, property):
                continue
            value = getattr(result, name)
            if isinstance(value, np.ndarray):
                units = re.findall(r"\[([^\]]+)\]", member.__doc__ or "")
                found.append((name, value, units[0] if len(units) == 1 else None))
            elif hasattr(value, "to_dataframe"):
                found += arrays_of(value)
    return found


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
    each array; one with further dimensions has a column for each of their elements, as `patch_fx_0`. Codes are words."""
    pandas = imported("pandas")
    arrays = arrays_of(result)
    shape = arrays[0][1].shape
    columns = {}
    for name, array, _ in arrays:
        words = words_of(name)
        flat = array.reshape(int(np.prod(shape)), -1)
        for further in np.ndindex(array.shape[len(shape):]):
            label = "_".join([name, *map(str, further)])
            column = flat[:, np.ravel_multi_index(further, array.shape[len(shape):])] if further else flat[:, 0]
            columns[label] = pandas.Categorical.from_codes(column, words) if words else column
    return pandas.DataFrame(columns)


def to_xarray(result):
    """An xarray.Dataset with a variable for each array, on dimensions dim_0, dim_1, ... that they share (row and element
    of a field); `units` among the attributes, of codes flag_values and flag_meanings as by the CF conventions."""
    xarray = imported("xarray")
    arrays = arrays_of(result)
    shape = arrays[0][1].shape
    is_field = arrays[0][0] == "x"
    shared = ["row", "element"] if is_field and len(shape) == 2 else [f"dim_{k}" for k in range(len(shape))]
    variables = {}
    for name, array, unit in arrays:
        owner = "patch" if name.startswith("patch_") else name
        further = [f"{owner}_{k}" if array.ndim > len(shape) + 1 else owner for k in range(array.ndim - len(shape))]
        words = words_of(name)
        attributes = {"units": unit} if unit else {}
        if words:
            attributes = {"flag_values": list(range(len(words))), "flag_meanings": " ".join(words)}
        variables[name] = (shared + further, array.copy(), attributes)
    dataset = xarray.Dataset(variables)
    return dataset.set_coords(["x", "y"]) if is_field else dataset
