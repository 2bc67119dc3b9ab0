"""The Python of the README and of docs/python.md runs as it stands there."""

import contextlib
import doctest
import io
import os
import re
import unittest
from pathlib import Path

from tests.compiled import load_tests_if_compiled

ROOT = Path(__file__).resolve().parents[2]


class ReadmeTest(unittest.TestCase):
    def setUp(self):
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(ROOT)

    def test_its_examples_give_what_they_say(self):
        text = (ROOT / "docs" / "python.md").read_text().replace("```", "\n")
        tests = doctest.DocTestParser().get_doctest(text, {}, "docs/python.md", None, 0)
        outcome = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(tests)
        self.assertEqual((outcome.failed, outcome.attempted), (0, 4))

    def test_its_python_runs(self):
        (code,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, "README.md", "exec"), {})
        fx, exact, shape = out.getvalue().split(maxsplit=2)
        self.assertAlmostEqual(float(fx) / float(exact), 1, delta=0.1)
        self.assertEqual(shape.strip(), "(2, 3)")


load_tests = load_tests_if_compiled([ReadmeTest])
