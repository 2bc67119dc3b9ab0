#!/usr/bin/env python3
"""Coefficients of microslip/railway/rows/kernel/row_pairs.cpp: the influence of rows on each other in closed form.

P(delta, rho) = E[asinh(delta/|Z|)], Z = a S - b T with independent S and T of density 2/pi sqrt(1 - t^2),
a^2 = 1 + rho, b^2 = 1 - rho, as sum of rho^(2 n) P_n(delta), exact at four values of rho^2, and each P_n as
h (A(m) + ln(delta^2) B(m)), h = delta/sqrt(1 + delta^2), m = h^2, A and B of degree 5, by least squares over P_n and its
first two derivatives with respect to ln(delta). Prints the coefficients, A's before B's, and the largest errors over P_0
and over its derivative.
"""

import numpy as np

SQUARES = np.array([0, 0.25, 0.64, 1])
DEGREE = 5

STEPS = np.arange(-40, 41) * 0.1  # tanh-sinh quadrature
NODES = np.tanh(np.pi / 2 * np.sinh(STEPS))
WEIGHTS = 0.1 * np.pi / 2 * np.cosh(STEPS) / np.cosh(np.pi / 2 * np.sinh(STEPS)) ** 2


def semicircle(t):
    return 2 / np.pi * np.sqrt(np.maximum(1 - t * t, 0))


def density(z, a, b):
    """Of Z at z >= 0."""
    if b < 1e-9:
        return semicircle(z / a) / a
    high = max(min(b, a - z), -b)
    y = (high - b) / 2 + (high + b) / 2 * NODES
    return (high + b) / 2 * np.sum(WEIGHTS * semicircle((z + y) / a) * semicircle(y / b)) / (a * b)


def differences(square):
    """|Z| at the nodes of a quadrature, with its density times their weights."""
    a, b = np.sqrt(1 + np.sqrt(square)), np.sqrt(1 - np.sqrt(square))
    places, weights = [], []
    for low, high in ((0, a - b), (a - b, a + b)):
        if high > low:
            z = np.maximum(low + (high - low) * (1 + NODES) / 2, 1e-14)
            places.append(z)
            weights.append((high - low) * WEIGHTS * np.array([density(v, a, b) for v in z]))
    return np.concatenate(places), np.concatenate(weights)


def exact(deltas):
    """P_n and its first two derivatives with respect to ln(delta): [delta, n, derivative]."""
    values = np.empty((deltas.size, SQUARES.size, 3))
    for k, square in enumerate(SQUARES):
        z, w = differences(square)
        for i, d in enumerate(deltas):
            r = np.hypot(z, d)
            values[i, k] = (w * np.arcsinh(d / z)).sum(), (w * d / r).sum(), (w * d * z * z / r**3).sum()
    return np.einsum("nk,ikv->inv", np.linalg.inv(np.vander(SQUARES, increasing=True)), values)


def basis(delta):
    """h m^k and h ln(delta^2) m^k with their derivatives with respect to ln(delta)."""
    m = delta**2 / (1 + delta**2)
    h, rate = np.sqrt(m), 1 - m
    dm = 2 * m * rate
    ddm = 2 * (1 - 2 * m) * dm
    columns = []
    for g, dg in ((np.ones_like(delta), 0), (np.log(delta**2), 2)):
        for k in range(DEGREE + 1):
            f = m**k
            df = k * m ** max(k - 1, 0) * dm
            ddf = k * (k - 1) * m ** max(k - 2, 0) * dm**2 + k * m ** max(k - 1, 0) * ddm
            q, dq, ddq = f * g, df * g + f * dg, ddf * g + 2 * df * dg
            columns.append((h * q, h * (rate * q + dq), h * ((rate**2 - dm) * q + 2 * rate * dq + ddq)))
    return np.array(columns).transpose(2, 1, 0)


def main():
    deltas = np.logspace(-4, 3.5, 600)
    wanted, columns = exact(deltas), basis(deltas)
    scale = np.stack([wanted[:, 0, 0], wanted[:, 0, 1], 5 * wanted[:, 0, 1]], axis=1)
    for n in range(SQUARES.size):
        matrix = (columns / scale[:, :, None]).reshape(-1, columns.shape[2])
        c = np.linalg.lstsq(matrix, (wanted[:, n] / scale).ravel(), rcond=None)[0]
        relative = np.abs((columns @ c - wanted[:, n]) / wanted[:, 0, [0, 1, 1]]).max(axis=0)
        print(f"P_{n}: {{{', '.join(f'{v:.12g}' for v in c)}}}  errors {relative[0]:.1e} {relative[1]:.1e} {relative[2]:.1e}")


if __name__ == "__main__":
    main()
