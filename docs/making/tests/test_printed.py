"""Blocks take over the figures that are printed now, and say so where the words have changed."""

import tempfile
import unittest
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

from printed import commands, renew, renewed, run

OUTPUT = """study: of something

First table
  Fx 10  rms   0.0012  0.0011  ok
  Fx 10  95 %  0.0031
  Fx 20  rms   0.0005  0.0004  NOT MET

Second table
  Fx 10  rms   0.0112  0.0111  ok
  cases that fail   1  0  NOT MET
"""


class RenewedTest(unittest.TestCase):
    def test_figures_and_verdicts_are_taken_over(self):
        self.assertEqual(renewed("Second table\n  Fx 10  rms   0.0199  0.0111  NOT MET\n  cases that fail   0  0   ok\n", OUTPUT),
                         "Second table\n  Fx 10  rms   0.0112  0.0111  ok\n  cases that fail   1  0  NOT MET\n")

    def test_a_known_limit_belongs_to_the_verdict(self):
        limit = "NOT MET, known limit: <= 2, limits.md"
        self.assertEqual(renewed("  cases that fail   0  0   ok\n", f"  cases that fail   1  0  {limit}\n"), f"  cases that fail   1  0  {limit}\n")
        self.assertEqual(renewed(f"  cases that fail   1  0  {limit}\n", OUTPUT), "  cases that fail   1  0  NOT MET\n")

    def test_what_is_right_stays(self):
        whole = OUTPUT.partition("\n\n")[2]
        self.assertEqual(renewed(whole, OUTPUT), whole)

    def test_the_page_may_leave_out_lines_of_a_paragraph(self):
        self.assertEqual(renewed("First table\n  Fx 20  rms   0.0007  0.0004  ok\n", OUTPUT),
                         "First table\n  Fx 20  rms   0.0005  0.0004  NOT MET\n")

    def test_paragraphs_only_where_it_has_dots(self):
        with self.assertRaisesRegex(ValueError, "cases that fail"):
            renewed("First table\n  cases that fail  1  0  ok\n", OUTPUT)
        self.assertEqual(renewed("First table\n...\n  cases that fail  0  0  ok\n...\n", OUTPUT),
                         "First table\n...\n  cases that fail   1  0  NOT MET\n...\n")

    def test_lines_alike_are_told_apart_by_their_figures(self):
        self.assertEqual(renewed("  Fx 10  rms   0.0199  0.0111  ok\n", OUTPUT), "  Fx 10  rms   0.0112  0.0111  ok\n")

    def test_other_words_are_an_error(self):
        with self.assertRaisesRegex(ValueError, "not printed so any more: 'Fy 10  rms'"):
            renewed("First table\n  Fx 10  rms   0.0012  0.0011  ok\n  Fy 10  rms\n", OUTPUT)


class PageTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page = Path(folder.name) / "page.md"

    def renew(self, text, write=True):
        self.page.write_text(text)
        (found,) = commands([self.page]).values()
        with redirect_stdout(StringIO()) as out:
            right = [renew(block, OUTPUT, write) for block in found.blocks]
        return right, out.getvalue(), self.page.read_text()

    def block(self, text):
        return f"Before.\n\n<!-- printed by: study -->\n```text\n{text}```\n\nAfter.\n"

    def test_blocks_of_a_page_are_rewritten(self):
        wrong = self.block("Second table\n  Fx 10  rms   0.1  0.1  ok\n")
        right, out, text = self.renew(wrong + wrong)
        self.assertEqual(right, [True, True])
        self.assertEqual(text, 2 * self.block("Second table\n  Fx 10  rms   0.0112  0.0111  ok\n"))
        self.assertIn("page.md:4: renewed", out)

    def test_checking_changes_nothing(self):
        wrong = self.block("Second table\n  Fx 10  rms   0.1999  0.0111  ok\n")
        self.assertEqual(self.renew(wrong, write=False)[::2], ([False], wrong))

    def test_checking_obeys_the_second_mark(self):
        wrong = self.block("Second table\n  Fx 10  rms   0.0113  0.0109  ok\n")
        near = wrong.replace("study -->", "study -->\n<!-- compared: within .03 -->")
        self.assertEqual(self.renew(near, write=False)[0], [True])
        self.assertEqual(self.renew(near.replace(".03", ".01"), write=False)[0], [False])
        self.assertEqual(self.renew(near)[2], near.replace("0.0113", "0.0112").replace("0.0109", "0.0111"))

    def test_tables_are_renewed(self):
        page = "<!-- printed by: study -->\n| a | 1 |\n\nAfter.\n"
        self.page.write_text(page)
        (found,) = commands([self.page]).values()
        with redirect_stdout(StringIO()):
            self.assertTrue(renew(found.blocks[0], "| a | 2 |\n", True))
        self.assertEqual(self.page.read_text(), page.replace("1", "2"))

    def test_slow_commands_are_known(self):
        self.page.write_text(self.block("x\n") + self.block("x\n").replace("printed by", "printed slowly by").replace("study", "long"))
        found = commands([self.page])
        self.assertEqual({name: one.is_slow for name, one in found.items()}, {"study": False, "long": True})
        self.assertTrue(found["long"].has("lon") and found["long"].has("page.md") and not found["long"].has("study"))

    def test_what_cannot_be_renewed_is_named_and_left(self):
        wrong = self.block("Third table\n")
        right, out, text = self.renew(wrong)
        self.assertEqual((right, text), ([False], wrong))
        self.assertIn("page.md:4: not printed so any more: 'Third table'", out)

    def test_a_command_that_fails_is_named_and_prints_nothing(self):
        out = StringIO()
        with redirect_stdout(out):
            self.assertEqual(run("echo 2; exit 1", self.page.parent), "2\n")
            self.assertIsNone(run("echo 2; no_such_program", self.page.parent))
        self.assertEqual(out.getvalue(), "echo 2; no_such_program: exit code 127\n")

    def test_the_documentation_names_its_commands(self):
        found = commands(sorted(Path(__file__).resolve().parents[2].glob("*.md")))
        self.assertIn("microslip validate carter", found)
        self.assertGreater(len(found), 15)


if __name__ == "__main__":
    unittest.main()
