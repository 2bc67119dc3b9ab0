"""Prints the types of the compiled module, the stub microslip/_core.pyi, from the module's signatures.

PYTHONPATH=build/release/share/microslip/python python3 python/binding/make_stub.py > python/microslip/_core.pyi
"""

import enum
import json
import re
import sys

import microslip

HEADER = '''"""Types of the compiled part of microslip; written by python/binding/make_stub.py, which also says what has which type."""

import enum
import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from typing import Any, Literal, overload

import numpy
from numpy.typing import ArrayLike, NDArray

'''

# Arguments that take words, and those that take more than their C++ type says.
TYPES_OF_ARGUMENTS = {key: f"Literal[{', '.join(map(json.dumps, words))}]" for kind in ("bodies", "wheel", "conicity")
                      for key, words in ((one["key"], one["words"]) for one in microslip.inputs(kind)) if words} | {
    "side": 'Literal["left", "right"]',
    "TangentialProblem.kind": 'Literal["steady", "transient", "shift"]',
    "precision": 'Literal["double", "single"]',
    "measure": 'Literal["von_mises", "tresca", "hydrostatic"]',
    "kind": 'Literal["rail", "wheel"]',
    "body": "Literal[1, 2]",
    "of": "tuple[float, float]",
    "ViscoelasticMaterial.shear_relaxation": "list[PronyTerm | tuple[float, float]]",
    "ViscoelasticMaterial.bulk_relaxation": "list[PronyTerm | tuple[float, float]] | None",
    "BodyLayer.material": "Material | ViscoelasticMaterial",
    "LayeredBody.substrate": "Material | ViscoelasticMaterial",
    "friction": "FrictionLaw | float",
    "FrictionLaw.coefficients": "ArrayLike",
    "WheelRail.friction": "FrictionLaw | float | tuple[ArrayLike, ArrayLike]",
    "WheelsetOnTrack.friction": "FrictionLaw | float | tuple[ArrayLike, ArrayLike]",
    "creepage": "Creepage | tuple[float, float, float]",
    "path": "str | os.PathLike[str]",
    "output": "str | os.PathLike[str]",
    "measured": "str | os.PathLike[str]",
    "case_file": "str | os.PathLike[str]",
    "executor": "Executor",
}
# Properties whose arrays hold codes or counts, and those that have another type than their C++ one says.
TYPES_OF_PROPERTIES = {
    "results": "tuple[str, ...]",
    "FrictionLaw.slip_velocities": "list[float] | None",
    "FrictionLaw.coefficients": "list[float] | None",
    "FrictionLaw.pressures": "list[float] | None",
    "FrictionLaw.temperatures": "list[float] | None",
    "variables": "tuple[str, ...]",
    "state": "NDArray[numpy.uint8]",
    "ForceArrays.inputs": "dict[str, Any]",
    "WheelRailArrays.inputs": "dict[str, Any]",
    "ForceArrays.status": "NDArray[numpy.uint8]",
    "WheelRailArrays.status": "NDArray[numpy.uint8]",
    "WheelsetContacts.status": "NDArray[numpy.uint8]",
    "ForceArrays.warning_code": "NDArray[numpy.uint32]",
    "WheelRailArrays.warning_code": "NDArray[numpy.uint32]",
    "SolutionArrays.newton_steps": "NDArray[numpy.int32]",
}
RESULTS = {"pressure": "Any", "coefficient": "Any", "traction_bound": "Any", "angle": "Any", "curvature": "Any", "derivative": "Any",
           "at": "Any", "equivalent_conicity": "Any", "wavelength": "Any", "nonlinearity_parameter": "Any",
           "radial_steering_index": "Any",
           "point": "tuple[Any, Any]",  # a number for numbers, else an array
           "to_dict": "dict[str, Any]",
           "fit_creep_curve": "dict[str, Any]",
           "to_dataframe": "Any", "to_xarray": "Any"}  # a pandas.DataFrame, an xarray.Dataset


# Classes whose methods take a state, and the kind of case that has it.
OWNERS_OF_STATES = {"WheelRail": "wheel", "WheelsetOnTrack": "wheelset"}

# Classes made from keywords, whose methods take them, and the class whose text lists these.
OWNERS_OF_KEYWORDS = {"RollingProblem": "RollingProblem", "Method": "Method", "Solver": "Method", "Fastsim": "Method", "Fastsim2": "Method"}
OF_FASTSIM = ("bound", "flexibility", "coefficients", "slope_reduction")
# Those that are no keys of case files; the first two a problem must have.
NEEDED = ("bodies", "friction")
TYPES_OF_OBJECTS = {
    "bodies": "Bodies | CombinedMaterial | LayeredBodies",
    "friction": "FrictionLaw | float",
    "gap": "GapCurvatures | ArrayLike | None",
    "grid": "ElementGrid | None",
    "temperature_effect": "TemperatureEffect | None",
    "thermal": "tuple[ThermalBody, ThermalBody] | None",
    "slope_reduction": "tuple[float, float, float] | None",
    "table": "CreepForceTable | None",
}
# What properties have where keywords take more.
TYPES_OF_VALUES = {
    ("RollingProblem", "bodies"): "Bodies | LayeredBodies",
    ("RollingProblem", "friction"): "FrictionLaw",
    ("RollingProblem", "gap"): "GapCurvatures | NDArray[numpy.float64] | None",
    ("Method", "grid"): "int | tuple[int, int]",
}
# Those for which the best value is found where they are left out.
BY_PROBLEM = ("discretisation", "elements", "coupling", "slip_start", "bound", "flexibility")
ALWAYS_THERE = ("memory_distance", "memory_speed", "kind", "direction", "theory", "tolerance", "coefficients")


