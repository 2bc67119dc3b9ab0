"""The recipes of packaging/ as tools/recipes writes them: whole, of one version and licence, and with the dependencies that
the lists of Debian packages have. What is at hand of their languages reads them.

Usage: recipes_test.py FOLDER, the source tree's.
"""

import ast
import hashlib
import importlib.machinery
import importlib.util
import json
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop()) if len(sys.argv) > 1 else Path(__file__).resolve().parents[1]

# What a dependency is called: by Debian, then by conda-forge, Spack, vcpkg, Conan, Homebrew.
LIBRARIES = {
    "libboost-dev": ("libboost-headers", "boost+math+random", {"boost-math", "boost-random"}, "boost", "boost"),
    "libcli11-dev": ("cli11", "cli11", {"cli11"}, "cli11", "cli11"),
    "libcsv-dev": (None, "libcsv", {"libcsv"}, "libcsv", "libcsv"),
    "libfmt-dev": ("fmt", "fmt", {"fmt"}, "fmt", "fmt"),
    "libhdf5-dev": ("hdf5", "hdf5~mpi", {"hdf5"}, "hdf5", "hdf5"),
    "libtomlplusplus-dev": ("tomlplusplus", "tomlplusplus", {"tomlplusplus"}, "tomlplusplus", "tomlplusplus"),
    "nlohmann-json3-dev": ("nlohmann_json", "nlohmann-json", {"nlohmann-json"}, "nlohmann_json", "nlohmann-json"),
}
BUILD_TOOLS = {"cmake", "ninja"}


def loaded(file):
    loader = importlib.machinery.SourceFileLoader(file.name, str(file))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(file.name, loader))
    loader.exec_module(module)
    return module


def names(place):
    return {found[place] for found in LIBRARIES.values()}


def listed(text, key):
    """The entries of a list of YAML below a key, without what they say of versions."""
    entries = re.search(rf"^ +{key}:\n((?: +- .*\n)+)", text, re.MULTILINE)[1]
    return {entry.split()[0] for entry in re.findall(r"- (.*)", entries) if not entry.startswith("$")}


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tool = loaded(ROOT / "tools/recipes")
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = Path(cls.temporary.name)
        cls.tool.write_recipes(cls.folder, b"sources", "https://example.invalid")
        cls.texts = {name: (cls.folder / file).read_text() for name, file in {
            "conda": "conda/recipe.yaml", "spack": "spack/packages/microslip/package.py", "vcpkg": "vcpkg/microslip/vcpkg.json",
            "port": "vcpkg/microslip/portfile.cmake", "conan": "conan/microslip/conanfile.py", "homebrew": "homebrew/microslip.rb"}.items()}
        cls.project = tomllib.loads((ROOT / "pyproject.toml").read_text())

    def test_nothing_is_left_to_fill_in(self):
        for file in filter(Path.is_file, self.folder.rglob("*")):
            self.assertNotRegex(file.read_text(), r"@[A-Z0-9_]+@", file)

    def test_version_licence_and_archive_are_one(self):
        version, python_version = self.tool.versions()
        metadata = json.loads((ROOT / "codemeta.json").read_text())
        self.assertEqual(metadata["version"], version)
        for name, text in self.texts.items():
            self.assertIn(python_version if name == "conda" else version, text, name)
            self.assertTrue(name == "port" or '"Apache-2.0"' in text or "license: Apache-2.0" in text, name)
            digest = hashlib.sha512 if name == "port" else hashlib.sha256
            self.assertTrue(name == "vcpkg" or digest(b"sources").hexdigest() in text, name)
            self.assertTrue(name == "vcpkg" or f"https://example.invalid/microslip-{version}.tar.gz" in text, name)
        self.assertEqual(self.project["project"]["license"]["text"], "Apache-2.0")

    def test_libraries_are_those_of_the_debian_packages(self):
        packages = (ROOT / "tools/packages-run.txt").read_text()
        section = packages[packages.index("# libraries\n"):packages.index("# pictures")]
        self.assertEqual(set(re.findall(r"^[^#\s]+", section, re.MULTILINE)), set(LIBRARIES))
        conda = listed(self.texts["conda"], "host") - {"python", "pybind11"}
        self.assertEqual(conda, names(0) - {None})
        self.assertIn("libcsv-3.0.3.tar.gz", self.texts["conda"])
        self.assertEqual(set(re.findall(r'depends_on\("([^"]+)", when=needs\)', self.texts["spack"])), names(1))
        program = json.loads(self.texts["vcpkg"])["features"]["program"]["dependencies"]
        self.assertEqual({entry if isinstance(entry, str) else entry["name"] for entry in program}, set().union(*(found[2] for found in LIBRARIES.values())))
        self.assertEqual(set(re.findall(r'self\.requires\("([^/]+)/', self.texts["conan"])), names(3))
        self.assertEqual(set(re.findall(r'depends_on "([^"]+)"', self.texts["homebrew"])) - BUILD_TOOLS, names(4))

    def test_python_packages_are_those_of_the_wheel(self):
        wheel = set(self.project["project"]["dependencies"])
        conda = {name.removesuffix("-base") for name in listed(self.texts["conda"], "run")} - {"python"}
        spack = {name.removeprefix("py-") for name in re.findall(r'depends_on\("([^"]+)", type="run"\)', self.texts["spack"])}
        self.assertEqual((conda, spack), (wheel, wheel))

    def test_wheels_are_for_the_pythons_that_are_stated(self):
        settings = self.project["tool"]["cibuildwheel"]
        stated = {f"cp3{minor}-*" for minor in re.findall(r"Python :: 3\.(\d+)", "\n".join(self.project["project"]["classifiers"]))}
        self.assertEqual(set(settings["build"].split()), stated)
        script = re.search(r"packaging/\S+", settings["linux"]["before-all"])[0]
        self.assertTrue((ROOT / script).is_file())

    def test_options_are_those_of_the_build(self):
        lists = "".join((ROOT / name).read_text() for name in ("CMakeLists.txt", "campaign/CMakeLists.txt", "python/CMakeLists.txt"))
        known = set(re.findall(r"(?:option|set)\((MICROSLIP_\w+)", lists))
        for file in filter(Path.is_file, self.folder.rglob("*")):
            for option in re.findall(r"\bMICROSLIP_\w+\b(?!\{)", file.read_text()):
                self.assertTrue(option in known or option == "MICROSLIP_BUILD_", f"{file.name}: {option}")

    def test_each_is_read_by_its_language(self):
        for file in self.folder.rglob("*.py"):
            ast.parse(file.read_text(), file.name)
        for file in self.folder.rglob("*.sh"):
            subprocess.run(["bash", "-n", file], check=True)
        if shutil.which("ruby"):
            subprocess.run(["ruby", "-c", self.folder / "homebrew/microslip.rb"], check=True, stdout=subprocess.DEVNULL)
        try:
            import yaml
        except ImportError:
            return
        recipe = yaml.safe_load(self.texts["conda"])
        self.assertEqual(recipe["package"]["name"], "microslip")


if __name__ == "__main__":
    unittest.main()
