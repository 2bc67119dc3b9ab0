#!/usr/bin/env python3
"""Runs what is in examples/, each file as its kind is run, in a new folder.

    run_example.py --list             prints the files; with tests, build files and headers left out
    run_example.py BUILD FILE         runs one, by its path in examples/, with the programs of a build

Exit codes: 0 it runs and is right by what its program says, 1 not so, 77 what it needs is not installed or not built.
"""
import fnmatch
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
EXAMPLES = ROOT / "examples"
NOT_THERE = 77
PROFILES = ("{examples}/profiles/60e1.prr", "{examples}/profiles/s1002.prw")

# What is no example by itself: parts of the programs beside them, and of other makers' programs.
PARTS = ("measured_friction.csv", "*/tests/*", "*/CMakeLists.txt", "*.hpp", "*.sed", "*/README.md", "*/__pycache__/*", "adapters/*")

# What scripts and programs are given. {build}, {examples}: folders.
ARGUMENTS = {
    "libcontact/manchester.py": ("{build}/compat/libcontact/libcontact.so", *PROFILES),
    "libcontact/manchester.c": PROFILES,
    "libcontact/manchester.f90": PROFILES,
    "c/solve_case.c": ("{examples}/hertzian_contact.toml",),
    "wheel_rail_unit.py": ("{build}/microslip_wheel_rail.fmu",),
    "wheelset/wheelset.py": ("{build}/c/libmicroslip_c.so",),
    "wheelset/profiled_wheelset.py": ("{examples}/profiles",),
    "wear/wear.py": (".", "--distance", "20"),
}

# Sections that make a case file a sweep's specification.
SWEEPS = ("[grid]", "[list]", "[sample]")

# Programs that are built, by their sources.
BUILT = {"c/*.c": "c_{stem}", "fortran/*.f90": "fortran_{stem}", "libcontact/*.f90": "libcontact_{stem}_fortran",
         "libcontact/*.c": "libcontact_{stem}_c", "wheelset/main.cpp": "wheelset", "wheelset/*.cpp": "{stem}",
         "vehicle/*.cpp": "{stem}"}

# What a separate test runs, in a script that names the file; and what takes minutes, which the figures of a page run.
ELSEWHERE = {"matlab/*.m": "c/tests/mex_test.m", "libcontact/wheel_forces.c": "compat/libcontact/tests/octave.sh",
             "wheelset/wheelset_on_profiles.cpp": "docs/wheelset-on-track.md", "wheelset/wheelset_theories.cpp": "docs/wheelset-on-track.md",
             "adapters/dytsi/critical_speed.cpp": "examples/adapters/dytsi/tests/bogies_test.sh",
             "adapters/dytsi/plot.py": "examples/adapters/dytsi/critical_speeds.sh",
             "adapters/dytsi/critical_speeds.sh": "docs/making/images.py",
             "vehicle/main.cpp": "docs/vehicle.md", "vehicle/plot.py": "docs/vehicle.md"}

# What is run before an example, for the files that it reads.
BEFORE = {
    "wheelset/plot.py": ("{build}/bin/wheelset", "."),
    "wear/plot.py": (sys.executable, "{examples}/wear/wear.py", ".", "--distance", "20"),
}


def matches(name, patterns):
    """The first pattern that a name matches, or None."""
    return next((pattern for pattern in patterns if fnmatch.fnmatch(name, pattern)), None)


def names():
    """The files that are run, by their paths in examples/."""
    files = sorted(path.relative_to(EXAMPLES).as_posix() for path in EXAMPLES.rglob("*") if path.is_file())
    is_part = {name for name in files if name.endswith(".cpp") and "int main(" not in (EXAMPLES / name).read_text()}
    return [name for name in files if name not in is_part and not matches(name, PARTS)]


class Failed(Exception):
    """An example does not run as it should."""


class NotThere(Exception):
    """Something that an example needs is not built or installed."""


