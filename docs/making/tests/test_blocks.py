"""Blocks of a page."""

import unittest

from blocks import blocks
from tests.page_in_folder import PAGE, PageTest


class BlocksTest(PageTest):
    def test_blocks_have_language_mark_and_line(self):
        code, output, drawing = blocks(self.page(PAGE))
        self.assertEqual((code.line, code.language, code.mark, code.text), (3, "python", "", "print(1 + 1)\n"))
        self.assertEqual((output.line, output.language, output.mark), (8, "text", "output"))
        self.assertEqual(drawing.marked("not run:"), "a drawing")
        self.assertIsNone(drawing.marked("output"))

    def test_a_second_mark_has_the_rules(self):
        one, other = blocks(self.page("<!-- printed by: x -->\n<!-- compared: noise 1 -->\n```\n1\n```\n<!-- a -->\n<!-- output -->\n```\n2\n```\n"))
        self.assertEqual((one.mark, one.compared, one.text), ("printed by: x", "noise 1", "1\n"))
        self.assertEqual((other.mark, other.compared), ("output", ""))

    def test_marked_tables_are_blocks(self):
        page = self.page("| a |\n|---|\n| 1 |\n\n<!-- printed by: x -->\n| b |\n|---|\n| 2 |\n\ntext\n")
        (table,) = blocks(page)
        self.assertEqual((table.language, table.mark, table.text), ("table", "printed by: x", "| b |\n|---|\n| 2 |\n"))
        self.assertEqual(page.read_text().splitlines()[table.line], "| b |")

    def test_a_block_without_end_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "page.md:1: the block does not end"):
            blocks(self.page("```sh\nls\n"))


if __name__ == "__main__":
    unittest.main()
