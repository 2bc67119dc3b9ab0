"""Helpers of the tests of pictures."""

import tempfile
from pathlib import Path

import matplotlib

from microslip import plot
from microslip.picture_style import SETTINGS
from microslip.result_file import ResultFile


def figures_of(path):
    """The figures of a result file, by the names of their files."""
    with ResultFile(path) as result, matplotlib.rc_context(SETTINGS):
        return plot.pictures(result)


def figures_written_by(write, *arguments, **named):
    """Figures of the file that `write` makes at a path."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "result.h5"
        write(path, *arguments, **named)
        return figures_of(path)


def written_for(test, write):
    """The path of the file that `write` makes at it, until the test ends."""
    folder = tempfile.TemporaryDirectory()
    test.addCleanup(folder.cleanup)
    path = Path(folder.name) / "result.h5"
    write(path)
    return path
