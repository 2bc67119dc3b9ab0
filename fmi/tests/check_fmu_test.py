"""The check of the description finds what it is for: each change of the good description breaks a rule."""

import os
import unittest
import zipfile

import check_fmu

CHANGES = [
    ('fmiVersion="2.0"', 'fmiVersion="3.0"', "no description of FMI 2.0"),
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


class CheckFmuTest(unittest.TestCase):
    def setUp(self):
        with zipfile.ZipFile(os.environ["MICROSLIP_FMU"]) as archive:
            self.good = archive.read("modelDescription.xml").decode()

    def faults(self, text):
        found = []
        check_fmu.check_description(text, found.append)
        return "\n".join(found)

    def test_the_good_one_breaks_no_rule(self):
        self.assertEqual(self.faults(self.good), "")

    def test_each_change_breaks_the_rule_it_is_about(self):
        for old, new, words in CHANGES:
            with self.subTest(change=new, words=words):
                self.assertIn(old, self.good)
                self.assertIn(words, self.faults(self.good.replace(old, new)))

    def test_binaries_have_the_names_of_their_platforms(self):
        def faults(*names):
            return check_fmu.check_binaries(names, "unit")

        both = ["binaries/linux64/unit.so", "binaries/win64/unit.dll", "modelDescription.xml"]
        self.assertEqual(faults(*both), [])
        self.assertEqual(faults(both[1]), ["binaries/linux64/unit.so is missing"])
        self.assertEqual(faults(both[0], "binaries/win64/unit.so"), ["binaries/win64/unit.dll is missing"])
        self.assertEqual(faults(both[0], "binaries/win32s/unit.dll"), ["binaries/win32s is no platform"])

    def test_structured_names_have_their_syntax(self):
        structured = self.good.replace('variableNamingConvention="flat"', 'variableNamingConvention="structured"')
        self.assertEqual(self.faults(structured.replace('name="spin"', 'name="patch[1].spin"')), "")
        self.assertIn("no structured name", self.faults(structured.replace('name="spin"', 'name="patch[1]..spin"')))


if __name__ == "__main__":
    unittest.main()
