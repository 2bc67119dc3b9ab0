"""conan create FOLDER/libcsv && conan create FOLDER/microslip"""

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get


class Microslip(ConanFile):
    name = "microslip"
    version = "@VERSION@"
    license = "Apache-2.0"
    description = "Frictional rolling contact of wheel and rail or of rollers: forces, tractions, slip"
    topics = ("rolling-contact", "contact-mechanics", "wheel-rail-contact", "friction")
    package_type = "static-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"program": [True, False]}
    default_options = {"program": False}

    def layout(self):
        cmake_layout(self, src_folder="source")

    def validate(self):
        check_min_cppstd(self, 20)

    def requirements(self):
        if self.options.program:
            self.requires("boost/[>=1.74]")
            self.requires("cli11/[>=2.3]")
            self.requires("fmt/[>=9]")
            self.requires("hdf5/[>=1.10]")
            self.requires("libcsv/3.0.3")
            self.requires("nlohmann_json/[>=3.11]")
            self.requires("tomlplusplus/[>=3.3]")

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25]")

    def source(self):
        get(self, "@URL@", sha256="@SHA256@", strip_root=True)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["MICROSLIP_BUILD_APP"] = bool(self.options.program)
        for part in ("PYTHON", "LIBCONTACT", "TESTS", "BENCH"):
            toolchain.cache_variables[f"MICROSLIP_BUILD_{part}"] = False
        toolchain.cache_variables["MICROSLIP_MPI"] = False
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        copy(self, "LICENSE", self.source_folder, f"{self.package_folder}/licenses")
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # the package has its own microslip-config.cmake
        self.cpp_info.builddirs.append("lib/cmake/microslip")
        self.cpp_info.libs = ["microslip"]
