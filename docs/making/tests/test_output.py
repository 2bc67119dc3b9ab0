"""What is printed beside what a page says."""

import unittest

from output import difference, last_digit


class OutputTest(unittest.TestCase):
    def test_a_unit_of_the_last_digit(self):
        for text, unit in (("-1.50", 0.01), (".5", 0.1), ("2.5e-3", 1e-4), ("1e6", 1e6)):
            self.assertAlmostEqual(last_digit(text) / unit, 1)

    def test_figures_may_differ_a_little(self):
        self.assertEqual(difference("Fx = -13306.6 N", "Fx = -13306.7 N"), "")
        self.assertEqual(difference("Fx = -13306.612 N", "Fx = -13306.7 N"), "")
        self.assertIn("-14062.2", difference("Fx = -14058.3 N", "Fx = -14062.2 N"))
        self.assertEqual(difference("a 0.0013", "a 0.0014"), "")
        self.assertNotEqual(difference("8 Newton steps", "9 Newton steps"), "")
        self.assertNotEqual(difference("a 0.0013", "a 0.0015"), "")

    def test_words_may_not(self):
        self.assertNotEqual(difference("Fx = 1 N", "Fy = 1 N"), "")
        self.assertNotEqual(difference("Fx = 1 N", "Fx = 1"), "")
        self.assertNotEqual(difference("1 2", "1"), "")

    def test_dots_stand_for_any_lines(self):
        printed = "a\nb\nc\nd\n"
        for said in ("a\n...\nd\n", "...\nc\nd\n", "a\nb\n...\n", "...\n", "a\n...\nb\n...\n"):
            self.assertEqual(difference(said, printed), "", said)
        for said in ("a\n...\nc\n", "...\nb\n", "a\n...\ne\n", "...\na\nb\n"):
            self.assertNotEqual(difference(said, printed), "", said)

    def test_all_lines_count(self):
        self.assertIn("ended", difference("a\nb\n", "a\n"))
        self.assertIn("also", difference("a\n", "a\nb\n"))


if __name__ == "__main__":
    unittest.main()
