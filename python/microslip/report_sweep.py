"""Tables of a sweep for its report: ranges of all quantities, and the cases."""

import numpy as np

from microslip.picture_style import shown, unit_for

# What the table of cases shows, where a sweep has it.
SHOWN = {"contact/fx": "Fx", "contact/fy": "Fy", "contact/mz": "Mz", "contact/slip_area": "slip area", "wheel/force_x": "Fx",
         "wheel/force_y": "Fy", "wheel/force_z": "Fz", "wheel/y_over_q": "Y/Q", "wheel/frictional_power": "power",
         "patches/0/peak_pressure": "p max", "wheelset/force_y": "Fy", "wheelset/moment_z": "Mz", "wheelset/frictional_power": "power"}
GROUPS = ("contact", "wheelset", "wheel", "left/wheel", "right/wheel", *(f"patches/{k}" for k in range(10)))
ROUNDING = 1e-13  # in parts of the largest number
CODES = ("status", "warning_code", "iterations", "patch_count")


def sweep_tables(result):
    """The ranges and the cases of a sweep."""
    numbers = [name for name in result.numbers_of(GROUPS) if not name.endswith(CODES)]
    return [ranges(result, numbers), cases(result)]


def ranges(result, names):
    """Least and largest value of each quantity."""
    rows = []
    for name in names:
        values = result.array(name, finite=False)
        known = values[np.isfinite(values)]
        if known.size == 0:
            continue
        factor, unit = unit_for(np.max(np.abs(known)), result.unit(name))
        least, mean, largest = factor * shown(np.array([known.min(), known.mean(), known.max()]), np.max(np.abs(known)), ROUNDING)
        rows.append({"name": name, "values": [f"{least:.6g}", f"{mean:.6g}", f"{largest:.6g}", str(known.size)], "unit": unit, "remark": ""})
    return {"title": "Ranges over all cases", "heads": ["least", "mean", "largest", "cases"], "rows": rows}


def cases(result):
    """A row for each case: what varies, main quantities, status."""
    names = [name for name in result.attribute("parameters").split("\n") if name]
    columns = [column(result, f"parameters/{name}", name) for name in names]
    columns += [column(result, name, head) for name, head in SHOWN.items() if name in result]
    return {"title": "Cases", "columns": columns}


def column(result, name, head):
    """A column in a unit that suits its largest number."""
    if not result.is_number(name):
        return {"head": head, "unit": "", "cells": [result.entry(name, k) for k in range(result.shape(name)[0])]}
    values = result.array(name, finite=False)
    known = np.abs(values[np.isfinite(values)])
    most = known.max() if known.size else 0
    values = shown(values, most, ROUNDING)
    factor, unit = unit_for(most, result.unit(name))
    return {"head": head, "unit": unit, "cells": ["none" if np.isnan(value) else f"{factor * value:.6g}" for value in values]}
