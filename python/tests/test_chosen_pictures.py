"""Pictures that are asked for: maps, surfaces, cuts, comparisons show the file's numbers; wishes that cannot be met are named."""

import os
import subprocess
import sys
import unittest

import h5py
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from microslip import plot
from microslip.result_file import ResultError
from tests.synthetic_results import write_contact_run, write_rolling_contact
from tests.figures import shown_at, title_of
from tests.test_plot import PYTHON_FOLDER, FolderTest


class ChosenPicturesTest(FolderTest):
    def setUp(self):
        super().setUp()
        write_rolling_contact(self.path, theories=("fastsim2", "exact"))

    def chosen(self, **wanted):
        (figure,) = plot.figures(self.path, **wanted).values()
        return figure

    def test_command_line(self):
        arguments = ("--field", "px", "--field=power", "--surface", "slip", "--cut=-1.5", "--compare", self.path)
        code, out, err = self.run_plot(self.path, "-o", self.folder / "p", *arguments)
        self.assertEqual((code, err), (0, []))
        names = ["surface_slip.png", "cut.png", "difference_px.png", "difference_power.png", "comparison.png"]
        self.assertEqual(out, [str(self.folder / "p" / name) for name in names])

    def test_maps_have_the_files_values(self):
        with h5py.File(self.path) as file:
            fields = {name: file[f"/fastsim2/fields/{name}"][()] for name in ("px", "py", "sx", "sy", "bound")}
            centres = [1e3 * file[f"/fastsim2/fields/{name}"][()] for name in "xy"]
        power = -2e-6 * (fields["px"] * fields["sx"] + fields["py"] * fields["sy"])
        wanted = {"px": 1e-6 * fields["px"], "traction": 1e-6 * np.hypot(fields["px"], fields["py"]),
                  "slip": 1e3 * np.hypot(fields["sx"], fields["sy"]), "power": power, "bound": 1e-6 * fields["bound"]}
        for name, values in wanted.items():
            drawn = shown_at(self.chosen(fields=[name]).axes[0], *centres)
            away = np.abs(drawn - values) / np.abs(values).max()
            self.assertLess(np.median(away), 0.01)
            # Beside the border of slip it is smoothed by a part of an element.
            self.assertGreater(np.mean(away < 0.06), 0.85)

    def test_colours_are_about_zero_where_both_signs_occur(self):
        def limits(name):
            return self.chosen(fields=[name]).axes[0].images[0].norm

        with h5py.File(self.path, "a") as file:
            for theory in ("fastsim2", "exact"):
                file[f"{theory}/fields/px"][...] = -np.abs(file[f"{theory}/fields/px"])
                file[f"{theory}/fields/sy"][...] = file[f"{theory}/fields/x"]
        sy, px, slip = limits("sy"), limits("px"), limits("slip")
        self.assertEqual(sy.vmin, -sy.vmax)
        self.assertEqual(px.vmax, 0)
        self.assertLess(px.vmin, 0)
        self.assertEqual(slip.vmin, 0)

    def test_surfaces_have_the_height_of_the_values(self):
        figure = self.chosen(surfaces=["traction"])
        with h5py.File(self.path) as file:
            largest = 1e-6 * np.hypot(file["/exact/fields/px"], file["/exact/fields/py"]).max()
        for axes in figure.axes[:2]:
            self.assertTrue(any(isinstance(part, Poly3DCollection) for part in axes.collections))
            self.assertEqual(axes.get_zlim()[0], 0)
            self.assertAlmostEqual(axes.get_zlim()[1], largest, delta=0.1 * largest)

    def test_cuts_stay_within_the_bound(self):
        figure = self.chosen(cut=2.0)
        above = figure.axes[0]
        lines = {line.get_label(): line.get_xydata() for line in above.lines}
        with h5py.File(self.path) as file:
            y = file["/fastsim2/fields/y"][:, 0]
            row = np.argmin(abs(y - 2e-3))
            np.testing.assert_allclose(lines["$p_x$"][:, 1], 1e-6 * file["/fastsim2/fields/px"][row])
        self.assertIn("y = 2 mm", above.get_title(loc="left"))
        self.assertTrue(np.all(lines[r"$|\mathbf{p}|$"][:, 1] <= lines[r"$\pm g$, the bound"][:, 1] * (1 + 1e-9)))

    def test_comparison_has_the_totals_of_both(self):
        other = self.folder / "other.h5"
        write_rolling_contact(other, creepage=(0.003, 0, 0))
        figure = plot.figures(self.path, other=other)["comparison.png"]
        self.assertIn("motion.creepage_longitudinal = 0.001 (A), 0.003 (B)", title_of(figure.subfigs[0]))
        table = next(axes.tables[0] for part in figure.subfigs for axes in part.axes if axes.tables)
        cells = {position: cell.get_text().get_text() for position, cell in table.get_celld().items()}
        numbers = [[float(cells[row, column].split()[0].replace("\N{MINUS SIGN}", "-")) for column in (1, 2, 3)]
                   for row in range(1, 6)]
        for one, two, difference in numbers:
            self.assertAlmostEqual(two - one, difference, delta=2e-3 * (abs(one) + abs(two)))
        with h5py.File(other) as file:
            self.assertAlmostEqual(numbers[0][1], 1e-3 * file["/fastsim2/fx"][()], delta=0.01)

    def test_differences_are_those_of_the_files(self):
        other = self.folder / "other.h5"
        write_rolling_contact(other, creepage=(0.003, 0, 0), theories=("fastsim2", "exact"))
        figure = plot.figures(self.path, fields=["px"], other=other)["difference_px.png"]
        panels = [axes for axes in figure.axes if axes.images]
        self.assertEqual(len(panels), 6, "two theories, A, B and B - A of each")
        with h5py.File(self.path) as one, h5py.File(other) as two:
            for row, theory in enumerate(("fastsim2", "exact")):
                a, b = (1e-6 * file[f"{theory}/fields/px"][()] for file in (one, two))
                centres = [1e3 * one[f"{theory}/fields/{name}"][()] for name in "xy"]
                for axes, wanted in zip(panels[3 * row:], (a, b, b - a)):
                    away = np.abs(shown_at(axes, *centres) - wanted) / np.abs(wanted).max()
                    self.assertLess(np.median(away), 0.01)
                    self.assertLess(away.max(), 0.1)
        same = plot.figures(self.path, fields=["px"], other=self.path)["difference_px.png"]
        self.assertEqual(np.abs([axes.images[0].get_array() for axes in same.axes[2:3]]).max(), 0)

    def test_differences_need_the_same_elements(self):
        other = self.folder / "other.h5"
        for what, words in (({"mx": 12}, "FASTSIM2 has 12 x 10 elements, in .* it has 10 x 10"),
                            ({"a": 6.1e-3}, "FASTSIM2 has elements up to 0.0.* mm from those of .*result.h5; differences need"),
                            ({"theories": ("fastsim",)}, "'px' is that of fastsim, in .* of fastsim2, exact: there is nothing to")):
            write_rolling_contact(other, **what)
            with self.assertRaisesRegex(ResultError, words):
                plot.figures(self.path, fields=["px"], other=other)

    def test_differences_of_two_runs_are_those_of_each_case(self):
        one, other = self.folder / "one.h5", self.folder / "other.h5"
        for path in (one, other):
            write_contact_run(path)
        with h5py.File(other, "a") as file:
            file["elements/px"][20:] *= 1.25
        figures = plot.figures(one, other=other, fields=["px"])
        self.assertEqual(sorted(figures), ["difference_px_0002.png"])
        panels = figures["difference_px_0002.png"].axes
        largest = [np.abs(axes.images[0].get_array()).max() for axes in panels[:6]]
        np.testing.assert_allclose(largest, [200, 200, 0, 400, 500, 100], err_msg="MPa: A, B, B - A of two patches")
        self.assertIn("case 2", title_of(figures["difference_px_0002.png"]))
        self.assertEqual(sorted(plot.figures(one, other=other)), ["difference_pressure_0002.png", "difference_traction_0002.png"])
        with self.assertRaisesRegex(ResultError, "'gap'"):
            plot.figures(one, other=other, fields=["gap"])
        with self.assertRaisesRegex(ResultError, "is of kind 'rolling_contact', .*one.h5 of kind 'contact_run'"):
            plot.figures(one, other=self.path)

    def test_cases_of_a_run_have_their_fields(self):
        write_contact_run(self.path)
        with h5py.File(self.path, "a") as file:
            file["cases/motion"] = [0, 1, 1]
        figures = plot.figures(self.path, fields=["px", "sx"], surfaces=["pressure"], cut=0.0)
        self.assertEqual(sorted(figures), ["cut_0002.png", "field_px_0002.png", "field_sx_0002.png", "surface_pressure_0002.png"])
        px, sx = (figures[f"field_{name}_0002.png"].axes for name in ("px", "sx"))
        for axes, largest in zip(px, (-200, -400)):
            self.assertEqual(axes.images[0].get_array().min(), largest, "MPa, of a patch")
        self.assertIn("A run, case 2", title_of(figures["field_px_0002.png"]))
        self.assertIn("[mm]", sx[-1].get_ylabel(), "slip of a shift is a length")
        surface = figures["surface_pressure_0002.png"].axes[0]
        self.assertAlmostEqual(surface.get_zlim()[1], 2000, msg="MPa, of the second patch")
        self.assertFalse(any("rolling" in text.get_text() for axes in px for text in axes.texts), "the file has no direction")
        with h5py.File(self.path, "a") as file:
            file["cases/my"][...], file["cases/stored_elements"][...], file["elements/index"][...] = 1, [0, 5, 5], np.arange(40) % 5 + 1
        with self.assertRaisesRegex(ResultError, "a single row of elements has no surface; --field and --cut show it"):
            plot.figures(self.path, surfaces=["px"])
        with self.assertRaisesRegex(ResultError, "does not have the field 'gap', but pressure, bound, traction, px, py, slip, sx, sy$"):
            plot.figures(self.path, fields=["gap"])
        with self.assertRaisesRegex(ResultError, "--stresses is not for a file of kind 'contact_run'.*it has --field, --surface, --cut,"):
            plot.figures(self.path, stresses=0.0)

    def test_wishes_that_cannot_be_met(self):
        for wanted, words in (({"fields": ["heat"]}, "'heat' is unknown, known: pressure"),
                              ({"fields": ["presure"]}, "did you mean 'pressure'"), ({"fields": ["pressure"]}, "does not have the field 'pressure', but bound, traction, px"),
                              ({"cut": 9.0}, "y = 9 mm is outside"), ({"other": "nowhere.h5"}, "nowhere.h5: no such file")):
            with self.assertRaisesRegex(ResultError, words):
                self.chosen(**wanted)
        code, out, err = self.run_plot(self.path, "--field", "heat")
        self.assertEqual((code, out, len(err)), (2, [], 1))

    def test_without_the_compiled_module(self):
        # The source folder does not have it, even where the tests' package does.
        def python(code):
            done = subprocess.run([sys.executable, "-c", code], cwd=self.folder, text=True, capture_output=True, check=False,
                                  env={**os.environ, "PYTHONPATH": str(PYTHON_FOLDER)})
            return done.returncode, done.stderr

        self.assertEqual(python("from microslip import plot; plot.main(['result.h5', '--cut=0'])"), (0, ""))
        self.assertTrue((self.folder / "cut.png").is_file())
        code, text = python("import sys; from microslip import plot; sys.exit(plot.main(['result.h5', '--convergence']))")
        self.assertEqual((code, len(text.splitlines())), (2, 1))
        self.assertIn("convergence.png needs the compiled module", text)
        self.assertIn("microslip.Fastsim2 needs the compiled module", python("import microslip; microslip.Fastsim2")[1])

    def test_a_format_of_later_versions_is_refused(self):
        with h5py.File(self.path, "a") as file:
            file.attrs["format"] = "3"
        with self.assertRaisesRegex(ResultError, "result.h5: has format 3 of result files; this version .* reads 2$"):
            self.chosen(cut=0.0)

    def test_other_kinds_are_refused(self):
        with h5py.File(self.path, "a") as file:
            file.attrs["kind"] = "subsurface"
        with self.assertRaisesRegex(ResultError, "--cut is not for a file of kind 'subsurface', but for contacts of two bodies and"):
            self.chosen(cut=0.0)

    def test_a_damaged_file_is_named_in_one_line(self):
        whole = self.path.read_bytes()
        for part in (0.1, 0.5, 0.99):
            self.path.write_bytes(whole[:int(part * len(whole))])
            code, out, err = self.run_plot(self.path)
            self.assertEqual((code, out, len(err)), (2, [], 1))
            self.assertIn(f"{self.path}: cut short or damaged: copy it again", err[0])


if __name__ == "__main__":
    unittest.main()
