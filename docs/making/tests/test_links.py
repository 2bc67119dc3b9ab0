"""Links of the pages beside the site: README, changelog and how to contribute, between all pages' headings, of tutorials, and the pages
that sources name."""

import re
import unittest
from pathlib import Path

from pages import record_of_doi

ROOT = Path(__file__).resolve().parents[3]
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]
TUTORIALS = [*ROOT.glob("docs/tutorials/*.py")]
LINK = re.compile(r"\]\(([^)\s]+)\)")
# A page that a comment or a message names, as docs/conventions.md.
NAMED = re.compile(r"\bdocs/[\w-]+\.md\b")
SOURCES = [file for folder in ("app", "bench", "c", "campaign", "cases", "compat", "examples", "explorer/core", "explorer/page/src", "fit", "fmi",
                               "fuzz", "io", "microslip", "python", "tests", "tools", "validation")
           for file in (ROOT / folder).rglob("*") if file.suffix in ("", ".cpp", ".hpp", ".c", ".h", ".f90", ".py", ".ts", ".toml") and file.is_file()]


def anchors(page):
    """Of the headings, as GitHub and the site make them."""
    headings = re.findall(r"^#+ (.*)$", without_code(page.read_text(encoding="utf-8")), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def without_code(text):
    """Blocks of code have no links, and their comments are no headings."""
    return re.sub(r"^```.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)


def broken(page):
    """The links of a page that lead nowhere."""
    for link in LINK.findall(without_code(page.read_text(encoding="utf-8"))):
        if re.match(r"[a-z]+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (page.parent / name).resolve() if name else page
        if not target.exists() or anchor and target.suffix == ".md" and anchor not in anchors(target):
            yield f"{page.relative_to(ROOT)}: {link}"


class LinksTest(unittest.TestCase):
    def test_links_lead_somewhere(self):
        self.assertGreater(sum(len(LINK.findall(page.read_text(encoding="utf-8"))) for page in PAGES), 100)
        self.assertEqual([link for page in PAGES + TUTORIALS for link in broken(page)], [])

    def test_pages_that_sources_name_are_there(self):
        named = [(file, name) for file in SOURCES for name in NAMED.findall(file.read_text(encoding="utf-8", errors="ignore"))]
        self.assertGreater(len(named), 10)
        self.assertEqual([f"{file.relative_to(ROOT)}: {name}" for file, name in named if not (ROOT / name).exists()], [])


    def test_of_a_doi_its_record_is_asked(self):
        self.assertEqual(record_of_doi(None, "https://doi.org/10.1016/0020-7403(67)90043-4"), "https://doi.org/api/handles/10.1016/0020-7403(67)90043-4")
        self.assertIsNone(record_of_doi(None, "https://semver.org"))


if __name__ == "__main__":
    unittest.main()
