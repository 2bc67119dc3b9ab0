"""Turns a tutorial, a Python script in cells, into a page with what it prints and draws.

    tutorial.py SCRIPT FOLDER     writes FOLDER/page.md and its pictures

Cells begin with `# %%`, as editors know them, and those of text with `# %% [markdown]`. After each cell of code the page has what it printed,
and the figures that it made, under the titles that their windows have. Scripts run in the folder of the project.
"""

import contextlib
import io
import os
import sys
from pathlib import Path

MARKER = "# %%"
TEXT = "# %% [markdown]"
ROOT = Path(__file__).resolve().parents[2]


def cells(text):
    """The cells of a script: whether it is text, the number of its first line, its lines."""
    found = []
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith(MARKER):
            found.append((line.rstrip() == TEXT, number + 1, []))
        elif found:
            found[-1][2].append(line)
        elif line.strip():
            raise ValueError(f"a tutorial begins with '{TEXT}', not with '{line}'")
    return found


def prose(lines):
    """The Markdown of a cell of text: comments without their signs."""
    wrong = [line for line in lines if line.strip() and not line.startswith("#")]
    if wrong:
        raise ValueError(f"not a comment in a cell of text: '{wrong[0]}'")
    return "\n".join(line[2:] for line in lines).strip("\n")


def fence(language, text):
    """A fenced block."""
    text = text.strip("\n")
    return f"```{language}\n{text}\n```"


class Runner:
    """Runs cells one after the other and keeps their figures in a folder."""

    def __init__(self, script, folder):
        self.script, self.folder = Path(script), Path(folder)
        self.names = {"__name__": "__main__"}
        self.pictures = 0

    def run(self, first, lines):
        """Code that begins in line `first`, its output and its figures as Markdown."""
        out = io.StringIO()
        code = "\n".join(lines).rstrip("\n")
        with contextlib.redirect_stdout(out):
            exec(compile("\n" * (first - 1) + code, str(self.script), "exec"), self.names)
        parts = [fence("python", code)]
        if out.getvalue().strip():
            parts.append(fence("text", out.getvalue()))
        return parts + self.figures()

    def figures(self):
        """Saves and closes the open figures."""
        from matplotlib import pyplot

        parts = []
        for number in pyplot.get_fignums():
            figure = pyplot.figure(number)
            if not figure.get_label():
                raise ValueError(f"{self.script}: a figure needs a title, subplots(num=...)")
            self.pictures += 1
            name = f"{self.script.stem}_{self.pictures}.png"
            figure.savefig(self.folder / name, dpi=150)
            parts.append(f"![{figure.get_label()}]({name})\n\n*{figure.get_label()}*")
            pyplot.close(figure)
        return parts


def page(script, folder):
    """The Markdown of a tutorial; its pictures go to `folder`."""
    runner, parts = Runner(script, folder), []
    for is_text, first, lines in cells(Path(script).read_text()):
        parts += [prose(lines)] if is_text else runner.run(first, lines)
    return "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    script, folder = (Path(argument).resolve() for argument in sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(ROOT)
    os.environ["MPLBACKEND"] = "Agg"
    (folder / "page.md").write_text(page(script, folder))
