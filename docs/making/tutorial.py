"""Turns a tutorial, a Python script in cells, into a page with what it prints and draws.

    tutorial.py SCRIPT FOLDER     writes FOLDER/page.md with its pictures, and FOLDER/SCRIPT.ipynb, a notebook with all output

Cells begin with `# %%`, as editors know them, and those of text with `# %% [markdown]`. After each cell of code the page has what it printed,
what its last line was worth, as in notebooks, and the figures that it made, under the titles that their windows have. Scripts run in the folder of the project.
"""

import ast
import base64
import contextlib
import io
import os
import re
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


class Cell:
    """A cell of code and its output: what it printed, what its last line was worth, its pictures with titles; nothing before it is run."""

    def __init__(self, lines):
        self.code, self.printed, self.value, self.pictures = "\n".join(lines).rstrip("\n"), "", None, []

    def markdown(self):
        parts = [fence("python", self.code)]
        if self.printed.strip():
            parts.append(fence("text", self.printed))
        if hasattr(self.value, "_repr_html_"):
            parts.append(fence("{raw} html", self.value._repr_html_()))
        elif self.value is not None:
            parts.append(fence("text", repr(self.value)))
        return parts + [f"![{title}]({file.name})\n\n*{title}*" for title, file in self.pictures]

    def outputs(self, count):
        """Converts it to outputs of a notebook."""
        from nbformat.v4 import new_output

        found = []
        if self.printed:
            found.append(new_output("stream", text=self.printed))
        if self.value is not None:
            data = {"text/plain": repr(self.value)}
            if hasattr(self.value, "_repr_html_"):
                data["text/html"] = self.value._repr_html_()
            found.append(new_output("execute_result", data, execution_count=count))
        for title, file in self.pictures:
            data = {"text/plain": f"<{title}>", "image/png": base64.b64encode(file.read_bytes()).decode()}
            found.append(new_output("display_data", data))
        return found


class Runner:
    """Runs cells one after the other and keeps their figures in a folder."""

    def __init__(self, script, folder):
        self.script, self.folder = Path(script), Path(folder)
        self.names = {"__name__": "__main__"}
        self.pictures = 0

    def run(self, first, lines):
        """Runs code that begins in line `first`; what it left."""
        cell = Cell(lines)
        tree = ast.parse("\n" * (first - 1) + cell.code, str(self.script))
        last = ast.Expression(tree.body.pop().value) if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(tree, str(self.script), "exec"), self.names)
            if last:
                cell.value = eval(compile(last, str(self.script), "eval"), self.names)
        cell.printed, cell.pictures = out.getvalue(), self.figures()
        return cell

    def figures(self):
        """Saves and closes the open figures: their titles and files."""
        from matplotlib import pyplot

        found = []
        for number in pyplot.get_fignums():
            figure = pyplot.figure(number)
            if not figure.get_label():
                raise ValueError(f"{self.script}: a figure needs a title, subplots(num=...)")
            self.pictures += 1
            file = self.folder / f"{self.script.stem}_{self.pictures}.png"
            figure.savefig(file, dpi=150)
            found.append((figure.get_label(), file))
            pyplot.close(figure)
        return found


def notebook(parts):
    """A Jupyter notebook (format 4.5) of texts and cells of code with their output. Links within the site are left as words."""
    from nbformat import v4

    found = []
    for number, part in enumerate(parts):
        if isinstance(part, str):
            found.append(v4.new_markdown_cell(re.sub(r"\[([^\]]*)\]\((?!https?:)[^)]*\)", r"\1", part), id=f"cell-{number}"))
        else:
            found.append(v4.new_code_cell(part.code, id=f"cell-{number}", execution_count=number + 1, outputs=part.outputs(number + 1)))
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return v4.new_notebook(cells=found, metadata={"kernelspec": kernel, "language_info": {"name": "python"}})


def executed(script, folder):
    """Runs a tutorial: its texts as strings, its code as cells. Pictures go to `folder`."""
    runner = Runner(script, folder)
    return [prose(lines) if is_text else runner.run(first, lines) for is_text, first, lines in cells(Path(script).read_text())]


def page(parts):
    """The Markdown of a tutorial that has been run."""
    return "\n\n".join(text for part in parts for text in ([part] if isinstance(part, str) else part.markdown())) + "\n"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    import nbformat

    script, folder = (Path(argument).resolve() for argument in sys.argv[1:])
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(ROOT)
    os.environ["MPLBACKEND"] = "Agg"
    parts = executed(script, folder)
    nbformat.write(notebook(parts), folder / f"{script.stem}.ipynb")
    (folder / "page.md").write_text(page(parts))
