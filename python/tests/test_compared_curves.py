"""Curves of several results in one picture are those of their files; what has no common axis is refused with the way round."""

import h5py
import numpy as np

from microslip import plot
from microslip.result_file import ResultError
from tests.synthetic_results import write_rolling_contact
from tests.test_conicity_picture import write_conicity
from tests.test_plot import FolderTest
from tests.test_sweep_picture import write_sweep
from tests.test_wheel_rail_pictures import write_wheel_rail
from tests.test_wheelset_pictures import write_wheelset


class ComparedCurvesTest(FolderTest):
    def paths(self, write, *changes, **what):
        """Files that `write` makes, with names of their own, each then changed."""
        found = []
        for number, change in enumerate(changes):
            found.append(str(self.folder / f"{number}.h5"))
            write(found[-1], **what)
            with h5py.File(found[-1], "a") as file:
                file.attrs["title"] = f"result {number}"
                change(file)
        return found

    def panels(self, paths):
        (figure,) = plot.figures(paths[0], other=paths[1:]).values()
        return figure.axes

    def refused(self, paths, words, **what):
        with self.assertRaisesRegex(ResultError, words):
            plot.figures(paths[0], other=paths[1:], **what)

    def test_creep_curves_of_three_contacts(self):
        paths = self.paths(write_rolling_contact, *[lambda file: None] * 3)
        for number, path in enumerate(paths):
            with h5py.File(path, "a") as file:
                file["creep_curve/fastsim2/fx"][...] *= 1 + 0.1 * number
        panels = self.panels(paths)
        for path, line in zip(paths, panels[0].lines[1:]):
            with h5py.File(path) as file:
                np.testing.assert_allclose(line.get_ydata(), 1e-3 * file["creep_curve/fastsim2/fx"][()], atol=1e-9)
        self.assertEqual([text.get_text() for text in panels[0].get_legend().get_texts()],
                         [f"result {number}, FASTSIM2" for number in range(3)])
        self.assertEqual(list(plot.figures(paths[0], other=paths[1])), ["comparison.png", "compared_curves.png"])

    def test_results_of_one_title_are_called_by_their_files(self):
        paths = self.paths(write_rolling_contact, *[lambda file: file.attrs.update(title="one")] * 3)
        labels = [text.get_text() for text in self.panels(paths)[0].get_legend().get_texts()]
        self.assertEqual(labels, [f"{path}, FASTSIM2" for path in paths])

    def test_sweeps(self):
        def double(file):
            file["contact/fx"][...] *= 2

        paths = self.paths(write_sweep, lambda file: None, double, shape=(2, 4))
        (axes,) = self.panels(paths)
        curves = {line.get_label(): line.get_ydata() for line in axes.lines[1:]}
        np.testing.assert_allclose(curves["result 0, a.word = two"], [0.001, 1.001, 2.001, np.nan])
        np.testing.assert_allclose(curves["result 1, a.word = one"], [0, 2, 4, 6])

    def test_wheels_wheelsets_and_conicities(self):
        def shift(file):
            for name in ("wheel/force_y", "left/wheel/force_y", "gauge_0/conicity"):
                if name in file:
                    file[name][...] += 1000

        for write, what, axis, name in ((write_wheel_rail, {"states": 5}, 1, "wheel/force_y"),
                                        (write_wheelset, {"states": 5}, 0, "left/wheel/force_y")):
            paths = self.paths(write, lambda file: None, shift, **what)
            lines = self.panels(paths)[axis].lines
            for path in paths:
                with h5py.File(path) as file:
                    wanted = 1e-3 * file[name][()]
                self.assertTrue(any(np.allclose(line.get_ydata(), wanted) for line in lines if len(line.get_ydata()) == 5), f"{name} of {path}")
        paths = self.paths(write_conicity, lambda file: None, shift, gauges=[1.435])
        first, second = (line.get_ydata() for line in self.panels(paths)[0].lines)
        np.testing.assert_allclose(second, first + 1000)
        self.assertTrue(np.isfinite(first).any())

    def test_what_cannot_be_compared_is_refused_with_the_way_round(self):
        def over_spin(file):
            file["creep_curve"].attrs["variable"] = "spin"

        contacts = self.paths(write_rolling_contact, lambda file: None, over_spin, lambda file: None)
        self.refused(contacts, "1.h5: is over spin, .*0.h5 over creepage_longitudinal; sweep both over one creepage")
        self.refused(contacts, "--field compares two results of one state", fields=["px"])
        sweep = str(self.folder / "sweep.h5")
        write_sweep(sweep, shape=(2, 4))
        self.refused([sweep, contacts[0]], "0.h5: is of kind 'rolling_contact', .*sweep.h5 of kind 'sweep': .*--points POINTS.csv")
        points = str(self.folder / "list.h5")
        write_sweep(points)
        self.refused([sweep, points], "list.h5: has curves only as a grid")
        one_state = str(self.folder / "rail.h5")
        write_wheel_rail(one_state)
        self.refused([one_state] * 3, "rail.h5: is of one state; .* give --compare once")
