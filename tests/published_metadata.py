"""What the project says of itself outside its documentation: one version everywhere, and a paper whose citations resolve.

Usage: published_metadata.py FOLDER, the source tree's.
"""

import json
import re
import sys
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop()) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


class PublishedMetadata(unittest.TestCase):
    def test_version_is_that_of_the_build(self):
        number, suffix = re.search(r'project\(microslip VERSION ([\d.]+).*MICROSLIP_PRERELEASE "(\w*)"', text_of("CMakeLists.txt"), re.DOTALL).groups()
        version = f"{number}-{suffix}" if suffix else number
        self.assertEqual(json.loads(text_of("codemeta.json"))["version"], version)
        self.assertEqual(json.loads(text_of("explorer/page/package.json"))["version"], version)
        self.assertEqual(re.search(r"^version: (\S+)$", text_of("CITATION.cff"), re.MULTILINE)[1], version)
        self.assertIn(f"## [{version}]", text_of("CHANGELOG.md"))
        self.assertIn(f"version = {{{version}}}", text_of("README.md"))

    def test_licence_is_one(self):
        self.assertTrue(json.loads(text_of("codemeta.json"))["license"].endswith("/Apache-2.0"))
        self.assertIn("license: Apache-2.0", text_of("CITATION.cff"))
        self.assertIn("License: Apache-2.0", text_of(".reuse/dep5"))
        self.assertEqual(text_of("LICENSES/Apache-2.0.txt"), text_of("LICENSE"))

    def test_paper_cites_what_its_bibliography_has(self):
        cited = set(re.findall(r"@(\w+)", re.sub(r"^---.*?^---", "", text_of("paper/paper.md"), flags=re.DOTALL | re.MULTILINE)))
        self.assertEqual(cited, set(re.findall(r"^@\w+\{(\w+),", text_of("paper/paper.bib"), re.MULTILINE)))

    def test_paper_has_the_length_of_its_journal(self):
        words = len(re.sub(r"^---.*?^---", "", text_of("paper/paper.md"), flags=re.DOTALL | re.MULTILINE).split())
        self.assertTrue(750 <= words <= 1750, words)


if __name__ == "__main__":
    unittest.main()
