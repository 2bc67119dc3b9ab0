# %% [markdown]
# # First contact
#
# A wheel stands on a rail and rolls, a little slower than it should: it is braked. How large is the contact, what force
# does the rail give, and where in the contact does it arise? This tutorial goes from two radii and a load to the
# tractions in the contact.
#
# Frame and signs are those of all pages ([conventions](../conventions.md)): x along the rolling direction, y to the
# left, forces on body 1, the wheel.

# %%
import math

import matplotlib.pyplot as plt
import microslip
import numpy as np
from matplotlib.patches import Patch
from microslip.picture_style import ALONG, INK, RED, SETTINGS, SLIDES, STICKS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})

# %% [markdown]
# ## The ellipse
#
# Under load the bodies flatten where they touch. Hertz's theory says how far, if both are smooth, curved and much
# larger than the contact. It needs the materials and four radii: along the rail the wheel has its rolling radius and
# the rail is straight (infinite); across the rail the wheel is taken as straight and the rail's head has a radius of
# 300 mm.

# %%
steel = microslip.Material.from_young(210e9, 0.28)  # Pa, -
pair = microslip.combine(steel, steel)
gap = microslip.gap_curvatures(rolling1=0.46, rolling2=math.inf, transverse1=math.inf, transverse2=0.3)
hertz = microslip.hertz_from_load(gap, pair, normal_force=80e3)
print(f"semi-axes      a = {1e3 * hertz.a:.2f} mm along x, b = {1e3 * hertz.b:.2f} mm along y")
print(f"peak pressure  {1e-6 * hertz.peak_pressure:.0f} MPa")
print(f"approach       {1e6 * hertz.approach:.0f} micrometres")

# %% [markdown]
# Eight tonnes stand on an area as large as a fingernail. The pressure there is far above the strength that steel has in
# a tension test; it holds because it is squeezed from all sides.
#
# ## The forces
#
# A braked wheel turns more slowly than it advances, so its surface is dragged forward over the rail: longitudinal
# creepage $\xi > 0$, here 1.8 mm for each metre rolled. There is a little lateral creepage $\eta$ too, and spin $\phi$,
# a turning about the vertical, because the contact plane is inclined.
#
# FASTSIM2 finds the forces in a microsecond:

# %%
contact = microslip.EllipticContact(hertz.a, hertz.b, pair.shear_modulus, pair.poisson_ratio, normal_force=80e3,
                                    friction=0.3, creepage=(0.0018, 0.0006, 0.4), rolling_speed=30.0)
forces = microslip.Fastsim2().solve(contact)
limit = 0.3 * 80e3
print(f"Fx = {forces.fx:.0f} N, Fy = {forces.fy:.0f} N, Mz = {forces.mz:.1f} N m")
print(f"|F| is {math.hypot(forces.fx, forces.fy) / limit:.0%} of the friction limit")
print(f"{forces.slip_area / (forces.slip_area + forces.adhesion_area):.0%} of the contact slips")

# %% [markdown]
# The force is against the creepage: $\xi > 0$ gives $F_x < 0$, the rail holds the wheel back. It is below the friction
# limit $\mu F_n$, and yet a part of the contact slips. How can that be?
#
# ## Where it slips
#
# `fields` gives the tractions of every cell.

# %%
cells = microslip.Fastsim2(40, 40).fields(contact).fields
state = np.asarray(cells.state)
figure, axes = plt.subplots(
    num="Adhesion (blue) and slip (orange); arrows are the tractions on the wheel",
    figsize=(6.5, 4.6))
drawn = microslip.plot.cells_of(cells, (contact.a, contact.b))
axes.set(xlim=(-7, 7), ylim=(-5.5, 5.5), aspect="equal")
drawn.draw_areas(axes)
drawn.draw_boundary(axes)
drawn.draw_outline(axes)
longest = np.hypot(drawn.px, drawn.py).max()
axes.quiver(*drawn.arrows(drawn.px, drawn.py, longest), color=INK, width=0.004, pivot="middle", zorder=4, angles="xy",
            scale_units="xy", scale=longest / drawn.arrow_length())
axes.legend(handles=[Patch(color=STICKS, label="sticks"), Patch(color=SLIDES, label="slides")], loc="upper left",
            bbox_to_anchor=(1, 1))
axes.set(xlabel="x [mm], rolling to the right", ylabel="y [mm]")
plt.show()

# %% [markdown]
# **How to read it.** The contact rolls to the right. A particle enters on the right, at the leading edge, without any
# traction. While it travels to the left through the contact, both surfaces stick together, and because the wheel creeps
# over the rail they shear each other more and more: the arrows grow. At some point the traction would be more than
# friction can bear, and the particle slips for the rest of its path. So there is always slip at the rear, at any
# creepage, and with more creepage it begins earlier. With spin the picture is not symmetric.
#
# A cut along y = 0 shows the same as a curve:

# %%
row = len(state) // 2
figure, axes = plt.subplots(num="Tractions along the middle of the contact, under their bound", figsize=(6.5, 3.6))
x = 1e3 * cells.x[row]
axes.plot(x, 1e-6 * cells.bound[row], color=INK, label="bound, $\\mu p_n$")
size = 1e-6 * np.hypot(cells.px[row], cells.py[row])
axes.plot(x, size, color=RED, linewidth=2.5, label="size of the traction")
axes.plot(x, -1e-6 * cells.px[row], "--", color=ALONG, label="$-p_x$")
axes.set(xlabel="x [mm], rolling to the right", ylabel="traction [MPa]")
axes.legend()
plt.show()

# %% [markdown]
# From the right, the traction grows until it meets the bound, and follows it down to the left. Its longitudinal part
# grows in a straight line, as the creepage that causes it is the same everywhere. FASTSIM2 finds the point where it
# meets the bound inside of a step: that is why it needs so few cells.
#
# ## The exact theory
#
# FASTSIM2 takes the surface for a bed of springs that do not know of each other. The exact theory takes the bodies for
# what they are, elastic half-spaces:

# %%
exact = microslip.Solver(theory="exact", grid=24).solve(contact)
print(f"FASTSIM2  Fx = {forces.fx:.0f} N, Fy = {forces.fy:.0f} N, Mz = {forces.mz:.1f} N m")
print(f"exact     Fx = {exact.forces.fx:.0f} N, Fy = {exact.forces.fy:.0f} N, Mz = {exact.forces.mz:.1f} N m")

# %% [markdown]
# The forces differ by some per cent of $\mu F_n$. That is the price of the bed of springs; the exact solution costs
# some milliseconds. [Accuracy and cost](accuracy_and_cost.py) has more on that choice, [creep curves](creep_curves.py)
# goes on from here.
