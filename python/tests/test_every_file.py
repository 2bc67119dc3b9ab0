"""`plot` draws every kind of file that the program writes; an interactive view shows the file's numbers."""

import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from microslip import plot
from microslip.result_file import ResultError
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
        self.expect("a/result.h5", "gap.png", "patches.png", "rail_head.png")

    def test_a_wheel_over_a_sweep(self):
        text = self.wheel_on_rail("wheel_on_rail.toml", "\n[sweep]\nlateral = [0.0, 0.003]\n")
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "contact_points.png", "forces.png")

    def test_a_wheelset(self):
        text = self.wheel_on_rail("wheelset_in_curve.toml", "")
        self.run_program("solve", self.text("a.toml", text), "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "wheelset.png")
        self.run_program("solve", self.text("a.toml", text[:text.index("[sweep]")]), "-o", "b", "--no-pictures")
        self.expect("b/result.h5", "patches.png")

    def test_sweeps_of_any_quantities(self):
        for quantities in ('["fx", "fy"]', '["adhesion_area"]'):
            case = SWEEP.format(quantities=quantities) + HERTZ.split("\n", 1)[1].replace("[", "[case.")
            self.run_program("sweep", self.text("a.toml", case), "-o", f"{len(quantities)}.h5")
            self.expect(f"{len(quantities)}.h5", "sweep.png")

    def test_profiles_and_conicity(self):
        self.run_program("profile", EXAMPLES / "profiles/s1002.prw", "-o", "a", "--no-pictures")
        self.expect("a/result.h5", "profile.png")
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
        with self.assertRaisesRegex(ResultError, "of two bodies"):
            plot.view(self.path)


if __name__ == "__main__":
    unittest.main()
