"""Links of the pages beside the site: README, changelog and how to contribute, and between all pages' headings."""

import re
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]
LINK = re.compile(r"\]\(([^)\s]+)\)")


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
        self.assertEqual([link for page in PAGES for link in broken(page)], [])


if __name__ == "__main__":
    unittest.main()
