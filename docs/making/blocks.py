"""Fenced blocks of a Markdown page, each with the mark that stands before it.

A mark is a comment, `<!-- ... -->`, on the line before a fence:

    not run: WHY          the block is not run, for the reason given
    output                what the block before prints; whole numbers are equal, others may
                          differ by 1e-5 of themselves or a unit of their last digit
    output of: COMMAND    the same, of a command
    printed by: COMMAND   an excerpt of what a longer command prints; tools/figures renews it
"""

import re
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^```(\S*)\s*$")
MARK = re.compile(r"^<!-- (.*) -->$")


@dataclass(frozen=True)
class Block:
    """A fenced block; `line` is that of its opening fence, counted from 1."""

    page: Path
    line: int
    language: str
    mark: str
    text: str

    @property
    def place(self):
        """For messages."""
        return f"{self.page}:{self.line}"

    def marked(self, word):
        """What follows `word` in the mark, or None."""
        return self.mark[len(word):].strip() if self.mark.startswith(word) else None


def blocks(page):
    """All fenced blocks of a page, in order."""
    lines = Path(page).read_text().splitlines()
    found, start = [], None
    for number, line in enumerate(lines):
        fence = FENCE.match(line)
        if not fence:
            continue
        if start is None:
            start, language = number, fence[1]
        else:
            mark = MARK.match(lines[start - 1]) if start > 0 else None
            text = "".join(f"{one}\n" for one in lines[start + 1:number])
            found.append(Block(Path(page), start + 1, language, mark[1] if mark else "", text))
            start = None
    if start is not None:
        raise ValueError(f"{page}:{start + 1}: the block does not end")
    return found
