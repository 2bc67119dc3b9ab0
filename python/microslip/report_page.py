"""The page of a report: what a document and a result file hold, set by the template report.html."""

import datetime
import hashlib
import io
import json
import os
from pathlib import Path

import matplotlib
from markupsafe import Markup

from microslip import plot
from microslip.contact_cells import read_cells
from microslip.picture_style import INK, SETTINGS, THEORIES, new_figure, open_axes
from microslip.report_checks import checks
from microslip.report_sweep import sweep_tables
from microslip.report_template import FOLDER, address, environment, is_number, template_name
from microslip.result_file import ResultFile
from microslip.rolling_contact_pictures import tractions_picture

RESOLUTION = 200  # pixels in an inch of a picture
TEXT_WIDTH = 7.24  # inches of a printed page
# Pictures on the page: their scale, and that of those higher than so many inches, of which two fit a page.
SCALE, SCALE_OF_TALL, TALL = 0.58, 0.46, 7.0
# Of two bodies, whose report is one page: the pictures stand side by side, at most so high on it, and the creep curve is
# drawn smaller [inches].
SCALE_OF_BODIES, HIGHEST, CREEP_CURVE = 0.52, 3.2, (6.8, 5.5)
BODIES = ("rail", "wheel", "left_rail", "right_rail", "left_wheel", "right_wheel")
# Rows of the printed tables that are errors of the method, not results.
ERRORS = ("discretisation error", "estimated error", "residual", "largest residual")
WIDE_FROM = 4  # columns of numbers that do not fit half a page
LONGEST_VALUE = 24  # letters
MOST_STATES = 200  # rows of a table of states; of more it shows one of each two, three, ...

EXACT = ("Exact theory: elastic half-spaces, without a further assumption on tractions or on the shape of the contact. What is left is the "
         "error of the grid, below.")
SIMPLIFIED = ("Simplified theory: the displacement at a point follows from the traction there alone. Its error is that of the theory, which "
              "more cells do not lessen; the exact theory is the measure.")
# What a theory assumes.
METHODS = {
    "exact": [EXACT],
    "table": ["Creep-force table: forces of the exact theory for ellipses, interpolated; no tractions. Errors are those of the interpolation "
              "and of taking the contact for an ellipse."],
    "fastsim": [SIMPLIFIED], "fastsim_half_step": [SIMPLIFIED], "fastsim2": [SIMPLIFIED],
    "fastrip": ["FaStrip: strips of the exact two-dimensional theory side by side, for ellipses."],
}
# What all leave out.
LIMITS = ("Bodies are half-spaces at the scale of the contact, which is to be small beside radii and the distance to the next edge, unless "
          "they have layers.",
          "Linear elasticity: nothing yields. Smooth surfaces, dry friction by the law and the coefficient given.",
          "Quasi-static: no inertia of the material.")
LIMITS_ON_RAILS = ("Wheel and rail are placed as rigid bodies; axle, wheel and rail do not bend.",
                   "The error of the grid is not estimated for wheels on rails: solution.grid of twice as many elements tells it.")


def write(document, output, form, template):
    """Writes the report of a document's file."""
    with open(document, encoding="utf-8") as file:
        page = html(json.load(file), template)
    if form == "html":
        with open(output, "w", encoding="utf-8") as file:
            file.write(page)
        return
    os.environ.setdefault("SOURCE_DATE_EPOCH", "0")  # what fonts in the file say of their time
    import weasyprint
    weasyprint.HTML(string=page).write_pdf(output)


def html(document, template=""):
    """The page as text."""
    with ResultFile(document["result_file"]) as result:
        values = page_values(document, result)
    with matplotlib.rc_context({**SETTINGS, "savefig.dpi": RESOLUTION}):
        values["pictures"] = pictures(document)
    return environment(template).get_template(template_name(template)).render(values)


def page_values(document, result):
    """What the template shows."""
    is_sweep = document["kind"] == "sweep"
    tables = sweep_tables(result) if is_sweep else document["tables"]
    results, errors = apart(tables)
    inputs = document.get("inputs", [])
    given = sorted((row for row in inputs if row["line"] is not None), key=lambda row: row["line"])
    title = result.attribute("title", "") or Path(document["case_file"]).stem.replace("_", " ")
    return {
        "title": title,
        "purpose": document["purpose"],
        "facts": facts(document, result),
        "verdict": verdict(document, result),
        "reason": failed(document, result),
        "warnings": warnings(document, result),
        "inputs": [described(row) for row in given],
        "defaults": [row for row in inputs if row["line"] is None],
        "method": [] if is_sweep else method(document, result),
        "tables": results,
        "has_narrow": any(not table["is_wide"] for table in results),
        "errors": errors,
        "checks": checks(result),
        "listings": [listing(name) for name in document["files"] if name.endswith(".toml")] if is_sweep else [],
        "files": [{"name": name, "sha256": hashlib.sha256(Path(name).read_bytes()).hexdigest()} for name in document["files"]],
        "style": Markup((FOLDER / "report.css").read_text(encoding="utf-8")),
        **{name: document[name] for name in ("version", "commit", "compiler", "build_type", "command_line")},
    }


def facts(document, result):
    """Lines below the title."""
    rows = [("case", document["case_file"])]
    date = document["date"] or epoch_date()
    if date:
        rows.append(("date", date))
    rows.append(("program", f"microslip {document['version']}, commit {document['commit']}"))
    for body in BODIES:
        if f"profiles/{body}" in result:
            points = result.shape(f"profiles/{body}/y")[0]
            rows.append((f"profile of the {body.replace('_', ' ')}", f"{result.group_attribute(f'profiles/{body}', 'source')}, {points} points"))
    return rows


