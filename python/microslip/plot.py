"""Draws the pictures of a result file and prints their names: python3 -m microslip.plot RESULT.h5 [-o DIR]."""

import argparse
import os
import sys

import matplotlib

from microslip.fastsim2_table1_pictures import fastsim2_table1_pictures
from microslip.fastsim2_table2_pictures import fastsim2_table2_pictures
from microslip.model_problem_picture import model_problem_pictures
from microslip.picture_style import SETTINGS
from microslip.refinement_pictures import refinement_pictures
from microslip.result_file import ResultError, ResultFile
from microslip.rolling_contact_pictures import rolling_contact_pictures
from microslip.subsurface_pictures import subsurface_pictures

PICTURES_OF_KIND = {
    "rolling_contact": rolling_contact_pictures,
    "fastsim2-table1": fastsim2_table1_pictures,
    "fastsim2-table2": fastsim2_table2_pictures,
    "model-problem": model_problem_pictures,
    "refinement": refinement_pictures,
    "subsurface": subsurface_pictures,
}


def pictures(result):
    """Figures of an open result file, by file name."""
    kind = result.attribute("kind")
    if kind not in PICTURES_OF_KIND:
        raise ResultError(f"{result.path}: kind '{kind}' has no pictures, known: {', '.join(PICTURES_OF_KIND)}")
    return PICTURES_OF_KIND[kind](result)


def save(figure, path, metadata):
    """Writes a picture under another name first, so that a file with the final name is always whole."""
    unfinished = f"{path}.{os.getpid()}.unfinished"
    try:
        figure.savefig(unfinished, format="png", metadata=metadata)
        os.replace(unfinished, path)
    except BaseException:
        if os.path.exists(unfinished):
            os.remove(unfinished)
        raise


def draw(path, folder):
    """Draws all pictures of a result file into a folder and prints their paths."""
    with ResultFile(path) as result, matplotlib.rc_context(SETTINGS):
        figures = pictures(result)
        source = f"microslip {result.attribute('version', '')} ({result.attribute('commit', '')})"
        metadata = {"Title": result.attribute("title", ""), "Software": source}
        os.makedirs(folder, exist_ok=True)
        for name, figure in figures.items():
            target = os.path.join(folder, name)
            save(figure, target, metadata)
            print(target, flush=True)


def main(arguments=None):
    """The command line; returns the exit code: 0, or 2 for a file that cannot be drawn."""
    parser = argparse.ArgumentParser(prog="python3 -m microslip.plot",
                                     description="Draws the pictures of a result file.")
    parser.add_argument("result", metavar="RESULT.h5", help="a file written by microslip")
    parser.add_argument("-o", metavar="DIR", dest="folder", help="folder for the pictures (default: beside RESULT.h5)")
    options = parser.parse_args(arguments)
    try:
        draw(options.result, options.folder or os.path.dirname(options.result) or ".")
    except (ResultError, OSError) as error:
        print(f"microslip.plot: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
