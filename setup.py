"""Lets CMake build the compiled module for `pip install .`; everything else is in pyproject.toml."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DMICROSLIP_BUILD_APP=OFF", "-DMICROSLIP_BUILD_TESTS=OFF", "-DMICROSLIP_BUILD_BENCH=OFF",
           "-DMICROSLIP_BUILD_PYTHON=ON", "-DMICROSLIP_PYTHON_FOLDER=.", f"-DPython3_EXECUTABLE={sys.executable}"]


class CMakeBuild(build_ext):
    """Builds the target of the module and puts it where setuptools looks for it."""

    def build_extension(self, ext):
        """Configures, builds, installs."""
        build = Path(self.build_temp).resolve()
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        jobs = str(os.cpu_count() or 1)  # without a number make starts all compilers at once
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, *OPTIONS], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "microslip_python", "--parallel", jobs], check=True)
        subprocess.run(["cmake", "--install", build, "--prefix", package.parent, "--component", "python"], check=True)


VERSION = re.search(r"project\(microslip VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
setup(version=VERSION, ext_modules=[Extension("microslip._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
