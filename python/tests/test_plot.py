"""The command line draws whole pictures or says in one line what is wrong; the pictures show the file's numbers."""

import contextlib
import io
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib
import matplotlib.image
import numpy as np
from matplotlib.quiver import Quiver

from microslip import plot
from microslip.picture_style import SETTINGS, bodies_of, put_title, new_figure, quantity, round_down, round_up, unit_for, with_unit
from microslip.result_file import ResultFile
from tests.synthetic_results import (GRIDS, write_contact_run, write_fastsim2_table1, write_fastsim2_table2, write_history,
                                     write_model_problem, write_models, write_rolling_contact)

PYTHON_FOLDER = Path(__file__).resolve().parent.parent


class ImportTest(unittest.TestCase):
    def test_the_package_has_the_pictures(self):
        code = "import microslip; print(microslip.plot.figures.__name__)"
        done = subprocess.run([sys.executable, "-c", code], cwd=PYTHON_FOLDER, capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("figures\n", ""))


class FolderTest(unittest.TestCase):
    """A test with a temporary folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.path = self.folder / "result.h5"

    def run_plot(self, *arguments):
        """Exit code, lines on stdout, lines on stderr."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = plot.main([str(argument) for argument in arguments])
        return code, out.getvalue().splitlines(), err.getvalue().splitlines()

    def figures(self):
        """The figures of the result file."""
        with ResultFile(self.path) as result, matplotlib.rc_context(SETTINGS):
            return plot.pictures(result)


class ContactRunTest(FolderTest):
    def test_each_patch_has_its_pressures_and_tractions(self):
        write_contact_run(self.path)
        case = self.figures()["case_0002.png"]
        panels = [axes for axes in case.axes if axes.get_title(loc="left")]
        self.assertEqual([axes.get_title(loc="left").splitlines()[0] for axes in panels], ["patch 1", "patch 2"])
        for scale, axes in enumerate(panels, start=1):
            [image] = axes.images
            self.assertAlmostEqual(image.get_array().max(), 1e3 * scale)
            self.assertAlmostEqual(image.get_array().min(), 1e3 * scale)
            [arrows] = [part for part in axes.collections if isinstance(part, Quiver)]
            self.assertTrue(np.allclose(arrows.U, -200 * scale) and np.allclose(arrows.V, 100 * scale))


