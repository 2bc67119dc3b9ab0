"""What each command prints with --json is what app/schemas/documents.json says, and every member of it is in the schema.

Usage: program_documents.py BUILD SOURCE, folders. Ends with 77 without the module jsonschema.
"""

import json
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import jsonschema
except ModuleNotFoundError:
    print("SKIPPED: needs the Debian package python3-jsonschema")
    sys.exit(77)

SOURCE, BUILD = Path(sys.argv.pop()).resolve(), Path(sys.argv.pop()).resolve()
SCHEMA = json.loads((SOURCE / "app/schemas/documents.json").read_text(encoding="utf-8"))

BODIES = """
[body1]
rolling_radius = 0.46
transverse_radius = inf
young_modulus = 2.1e11
poisson_ratio = 0.28
[body2]
rolling_radius = inf
transverse_radius = 0.3
young_modulus = 2.1e11
poisson_ratio = 0.28
[load]
normal_force = 80000
[friction]
coefficient = 0.3
[motion]
creepage_longitudinal = 1e-3
rolling_speed = 30
"""
COVERED = """
[body1]
rolling_radius = 0.1
transverse_radius = inf
young_modulus = 2.1e11
poisson_ratio = 0.28
[body2]
rolling_radius = 0.15
transverse_radius = inf
young_modulus = 2.1e11
poisson_ratio = 0.28
[[body2.layers]]
thickness = 0.015
hardness = 60
poisson_ratio = 0.499
[load]
normal_force = 10000
[friction]
coefficient = 0.6
[motion]
rolling_speed = 5
[solution]
theory = "exact"
grid = 12
"""
EXACT = BODIES + '[solution]\ntheory = "exact"\ngrid = 8\n'
STARTING = EXACT.replace("[motion]", '[motion]\nkind = "transient"\nsteps = 3')
WHEEL = """
[rail]
profile = "60E1"
[track]
gauge = 1.435
cant = 0.025
[wheelset]
profile = "S1002"
nominal_radius = 0.46
flange_back_distance = 1.36
[wheel]
vertical_force = 80000
lateral = 0.003
forward_velocity = 20
[material]
young_modulus = 2.1e11
poisson_ratio = 0.28
[friction]
coefficient = 0.3
"""
POINTS = "creepage_longitudinal [%],adhesion_coefficient\n0.1,0.1\n0.3,0.2\n0.6,0.28\n1,0.3\n2,0.3\n"
FILES = {"contact.toml": BODIES, "exact.toml": EXACT, "covered.toml": COVERED, "starting.toml": STARTING, "wheel.toml": WHEEL, "points.csv": POINTS,
         "receptance.csv": "frequency [Hz],receptance_real [m/N],receptance_imaginary [m/N]\n0,1e-8,0\n2000,1e-9,-1e-9\n",
         "rail.slcs": f"0 1000\n2\n0\n1 1\n-.1 '{SOURCE}/examples/profiles/60e1.prr'\n.3 '{SOURCE}/examples/profiles/60e1.prr'\n0\n"}

#: In this order: some read what others write.
COMMANDS = [
    ("solve contact.toml --no-pictures", "rolling_contact"), ("solve exact.toml -o exact --no-pictures", "rolling_contact"), ("solve covered.toml --no-pictures", "rolling_contact"),
    ("solve starting.toml --no-pictures", "rolling_contact"), ("solve wheel.toml --no-pictures", "wheel_rail"), (f"solve {SOURCE}/examples/wheelset_in_curve.toml --no-pictures", "wheelset"),
    ("hertz contact.toml", "hertz"), (f"batch {SOURCE}/examples/contacts.csv -o contacts.csv", "batch"),
    (f"sweep {SOURCE}/examples/creep_sweep.toml -o sweep.h5", "sweep"), ("statistics sweep.h5", "statistics"),
    (f"run {SOURCE}/examples/sphere_on_plane.inp", "contact_run"), (f"profile {SOURCE}/examples/profiles/s1002.prw", "profile"),
    (f"profile {SOURCE}/examples/profiles -o profiles --no-pictures", "profiles"), ("profile rail.slcs", "sliced_profile"),
    ("conicity S1002 60E1", "conicity"), ("fit points.csv --case contact.toml --model coulomb", "creep_curve_fit"),
    ("respond exact.toml --wavelength 10mm 1m --points 2", "frequency_response"), ("convert exact/result.h5 -o exact.csv", "convert"),
    ("respond wheel.toml --wavelength 20mm 1m --points 4 --poles 4", "frequency_response"), ("respond exact.toml --wavelength 20mm 1m --points 2 --receptance receptance.csv", "frequency_response"),
    ("table show", "table"),
    ("validate model-problem --no-pictures", "validate"), ("plot exact/result.h5 -o pictures", "plot"), ("report contact.toml -o contact.html", "report"),
]
UNTRIED = {"bench"}  # which takes a minute


class ProgramDocuments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)
        cls.validator = jsonschema.Draft202012Validator(SCHEMA)

    def test_every_kind_is_tried(self):
        self.assertEqual({kind for _, kind in COMMANDS} | UNTRIED, set(SCHEMA["properties"]["kind"]["enum"]))

    def test_documents_are_those_of_the_schema(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in FILES.items():
                (Path(folder) / name).write_text(text, encoding="utf-8")
            for command, kind in COMMANDS:
                with self.subTest(command):
                    self.check(self.document_of(command, folder), kind)

    def document_of(self, command, folder):
        done = subprocess.run([BUILD / "bin/microslip", *command.split(), "--json"], cwd=folder, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def check(self, document, kind):
        self.assertEqual(document["kind"], kind)
        for error in self.validator.iter_errors(document):
            self.fail(f"{'/'.join(map(str, error.absolute_path))}: {error.message[:300]}")
        described = SCHEMA["$defs"][kind]
        parts = [described, *(SCHEMA["$defs"][part["$ref"].rsplit("/", 1)[1]] for part in described.get("allOf", []))]
        names = SCHEMA["properties"].keys() | {name for part in parts for name in part["properties"]}
        patterns = [pattern for part in parts for pattern in part.get("patternProperties", {})]
        self.assertEqual([name for name in document if name not in names and not any(re.search(one, name) for one in patterns)], [])


if __name__ == "__main__":
    unittest.main()
