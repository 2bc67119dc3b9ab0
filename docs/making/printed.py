"""Renews the blocks of the pages that are marked `printed by: COMMAND` with what the commands print now.

    printed.py --list          prints the commands
    printed.py [WORD...]       runs the commands that have one of the words in them (none: all), and rewrites their blocks
    printed.py --check WORD... only says which blocks would change; exit code 1 if there are any

A block is an excerpt: its lines stand in the output in their order with the same words, and take over its figures and verdicts. Where the words have changed the block is left as it is and named: then page and prose need a hand. Exit code 1.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

from blocks import blocks
from output import NUMBER

ROOT = Path(__file__).resolve().parents[2]
VERDICT = re.compile(r"\b(ok|NOT MET)\b")
OMITTED = "..."


def words(line):
    """A line without its figures and verdicts."""
    return " ".join(NUMBER.sub("#", VERDICT.sub("!", line)).split())


def equal_figures(one, other):
    """How many figures two lines with the same words have in common: labels and what has not changed say which line it is."""
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


def commands(pages):
    """The marked blocks of all pages, by their command."""
    found = {}
    for page in pages:
        for block in blocks(page):
            command = block.marked("printed by:")
            if command:
                found.setdefault(command, []).append(block)
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
    if text == block.text:
        return True
    print(f"{block.place}: {'renewed' if write else 'other figures'}")
    if write:
        rewrite(block, text)
    return write


def run(command):
    """What a command prints; a study whose figures are not met has the exit code 1 and is printed all the same."""
    done = subprocess.run(["bash", "-c", command], text=True, stdout=subprocess.PIPE, cwd=ROOT)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{command}: exit code {done.returncode}")
    return done.stdout


def main(arguments):
    """The command line."""
    parser = argparse.ArgumentParser(description="Runs studies and benchmarks and rewrites what the documentation says "
                                     "that they print. All of them take an hour or so.")
    parser.add_argument("words", nargs="*", metavar="WORD", help="only the commands with one of these in them")
    parser.add_argument("--list", action="store_true", help="print the commands and run none")
    parser.add_argument("--check", action="store_true", help="say which figures are others and rewrite none")
    asked = parser.parse_args(arguments)
    chosen = asked.words
    found = commands([ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))])
    if asked.list:
        print("\n".join(found))
        return 0
    wanted = [command for command in found if not chosen or any(word in command for word in chosen)]
    if not wanted:
        raise SystemExit(f"no command has {' or '.join(chosen)} in it; --list prints all")
    right = True
    for command in wanted:
        print(f"{command} ...", flush=True)
        output = run(command)
        for block in found[command]:
            right &= renew(block, output, not asked.check)
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
