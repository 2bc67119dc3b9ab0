"""Puts a site beside those of other versions on a host, and writes which there are for their switch, static/versions.js.

    versions.py SITE HOST     copies the folder SITE to HOST/VERSION, that of conf.py, and renews HOST/versions.js
"""

import json
import re
import runpy
import shutil
import sys
from pathlib import Path

NAME = re.compile(r"(\d+)\.(\d+)\.(\d+)(?:-([a-z]*)(\d*))?")


def age(version):
    """A key by which versions are sorted: 1.0.0-rc1, 1.0.0-rc2, 1.0.0, 1.1.0."""
    *numbers, stage, count = NAME.fullmatch(version).groups()
    return [int(number) for number in numbers], stage is None, stage or "", int(count or 0)


def versions(host):
    """The versions on a host with their pages, newest first."""
    found = [folder for folder in host.iterdir() if NAME.fullmatch(folder.name) and (folder / "index.html").exists()]
    return [(folder.name, sorted(page.relative_to(folder).as_posix() for page in folder.rglob("*.html") if "_static" not in page.parts))
            for folder in sorted(found, key=lambda folder: age(folder.name), reverse=True)]


def add(site, host, version):
    """Copies a site to a host as a version, in place of one of that name, and lists all that are there."""
    if not NAME.fullmatch(version):
        raise ValueError(f"'{version}' is no version, as 1.0.0 or 1.0.0-rc1")
    host.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(host / version, ignore_errors=True)
    shutil.copytree(site, host / version, ignore=shutil.ignore_patterns(".doctrees"))
    (host / "versions.js").write_text(f"documentationVersions({json.dumps(versions(host))});\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    add(Path(sys.argv[1]), Path(sys.argv[2]), runpy.run_path(str(Path(__file__).parents[1] / "conf.py"))["release"])
