"""Work of the workers of an executor for microslip.sweep: a function that can be sent to other processes."""

import threading

_kept = threading.local()


def solve_chunk(text, name, number):
    """The rows of a chunk. Each thread keeps the solver of the sweep that it worked for last."""
    if getattr(_kept, "sweep", None) != (text, name):
        from microslip import _core
        _kept.solver = _core._ChunkSolver(text, name)
        _kept.sweep = text, name
    return _kept.solver.solve(number)
