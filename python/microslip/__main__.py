"""`python -m microslip`, and the command `microslip` where pip has installed it: runs the program."""

import os
import sys
from pathlib import Path

PACKAGE = Path(__file__).absolute().parent


def main():
    """Becomes the program: in the package, as in a wheel, or in the prefix in which both are installed."""
    for program in (PACKAGE / "bin/microslip", PACKAGE.parents[3] / "bin/microslip"):
        if program.is_file():
            os.environ.setdefault("MICROSLIP_PYTHON", sys.executable)  # draws the pictures
            os.execv(program, ["microslip", *sys.argv[1:]])
    sys.exit(f"microslip: there is no program in {PACKAGE}/bin; was the package built without it?")


if __name__ == "__main__":
    main()
