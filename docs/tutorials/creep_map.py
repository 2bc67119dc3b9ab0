# %% [markdown]
# # A creep map with arrays
#
# How much force does a wheel have left for steering while it brakes? One curve does not say: the answer is a surface
# over longitudinal and lateral creepage. Here it is computed in one call, and taken apart as a labelled table.

# %%
import copy

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import INK, SETTINGS, SIGNED

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
contact = copy.copy(microslip.read_case("examples/hertzian_contact.toml").contact)
contact

# %% [markdown]
# ## One call
#
# Creepages broadcast as numpy's arrays do: a column of longitudinal ones and a row of lateral ones make a map. Spin
# stays that of a contact plane inclined by a tenth.

# %%
longitudinal = np.linspace(-6e-3, 6e-3, 121)
lateral = np.linspace(-6e-3, 6e-3, 121)
solver = microslip.Fastsim2(flexibility="blended")
forces = solver.solve_batch(contact, longitudinal[:, None], lateral[None, :], spin=0.2)
forces.fx.shape, np.unique(forces.status)

# %% [markdown]
# ## What is left for steering
#
# The larger the braking force, the smaller the lateral force that the same lateral creepage gives.

# %%
limit = 0.3 * contact.normal_force
figure, axes = plt.subplots(1, 2, num="Longitudinal and lateral force over both creepages, spin .2 /m", figsize=(10, 4.2))
for ax, force, name in zip(axes, (forces.fx, forces.fy), ("F_x", "F_y")):
    drawn = ax.contourf(1e3 * longitudinal, 1e3 * lateral, force.T / limit, levels=np.linspace(-1, 1, 21), cmap=SIGNED)
    ax.contour(1e3 * longitudinal, 1e3 * lateral, force.T / limit, levels=[0], colors=INK, linewidths=0.8)
    ax.set(xlabel="longitudinal creepage [$10^{-3}$]", ylabel="lateral creepage [$10^{-3}$]", title=f"${name}/(\\mu F_n)$")
figure.colorbar(drawn, ax=axes, ticks=np.linspace(-1, 1, 5))
plt.show()

# %% [markdown]
# **How to read it.** Left, $F_x$ hardly depends on the lateral creepage near the centre, and falls with it outside,
# where both share the friction. Right, the line of $F_y = 0$ does not pass through the centre: spin alone pushes the
# wheel sideways, and it takes some lateral creepage to hold against it.
#
# ## As a table
#
# `to_dataframe()` makes a table for pandas, a row for each contact; `to_xarray()` a dataset with the dimensions kept
# and units attached. Both packages are optional; `to_dict()` needs numpy alone.

# %%
try:
    data = forces.to_xarray().assign_coords(dim_0=1e3 * longitudinal, dim_1=1e3 * lateral)
    data = data.rename(dim_0="longitudinal", dim_1="lateral")
    used = np.hypot(data.fx, data.fy) / limit
    print("friction used at lateral creepage 2e-3:")
    for xi in (0, 1, 2, 4):
        print(f"  longitudinal {xi}e-3: {float(used.sel(longitudinal=xi, lateral=2, method='nearest')):.3f}")
except ImportError as error:
    print(error)

# %% [markdown]
# Derivatives of all these forces come from `differentiate_batch`; the same map by the exact theory from
# `Solver(theory="exact", grid=24).solve_batch`, and from a table of the exact theory from `CreepForceTable().solve_batch`
# ([which theory, at which price](../which-theory.md)).
