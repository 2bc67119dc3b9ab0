"""Reference of the Python module: every public name with its types, from the stub, and its text, from the module."""

import ast
import inspect
import re
from pathlib import Path

from headers import escaped

STUB = Path(__file__).resolve().parents[2] / "python" / "microslip" / "_core.pyi"


def text_of(member):
    """A docstring without the signatures that pybind11 puts before it."""
    text = re.sub(r"^\w+\(.*\) -> .*$|^Overloaded function\.$|^\d+\. \w+\(.*$", "", member.__doc__ or "", flags=re.MULTILINE)
    return escaped(text.strip())


def first_sentence(text):
    """For tables."""
    return re.split(r"(?<=[.:;])\s", " ".join(text.split()))[0].rstrip(":;")


def signature(node, name, drop_self=True):
    """A function as it is called."""
    arguments = ast.unparse(node.args)
    if drop_self:
        arguments = re.sub(r"^self(, )?", "", arguments)
    returns = f" -> {ast.unparse(node.returns)}" if node.returns and name != "__init__" else ""
    return f"({arguments}){returns}"


def decorated(node, name):
    """Returns whether a method has a decorator."""
    return any(ast.unparse(one) == name for one in node.decorator_list)


def class_section(node, cls):
    """A class: how it is made, its fields as a table, its methods."""
    methods = [part for part in node.body if isinstance(part, ast.FunctionDef)]
    makers = [signature(part, "__init__") for part in methods if part.name == "__init__"]
    parts = [f"### {node.name}", text_of(cls)]
    if makers:
        parts.append("```python\n" + "\n".join(node.name + maker for maker in makers) + "\n```")
        parts.append(text_of(cls.__init__))
    values = [ast.unparse(part) for part in node.body if isinstance(part, ast.Assign)]
    if values:
        parts.append("```python\n" + "\n".join(values) + "\n```")
    fields = [part for part in methods if decorated(part, "property")]
    if fields:
        rows = [f"| `{part.name}` | `{ast.unparse(part.returns)}` | {' '.join(text_of(getattr(cls, part.name)).split())} |".replace(" | None`", " or None`")
                for part in fields]
        parts.append("\n".join(["| field | type | |", "|---|---|---|", *rows]))
    shown = set()
    for part in methods:
        if part.name.startswith("__") or part in fields or part.name in shown or any(ast.unparse(one).endswith(".setter") for one in part.decorator_list):
            continue
        shown.add(part.name)
        same = [signature(one, one.name) for one in methods if one.name == part.name]
        parts += [f"#### {node.name}.{part.name}", "```python\n" + "\n".join(part.name + one for one in same) + "\n```",
                  text_of(getattr(cls, part.name))]
    return "\n\n".join(part for part in parts if part)


def function_section(nodes, function):
    """A function with all its signatures."""
    calls = "\n".join(node.name + signature(node, node.name, drop_self=False) for node in nodes)
    return f"### {nodes[0].name}\n\n```python\n{calls}\n```\n\n{text_of(function)}"


def plain_section(module):
    """The functions of a module in plain Python."""
    parts = [f"## {module.__name__}", escaped(module.__doc__.strip())]
    for name, function in inspect.getmembers(module, inspect.isfunction):
        if function.__module__ == module.__name__:
            parts += [f"### {module.__name__}.{name}", f"```python\n{name}{inspect.signature(function)}\n```", escaped(inspect.getdoc(function))]
    return "\n\n".join(parts)


def reference(module, *plain_modules):
    """The whole reference: a table of all names, functions, classes; then modules in plain Python."""
    nodes = {}
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            nodes.setdefault(node.name, []).append(node)
    functions = {name: found for name, found in nodes.items() if isinstance(found[0], ast.FunctionDef)}
    rows = [f"| [`{name}`](#{name.lower()}) | {first_sentence(text_of(getattr(module, name)))} |" for name in sorted(nodes)]
    parts = ["\n".join(["| name | |", "|---|---|", *rows]), "## Functions"]
    parts += [function_section(found, getattr(module, name)) for name, found in sorted(functions.items())]
    parts.append("## Classes")
    parts += [class_section(found[0], getattr(module, name)) for name, found in sorted(nodes.items()) if name not in functions]
    parts += [plain_section(one) for one in plain_modules]
    return "\n\n".join(parts)
