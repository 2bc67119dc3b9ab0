# %% [markdown]
# # Accuracy and cost
#
# How long may a contact take, and how wrong may it be? The answer decides between the two theories, and between grids.
# This tutorial draws one picture from which both can be read, and shows how to ask the exact theory for an accuracy
# instead of a grid.

# %%
import time

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, GREEN, INK3, RED, SETTINGS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
contact = microslip.read_case("examples/hertzian_contact.toml").contact
limit = 0.3 * contact.normal_force

# %% [markdown]
# ## An answer with its error
#
# With `accuracy` a `Solver` takes the error that is wanted, in units of $\mu F_n$, refines its grid until it is reached,
# and says how large it thinks the error is. With a small one we have a reference for all that follows.

# %%
def elements(solution):
    """Across the ellipse of its grid."""
    return round(2 * contact.a / solution.grid.dx)


best = microslip.Solver(theory="exact", accuracy=1e-4).solve(contact)
print(f"Fx = {best.forces.fx:.2f} N, Fy = {best.forces.fy:.2f} N")
print(f"estimated error {best.estimated_error:.1e} of mu Fn, {elements(best)} elements across")
for wanted in (1e-2, 1e-3):
    found = microslip.Solver(theory="exact", accuracy=wanted).solve(contact)
    true = max(abs(found.forces.fx - best.forces.fx), abs(found.forces.fy - best.forces.fy)) / limit
    print(f"wanted {wanted:g}: estimated {found.estimated_error:.1e}, true {true:.1e}, {elements(found)} elements across")

# %% [markdown]
# The estimate is meant to be on the safe side, and is; over many cases see
# [the study](../accuracy-discretisation.md#second-order).
#
# ## Error over time
#
# Now all methods on a row of grids, each with the time that one contact takes:

# %%
def measured(solve):
    """Error of the force over mu Fn, and the shortest time of some runs [ms]."""
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        forces = solve()
        times.append(1e3 * (time.perf_counter() - begin))
    return np.hypot(forces.fx - best.forces.fx, forces.fy - best.forces.fy) / limit, min(times)


def exact(n, discretisation):
    """The exact theory on n x n elements: a new contact each time, so that nothing is kept from the one before."""
    return lambda: microslip.Solver(theory="exact", grid=n, discretisation=discretisation).solve(contact).forces


methods = {
    "FASTSIM": [(n, measured(lambda s=microslip.Fastsim(n, n): s.solve(contact))) for n in (5, 10, 20, 40, 80)],
    "FASTSIM2": [(n, measured(lambda s=microslip.Fastsim2(n, n): s.solve(contact))) for n in (5, 10, 20, 40, 80)],
    "exact, classical": [(n, measured(exact(n, "classical"))) for n in (8, 16, 32, 64)],
    "exact, second order": [(n, measured(exact(n, "second_order"))) for n in (8, 16, 32, 64)],
}
print("method                 grid      error   time [ms]")
for name, row in methods.items():
    for n, (error, passed) in row:
        print(f"{name:20} {n:>3} x {n:<3} {error:9.5f} {passed:10.3f}")

# %%
figure, axes = plt.subplots(num="Error of the force over the time for one contact", figsize=(7, 4.4))
for (name, row), colour, style in zip(methods.items(), (RED, GREEN, INK3, ALONG), ("s-", "^-", "v-", "o-")):
    errors, times = np.array([values for _, values in row]).T
    axes.loglog(times, errors, style, color=colour, label=name)
    for (n, _), x, y in zip(row, times, errors):
        axes.annotate(str(n), (x, y), xytext=(3, 4), textcoords="offset points", fontsize=8, color=colour)
axes.set(xlabel="time for one contact [ms]", ylabel="error of the force / ($\\mu F_n$)")
axes.legend(loc="lower left")
plt.show()

# %% [markdown]
# **How to read it.** Better is down and to the left. The simplified theory, on the left, soon stops getting better:
# beyond some 10 x 10 cells of FASTSIM2 what remains is the error of the model itself, the distance between a bed of
# springs and an elastic body. It is a few per cent of $\mu F_n$ here, and finer cells only cost time. (FASTSIM's curve
# even rises: on coarse cells its two errors happen to have opposite signs here and cancel. One cannot count on that.)
# The exact theory is a thousand times dearer and goes down as far as one likes; elements of second order get there on
# far coarser grids than classical ones.
#
# Numbers beside the points are the cells or elements in each direction.
#
# ## What to take
#
# | for | take | because |
# |---|---|---|
# | time integration of a vehicle, millions of contacts | `Fastsim2(10, 10)` | a microsecond; an error below that of the profiles and of the friction coefficient |
# | wear, fatigue, tables of forces | `Solver(theory="exact", grid=24)` | milliseconds; 0.001 of $\mu F_n$ |
# | a number to trust | `Solver(theory="exact", accuracy=1e-3)` | it says how far it may be off |
# | comparing with CONTACT | `discretisation="classical"` | the same equations, the same digits |
#
# Blended flexibilities bring the simplified theory nearer to the exact one, at no cost:

# %%
for flexibility in ("three", "blended"):
    forces = microslip.Fastsim2(20, 20, flexibility=flexibility, bound="parabolic").solve(contact)
    print(f"{flexibility:8} error {np.hypot(forces.fx - best.forces.fx, forces.fy - best.forces.fy) / limit:.4f}")

# %% [markdown]
# One contact says little about that. Over the [3,220 cases](../accuracy-exact.md#fastsim2-table1) they halve the error.
