"""Pictures that look the same are the same, others are told apart; every picture of the pages has a command that draws it."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy as np
from images import IMAGES, ROOT, SOURCES, TOLERANCE, difference
from matplotlib.figure import Figure


class ImagesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def drawn(self, name, height, title, size=(6, 4)):
        figure = Figure(figsize=size)
        axes = figure.subplots()
        x = np.linspace(0, 1, 50)
        axes.fill_between(x, height * np.sqrt(x))
        axes.set_xlim(0, 1)
        axes.set_ylim(0, 2)
        axes.set_title(title)
        figure.savefig(self.folder / name, dpi=100)
        return self.folder / name

    def test_other_curves_are_seen_and_a_last_digit_is_not(self):
        one = self.drawn("one.png", 1.0, "force 17.48")
        self.assertEqual(difference(one, one), 0)
        self.assertLess(difference(one, self.drawn("digit.png", 1.0, "force 17.49")), TOLERANCE)
        self.assertGreater(difference(one, self.drawn("other.png", 1.1, "force 17.48")), TOLERANCE)
        self.assertEqual(difference(one, self.drawn("wide.png", 1.0, "force 17.48", (7, 4))), np.inf)

    def test_every_picture_has_its_command(self):
        drawn = [picture for source in SOURCES for picture in source.pictures]
        self.assertEqual(len(set(drawn)), len(drawn))
        self.assertEqual(set(drawn), {path.name for path in IMAGES.glob("*.png")})

    def test_every_picture_is_on_a_page(self):
        pages = "".join(page.read_text() for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))])
        shown = set(re.findall(r"images/(\w+\.png)", pages))
        self.assertLessEqual(shown, {path.name for path in IMAGES.glob("*.png")})


if __name__ == "__main__":
    unittest.main()
