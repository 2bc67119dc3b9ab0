#!/usr/bin/env python3
"""Checks that everything that a source or header defines or declares is in the namespace of its folder. Of namespaces
around it there may be forward declarations of types alone."""
import pathlib
import re
import sys

from unique_types import bare, sources

# A folder, with the folders below it, and its namespace.
NAMESPACES = {
    "app": "microslip::app",
    "campaign": "microslip::campaign",
    "cases": "microslip::cases",
    "compat/contact": "microslip::contact_program",
    "compat/libcontact": "microslip::libcontact",
    "explorer/core": "microslip::explorer",
    "fmi": "microslip::fmi",
    "io": "microslip::io",
    "microslip": "microslip",
    "python/binding": "microslip::python",
    "validation": "microslip::validation",
}
# Files with functions that a standard or a library wants outside of namespaces.
OUTSIDE = ("explorer/core/exports.cpp", "fmi/fmi2.cpp", "fmi/fmi3.cpp", "python/binding/module.cpp")
SPECIALISED = "pybind11::detail"  # where a library wants its templates specialised

BODY = None  # a scope that is no namespace, or has C linkage: nothing in it is looked at
NAMESPACE = re.compile(r"(?:^|\s)namespace(?:\s+(?P<name>[\w:]+))?$")
FORWARD = re.compile(r"(?:template\s*<.*>\s*)?(?:struct|class|enum(?:\s+class)?)\s+\w+(?:\s*:\s*[\w:]+)?$|using\b|$")
MAIN = re.compile(r"\bw?main\s*\(")


def folder_namespace(file):
    """The namespace of a file's folder; None where the table has none, and for tests."""
    if "tests" in pathlib.PurePosixPath(file).parts or file in OUTSIDE:
        return None
    return next((name for folder, name in NAMESPACES.items() if file.startswith(folder + "/")), None)


def is_within(name, *others):
    """Returns whether a namespace is one of others or within one."""
    return any(name == other or name.startswith(other + "::") for other in others)


def misplaced(text, namespace):
    """(line, text) of what is not in `namespace`."""
    text, found, scopes, begin = bare(text), [], [], 0
    for end in re.finditer(r"[{};]", text):
        head, begin = " ".join(text[begin:end.start()].split()), end.end()
        if end[0] == "}":
            scopes.pop()
            continue
        opened = NAMESPACE.search(head) if end[0] == "{" else None
        is_forward = end[0] == ";" and FORWARD.match(head)
        if BODY not in scopes and not opened and not is_forward and not head.startswith("extern") and not MAIN.search(head):
            if not is_within("::".join(filter(None, scopes)), namespace, SPECIALISED):
                found.append((text.count("\n", 0, end.start()) + 1, head))
        if end[0] == "{":
            scopes.append(opened["name"] or "" if opened else BODY)
    return found


def check_itself():
    """What is elsewhere is found, and nothing else."""
    def heads(text):
        return [head for _, head in misplaced(text, "a::b")]

    assert not heads("namespace a { class F; } namespace a::b { struct S { int x; }; namespace { int f() { return 1; } } namespace c { int g(); } }")
    assert not heads('using namespace a::b; int main(int n, char** w) { return n; } extern "C" { int f() { return 1; } }')
    assert not heads("namespace pybind11::detail { template <> struct caster<int> { int x; }; }")
    assert heads("namespace a { struct S { int x; }; }") == ["struct S"]
    assert heads("namespace a { namespace c { int f(); } }") == ["int f()"]
    assert heads("int f() { return 1; }") == ["int f()"] and heads("namespace { int x = 1; }") == ["int x = 1"]
    assert heads("namespace a::bc { int f(); }") == ["int f()"]
    assert folder_namespace("io/case_file.cpp") == "microslip::io" and folder_namespace("microslip/version.hpp") == "microslip"
    assert folder_namespace("fmi/tests/fmu_test.cpp") is None and folder_namespace("bench/main.cpp") is None


def main():
    check_itself()
    root = pathlib.Path(sys.argv[1])
    wrong, count = [], 0
    for source in sources(root):
        file = source.relative_to(root).as_posix()
        if namespace := folder_namespace(file):
            count += 1
            wrong += [f"{file}:{line}: not in namespace {namespace}: {head[:80]}" for line, head in misplaced(source.read_text(), namespace)]
    print("\n".join(wrong) or f"{count} files, all in the namespaces of their folders")
    return 1 if wrong or not count else 0


if __name__ == "__main__":
    sys.exit(main())
