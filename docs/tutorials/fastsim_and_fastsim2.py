# %% [markdown]
# # FASTSIM against FASTSIM2
#
# Both solve the same equations, the simplified theory, by marching particles through the contact. FASTSIM (Kalker 1982)
# takes steps of first order, FASTSIM2 (Vollebregt and Wilders 2010) of second order. What difference does that make,
# and how many cells does one need?
#
# Two errors are in play, and it helps to keep them apart: the **discretisation error**, which finer cells make smaller,
# and the **model error** of the simplified theory, which no grid removes. This tutorial is about the first;
# [accuracy and cost](accuracy_and_cost.py) is about both.

# %%
import time

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, GREEN, INK3, RED, SETTINGS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})

# %% [markdown]
# ## One contact, row by row
#
# The difference is easily seen with spin, where the direction of the slip turns on the particle's path. First 8 x 8
# cells of each, beside 200 x 200 of FASTSIM2, all along the row next to the middle:

# %%
contact = microslip.EllipticContact(6e-3, 6e-3, 82e9, 0.28, 82e3, 0.3, (0.001, 0, 0.6))
rows = {"FASTSIM, 8 x 8": (microslip.Fastsim(8, 8), RED, "s-"),
        "FASTSIM2, 8 x 8": (microslip.Fastsim2(8, 8), ALONG, "o-"),
        "FASTSIM2, 200 x 200": (microslip.Fastsim2(200, 200), INK3, "-")}
figure, panels = plt.subplots(
    1, 2, num="Tractions of coarse grids along a row 0.75 mm beside the middle",
    figsize=(9.5, 3.8))
for name, (solver, colour, style) in rows.items():
    cells = solver.fields(contact).fields
    row = np.argmin(np.abs(cells.y[:, 0] - 0.75e-3))
    for axes, values in zip(panels, (cells.px, cells.py)):
        axes.plot(1e3 * cells.x[row], 1e-6 * values[row], style, color=colour, markersize=4, label=name)
for axes, label in zip(panels, ("$p_x$ [MPa]", "$p_y$ [MPa]")):
    axes.set(xlabel="x [mm], rolling to the right", ylabel=label)
panels[0].legend()
plt.show()

# %% [markdown]
# **How to read it.** FASTSIM's tractions rise too early: in its first cell it takes a full step where the particle has
# only come half as far, and its slip belongs to the wrong end of the step. FASTSIM2's points lie on the fine curve,
# but for the last one, in whose step slip begins.
#
# ## Many contacts
#
# One case can mislead. Here are 300 random ones, with ellipses from five times longer than wide to the reverse, of all
# creepages at which the contact neither sticks nor slides fully. Errors are against 320 x 320 cells of FASTSIM2, in
# units of $\mu F_n$, as root mean squares.

# %%
random = np.random.default_rng(1)
count = 300
a = 6e-3 * np.exp(random.uniform(-0.8, 0.8, count))
b = 36e-6 / a
angle, size = random.uniform(0, 2 * np.pi, count), random.uniform(0.3, 3, count)
creepages = {"longitudinal": 8e-4 * size * np.cos(angle), "lateral": 8e-4 * size * np.sin(angle),
             "spin": random.normal(0, 0.15, count)}
limit = 0.3 * contact.normal_force


def forces(solver):
    """Fx and Fy of all contacts over mu Fn, and the time for it [s]."""
    begin = time.perf_counter()
    found = solver.solve_batch(contact, **creepages, a=a, b=b, threads=1)
    passed = time.perf_counter() - begin
    return np.array([found.fx, found.fy]) / limit, passed


reference, _ = forces(microslip.Fastsim2(320, 320))
grids = np.array([5, 10, 20, 40, 80])
methods = {"FASTSIM": (microslip.Fastsim, {}, RED, "s-"),
           "FASTSIM, half first step": (microslip.Fastsim, {"half_first_step": True}, GREEN, "^-"),
           "FASTSIM2": (microslip.Fastsim2, {}, ALONG, "o-")}
errors = {}
print("rms error of the force  " + "".join(f"{n:>4} x {n:<3}" for n in grids))
for name, (kind, options, _, _) in methods.items():
    errors[name] = [np.sqrt(np.mean((forces(kind(n, n, **options))[0] - reference) ** 2)) for n in grids]
    print(f"{name:24}" + "".join(f"{error:10.5f}" for error in errors[name]))

# %%
figure, axes = plt.subplots(
    num="Discretisation errors over the number of cells in each direction",
    figsize=(6.5, 4.2))
for name, (_, _, colour, style) in methods.items():
    axes.loglog(grids, errors[name], style, color=colour, label=name)
for order, start in ((1, 0.06), (2, 0.006)):
    line = start * (grids[0] / grids) ** float(order)
    axes.loglog(grids, line, ":", color=INK3)
    axes.annotate(f"order {order}", (grids[-1], line[-1]), color=INK3, xytext=(4, 0), textcoords="offset points")
axes.set(xlabel="cells in each direction", ylabel="rms error / ($\\mu F_n$)", xlim=(4.5, 130))
axes.set_xticks(grids, [str(n) for n in grids])
axes.minorticks_off()
axes.legend()
plt.show()

# %% [markdown]
# **How to read it.** On logarithmic scales an error of order $p$ is a straight line of slope $-p$. FASTSIM halves its
# error when the cells are halved; FASTSIM2 quarters it. On 10 x 10 cells FASTSIM2 is better than FASTSIM on 80 x 80,
# with a sixty-fourth of the cells. The middle line shows what a better first step alone is worth.
#
# The model error of the simplified theory is some 0.03, so for forces alone 10 x 10 cells of FASTSIM2 are enough; take
# more for tractions and areas.
#
# ## What it costs

# %%
for name, solver in (("FASTSIM, 80 x 80", microslip.Fastsim(80, 80)),
                     ("FASTSIM2, 10 x 10", microslip.Fastsim2(10, 10))):
    fastest = min(forces(solver)[1] for _ in range(5))
    print(f"{name:18} {1e6 * fastest / count:6.1f} microseconds a contact")

# %% [markdown]
# Times are those of the machine that built this page. [Performance](../performance.md) measures them with care,
# [accuracy](../accuracy.md) repeats the paper's statistics on its 3,220 cases.
