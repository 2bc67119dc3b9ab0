# %% [markdown]
# # Stresses below the surface
#
# Rolling contact fatigue begins where the material is stressed most, and that is seldom on the surface. This tutorial
# takes the tractions of the exact theory, looks into the rail below them, and asks how friction moves the most stressed
# point.

# %%
import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, INK, INK3, RED, SETTINGS, SIZES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
steel = microslip.Material.from_young(210e9, 0.28)
pair = microslip.combine(steel, steel)
hertz = microslip.hertz_from_load(microslip.gap_curvatures(0.46, np.inf, np.inf, 0.3), pair, 80e3)

# %% [markdown]
# ## From tractions to stresses
#
# The interior field needs the three tractions on a regular grid of elements. `NormalProblem` gives the pressure,
# `TangentialProblem` the tangential tractions:

# %%
grid = microslip.ElementGrid.across_ellipse(hertz.a, hertz.b, 36, 36, margin=2)
normal = microslip.NormalProblem(pair, grid).solve(microslip.hertzian_gap(hertz.gap, grid), normal_force=80e3)
tangential = microslip.TangentialProblem(pair, grid)


def rail(friction, creepage):
    """The field in the rail, body 2, in steady rolling."""
    found = tangential.solve(friction * normal.pressure, creepage)
    return microslip.InteriorField(steel, 2, grid, px=found.px, py=found.py, pn=normal.pressure)


braked = rail(0.5, (0.01, 0, 0))  # the whole contact slides
alone = microslip.InteriorField(steel, 2, grid, pn=normal.pressure)

# %% [markdown]
# Points are given with their depth below the surface. Here a section along the rail, below the middle of the contact;
# von Mises' stress says how close a point is to yielding.

# %%
x, depth = np.linspace(-2 * hertz.a, 2 * hertz.a, 81), np.linspace(0.3e-3, 9e-3, 36)
figure, panels = plt.subplots(
    1, 2, num="Von Mises' stress in the rail: pressure alone, and with the wheel braked to full sliding, friction 0.5",
    figsize=(10, 3.6), sharey=True)
for axes, field, title in zip(panels, (alone, braked), ("pressure alone", "full sliding, friction 0.5")):
    stress = 1e-6 * field.at(x, 0.0, depth[:, None]).von_mises
    drawn = axes.contourf(1e3 * x, -1e3 * depth, stress, levels=np.arange(0, 1051, 75), cmap=SIZES, extend="max")
    axes.plot([-1e3 * hertz.a, 1e3 * hertz.a], [0, 0], color=INK, linewidth=4)
    axes.set(xlabel="x [mm], rolling to the right", title=title, aspect="equal")
panels[0].set_ylabel("z [mm]")
figure.colorbar(drawn, ax=panels, label="[MPa]")
plt.show()

# %% [markdown]
# **How to read it.** The black bar is the contact. Left: pressure alone stresses the rail most well below the surface,
# where the load already shears the material but no longer squeezes it from all sides. Right: the braked wheel drags the
# rail's surface forward; a second, larger maximum appears at the surface, and the field leans.
#
# ## Where is the worst point?
#
# `find_largest` searches it: first in planes, then from the best of their points. Nearer to the surface than about
# three quarters of an element the steps between the elements are felt, so that is where the search begins.

# %%
top = 0.75 * grid.dx
planes = np.linspace(top, 5e-3, 10)
frictions = np.linspace(0, 0.6, 9)
peaks = [microslip.InteriorLayers(rail(mu, (0.02, 0, 0)) if mu > 0 else alone).find_largest(planes) for mu in frictions]
for mu, peak in list(zip(frictions, peaks))[::2]:
    print(f"friction {mu:.2f}: {1e-6 * peak.value:4.0f} MPa at x = {1e3 * peak.x:5.2f} mm, "
          f"{1e3 * peak.depth:.2f} mm deep")

figure, (left, right) = plt.subplots(
    1, 2, num="The largest stress in the rail over the coefficient of friction, in full sliding: how large, how deep",
    figsize=(9.5, 3.6))
left.plot(frictions, [1e-6 * peak.value for peak in peaks], "o-", color=RED)
left.set(xlabel="coefficient of friction", ylabel="largest von Mises' stress [MPa]", ylim=(0, None))
right.plot(frictions, [1e3 * peak.depth for peak in peaks], "o-", color=ALONG)
right.axhline(1e3 * top, linestyle=":", color=INK3)
right.set(xlabel="coefficient of friction", ylabel="its depth [mm]", ylim=(0, None))
plt.show()

# %% [markdown]
# **How to read it.** Up to a friction of about 0.4 the worst point stays inside and its stress hardly changes. Beyond,
# it jumps to the surface (the dotted line is where the search begins) and grows with friction. That is the old rule
# that dry rails crack from the surface and lubricated ones from within.
#
# Stresses on the surface itself, and how near to it the field is to be trusted, are treated in
# [inside the bodies](../theory-interior.md).
