"""Draws the pictures of a result file and prints their names: microslip plot RESULT.h5, or python3 -m microslip.plot RESULT.h5."""

import argparse
import contextlib
import os
import re
import signal
import sys
import threading

import matplotlib

from microslip import computed_pictures
from microslip.compared_curves import compared_curves, is_swept, require_one_kind
from microslip.comparison_picture import comparison_picture
from microslip.conicity_picture import conicity_pictures
from microslip.contact_cells import cells_of  # noqa: F401, microslip.plot.cells_of
from microslip.contact_run_pictures import cases_of_run, contact_run_pictures
from microslip.creep_curve_fit_picture import creep_curve_fit_pictures
from microslip.cut_picture import cut_picture
from microslip.difference_picture import difference_picture
from microslip.fastsim2_table1_pictures import fastsim2_table1_pictures
from microslip.fastsim2_table2_pictures import fastsim2_table2_pictures
from microslip.field_picture import FIELDS, field_map, field_surface
from microslip.frequency_response_picture import frequency_response_pictures
from microslip.interactive import view  # noqa: F401, microslip.plot.view
from microslip.measured_points_picture import measured_points_pictures
from microslip.model_problem_picture import model_problem_pictures
from microslip.models_pictures import models_pictures
from microslip.picture_style import STYLES, adapt, settings_of
from microslip.picture_style import style as in_style
from microslip.profile_picture import profile_pictures
from microslip.profiles_picture import profiles_pictures
from microslip.refinement_pictures import refinement_pictures
from microslip.result_file import DAMAGED, ResultError, ResultFile
from microslip.rolling_contact_pictures import rolling_contact_pictures
from microslip.sliced_profile_picture import sliced_profile_pictures
from microslip.solved_contacts import KINDS, read_contacts
from microslip.statistics_pictures import statistics_pictures
from microslip.subsurface_pictures import subsurface_pictures
from microslip.sweep_picture import sweep_pictures
from microslip.wheel_rail_pictures import wheel_rail_pictures
from microslip.wheelset_pictures import wheelset_pictures

ENDING = (signal.SIGINT, signal.SIGTERM)
CREEP_TABLE = b"MSCREEP"  # how the files of creep-force tables begin

FORMATS = ("pdf", "png", "svg")
SETTINGS_OF_FILES = {"pdf.fonttype": 42}  # fonts that other programs can edit

PICTURES_OF_KIND = {
    "rolling_contact": rolling_contact_pictures,
    "conicity": conicity_pictures,
    "contact_run": contact_run_pictures,
    "creep_curve_fit": creep_curve_fit_pictures,
    "fastsim2-table1": fastsim2_table1_pictures,
    "fastsim2-table2": fastsim2_table2_pictures,
    "frequency_response": frequency_response_pictures,
    "measured_points": measured_points_pictures,
    "model-problem": model_problem_pictures,
    "models": models_pictures,
    "profile": profile_pictures,
    "profiles": profiles_pictures,
    "refinement": refinement_pictures,
    "sliced_profile": sliced_profile_pictures,
    "statistics": statistics_pictures,
    "subsurface": subsurface_pictures,
    "sweep": sweep_pictures,
    "wheel_rail": wheel_rail_pictures,
    "wheelset": wheelset_pictures,
}

# The options for files with fields of contacts, and those for two bodies alone.
OPTIONS_OF_CONTACTS = ("--field", "--surface", "--cut", "--stresses", "--compare")
OPTIONS_OF_RUNS = ("--field", "--surface", "--cut", "--compare")
OPTIONS_OF_TWO_BODIES = ("--creep-curves", "--convergence")
# What is compared of wheels on rails where no field is asked for.
FIELDS_TO_COMPARE = ("pressure", "traction")

# What is drawn beside result.h5 of one case or another.
PICTURES_OF_SOLVE = {"tractions.png", "areas.png", "creep_curve.png", "history.png", "interior.png", "gap.png", "patches.png",
                     "rail_head.png", "tractions_on_profiles.png", "contact_points.png", "forces.png", "wheelset.png"}


def pictures(result):
    """Figures of an open result file, by file name."""
    kind = result.attribute("kind")
    if kind not in PICTURES_OF_KIND:
        raise ResultError(f"{result.path}: kind '{kind}' has no pictures, known: {', '.join(PICTURES_OF_KIND)}")
    return PICTURES_OF_KIND[kind](result)