class CommandLineTest(FolderTest):
    def expect_pictures(self, names):
        code, out, err = self.run_plot(self.path, "-o", self.folder / "pictures")
        self.assertEqual((code, err), (0, []))
        self.assertEqual(out, [str(self.folder / "pictures" / name) for name in names])
        self.assertEqual(sorted(os.listdir(self.folder / "pictures")), sorted(names))
        for line in out:
            pixels = matplotlib.image.imread(line)[..., :3]
            self.assertGreater(min(pixels.shape[:2]), 400)
            self.assertGreater(pixels.std(), 0.05, f"{line} is blank")

    def test_rolling_contact(self):
        write_rolling_contact(self.path)
        self.expect_pictures(["tractions.png", "areas.png", "creep_curve.png"])

    def test_both_theories(self):
        write_rolling_contact(self.path, theories=("fastsim2", "exact"))
        self.expect_pictures(["tractions.png", "areas.png", "creep_curve.png"])

    def test_transient_rolling(self):
        write_rolling_contact(self.path, theories=("exact",))
        with h5py.File(self.path, "a") as file:
            del file["creep_curve"]
            write_history(file)
        self.expect_pictures(["tractions.png", "areas.png", "history.png"])

    def test_kinds_of_files_have_their_pictures(self):
        for write, names in ((write_contact_run, ["forces.png", "case_0002.png"]),
                             (write_fastsim2_table1, ["fastsim2_figure3.png"]),
                             (write_fastsim2_table2, ["fastsim2_figure4.png", "fastsim2_figure5.png"]),
                             (write_model_problem, ["model_problem.png"]),
                             (write_models, ["result.png"])):
            with self.subTest(names=names):
                write(self.path)
                self.expect_pictures(names)
                for path in (self.path, self.folder / "pictures"):
                    shutil.rmtree(path) if path.is_dir() else path.unlink()

    def test_module_runs_as_a_program_and_draws_beside_the_file(self):
        write_model_problem(self.path)
        done = subprocess.run([sys.executable, "-m", "microslip.plot", "result.h5"], cwd=self.folder, text=True,
                              capture_output=True, env={**os.environ, "PYTHONPATH": str(PYTHON_FOLDER)}, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.split(), [os.path.join(".", "model_problem.png")])
        self.assertTrue((self.folder / "model_problem.png").is_file())

    def test_picture_names_its_version(self):
        write_model_problem(self.path)
        self.run_plot(self.path)
        self.assertIn(b"microslip 0.1.0 (abc)", (self.folder / "model_problem.png").read_bytes())

    def test_formats_that_are_asked_for(self):
        write_model_problem(self.path)
        code, names, errors = self.run_plot(self.path, "--format", "pdf", "--format", "svg", "--format", "png", "--dpi", 40)
        self.assertEqual((code, errors), (0, []))
        drawn = {form: self.folder / f"model_problem.{form}" for form in ("pdf", "svg", "png")}
        self.assertEqual(names, [str(path) for path in drawn.values()])
        self.assertTrue(drawn["pdf"].read_bytes().startswith(b"%PDF-"))
        self.assertNotIn(b"CreationDate", drawn["pdf"].read_bytes())
        self.assertIn("<dc:title>microslip 0.1.0 (abc)</dc:title>", drawn["svg"].read_text())  # the program
        size = self.figures()["model_problem.png"].get_size_inches()
        shape = matplotlib.image.imread(drawn["png"]).shape
        for pixels, inches in zip(shape[1::-1], size):  # without empty margins, with a small one
            self.assertLess(abs(pixels - 40 * inches), 0.05 * 40 * inches)

    def test_styles_have_sizes_of_their_own(self):
        write_rolling_contact(self.path)
        page, paper, slides = (plot.figures(self.path, style=style)["creep_curve.png"] for style in ("page", "paper", "slides"))
        self.assertAlmostEqual(25.4 * paper.get_figwidth(), 85, delta=0.5, msg="a column in mm")
        sizes = [figure.axes[0].xaxis.label.get_size() / figure.get_figwidth() for figure in (page, paper, slides)]
        self.assertEqual(min(sizes), sizes[0], "letters are larger beside the picture in a paper and on slides")
        self.assertGreaterEqual(min(label.get_size() for label in paper.axes[0].get_xticklabels()), 6, "points")
        code, names, errors = self.run_plot(self.path, "--style", "paper")
        self.assertEqual((code, errors, len(names)), (0, [], 3))

    def test_styles_that_there_are_not(self):
        write_rolling_contact(self.path)
        self.assertEqual(self.run_plot(self.path, "--style", "poster"),
                         (2, [], ["microslip.plot: style 'poster': must be one of page, paper, slides"]))

    def test_formats_that_there_are_not(self):
        self.assertEqual(self.run_plot(self.path, "--format", "jpg"), (2, [], ["microslip.plot: --format jpg: must be one of pdf, png, svg"]))

    def test_pictures_of_an_earlier_case_do_not_stay(self):
        write_rolling_contact(self.path, theories=("exact",))
        theirs = self.folder / "history.png"
        theirs.write_bytes(b"a picture of somebody else")
        self.run_plot(self.path)
        self.assertTrue((self.folder / "creep_curve.png").is_file())
        with h5py.File(self.path, "a") as file:
            del file["creep_curve"]
        code, out, _ = self.run_plot(self.path)
        self.assertEqual((code, len(out)), (0, 2))
        self.assertFalse((self.folder / "creep_curve.png").exists())
        self.assertTrue(theirs.is_file())

    def expect_error(self, *words):
        code, out, err = self.run_plot(self.path)
        self.assertEqual((code, out, len(err)), (2, [], 1))
        for word in (str(self.path), *words):
            self.assertIn(word, err[0])
        self.assertEqual([name for name in os.listdir(self.folder) if "png" in name], [])

    def test_missing_file(self):
        self.expect_error("no such file")

    def test_not_hdf5(self):
        self.path.write_text("x,y\n1,2\n")
        self.expect_error("not a result file (HDF5)")

    def test_truncated_hdf5(self):
        write_rolling_contact(self.path)
        self.path.write_bytes(self.path.read_bytes()[:5000])
        self.expect_error("cut short or damaged")

    def test_unknown_kind(self):
        with h5py.File(self.path, "w") as file:
            file.attrs["kind"] = "weather"
        self.expect_error("'weather'", "rolling_contact")

    def test_no_kind(self):
        with h5py.File(self.path, "w"):
            pass
        self.expect_error("'kind'")

    def test_every_missing_dataset_is_named(self):
        for name in ("/fastsim2/fields/px", "/fastsim2/fx", "/hertz/a", "/creep_curve/fastsim2/fy", "/creep_curve/limit"):
            write_rolling_contact(self.path)
            with h5py.File(self.path, "a") as file:
                del file[name]
            self.expect_error(f"no dataset {name}")

    def test_no_theory(self):
        write_rolling_contact(self.path, theories=("fastsim2",))
        with h5py.File(self.path, "a") as file:
            del file["/fastsim2"]
        self.expect_error("no results")

    def test_values_that_are_not_finite(self):
        write_rolling_contact(self.path)
        with h5py.File(self.path, "a") as file:
            file["/fastsim2/fields/px"][3, 4] = np.nan
        self.expect_error("/fastsim2/fields/px", "not finite")

    def test_shapes_that_differ(self):
        write_rolling_contact(self.path)
        with h5py.File(self.path, "a") as file:
            del file["/creep_curve/fastsim2/fx"]
            file["/creep_curve/fastsim2/fx"] = np.zeros(3)
        self.expect_error("/creep_curve/fastsim2/fx", "(3,)")

    def test_folder_that_cannot_be_made(self):
        write_model_problem(self.path)
        code, out, err = self.run_plot(self.path, "-o", self.path / "inside")
        self.assertEqual((code, out, len(err)), (2, [], 1))

    def test_nothing_half_written_is_left(self):
        (self.folder / "model_problem.png").mkdir()
        write_model_problem(self.path)
        code, _, err = self.run_plot(self.path)
        self.assertEqual((code, len(err)), (2, 1))
        self.assertEqual(sorted(os.listdir(self.folder)), ["model_problem.png", "result.h5"])


