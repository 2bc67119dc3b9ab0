"""Reference pages from the headers: every public declaration of a header with the comment above it.

The headers are laid out by clang-format, so their declarations can be told apart by lines: a declaration ends where its braces are closed
and a line at the margin ends with `;` or `}`. Comments are `///` in C++ and `/* ... */` in C.
"""

import re

SKIPPED = re.compile(r"^(#|//(?!/)|namespace [\w:]+ \{$|\} // namespace|extern \"C\" \{|\}$|using namespace )")
BODY = re.compile(r"(?<=[\w)]) \{")  # not that of a default, = {}
FORWARD = re.compile(r"(class|struct) \w+;$")
NAME = re.compile(r"(?:class|struct|enum(?: class)?|union|concept)\s+(\w+)|using\s+(\w+)\s*=|\b(operator\S+?|~?\w+)\s*\(|(\w+)\s*(?:\{.*\}|=.*)?;")


def uncommented(comment):
    """The prose of a comment."""
    lines = []
    for line in comment:
        line = re.sub(r"^\s*(///?|/\*|\*/|\*(?= |$))", "", line)
        lines.append(re.sub(r"\s*\*/\s*$", "", line).strip())
    return "\n".join(lines).strip()


def depth_change(line):
    """Braces that a line of code opens less those that it closes; those in comments do not count."""
    code = re.sub(r"//.*|/\*.*?\*/", "", line)
    return code.count("{") - code.count("}")


def public_part(code):
    """A class without its private part."""
    kept, private = [], False
    for line in code:
        if re.match(r"(private|public|protected):$", line):
            private = line == "private:"
            if line == "public:" and kept and not any(re.match(r"\S", one) for one in kept[1:]):
                kept.append(line)
            continue
        if not private or line.startswith("}"):
            kept.append(line)
    while len(kept) > 2 and not kept[-2].strip():
        del kept[-2]
    return kept


def declared(code):
    """A function without its body; other declarations as they are."""
    first = " ".join(code)
    if not BODY.search(first) or re.match(r"(template <.*?> )?(class|struct|enum|union|typedef|inline constexpr|constexpr \w+ \w+ ?[{=])", first):
        return public_part(code)
    head = []
    for line in code:
        head.append(BODY.split(line)[0])
        if BODY.search(line):
            break
    return head[:-1] + [head[-1] + ";"]


def name_of(code):
    """Name of a declaration."""
    text = re.sub(r"^template <[^{;]*?>\s+(?=class|struct|using|\w)", "", " ".join(line.strip() for line in code))
    text = re.sub(r"//.*?$|\bMICROSLIP_API\b", "", text)
    typedef = re.match(r"typedef (?:struct|enum) (\w+)|typedef .*?\(\*(\w+)\)", text)
    if typedef:
        return typedef[1] or typedef[2]
    found = NAME.search(text)
    return next(group for group in found.groups() if group) if found else ""


def declarations(text):
    """All declarations of a header at namespace level, as (name, prose, code); comments that stand alone have no name."""
    found, comment, code, depth, in_comment = [], [], [], 0, False
    for line in re.sub(r"\\\n", " ", text).splitlines():  # macros go on after a backslash
        opens = not code and (line.startswith("///") or line.startswith("/*"))
        if opens or in_comment:
            comment.append(line)
            in_comment = (opens and line.startswith("/*") or in_comment) and "*/" not in line
        elif not code and not line.strip():
            if comment:
                found.append(("", uncommented(comment), []))
            comment = []
        elif not code and SKIPPED.match(line):
            comment = [] if line.startswith("#") else comment
        else:
            code.append(line)
            depth += depth_change(line)
            if depth == 0 and re.search(r"[;}]\s*(//.*|/\*.*\*/)?$", line):
                if not FORWARD.match(line):
                    found.append((name_of(code), uncommented(comment), declared(code)))
                comment, code = [], []
    if code:
        raise ValueError(f"a declaration does not end: {code[0]}")
    return found


def fenced(language, code):
    """A block of code."""
    return "```" + language + "\n" + "\n".join(code) + "\n```"


def escaped(prose):
    """Prose as Markdown: characters that Markdown would interpret are escaped."""
    return re.sub(r"([*_<>\[\]$\\#|])", r"\\\1", re.sub(r"`[^`]*`", lambda code: code[0].replace("_", "\0"), prose)).replace("\0", "_")


def reference(header, name, language):
    """The section of a header: a heading, then declarations, those that belong together under one heading."""
    parts, last = [f"## {name}"], None
    for declared_name, prose, code in declarations(header):
        if not code:
            if not re.fullmatch(r"[-\s\w]*----[-\s]*", prose):
                parts.append(escaped(prose))
            continue
        if declared_name != last:
            parts.append(f"### {declared_name}")
        last = declared_name
        parts += [escaped(prose)] if prose else []
        parts.append(fenced(language, code))
    return "\n\n".join(parts)
