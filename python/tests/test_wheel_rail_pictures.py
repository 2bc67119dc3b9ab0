"""The pictures of a wheel on a rail show the numbers of their file; outlines are arcs with closed forms."""

import tempfile
import unittest
from pathlib import Path

import h5py
import matplotlib
import numpy as np
from matplotlib.quiver import Quiver

from microslip import plot
from microslip.picture_style import SETTINGS
from microslip.result_file import ResultError, ResultFile
from microslip.profile_tractions_picture import line_loads
from microslip.wheel_rail_pictures import RailHead, envelope, minima, read_patches
from tests.synthetic_results import fastsim

RADIUS, MIDDLE = 0.3, 0.75
PATCH = {"place_x": 1e-3, "place_y": MIDDLE, "place_z": 0.0, "angle": 0.0, "rail_y": 0.0, "wheel_y": 0.002, "normal_force": 80e3,
         "creepage_longitudinal": 1e-3, "creepage_lateral": 5e-4, "spin": 0.2, "rolling_speed": 30.0}


def arc(radius):
    """An arc that is highest above the middle of the rail."""
    angle = np.linspace(-0.1, 0.1, 2001)
    return MIDDLE + radius * np.sin(angle), radius * (np.cos(angle) - 1)


def write_wheel_rail(path, states=1, side="left", fields=True):
    """A file of kind wheel_rail with a patch in each state."""
    with h5py.File(path, "w") as file:
        file.attrs.update({"kind": "wheel_rail", "title": "arcs", "version": "0.1.0", "commit": "abc"})
        file["inputs/wheel/side"] = side
        for name in ("force_x", "force_y", "t_gamma", "t_gamma_with_spin", "frictional_power"):
            file[f"wheel/{name}"] = np.linspace(1, 2, states)
        file["patches/state"] = np.arange(states)
        for name, value in PATCH.items():
            file[f"patches/{name}"] = np.full(states, value)
        for body, radius in (("rail", RADIUS), ("wheel", 2 * RADIUS)):
            y, z = arc(radius)
            file[f"profiles/{body}/y"], file[f"profiles/{body}/z"] = y - MIDDLE, z
            if states == 1:
                forward = 1 if side == "left" else -1
                file[f"outlines/{body}/y"], file[f"outlines/{body}/z"] = y[::forward], z[::forward]
        if states > 1:
            file["states/lateral"] = np.linspace(0, 5e-3, states)
            file["states/lateral"].attrs["unit"] = "m"
            file["states"].attrs["varied"] = "lateral, yaw"
        elif fields:
            for name, values in fastsim(6e-3, 4e-3, 12, 12, (1e-3, 5e-4, 0.2), 24e3).items():
                file[f"fields/0/{name}"] = values
            file["fields/0/pressure"] = file["fields/0/bound"][()] / 0.3


