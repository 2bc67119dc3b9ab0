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

    def test_a_block_without_end_is_an_error(self):
        with self.assertRaisesRegex(ValueError, "page.md:1: the block does not end"):
            blocks(self.page("```sh\nls\n"))


if __name__ == "__main__":
    unittest.main()
