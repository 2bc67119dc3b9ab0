"""Figures of the studies that are not met, beside those that the pages show so."""

import contextlib
import io
import stat
import tempfile
import unittest
from pathlib import Path

import studies

PAGE = """```text
  error of A                   0.2  <= 0.1             NOT MET
  error of B                   0.1  <= 0.1             ok
```
"""


class StudiesTest(unittest.TestCase):
    def expected(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "page.md"
            page.write_text(PAGE)
            return studies.known([page])

    def test_what_a_page_shows_as_not_met_is_expected_with_any_figure(self):
        self.assertEqual(studies.unexpected("  error of A   0.3  <= 0.1    NOT MET\n", self.expected()), [])

    def test_what_a_page_shows_as_met_is_not(self):
        self.assertEqual(studies.unexpected("heading\n  error of B  0.3  <= 0.1  NOT MET\n", self.expected()), ["error of B  0.3  <= 0.1  NOT MET"])

    def run_program(self, text, code):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program"
            program.write_text(f"#!/bin/sh\necho \"{text}\"\nexit {code}\n")
            program.chmod(program.stat().st_mode | stat.S_IXUSR)
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                return studies.main(program, []), out.getvalue()

    def test_the_exit_code_says_whether_there_are_any(self):
        self.assertEqual(self.run_program("error of nothing known 3 NOT MET", 1)[0], 1)
        self.assertIn("error of nothing known 3 NOT MET", self.run_program("error of nothing known 3 NOT MET", 1)[1])
        self.assertEqual(self.run_program("error of nothing known 3 ok", 0)[0], 0)

    def test_a_program_that_fails_is_no_success(self):
        self.assertEqual(self.run_program("error", 2)[0], 2)


if __name__ == "__main__":
    unittest.main()
