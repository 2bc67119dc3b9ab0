from spack.package import *


class Microslip(CMakePackage):
    """Frictional rolling contact of wheel and rail or of rollers: forces, tractions, slip"""

    url = "@URL@"
    license("Apache-2.0")
    version("@VERSION@", sha256="@SHA256@")

    variant("app", default=True, description="the program")
    variant("libcontact", default=False, description="a replacement for CONTACT's library")
    variant("mpi", default=False, description="campaigns on several processes")
    variant("python", default=False, description="the Python module, and pictures")
    conflicts("+mpi", when="~app")
    requires("+app", when="+python")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    for needs in ("+app", "+libcontact"):
        depends_on("boost+math+random", when=needs)
        depends_on("cli11", when=needs)
        depends_on("fmt", when=needs)
        depends_on("hdf5~mpi", when=needs)
        depends_on("libcsv", when=needs)
        depends_on("nlohmann-json", when=needs)
        depends_on("tomlplusplus", when=needs)
    depends_on("mpi", when="+mpi")
    with when("+python"):
        extends("python")
        depends_on("py-pybind11", type="build")
        depends_on("py-h5py", type="run")
        depends_on("py-jinja2", type="run")
        depends_on("py-matplotlib", type="run")
        depends_on("py-numpy", type="run")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("MICROSLIP_BUILD_APP", "app"),
            self.define_from_variant("MICROSLIP_BUILD_LIBCONTACT", "libcontact"),
            self.define_from_variant("MICROSLIP_BUILD_PYTHON", "python"),
            self.define_from_variant("MICROSLIP_MPI", "mpi"),
            self.define("MICROSLIP_BUILD_TESTS", False),
            self.define("MICROSLIP_BUILD_BENCH", False),
        ]
