"""The reference of the Python module has every public name, with its types and its text."""

import importlib.util
import unittest

import microslip
from microslip import plot
from python_names import first_sentence, reference, text_of


@unittest.skipUnless(importlib.util.find_spec("microslip._core"), "not compiled")
class ReferenceTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = reference(microslip, plot)

    def test_every_name_is_there(self):
        names = [name for name in dir(microslip) if getattr(getattr(microslip, name), "__module__", None) == "microslip"]
        self.assertGreater(len(names), 50)
        for name in names:
            self.assertIn(f"\n### {name}\n", self.made)
            self.assertIn(f"| [`{name}`](#{name.lower()}) | ", self.made)

    def test_methods_have_the_types_of_the_stub(self):
        self.assertIn("#### RowSolver.solve\n", self.made)
        self.assertIn('Fastsim2(mx: int=10, my: int=10, *, direction: Literal[\'forward\', \'backward\']', self.made)
        self.assertNotIn("self: microslip", self.made)

    def test_fields_stand_in_tables(self):
        self.assertIn("| `fx` | `float` | ", self.made)

    def test_the_pictures_are_there(self):
        self.assertIn("### microslip.plot.figures\n\n```python\nfigures(path, style='page', **chosen)\n```\n\nThe figures", self.made)

    def test_texts_are_without_signatures(self):
        text = text_of(microslip.hertz_from_load)
        self.assertNotIn("->", text)
        self.assertGreater(len(text), 20)
        self.assertEqual(first_sentence("One: two.\nThree"), "One")


if __name__ == "__main__":
    unittest.main()
