"""Runs the code of a page as it stands there, and compares what it prints with what the page says.

    run_blocks.py check PAGE PROGRAMS     in a new folder with a copy of examples/, blocks one after the other
    run_blocks.py extract FOLDER PAGE...  writes the C and C++ blocks as PAGE_1.cpp, ..., for CMake to build

PROGRAMS is the folder with microslip and the built blocks. Exit codes: 0 as the page says, 1 not so.
"""

import contextlib
import doctest
import io
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from blocks import blocks
from output import difference

ROOT = Path(__file__).resolve().parents[2]
COMPILED = {"cpp": ".cpp", "c": ".c"}
LIMIT = 120  # s, for one block


def source_name(page, number):
    """The name of the number-th compiled block of a page."""
    return f"{Path(page).stem.lower()}_{number}"


def compiled_blocks(page):
    """The C and C++ blocks of a page that are to be run, by name."""
    chosen = [block for block in blocks(page) if block.language in COMPILED and not block.mark.startswith("not run: ")]
    return {source_name(page, number): block for number, block in enumerate(chosen, 1)}


def extract(folder, pages):
    """Writes the blocks for the compiler; files that stay the same are left alone."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    wanted = {f"{name}{COMPILED[block.language]}": block.text
              for page in pages for name, block in compiled_blocks(page).items()}
    for old in folder.iterdir():
        if old.name not in wanted:
            old.unlink()
    for name, text in wanted.items():
        path = folder / name
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


def run_program(command, **options):
    """Output of a command; an error with both its streams if it fails."""
    done = subprocess.run(command, text=True, capture_output=True, timeout=LIMIT, **options)
    if done.returncode != 0:
        raise RuntimeError(f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def run_shell(text):
    """Output of commands."""
    return run_program(["bash", "-euo", "pipefail", "-c", text])


def run_python(text, names):
    """Output of Python code; `names` are kept from block to block."""
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(compile(text, "<block>", "exec"), names)
    return out.getvalue()


def run_session(block, names):
    """Runs a block with prompts (>>>); its output stands in it."""
    test = doctest.DocTestParser().get_doctest(block.text, names, str(block.page), None, block.line)
    out = io.StringIO()
    outcome = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE).run(test, out=out.write, clear_globs=False)
    if outcome.failed or not outcome.attempted:
        raise RuntimeError(out.getvalue() or "there is nothing to run")
    names.update(test.globs)


class Page:
    """Runs the blocks of a page in the current folder."""

    def __init__(self, page, programs):
        self.blocks = blocks(page)
        self.names = {"__name__": "__main__"}
        self.built = {block: Path(programs) / f"docs_{name}" for name, block in compiled_blocks(page).items()}
        self.printed = None

    def run(self, block):
        """Runs one block, or compares it with what the block before printed."""
        before, self.printed = self.printed, None
        if any(map(block.marked, ("not run:", "printed by:", "printed slowly by:"))) or block.language.startswith("{"):
            return  # the last is an instruction for Sphinx
        if block.marked("output") is not None:
            self.compare(block, before)
        elif block.language == "python":
            self.printed = run_python(block.text, self.names)
        elif block.language == "pycon":
            run_session(block, self.names)
        elif block.language == "sh":
            self.printed = run_shell(block.text)
        elif block.language == "toml":
            import microslip
            microslip.parse_case(block.text)
        elif block in self.built:
            self.printed = run_program([self.built[block]])
        else:
            raise RuntimeError(f"a block of '{block.language}' needs a mark, see docs/making/blocks.py")

    def compare(self, block, before):
        """Returns whether the command of its mark, or else the block before, printed this."""
        command = block.marked("output of:")
        printed = run_shell(command) if command else before
        if printed is None:
            raise RuntimeError("no block before it was run")
        wrong = difference(block.text, printed)
        if wrong:
            raise RuntimeError(wrong)


def check(page, programs):
    """Runs all blocks of a page and prints what is wrong; returns the exit code."""
    page, programs = Path(page).resolve(), Path(programs).resolve()
    os.environ["PATH"] = f"{programs}{os.pathsep}{os.environ['PATH']}"
    os.environ.setdefault("MPLBACKEND", "Agg")
    wrong = 0
    with tempfile.TemporaryDirectory(prefix="microslip_page_") as folder, contextlib.chdir(folder):
        shutil.copytree(ROOT / "examples", "examples")
        running = Page(page, programs)
        for block in running.blocks:
            try:
                running.run(block)
            except Exception as error:
                wrong += 1
                print(f"{block.place}: {type(error).__name__}: {error}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[1] == "check":
        sys.exit(check(*sys.argv[2:]))
    if len(sys.argv) > 3 and sys.argv[1] == "extract":
        sys.exit(extract(sys.argv[2], sys.argv[3:]))
    sys.exit(__doc__)
