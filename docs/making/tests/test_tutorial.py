"""Tutorials become pages with what they print and draw."""

import tempfile
import traceback
import unittest
from importlib.util import find_spec
from pathlib import Path

import matplotlib

matplotlib.use("Agg")

from tutorial import cells, executed, notebook, page, prose

SCRIPT = '''# %% [markdown]
# # A title
#
# Some words.

# %%
import matplotlib.pyplot as plt
a = 2
print(a + 1)

# %%
plt.subplots(num="A picture")
print(__name__)
'''


class TutorialTest(unittest.TestCase):
    def page(self, text):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        script = self.folder / "lesson.py"
        script.write_text(text)
        self.parts = executed(script, self.folder)
        return page(self.parts)

    def test_cells_are_text_or_code(self):
        self.assertEqual([(is_text, first) for is_text, first, _ in cells(SCRIPT)], [(True, 2), (False, 7), (False, 12)])

    def test_text_is_without_signs(self):
        self.assertEqual(prose(["# # A title", "#", "# Some words.", ""]), "# A title\n\nSome words.")

    def test_output_and_pictures_stand_below_the_code(self):
        made = self.page(SCRIPT)
        self.assertTrue(made.startswith("# A title\n\nSome words.\n\n```python\nimport matplotlib"))
        self.assertIn("print(a + 1)\n```\n\n```text\n3\n```\n\n```python\n", made)
        self.assertTrue(made.endswith("```text\n__main__\n```\n\n![A picture](lesson_1.png)\n\n*A picture*\n"))
        self.assertEqual((self.folder / "lesson_1.png").read_bytes()[:4], b"\x89PNG")
        self.assertEqual(matplotlib.pyplot.get_fignums(), [])

    def test_what_the_last_line_is_worth_is_shown(self):
        made = self.page("# %%\n3 * 7\n\n# %%\nprint(1)\n")
        self.assertEqual(made, "```python\n3 * 7\n```\n\n```text\n21\n```\n\n```python\nprint(1)\n```\n\n```text\n1\n```\n")

    def test_tables_are_shown_as_such(self):
        made = self.page("# %%\nclass Table:\n    def _repr_html_(self):\n        return '<b>x</b>'\n\nTable()\n")
        self.assertTrue(made.endswith("```{raw} html\n<b>x</b>\n```\n"))

    @unittest.skipUnless(find_spec("nbformat"), "nbformat is not installed")
    def test_a_notebook_has_text_output_and_pictures(self):
        self.page(SCRIPT.replace("words", "[words](../page.md)") + "5\n")
        text, first, second = notebook(self.parts)["cells"]
        self.assertEqual(text["source"], "# A title\n\nSome words.")
        self.assertEqual(first["outputs"], [{"output_type": "stream", "name": "stdout", "text": "3\n"}])
        printed, value, picture = second["outputs"]
        self.assertEqual((printed["text"], value["data"]["text/plain"]), ("__main__\n", "5"))
        self.assertTrue(picture["data"]["image/png"].startswith("iVBOR"))

    @unittest.skipUnless(find_spec("nbformat"), "nbformat is not installed")
    def test_a_notebook_is_valid(self):
        import nbformat

        self.page(SCRIPT + "5\n")
        nbformat.validate(notebook(self.parts))

    def test_a_figure_needs_a_title(self):
        with self.assertRaisesRegex(ValueError, "needs a title"):
            self.page('# %%\nimport matplotlib.pyplot as plt\nplt.subplots()\n')
        matplotlib.pyplot.close("all")

    def test_errors_name_the_line(self):
        try:
            self.page("# %%\na = 1\n\n# %%\nb = 2\n1 / 0\n")
        except ZeroDivisionError as error:
            self.assertEqual(traceback.extract_tb(error.__traceback__)[-1].lineno, 6)
        else:
            self.fail("no error")

    def test_what_is_no_tutorial(self):
        for text in ("import os\n# %%\n", "# %% [markdown]\nimport os\n"):
            with self.assertRaises(ValueError):
                self.page(text)


if __name__ == "__main__":
    unittest.main()