class RollingContactPicturesTest(FolderTest):
    def test_tractions_stand_at_their_cells(self):
        write_rolling_contact(self.path, mx=40, my=40)
        axes = self.figures()["tractions.png"].axes[0]
        arrows = next(part for part in axes.collections if isinstance(part, Quiver))
        with h5py.File(self.path) as file:
            x, y, px, py = (np.ravel(file[f"/fastsim2/fields/{name}"]) for name in ("x", "y", "px", "py"))
        largest = 1e-6 * np.hypot(px, py).max()
        for at_x, at_y, u, v in zip(arrows.X, arrows.Y, arrows.U, arrows.V):
            near = np.argmin(np.hypot(1e3 * x - at_x, 1e3 * y - at_y))
            np.testing.assert_allclose((u, v), (1e-6 * px[near], 1e-6 * py[near]), atol=0.12 * largest)

    def test_arrows_lie_inside(self):
        write_rolling_contact(self.path, theories=("fastsim2", "exact"))
        for name in ("tractions.png", "areas.png"):
            for axes in self.figures()[name].axes[:2]:
                arrows = next(part for part in axes.collections if isinstance(part, Quiver))
                for side in (-0.5, 0.5):
                    x, y = arrows.X + side * arrows.U / arrows.scale, arrows.Y + side * arrows.V / arrows.scale
                    self.assertLessEqual(((x / 6) ** 2 + (y / 4) ** 2).max(), 1.0)

    def test_theories_share_their_scales(self):
        write_rolling_contact(self.path, theories=("fastsim2", "exact"))
        figure = self.figures()["tractions.png"]
        arrows = [next(part for part in axes.collections if isinstance(part, Quiver)) for axes in figure.axes[:2]]
        self.assertEqual(arrows[0].scale, arrows[1].scale)
        titles = [axes.get_title(loc="left").splitlines()[0] for axes in figure.axes[:2]]
        self.assertEqual(titles, ["FASTSIM2", "exact theory"])

    def test_title_has_the_totals(self):
        write_rolling_contact(self.path)
        title = self.figures()["tractions.png"].axes[0].get_title(loc="left")
        with h5py.File(self.path) as file:
            for name, unit in (("fx", "N"), ("fy", "N"), ("mz", "N m")):
                self.assertIn(with_unit(file[f"/fastsim2/{name}"][()], unit), title)

    def test_areas_add_up(self):
        write_rolling_contact(self.path)
        texts = self.figures()["areas.png"].axes[0].get_title(loc="left").splitlines()[1].split(", ")
        self.assertEqual([text.split()[-1] for text in texts], ["stick", "slide"])
        self.assertAlmostEqual(sum(float(text.split("(")[1].split()[0]) for text in texts), 100, delta=0.1001)

    def test_extreme_contacts_are_drawn(self):
        for a, b, mx, my, creepage in ((6e-3, 6e-7, 10, 10, (0, 0, 0.2)), (1e-6, 1e-2, 10, 10, (0.001, 0, 0)),
                                       (6e-3, 4e-3, 1, 1, (0, 0, 0)), (6e-3, 4e-3, 10, 10, (1e3, -1e3, 1e3))):
            write_rolling_contact(self.path, a=a, b=b, mx=mx, my=my, creepage=creepage)
            for figure in self.figures().values():
                figure.savefig(io.BytesIO(), dpi=40)

    def test_creep_curve_goes_through_the_case(self):
        for varied, factor in (("creepage_longitudinal", 1e3), ("creepage_lateral", 1e3), ("spin", 1)):
            write_rolling_contact(self.path, varied=varied)
            axes = self.figures()["creep_curve.png"].axes[0]
            points = [line.get_xydata()[0] for line in axes.lines if line.get_marker() == "o"]
            with h5py.File(self.path) as file:
                here = factor * file[f"/creep_curve/{varied}"][()]
                expected = [[here, 1e-3 * file[f"/fastsim2/{name}"][()]] for name in ("fx", "fy")]
            np.testing.assert_allclose(points, expected, rtol=1e-12)
            for line, point in zip(axes.lines, points):
                self.assertAlmostEqual(np.interp(here, *line.get_xydata().T), point[1], delta=0.02 * abs(point[1]))


