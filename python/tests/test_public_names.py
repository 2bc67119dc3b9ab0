"""Every public name is imported and says what it is, with shapes and units; the stub says the same as the module."""

import ast
import enum
import importlib.util
import re
import unittest
from pathlib import Path

import microslip
from tests.compiled import load_tests_if_compiled

PACKAGE = Path(microslip.__file__).resolve().parent
UNIT = re.compile(r"\[(-|1/m|m/s|mm/s|s|rad|rad/s|mm|mm\^2|m|m\^2|N|N m|N mm|N/m|N/m\^2|N/mm\^2|Pa|Pa/m|1/Pa|m/Pa|J|W|K|deg C|kg/m|kg/m\^3|W/\(m K\)|J/\(kg K\))\]")
SHAPE = re.compile(r"[Ss]hape \((\.\.\.|[a-z\d]+)(, [a-z\d]+)*\)")


def members():
    """All public names with what they stand for."""
    return {name: getattr(microslip, name) for name in dir(microslip)
            if getattr(getattr(microslip, name), "__module__", None) == "microslip"}


def stub():
    """The stub's classes and functions by name."""
    return {node.name: node for node in ast.parse((PACKAGE / "_core.pyi").read_text()).body
            if isinstance(node, (ast.ClassDef, ast.FunctionDef))}


class PublicNamesTest(unittest.TestCase):
    def test_there_are_many(self):
        for name in ("Fastsim", "Fastsim2", "RollingProblem", "Method", "Solver", "InteriorField",
                     "hertz_from_load", "read_case", "solve_case", "run_contact_input", "Error", "Status"):
            self.assertIn(name, members())
        self.assertGreater(len(members()), 50)

    def test_every_function_has_a_text_with_units(self):
        for name, member in members().items():
            if not isinstance(member, type):
                text = re.sub(r"^\w+\(.*\) -> .*\n", "", member.__doc__)
                self.assertRegex(text, UNIT, name)

    def test_every_class_and_method_has_a_text(self):
        for name, cls in members().items():
            if not isinstance(cls, type):
                continue
            self.assertGreater(len(cls.__doc__ or ""), 20, name)
            for key, member in vars(cls).items():
                if not key.startswith("_") and not isinstance(cls, enum.EnumMeta):
                    self.assertTrue(member.__doc__, f"{name}.{key}")

    def test_texts_name_the_types_of_python(self):
        for name, member in members().items():
            for key, part in [("", member), *(vars(member).items() if isinstance(member, type) else ())]:
                self.assertNotIn("::", getattr(part, "__doc__", None) or "", f"{name}.{key}")

    def test_numbers_have_units_and_arrays_shapes(self):
        checked = 0
        for name, node in stub().items():
            if not isinstance(node, ast.ClassDef) or issubclass(members()[name], (Exception, enum.Enum)):
                continue
            for method in (part for part in node.body if isinstance(part, ast.FunctionDef)):
                returns = ast.unparse(method.returns) if method.returns else ""
                if any(ast.unparse(one) == "property" for one in method.decorator_list):
                    text = getattr(members()[name], method.name).__doc__
                    if returns in ("float", "int") or returns.startswith("NDArray"):
                        self.assertRegex(text, UNIT, f"{name}.{method.name}")
                        checked += 1
                    if returns.startswith("NDArray"):
                        self.assertRegex(text, SHAPE, f"{name}.{method.name}")
                elif len(method.args.args) > 1 and not method.name.startswith("__") and method.name != "solve_batch":
                    self.assertRegex(getattr(members()[name], method.name).__doc__, r"\[|The same", f"{name}.{method.name}")
        self.assertGreater(checked, 100)

    def test_the_stub_is_that_of_the_module(self):
        maker = Path(__file__).resolve().parents[1] / "binding" / "make_stub.py"
        spec = importlib.util.spec_from_file_location("make_stub", maker)
        made = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(made)
        self.assertEqual((PACKAGE / "_core.pyi").read_text(), made.stub(), "run python/binding/make_stub.py anew")

    def test_the_stub_names_every_name(self):
        self.assertEqual(sorted(stub()), sorted(members()))
        for name, node in stub().items():
            if isinstance(node, ast.ClassDef):
                for method in node.body:
                    if isinstance(method, ast.FunctionDef):
                        self.assertTrue(hasattr(members()[name], method.name), f"{name}.{method.name}")

    def test_every_name_of_the_stub_has_a_text(self):
        for name, node in stub().items():
            self.assertTrue(ast.get_docstring(node), name)
            for method in node.body:
                if isinstance(method, ast.FunctionDef) and not method.name.startswith("__"):
                    is_setter = any(ast.unparse(one).endswith(".setter") for one in method.decorator_list)
                    self.assertTrue(is_setter or ast.get_docstring(method), f"{name}.{method.name}")

    def test_the_package_is_typed(self):
        self.assertTrue((PACKAGE / "py.typed").exists())

    def test_unknown_names_are_attribute_errors(self):
        with self.assertRaisesRegex(AttributeError, "'Fastsim3'"):
            microslip.Fastsim3

    def test_the_build_is_known(self):
        self.assertEqual(sorted(microslip.build_info()), ["build_type", "commit", "compiler", "version"])
        self.assertEqual(microslip.__version__, microslip.build_info()["version"])


load_tests = load_tests_if_compiled([PublicNamesTest])
