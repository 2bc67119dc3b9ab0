# %% [markdown]
# # A coated roller
#
# Hard coatings of some micrometres protect bearings and gears. They come off where the bond below them is sheared too
# much, and friction at the surface does that. This tutorial asks how friction and thickness load a coating and its bond.

# %%
import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, INK3, RED, SETTINGS, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
steel = microslip.Material.from_young(210e9, 0.3)
carbon = microslip.Material.from_young(400e9, 0.25)
gap = microslip.gap_curvatures(0.005, 0.040, 0.5, np.inf)


def coated(thickness):
    """A roller with a coating of a thickness [m] on a ring of steel."""
    return microslip.LayeredBodies(microslip.LayeredBody(steel, [microslip.BodyLayer(thickness, carbon)]),
                                   microslip.LayeredBody(steel))


# %% [markdown]
# ## Pressure hardly notices
#
# Layers that are thin beside the contact bend with what is below them: pressure and size of the contact are almost
# those of steel.

# %%
solver = microslip.Solver(theory="exact", grid=(40, 20))
like = microslip.RollingProblem(bodies=coated(3e-6), gap=gap, normal_force=50, friction=0.1, rolling_speed=10.0,
                                creepage_longitudinal=2e-3)
hertz = microslip.hertz_from_load(gap, microslip.combine(steel, steel), 50)
solution = solver.solve(like)
print(f"Hertz on steel: {1e-6 * hertz.peak_pressure:.0f} MPa, semi-axis {1e6 * hertz.a:.0f} um; "
      f"coated: {1e-6 * solution.peak_pressure:.0f} MPa")

# %% [markdown]
# ## Stress below the surface
#
# The stiff coating takes more than its share of the stress along the surface: the stress jumps at the bond.

# %%
depth = np.linspace(0.1e-6, 60e-6, 120)
figure, axes = plt.subplots(num="Von Mises' stress below the middle of the contact, of steel and with coatings", figsize=(6.4, 4))
for thickness, colour in ((0, INK3), (3e-6, ALONG), (10e-6, RED)):
    bodies = coated(thickness) if thickness else microslip.LayeredBodies(microslip.LayeredBody(steel), microslip.LayeredBody(steel))
    found = solver.solve(like.replace(bodies=bodies))
    stress = found.interior_states(bodies, 0.0, 0.0, depth).von_mises[:, 0, 0]
    axes.plot(1e6 * depth, 1e-6 * stress, color=colour,
              label=f"coating of {1e6 * thickness:.0f} um" if thickness else "steel")
axes.set(xlabel="depth [um]", ylabel="von Mises' stress [MPa]")
axes.legend()
plt.show()

# %% [markdown]
# **How to read it.** The coating, twice as stiff as steel, is stretched and compressed as the steel below it is, and
# answers with twice the stress: at 3 um it jumps from 300 to 240 MPa. The largest stress of the steel below stays where
# it was.
#
# ## The bond
#
# Shear stress in the bond over the friction, in full sliding: from some friction on it is the traction at the surface
# that loads the bond.

# %%
frictions = np.linspace(0.0, 0.5, 6)
figure, axes = plt.subplots(num="Largest shear stress of the bond over the friction", figsize=(6.4, 4))
for thickness, colour in ((1e-6, SLIDES), (3e-6, ALONG), (10e-6, RED)):
    shear = []
    for mu in frictions:
        one = like.replace(bodies=coated(thickness), friction=mu, creepage_longitudinal=0.05)
        shear.append(1e-6 * microslip.layered_peaks(one.bodies, solver.solve(one)).interfaces[0].shear)
    axes.plot(frictions, shear, "o-", color=colour, label=f"coating of {1e6 * thickness:.0f} um")
axes.set(xlabel="coefficient of friction", ylabel="shear stress of the bond [MPa]", ylim=(0, None))
axes.legend()
plt.show()

# %% [markdown]
# **How to read it.** Without friction a thicker coating has the larger shear stress in its bond, which lies nearer to
# the depth where pressure shears most. With friction the traction at the surface reaches the bond, undiminished if the
# coating is thin: at 0.5 the thinnest coating is the worst off.
#
# The same case as a file for `microslip solve` is `examples/coated_roller.toml`; how layers are given is in
# [Bodies with layers](../layers.md), the formulas are in the [theory of layers](../theory-layers.md).
