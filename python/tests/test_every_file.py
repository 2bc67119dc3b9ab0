"""`plot` draws every kind of file that the program writes; an interactive view shows the file's numbers."""

import subprocess
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

import matplotlib.text
import numpy as np

import microslip
from microslip import plot
from microslip.computed_pictures import material_of, tractions_on_grid
from microslip.field_picture import field_values
from microslip.result_file import ResultError, ResultFile
from microslip.solved_contacts import read_contacts
from tests.synthetic_results import write_contact_run, write_rolling_contact

# The package lies in share/microslip/python of the folder that has the program in bin.
PROGRAM = Path(microslip.__file__).parents[4] / "bin" / "microslip"
EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
HERTZ = """[body1]
rolling_radius = 0.05
transverse_radius = 0.2
young_modulus = 210e9
poisson_ratio = 0.3
[body2]
rolling_radius = 0.1
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.3
[load]
normal_force = 1e3
[friction]
coefficient = 0.3
[motion]
creepage_longitudinal = 0.001
rolling_speed = 1.0
"""
INTERIOR = """[solution]
theory = "exact"
grid = [8, 8]
[interior]
x = [-2e-4, 0.0, 2e-4]
y = [0.0]
z = [1e-4, 2e-4]
"""
SWEEP = """[grid]
motion.creepage_longitudinal = [1e-4, 1e-3, 2e-3]
[output]
quantities = {quantities}
[case.body1]
"""


