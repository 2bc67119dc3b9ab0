"""Runs the studies in full and names the figures that are not met, except those that the pages show as not met.

    studies.py PROGRAM [STUDY...]     exit code 1 if there are any
"""

import subprocess
import sys

from blocks import blocks
from printed import ROOT, words

NOT_MET = "NOT MET"


def known(pages):
    """The figures that pages show as not met, as words."""
    return {words(line) for page in pages for block in blocks(page) for line in block.text.splitlines() if NOT_MET in line}


def unexpected(output, expected):
    """Lines of an output with a figure that is not met and not expected to be."""
    return [line.strip() for line in output.splitlines() if NOT_MET in line and words(line) not in expected]


def main(program, studies):
    """Runs the studies, all of them if none is named; the exit code."""
    done = subprocess.run([program, "validate", "--thorough", "--no-pictures", *studies], text=True, stdout=subprocess.PIPE)
    print(done.stdout, flush=True)
    if done.returncode not in (0, 1):
        return done.returncode
    found = unexpected(done.stdout, known(sorted((ROOT / "docs").glob("*.md"))))
    print("\n".join(["figures that the pages do not show as not met:", *found] if found else ["all figures are as the pages say"]))
    return int(bool(found))


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:]))
