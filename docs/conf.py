"""The documentation as a site: `tools/docs` builds it. Pages are the Markdown files of this folder and the scripts of tutorials/."""

import pathlib
import re
import shutil
import sys

folder = pathlib.Path(__file__).parent
project = "microslip"
author = "the microslip authors"
copyright = author  # noqa: A001 (Sphinx's name)
version, prerelease = re.search(r'VERSION (\d+\.\d+\.\d+).*?MICROSLIP_PRERELEASE "(.*?)"', (folder.parent / "CMakeLists.txt").read_text(),
                                re.DOTALL).groups()
release = f"{version}-{prerelease}" if prerelease else version

sys.path.insert(0, str(folder / "making"))

extensions = ["myst_parser", "sphinx.ext.mathjax", "pages"]
myst_enable_extensions = ["dollarmath", "amsmath"]
myst_heading_anchors = 4
myst_dmath_double_inline = True
source_suffix = {".md": "markdown", ".py": "markdown"}  # the .py are tutorials, see making/pages.py
exclude_patterns = ["conf.py", "drawings", "making"]

html_theme = "furo"
html_title = f"microslip {release}"
html_show_sphinx = False
html_static_path = ["making/static"]
html_css_files = ["site.css"]
html_js_files = ["versions.js"]

# Formulas are drawn by Debian's MathJax 2, copied into the site: it needs no network.
mathjax = pathlib.Path("/usr/share/javascript/mathjax")
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML-full"
mathjax2_config = {"tex2jax": {"processClass": "math"}, "messageStyle": "none"}
myst_update_mathjax = False  # which is for MathJax 3


def copy_mathjax(app, exception):
    if exception is None and app.builder.format == "html":
        unneeded = shutil.ignore_patterns("unpacked", "test", "localization", "docs")
        shutil.copytree(mathjax, pathlib.Path(app.outdir) / "_static" / "mathjax", ignore=unneeded, dirs_exist_ok=True)


def setup(app):
    app.connect("build-finished", copy_mathjax)
