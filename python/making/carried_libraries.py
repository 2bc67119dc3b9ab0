"""Makes binaries carry the libraries that they need beyond those that every Linux has."""

import hashlib
import re
import shutil
import subprocess
from pathlib import Path

# PEP 600: what a manylinux wheel may expect of the system.
OF_THE_SYSTEM = re.compile(r"(ld-linux.*|linux-vdso|lib(c|m|dl|rt|pthread|resolv|stdc\+\+|gcc_s))\.so")


def _output(*command):
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout


def _needed(file):
    """Names of the libraries that a file asks for itself."""
    return [name for name in _output("patchelf", "--print-needed", file).split() if not OF_THE_SYSTEM.match(name)]


def _found(file):
    """Paths at which the loader finds each library of a file, and those that these need."""
    return dict(re.findall(r"(\S+) => (/\S+)", _output("ldd", file)))


def _carried_name(library):
    """A name that no other library has: with another copy in the process, each caller gets the right one."""
    stem, dot, rest = library.name.partition(".so")
    return f"{stem}-{hashlib.sha256(library.read_bytes()).hexdigest()[:8]}{dot}{rest}"


def carry_libraries(binaries, folder):
    """Copies the libraries into the folder, under unique names, and lets binaries and copies look for them there."""
    if not shutil.which("patchelf"):
        raise FileNotFoundError("a wheel carries its libraries, which needs patchelf: install it (tools/setup)")
    folder.mkdir(exist_ok=True)
    paths = {name: Path(path) for binary in binaries for name, path in _found(binary).items()
             if not OF_THE_SYSTEM.match(name)}
    names = {name: _carried_name(path) for name, path in paths.items()}
    copies = []
    for name, path in paths.items():
        copies.append(folder / names[name])
        shutil.copy(path, copies[-1])
        copies[-1].chmod(0o755)
        subprocess.run(["patchelf", "--set-soname", names[name], copies[-1]], check=True)
    for file in [*binaries, *copies]:
        renamed = [part for name in _needed(file) for part in ("--replace-needed", name, names[name])]
        up = Path(*[".."] * len(file.relative_to(folder.parent).parts[:-1]))
        # One after the other: patchelf 0.14 loses new names when it sets the path in the same call.
        for changes in (renamed, ["--set-rpath", f"$ORIGIN/{up / folder.name}"]):
            if changes:
                subprocess.run(["patchelf", *changes, file], check=True)
