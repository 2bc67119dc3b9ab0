"""Compares the figures of a page with those that are printed, by the rules of the mark `compared:`, see blocks.py."""

import re
from dataclasses import dataclass

from output import NUMBER, same_number

VERDICT = re.compile(r"\b(?:ok|NOT MET(?:, known limit: .*)?)\b")


@dataclass(frozen=True)
class Rules:
    """Rules for figures that may differ."""

    within: float = 0.0
    noise: float = 0.0
    left_out: tuple = ()
    words_only: bool = False

    def same(self, said, printed):
        """Returns whether two figures count as equal."""
        a, b = float(said), float(printed)
        return same_number(said, printed) or abs(a - b) <= self.within * abs(a) or max(abs(a), abs(b)) < self.noise


def parse(text):
    """The rules of a mark."""
    given = {}
    for rule in filter(None, map(str.strip, text.split(";"))):
        word, _, rest = rule.partition(" ")
        if rule == "words only":
            given["words_only"] = True
        elif word in ("within", "noise"):
            given[word] = float(rest)
        elif word == "not" and rest:
            given["left_out"] = tuple(part.strip() for part in rest.split(","))
        else:
            raise ValueError(f"compared: '{rule}' is no rule, see docs/making/blocks.py")
    return Rules(**given)


def column(line, begin, end):
    """Position of a part of a line: in a table of Markdown the number of its cell, else its first and last column."""
    return (line.count("|", 0, begin),) * 2 if line.startswith("|") else (begin, end - 1)


def columns_of(texts, line):
    """Positions of the texts in a line."""
    return [column(line, *match.span()) for text in texts for match in re.finditer(re.escape(text), line)]


def other_line(said, printed, rules):
    """The first two lines of two texts with the same words in which a figure or a verdict is another one, None if there are
    none. A head counts up to the next blank line."""
    heads = []
    for one, other in zip(said.splitlines(), printed.splitlines()):
        heads = heads + columns_of(rules.left_out, one) if one.strip() else []
        if rules.words_only or any(text in one for text in rules.left_out):
            continue
        if VERDICT.findall(one) != VERDICT.findall(other):
            return one, other
        for figure, new in zip(NUMBER.finditer(one), NUMBER.findall(other)):
            first, last = column(one, *figure.span())
            if not any(first <= end and begin <= last for begin, end in heads) and not rules.same(figure[0], new):
                return one, other
    return None
