"""Surfaces that `microslip convert -o NAME.vtp` writes: their tractions times areas are the forces, in track axes on rails."""

import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

import numpy as np

from microslip.result_file import ResultFile
from tests.test_every_file import EXAMPLES, HERTZ, PROGRAM

EXACT = '[solution]\ntheory = "exact"\ngrid = [8, 8]\n'


def read(path):
    """The corners (elements, 4, 3) of a surface, and its numbers and vectors by name."""
    piece = xml.etree.ElementTree.parse(path).getroot().find("PolyData/Piece")
    arrays = {array.get("Name"): np.array(array.text.split(), dtype=float).reshape(-1, int(array.get("NumberOfComponents", "1")))
              for array in piece.iter("DataArray")}
    points = arrays.pop("corners [m]")
    return points[arrays.pop("connectivity").astype(int).reshape(-1, 4)], {name: np.squeeze(values) for name, values in arrays.items()}


def areas_of(corners):
    """Areas of the rectangles."""
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]), axis=1)


@unittest.skipUnless(PROGRAM.is_file(), f"no program: {PROGRAM}")
class VtkSurfacesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, text=True, capture_output=True, check=False)

    def surfaces(self, case):
        """Solves a case; its result file and the surfaces by the end of their names."""
        self.run_program("solve", case, "-o", "a", "--no-pictures")
        done = self.run_program("convert", "a/result.h5", "-o", "b.vtp")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(done.stdout.split()), sorted(path.name for path in self.folder.glob("b.*.vtp")))
        return self.folder / "a" / "result.h5", {path.name[2:-4]: read(path) for path in self.folder.glob("b.*.vtp")}

    def test_two_bodies_lie_in_a_plane_with_all_their_fields(self):
        (self.folder / "case.toml").write_text(HERTZ + EXACT)
        path, surfaces = self.surfaces("case.toml")
        self.assertEqual(sorted(surfaces), ["exact.fields", "fastsim2.fields"])
        with ResultFile(path) as result:
            for theory in ("exact", "fastsim2"):
                corners, values = surfaces[f"{theory}.fields"]
                for name in ("x", "px", "state", "area"):
                    heading = name if name == "state" else f"{name} [{result.unit(f'/{theory}/fields/{name}')}]"
                    np.testing.assert_array_equal(values[heading], result.array(f"/{theory}/fields/{name}", dimensions=2).ravel())
                np.testing.assert_allclose(corners.mean(axis=1)[:, 0], values["x [m]"], atol=1e-12)
                np.testing.assert_allclose(areas_of(corners), values["area [m^2]"], rtol=1e-9)
                self.assertEqual(np.abs(corners[..., 2]).max(), 0)
                force = values["traction on body 1 [Pa]"].T @ areas_of(corners)
                np.testing.assert_allclose(force[:2], [result.number(f"/{theory}/{name}") for name in ("fx", "fy")], rtol=1e-9, atol=1e-9)
                if theory == "exact":
                    self.assertAlmostEqual(force[2] / 1e3, 1, delta=1e-6)

    def test_patches_on_a_rail_add_up_to_the_force_on_the_wheel(self):
        text = (EXAMPLES / "wheel_on_rail.toml").read_text().replace('"profiles/', f'"{EXAMPLES}/profiles/')
        (self.folder / "rail.toml").write_text(text.replace('\n# shape = "flat"', '\nshape = "flat"'))  # surfaces that do not turn
        path, surfaces = self.surfaces("rail.toml")
        self.assertEqual(sorted(surfaces), ["fields.0", "fields.1"])
        total = sum(values["traction on body 1 [Pa]"].T @ areas_of(corners) for corners, values in surfaces.values())
        with ResultFile(path) as result:
            force = [float(result.array(f"/wheel/force_{axis}")[0]) for axis in "xyz"]
            places = np.array([result.array(f"/patches/place_{axis}") for axis in "xyz"]).T
        np.testing.assert_allclose(total, force, rtol=1e-6)
        for number, place in enumerate(places):
            centres = surfaces[f"fields.{number}"][0].mean(axis=1)
            self.assertLess(np.linalg.norm(centres - place, axis=1).min(), 1e-3)

    def check_against(self, result, group, surface):
        """A surface has the group's elements, each with its area and numbers."""
        corners, values = surface
        fields = {name: result.array(f"/{group}/{name}", dimensions=2).ravel() for name in ("x", "y", "px", "py", "state", "area")}
        self.assertEqual(len(corners), fields["x"].size)
        self.assertGreater(np.count_nonzero(fields["state"]), 20)
        for name, wanted in fields.items():
            heading = name if name == "state" else f"{name} [{result.unit(f'/{group}/{name}')}]"
            np.testing.assert_array_equal(values[heading], wanted, f"{group}/{name}")
        np.testing.assert_allclose(areas_of(corners), fields["area"], rtol=1e-6)

    def test_wheelset_has_the_patches_of_both_wheels_on_their_rails(self):
        text = (EXAMPLES / "wheelset_in_curve.toml").read_text().replace('"profiles/', f'"{EXAMPLES}/profiles/')
        (self.folder / "set.toml").write_text(text.split("[sweep]")[0] + '[solution]\ntheory = "exact"\nshape = "flat"\ngrid = 8\n')
        path, surfaces = self.surfaces("set.toml")
        with ResultFile(path) as result:
            for side, sign in (("left", 1), ("right", -1)):
                of_side = {name: surface for name, surface in surfaces.items() if name.startswith(side)}
                self.assertEqual(len(of_side), result.array(f"/{side}/patches/place_y").size)
                for name, surface in of_side.items():
                    self.check_against(result, name.replace(".", "/"), surface)
                    self.assertGreater(sign * surface[0][..., 1].min(), 0.6)  # m, on the rail of this side
                total = sum(values["traction on body 1 [Pa]"].T @ areas_of(corners) for corners, values in of_side.values())
                force = [float(result.array(f"/{side}/wheel/force_{axis}")[0]) for axis in "xyz"]
                np.testing.assert_allclose(total, force, rtol=1e-6, atol=1e-3)

    def test_bodies_with_layers_have_the_fields_of_their_surfaces(self):
        (self.folder / "coated.toml").write_text((EXAMPLES / "coated_roller.toml").read_text().replace("grid = [40, 40]", "grid = [12, 12]"))
        path, surfaces = self.surfaces("coated.toml")
        self.assertEqual(list(surfaces), ["exact.fields"])
        with ResultFile(path) as result:
            self.check_against(result, "exact/fields", surfaces["exact.fields"])
            corners, values = surfaces["exact.fields"]
            force = values["traction on body 1 [Pa]"].T @ areas_of(corners)
            np.testing.assert_allclose(force, [result.number("/exact/fx"), result.number("/exact/fy"), 50], rtol=1e-6, atol=1e-9)

    def test_what_has_no_fields_and_other_names_are_refused(self):
        (self.folder / "case.toml").write_text(HERTZ + '[solution]\ntheory = "fastsim2"\n')
        self.run_program("solve", "case.toml", "-o", "a", "--no-pictures")
        done = self.run_program("convert", "a/result.h5", "-o", "b.vti")
        self.assertEqual(done.returncode, 2)
        self.assertIn("needs a name that ends with .csv, for tables, or .vtp", done.stderr)
        self.run_program("conicity", EXAMPLES / "profiles/s1002.prw", EXAMPLES / "profiles/60e1.prr", "-o", "c", "--no-pictures")
        done = self.run_program("convert", "c/result.h5", "-o", "b.vtp")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no fields", done.stderr)
        self.run_program("run", EXAMPLES / "sphere_on_plane.inp", "-o", "d")  # whose elements are those of many cases
        done = self.run_program("convert", "d/sphere_on_plane.h5", "-o", "b.vtp")
        self.assertEqual(done.returncode, 2)
        self.assertIn("has no fields", done.stderr)


if __name__ == "__main__":
    unittest.main()
