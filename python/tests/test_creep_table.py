"""The creep-force table: linear theory, full sliding, the exact theory, derivatives by differences, batches, bad files."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled

SHIPPED = Path(microslip.__file__).resolve().parent / "hertz.creep"


def numbers(forces):
    return forces.fx, forces.fy, forces.mz


class CreepTableTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.table = microslip.CreepForceTable(poisson_ratio=0.28)

    def test_the_range(self):
        self.assertEqual(self.table.axis_ratios, (0.05, 20))
        self.assertEqual(self.table.poisson_ratios, (0.28,))

    def test_status_and_numbers_agree_whatever_the_contact(self):
        for changed in ({"b": 1e-300}, {"shear_modulus": 1e-300, "normal_force": 1e30}, {"normal_force": 1e-320}, {"a": 1e300}):
            batch = self.table.differentiate_batch(contact(), **changed)
            self.assertEqual(batch.forces.status, microslip.Status.invalid_input)
            self.assertTrue(np.all(np.isnan(batch.jacobian)) and np.isnan(batch.forces.fx))

    def test_as_accurate_as_the_exact_theory(self):
        exact = microslip.Solver(theory="exact", accuracy=0.003)
        for creepage in ((0.0005, 0.0002, 0.1), (0.001, -0.0008, 0.5), (-0.0003, 0.002, -0.2), (0.0, 0.0003, 1.0)):
            found, expected = self.table.solve(contact(creepage)), exact.solve(contact(creepage)).forces
            np.testing.assert_allclose(numbers(found)[:2], numbers(expected)[:2], atol=0.003 * 24e3)
            self.assertIs(found.status, microslip.Status.ok)

    def test_small_creepages_follow_linear_theory(self):
        c = microslip.creepage_coefficients(contact().a / contact().b, 0.28, "computed")
        expected = -contact().shear_modulus * contact().a * contact().b * c.c11 * 1e-9
        self.assertAlmostEqual(self.table.solve(contact((1e-9, 0, 0))).fx / expected, 1, delta=1e-5)

    def test_full_sliding_gives_mu_fn(self):
        self.assertAlmostEqual(self.table.solve(contact((1.0, 0, 0))).fx / -24e3, 1, delta=2e-4)

    def test_derivatives_are_those_of_the_forces(self):
        at = np.array([0.0007, 0.0004, 0.3])
        jacobian = self.table.differentiate(contact(at)).jacobian
        for k, step in enumerate((1e-8, 1e-8, 1e-5)):
            change = np.eye(3)[k] * step
            above, below = self.table.solve(contact(at + change)), self.table.solve(contact(at - change))
            slope = (np.array(numbers(above)) - numbers(below)) / (2 * step)
            np.testing.assert_allclose(slope, jacobian[:, k], rtol=1e-4, atol=1e-3 * abs(slope).max())

    def test_a_batch_is_its_contacts(self):
        xi = np.linspace(-0.002, 0.002, 7)
        batch = self.table.solve_batch(contact(), longitudinal=xi, threads=2)
        singles = [self.table.solve(contact((x, contact().creepage.lateral, contact().creepage.spin))).fx for x in xi]
        np.testing.assert_array_equal(batch.fx, singles)
        self.assertEqual(self.table.differentiate_batch(contact(), longitudinal=xi).jacobian.shape, (7, 3, 4))

    def test_beyond_the_range_is_a_status(self):
        batch = self.table.solve_batch(contact(), a=np.array([5e-3, 0.2, -1.0]))
        self.assertEqual([int(s) for s in batch.status], [0, microslip.Status.out_of_range, microslip.Status.invalid_input])

    def test_files_that_are_no_tables_are_refused(self):
        whole = SHIPPED.read_bytes()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "bad.creep"
            for bad, reason in ((b"", "is empty"), (b"#" * 1000, "is no creep-force table"), (whole[:-5], "cut short"),
                                (whole[:5000] + b"\x77\x13" + whole[5002:], "corrupted")):
                path.write_bytes(bad)
                with self.assertRaisesRegex(microslip.Error, reason):
                    microslip.CreepForceTable(path)
        with self.assertRaises(FileNotFoundError):
            microslip.CreepForceTable("none.creep")


load_tests = load_tests_if_compiled([CreepTableTest])
