"""Pages that are right pass, pages that are wrong fail and say where."""

import os
import unittest

from run_blocks import check, compiled_blocks, extract
from tests.page_in_folder import PAGE, PageTest


class RunTest(PageTest):
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


if __name__ == "__main__":
    unittest.main()
