#!/usr/bin/env python3
"""The Manchester contact benchmark A-2.2 through libcontact by ctypes: both wheels, 21 states each. manchester.c says
more.

    python3 manchester.py PREFIX/lib/libcontact.so RAIL.prr WHEEL.prw
"""
import sys
from ctypes import CDLL, byref, c_double, c_int

UNITS, CONFIG, PVTIME, TANG, NORM, DISCNS, SENS = 1933, 1967, 1970, 1972, 1973, 1977, 1988
CONTACT_UNITS = 1934
WHOLE = -1
ROLL = [0.00000000, -0.00002304, -0.00005049, -0.00008103, -0.00011280, -0.00014570, -0.00018030, -0.00021680,
        -0.00025570, -0.00029770, -0.00035540, -0.00047770, -0.00062720, -0.00437600, -0.00639300, -0.00764200,
        -0.00860600, -0.00940800, -0.01010113, -0.01071386, -0.01126431]
PITCH_VELOCITY = [-4.34811810, -4.34741340, -4.34657520, -4.34624400, -4.34591970, -4.34556270, -4.34515030,
                  -4.34466880, -4.34409300, -4.34337150, -4.33536370, -4.33188640, -4.32937180, -4.27488340,
                  -4.26356290, -4.25757470, -4.25348570, -4.25032450, -4.24775610, -4.24556650, -4.24363750]


def ints(*values):
    return (c_int * len(values))(*values)


def doubles(*values):
    return (c_double * len(values))(*values)


class Contact:
    """The library's functions: numbers are handed over by reference, results are lists."""

    def __init__(self, path):
        self.library = CDLL(path)

    def call(self, name, *arguments):
        def by_reference(value):
            if isinstance(value, int):
                return byref(c_int(value))
            return byref(c_double(value)) if isinstance(value, float) else value

        code = getattr(self.library, name)(*map(by_reference, arguments))
        if code < 0:
            sys.exit(f"{name}: code {code}, see contact_addon.out")
        return code

    def numbers(self, name, *arguments, count):
        """The numbers that a function returns in one array."""
        values = doubles(*[0.0] * count)
        self.call(name, *arguments, count, values)
        return list(values)

    def scalars(self, name, *arguments, count, kind=c_double):
        """The numbers that a function returns one by one."""
        values = [kind() for _ in range(count)]
        self.call(name, *arguments, *map(byref, values))
        return [value.value for value in values]


def set_profile(contact, ire, file, itype):
    name = file.encode()
    contact.call("cntc_setprofileinputfname", ire, name, len(name), 3, ints(itype, 0, 0), 2, doubles(1, 0))


def set_up(contact, ire, rail, wheel):
    """Makes the settings that do not change from state to state."""
    flags = {UNITS: CONTACT_UNITS, CONFIG: ire - 1, TANG: 3, PVTIME: 2, NORM: 1, DISCNS: 2}
    contact.call("cntc_setflags", ire, WHOLE, len(flags), ints(*flags), ints(*flags.values()))
    contact.call("cntc_setmaterialparameters", ire, WHOLE, 0, 4, doubles(0.28, 0.28, 82000, 82000))
    contact.call("cntc_setfrictionmethod", ire, WHOLE, 0, 2, doubles(0.3, 0.3))
    contact.call("cntc_setverticalforce", ire, 10000.0)
    contact.call("cntc_setpotcontact", ire, WHOLE, -1, 5, doubles(0.2, 0.2, 1.5707963267948966, 8, 4))
    contact.call("cntc_setrollingstepsize", ire, WHOLE, 0.0, 1.0)
    contact.call("cntc_settrackdimensions", ire, 3, 11, doubles(14, 0, 1435, 0, 0, 0, 0, 0, 0, 0, 0))
    set_profile(contact, ire, rail, 0)
    contact.call("cntc_setwheelsetdimensions", ire, 3, 3, doubles(1360, -70, 460))
    set_profile(contact, ire, wheel, 1)


def set_state(contact, ire, state):
    contact.call("cntc_setwheelsetposition", ire, 2, 6, doubles(0, 0.5 * state, 0, ROLL[state], 0.0012 * state, 0))
    contact.call("cntc_setwheelsetvelocity", ire, 2, 6, doubles(2000, 0, 0, 0, 0, PITCH_VELOCITY[state]))


def show(word, counts, numbers, digits=9):
    print(word, *counts, *(f"{number:.{digits}g}" for number in numbers))


def show_patch(contact, ire, state, icp):
    at = contact.numbers("cntc_getcontactlocation", ire, icp, count=40)
    velocity = contact.scalars("cntc_getreferencevelocity", ire, icp, count=1)
    approach = contact.scalars("cntc_getpenetration", ire, icp, count=1)
    creepages = contact.scalars("cntc_getcreepages", ire, icp, count=3)
    forces = contact.scalars("cntc_getcontactforces", ire, icp, count=4)
    area = contact.scalars("cntc_getcontactpatchareas", ire, icp, count=3)[0]
    pressure = contact.scalars("cntc_getmaximumpressure", ire, icp, count=1)
    results = at[0:4] + at[5:7] + velocity + approach + creepages + forces + [area] + pressure
    show("patch", (ire, state + 1, icp), results)


def show_fields(contact, ire, icp):
    """Pressures and tractions of all elements, and what they sum up to."""
    mx, my = contact.scalars("cntc_getnumelements", ire, icp, count=2, kind=c_int)
    dx, dy = contact.scalars("cntc_getgriddiscretization", ire, icp, count=2)
    count = mx * my
    pn, px, py = ((c_double * count)() for _ in range(3))
    division = (c_int * count)()
    contact.call("cntc_gettractions", ire, icp, count, pn, px, py)
    contact.call("cntc_getelementdivision", ire, icp, count, division)
    in_contact = sum(element > 0 for element in division)
    show("fields", (ire, icp, mx, my, in_contact), (sum(pn) * dx * dy, sum(px) * dx * dy))


def main(library, rail, wheel):
    contact = Contact(library)
    blank = (b" ", b" ", b" ", 1, 1, 1)
    contact.call("cntc_initializefirst", byref(c_int()), byref(c_int()), 0, *blank)
    for ire in (1, 2):
        contact.call("cntc_initialize", ire, 1, byref(c_int()), byref(c_int()), b" ", 1)
        set_up(contact, ire, rail, wheel)
    for ire in (1, 2):
        for state in range(len(ROLL)):
            is_last = state == len(ROLL) - 1
            set_state(contact, ire, state)
            contact.call("cntc_setflags", ire, WHOLE, 1, ints(SENS), ints(3 if is_last else 0))
            contact.call("cntc_calculate", ire, WHOLE, byref(c_int()))
            forces = contact.numbers("cntc_getglobalforces", ire, WHOLE, count=24)
            height = contact.numbers("cntc_getwheelsetposition", ire, count=6)[2]
            patches, = contact.scalars("cntc_getnumcontactpatches", ire, count=1, kind=c_int)
            show("wheel", (ire, state + 1, patches), [height] + forces[0:3] + forces[6:9])
            for icp in range(1, patches + 1):
                show_patch(contact, ire, state, icp)
            if is_last:
                show_fields(contact, ire, 1)
                sensitivities = doubles(*[0.0] * 16)
                contact.call("cntc_getsensitivities", ire, 1, 4, 4, sensitivities)
                show("sensitivities", (ire,), sensitivities, digits=6)
    contact.call("cntc_finalizelast")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: manchester.py LIBRARY RAIL.prr WHEEL.prw")
    main(*sys.argv[1:])
