#!/usr/bin/env python3
"""Checks that folders include one another only as the table says, and that the table has no cycles."""
import pathlib
import re
import sys

EVERYWHERE = "microslip"  # decimal, error, progress, status, vec2, version: every folder may include them
EXACT = "microslip/exact/"
RAILWAY = "microslip/railway/"

# A folder and what it may include, besides itself.
ALLOWED = {
    "microslip": [],
    "microslip/numerics": [],
    "microslip/elasticity": ["microslip/numerics"],
    "microslip/friction": ["microslip/numerics"],
    "microslip/contact": ["microslip/friction"],
    "microslip/simplified": ["microslip/contact", "microslip/friction", "microslip/numerics"],
    "microslip/thermal": ["microslip/contact"],
    EXACT + "halfspace": ["microslip/contact", "microslip/elasticity", "microslip/numerics"],
    EXACT + "normal": ["microslip/contact", "microslip/elasticity", "microslip/numerics", EXACT + "halfspace"],
    EXACT + "newton": ["microslip/contact", "microslip/numerics", EXACT + "halfspace"],
    EXACT + "fitted": ["microslip/contact", "microslip/elasticity", "microslip/numerics", "microslip/simplified",
                       EXACT + "halfspace", EXACT + "normal", EXACT + "newton"],
    EXACT + "classical": ["microslip/contact", "microslip/elasticity", "microslip/friction", "microslip/numerics",
                          "microslip/simplified", "microslip/thermal", EXACT + "halfspace", EXACT + "normal",
                          EXACT + "newton"],
    "microslip/interior": ["microslip/contact", "microslip/elasticity", "microslip/numerics", EXACT + "halfspace"],
    "microslip/rolling": ["microslip/contact", "microslip/elasticity", "microslip/friction", "microslip/simplified",
                          "microslip/thermal", EXACT + "classical", EXACT + "fitted", EXACT + "halfspace",
                          EXACT + "normal", "microslip/table"],
    "microslip/damage": ["microslip/contact"],
    "microslip/response": ["microslip/contact", "microslip/numerics"],
    "microslip/batch": ["microslip/contact", "microslip/simplified"],
    "microslip/table": ["microslip/contact", "microslip/numerics", "microslip/simplified"],
    "microslip/table/making": ["microslip/batch", "microslip/contact", "microslip/rolling", "microslip/simplified",
                               "microslip/table"],
    RAILWAY + "profile": ["microslip/numerics"],
    RAILWAY + "geometry": ["microslip/contact", "microslip/numerics", RAILWAY + "profile"],
    RAILWAY + "problem": ["microslip/contact", "microslip/damage", "microslip/elasticity", RAILWAY + "geometry",
                          RAILWAY + "profile"],
    RAILWAY + "rows": ["microslip/elasticity", "microslip/numerics", "microslip/simplified", "microslip/table",
                       RAILWAY + "geometry", RAILWAY + "problem", RAILWAY + "profile"],
    RAILWAY + "exact": ["microslip/contact", "microslip/elasticity", "microslip/numerics", EXACT + "classical",
                        EXACT + "fitted", EXACT + "halfspace", RAILWAY + "geometry", RAILWAY + "problem", RAILWAY + "rows"],
    "microslip/railway": ["microslip/contact", "microslip/damage", "microslip/friction", "microslip/numerics",
                          "microslip/table", RAILWAY + "exact", RAILWAY + "geometry", RAILWAY + "problem",
                          RAILWAY + "profile", RAILWAY + "rows"],
    RAILWAY + "vehicle": ["microslip/numerics", "microslip/railway", RAILWAY + "geometry", RAILWAY + "problem"],
    "microslip/description": ["microslip/contact", "microslip/elasticity", "microslip/friction", "microslip/railway",
                              RAILWAY + "geometry", RAILWAY + "problem", RAILWAY + "profile", RAILWAY + "vehicle"],
}


def layer(path):
    """The table's folder of a file."""
    return path.parent.as_posix().removesuffix("/kernel")  # the part that is compiled for several instruction sets


def dependencies(source):
    """(folder, included folder) -> the includes, as text."""
    found = {}
    for file in sorted((source / "microslip").rglob("*.[hc]pp")):
        here = file.relative_to(source)
        for line, text in enumerate(file.read_text().splitlines(), 1):
            include = re.match(r'\s*#include "(.*)"', text)
            if include and "/" in include[1] and layer(here) != layer(pathlib.PurePosixPath(include[1])):
                pair = layer(here), layer(pathlib.PurePosixPath(include[1]))
                found.setdefault(pair, []).append(f"{here}:{line}: includes {include[1]}")
    return found


def cycle(allowed):
    """Folders that the table lets include one another in a cycle, or nothing."""
    left = {folder: set(lower) for folder, lower in allowed.items()}
    while left:
        lowest = [folder for folder, lower in left.items() if not lower & left.keys()]
        if not lowest:
            return sorted(left)
        for folder in lowest:
            del left[folder]
    return []


def complaints(found, allowed):
    """What is wrong, one line each."""
    lines = [f"the table has a cycle among {', '.join(cycle(allowed))}"] if cycle(allowed) else []
    for (folder, other), includes in sorted(found.items()):
        if folder not in allowed:
            lines.append(f"{folder}: not in the table")
        elif other != EVERYWHERE and other not in allowed[folder]:
            lines += [f"{include}; {folder} may not include {other}" for include in includes]
    return lines


def main():
    found = dependencies(pathlib.Path(sys.argv[1]))
    between_layers = sum(other != EVERYWHERE for _, other in found)
    wrong = complaints(found, ALLOWED)
    print("\n".join(wrong) or f"{between_layers} dependencies between folders, no cycles")
    # The check itself: an upward include, an unknown folder and a cycle are found.
    assert complaints({("microslip/numerics", "microslip/rolling"): ["x"]}, ALLOWED)
    assert complaints({("microslip/unknown", "microslip/numerics"): ["x"]}, ALLOWED)
    assert cycle({"a": ["b"], "b": ["a"]}) and not cycle({"a": ["b"], "b": []})
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
