"""The check of the description finds what it is for: each change of the good description breaks a rule."""

import os
import unittest
import zipfile

import check_fmu

CHANGES = [
    ('fmiVersion="2.0"', 'fmiVersion="1.0"', "no description of FMI 2.0"),
    (' guid="', ' gid="', "lacks the attribute guid"),
    (' guid="', ' gid="', "unknown attribute gid"),
    ('name="spin" valueReference="2"', 'name="spin" valueReference="1"', "shares its value reference"),
    ('name="spin"', 'name="fx"', "used twice"),
    ('<Real unit="1" start="0"/>', '<Real unit="1"/>', "needs a start value"),
    ('<Real unit="N.m"/>', '<Real unit="N.m" start="0"/>', "must not have a start value"),
    ('<Real unit="N.m"/>', '<Real unit="Nm"/>', "undefined unit"),
    ('<Real unit="N.m"/>', "<Integer/>", "continuous, but not real"),
    ('causality="parameter" variability="fixed"', 'causality="parameter" variability="continuous"', "do not go together"),
    ('start="0.28"', 'start="0.6"', "starts outside its range"),
    ('<Unknown index="18" dependencies="1 2 3 4 5"/>', "", "must list all outputs"),
    ('<Unknown index="6" dependencies="1 2 3 4 5"/>', '<Unknown index="6" dependencies="11"/>', "is no input"),
    ('<Unknown index="6" dependencies="1 2 3 4 5"/>', '<Unknown index="6" dependencies="99"/>', "no variable 99"),
    ('<Unknown index="6" dependencies="1 2 3 4 5"/>', '<Unknown index="9"/>', "ascending"),
    ("CoSimulation", "ModelExchange", "CoSimulation is missing"),
    ("UnitDefinitions", "TypeDefinitions", "undefined unit"),
]

CHANGES3 = [
    (' instantiationToken="', ' guid="', "lacks the attribute instantiationToken"),
    (' instantiationToken="', ' guid="', "unknown attribute guid"),
    ("canGetAndSetFMUState", "canGetAndSetFMUstate", "unknown attribute canGetAndSetFMUstate"),
    ('name="spin"', 'name="fx"', "the name fx is used twice"),
    ('name="spin" valueReference="2"', 'name="spin" valueReference="1"', "the value reference 1 is used twice"),
    ('name="mx" valueReference="15"', 'name="mx" valueReference="1"', "the value reference 1 is used twice"),
    ('causality="independent"', 'causality="local"', "one independent variable"),
    ('unit="s"/>', 'unit="s" start="0"/>', "time must not have a start value"),
    ('unit="1/m" start="0"/>', 'unit="1/m"/>', "needs a start value"),
    ('<Start value="hertz.creep"/>', "", "table needs a start value"),
    ('unit="N.m"/>', 'unit="N.m" start="0"/>', "must not have a start value"),
    ('unit="N.m"/>', 'unit="Nm"/>', "undefined unit"),
    ('max="10000"', 'max="1e+04"', "not whole"),
    ('causality="parameter" variability="fixed"', 'causality="parameter" variability="continuous"', "do not go together"),
    ('start="0.28"', 'start="0.6"', "starts outside its range"),
    ('<Output valueReference="5" dependencies="0 1 2 3 4"/>', "", "must list all outputs as Output"),
    ('<Output valueReference="5" dependencies="0 1 2 3 4"/>', '<Output valueReference="5" dependencies="10"/>', "is no input"),
    ('<Output valueReference="5" dependencies="0 1 2 3 4"/>', '<Output valueReference="5" dependencies="99"/>', "no variable 99"),
    ('    <Output valueReference="5"', '    <InitialUnknown valueReference="5"/><Output valueReference="5"', "must come before"),
    ("<Float64 name=\"spin\"", "<Float32 name=\"spin\"", "has the type Float32"),
    ("CoSimulation", "ModelExchange", "CoSimulation is missing"),
]


class CheckFmuTest(unittest.TestCase):
    def setUp(self):
        self.good, self.good3 = (self.description(os.environ[name]) for name in ("MICROSLIP_FMU", "MICROSLIP_FMU3"))

    def description(self, path):
        with zipfile.ZipFile(path) as archive:
            return archive.read("modelDescription.xml").decode()

    def faults(self, text):
        found = []
        check_fmu.check_description(text, found.append)
        return "\n".join(found)

    def test_the_good_one_breaks_no_rule(self):
        self.assertEqual(self.faults(self.good), "")
        self.assertEqual(self.faults(self.good3), "")

    def test_each_change_breaks_the_rule_it_is_about(self):
        for good, changes in ((self.good, CHANGES), (self.good3, CHANGES3)):
            for old, new, words in changes:
                with self.subTest(change=new, words=words):
                    self.assertIn(old, good)
                    self.assertIn(words, self.faults(good.replace(old, new)))

    def test_binaries_have_the_names_of_their_platforms(self):
        def faults(*names):
            return check_fmu.check_binaries(names, "unit")

        both = ["binaries/linux64/unit.so", "binaries/win64/unit.dll", "modelDescription.xml"]
        self.assertEqual(faults(*both), [])
        self.assertEqual(faults(both[1]), ["binaries/linux64/unit.so is missing"])
        self.assertEqual(faults(both[0], "binaries/win64/unit.so"), ["binaries/win64/unit.dll is missing"])
        self.assertEqual(faults(both[0], "binaries/win32s/unit.dll"), ["binaries/win32s is no platform"])

    def test_structured_names_have_their_syntax(self):
        for good in (self.good, self.good3):
            structured = good.replace('variableNamingConvention="flat"', 'variableNamingConvention="structured"')
            self.assertEqual(self.faults(structured.replace('name="spin"', 'name="patch[1].spin"')), "")
            self.assertIn("no structured name", self.faults(structured.replace('name="spin"', 'name="patch[1]..spin"')))


if __name__ == "__main__":
    unittest.main()
