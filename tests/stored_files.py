"""Files that earlier versions wrote are read by this one, and cases give what they gave.

Usage: stored_files.py BUILD SOURCE checks SOURCE/tests/stored/VERSION; stored_files.py BUILD SOURCE --write VERSION makes such
a folder with this version, once, when it is released.

A folder has case files, result files, and columns.json: of each result file the tables that `microslip
convert` writes of it, by column how many numbers it has and their sum, and of each case the forces that it gave.
"""

import csv
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

WRITTEN = sys.argv[sys.argv.index("--write") + 1] if "--write" in sys.argv else ""
BUILD, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
STORED = SOURCE / "tests/stored"
TOLERANCE = 1e-4  # of forces, by which a solver may change within a major version
COMMANDS = {
    "contact": "solve contact.toml -o {} --no-pictures", "wheel": "solve wheel.toml -o {} --no-pictures", "wheelset": "solve wheelset.toml -o {} --no-pictures",
    "nip": "solve nip.toml -o {} --no-pictures", "sweep": "sweep sweep.toml -o {}/result.h5", "profile": "profile wheel.prw -o {} --no-pictures",
    "statistics": "statistics sweep.h5 -o {} --no-pictures", "conicity": "conicity wheel.prw 60E1 --amplitudes 0.001 0.007 0.001 -o {} --no-pictures",
    "contact_run": "run contact_run.inp -o {}", "slices": "profile wheel.slcw -o {} --no-pictures",
    "fit": "fit points.csv --case contact.toml --model coulomb -o {} --no-pictures", "response": "respond contact.toml --wavelength 10mm 1m --points 2 -o {} --no-pictures",
}


def run(command, folder):
    environment = {**os.environ, "PATH": f"{BUILD}/bin:{os.environ.get('PATH', '')}"} # results state the command: no folders of this machine in it
    done = subprocess.run(["microslip", *command.split()], cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{command}: {done.stderr}")
    return done.stdout


def columns_of(result):
    """Of each table that is made of a result file: how many numbers a column has, and their sum."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        run(f"convert {result} -o {folder}/t.csv", folder)
        for path in sorted(Path(folder).glob("*.csv")):
            with path.open(encoding="utf-8", newline="") as file:
                head, *rows = csv.reader(line for line in file if not line.startswith("#"))
            for at, name in enumerate(head):
                numbers = [number for row in rows if (number := number_of(row[at])) is not None]
                found[f"{path.name}: {name}"] = [len(numbers), math.fsum(numbers)]
    return found


def number_of(text):
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None


def forces_of(case):
    """Of a case's document: the forces of its theories, or of its wheel or wheelset."""
    with tempfile.TemporaryDirectory() as folder:
        document = json.loads(run(f"solve {case.name} --json --no-pictures -o {folder}", case.parent))
    found = {}
    for group in ("exact", "fastsim2", "wheel", "wheelset"):
        for name in ("fx", "fy", "mz", "force_x", "force_y", "force_z"):
            if name in document.get(group, {}):
                found[f"{group}/{name}"] = document[group][name] if isinstance(document[group][name], list) else [document[group][name]]
    return found


def is_case(path):
    return "[grid]" not in path.read_text(encoding="utf-8")  # of sweeps


def write(version):
    folder = STORED / version
    with tempfile.TemporaryDirectory() as parent:
        made = shutil.copytree(folder, Path(parent) / "made")
        for name, command in COMMANDS.items():
            (made / name).mkdir()
            run(command.format(name), made)
            (result,) = (made / name).glob("*.h5")
            shutil.copy(result, folder / f"{name}.h5")
    known = {"tables": {path.name: columns_of(path) for path in sorted(folder.glob("*.h5"))},
             "cases": {path.name: forces_of(path) for path in sorted(folder.glob("*.toml")) if is_case(path)}}
    (folder / "columns.json").write_text(json.dumps(known, indent=1) + "\n", encoding="utf-8")


class StoredFiles(unittest.TestCase):
    def folders(self):
        folders = sorted(STORED.iterdir())
        self.assertTrue(folders)
        return [(folder, json.loads((folder / "columns.json").read_text(encoding="utf-8"))) for folder in folders]

    def test_results_are_read(self):
        for folder, known in self.folders():
            self.assertEqual(sorted(known["tables"]), sorted(path.name for path in folder.glob("*.h5")))
            for name, columns in known["tables"].items():
                with self.subTest(f"{folder.name}/{name}"):
                    found = columns_of(folder / name)
                    for column, (count, total) in columns.items():
                        self.assertEqual(found[column][0], count, column)
                        self.assertTrue(math.isclose(found[column][1], total, rel_tol=1e-12, abs_tol=1e-300), (column, found[column][1], total))

    def test_pictures_are_drawn_of_them(self):
        for folder, known in self.folders():
            for name in known["tables"]:
                with self.subTest(f"{folder.name}/{name}"), tempfile.TemporaryDirectory() as pictures:
                    run(f"plot {folder / name} -o {pictures}", folder)
                    self.assertTrue(list(Path(pictures).glob("*.png")))

    def test_cases_give_what_they_gave(self):
        for folder, known in self.folders():
            for name, forces in known["cases"].items():
                with self.subTest(f"{folder.name}/{name}"):
                    found = forces_of(folder / name)
                    largest = max(abs(value) for values in forces.values() for value in values)
                    for quantity, values in forces.items():
                        for one, other in zip(found[quantity], values, strict=True):
                            self.assertLessEqual(abs(one - other), TOLERANCE * largest, quantity)


if __name__ == "__main__":
    if WRITTEN:
        write(WRITTEN)
    else:
        del sys.argv[1:]
        unittest.main()