def python_type(text):
    """A type as pybind11 writes it, as Python does."""
    text = re.sub(r"numpy\.ndarray(\[numpy\.float64\])?", "NDArray[numpy.float64]", text)
    text = re.sub(r"List\[float\[3\]\]", "tuple[float, float, float]", text)
    for old, new in (("Tuple[", "tuple["), ("List[", "list["), ("Dict[", "dict["), ("microslip.", ""),
                     ("dict", "dict[str, str]")):
        text = text.replace(old, new)
    return re.sub(r"Optional\[(.*)\]", r"\1 | None", text)


def split(arguments):
    """The arguments of a signature; commas within brackets do not count."""
    parts, depth = [""], 0
    for letter in arguments:
        depth += (letter in "[(<") - (letter in "])>")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def argument(text, owner):
    """An argument with its type."""
    name, _, rest = text.partition(":")
    if not rest or name == "self":
        return name
    kind, _, default = (part.strip() for part in rest.partition(" = "))
    kind = python_type(kind)
    if kind == "str" or name == "body" or (kind == "object" and default != "None" and (owner, name) != ("TangentialProblem", "bound")):
        kind = TYPES_OF_ARGUMENTS.get(f"{owner}.{name}", TYPES_OF_ARGUMENTS.get(name, kind))
    if name == "executor":
        kind = TYPES_OF_ARGUMENTS[name]
    if kind == "str | None":
        kind = TYPES_OF_ARGUMENTS.get(name, "str") + " | None"
    if kind == "object":
        kind = "ArrayLike"
    if kind == "RollingProblem":
        kind += " | EllipticContact"  # which makes one
    if default == "None" and "None" not in kind:
        kind += " | None"
    if default.startswith("Creepage(") or default == "inf":
        default = "..."
    if kind.startswith("tuple"):
        default = default.replace("[", "(").replace("]", ")")
    return f"{name}: {kind}" + (f" = {default}" if default else "")


def keywords(owner, name):
    """Keywords of the methods that take a state, instead of **kwargs: numbers, or arrays of many states."""
    kind = "ArrayLike" if name.endswith("_batch") else "float"
    wanted = ["*"]
    if owner == "WheelsetOnTrack":  # in place of a load
        wanted += [f"{key}: float = ..." for key in ("vertical", "roll")]
    for given in microslip.inputs(OWNERS_OF_STATES[owner]):
        if given["state"]:
            is_needed = given["needed"] and given["key"] == "forward_velocity"
            default = "" if is_needed else " = ..." if given["default"] is None else f" = {given['default']}"
            wanted.append(f"{given['key']}: {kind}" + default)
    return wanted


def described_keywords(owner):
    """The keywords of a class made from them, with their types and defaults, in the order of its text."""
    inputs = {(one["section"], one["key"]): one for one in microslip.inputs("bodies")}
    text = getattr(microslip, owner).__init__.__doc__
    for name in re.findall(r"^    (\w+) \[[^\]]*\]: ", text, re.MULTILINE):
        sections = ("ellipse", "load", "friction", "motion") if owner == "RollingProblem" else ("solution",)
        described = next((inputs[section, name] for section in sections if (section, name) in inputs), None)
        if described is None or name == "table":  # the file of one in case files
            yield name, TYPES_OF_OBJECTS[name], "..."
            continue
        if described["words"]:
            kind = f"Literal[{', '.join(map(json.dumps, described['words']))}]"
        else:
            kind = {"grid": "int | tuple[int, int]", "steps": "int"}.get(name, "float")
        has_default = described["default"] is not None and name not in BY_PROBLEM
        yield name, f"{kind} | None", repr(described["default"]) if has_default else "..."


def keywords_of(owner, is_partial):
    """Keywords that a method takes instead of **kwargs; none is required if another problem has it."""
    for key, kind, default in described_keywords(OWNERS_OF_KEYWORDS[owner]):
        if not owner.startswith("Fastsim") or key in OF_FASTSIM:
            yield f"{key}: {kind}" + ("" if key in NEEDED and not is_partial else f" = {'...' if is_partial else default}")


