import unittest

import numpy as np

from microslip.interior_picture import panels_of


class InteriorPicture(unittest.TestCase):
    """Points in both bodies are drawn for each by itself."""

    def test_bodies_have_panels_of_their_own(self):
        x, z = (values.ravel() for values in np.meshgrid([-1e-3, 0, 1e-3], [-2e-3, -1e-3, 1e-3, 2e-3]))
        panels = panels_of((x, np.zeros(x.size), z, np.where(z > 0, 1.0, 2.0)))
        self.assertEqual([panel["held"].split(",")[0] for panel in panels], ["body 1", "body 2"])
        for panel, stress in zip(panels, (1.0, 2.0)):
            self.assertEqual(set(panel["stress"]), {stress})
            self.assertEqual(panel["stress"].size, 6)

    def test_one_body_has_one(self):
        z = np.array([1e-3, 2e-3])
        self.assertEqual(len(panels_of((0 * z, 0 * z, z, z))), 1)


if __name__ == "__main__":
    unittest.main()
