"""Lets CMake build the compiled module and the program for pip; everything else is in pyproject.toml."""

import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT / "python/making"))
from carried_libraries import carry_libraries  # noqa: E402  beside this file, which pip does not put on the path

OPTIONS = ["-DCMAKE_BUILD_TYPE=Release", "-DMICROSLIP_BUILD_APP=ON", "-DMICROSLIP_BUILD_TESTS=OFF", "-DMICROSLIP_BUILD_BENCH=OFF",
           "-DMICROSLIP_BUILD_LIBCONTACT=OFF", "-DMICROSLIP_BUILD_PYTHON=ON", "-DMICROSLIP_MPI=OFF", "-DMICROSLIP_PYTHON_FOLDER=.",
           "-DCMAKE_INSTALL_BINDIR=microslip/bin", f"-DPython3_EXECUTABLE={sys.executable}"]


def pybind11_option():
    """Where pip's pybind11 is, if pip has brought it for the build."""
    try:
        from pybind11 import get_cmake_dir
    except ImportError:
        return []
    return [f"-Dpybind11_DIR={get_cmake_dir()}"]


class CMakeBuild(build_ext):
    """Builds module and program and puts them where setuptools looks for the module."""

    def build_extension(self, ext):
        """Configures, builds, installs."""
        build = Path(self.build_temp).resolve()
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        jobs = str(os.cpu_count() or 1)  # without a number make starts all compilers at once
        targets = ["microslip_python", "microslip_app", "microslip_validate"]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *generator, *OPTIONS, *pybind11_option()], check=True)
        subprocess.run(["cmake", "--build", build, "--target", *targets, "--parallel", jobs], check=True)
        for component in ("python", "program"):
            subprocess.run(["cmake", "--install", build, "--prefix", package.parent, "--component", component], check=True)
        carry_libraries([package / Path(self.get_ext_filename(ext.name)).name, package / "bin/microslip",
                         package / "bin/microslip-validate"], package / "libraries")


VERSION = "".join(re.search(r'project\(microslip VERSION ([\d.]+).*MICROSLIP_PRERELEASE "(\w*)"',
                            (ROOT / "CMakeLists.txt").read_text(), re.DOTALL).groups())  # 1.0.0rc1, as pip writes it
LIBC = platform.libc_ver()[1].replace(".", "_")
setup(version=VERSION, ext_modules=[Extension("microslip._core", sources=[])], cmdclass={"build_ext": CMakeBuild},
      options={"bdist_wheel": {"plat_name": f"manylinux_{LIBC}_{platform.machine()}"}})
