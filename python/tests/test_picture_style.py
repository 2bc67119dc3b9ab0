"""Colours of theories and of states are told apart by colour-blind readers; legends fit; lines scale with letters."""

import itertools
import unittest

import numpy as np

from microslip import picture_style as pictures

# Colours of linear light as those see them who lack one kind of cones (Machado, Oliveira & Fernandes 2009, severity 1).
CONES = {
    "protan": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "deutan": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "tritan": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
    "all": np.eye(3),
}
XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]])
WHITE = XYZ.sum(axis=1)


def lab(colour, cones):
    """CIE L*a*b* of an sRGB colour as it is seen."""
    code = np.array([int(colour[k:k + 2], 16) for k in (1, 3, 5)]) / 255
    linear = np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)
    part = XYZ @ np.clip(np.array(cones) @ linear, 0, 1) / WHITE
    root = np.where(part > 216 / 24389, np.cbrt(part), (24389 / 27 * part + 16) / 116)
    return np.array([116 * root[1] - 16, 500 * (root[0] - root[1]), 200 * (root[1] - root[2])])


def away(one, other, cones):
    """Distance of two colours, Delta E of 1976: 2 is just seen."""
    return float(np.linalg.norm(lab(one, cones) - lab(other, cones)))


class PictureStyleTest(unittest.TestCase):
    def test_states_are_told_apart(self):
        for name, cones in CONES.items():
            self.assertGreater(away(pictures.STICKS, pictures.SLIDES, cones), 80, name)
            self.assertGreater(away(pictures.SOFT_STICKS, pictures.SOFT_SLIDES, cones), 18, name)

    def test_theories_are_told_apart_by_colours_and_by_dashes(self):
        for one, other in itertools.combinations(("exact", "fastsim2", "table"), 2):
            for name, cones in CONES.items():
                self.assertGreater(away(pictures.LOOKS[one][0], pictures.LOOKS[other][0], cones), 18, f"{one}, {other}: {name}")
        dashes = [str(dashes) for _, dashes in pictures.LOOKS.values()]
        self.assertEqual(len(set(dashes)), len(dashes))

    def test_theories_are_neither_blue_nor_orange(self):
        for theory, (colour, _) in pictures.LOOKS.items():
            for state in (pictures.STICKS, pictures.SLIDES):
                self.assertGreater(away(colour, state, CONES["all"]), 30, theory)

    def test_components_are_told_apart(self):
        for name, cones in CONES.items():
            self.assertGreater(away(pictures.ALONG, pictures.ACROSS, cones), 30, name)

    def test_legends_are_not_wider_than_their_axes_share(self):
        for style in pictures.STYLES:
            with pictures.style(style):
                figure = pictures.new_figure(7, 4)
                panels = figure.subplots(1, 2)
                for axes in panels:
                    for number in range(4):
                        axes.plot([0, 1], label=f"a long name of curve {number}")
                    pictures.names_above(axes)
                    width = axes.get_legend().get_window_extent(figure.canvas.get_renderer()).width
                    self.assertLess(width, figure.bbox.width / 2, style)

    def test_lines_of_papers_are_thinner(self):
        with pictures.style("paper"):
            figure = pictures.new_figure(7, 4)
            (line,) = figure.subplots().plot([0, 1], linewidth=2, marker="o", markersize=5)
            pictures.scale_lines(figure, "paper")
        self.assertAlmostEqual(line.get_linewidth(), 1.2)
        self.assertAlmostEqual(line.get_markersize(), 3)

    def test_labels_of_papers_are_not_longer_than_their_axes_need(self):
        with pictures.style("paper"):
            figure = pictures.new_figure(7, 5)
            panels = figure.subplots(3, 1)
            words = "a force over what friction bears [kN]"
            for axes in panels:
                axes.set_ylabel(words)
            panels[2].set_ylabel("short [-]")
            size = panels[2].yaxis.label.get_size()
            pictures.fit_labels(figure)
            figure.draw_without_rendering()
        one, other, short = (axes.yaxis.label for axes in panels)
        self.assertEqual(one.get_text().replace("\n", " "), words)
        self.assertIn("\n", one.get_text())
        self.assertFalse(one.get_window_extent().overlaps(other.get_window_extent()))
        self.assertEqual((short.get_text(), short.get_size()), ("short [-]", size))
        self.assertEqual(pictures.in_two_lines("$a b$ [kN]"), "$a b$\n[kN]")


if __name__ == "__main__":
    unittest.main()
