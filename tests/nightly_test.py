#!/usr/bin/env python3
"""tools/nightly with the programs that it calls replaced by scripts that only end: nightly_test.py ROOT"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
NIGHTLY = ROOT / "tools" / "nightly"


def named_programs():
    """The programs that the steps call, by the name of the step."""
    steps = subprocess.run([NIGHTLY, "--list"], text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()
    return {step.partition(":")[0]: re.findall(r"(?:tools|build/release/bin)/\w+", step) for step in steps}


class NightlyTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "tools").mkdir()
        shutil.copy(NIGHTLY, self.folder / "tools")
        subprocess.run(["git", "init", "-q", self.folder], check=True)  # `tidy` lists the sources

    def run_nightly(self, *arguments, codes=None):
        """What it did and the outcome of each step, with programs that have other exit codes than 0."""
        for program in {program for programs in named_programs().values() for program in programs}:
            script = self.folder / program
            script.parent.mkdir(parents=True, exist_ok=True)
            script.write_text(f"#!/bin/sh\necho this is {script.name}\nexit {(codes or {}).get(script.name, 0)}\n")
            script.chmod(0o755)
        done = subprocess.run([self.folder / "tools" / "nightly", *arguments], text=True, capture_output=True)
        return done, dict(re.findall(r"^  (\w+) +(ok|FAILED|skipped) +\d+ s$", done.stdout, re.MULTILINE))

    def test_each_tool_is_there(self):
        for name, programs in named_programs().items():
            self.assertTrue(programs, name)
            for program in programs:
                self.assertTrue((ROOT / program).is_file() or program.startswith("build/"), program)

    def test_all_that_end_well(self):
        done, outcomes = self.run_nightly()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(outcomes, dict.fromkeys(named_programs(), "ok"))

    def test_the_others_run_after_one_that_fails(self):
        done, outcomes = self.run_nightly(codes={"figures": 1, "links": 77})
        self.assertEqual(done.returncode, 1)
        self.assertEqual(outcomes, {**dict.fromkeys(named_programs(), "ok"), "figures": "FAILED", "links": "skipped"})
        self.assertIn("this is figures", done.stdout)
        self.assertNotIn("this is pictures", done.stdout)
        self.assertEqual((self.folder / "build" / "nightly" / "pictures.log").read_text(), "this is pictures\n")

    def test_what_is_skipped_is_no_failure(self):
        self.assertEqual(self.run_nightly("links", codes={"links": 77})[0].returncode, 0)

    def test_steps_are_chosen(self):
        self.assertEqual(self.run_nightly("fuzz", "links")[1], {"fuzz": "ok", "links": "ok"})
        done, outcomes = self.run_nightly("fuzz", "buzz")
        self.assertEqual((done.returncode, outcomes), (2, {}))
        self.assertIn("no step 'buzz'", done.stderr)


if __name__ == "__main__":
    unittest.main()
