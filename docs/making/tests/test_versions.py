"""Versions of the site beside each other, and their switch in a browser."""

import functools
import html
import http.server
import re
import shutil
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import versions

MAKING = Path(__file__).resolve().parents[1]
# What a page of the theme has of what the switch needs.
PAGE = """<!DOCTYPE html><html><head>
<script data-url_root="{root}" id="documentation_options"></script>
<script>var DOCUMENTATION_OPTIONS = {{URL_ROOT: document.getElementById("documentation_options").getAttribute("data-url_root")}};</script>
<script src="{root}_static/versions.js"></script>
</head><body><aside><a class="sidebar-brand">microslip</a></aside></body></html>
"""


class VersionsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.host = self.folder / "host"

    def add(self, version, *pages):
        """Puts a site with these pages on the host."""
        site = self.folder / f"site {version}"
        for page in ("index.html", *pages):
            (site / page).parent.mkdir(parents=True, exist_ok=True)
            (site / page).write_text(PAGE.format(root="../" * page.count("/") or "./"))
        (site / "_static").mkdir(exist_ok=True)
        shutil.copy(MAKING / "static" / "versions.js", site / "_static")
        versions.add(site, self.host, version)

    def test_newest_first_and_candidates_before_their_release(self):
        for version in ("1.0.0", "1.10.0", "1.0.0-rc2", "1.2.0", "1.0.0-rc10"):
            self.add(version)
        (self.host / "other").mkdir()
        self.assertEqual([version for version, _ in versions.versions(self.host)], ["1.10.0", "1.2.0", "1.0.0", "1.0.0-rc10", "1.0.0-rc2"])

    def test_a_version_takes_the_place_of_one_of_its_name(self):
        self.add("1.0.0", "old.html")
        shutil.rmtree(self.folder / "site 1.0.0")
        self.add("1.0.0", "tutorials/new.html")
        self.assertEqual(versions.versions(self.host), [("1.0.0", ["index.html", "tutorials/new.html"])])

    def test_what_is_no_version(self):
        with self.assertRaisesRegex(ValueError, "'latest' is no version"):
            self.add("latest")

    def seen(self, address):
        """The document of a page after its scripts have run in Chromium."""
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.folder}/profile", "--virtual-time-budget=5000",
                   "--dump-dom", address]
        return subprocess.run(command, text=True, capture_output=True, timeout=120, check=True).stdout

    def switch(self, address):
        """The choices of a page's switch, as (version, address), and the chosen one; None without a switch."""
        found = re.search(r"</a><select[^>]*>(.*?)</select>", self.seen(address), re.DOTALL)
        if not found:
            return None
        options = re.findall(r'<option value="([^"]*)"( selected="")?>([^<]*)</option>', found[1])
        return [(version, html.unescape(value)) for value, _, version in options], [version for _, chosen, version in options if chosen]

    def check_switch(self, base):
        """The switch of three pages of two versions at an address."""
        self.add("1.0.0", "old.html", "tutorials/lesson.html")
        self.add("1.1.0", "tutorials/lesson.html")
        for page, there in (("index.html", "index.html"), ("tutorials/lesson.html", "tutorials/lesson.html"), ("old.html", "index.html")):
            self.assertEqual(self.switch(f"{base}/1.0.0/{page}"),
                             ([("1.1.0", f"{base}/1.1.0/{there}"), ("1.0.0", f"{base}/1.0.0/{page}")], ["1.0.0"]))

    @unittest.skipUnless(shutil.which("chromium"), "Chromium is not installed")
    def test_the_switch_of_pages_that_are_files(self):
        self.check_switch(self.host.resolve().as_uri())

    @unittest.skipUnless(shutil.which("chromium"), "Chromium is not installed")
    def test_the_switch_of_pages_on_a_server(self):
        class Quiet(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *arguments):
                pass

        server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=self.host))
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        self.check_switch(f"http://127.0.0.1:{server.server_port}")

    @unittest.skipUnless(shutil.which("chromium"), "Chromium is not installed")
    def test_there_is_none_without_other_versions(self):
        self.add("1.0.0")
        address = (self.host / "1.0.0" / "index.html").resolve().as_uri()
        self.assertIsNone(self.switch(address))
        (self.host / "versions.js").unlink()
        self.assertIsNone(self.switch(address))


if __name__ == "__main__":
    unittest.main()
