# %% [markdown]
# # In a vehicle code
#
# A vehicle code calls the contact law in its innermost loop, some thousand times for each simulated second and contact,
# and if its integrator is implicit, it needs derivatives. This tutorial builds the smallest vehicle that shows what
# matters: one wheelset, held by springs, that begins to hunt when it runs too fast.
#
# The same in C++, with rotation and flanges, is in `examples/wheelset`; the C interface, Fortran and FMI are in
# [embedding](../embedding.md). The pattern is the same everywhere: create the solver once, call it often.

# %%
import time

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, INK3, RED, SETTINGS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})

# %% [markdown]
# ## The wheelset
#
# Its state is the lateral displacement $y$, the yaw angle $\psi$ (to the left), and their rates. With the conicity
# $\lambda$ the left wheel (side $s = 1$) rolls on the radius $r + \lambda y$, the right one ($s = -1$) on
# $r - \lambda y$. The creepages are
#
# $$\xi_s = -\frac{s\,\lambda y}{r} - \frac{s\,l\,\dot\psi}{v}, \qquad \eta = \frac{\dot y}{v} - \psi, \qquad \phi_s = \frac{\dot\psi}{v} - \frac{s\,\lambda}{r},$$
#
# with half the gauge $l$ and the speed $v$, linear in the state: one matrix for each wheel and a constant.

# %%
mass, inertia, radius, half_gauge, conicity = 1200.0, 800.0, 0.46, 0.75, 0.1
spring, yaw_spring, load = 2e5, 1e6, 60e3  # N/m, N m, N
steel = microslip.Material.from_young(210e9, 0.28)
pair = microslip.combine(steel, steel)
hertz = microslip.hertz_from_load(microslip.gap_curvatures(radius, np.inf, np.inf, 0.3), pair, load)


def wheel(side, speed):
    """Creepages = matrix @ (y, psi, y', psi') + constant."""
    matrix = np.array([[-side * conicity / radius, 0, 0, -side * half_gauge / speed],
                       [0, -1, 1 / speed, 0],
                       [0, 0, 0, 1 / speed]])
    return matrix, np.array([0, 0, -side * conicity / radius])


# %% [markdown]
# ## The contact law in it
#
# Each wheel has its creepages; `differentiate` gives forces and their derivatives in one call. The chain rule carries
# them to the state. That is all that an integrator needs.

# %%
solver = microslip.Fastsim2()
contact = microslip.EllipticContact(hertz.a, hertz.b, pair.shear_modulus, pair.poisson_ratio, load, 0.3)
calls, inside = 0, 0.0


def rates(state, speed):
    """f(z) of z' = f(z), and its Jacobian."""
    global calls, inside
    f = np.array([state[2], state[3], -spring * state[0] / mass, -yaw_spring * state[1] / inertia])
    jacobian = np.zeros((4, 4))
    jacobian[[0, 1], [2, 3]] = 1
    jacobian[2, 0], jacobian[3, 1] = -spring / mass, -yaw_spring / inertia
    for side in (1, -1):
        matrix, constant = wheel(side, speed)
        contact.creepage = tuple(matrix @ state + constant)
        begin = time.perf_counter()
        found = solver.differentiate(contact)
        inside += time.perf_counter() - begin
        calls += 1
        lever = np.zeros((4, 3))  # how Fx, Fy, Mz act on the rates
        lever[2, 1], lever[3] = 1 / mass, (-side * half_gauge / inertia, 0, 1 / inertia)
        f += lever @ (found.forces.fx, found.forces.fy, found.forces.mz)
        jacobian += lever @ found.jacobian[:, :3] @ matrix
    return f, jacobian


# %% [markdown]
# ## Is it stable?
#
# For small motions the eigenvalues of the Jacobian decide: the largest real part is the rate at which a disturbance
# grows.

# %%
speeds = np.linspace(10, 90, 81)
growth = [np.linalg.eigvals(rates(np.zeros(4), speed)[1]).real.max() for speed in speeds]
critical = np.interp(0, growth, speeds)
figure, axes = plt.subplots(num="Growth rate of small disturbances over the speed", figsize=(6.5, 3.4))
axes.plot(speeds, growth, color=ALONG)
axes.axhline(0, color=INK3, linewidth=1)
axes.axvline(critical, color=INK3, linestyle="--", linewidth=1)
axes.annotate(f"critical speed\n{critical:.1f} m/s", (critical, 4), xytext=(-6, 0), textcoords="offset points",
              ha="right")
axes.set(xlabel="speed [m/s]", ylabel="growth rate [1/s]")
plt.show()

# %% [markdown]
# **How to read it.** Below zero disturbances die out, above it they grow: the wheelset hunts. (The larger model in
# `examples/wheelset` finds 51.13 m/s.) Note that no derivative was taken by differences: the contact law's are exact,
# which matters where the growth rate is near zero.
#
# ## Large motions
#
# Beyond small motions the forces saturate. The creep forces are stiff (their time constant is below a millisecond at
# low speed), so the integrator is implicit: the trapezoidal rule, with Newton's method and the same Jacobian.

# %%
def run(speed, start, duration, step=1e-3):
    """States at equal steps."""
    states = [np.array([start, 0, 0, 0])]
    for _ in range(round(duration / step)):
        before = states[-1]
        f0, _ = rates(before, speed)
        z = before + step * f0
        for _ in range(20):
            f, jacobian = rates(z, speed)
            change = np.linalg.solve(np.eye(4) - step / 2 * jacobian, z - before - step / 2 * (f0 + f))
            z = z - change
            if np.abs(change).max() < 1e-9:
                break
        else:
            raise RuntimeError("Newton's method does not converge")
        states.append(z)
    return np.array(states)


calls, inside, begin = 0, 0.0, time.perf_counter()
figure, axes = plt.subplots(
    num="Lateral displacement after a disturbance of 3 mm, below and above the critical speed",
    figsize=(8, 3.4))
for ratio, colour in ((0.8, ALONG), (1.1, RED)):
    lateral = run(ratio * critical, 3e-3, 2.5)[:, 0]
    axes.plot(1e-3 * np.arange(len(lateral)), 1e3 * lateral, color=colour, label=f"{ratio:g} of the critical speed")
passed = time.perf_counter() - begin
axes.set(xlabel="time [s]", ylabel="lateral displacement [mm]")
axes.legend(loc="upper left")
plt.show()
print(f"{calls} contacts with derivatives, {1e6 * inside / calls:.1f} microseconds each, "
      f"{inside / passed:.0%} of the time")

# %% [markdown]
# **How to read it.** Below the critical speed the disturbance is forgotten, above it grows, until flanges would stop it
# (this wheelset has none). Here numpy's small matrices cost most of the time; in C++ the contact law does, and a
# simulated second takes 21 ms.
#
# ## What to keep in mind
#
# - **One solver for each thread**, made before the loop. `solve` and `differentiate` then allocate nothing and take no
#   lock, in C++ and C.
# - **Look at `status`**: a contact out of range gives NaN and a status, not an exception, so that a bad trial step of
#   an integrator can be taken back.
# - **Smoothness.** Forces are continuous, and their derivatives too but for kinks where contacts begin to slip;
#   Newton's method does not mind.
# - **Signs** are settled by three test cases, see [conventions](../conventions.md#signs-by-numbers). Try them first.
