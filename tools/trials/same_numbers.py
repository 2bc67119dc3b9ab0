"""Compares all numbers of two JSON documents, or tables of CSV, but for what tells where they come from, and residuals: same_numbers.py FIRST SECOND"""

import csv
import json
import sys

# Solvers that iterate stop at 1e-6 and less of what they look for: rounding becomes that much larger.
TOLERANCE = 1e-7
# Numbers in SI that are not larger are what rounding leaves of zero.
ROUNDING = 1e-10
ORIGIN = {"compiler", "command_line", "files", "commit", "created", "seconds", "input", "residual"}


def numbers(value, place=""):
    """All numbers and words with their paths."""
    if isinstance(value, dict):
        for name, part in value.items():
            if name not in ORIGIN:
                yield from numbers(part, f"{place}/{name}")
    elif isinstance(value, list):
        for index, part in enumerate(value):
            yield from numbers(part, f"{place}/{index}")
    else:
        yield place, value


def document(name):
    """Contents of a file; fields of a table that are numbers are numbers."""
    with open(name, encoding="utf-8", newline="") as file:
        if not name.endswith(".csv"):
            return json.load(file)
        return [[number(field) for field in row] for row in csv.reader(file)]


def number(field):
    """A field as a number, if it is one."""
    try:
        return float(field)
    except ValueError:
        return field


def differ(one, other):
    """Returns whether two values are not the same but for rounding."""
    if isinstance(one, float) and isinstance(other, float):
        largest = max(abs(one), abs(other))
        return largest > ROUNDING and abs(one - other) > TOLERANCE * largest
    return one != other


def main():
    """The exit code: 0 if all are the same."""
    first, second = (dict(numbers(document(name))) for name in sys.argv[1:3])
    wrong = [f"{place}: {first.get(place)} {second.get(place)}" for place in sorted(first.keys() | second.keys())
             if place not in first or place not in second or differ(first[place], second[place])]
    print(f"{len(first)} values" if not wrong else "\n".join(wrong))
    return 1 if wrong or not first else 0


if __name__ == "__main__":
    sys.exit(main())
