"""A damaged result file gives its pictures, or one line that names it."""

import json
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

from tests.synthetic_results import write_model_problem

PYTHON_FOLDER = Path(__file__).resolve().parent.parent

# Draws a file with some bytes inverted here, then there, without writing the pictures; in a separate process, as
# HDF5 crashes over some or never returns.
DRAW = """
import contextlib, io, json, sys
from microslip import plot

plot.save_all = lambda *_: None
path, places = sys.argv[1], json.loads(sys.argv[2])
whole = open(path, "rb").read()
for place in places:
    damaged = bytearray(whole)
    damaged[place:place + 32] = bytes(byte ^ 0xFF for byte in whole[place:place + 32])
    open(path + ".damaged", "wb").write(damaged)
    print(json.dumps({"place": place}), flush=True)
    with contextlib.redirect_stderr(io.StringIO()) as errors:
        code = plot.main([path + ".damaged"])
    print(json.dumps({"place": place, "code": code, "errors": errors.getvalue()}), flush=True)
"""


class DamagedFileTest(unittest.TestCase):
    def outcomes(self, path, places):
        """Outcome of the file damaged at each of these offsets; None where HDF5 crashed or did not return."""
        found = {}
        while places:
            with subprocess.Popen([sys.executable, "-c", DRAW, path, json.dumps(places)], cwd=PYTHON_FOLDER,
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
                watch = threading.Timer(60, process.kill)
                watch.start()
                lines = [json.loads(line) for line in process.stdout]
                watch.cancel()
            self.assertLessEqual(process.returncode, 0)
            found.update({line["place"]: line if "code" in line else None for line in lines})
            places = [place for place in places if place not in found]
        return found

    def test_every_refusal_names_the_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "result.h5")
            write_model_problem(path, mx=4)
            outcomes = self.outcomes(path, list(range(0, 2200, 94)))  # how the file is built, and what belongs to all of it
            refused = [outcome for outcome in outcomes.values() if outcome and outcome["code"] != 0]
            self.assertGreater(len(refused), 10)
            for outcome in refused:
                self.assertEqual(outcome["code"], 2, outcome)
                self.assertRegex(outcome["errors"], rf"\Amicroslip\.plot: {path}\.damaged: [^\n]+\n\Z")


if __name__ == "__main__":
    unittest.main()
