"""Sphinx extension: pages that are made when the site is built.

A tutorial (a `.py` file) becomes what tutorial.py makes of it. In a Markdown page a line `<!-- headers: FOLDER or FILE -->` becomes the reference of the headers
there, `<!-- python reference -->` that of the compiled module.
"""

import os
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import headers
import python_names

ROOT = Path(__file__).resolve().parents[2]
HEADERS = re.compile(r"^<!-- headers: (\S+) -->$", re.MULTILINE)
PYTHON = "<!-- python reference -->"


def tutorial_page(app, docname):
    """Runs a tutorial in a separate process, if its page is not there yet or older than what it is made from."""
    folder = Path(app.doctreedir) / docname
    script, runner = Path(app.srcdir) / f"{docname}.py", Path(__file__).with_name("tutorial.py")
    module = Path(find_spec("microslip._core").origin)
    app.env.note_dependency(str(module))
    page = folder / "page.md"
    if not page.exists() or page.stat().st_mtime < max(source.stat().st_mtime for source in (script, runner, module)):
        done = subprocess.run([sys.executable, runner, script, folder], text=True, capture_output=True)
        if done.returncode != 0:
            raise RuntimeError(f"{script} fails\n{done.stdout}{done.stderr}")
    place = os.path.relpath(folder, Path(app.srcdir) / Path(docname).parent)
    text = re.sub(r"^!\[(.*)\]\((\S+)\)$", rf"![\1]({place}/\2)", page.read_text(), flags=re.MULTILINE)
    title, rest = text.split("\n\n", 1)
    script, book = f"docs/{docname}.py", f"{place}/{Path(docname).name}.ipynb"
    return f"{title}\n\n{{download}}`Notebook<{book}>` with all output; script `{script}`; [how to open them](../tutorials.md).\n\n{rest}"


def header_sections(app, match):
    """The reference of a header, or of those in a folder."""
    place = ROOT / match[1]
    files = [place] if place.is_file() else sorted(place.glob("*.hpp"))
    if not files:
        raise RuntimeError(f"no headers in {place}")
    for file in files:
        app.env.note_dependency(str(file))
    sections = [headers.reference(file.read_text(), file.relative_to(ROOT).as_posix().removeprefix("c/include/"), "c" if file.suffix == ".h" else "cpp")
                for file in files]
    return "\n\n".join(sections)


def python_reference(app):
    """The reference of the compiled module."""
    import microslip
    from microslip import plot

    app.env.note_dependency(str(python_names.STUB))
    return python_names.reference(microslip, plot)


def make_page(app, docname, source):
    """The text of a page as Sphinx is to read it."""
    if Path(app.env.doc2path(docname)).suffix == ".py":
        source[0] = tutorial_page(app, docname)
        return
    source[0] = HEADERS.sub(lambda match: header_sections(app, match), source[0])
    if PYTHON in source[0]:
        source[0] = source[0].replace(PYTHON, python_reference(app))


def record_of_doi(app, uri):
    """The record of a DOI in place of the publisher's page, which many refuse to programs: what tools/links asks for."""
    doi = re.fullmatch(r"https://doi\.org/(.+)", uri)
    return f"https://doi.org/api/handles/{doi[1]}" if doi else None


def setup(app):
    """Called by Sphinx."""
    app.connect("linkcheck-process-uri", record_of_doi)
    app.connect("source-read", make_page)
    return {"parallel_read_safe": True}