@unittest.skipUnless(PROGRAM.is_file(), f"no program: {PROGRAM}")
class EveryFileTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True, check=False)
        self.assertIn(done.returncode, (0, 1), done.stderr)

    def text(self, name, text):
        (self.folder / name).write_text(text)
        return name

    def expect(self, path, *pictures):
        """The pictures of a file; each can be drawn."""
        figures = plot.figures(self.folder / path)
        self.assertEqual(sorted(figures), sorted(pictures))
        for figure in figures.values():
            figure.canvas.draw()

    def test_a_hertzian_contact(self):
        self.run_program("solve", self.text("a.toml", HERTZ), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png", "creep_curve.png")

    def test_stresses_inside_the_bodies(self):
        self.run_program("solve", self.text("a.toml", HERTZ + INTERIOR), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png", "creep_curve.png", "interior.png")

    def test_transient_rolling(self):
        text = HERTZ + 'kind = "transient"\nsteps = 4\n' + INTERIOR.split("[interior]")[0]
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png", "history.png")

    def test_a_shift_has_no_direction_of_rolling_and_slips_by_lengths(self):
        text = HERTZ.replace("creepage_longitudinal = 0.001", 'kind = "shift"\nshift_longitudinal = 1e-6').replace("rolling_speed = 1.0\n", "") + INTERIOR.split("[interior]")[0]
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png")
        path = self.folder / "a/result.h5"
        texts = [text.get_text() for figure in {**plot.figures(path), **plot.figures(path, cut=0.0, surfaces=["traction"])}.values()
                 for text in figure.findobj(matplotlib.text.Text)]
        self.assertIn("x [mm]", texts)
        self.assertEqual([text for text in texts if "rolling" in text and "contact" not in text], [])
        self.assertIn("slip of the upper roller [mm]", texts)
        scale = plot.figures(path, fields=["slip"])["field_slip.png"].axes[-1].get_ylabel()
        self.assertRegex(scale, r"\[[mµn]m\]$")
        self.refused(path, "a shift takes no time", fields=["power"])

    def test_a_contact_without_friction(self):
        text = HERTZ.replace("coefficient = 0.3", "coefficient = 0") + INTERIOR.split("[interior]")[0]
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png", "creep_curve.png")
        self.refused(self.folder / "a/result.h5", "needs friction", convergence=True)

    def test_the_case_lies_on_its_own_curve(self):
        text = HERTZ + 'step = "2e-4 m"\n' + INTERIOR.split("[interior]")[0] + 'discretisation = "classical"\n'
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        with ResultFile(self.folder / "a/result.h5") as result:
            value, fx = result.arrays(["/creep_curve/exact/value", "/creep_curve/exact/fx"])
            between = np.interp(0.001, value, fx)
            self.assertAlmostEqual(between / result.number("/exact/fx"), 1, delta=0.01)

    def test_bodies_that_lean(self):
        text = HERTZ.replace("[body2]", "creep_ratio = 2.0\ncreep_time = 5e-4\n[body2]", 1)
        self.run_program("solve", self.text("a.toml", text + INTERIOR.split("[interior]")[0]), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "tractions.png", "areas.png", "creep_curve.png")

    def wheel_on_rail(self, name, more):
        """The text of an example without its exact theory, with profiles that are found here."""
        text = (EXAMPLES / name).read_text().replace('"profiles/', f'"{EXAMPLES}/profiles/')
        return text.replace('theory = "exact"', 'theory = "fastsim2"').replace('shape = "flat"', "") + more

    def test_a_wheel_on_a_rail(self):
        self.run_program("solve", self.text("a.toml", self.wheel_on_rail("wheel_on_rail.toml", "")), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "gap.png", "patches.png", "rail_head.png", "tractions_on_profiles.png")

    def test_pictures_that_are_asked_for_of_a_wheel_on_a_rail(self):
        interior = INTERIOR[INTERIOR.index("[interior]"):]
        self.run_program("solve", self.text("a.toml", self.wheel_on_rail("wheel_on_rail.toml", interior)), "-o", "a", "--no-pictures")
        path = self.folder / "a/result.h5"
        self.expect("a/result.h5", "gap.png", "patches.png", "rail_head.png", "tractions_on_profiles.png", "interior_1.png", "interior_2.png")
        figures = plot.figures(path, fields=["pressure", "wear_depth"], surfaces=["traction"], cut=0.0, stresses=0.0)
        self.assertEqual(sorted(figures), ["cut.png", "field_pressure.png", "field_wear_depth.png", "stresses_patch_1.png",
                                           "stresses_patch_2.png", "surface_traction.png"])
        for figure in figures.values():
            figure.canvas.draw()
        titles = [axes.get_title(loc="left") for axes in figures["field_pressure.png"].axes]
        self.assertEqual(titles[:2], ["patch 1", "patch 2"])
        with ResultFile(path) as result:
            drawn = figures["field_pressure.png"].axes[0].images[0].norm.vmax
            self.assertAlmostEqual(drawn, 1e-6 * max(result.array(f"/fields/{k}/pressure", dimensions=2).max() for k in (0, 1)))
            for contact in read_contacts(result).values():  # power is the speed times the work per metre
                work = field_values(result, contact, "friction_work")
                np.testing.assert_allclose(field_values(result, contact, "power"), contact.speed * work, rtol=1e-9, atol=1e-6 * work.max())
        self.refused(path, "--creep-curves is not for a file of kind 'wheel_rail', but for contacts of two bodies; it has --field", spins=[])
        self.refused(path, r"goes from \S+ to \S+ mm \(patch 1\), from \S+ to \S+ mm \(patch 2\)", cut=99.0)
        self.refused(path, "did you mean 'wear_depth'", fields=["weardepth"])

    def refused(self, path, words, **chosen):
        with self.assertRaisesRegex(ResultError, words):
            plot.figures(path, **chosen)

    @unittest.skipUnless(find_spec("plotly"), "plotly is not installed")
    def test_a_view_of_a_patch(self):
        self.run_program("solve", self.text("a.toml", self.wheel_on_rail("wheel_on_rail.toml", "")), "-o", "a", "--no-pictures")
        path = self.folder / "a/result.h5"
        with ResultFile(path) as result:
            largest = [1e-6 * result.array(f"/fields/{k}/pressure", dimensions=2).max() for k in (0, 1)]
        highest = f"patch {1 + int(np.argmax(largest))}"
        self.assertIn(highest, plot.view(path, "pressure").layout.title.text)
        for k in (0, 1):
            heights = [surface.z.max() for surface in plot.view(path, "pressure", patch=f"patch {k + 1}").data if surface.type == "surface"]
            self.assertAlmostEqual(max(heights) / largest[k], 1, delta=0.1)
        for wrong, words in (({"patch": "patch 9"}, "no patch 'patch 9', there are: patch 1, patch 2"),
                             ({"theory": "exact"}, "choose by patch=, one of: patch 1, patch 2")):
            with self.assertRaisesRegex(ResultError, words):
                plot.view(path, **wrong)

    def test_stresses_below_a_patch_are_those_that_the_program_finds(self):
        interior = "[interior]\nx = [-1e-3, 0.0, 2e-3]\ny = [0.0]\nz = [-3e-3, 2e-3, 4e-3]\n"
        self.run_program("solve", self.text("a.toml", self.wheel_on_rail("wheel_on_rail.toml", interior)), "-o", "a", "--no-pictures")
        with ResultFile(self.folder / "a/result.h5") as result:
            grid, (px, py, pn) = tractions_on_grid(result, "/fields/1")
            x, z = result.arrays(["/interior/1/x"]) + result.arrays(["/interior/1/z"])
            expected = result.array("/interior/1/von_mises", dimensions=3)[:, 0]
            for row, depth in zip(expected, z):
                body = 1 if depth > 0 else 2
                field = microslip.InteriorField(material_of(result, body), body, grid, px=px, py=py, pn=pn)
                np.testing.assert_allclose(field.at(x, 0.0, abs(depth)).von_mises, row, rtol=0.02)

    def test_a_wheel_over_a_sweep(self):
        text = self.wheel_on_rail("wheel_on_rail.toml", "\n[sweep]\nlateral = [0.0, 0.003]\n")
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "contact_points.png", "forces.png")
        self.refused(self.folder / "a/result.h5", "has no fields; a case of one state, without .sweep.", fields=["pressure"])

    def test_a_wheelset(self):
        text = self.wheel_on_rail("wheelset_in_curve.toml", "")
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "wheelset.png")
        self.run_program("solve", self.text("a.toml", text[:text.index("[sweep]")]), "-o", "b", "--no-pictures")
        self.expect("b/result.h5", "patches.png")
        titles = [axes.get_title(loc="left") for axes in plot.figures(self.folder / "b/result.h5", fields=["slip"])["field_slip.png"].axes]
        self.assertEqual(titles[:2], ["left wheel, patch 1", "right wheel, patch 1"])

    def test_sweeps_of_any_quantities(self):
        for quantities in ('["fx", "fy"]', '["adhesion_area"]'):
            case = SWEEP.format(quantities=quantities) + HERTZ.split("\n", 1)[1].replace("[", "[case.")
            self.run_program("sweep", self.text("a.toml", case), "-o", f"{len(quantities)}.h5")
            self.expect(f"{len(quantities)}.h5", "sweep.png")

    def test_parameters_of_sweeps_have_units(self):
        case = SWEEP.format(quantities='["fx"]') + HERTZ.split("\n", 1)[1].replace("[", "[case.")
        case = case.replace("motion.creepage_longitudinal = [1e-4, 1e-3, 2e-3]", 'load.normal_force = ["1 kN", "2 kN"]')
        self.run_program("sweep", self.text("a.toml", case), "-o", "a.h5")
        axes = plot.figures(self.folder / "a.h5")["sweep.png"].axes[0]
        self.assertEqual(axes.get_xlabel(), "load.normal_force [kN]")
        np.testing.assert_allclose(axes.lines[0].get_xdata(), [1, 2])

    def test_grids_are_drawn_over_the_parameter_with_most_numbers(self):
        case = SWEEP.format(quantities='["fx"]') + HERTZ.split("\n", 1)[1].replace("[", "[case.")
        varied = ("load.normal_force = { from = 1e3, to = 2e3, count = 16 }\nmotion.spin = { from = 0, to = 2, count = 15 }\n"
                  "body1.poisson_ratio = [0.2, 0.3]")
        case = case.replace("motion.creepage_longitudinal = [1e-4, 1e-3, 2e-3]", varied)
        self.run_program("sweep", self.text("a.toml", case), "-o", "a.h5")
        axes = plot.figures(self.folder / "a.h5")["sweep.png"].axes[0]
        self.assertEqual(axes.get_xlabel(), "load.normal_force [kN]")
        self.assertEqual(axes.get_title(loc="left"), "12 of 30 combinations")
        self.assertEqual([len(line.get_xdata()) for line in axes.lines], [16] * 12)

    def test_measured_creep_curves(self):
        points, case = EXAMPLES / "creep_curve.csv", EXAMPLES / "creep_curve.toml"
        self.run_program("fit", points, "--case", case, "--model", "polach", "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "creep_curve_fit.png")
        self.run_program("solve", case, "--points", points, "-o", "b", "--no-pictures")
        self.expect("b/measured_points.h5", "measured_points.png")
        self.run_program("sweep", EXAMPLES / "creep_sweep.toml", "-o", "c.h5")
        points = self.text("points.csv", "creepage_longitudinal [%],adhesion_coefficient\n0.1,0.15\n1,0.3\n")
        self.run_program("plot", "c.h5", "--points", points, "-o", "c")
        figure = plot.figures(self.folder / "c/measured_points.h5")["measured_points.png"]
        through = [line for line in figure.axes[0].lines if len(line.get_xdata()) == 25]
        self.assertEqual(len(through), 6)  # two theories and three spins

    def test_profiles_and_conicity(self):
        self.run_program("profile", EXAMPLES / "profiles/s1002.prw", "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "profile.png")
        self.run_program("profile", EXAMPLES / "profiles", "-o", "f", "--no-pictures")
        self.expect("f/result.h5", "profiles.png")
        (self.folder / "rail.slcs").write_text(f"0 1000\n2\n0\n1\n0 '{EXAMPLES}/profiles/60e1.prr'\n1 '{EXAMPLES}/profiles/60e1.prr'\n")
        self.run_program("profile", "rail.slcs", "-o", "s", "--no-pictures")
        self.expect("s/result.h5", "surface.png")
        self.run_program("conicity", EXAMPLES / "profiles/s1002.prw", EXAMPLES / "profiles/60e1.prr", "--cant", "0.025", "-o", "b",
                         "--no-pictures")
        self.expect("b/result.h5", "conicity.png", "contact_points.png")

    def test_a_run_of_contact(self):
        self.run_program("run", EXAMPLES / "sphere_on_plane.inp", "-o", "a")
        names = [path.name for path in (self.folder / "a").glob("*.h5")]
        self.assertEqual(names, ["sphere_on_plane.h5"])
        self.assertIn("forces.png", plot.figures(self.folder / "a" / names[0]))

    def test_the_program_says_what_is_wrong_with_a_file(self):
        self.text("w.toml", HERTZ)
        done = subprocess.run([PROGRAM, "plot", "w.toml"], cwd=self.folder, text=True, capture_output=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertTrue(done.stderr.startswith("microslip: w.toml: not a result file"), done.stderr)

    def test_a_study(self):
        self.run_program("validate", "model-problem", "-o", "a", "--no-pictures")
        self.expect("a/model_problem.h5", "model_problem.png")


class ViewTest(unittest.TestCase):
    def setUp(self):
        try:
            import plotly  # noqa: F401
        except ImportError:
            self.skipTest("plotly is not installed")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "result.h5"

    def test_a_view_has_the_fields_height_up_to_the_outline(self):
        write_rolling_contact(self.path, theories=("fastsim2", "exact"))
        figure = plot.view(self.path, "traction")
        surface, outline = figure.data
        self.assertEqual((surface.type, outline.type), ("surface", "scatter3d"))
        largest = plot.view(self.path, "traction", "fastsim2").data[0].z.max()
        self.assertAlmostEqual(np.max(surface.z) / largest, 1, delta=0.1)
        np.testing.assert_allclose((surface.x[-1] / 6) ** 2 + (surface.y[-1] / 4) ** 2, 1, rtol=2e-3)
        self.assertIn("exact theory", figure.layout.title.text)
        page = self.path.with_suffix(".html")
        figure.write_html(str(page))
        self.assertIn("plotly", page.read_text()[:10_000_000])

    def test_wishes_that_cannot_be_met(self):
        write_rolling_contact(self.path)
        with self.assertRaisesRegex(ResultError, "no theory 'exact'"):
            plot.view(self.path, theory="exact")
        with self.assertRaisesRegex(ResultError, "'heat' is unknown"):
            plot.view(self.path, "heat")
        write_contact_run(self.path)
        with self.assertRaisesRegex(ResultError, "kind 'contact_run' has no fields to view; these kinds have: rolling_contact, wheel_rail"):
            plot.view(self.path)


if __name__ == "__main__":
    unittest.main()