def epoch_date():
    """Date that SOURCE_DATE_EPOCH tells, or nothing."""
    seconds = os.environ.get("SOURCE_DATE_EPOCH", "")
    return datetime.datetime.fromtimestamp(int(seconds), datetime.timezone.utc).date().isoformat() if seconds.isdigit() else ""


def failed(document, result):
    """Why the result is not one; empty if it is."""
    if document["kind"] != "sweep":
        return document["reason"]
    count = result.shape("failures/case")[0]
    return f"{count} of the cases have another status than ok" if count else ""


def verdict(document, result):
    """How it ended, in a sentence."""
    reason = failed(document, result)
    if reason:
        return f"Not solved: {reason}." if document["kind"] != "sweep" else f"Not all solved: {reason}."
    return "All cases are solved." if document["kind"] == "sweep" else "Solved: the status of all results is ok."


def warnings(document, result):
    """Doubts about the results."""
    if document["kind"] != "sweep":
        return document["warnings"]
    return [line for line in result.attribute("warnings", "\n").split("\n") if line]


def method(document, result):
    """The theory, what it assumes of this case, and what every theory here leaves out."""
    lines = list(METHODS.get(document["theory"], []))
    for group in ("hertz", *THEORIES):
        if result.assumption(group):
            name = "Hertz's ellipse" if group == "hertz" else THEORIES[group]
            lines.append(f"{name} is of {result.assumption(group)}.")
    on_rails = document["kind"] in ("wheel_rail", "wheelset")
    return [*lines, *LIMITS, *(LIMITS_ON_RAILS if on_rails else ())]


def described(row):
    """A row of inputs: words are set as texts."""
    return {**row, "is_text": not row["unit"] and not is_number(row["value"])}


def apart(tables):
    """Tables of results, and those of errors, which have the rows that are none of results."""
    results, errors = [], []
    for table in tables:
        if "columns" in table:
            results.append({**thinned(table), "is_wide": True})
            continue
        rows = [laid_out(row, table) for row in table["rows"]]
        wrong = [row for row in rows if row["name"].startswith(ERRORS)]
        rest = [row for row in rows if not row["name"].startswith(ERRORS)]
        results.append({**table, "heads": heads(table), "rows": rest, "is_wide": len(table["heads"]) >= WIDE_FROM})
        if wrong:
            errors.append({**table, "title": "", "heads": heads(table), "rows": wrong})
    return results, errors


def heads(table):
    """Heads of a table's columns, where there are several."""
    return table["heads"] if len(table["heads"]) > 1 else []


def laid_out(row, table):
    """A row of a table with a value for each column, those that are not there empty; long texts stand below, as remarks."""
    columns = max(1, len(table["heads"]))
    values = row["values"] + [""] * (columns - len(row["values"]))
    if row["unit"] == "" and len(values[0]) > LONGEST_VALUE:
        return {**row, "values": [""] * columns, "remark": values[0]}
    return {**row, "values": values}


def thinned(table):
    """A table of states with at most MOST_STATES rows."""
    step = -(-len(table["columns"][0]["cells"]) // MOST_STATES)
    if step == 1:
        return table
    columns = [{**column, "cells": column["cells"][::step]} for column in table["columns"]]
    return {**table, "title": f"{table['title']}: one of each {step}", "columns": columns}


def listing(name):
    """Text of a file, line by line."""
    return {"name": name, "lines": Path(name).read_text(encoding="utf-8", errors="replace").splitlines()}


def pictures(document):
    """The pictures of the result as parts of the page, all to about one scale."""
    found = plot.figures(document["result_file"])
    found.pop("friction_law.png", None)  # which the inputs tell
    is_of_bodies = document["kind"] == "rolling_contact"
    with ResultFile(document["result_file"]) as result:
        if "tractions.png" in found:
            found.pop("areas.png", None)  # whose border the tractions show
            theory = document["theory"]
            found["tractions.png"] = tractions_picture(result, {theory: read_cells(result, theory)})
        if "gap.png" not in found and "profiles" in result:
            found = {"profiles.png": profiles_picture(result), **found}
    if is_of_bodies and "creep_curve.png" in found:
        found["creep_curve.png"].set_size_inches(*CREEP_CURVE)
    shown = []
    for name, figure in found.items():
        width, height = figure.get_size_inches()
        scale = SCALE if height < TALL else SCALE_OF_TALL
        if is_of_bodies:
            scale = min(SCALE_OF_BODIES, HIGHEST / height)
        shown.append({"name": Path(name).stem.replace("_", " "), "address": address(png(figure), name),
                      "percent": f"{min(100.0, 100 * scale * width / TEXT_WIDTH):.1f}"})
    return shown


def profiles_picture(result):
    """The profiles that were read, each in its own axes."""
    names = [name for name in BODIES if f"profiles/{name}" in result]
    figure = new_figure(2.8 * max(2, len(names)), 2.4)
    for axes, name in zip(figure.subplots(1, len(names), squeeze=False)[0], names):
        axes.plot(*(1e3 * result.array(f"profiles/{name}/{axis}") for axis in "yz"), color=INK, linewidth=1.2)
        axes.set_title(name.replace("_", " "))
        axes.set_aspect("equal", adjustable="datalim")
        axes.set_xlabel("y [mm]")
        axes.set_ylabel("z [mm], up")
        open_axes(axes)
    return figure


def png(figure):
    """A figure's bytes, the same each time."""
    text = io.BytesIO()
    figure.savefig(text, format="png", metadata={"Software": None})
    return text.getvalue()
