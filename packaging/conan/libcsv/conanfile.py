"""libcsv, which Conan Center does not have: one file in C."""

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, save

LISTS = """cmake_minimum_required(VERSION 3.15)
project(csv C)
add_library(csv STATIC libcsv.c)
set_target_properties(csv PROPERTIES POSITION_INDEPENDENT_CODE ON)
install(TARGETS csv)
install(FILES csv.h TYPE INCLUDE)
"""


class Libcsv(ConanFile):
    name = "libcsv"
    version = "3.0.3"
    license = "LGPL-2.1-or-later"
    description = "Reads and writes CSV, in C89"
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"

    def layout(self):
        cmake_layout(self, src_folder="source")

    def source(self):
        get(self, "https://downloads.sourceforge.net/project/libcsv/libcsv/libcsv-3.0.3/libcsv-3.0.3.tar.gz",
            sha256="d9c0431cb803ceb9896ce74f683e6e5a0954e96ae1d9e4028d6e0f967bebd7e4", strip_root=True)
        save(self, "CMakeLists.txt", LISTS)

    def generate(self):
        CMakeToolchain(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "COPYING.LESSER", self.source_folder, f"{self.package_folder}/licenses")
        CMake(self).install()

    def package_info(self):
        self.cpp_info.libs = ["csv"]
