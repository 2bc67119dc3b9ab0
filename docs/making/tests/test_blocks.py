"""Blocks of a page, and their comparison with what is printed."""

import os
import tempfile
import unittest
from pathlib import Path

from blocks import blocks
from output import difference, last_digit
from run_blocks import check, compiled_blocks, extract

PAGE = """A page.

```python
print(1 + 1)
```

<!-- output -->
```text
2
```

<!-- not run: a drawing -->
```text
o--o
```
"""


class PageTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def page(self, text):
        path = self.folder / "page.md"
        path.write_text(text)
        return path


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


class RunTest(PageTest):
    """Pages that are wrong fail, and print where."""

    def outcome(self, text):
        kept = os.dup(2)
        with open(self.folder / "errors", "w+") as errors:
            os.dup2(errors.fileno(), 2)
            try:
                code = check(self.page(text), self.folder)
            finally:
                os.dup2(kept, 2)
                os.close(kept)
            errors.seek(0)
            return code, errors.read()

    def test_a_page_that_is_right(self):
        self.assertEqual(self.outcome(PAGE), (0, ""))

    def test_other_output_is_named_by_line(self):
        code, errors = self.outcome(PAGE.replace("\n2\n", "\n3\n"))
        self.assertEqual(code, 1)
        self.assertRegex(errors, r"page\.md:8: RuntimeError: says\n  3\nbut printed is\n  2")

    def test_code_that_fails(self):
        for block in ("```python\n1/0\n```\n", "```sh\nfalse\n```\n", "```sh\nfalse | true\n```\n", "```pycon\n>>> 1 + 1\n3\n```\n",
                      "```pycon\nnothing\n```\n"):
            self.assertEqual(self.outcome(block)[0], 1, block)

    def test_sessions_keep_their_names(self):
        self.assertEqual(self.outcome("```pycon\n>>> a = 2\n```\n```pycon\n>>> a\n2\n```\n```python\nassert a == 2\n```\n"), (0, ""))

    def test_every_block_is_run_or_marked(self):
        for block in ("```\nls\n```\n", "```text\nls\n```\n", "```ruby\nls\n```\n"):
            code, errors = self.outcome(block)
            self.assertEqual(code, 1)
            self.assertIn("needs a mark", errors)

    def test_output_needs_a_block_that_was_run(self):
        self.assertIn("no block before it was run", self.outcome("<!-- output -->\n```text\n1\n```\n")[1])
        marked = PAGE.replace("```python", "<!-- not run: so -->\n```python")
        self.assertIn("no block before it was run", self.outcome(marked)[1])

    def test_output_of_a_command(self):
        self.assertEqual(self.outcome("<!-- output of: echo 1 -->\n```text\n1\n```\n"), (0, ""))
        self.assertEqual(self.outcome("<!-- output of: echo 2 -->\n```text\n1\n```\n")[0], 1)

    def test_compiled_blocks_become_files(self):
        page = self.page("```cpp\nint main() {}\n```\n```c\nint main(void) { return 0; }\n```\n<!-- not run: so -->\n```c\nint\n```\n")
        self.assertEqual(list(compiled_blocks(page)), ["page_1", "page_2"])
        code = self.folder / "code"
        extract(code, [page])
        (code / "old_1.cpp").write_text("")
        extract(code, [page])
        self.assertEqual(sorted(path.name for path in code.iterdir()), ["page_1.cpp", "page_2.c"])
        self.assertEqual((code / "page_1.cpp").read_text(), "int main() {}\n")


class OutputTest(unittest.TestCase):
    def test_a_unit_of_the_last_digit(self):
        for text, unit in (("-1.50", 0.01), (".5", 0.1), ("2.5e-3", 1e-4), ("1e6", 1e6)):
            self.assertAlmostEqual(last_digit(text) / unit, 1)

    def test_figures_may_differ_a_little(self):
        self.assertEqual(difference("Fx = -13306.6 N", "Fx = -13306.7 N"), "")
        self.assertEqual(difference("Fx = -13306.6 N", "Fx =  -13310 N"), "")
        self.assertIn("-13406.6", difference("Fx = -13306.6 N", "Fx = -13406.6 N"))
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
