# %% [markdown]
# # The exact theory
#
# The exact theory takes both bodies as elastic half-spaces: a traction anywhere moves the surface everywhere. So
# nothing has to be assumed about the contact area or about springs, and shapes that are no ellipses, histories and
# prescribed forces can be treated. This tutorial shows three things that the simplified theory cannot do.

# %%
import copy

import matplotlib.pyplot as plt
import microslip
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from microslip.picture_style import ALONG, GREEN, INK, INK3, RED, SETTINGS, SIZES, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
case = microslip.read_case("examples/hertzian_contact.toml")
contact = copy.copy(case.contact)  # to be changed below
limit = 0.3 * contact.normal_force
solver = microslip.Solver(theory="exact", grid=32)

# %% [markdown]
# ## Forces given
#
# In a measurement one knows the force, not the creepage. A force may be prescribed instead of the creepage in its direction:
# the creepage is then found.

# %%
solved = solver.solve(microslip.RollingProblem(contact, force_longitudinal=-0.5 * limit))
print(f"Fx = {solved.forces.fx:.1f} N at xi = {solved.creepage.longitudinal:.6f}")
print(f"residual {solved.residual:.1e} after {solved.newton_steps} Newton steps; status {solved.forces.status.name}")
beyond = solver.solve(microslip.RollingProblem(contact, force_longitudinal=-1.1 * limit))
share = np.hypot(beyond.forces.fx, beyond.forces.fy) / limit
print(f"more than friction can bear: status {beyond.forces.status.name}, |F| = {share:.3f} mu Fn")

# %% [markdown]
# Look at `status`, always. Not converging, or a force beyond the friction limit, is no exception in microslip: the
# result says so.
#
# ## How steady rolling comes about
#
# Steady rolling is a limit. A contact that begins to roll from nothing needs some distance until its tractions no longer
# change: how long? Transient rolling goes step by step and keeps the history.

# %%
contact.creepage = (0.0018, 0.0006, 0.4)
steps, length = 72, contact.a / 16
transient = solver.solve(microslip.RollingProblem(contact, kind="transient", step=length, steps=steps))
steady = microslip.Solver(theory="exact", grid=32, discretisation="classical").solve(contact)
distance = length * np.arange(1, steps + 1) / contact.a
figure, axes = plt.subplots(num="Forces while the contact rolls its first lengths", figsize=(6.5, 3.8))
for name, colour in (("fx", ALONG), ("fy", SLIDES)):
    history = [-getattr(step.forces, name) / limit for step in transient.history]
    axes.plot(distance, history, ".-", color=colour, label=f"$-F_{name[1]}$")
    axes.axhline(-getattr(steady.forces, name) / limit, linestyle=":", color=colour, label=f"$-F_{name[1]}$, steady")
axes.set(xlabel="distance rolled / a", ylabel="force / ($\\mu F_n$)")
axes.legend(ncols=2)
plt.show()

# %% [markdown]
# **How to read it.** After one length of the contact ($2a$) most of the force is there; after two of them the rest has
# gone. So a vehicle model may take steady rolling as long as creepages change slowly over some centimetres.
# Corrugation, with waves of that length, is where it may not.
#
# ## Any shape
#
# Worn profiles touch in areas that are no ellipses, or in two areas at once. A `RollingProblem` takes any undeformed
# distance `gap` between the surfaces, given at the centres of a regular grid. Here: a rail with a shallow groove along
# the middle of its running surface.

# %%
steel = microslip.Material.from_young(210e9, 0.28)
pair = microslip.combine(steel, steel)
mx, my, size = 72, 72, 0.25e-3
grid = microslip.ElementGrid(mx, my, -(mx - 1) / 2 * size, -(my - 1) / 2 * size, size, size)
smooth = microslip.hertzian_gap(microslip.gap_curvatures(0.46, np.inf, np.inf, 0.3), grid)
groove = 30e-6 * np.exp(-((grid.y[:, None] - 0.8e-3) / 1.5e-3) ** 2) + 0 * grid.x[None, :]
without = microslip.RollingProblem(gap=smooth, grid=grid, bodies=pair, normal_force=80e3, friction=0.3, rolling_speed=20.0,
                                   creepage_longitudinal=0.0018, creepage_lateral=0.0006, spin=0.4)
ellipse = solver.solve(without)
patch = solver.solve(without.replace(gap=smooth + groove))
print(f"smooth rail   Fx = {ellipse.forces.fx:.0f} N, Fy = {ellipse.forces.fy:.0f} N")
print(f"with groove   Fx = {patch.forces.fx:.0f} N, Fy = {patch.forces.fy:.0f} N, status {patch.forces.status.name}")
print(f"largest pressure: {1e-6 * patch.peak_pressure:.0f} MPa with the groove, "
      f"{1e-6 * ellipse.peak_pressure:.0f} MPa without")

# %%
figure, (left, right) = plt.subplots(
    1, 2, num="Two contact patches beside a groove: pressure, and traction over its bound",
    figsize=(10, 4), sharey=True)
drawn = microslip.plot.cells_of(patch.fields)
share = np.hypot(drawn.px, drawn.py) / np.where(drawn.bound > 0, drawn.bound, np.inf)
for axes in (left, right):
    axes.set(xlabel="x [mm], rolling to the right", aspect="equal", xlim=(-9, 9), ylim=(-8, 8))
for axes, values, colours, label, highest in ((left, drawn.pressure, SIZES, "pressure [MPa]", drawn.pressure.max()),
                                              (right, share, SIZES, "traction / bound: 1 is slip", 1)):
    scale = ScalarMappable(Normalize(0, highest), colours)
    drawn.draw(axes, values, vanishes=axes is left, cmap=colours, norm=scale.norm)
    drawn.draw_outline(axes)
    figure.colorbar(scale, ax=axes, label=label)
left.set_ylabel("y [mm]")
plt.show()

# %% [markdown]
# **How to read it.** Left: the groove cuts the contact in two, each part with a larger pressure than the smooth rail
# has anywhere. Right: each patch has a leading edge, where tractions begin at zero, and a slip area. The
# sum of the forces is yet within a per cent of that of the smooth rail. That is a common finding: **total forces
# forgive a wrong shape; stresses and wear do not.**
#
# The grid must be larger than the contact; if the contact reaches its border the result says so. How it is all solved
# is told in [the theory](../theory-exact.md).
