"""The picture of a profile of slices shows the surface of its result file, and nothing where it is interrupted."""

import unittest

import h5py
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from tests.figures import figures_written_by


def write_ramp(path, role="rail", absent=0):
    """A parabola that rises by 10 mm, over 3 slices and 5 stations, whose first lines are absent in the last slice."""
    u, y = np.linspace(0, 2, 5), np.linspace(-0.03, 0.03, 31)
    z = 0.005 * u[:, None] - 5 * y**2
    y = np.broadcast_to(y, z.shape).copy()
    y[-1, :absent] = z[-1, :absent] = np.nan
    with h5py.File(path, "w") as file:
        file.attrs.update(kind="sliced_profile", title="ramp", version="0", commit="0")
        file["role"] = role
        file["slices/u"], file["surface/u"], file["surface/y"], file["surface/z"] = u[::2], u, y, z


class SlicedProfilePictureTest(unittest.TestCase):
    def axes(self, **named):
        figure = figures_written_by(write_ramp, **named)["surface.png"]
        return [axes for part in figure.subfigs for axes in part.axes if axes.get_label() != "<colorbar>"]

    def test_the_surface_has_the_files_points(self):
        surface, sections = self.axes()
        (drawn,) = (part for part in surface.collections if isinstance(part, Poly3DCollection))
        self.assertEqual(len(drawn.get_facecolor()), 4 * 30)
        self.assertEqual([len(line.get_xdata()) for line in sections.lines], [31] * 3, "a section at each slice")
        for line, rise in zip(sections.lines, (0, 5, 10)):
            np.testing.assert_allclose(line.get_ydata(), rise - 5e-3 * line.get_xdata() ** 2, atol=1e-9)

    def test_an_interruption_is_left_out(self):
        *_, sections = self.axes(absent=10)
        self.assertEqual([np.isfinite(line.get_ydata()).sum() for line in sections.lines], [31, 31, 21])

    def test_a_wheel_has_angles(self):
        surface, _ = self.axes(role="wheel")
        self.assertIn("deg", surface.get_xlabel())


if __name__ == "__main__":
    unittest.main()
