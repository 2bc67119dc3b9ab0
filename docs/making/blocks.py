"""Fenced blocks and marked tables of a Markdown page, each with the marks that stand before it.

A mark is a comment, `<!-- ... -->`, on a line before a fence:

    not run: WHY               the block is not run, for the reason given
    output                     what the block before prints; whole numbers are equal, others may
                               differ by 1e-5 of themselves or a unit of their last digit
    output of: COMMAND         the same, of a command
    printed by: COMMAND        an excerpt of what a command prints in some seconds: a test compares
                               it likewise, tools/figures renews it
    printed slowly by: COMMAND the same of a longer one, which only tools/figures runs

The last two may stand before a table as well, and have a second mark behind them that says which
figures other machines or moments may print:

    compared: RULE; RULE...    within X     by how much of themselves figures may differ, whole ones too
                               noise X      what is smaller is as good as zero
                               not A, B     no figures in lines that have A or B in them or below
                                            such heads of columns: times, numbers of steps
                               words only   no figures
"""

import re
from dataclasses import dataclass
from pathlib import Path

FENCE = re.compile(r"^```(\S*)\s*$")
MARK = re.compile(r"^<!-- (.*) -->$")
COMPARED = "compared:"


@dataclass(frozen=True)
class Block:
    """A fenced block, or a table; `line` is that before its text, counted from 1."""

    page: Path
    line: int
    language: str
    mark: str
    text: str
    compared: str = ""  # the rules of its second mark

    @property
    def place(self):
        """For messages."""
        return f"{self.page}:{self.line}"

    def marked(self, word):
        """Returns what follows `word` in the mark, or None."""
        return self.mark[len(word):].strip() if self.mark.startswith(word) else None


def marks_before(lines, number):
    """The mark before a line and the rules of a second one, "" where there are none."""
    mark, compared = "", ""
    while number > 0 and not mark and (found := MARK.match(lines[number - 1])):
        number -= 1
        if found[1].startswith(COMPARED) and not compared:
            compared = found[1][len(COMPARED):].strip()
        else:
            mark = found[1]
    return mark, compared


def blocks(page):
    """All fenced blocks and marked tables of a page, in order."""
    lines = Path(page).read_text().splitlines()
    found, start = [], None

    def add(first, end, line, language, marks):
        text = "".join(f"{one}\n" for one in lines[first:end])
        found.append(Block(Path(page), line, language, marks[0], text, marks[1]))

    for number, line in enumerate(lines):
        fence = FENCE.match(line)
        if start is None and line.startswith("|") and number > 0 and MARK.match(lines[number - 1]):
            end = next((k for k in range(number, len(lines)) if not lines[k].startswith("|")), len(lines))
            add(number, end, number, "table", marks_before(lines, number))
        if not fence:
            continue
        if start is None:
            start, language = number, fence[1]
        else:
            add(start + 1, number, start + 1, language, marks_before(lines, start))
            start = None
    if start is not None:
        raise ValueError(f"{page}:{start + 1}: the block does not end")
    return found
