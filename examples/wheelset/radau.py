"""The integrator of radau.hpp in Python."""

import numpy as np
from numpy.linalg import solve

A = np.array([[5 / 12, -1 / 12], [3 / 4, 1 / 4]])


class Radau:
    """Two-stage Radau IIA method with a Jacobian that is kept as long as it serves; steps are halved where Newton's method does
    not converge, and end on jumps of the rates that the motion cannot leave."""

    def __init__(self, scale, tolerance=1e-7):
        self.scale, self.tolerance = np.array(scale), tolerance
        self.slope, self.step, self.inverse = np.zeros(len(scale)), 0.0, None
        self.iterations = self.jacobians = self.halvings = self.jumps = 0

    def advance(self, z, step, rates, jacobian, halvings=5):
        """The state after a step; `rates(z)` is f, `jacobian(z)` its Jacobian."""
        stages = self.find_stages(z, step, rates, jacobian, halvings == 0)
        if stages is not None:
            self.slope = stages[1] / step
            return z + stages[1]
        if halvings == 0:
            raise RuntimeError("Newton's method does not converge")
        self.halvings += 1
        for _ in range(2):
            z = self.advance(z, step / 2, rates, jacobian, halvings - 1)
        return z

    def find_stages(self, z, step, rates, jacobian, is_shortest):
        stages = step * np.outer((1 / 3, 1), self.slope)
        stale, before = self.inverse is None or step != self.step, 0.0
        for iteration in range(1, 26):
            self.iterations += 1
            if stale:
                self.factor(z + stages[1], step, jacobian)
            residual = step * A @ np.array([rates(z + stage) for stage in stages]) - stages
            change = (self.inverse @ residual.ravel()).reshape(stages.shape)
            part = 0.6 ** max(0, iteration - 8) if is_shortest else 1.0
            stages = stages + part * change
            size = np.abs(change / self.scale).max()
            if not np.isfinite(size):
                break
            reduction = size / before if iteration > 1 else 0.0
            if size < self.tolerance or (0 < reduction < 1 and size * reduction / (1 - reduction) < self.tolerance):
                return stages
            stale, before = reduction > 0.2 and part == 1, size
        self.inverse = None
        if not is_shortest or not before < 1:
            return None
        self.jumps += 1
        return stages

    def factor(self, z, step, jacobian):
        size = 2 * len(self.scale)
        self.inverse = solve(np.eye(size) - step * np.kron(A, jacobian(z)), np.eye(size))
        self.step = step
        self.jacobians += 1
