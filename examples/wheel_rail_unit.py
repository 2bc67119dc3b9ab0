#!/usr/bin/env python3
"""The functional mock-up unit of a wheel on a rail, stepped as a system simulation does, with nothing but Python's
library: wheel_rail_unit.py FILE.fmu. Prints the lateral force on the wheel, its derivative, and the flange's load while the
wheel moves towards the flange."""

import ctypes
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

Logger = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_char_p,
                          ctypes.c_char_p)


class Callbacks(ctypes.Structure):
    """fmi2CallbackFunctions."""
    _fields_ = [("logger", Logger)] + [(name, ctypes.c_void_p) for name in ("allocate", "free", "finished", "environment")]


class Unit:
    """An instance for co-simulation, its variables by their names."""

    def __init__(self, folder):
        root = ElementTree.parse(folder / "modelDescription.xml").getroot()
        self.references = {v.get("name"): int(v.get("valueReference")) for v in root.iter("ScalarVariable")}
        identifier = root.find("CoSimulation").get("modelIdentifier")
        self.library = ctypes.CDLL(str(folder / "binaries/linux64" / f"{identifier}.so"))
        self.library.fmi2Instantiate.restype = ctypes.c_void_p
        # The message is given by a format "%s" and one argument more, which this logger has not.
        self.callbacks = Callbacks(Logger(lambda environment, name, status, category, text: None))
        self.instance = ctypes.c_void_p(self.library.fmi2Instantiate(
            b"wheel", 1, root.get("guid").encode(), (folder / "resources").as_uri().encode(), ctypes.byref(self.callbacks), 0, 0))

    def call(self, name, *arguments):
        if getattr(self.library, name)(self.instance, *arguments) != 0:
            raise RuntimeError(f"{name} failed")

    def reference(self, name):
        return ctypes.byref(ctypes.c_uint(self.references[name]))

    def set(self, name, value):
        if isinstance(value, str):
            self.call("fmi2SetString", self.reference(name), ctypes.c_size_t(1), ctypes.byref(ctypes.c_char_p(value.encode())))
        else:
            self.call("fmi2SetReal", self.reference(name), ctypes.c_size_t(1), ctypes.byref(ctypes.c_double(value)))

    def get(self, name):
        value = ctypes.c_double()
        self.call("fmi2GetReal", self.reference(name), ctypes.c_size_t(1), ctypes.byref(value))
        return value.value

    def derivative(self, of, by):
        seed, change = ctypes.c_double(1), ctypes.c_double()
        self.call("fmi2GetDirectionalDerivative", self.reference(of), ctypes.c_size_t(1), self.reference(by),
                  ctypes.c_size_t(1), ctypes.byref(seed), ctypes.byref(change))
        return change.value


def main(path):
    with tempfile.TemporaryDirectory() as name, zipfile.ZipFile(path) as archive:
        archive.extractall(name)
        unit = Unit(Path(name))
        unit.set("track.cant", 0.025)
        unit.set("wheelset.profile", "s1002.prw")  # one of the unit's files; any path will do
        for name, value in (("state.forward_velocity", 20.0), ("state.pitch_velocity", 20.0 / 0.46), ("state.yaw", 2e-3)):
            unit.set(name, value)
        unit.call("fmi2EnterInitializationMode")
        unit.call("fmi2ExitInitializationMode")
        print("y [mm]   Fy [N]   dFy/dy [N/mm]   largest contact angle [deg]")
        for k in range(8):
            unit.set("state.lateral", k * 1e-3)
            unit.call("fmi2DoStep", ctypes.c_double(k * 0.1), ctypes.c_double(0.1), 1)
            angle = max(unit.get(f"patch[{patch}].angle") for patch in range(1, 9))
            print(f"{k:6} {unit.get('wheel.force_y'):8.0f} {unit.derivative('wheel.force_y', 'state.lateral') / 1e3:15.0f} {angle * 57.29578:29.1f}")
        unit.library.fmi2FreeInstance(unit.instance)


if __name__ == "__main__":
    main(sys.argv[1])
