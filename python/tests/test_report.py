"""Reports: balances of results, numbers and units as people write them."""

import unittest

import numpy as np

from microslip.report_checks import checks
from microslip.report_template import number, typeset, unit


class Result:
    """A result file of these datasets."""

    def __init__(self, kind, datasets):
        self.kind, self.datasets = kind, datasets

    def attribute(self, _name, _default=None):
        """Its kind."""
        return self.kind

    def __contains__(self, name):
        return any(path == name or path.startswith(name + "/") for path in self.datasets)

    def array(self, name, dimensions=1, finite=True):
        """A dataset."""
        values = np.asarray(self.datasets[name], dtype=float)
        assert values.ndim == dimensions and (np.isfinite(values).all() or not finite)
        return values

    def number(self, name):
        """A single number."""
        return float(self.array(name, dimensions=0))

    def unit(self, name):
        """Its unit."""
        return {"exact/frictional_power": "W"}[name]


def two_bodies(**changed):
    """Two elements of 1 m^2 whose tractions add up."""
    datasets = {"exact/fields/area": [[1, 1]], "exact/fields/px": [[-2, -3]], "exact/fields/py": [[0, 0]], "exact/fields/bound": [[4, 4]],
                "exact/fields/pressure": [[10, 20]], "hertz/normal_force": 30, "exact/fx": -5, "exact/fy": 0,
                "exact/frictional_power": 7, "exact/power_by_creepage": 7}
    return Result("rolling_contact", {**datasets, **{name.replace("__", "/"): value for name, value in changed.items()}})


def wheel(**changed):
    """A wheel with two patches in the first of two states and one in the second, the surface there inclined by 30 degrees."""
    angle = np.pi / 6
    normal, fy = 100.0, 20.0
    y, z = fy * np.cos(angle) - normal * np.sin(angle), normal * np.cos(angle) + fy * np.sin(angle)
    datasets = {"patches/state": [0, 0, 1], "patches/normal_force": [50, 70, normal], "patches/fx": [1, 2, 3], "patches/fy": [4, 5, fy],
                "patches/angle": [0, 0, angle], "patches/frictional_power": [6, 7, 8], "wheel/force_x": [3, 3], "wheel/force_y": [9, y],
                "wheel/force_z": [120, z], "wheel/frictional_power": [13, 8], "states/vertical_force": [120, z]}
    return Result("wheel_rail", {**datasets, **{name.replace("__", "/"): value for name, value in changed.items()}})


def apart(result):
    """How far what is compared differs, by its name."""
    return {row["name"]: float(row["apart"]) for row in checks(result)}


class Checks(unittest.TestCase):
    """Balances that hold, and each of them broken."""

    def test_balances_of_two_bodies_hold(self):
        self.assertEqual(apart(two_bodies()), {"pressures = normal force": 0, "tractions = fx": 0, "tractions = fy": 0,
                                               "power of friction = of the forces": 0})

    def test_each_broken_balance_of_two_bodies_is_told(self):
        for changed, name, by in (({"exact__fx": -6}, "tractions = fx", 1 / 8), ({"exact__fy": 2}, "tractions = fy", 2 / 8),
                                  ({"hertz__normal_force": 40}, "pressures = normal force", 10 / 40),
                                  ({"exact__power_by_creepage": 14}, "power of friction = of the forces", 1)):
            found = apart(two_bodies(**changed))
            self.assertAlmostEqual(found.pop(name), by, delta=0.05 * by)
            self.assertEqual(set(found.values()), {0})

    def test_the_worst_state_of_a_wheel_is_told(self):
        self.assertLess(max(apart(wheel()).values()), 1e-15)
        row = next(row for row in checks(wheel(wheel__force_x=[3, 4])) if row["name"] == "patches = Fx")
        self.assertEqual((row["left"], row["right"], row["unit"]), ("3", "4", "N"))
        self.assertGreater(apart(wheel(states__vertical_force=[120, 90]))["Fz = load given"], 0.05)

    def test_states_without_a_result_are_left_out(self):
        nothing = wheel(wheel__force_x=[3, np.nan], wheel__force_y=[9, np.nan], wheel__force_z=[120, np.nan])
        self.assertEqual(apart(nothing)["patches = Fx"], 0)

    def test_a_nip_takes_the_power_that_it_loses(self):
        nip = {"nip__slip_power": 3, "nip__hysteresis_power": 12, "nip__drive1": -10, "nip__drive2": 20, "inputs__motion__rolling_speed": 2,
               "exact__creepage_longitudinal": -0.25}
        found = apart(two_bodies(**nip))  # -10 N at 2.25 m/s, 20 N at 1.75 m/s: 12.5 W of 15 W
        self.assertAlmostEqual(found["power of drives = slip + hysteresis"], 2.5 / 15, delta=0.01)
        self.assertNotIn("power of friction = of the forces", found)


class Typesetting(unittest.TestCase):
    """Numbers, units and texts."""

    def test_numbers(self):
        for text, shown in (("-14.06", "−14.06"), ("inf", "∞"), ("-inf", "−∞"), ("1.2e-05", "1.2·10<sup>−5</sup>"), ("40, 40", "40, 40"),
                            ("second_order", "second_order"), ("60e1.prr", "60e1.prr"), ("0.1, -0.2", "0.1, −0.2")):
            self.assertEqual(str(number(text)), shown)

    def test_units(self):
        for text, shown in (("mm^2", "mm²"), ("ug/m", "µg/m"), ("-", ""), ("um", "µm"), ("N m", "N\u00a0m"),
                            ("mu Fn sqrt(a b)", "µ<i>F</i><sub>n</sub>\u00a0√(ab)")):
            self.assertEqual(str(unit(text)), shown)

    def test_texts(self):
        self.assertEqual(str(typeset("40 x 40 elements <b>")), "40 × 40 elements &lt;b&gt;")
        self.assertEqual(str(typeset("lateral force fy")), "lateral force <i>f</i><sub>y</sub>")


if __name__ == "__main__":
    unittest.main()
