"""Tutorials run as notebooks, and a cell that fails is named."""

import contextlib
import io
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

NEEDED = ("nbformat", "nbclient", "ipykernel")

GOOD = """# %% [markdown]
# # A lesson

# %%
number = 2

# %%
open("examples/contacts.csv").close()
number + 1
"""


@unittest.skipUnless(all(map(find_spec, NEEDED)), f"needs {', '.join(NEEDED)}")
class NotebooksTest(unittest.TestCase):
    def run_lessons(self, *words, **lessons):
        import notebooks

        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, text in lessons.items():
            (self.folder / f"{name}.py").write_text(text)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            code = notebooks.main(self.folder / "made", words, self.folder)
        return code, out.getvalue()

    def notebook(self, name):
        import nbformat

        return nbformat.read(self.folder / "made" / f"{name}.ipynb", as_version=4)

    def test_cells_run_one_after_the_other_beside_the_examples(self):
        code, said = self.run_lessons(good=GOOD)
        self.assertEqual(code, 0)
        self.assertRegex(said, r"^good: \d+ s\n$")
        text, first, second = self.notebook("good").cells
        self.assertEqual(text.source, "# A lesson")
        self.assertEqual([first.outputs, second.outputs[0].data["text/plain"]], [[], "3"])

    def test_a_cell_that_fails_is_named_and_others_go_on(self):
        code, said = self.run_lessons(bad=GOOD.replace("number + 1", "number / 0"), good=GOOD)
        self.assertEqual(code, 1)
        self.assertIn("bad.py:8: cell 3 of 3 fails: ZeroDivisionError: division by zero\n", said)
        self.assertIn("good:", said)
        self.assertEqual(self.notebook("bad").cells[2].outputs[0].output_type, "error")

    def test_a_kernel_that_dies_is_told(self):
        code, said = self.run_lessons(bad=GOOD.replace("number = 2", "import os; os._exit(1)"))
        self.assertEqual(code, 1)
        self.assertIn("bad.py:5: cell 2 of 3 fails: Kernel died", said)

    def test_words_choose(self):
        self.assertEqual(self.run_lessons("oo", good=GOOD, bad="1 +")[0], 0)
        with self.assertRaises(SystemExit):
            self.run_lessons("none", good=GOOD)


if __name__ == "__main__":
    unittest.main()