class StudyPicturesTest(FolderTest):
    def test_figure_3_goes_through_the_published_percentiles(self):
        write_fastsim2_table1(self.path)
        for axes, published in zip(self.figures()["fastsim2_figure3.png"].axes, (8, 8, 0), strict=True):
            lines = [line for line in axes.lines if len(line.get_xdata()) > 1]
            points = [line for line in axes.lines if len(line.get_xdata()) == 1]
            self.assertEqual((len(lines), len(points)), (4, published))
            for point in points:
                value, share = point.get_xydata()[0]
                distances = [abs(np.interp(value, *line.get_xydata().T) - share) for line in lines
                             if line.get_color() == point.get_color()]
                self.assertLess(min(distances), 0.5)

    def test_figure_4_holds_the_percentiles(self):
        write_fastsim2_table2(self.path)
        figure = self.figures()["fastsim2_figure4.png"]
        with h5py.File(self.path) as file:
            for axes, algorithm in zip(figure.axes, ("fastsim", "fastsim2")):
                self.assertEqual(len(axes.lines), len(GRIDS))
                for line, p80, p95 in zip(axes.lines, file[f"/{algorithm}/p80_fy"], file[f"/{algorithm}/p95_fy"]):
                    for percentile, share in ((p80, 80), (p95, 95)):
                        self.assertAlmostEqual(np.interp(percentile, *line.get_xydata().T), share, delta=0.5)

    def test_figure_5_has_triangles_of_first_and_second_order(self):
        write_fastsim2_table2(self.path)
        for axes in self.figures()["fastsim2_figure5.png"].axes:
            slopes = []
            for triangle in axes.patches:
                (left, high), _, (right, low) = triangle.get_xy()[:3]
                slopes.append(np.log(high / low) / np.log(right / left))
            np.testing.assert_allclose(slopes, [1, 2], rtol=1e-12)

    def test_figure_5_has_a_line_at_a_tenth_of_the_theorys_error(self):
        write_fastsim2_table2(self.path)
        levels = [next(line.get_ydata()[0] for line in axes.lines if "tenth" in line.get_label())
                  for axes in self.figures()["fastsim2_figure5.png"].axes]
        np.testing.assert_allclose(levels, [0.0026, 0.0039])

    def test_model_problem_shows_slip_that_is_infinite_at_the_end(self):
        write_model_problem(self.path)
        with h5py.File(self.path, "a") as file:
            file["/case3/s_exact"][-20:] = np.inf
        figure = self.figures()["model_problem.png"]
        self.assertTrue(np.all(np.isfinite([axes.get_ylim() for axes in figure.axes])))