def chosen_pictures(result, fields=(), surfaces=(), cut=None, spins=None, convergence=False, stresses=None, others=()):
    """Figures that are asked for, by file name: fields as maps and surfaces, cut and stresses at y [mm], on rails in each
    patch's frame; of two bodies also creep curves for spins [1/m] (empty: chosen from the contact) and convergence. With
    other open result files their curves are drawn together, with one other fields beside its own with their differences."""
    asked = {"--field": fields, "--surface": surfaces, "--cut": cut is not None, "--stresses": stresses is not None,
             "--creep-curves": spins is not None, "--convergence": convergence, "--compare": others}
    for one in (result, *others):
        check_options(one, [option for option, wanted in asked.items() if wanted])
    if result.attribute("kind") == "contact_run":
        figures = pictures_of_cases(result, () if others else fields, surfaces, cut)
        return {**figures, **(compared_pictures(result, others, fields) if others else {})}
    contacts = read_contacts(result) if (fields and not others) or surfaces or cut is not None else {}
    figures = {} if others else {f"field_{name}.png": field_map(result, contacts, name) for name in fields}
    figures.update({f"surface_{name}.png": field_surface(result, contacts, name) for name in surfaces})
    if cut is not None:
        figures["cut.png"] = cut_picture(result, contacts, cut)
    if others:
        figures.update(compared_pictures(result, others, fields))
    if spins is not None:
        figures["creep_curves.png"] = computed("creep_curves", "creep_curves_picture", result, spins)
    if convergence:
        figures["convergence.png"] = computed("convergence", "convergence_picture", result)
    if stresses is not None:
        figures.update(computed("stresses", "stresses_pictures", result, stresses))
    return figures


def compared_pictures(result, others, fields):
    """Figures of several results by file name: their curves, or of two in one state differences of fields, and of two bodies
    both side by side."""
    results = (result, *others)
    if len(others) > 1 or is_swept(result) or is_swept(others[0]):
        if fields:
            raise ResultError(f"{result.path}: --field compares two results of one state; without it their curves are compared")
        return {"compared_curves.png": compared_curves(results)}
    other, of_two_bodies = others[0], result.attribute("kind") == "rolling_contact"
    require_one_kind(results)
    if result.attribute("kind") == "contact_run":
        return compared_cases(results, fields or FIELDS_TO_COMPARE)
    fields = fields or (() if of_two_bodies else FIELDS_TO_COMPARE)
    contacts = [read_contacts(one) for one in results] if fields else []
    figures = {f"difference_{name}.png": difference_picture(results, contacts, name) for name in fields}
    if of_two_bodies:
        figures["comparison.png"] = comparison_picture(result, other)
        if all("creep_curve" in one for one in results) and not fields:
            figures["compared_curves.png"] = compared_curves(results)
    return figures


def compared_cases(results, fields):
    """Figures of fields of cases that two runs of CONTACT's files have both stored, the first ones."""
    first, second = (cases_of_run(result) for result in results)
    common = [number for number in first if number in second]
    if not common:
        raise ResultError(f"{results[1].path}: stores the elements of no case that {results[0].path} stores, too")
    pairs = {number: (first[number], second[number]) for number in common}
    return {f"difference_{name}_{number:04}.png": difference_picture(pair, [case.contacts for case in pair], name)
            for number, pair in pairs.items() for name in fields}


def pictures_of_cases(result, fields, surfaces, cut):
    """Figures of the cases of a run of CONTACT's files: fields as maps and surfaces, cuts at y [mm]."""
    figures = {}
    for number, case in cases_of_run(result).items():
        figures.update({f"field_{name}_{number:04}.png": field_map(case, case.contacts, name) for name in fields})
        figures.update({f"surface_{name}_{number:04}.png": field_surface(case, case.contacts, name) for name in surfaces})
        if cut is not None:
            figures[f"cut_{number:04}.png"] = cut_picture(case, case.contacts, cut)
    return figures


def check_options(result, options):
    """Throws for options that a file's kind does not have; says which it has."""
    kind = result.attribute("kind")
    has = OPTIONS_OF_CONTACTS + (OPTIONS_OF_TWO_BODIES if kind == "rolling_contact" else ()) if kind in KINDS else ()
    if kind in ("sweep", "conicity"):
        has = ("--compare",)
    if kind == "contact_run":
        has = OPTIONS_OF_RUNS
    wrong = [option for option in options if option not in has]
    if wrong:
        which = f"it has {', '.join(has)}" if has else "without options plot draws what it has"
        raise ResultError(f"{result.path}: {wrong[0]} is not for a file of kind '{kind}', but for "
                          f"{'contacts of two bodies' if wrong[0] in OPTIONS_OF_TWO_BODIES else 'contacts of two bodies and wheels on rails'}; {which}")


def computed(name, function, *arguments):
    """Pictures that the compiled module computes for."""
    try:
        import microslip._core  # noqa: F401, computed_pictures uses it
    except ImportError as error:
        raise ResultError(f"{name}.png needs the compiled module of microslip: {error}") from None
    try:
        return getattr(computed_pictures, function)(*arguments)
    except ValueError as error:
        raise ResultError(f"{name}.png: {error}") from None


