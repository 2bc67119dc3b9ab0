"""Cost of a call through the Python interface: PYTHONPATH=build/release/share/microslip/python python3 bench/interfaces.py.

The overhead is the time of a call whose input is refused at once: all that is left of it is the way in and out.
"""

import math
import time
import timeit

import numpy as np

import microslip

WANTED = 2000  # ns that a call may cost more than in C++


def nanoseconds(call):
    """The shortest of several runs: what company costs is not the call's."""
    return 1e9 * min(timeit.repeat(call, number=500, repeat=300)) / 500


def main():
    """Prints one line for each kind of call."""
    steel = microslip.Material.from_young(210e9, 0.28)
    pair = microslip.combine(steel, steel)
    hertz = microslip.hertz_from_load(microslip.gap_curvatures(0.46, math.inf, math.inf, 0.3), pair, 80e3)
    contact = microslip.EllipticContact(hertz.a, hertz.b, pair.shear_modulus, pair.poisson_ratio, 80e3, 0.3, (0.0018, 0.0006, 0.4))
    refused = microslip.EllipticContact(-1, 1, 1, 0.3, 1, 0.3)
    solver = microslip.Fastsim2()
    solve, differentiate, creepage = solver.solve, solver.differentiate, contact.creepage
    forces = solve(contact)

    def changed():
        creepage.spin = 0.4
        return solve(contact).fx

    calls = {
        "solve(contact)": lambda: solve(contact),
        "solve(contact, xi, eta, phi)": lambda: solve(contact, 0.0018, 0.0006, 0.4),
        "set one creepage, solve, read fx": changed,
        "differentiate(contact)": lambda: differentiate(contact),
        "overhead: solve of refused input": lambda: solve(refused),
        "overhead: solve of refused input with xi, eta, phi": lambda: solve(refused, 0.0018, 0.0006, 0.4),
        "overhead: differentiate of refused input": lambda: differentiate(refused),
        "read forces.fx": lambda: forces.fx,
    }
    for name, call in calls.items():
        print(f"{name:<52}{nanoseconds(call):8.0f} ns" + (f"   wanted: <= {WANTED} ns" if "overhead" in name else ""))
    creepages = np.linspace(1e-4, 3e-3, 100000)
    batch = timeit.repeat(lambda: solver.solve_batch(contact, creepages, threads=1), timer=time.process_time, number=1, repeat=15)
    print(f"{'solve_batch of 100,000 on one thread, CPU time each':<52}{1e9 * min(batch) / len(creepages):8.0f} ns")


if __name__ == "__main__":
    main()