class WheelRailPicturesTest(unittest.TestCase):
    def file(self, **what):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = Path(folder.name) / "result.h5"
        write_wheel_rail(path, **what)
        return path

    def figures(self, **what):
        with ResultFile(self.file(**what)) as result, matplotlib.rc_context(SETTINGS):
            return plot.pictures(result)

    def test_a_state_has_patches_and_gap_and_a_sweep_has_curves(self):
        self.assertEqual(sorted(self.figures()), ["gap.png", "patches.png", "rail_head.png", "tractions_on_profiles.png"])
        self.assertEqual(sorted(self.figures(fields=False)), ["gap.png"])
        self.assertEqual(sorted(self.figures(states=4)), ["contact_points.png", "forces.png"])

    def test_differences_of_wheels_are_of_each_patch(self):
        one, two = self.file(), self.file()
        with h5py.File(two, "a") as file:
            file["fields/0/pressure"][...] *= 1.5
        figures = plot.figures(one, other=two)
        self.assertEqual(sorted(figures), ["difference_pressure.png", "difference_traction.png"])
        a, b, difference = (axes.images[0].get_array() for axes in figures["difference_pressure.png"].axes[:3])
        self.assertAlmostEqual(difference.max(), 0.5 * a.max())
        self.assertAlmostEqual(b.max(), 1.5 * a.max())

    def test_arrows_on_the_profiles_are_the_forces_of_rows(self):
        with ResultFile(self.file()) as result, matplotlib.rc_context(SETTINGS):
            (cells,) = read_patches(result, RailHead(result))
            fields = {name: result.array(f"/fields/0/{name}", dimensions=2) for name in ("pressure", "px", "py", "area")}
            figure = plot.pictures(result)["tractions_on_profiles.png"]
        u, *loads = line_loads(cells)
        for load, name in zip(loads, ("pressure", "px", "py")):
            force = np.sum(fields[name] * fields["area"])  # the areas of this file are scaled to a load, by 0.4 %
            self.assertAlmostEqual(load.sum() * cells.height / force, 1, delta=0.006)
        shape, components = figure.axes
        on_wheel, on_rail = (arrows for arrows in shape.collections if isinstance(arrows, Quiver))
        np.testing.assert_array_equal(on_wheel.U, -on_rail.U)
        np.testing.assert_array_equal(on_wheel.V, -on_rail.V)
        self.assertTrue(np.all(on_wheel.V > 0), "the rail presses the wheel up")
        normal = components.get_lines()[0]
        np.testing.assert_allclose(normal.get_xdata(), u)
        np.testing.assert_allclose(normal.get_ydata() / loads[0], normal.get_ydata().max() / loads[0].max())

    def test_curves_over_a_sweep_are_those_of_the_file(self):
        forces = self.figures(states=4)["forces.png"].axes[0]
        lines = {line.get_label(): line for line in forces.get_lines()}
        np.testing.assert_allclose(lines["$F_x$, forward"].get_xdata(), np.linspace(0, 5, 4))
        np.testing.assert_allclose(lines["$F_x$, forward"].get_ydata(), np.linspace(1, 2, 4))  # in N
        self.assertEqual(self.figures(states=4)["forces.png"].axes[3].get_xlabel(), "lateral [mm]")

    def test_patches_lie_where_the_file_says_on_either_side(self):
        for side in ("left", "right"):
            with ResultFile(self.file(side=side)) as result:
                rail = RailHead(result)
                self.assertTrue((np.diff(rail.y) > 0).all())
                cells, = read_patches(result, rail)
            inside = cells.state != 0
            self.assertAlmostEqual(cells.x[inside].mean(), 1.0, delta=0.1)
            self.assertAlmostEqual(cells.y[inside].mean(), 0.0, delta=0.1)
            self.assertAlmostEqual(cells.y[inside].max(), 4, delta=0.5)

    def test_the_rails_head_is_measured_along_its_surface(self):
        with ResultFile(self.file()) as result:
            rail = RailHead(result)
        u = np.array([-20.0, 0.0, 15.0])
        y, z, normal_y, normal_z = rail.at(u)
        np.testing.assert_allclose(y, 1e3 * MIDDLE + 300 * np.sin(u / 300), atol=1e-4)
        np.testing.assert_allclose(z, 300 * (np.cos(u / 300) - 1), atol=1e-4)
        np.testing.assert_allclose(normal_y, np.sin(u / 300), atol=1e-3)
        np.testing.assert_allclose(normal_z, np.cos(u / 300), atol=1e-3)
        self.assertAlmostEqual(rail.nearest(1e3 * MIDDLE, 0.0), 0, delta=0.1)

    def test_the_gap_between_arcs_has_its_minimum_where_they_touch(self):
        axes = self.figures()["gap.png"].axes[1]
        points = next(line for line in axes.get_lines() if line.get_marker() == "o")
        np.testing.assert_allclose(points.get_xdata(), [0.0], atol=0.05)  # from the rail's highest point, which is the middle
        np.testing.assert_allclose(points.get_ydata(), [0.0], atol=1e-4)

    def test_envelopes_see_the_outermost_sheet(self):
        y, z = np.array([0.0, 2.0, 1.0, 3.0]), np.array([0.0, 2.0, 3.0, 3.0])  # turns back between 1 and 2
        np.testing.assert_allclose(envelope(y, z, np.array([0.5, 1.5, 2.5]), True), [0.5, 3.0, 3.0])
        np.testing.assert_allclose(envelope(y, z, np.array([0.5, 1.5, 2.5]), False), [0.5, 1.5, 3.0])
        self.assertTrue(np.isnan(envelope(y, z, np.array([5.0]), True)).all())

    def test_minima_are_no_saddles(self):
        x = np.linspace(-2, 2, 401)
        self.assertEqual(list(minima((x**2 - 1) ** 2, 25)), [100, 300])
        values = np.where(np.abs(x) > 1.5, np.nan, x)
        self.assertEqual(len(minima(values, 25)), 1)

    def test_what_is_missing_is_named(self):
        path = self.file()
        with h5py.File(path, "a") as file:
            del file["outlines/rail/y"]
        with ResultFile(path) as result, self.assertRaisesRegex(ResultError, "no dataset /outlines/rail/y"):
            plot.pictures(result)


if __name__ == "__main__":
    unittest.main()
