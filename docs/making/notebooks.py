"""Makes notebooks of the tutorials and runs each in a kernel of Jupyter, as a reader does, from its first cell to its last.

    notebooks.py FOLDER [WORD...]     writes FOLDER/NAME.ipynb, with output, of the tutorials with one of the words in their name (none: all)

A cell that fails is named with its line in the tutorial; the notebook has its error, and the exit code is 1. FOLDER gets a link to
examples/, which tutorials read.
"""

import os
import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellControlSignal, CellExecutionError, DeadKernelError

from tutorial import ROOT, Cell, cells, notebook, prose

TUTORIALS = ROOT / "docs" / "tutorials"
LIMIT = 600  # s, for one cell
os.environ["PYDEVD_DISABLE_FILE_VALIDATION"] = "1"  # else the debugger of each kernel warns that it misses breakpoints


def run(script, folder):
    """Writes the notebook of a tutorial with its output; what is wrong with it, or nothing."""
    found = cells(script.read_text())
    book = notebook([prose(lines) if is_text else Cell(lines) for is_text, _, lines in found])
    begun = []
    client = NotebookClient(book, timeout=LIMIT, kernel_name="python3", resources={"metadata": {"path": str(folder)}},
                            on_cell_start=lambda cell, cell_index: begun.append(cell_index))
    wrong = ""
    try:
        client.execute()
    except (CellControlSignal, DeadKernelError) as error:
        words = f"{error.ename}: {error.evalue}" if isinstance(error, CellExecutionError) else str(error).strip()
        wrong = f"{script}:{found[begun[-1]][1]}: cell {begun[-1] + 1} of {len(found)} fails: {words}"
    nbformat.write(book, folder / f"{script.stem}.ipynb")
    return wrong


def main(folder, words, tutorials=TUTORIALS):
    """Runs the tutorials with one of the words in their name; the exit code."""
    chosen = [script for script in sorted(tutorials.glob("*.py")) if not words or any(word in script.stem for word in words)]
    if not chosen:
        raise SystemExit(f"no tutorial has {' or '.join(words)} in its name")
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / "examples").exists():
        (folder / "examples").symlink_to(os.path.relpath(ROOT / "examples", folder))
    failed = False
    for script in chosen:
        start = time.monotonic()
        wrong = run(script, folder)
        failed |= bool(wrong)
        print(wrong or f"{script.stem}: {time.monotonic() - start:.0f} s", flush=True)
    return int(failed)


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]).resolve(), sys.argv[2:]))