def signatures(function):
    """The signatures of a function or method, from the first line or the numbered lines of its docstring."""
    lines = function.__doc__.splitlines()
    if len(lines) > 1 and lines[1].startswith("Overloaded"):
        lines = [line[3:] for line in lines if re.match(r"\d\. ", line)]
    else:
        lines = lines[:1]
    return [re.fullmatch(r"(\w+)\((.*)\) -> (.*)", line).groups() for line in lines]


def texts(function):
    """The texts of a function or method without its signatures, one for each overload."""
    lines = function.__doc__.splitlines()
    if len(lines) > 1 and lines[1].startswith("Overloaded"):
        parts = re.split(r"^\d\. .*$", "\n".join(lines), flags=re.MULTILINE)[1:]
    else:
        parts = ["\n".join(lines[1:])]
    return [part.strip() for part in parts]


def documented(head, text, indent):
    """A definition whose body is its text."""
    inner = indent + "    "
    return [f"{head}:", f'{inner}"""' + text.replace("\n", f"\n{inner}") + '"""'] if text else [f"{head}: ..."]


def function_lines(name, function, owner="", indent="", decorator=""):
    """A function or a method; each overload on a separate line."""
    found = signatures(function)
    for (_, arguments, result), text in zip(found, texts(function)):
        if len(found) > 1:
            yield f"{indent}@overload"
        if decorator:
            yield f"{indent}@{decorator}"
        result = RESULTS.get(name, python_type(result))
        parts = [argument(part, owner) for part in split(arguments)]
        if "**kwargs" in parts and owner in OWNERS_OF_STATES:
            at = parts.index("**kwargs")
            words = keywords(owner, name)
            parts[at:] = words[1:] if "*" in parts else words
        if "**kwargs" in parts and owner in OWNERS_OF_KEYWORDS:
            is_partial = name == "replace" or "contact" in arguments
            parts[-1:] = [*(["*"] if "*" not in parts else []), *keywords_of(owner, is_partial)]
        if name == "__init__":
            result = "None"
        yield from documented(f"{indent}def {name}({', '.join(parts)}) -> {result}", text, indent)


def property_type(owner, name, member):
    """The type of a property, from its getter's signature; that of a keyword, where it is one."""
    if OWNERS_OF_KEYWORDS.get(owner) == owner:
        kind = next(kind for key, kind, _ in described_keywords(owner) if key == name)
        return TYPES_OF_VALUES.get((owner, name), kind.removesuffix(" | None") if name in ALWAYS_THERE else kind)
    for key in (f"{owner}.{name}", name):
        if key in TYPES_OF_PROPERTIES and not (key == "status"):
            return TYPES_OF_PROPERTIES[key]
    return python_type(member.fget.__doc__.splitlines()[0].split("->")[1].strip())


SPECIAL_METHODS = {
    "__iter__": {"Creepage": "Iterator[float]", "ContactRun": "ContactRun"},
    "__next__": {"ContactRun": "ContactCase"},
    "__len__": {"ForceArrays": "int", "WheelRailArrays": "int", "WheelsetContacts": "int"},
}


def class_lines(name, cls):
    """A class with its methods and properties in the order of their definition."""
    if issubclass(cls, Exception):
        return documented(f"class {name}(ValueError)", cls.__doc__, "")
    if issubclass(cls, enum.IntEnum):
        return [*documented(f"class {name}(enum.IntEnum)", cls.__doc__, ""), *(f"    {member.name} = {member.value}" for member in cls)]
    base = cls.__mro__[1].__name__
    lines = documented(f"class {name}({base})" if base in vars(microslip) else f"class {name}", cls.__doc__, "")
    for key, member in vars(cls).items():
        if isinstance(member, property):
            kind = property_type(name, key, member)
            lines += ["    @property", *documented(f"    def {key}(self) -> {kind}", member.__doc__, "    ")]
            if member.fset:
                value = TYPES_OF_ARGUMENTS.get(key, kind)
                lines += [f"    @{key}.setter", f"    def {key}(self, value: {value}) -> None: ..."]
        elif key in SPECIAL_METHODS:
            lines.append(f"    def {key}(self) -> {SPECIAL_METHODS[key][name]}: ...")
        elif isinstance(member, staticmethod):
            lines += function_lines(key, member.__func__, name, "    ", "staticmethod")
        elif not key.startswith("_") or (key == "__init__" and member.__doc__.startswith("__init__(")):
            lines += function_lines(key, member, name, "    ")
    return lines


def stub():
    """The whole stub."""
    parts = []
    for name in sorted(dir(microslip), key=lambda key: (not isinstance(getattr(microslip, key), type), key)):
        member = getattr(microslip, name)
        if getattr(member, "__module__", None) != "microslip":
            continue
        lines = class_lines(name, member) if isinstance(member, type) else function_lines(name, member)
        parts.append("\n".join(lines))
    return HEADER + "\n\n".join(parts) + "\n"


if __name__ == "__main__":
    sys.stdout.write(stub())
