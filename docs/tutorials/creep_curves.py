# %% [markdown]
# # Creep curves
#
# The force over the creepage is the characteristic curve of a rolling contact. Traction control, hunting and wear
# depend on its slope at the origin, on where it bends, and on whether it falls again. This tutorial computes such
# curves in single calls, and says what bends them.

# %%
import copy

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, GREEN, INK3, RED, SETTINGS, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
contact = copy.copy(microslip.read_case("examples/hertzian_contact.toml").contact)  # to be changed below
solver = microslip.Fastsim2()
limit = 0.3 * contact.normal_force  # mu Fn

# %% [markdown]
# ## Slope and saturation
#
# A batch takes arrays instead of creepages; they broadcast as numpy's arrays do, and all processors work on them. So
# one call gives the curves for three spins: spins down, creepages across.

# %%
xi = np.linspace(0, 8e-3, 161)
spins = np.array([0.0, 0.4, 1.2])
curves = solver.solve_batch(contact, xi, lateral=0, spin=spins[:, None])
coefficients = microslip.creepage_coefficients(contact.a / contact.b, contact.poisson_ratio)
slope = coefficients.c11 * contact.shear_modulus * contact.a * contact.b  # N

figure, (along, across) = plt.subplots(
    1, 2, num="Forces over the longitudinal creepage for three spins",
    figsize=(9.5, 3.8))
for row, colour in enumerate((ALONG, SLIDES, GREEN)):
    along.plot(1e3 * xi, -curves.fx[row] / limit, color=colour, label=f"spin {spins[row]:g} /m")
    across.plot(1e3 * xi, -curves.fy[row] / limit, color=colour)
along.plot(1e3 * xi, slope * xi / limit, ":", color=INK3, label="Kalker's linear theory")
along.set(xlabel="longitudinal creepage [$10^{-3}$]", ylabel="$-F_x$ / ($\\mu F_n$)", ylim=(0, 1.1))
across.set(xlabel="longitudinal creepage [$10^{-3}$]", ylabel="$-F_y$ / ($\\mu F_n$)", ylim=(0, 1.1))
along.legend(loc="lower right")
plt.show()
print(f"slope at the origin {slope / 1e6:.2f} MN, by differences {-curves.fx[0, 1] / xi[1] / 1e6:.2f} MN")

# %% [markdown]
# **How to read it.** Left: without spin the curve leaves the origin with the slope of Kalker's linear theory,
# $C_{11} G a b$, which is a property of the elastic bodies alone; friction plays no part there. It bends as the slip
# area grows, and ends at the friction limit when all of the contact slips. Right: spin alone pushes the wheel sideways,
# as it does a spinning ball. Whatever part of the friction is used for one direction is missing in the other: braking
# takes the lateral force away. That is why a braked wheel is guided less.
#
# ## Derivatives
#
# An implicit integrator needs the slope at any point of the curve, in all directions. `differentiate` gives them with
# the forces, by differentiation of the code itself, not by differences:

# %%
contact.creepage = (0.0018, 0.0006, 0.4)
derivatives = solver.differentiate(contact)
print("dF/d(xi, eta, phi):")
for name, row in zip(("Fx", "Fy", "Mz"), derivatives.jacobian):
    print(f"  {name}  {row[0]:11.4g} {row[1]:11.4g} {row[2]:11.4g}")
step = 1e-7
contact.creepage = (0.0018 + step, 0.0006, 0.4)
change = (solver.solve(contact).fx - derivatives.forces.fx) / step
print(f"dFx/dxi by a difference: {change:.4g} N")

# %% [markdown]
# Compare the first number with the slope at the origin: four fifths of the friction are used, and the curve is only
# half as steep.
#
# ## Friction that falls
#
# Measured curves have a maximum and fall beyond it, since friction drops with the speed of sliding. Polach's law,
# $\mu = \mu_0((1 - A)e^{-Bv} + A)$ with the slip velocity $v$, is one of those that microslip has. Now the rolling
# speed matters: the same creepage is a larger slip velocity on a faster train.

# %%
contact.friction = microslip.FrictionLaw.polach(0.3, ratio=0.4, decay=0.6)  # mu_0, A, B [s/m]
creepages = np.linspace(0, 0.1, 400)
figure, axes = plt.subplots(num="Creep curves with friction that falls with the slip velocity", figsize=(6.5, 3.8))
for speed, colour in ((5.0, ALONG), (15.0, SLIDES), (40.0, RED)):
    contact.rolling_speed = speed
    falling = solver.solve_batch(contact, creepages, lateral=0, spin=0)
    axes.plot(100 * creepages, -falling.fx / limit, color=colour, label=f"{speed:g} m/s")
    best = np.argmax(-falling.fx)
    print(f"{speed:4g} m/s: at most {-falling.fx[best] / limit:.3f} mu_0 Fn, "
          f"at a creepage of {100 * creepages[best]:.2f} %")
axes.set(xlabel="longitudinal creepage [%]", ylabel="$-F_x$ / ($\\mu_0 F_n$)")
axes.legend()
plt.show()

# %% [markdown]
# **How to read it.** To the left of the maximum more creepage gives more force, and a driven wheel finds its balance.
# To the right it gives less, and the wheel begins to spin. The maximum is what traction control looks for; it is lower
# at higher speed. With the exact theory, falling friction has more than one solution and needs a memory: see
# [other bodies and friction](../theory-bodies.md).
