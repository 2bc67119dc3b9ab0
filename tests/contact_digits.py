#!/usr/bin/env python3
"""Checks docs/contact-digits.md against the code: every digit that a control integer has stands there with its
enumeration and all values, and the functions that it names are where it says."""
import pathlib
import re
import sys

HEADERS = ("digits.hpp", "wheel_rail/digits.hpp")
VALUES = re.compile(r'values_of<(\w+)> = \{"(\w+)", \{([^}]*)\}\}')
DIGIT = re.compile(r"[A-Z]2?")


def values_in(text):
    """The values that a cell names: `0 to 4, 9`."""
    found = []
    for part in text.split(","):
        low, _, high = part.strip().partition(" to ")
        found += range(int(low), int(high or low) + 1)
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    code = root / "compat" / "contact"
    choices = {name: (digit, [int(value) for value in values.split(",")])
               for header in HEADERS for name, digit, values in VALUES.findall((code / header).read_text())}
    missing = {name for name, (digit, _) in choices.items() if DIGIT.fullmatch(digit)}
    wrong = []
    for line in (root / "docs" / "contact-digits.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) != 6 or not DIGIT.fullmatch(cells[0]):
            continue
        name = cells[3].strip("`")
        missing.discard(name)
        if choices.get(name) != (cells[0], values_in(cells[4])):
            wrong.append(f"{cells[0]}, {name}: the code has {choices.get(name)}")
        file = None
        for text in re.findall(r"`([^`]+)`", cells[5]):
            if "." in text:
                file = code / text
            elif not file.exists() or not re.search(rf"\b{text}\(", file.read_text()):
                wrong.append(f"{cells[0]}: there is no {text} in {file}")
    wrong += [f"{name} has no row" for name in sorted(missing)]
    print("\n".join(wrong) or f"{len(choices)} enumerations")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
