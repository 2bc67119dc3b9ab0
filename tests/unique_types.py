#!/usr/bin/env python3
"""Checks that no type has two definitions. A program with both takes one destructor for the two, without a word, and
crashes where that is not inlined. Types in anonymous namespaces and in functions are nobody else's."""
import pathlib
import re
import sys

ENDINGS = (".hpp", ".cpp", ".h", ".c")
LEFT_OUT = ("build", ".git")
COPIES = ("microslip_abi_2.h",)  # of a header as it was, for programs that were built with that

# What a definition of a type ends with before its brace; its name may be qualified, and have template arguments.
TYPE = re.compile(r"(?:^|\s)(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?:alignas\s*\([^()]*\)\s*)?"
                  r"(?P<name>[A-Za-z_]\w*(?:\s*<.*>)?(?:\s*::\s*[A-Za-z_]\w*(?:\s*<.*>)?)*?)\s*(?:final\s*)?(?:(?<!:):(?!:).*)?$", re.DOTALL)
NAMESPACE = re.compile(r"(?:^|\s)namespace(?:\s+(?P<name>[\w:\s]+))?$")
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(?P<end>[^("]*)\(.*?\)(?P=end)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'|^[ \t]*#(?:\\\n|[^\n])*',
                   re.DOTALL | re.MULTILINE)
HIDDEN = None  # the name of a scope whose types are nobody else's: a function, an anonymous namespace


def bare(text):
    """A source without comments, texts and instructions to the preprocessor; lines stay where they are."""
    return TOKEN.sub(lambda match: "\n" * match[0].count("\n") or " ", text)


def without_templates(head):
    """What stands before a brace without `template <...>`."""
    while (begin := re.search(r"\btemplate\s*<", head)) is not None:
        end, depth = begin.end(), 1
        while depth and end < len(head):
            depth += {"<": 1, ">": -1}.get(head[end], 0)
            end += 1
        head = head[:begin.start()] + " " + head[end:]
    return head


def scope(head):
    """(name, is a type) of the scope whose brace follows `head`: "" where names stay as they are."""
    head = " ".join(re.sub(r"\b(?:public|private|protected)\s*:(?!:)|\[\[.*?\]\]", " ", without_templates(head)).split())
    if namespace := NAMESPACE.search(head):
        return (namespace["name"] or "").strip() or HIDDEN, False
    if head == "extern":  # "C"
        return "", False
    found = TYPE.search(head)
    return (found["name"].replace(" ", ""), True) if found else (HIDDEN, False)


def types(text):
    """(qualified name, line) of the types that a source defines for others."""
    text, found, scopes, begin = bare(text), [], [], 0
    for brace in re.finditer(r"[{};]", text):
        head, begin = text[begin:brace.start()], brace.end()
        if brace[0] == "{":
            name, is_type = scope(head)
            scopes.append(name)
            if is_type and HIDDEN not in scopes:
                found.append(("::".join(filter(None, scopes)), text.count("\n", 0, brace.start()) + 1))
        elif brace[0] == "}" and scopes:
            scopes.pop()
    return found


def sources(root):
    """All sources below a folder, without what is built there."""
    for folder in sorted(root.iterdir()):
        if folder.is_dir() and folder.name not in LEFT_OUT:
            yield from sorted(file for file in folder.rglob("*") if file.suffix in ENDINGS and file.name not in COPIES)


def definitions(root):
    """Qualified name -> {file: line} of its definitions."""
    found = {}
    for file in sources(root):
        path = file.relative_to(root).as_posix()
        for name, line in types(file.read_text()):
            found.setdefault(name, []).append((path, line))
    return found


def complaints(found):
    """What is wrong, one line each."""
    return [f"{name}: defined in {' and '.join(f'{file}:{line}' for file, line in places)}"
            for name, places in sorted(found.items()) if len(places) > 1]


def check_itself():
    """Types are found, others' and hidden ones told apart."""
    def names(text):
        return [name for name, _ in types(text)]

    assert names("namespace a { struct S { int x{}; enum class E : char { e }; }; class D final : public B<S> {}; }") == ["a::S", "a::S::E", "a::D"]
    assert names("namespace a::b { template <class T> struct S { T t; }; template <> struct S<int> {}; }") == ["a::b::S", "a::b::S<int>"]
    assert names("struct A::B { }; union U { };") == ["A::B", "U"]
    assert names('extern "C" { struct S { double x; }; }') == ["S"]
    assert not names("namespace a { namespace { struct S { struct T {}; }; } } void f() { struct L {}; }")
    assert not names("struct S; struct S* f(struct S s) { return {}; } template <class T> void g(T t) { h(t); } enum E : int;")
    assert not names("// struct S {\n/* struct S {} */ const char* t = \"struct S {\", c = '{', *r = R\"x(struct S {)x\";\n#define M struct S {")
    assert types("\n/*\n*/\nstruct S\n{ };") == [("S", 5)]
    assert complaints({"S": [("a.hpp", 1), ("b.hpp", 2)]}) and not complaints({"S": [("a.hpp", 1)]})


def main():
    check_itself()
    found = definitions(pathlib.Path(sys.argv[1]))
    wrong = complaints(found)
    print("\n".join(wrong) or f"{len(found)} types, each with one definition")
    return 1 if wrong or not found else 0


if __name__ == "__main__":
    sys.exit(main())
