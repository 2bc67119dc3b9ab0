"""Compares what a program prints with what a page says that it prints."""

import re

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
RELATIVE = 1e-5  # other processors round otherwise, and iterations end elsewhere


def words_and_numbers(line):
    """The words between the numbers of a line, with single spaces, and its numbers as they are printed."""
    return [" ".join(word.split()) for word in NUMBER.split(line)], NUMBER.findall(line)


def last_digit(text):
    """The value of one unit of the last digit of a number as it is printed."""
    mantissa, _, exponent = text.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def same_number(said, printed):
    """Whole numbers are the same; others within RELATIVE, or one unit of the last digit that the page has."""
    a, b = float(said), float(printed)
    if said.lstrip("+-").isdigit():
        return a == b
    return abs(a - b) <= max(1.001 * last_digit(said), RELATIVE * abs(a))


def same_line(said, printed):
    """Returns whether two lines have the same words and the same numbers."""
    words, numbers = words_and_numbers(said)
    printed_words, printed_numbers = words_and_numbers(printed)
    return words == printed_words and all(map(same_number, numbers, printed_numbers))


def difference(said, printed):
    """The first line of `said` that was not printed, in words; "" if there is none. A line "..." stands for any lines."""
    rest = [line.rstrip() for line in printed.rstrip().splitlines()]
    skipping = False
    for line in said.rstrip().splitlines():
        if line.strip() == "...":
            skipping = True
            continue
        while skipping and rest and not same_line(line, rest[0]):
            rest.pop(0)
        if not rest:
            return f"says\n  {line}\nbut the output has ended"
        if not same_line(line, rest[0]):
            return f"says\n  {line}\nbut printed is\n  {rest[0]}"
        rest.pop(0)
        skipping = False
    return "" if skipping or not rest else f"ends, but printed is also\n  {rest[0]}"