def figures(path, style="page", **chosen):
    """The figures of a result file by file name: all of its kind, or those that are asked for, see chosen_pictures; `other`
    is the path of one more result, or a list of paths. `style`: page, paper or slides. For notebooks: figures("result.h5", fields=["pressure"])["field_pressure.png"]."""
    with contextlib.ExitStack() as files, in_style(style):
        result = files.enter_context(ResultFile(path))
        other = chosen.pop("other", None) or []
        if other:
            paths = [other] if isinstance(other, (str, os.PathLike)) else other
            chosen["others"] = [files.enter_context(ResultFile(one)) for one in paths]
        drawn = chosen_pictures(result, **chosen) if chosen else pictures(result)
        for figure in drawn.values():
            adapt(figure, style)
        return drawn


def is_creep_table(path):
    """Returns whether a file is a creep-force table."""
    try:
        with open(path, "rb") as file:
            return file.read(len(CREEP_TABLE)) == CREEP_TABLE
    except OSError:
        return False


def table_figures(path, axis_ratio=1.0, poisson_ratio=0.28, spins=(0.0, 0.5, 1.0), style="page"):
    """The picture of a creep-force table for an ellipse, by file name."""
    with in_style(style):
        try:
            import microslip
            from microslip.creep_table_picture import creep_table_picture
            table = microslip.CreepForceTable(path, poisson_ratio=poisson_ratio)
            figure = creep_table_picture(table, axis_ratio, poisson_ratio, spins)
            adapt(figure, style)
            return {"creep_table.png": figure}
        except ImportError as error:
            raise ResultError(f"creep_table.png needs the compiled module of microslip: {error}") from None
        except ValueError as error:
            raise ResultError(str(error)) from None


def end_early(_number, _frame):
    """Ends the process from within Python, once."""
    for number in ENDING:
        signal.signal(number, signal.SIG_IGN)
    sys.exit(130)


@contextlib.contextmanager
def ending_from_within():
    """Lets what Ctrl-C and SIGTERM end clean up behind itself. Elsewhere they end the program of pictures at once, also
    in the middle of the work of other libraries."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = {number: signal.signal(number, end_early) for number in ENDING}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def save(figure, path, dpi, metadata):
    """Writes a picture, of the format that its name ends with, under another name first, so that a file with the final name is
    always whole."""
    form = os.path.splitext(path)[1][1:]
    unfinished = f"{path}.{os.getpid()}.unfinished"
    with ending_from_within():
        try:
            figure.savefig(unfinished, format=form, dpi=dpi, metadata=metadata_of(form, *metadata))
            os.replace(unfinished, path)
        except BaseException:
            if os.path.exists(unfinished):
                os.remove(unfinished)
            raise


def require_formats(formats):
    """Refuses formats of files that there are not."""
    for form in formats:
        if form not in FORMATS:
            raise ResultError(f"--format {form}: must be one of {', '.join(FORMATS)}")


def metadata_of(form, title, source):
    """What a file says of itself: title and program, no time."""
    return {"Title": title, **{"png": {"Software": source}, "pdf": {"Creator": source, "CreationDate": None},
                               "svg": {"Creator": source, "Date": None}}[form]}


def remove_older(folder, drawn):
    """Removes the pictures that an earlier case of `solve` left in the folder and that this one does not have."""
    of_patches = {name for name in os.listdir(folder) if re.fullmatch(r"interior_\d+\.png", name)}
    for name in (PICTURES_OF_SOLVE | of_patches) - set(drawn):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, "rb") as file:
                is_ours = b"tEXtSoftware\0microslip " in file.read(1000)
            if is_ours:
                os.remove(path)


def draw(path, folder, chosen, formats=("png",), dpi=None, style="page"):
    """Draws all pictures of a result file, or those that are asked for, into a folder and prints their paths. Where all of
    result.h5 are drawn beside it none of an earlier case stays."""
    if is_creep_table(path):
        save_all(table_figures(path, style=style, **chosen), folder, formats, dpi, ("creep-force table", "microslip"), style)
        return
    with ResultFile(path) as result:
        source = f"microslip {result.attribute('version', '')} ({result.attribute('commit', '')})"
        metadata = (result.attribute("title", ""), source)
    drawn = figures(path, style, **chosen)
    save_all(drawn, folder, formats, dpi, metadata, style)
    if not chosen and os.path.basename(path) == "result.h5" and os.path.samefile(folder, os.path.dirname(path) or "."):
        remove_older(folder, drawn)


def save_all(drawn, folder, formats, dpi, metadata, style="page"):
    """Writes pictures into a folder, in each format, and prints their paths. `metadata`: title and program."""
    try:
        os.makedirs(folder, exist_ok=True)
    except FileExistsError:
        raise ResultError(f"{folder}: is a file, no folder for pictures") from None
    with matplotlib.rc_context({**settings_of(style), **SETTINGS_OF_FILES}):
        for name, figure in drawn.items():
            for form in formats:
                target = os.path.join(folder, f"{os.path.splitext(name)[0]}.{form}")
                save(figure, target, dpi or matplotlib.rcParams["savefig.dpi"], metadata)
                print(target, flush=True)


def numbers(text):
    """Numbers between commas."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ResultError(f"spins '{text}': must be numbers between commas, e.g. 0,0.2,0.4") from None


