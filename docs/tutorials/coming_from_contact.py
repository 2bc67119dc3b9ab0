# %% [markdown]
# # Coming from CONTACT
#
# Who has input files of the program CONTACT can run them as they are. This tutorial runs one, shows where its numbers
# are in Python, and builds one of its cases anew without the file.
#
# From the command line it is `microslip run FILE.inp`; [CONTACT's input files](../contact-input.md) says what is read.

# %%
import math

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, INK, INK3, SETTINGS, SLIDES, STICKS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
with open("examples/sphere_on_plane.inp") as file:
    print("".join(file.readlines()[4:15]))

# %% [markdown]
# That is its first case: a ball pressed on a plane. Then follow a shift by 7/8 of the friction limit, one step of
# rolling, and steady rolling, each from the tractions of the case before.
#
# ## Run
#
# Cases come one after the other as they are solved, so that a file of ten thousand needs no more memory than one of
# ten. `totals` are in CONTACT's units and under its names, fields are in SI units.

# %%
cases = list(microslip.run_contact_input("examples/sphere_on_plane.inp"))
print("case  outcome        FN        FX   adhesion  slip   approach")
for case in cases:
    totals = case.totals
    print(f"{case.number:4}  {case.outcome:8} {totals.fn:8.4f}  {totals.fx:8.4f}   "
          f"{totals.adhesion:8} {totals.slip:5}   {totals.approach:.5f}")

# %% [markdown]
# A case that asks for something that is not supported is no error: its `outcome` says refused, `reasons` say why, and
# the others run.
#
# ## Look
#
# Elements are stored as in CONTACT, x ascending.

# %%
figure, panels = plt.subplots(
    1, 3, num="Adhesion (blue) and slip (orange) after the shift, after one step of rolling, and in steady rolling",
    figsize=(10, 3.6), sharey=True)
for axes, case, title in zip(panels, cases[1:], ("shift", "one step rolled", "steady rolling")):
    x, y = np.meshgrid(1e3 * case.grid.x, 1e3 * case.grid.y)
    state, px = np.asarray(case.tangential.state), np.asarray(case.tangential.px)
    for kind, colour in ((microslip.CellState.adhesion, STICKS), (microslip.CellState.slip, SLIDES)):
        here = state == kind
        axes.plot(x[here], y[here], "s", color=colour, markersize=9)
    inside = state != microslip.CellState.exterior
    axes.quiver(x[inside], y[inside], px[inside], np.asarray(case.tangential.py)[inside], width=0.005, zorder=3)
    axes.set(title=title, xlabel="x [mm]", aspect="equal")
panels[0].set_ylabel("y [mm]")
plt.show()

# %% [markdown]
# **How to read it.** Shifted: slip in a ring, adhesion in the middle, as Cattaneo and Mindlin found. Rolled a little:
# particles that entered on the right adhere. Steady: slip is only at the rear, on the left, as Carter found.
#
# ## The same without the file
#
# What the file calls ... | is here
# --- | ---
# `POISS`, `GG` | `Material(shear_modulus, poisson_ratio)`, in Pa
# `FN`, `FSTAT` | `normal_force`, `friction` of `EllipticContact`
# `CKSI`, `CETA`, `CPHI` | `creepage`, spin in 1/m
# `T` = 1, 2, 3 | `kind="shift"`, `"transient"`, `"steady"` of `RollingProblem`
# `F` = 1, 2 | `force_longitudinal`, `force_lateral` of `RollingProblem`
# `IPOTCN` = -3, `MX`, `MY`, `SCALE` | the ellipse's semi-axes, elements across it
# `DQ` | `step`
# `CHI` | `direction`
#
# In module 3 signs are the same. In module 1 some are not: see the [table](../conventions.md#contact).
#
# The steady rolling of the fourth case, once with CONTACT's discretisation, then with elements of second order. The
# grid of the file reaches beyond the ellipse by a factor of 1.4, so its 21 elements are 15 across the ellipse:

# %%
rubbery = microslip.Material(200e6, 0.42)  # 200 N/mm^2
limit = 0.4 * 9.1954
contact = microslip.EllipticContact(1e-3, 1e-3, rubbery.shear_modulus, rubbery.poisson_ratio, 9.1954, 0.4)
problem = microslip.RollingProblem(contact, force_longitudinal=-0.875 * limit)
print(f"file                  xi = {cases[3].totals.x:.6f}")
for discretisation, n in (("classical", 15), ("second_order", 15), ("second_order", 64)):
    solved = microslip.Solver(theory="exact", grid=n, discretisation=discretisation).solve(problem)
    print(f"{discretisation:12} {n:3} x {n:<3} xi = {solved.creepage.longitudinal:.6f}")

# %% [markdown]
# The classical elements repeat CONTACT's number. Those of second order, on the same grid, are much nearer to the limit.
# So differences from CONTACT are mostly CONTACT's discretisation error; where digits matter, compare with
# `discretisation="classical"`. [Accuracy of the exact theory](../accuracy-exact.md) has all printed results of
# CONTACT's examples beside microslip's.
