#!/usr/bin/env python3
"""tools/nightly with the tools that it calls replaced by scripts that only end: nightly_test.py ROOT"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1) if len(sys.argv) > 1 else ".").resolve()
NIGHTLY = ROOT / "tools" / "nightly"


def named_tools():
    """The tools that the steps call, by the name of the step."""
    steps = subprocess.run([NIGHTLY, "--list"], text=True, stdout=subprocess.PIPE, check=True).stdout.splitlines()
    return {step.partition(":")[0]: re.search(r"\btools/(\w+)", step)[1] for step in steps}


class NightlyTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "tools").mkdir()
        shutil.copy(NIGHTLY, self.folder / "tools")
        subprocess.run(["git", "init", "-q", self.folder], check=True)  # `tidy` lists the sources

    def run_nightly(self, *arguments, codes=None):
        """The exit code and the outcome of each step, with tools that have other exit codes than 0."""
        for tool in set(named_tools().values()):
            script = self.folder / "tools" / tool
            script.write_text(f"#!/bin/sh\necho this is {tool}\nexit {(codes or {}).get(tool, 0)}\n")
            script.chmod(0o755)
        done = subprocess.run([self.folder / "tools" / "nightly", *arguments], text=True, capture_output=True)
        return done, dict(re.findall(r"^  (\w+) +(ok|FAILED|skipped) +\d+ s$", done.stdout, re.MULTILINE))

    def test_each_tool_is_there(self):
        for tool in named_tools().values():
            self.assertTrue((ROOT / "tools" / tool).is_file(), tool)

    def test_all_that_end_well(self):
        done, outcomes = self.run_nightly()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(outcomes, dict.fromkeys(named_tools(), "ok"))

    def test_the_others_run_after_one_that_fails(self):
        done, outcomes = self.run_nightly(codes={"figures": 1, "links": 77})
        self.assertEqual(done.returncode, 1)
        self.assertEqual(outcomes, {**dict.fromkeys(named_tools(), "ok"), "figures": "FAILED", "links": "skipped"})
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
