"""Renews the blocks of the pages that are marked `printed by: COMMAND` or `printed slowly by: COMMAND` with what the
commands print now.

    printed.py --list          prints the commands
    printed.py [WORD...]       runs the commands with one of the words in them or in the name of a page that has what they
                               print (none: all), and rewrites their blocks
    printed.py --check WORD... only says which blocks have other figures than their marks allow; exit code 1 if there are any
    printed.py --quick ...     leaves out the slow ones

A block is an excerpt: its lines stand in the output in their order with the same words, and take over its figures and verdicts. Where the words have changed the block is left as it is and named: then page and prose need a hand. Exit code 1; 77 where all commands lack stored results.
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from blocks import blocks
from figures import VERDICT, other_line, parse
from output import NUMBER

ROOT = Path(__file__).resolve().parents[2]
BUILD = "build/release"  # as the commands have it
MARKS = ("printed by:", "printed slowly by:")
OMITTED = "..."
# What a study says whose stored results are not there.
SKIPPED = re.compile(r"^ *SKIPPED: .*$", re.MULTILINE)
NOTHING = 77  # the exit code where nothing could be run


def words(line):
    """A line without its figures and verdicts."""
    return " ".join(NUMBER.sub("#", VERDICT.sub("!", line)).split())


def equal_figures(one, other):
    """Number of figures that two lines with the same words have in common: labels and what has not changed say which line it is."""
    return sum(a == b for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)))


def next_line(line, lines, begin, end):
    """The line of the output that a line of the page stands for: same words, and of several the one with the most equal figures. None if there
    is none."""
    same = [k for k in range(begin, end) if words(lines[k]) == words(line)]
    return max(same, key=lambda k: equal_figures(lines[k], line), default=None)


def paragraph_end(lines, begin):
    """The number of the blank line that ends the paragraph of a line."""
    return next((k for k in range(begin, len(lines)) if not lines[k].strip()), len(lines))


def aligned(said, lines, start):
    """The lines of the output from `start` on that the lines of a page stand for, or the first line of the page that is not there. Within a
    paragraph the page may leave lines out; whole paragraphs only where it has "..."."""
    made, here, skipping = [], start, False
    for line in said:
        if line.strip().startswith(OMITTED):
            made.append(line)
            skipping = True
            continue
        end = len(lines) if skipping else min(paragraph_end(lines, here) + 1, len(lines))
        found = next_line(line, lines, here, end)
        if found is None:
            return made, line
        made.append(lines[found].rstrip())
        here, skipping = found + 1, False
    return made, None


def renewed(text, output):
    """An excerpt with the figures of the output. ValueError names the first line whose words are not there."""
    said, lines = text.rstrip("\n").splitlines(), output.splitlines()
    first = next(line for line in said if not line.strip().startswith(OMITTED))
    starts = [k for k, line in enumerate(lines) if words(line) == words(first)]
    starts.sort(key=lambda k: -equal_figures(lines[k], first))
    best, missing = [], first
    for start in starts:
        made, wrong = aligned(said, lines, start)
        if wrong is None:
            return "".join(f"{line}\n" for line in made)
        if len(made) > len(best):
            best, missing = made, wrong
    raise ValueError(f"not printed so any more: '{missing.strip()}'")


@dataclass
class Printed:
    """Excerpts of a command's output in the pages."""

    command: str
    is_slow: bool = False
    blocks: list = field(default_factory=list)

    def has(self, word):
        """Returns whether the word is in the command or in the path of a page."""
        return word in self.command or any(word in str(block.page) for block in self.blocks)


def commands(pages):
    """The marked blocks of all pages, by their command."""
    found = {}
    for page in pages:
        for block in blocks(page):
            quick, slow = (block.marked(word) for word in MARKS)
            if command := quick or slow:
                one = found.setdefault(command, Printed(command))
                one.is_slow |= slow is not None
                one.blocks.append(block)
    return found


def rewrite(block, text):
    """Puts another text into a block; the page is replaced as a whole."""
    lines = block.page.read_text().splitlines(keepends=True)
    lines[block.line:block.line + block.text.count("\n")] = [text]
    unfinished = block.page.with_suffix(".unfinished")
    unfinished.write_text("".join(lines))
    unfinished.replace(block.page)


def renew(block, output, write):
    """Renews one block if `write`, and prints what is to be said; returns whether it is as it should be."""
    try:
        text = renewed(block.text, output)
    except ValueError as error:
        print(f"{block.place}: {error}")
        return False
    if write:
        if text != block.text:
            print(f"{block.place}: renewed")
            rewrite(block, text)
        return True
    other = other_line(block.text, text, parse(block.compared))
    if other:
        print(f"{block.place}: says\n  {other[0]}\nbut printed is\n  {other[1]}")
    return other is None


def make_workplace(folder, build):
    """Links to all that the commands name, so that what they write is written elsewhere; `build` instead of the usual one."""
    for entry in ROOT.iterdir():
        if entry.name not in ("build", "results"):
            (folder / entry.name).symlink_to(entry)
    (folder / "results").mkdir()
    (folder / BUILD).parent.mkdir()
    (folder / BUILD).symlink_to(ROOT / build)


def run(command, folder):
    """Output of a command, None if it fails; a study whose figures are not met has the exit code 1 and is printed all the same."""
    environment = {**os.environ, "PATH": f"{folder / BUILD / 'bin'}{os.pathsep}{os.environ['PATH']}"}
    done = subprocess.run(["bash", "-c", command], text=True, stdout=subprocess.PIPE, cwd=folder, env=environment)
    if done.returncode not in (0, 1):
        print(f"{command}: exit code {done.returncode}")
        return None
    return done.stdout


def main(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(description="Runs studies and benchmarks and rewrites what the documentation says "
                                     "that they print. All of them take an hour or so.")
    parser.add_argument("words", nargs="*", metavar="WORD", help="only the commands with one of these in them or in their page's name")
    parser.add_argument("--list", action="store_true", help="print the commands and run none")
    parser.add_argument("--check", action="store_true", help="say which figures are others and rewrite none")
    parser.add_argument("--quick", action="store_true", help="leave out commands that take more than some seconds")
    parser.add_argument("--build", default=BUILD, help=f"the folder of the programs; default: {BUILD}")
    asked = parser.parse_args(arguments)
    found = commands([ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]).values()
    wanted = [one for one in found if (not asked.words or any(map(one.has, asked.words))) and not (asked.quick and one.is_slow)]
    if asked.list:
        print("\n".join(one.command for one in wanted))
        return 0
    if not wanted:
        raise SystemExit(f"no command has {' or '.join(asked.words)} in it; --list prints all")
    right, compared = True, False
    with tempfile.TemporaryDirectory(prefix="microslip_printed_") as folder:
        make_workplace(Path(folder), asked.build)
        for one in wanted:
            print(f"{one.command} ...", flush=True)
            output = run(one.command, Path(folder))
            if output is None:
                right = False
            elif skipped := SKIPPED.search(output):
                print(skipped[0])
            else:
                compared = True
                for block in one.blocks:
                    right &= renew(block, output, not asked.check)
    return (0 if compared else NOTHING) if right else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