class Runner:
    """Runs examples in the current folder with the programs of a build."""

    def __init__(self, build):
        self.build = build
        self.program = str(build / "bin/microslip")

    def filled(self, texts, **more):
        """Texts with the folders in them."""
        return [text.format(build=self.build, examples=EXAMPLES, **more) for text in texts]

    def run(self, *command, environment=None, codes=(0,)):
        """Runs a command; it has Failed with an exit code that is none of `codes`."""
        done = subprocess.run(list(map(str, command)), text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                              env={**os.environ, **(environment or {})})
        said = f"{' '.join(map(str, command))}\n{done.stdout[-4000:]}{done.stderr}"
        if done.returncode not in codes:
            raise Failed(f"exit code {done.returncode}: {said}")
        print(said)

    def microslip(self, *arguments, **options):
        """Runs the program."""
        self.run(self.program, *arguments, **options)

    def plot(self, folder):
        """Draws every result below a folder."""
        results = sorted(pathlib.Path(folder).rglob("*.h5"))
        if not results:
            raise Failed(f"no result in {folder}")
        for result in results:
            pictures = result.with_suffix("")
            self.microslip("plot", result, "-o", pictures)
            if not list(pictures.glob("*.png")):
                raise Failed(f"no pictures of {result}")

    def case(self, name):
        """A case or a sweep, as `init` writes it, with what it names, in an empty folder."""
        self.microslip("init", "--example", pathlib.Path(name).stem, "case.toml")
        for written in pathlib.Path().rglob("*"):
            original = EXAMPLES / (name if written.name == "case.toml" else written)
            if written.is_file() and written.read_bytes() != original.read_bytes():
                raise Failed(f"init writes {written} otherwise than {original}")
        if any(line.startswith(SWEEPS) for line in pathlib.Path("case.toml").read_text().splitlines()):
            self.microslip("sweep", "case.toml", "-o", "results/sweep.h5")
        else:
            self.microslip("solve", "case.toml", "--no-pictures", "-o", "results")
        self.plot("results")

    def contact_input(self, name):
        """An input file of the program CONTACT."""
        shutil.copy(EXAMPLES / name, ".")
        self.microslip("run", pathlib.Path(name).name, "-o", "results")
        self.microslip("convert", pathlib.Path(name).name, "-o", "cases", codes=(0, 1))  # 1: some go on from others
        for case in sorted(pathlib.Path("cases").rglob("*.toml")):
            self.microslip("solve", case, "--no-pictures", "-o", pathlib.Path("results") / case.stem)
        self.plot("results")

    def table(self, name):
        """A table of contacts, by every theory."""
        for theory in ("fastsim2", "table", "exact"):
            self.microslip("batch", EXAMPLES / name, "--theory", theory, "-o", f"{theory}.csv")

    def profile(self, name):
        """A profile."""
        self.microslip("profile", EXAMPLES / name, "-o", "pictures")

    def measured_curve(self, name):
        """Measured creep curves, with the case of the same name; what is fitted is a case."""
        self.microslip("fit", EXAMPLES / name, "--case", (EXAMPLES / name).with_suffix(".toml"), "-o", "fitted")
        self.microslip("solve", "fitted/case.toml", "--no-pictures", "-o", "results")

    def python(self, name):
        """A script."""
        for package in ("numpy", "matplotlib", "microslip"):
            if subprocess.run([sys.executable, "-c", f"import {package}"], stderr=subprocess.DEVNULL, check=False).returncode != 0:
                raise NotThere(f"Python's {package} is not there")
        arguments = self.filled(ARGUMENTS.get(name, ()))
        for file in arguments:
            if file.startswith(str(self.build)) and not pathlib.Path(file).exists():
                raise NotThere(f"{file} is not built")
        self.run(sys.executable, EXAMPLES / name, *(arguments or (["."] if name in BEFORE else [])))

    def job(self, name):
        """A script of a cluster, here on one machine."""
        if not shutil.which("mpirun"):
            raise NotThere("mpirun is not installed")
        self.run("bash", EXAMPLES / name, EXAMPLES / "creep_sweep.toml", "out.h5",
                 environment={"PATH": f"{self.build}/bin{os.pathsep}{os.environ['PATH']}", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                              "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})  # in containers

    def built(self, name):
        """A program of the build."""
        program = self.build / "bin" / BUILT[matches(name, BUILT)].format(stem=pathlib.Path(name).stem)
        if not program.exists():
            if name.endswith(".f90") and not shutil.which("gfortran"):
                raise NotThere("there is no Fortran compiler")
            raise Failed(f"{program} is not there: nothing builds examples/{name}")
        self.run(program, *self.filled(ARGUMENTS.get(name, ())))

    def elsewhere(self, name):
        """What another test's script is to name."""
        script = ELSEWHERE[matches(name, ELSEWHERE)]
        if pathlib.Path(name).stem not in (ROOT / script).read_text():
            raise Failed(f"{script} does not run examples/{name}")

    def example(self, name):
        """Runs one example."""
        if name in BEFORE:
            self.run(*self.filled(BEFORE[name]))
        for pattern, method in KINDS.items():
            if fnmatch.fnmatch(name, pattern):
                return method(self, name)
        raise Failed(f"examples/{name}: no line in the table of kinds says how it is run")


KINDS = {
    **dict.fromkeys(ELSEWHERE, Runner.elsewhere),
    **dict.fromkeys(BUILT, Runner.built),
    "profiles/*": Runner.profile,
    "*.toml": Runner.case,
    "*.inp": Runner.contact_input,
    "creep_curve.csv": Runner.measured_curve,
    "*.csv": Runner.table,
    "*.py": Runner.python,
    "*.sbatch": Runner.job,
}


def main(arguments):
    if arguments == ["--list"]:
        print("\n".join(names()))
        return 0
    if len(arguments) != 2:
        sys.exit(__doc__)
    build, name = pathlib.Path(arguments[0]).resolve(), arguments[1]
    with tempfile.TemporaryDirectory(prefix="microslip_example_") as folder:
        os.chdir(folder)
        try:
            Runner(build).example(name)
        except NotThere as why:
            print(f"skipped: {why}")
            return NOT_THERE
        except Failed as why:
            print(why, file=sys.stderr)
            return 1
        finally:
            os.chdir(ROOT)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