def parse(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(prog="python3 -m microslip.plot", description="Draws the pictures of a result file, or the pictures "
                                     "of two bodies, or of wheels on rails, that the options ask for.")
    parser.add_argument("result", metavar="RESULT.h5", help="a file written by microslip")
    parser.add_argument("-o", "--output", metavar="DIR", help="folder for the pictures (default: beside RESULT.h5)")
    parser.add_argument("--format", metavar="FORMAT", action="append", default=[],
                        help=f"of the files: {', '.join(FORMATS)}; may be given again (default: png)")
    parser.add_argument("--style", default="page", help=f"sizes of letters and pictures: {', '.join(STYLES)}")
    parser.add_argument("--dpi", type=int, help="pixels in an inch of PNG (default: 150, paper 300, slides 200)")
    parser.add_argument("--field", metavar="NAME", action="append", default=[], help=f"a field as a map: {', '.join(FIELDS)}")
    parser.add_argument("--surface", metavar="NAME", action="append", default=[], help="a field as a surface")
    parser.add_argument("--cut", metavar="Y", type=float, help="tractions with their bound and slip along the row at y [mm]")
    parser.add_argument("--creep-curves", metavar="SPINS", type=numbers,
                        help="Fx and Fy over the longitudinal creepage by both theories, for spins [1/m], e.g. 0,0.2,0.4")
    parser.add_argument("--convergence", action="store_true", help="errors of the exact theory over the number of elements")
    parser.add_argument("--stresses", metavar="Y", type=float, help="stresses inside both bodies in the plane of y [mm]")
    parser.add_argument("--compare", metavar="OTHER.h5", action="append", help="this result beside another; may be given again for curves")
    parser.add_argument("--axis-ratio", metavar="A/B", type=float, help="of a creep-force table: semi-axis along x over that along y")
    parser.add_argument("--poisson-ratio", metavar="NU", type=float, help="of a creep-force table: Poisson's ratio")
    parser.add_argument("--spins", metavar="SPINS", type=numbers,
                        help="of a creep-force table: spins, scaled with G (a b)^(3/2)/(mu Fn), e.g. 0,0.5,1")
    return parser.parse_args(arguments)


def choice(options):
    """The pictures that the command line asks for, as arguments of chosen_pictures; none: all of the file's kind."""
    asked = {"fields": options.field, "surfaces": options.surface, "cut": options.cut, "spins": options.creep_curves,
             "convergence": options.convergence, "stresses": options.stresses, "other": options.compare}
    of_table = {"axis_ratio": options.axis_ratio, "poisson_ratio": options.poisson_ratio, "spins": options.spins}
    is_table = is_creep_table(options.result)
    asked, others = (of_table, asked) if is_table else (asked, of_table)
    if any(value is not None and value is not False and value != [] for value in others.values()):
        what = "a creep-force table has only" if is_table else "no creep-force table, which alone has"
        raise ResultError(f"{options.result}: {what} --axis-ratio, --poisson-ratio and --spins")
    return {name: value for name, value in asked.items() if value is not None and value is not False and value != []}


def main(arguments=None):
    """The command line; returns the exit code: 0, or 2 for a file that cannot be drawn."""
    options = None
    try:
        options = parse(arguments)
        require_formats(options.format)
        draw(options.result, options.output or os.path.dirname(options.result) or ".", choice(options),
             dict.fromkeys(options.format or ["png"]), options.dpi, options.style)
    except (ResultError, OSError) as error:
        print(f"microslip.plot: {error}", file=sys.stderr)
        return 2
    except Exception as error:  # numbers of which pictures can make nothing
        if options is None:
            raise
        print(f"microslip.plot: {options.result}: cannot be drawn, {type(error).__name__}: {' '.join(str(error).split())}; the file is "
              f"perhaps {DAMAGED}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    for each in ENDING:
        signal.signal(each, signal.SIG_DFL)
    sys.exit(main())
