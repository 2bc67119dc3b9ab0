"""Figures of a page beside those that are printed, by rules."""

import unittest

from figures import other_line, parse

TABLE = """heads      steps   time [s]   Fx
  steel       12       0.50   1.25
  rubber      17       0.75   2.50

  rms      0.50
"""


class RulesTest(unittest.TestCase):
    def test_figures_are_compared_without_rules(self):
        self.assertIsNone(other_line(TABLE, TABLE, parse("")))
        for figure, new in (("12", "13"), ("2.50", "2.52"), ("rms      0.50", "rms      0.52")):
            changed = other_line(TABLE, TABLE.replace(figure, new), parse(""))
            self.assertIn(figure, changed[0])
            self.assertIn(new, changed[1])

    def test_a_unit_of_the_last_digit_is_nothing(self):
        self.assertIsNone(other_line("x 0.123", "x 0.124", parse("")))
        self.assertIsNotNone(other_line("x 0.123", "x 0.126", parse("")))

    def test_within(self):
        self.assertIsNone(other_line("400 of 1.00", "401 of 1.01", parse("within .02")))
        self.assertIsNotNone(other_line("400 of 1.00", "409 of 1.01", parse("within .02")))

    def test_noise(self):
        rules = parse("noise 1e-9")
        self.assertIsNone(other_line("x 1.7e-11", "x -3.4e-10", rules))
        self.assertIsNotNone(other_line("x 1.7e-11", "x 3.4e-9", rules))
        self.assertIsNotNone(other_line("x 1.7e-8", "x 1.9e-8", rules))

    def test_columns_below_a_head_up_to_the_blank_line(self):
        other = TABLE.replace("12", "99").replace("0.75", "9.75")
        self.assertIsNone(other_line(TABLE, other, parse("not steps, time [s]")))
        self.assertEqual(other_line(TABLE, other, parse("not steps"))[0].split()[0], "rubber")
        self.assertIsNotNone(other_line(TABLE, TABLE.replace("2.50", "2.75"), parse("not steps, time [s]")))
        self.assertIsNotNone(other_line(TABLE, TABLE.replace("rms      0.50", "rms      0.60"), parse("not steps, time [s]")))

    def test_cells_of_a_table_of_markdown(self):
        said, printed = "| a | time [s] | b |\n|---|---|---|\n| x | 1.5 | 7 |\n", "| a | time [s] | b |\n|---|---|---|\n| x | 2.5 | 7 |\n"
        self.assertIsNone(other_line(said, printed, parse("not time [s]")))
        self.assertIsNotNone(other_line(said, printed, parse("not b")))

    def test_lines(self):
        self.assertIsNone(other_line("  time: 1.5 s, 3 steps", "  time: 9.5 s, 4 steps", parse("not time:")))
        self.assertIsNotNone(other_line("  case: 1.5 s", "  case: 9.5 s", parse("not time:")))

    def test_verdicts_count(self):
        self.assertIsNotNone(other_line("x 1  ok", "x 1  NOT MET", parse("within 1")))

    def test_words_only(self):
        self.assertIsNone(other_line("x 1", "x 2", parse("words only")))

    def test_other_words_are_no_rules(self):
        for text in ("without 1", "noise x", "not", "words"):
            with self.assertRaises(ValueError):
                parse(text)


if __name__ == "__main__":
    unittest.main()
