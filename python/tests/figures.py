"""Helpers of the tests of pictures."""

import tempfile
from pathlib import Path

import matplotlib
import numpy as np

from microslip import plot
from microslip.picture_style import SETTINGS
from microslip.result_file import ResultFile


def figures_of(path):
    """The figures of a result file, by the names of their files."""
    with ResultFile(path) as result, matplotlib.rc_context(SETTINGS):
        return plot.pictures(result)


def title_of(figure):
    """The title of a figure with its explanation."""
    return "\n".join([figure._suptitle.get_text().strip(), *(text.get_text() for text in figure.artists)])


def shown_at(axes, x, y):
    """The values of the pixels of a picture's first image at points, those beyond it as at its edge."""
    image = axes.images[0]
    values, (left, right, low, high) = np.asarray(image.get_array()), image.get_extent()
    column, row = (np.clip(np.round((at - first) / (last - first) * (count - 1)), 0, count - 1).astype(int)
                   for at, first, last, count in ((x, left, right, values.shape[1]), (y, low, high, values.shape[0])))
    return values[row, column]


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