class NumbersTest(unittest.TestCase):
    def test_round_numbers_enclose_the_value(self):
        for value in np.geomspace(1e-9, 1e9, 200):
            self.assertLessEqual(round_down(value), value * (1 + 1e-9))
            self.assertGreater(2.5 * round_down(value), value * (1 - 1e-9))
            self.assertGreaterEqual(round_up(value), value * (1 - 1e-9))
            self.assertLess(round_up(value), 2.5 * value * (1 + 1e-9))
        for exact in (0.001, 0.02, 5.0, 1000.0):
            self.assertEqual((round_down(exact), round_up(exact)), (exact, exact))

    def test_quantities(self):
        self.assertEqual(quantity(-12.3, "kN"), "\N{MINUS SIGN}12.30 kN")
        self.assertEqual(quantity(1234.0, "mm²"), "1234 mm²")
        self.assertEqual(quantity(-1e-16, "N m"), "0 N m")

    def test_units_fit_the_size(self):
        for value, unit, text in ((35.24, "N", "35.24 N"), (-14060, "N", "\N{MINUS SIGN}14.06 kN"), (3.2e8, "Pa", "320.0 MPa"),
                                  (1.2e9, "Pa", "1200 MPa"), (3e5, "Pa", "0.3000 MPa"), (180.0, "Pa", "180.0 Pa"),
                                  (2e-5, "m", "20.00 µm"), (0.012, "m", "12.00 mm"), (17.49, "N m", "17.49 N m"),
                                  (2.5e6, "W/m²", "2.500 MW/m²"), (0, "N", "0 N")):
            self.assertEqual(with_unit(value, unit), text)
        self.assertEqual(with_unit(-3e-14, "N", 35.0), "0 N")
        self.assertEqual(unit_for(0.0, "Pa"), (1e-6, "MPa"))
        self.assertEqual(unit_for(0.3, "-"), (1.0, "-"))

    def test_long_titles_are_broken(self):
        figure = new_figure(6, 4)
        put_title(figure, "a word and another " * 12)
        lines = figure._suptitle.get_text().splitlines()
        self.assertGreater(len(lines), 2)
        figure.canvas.draw()
        box = figure._suptitle.get_window_extent()
        self.assertGreaterEqual(box.x0, 0)
        self.assertLessEqual(box.x1, figure.bbox.x1)


class BodiesTest(FolderTest):
    def test_bodies_are_called_what_they_are(self):
        inf = float("inf")
        for radii, names in (((0.46, inf, 0.3), ("wheel", "rail")), ((0.05, 0.12, inf), ("upper roller", "lower roller")),
                             ((0.05, -0.12, inf), ("roller", "ring")), ((-0.12, 0.05, 0.1), ("ring", "roller")),
                             ((0.46, inf, inf), ("body 1", "body 2")), ((inf, inf, 0.3), ("body 1", "body 2"))):
            with h5py.File(self.path, "w") as file:
                for name, value in zip(("body1/rolling_radius", "body2/rolling_radius", "body2/transverse_radius"), radii):
                    file[f"/inputs/{name}"] = value
            with ResultFile(self.path) as result:
                self.assertEqual(bodies_of(result), names)


if __name__ == "__main__":
    unittest.main()
