# %% [markdown]
# # Wear of a profile
#
# A wheel wears where it slides: on the tread everywhere a little, at the flange's root in curves. What it loses changes
# where it touches, and so where it wears next. This tutorial takes that round once with all its parts in view, and then
# uses `examples/wear/wear.py`, which goes on for thousands of kilometres.

# %%
import sys

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, INK3, RED, SETTINGS, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
sys.path.append("examples/wear")
import wear

new = microslip.read_profile("examples/profiles/s1002.prw")

# %% [markdown]
# ## One contact
#
# Archard's law: the volume worn off is $k\,F\,s/H$, load times sliding distance over hardness, with a coefficient $k$
# that depends on how fast the surfaces slide and how hard they are pressed. The tribologists at KTH measured it; their map
# is what `wear_depth` uses for each element ([formulas](../theory-wear-and-fatigue.md)).

# %%
contact = wear.pair(new)
solution = contact.solve(lateral=3e-3, yaw=1.5e-3, vertical_force=80e3, forward_velocity=30.0)
solution

# %% [markdown]
# `worn_area` is the cross-section that this patch takes off a wheel, per passage. In the patch, depth is lost where
# it slips. Summed along the rows it is what a point of the wheel loses each turn:

# %%
patch, fields = solution.patches[0], solution.fields[0]
depth = microslip.wear_depth(fields, hardness=3e9, rolling_speed=patch.rolling_speed).sum(axis=1)
figure, axis = plt.subplots(num="Depth that one passage takes off, across the wheel", figsize=(6.5, 3.4))
axis.plot(1e3 * fields.fields.y[:, 0], 1e9 * depth, color=RED)
axis.set(xlabel="y in the patch [mm]", ylabel="depth [nm]")
plt.show()
print(f"a turn takes off {1e9 * depth.max():.2f} nm at most: {1e-3 * 50e-6 / depth.max() * 2 * np.pi * 0.46:.0f} km for 0.05 mm at that point")

# %% [markdown]
# ## Many contacts
#
# A wheel does not stay at one position. Its service is a distribution of states: here lateral positions about the
# track's centre, turned to either side alike. Each contributes by its share of the distance.

# %%
of = wear.service()
before, area = wear.wear_per_metre(new, of=of)
s = 1e3 * wear.BIN * np.arange(len(before))
figure, axis = plt.subplots(num="Depth per 1000 km along the new profile, and after smoothing", figsize=(7, 3.4))
axis.plot(s, 1e3 * 1e6 * before, color=INK3, linewidth=0.8, label="as computed")
axis.plot(s, 1e3 * 1e6 * wear.smoothed(before), color=ALONG, label="smoothed")
axis.set(xlabel="length along the profile [mm]", ylabel="depth [mm]")
axis.legend()
plt.show()
print(f"{1e12 * area:.0f} mm^2 per 1000 km")

# %% [markdown]
# Smoothing stands for all the states between those that were computed. Without it, peaks would feed on themselves.
#
# ## The profile that is left
#
# The depth is taken off along the normal, at most 0.05 mm before contacts are computed anew:

# %%
profile, gone, total = new, 0.0, 0.0
stations = [(0.0, new)]
for _ in range(3):
    rate = wear.smoothed(wear.wear_per_metre(profile, of=of)[0])
    step = wear.DEEPEST_STEP / rate.max()
    profile, total = wear.worn(profile, step * rate), total + step
    stations.append((total, profile))
figure, axis = plt.subplots(num="What is worn off the profile, along z", figsize=(7, 3.4))
for (distance, worn), colour in zip(stations[1:], (ALONG, SLIDES, RED)):
    common = np.linspace(-0.035, 0.04, 400)
    old_z, new_z = (np.interp(common, p.y, p.z) for p in (new, worn))
    axis.plot(1e3 * common, 1e3 * np.abs(new_z - old_z), color=colour, label=f"{1e-3 * distance:.0f} km")
axis.set(xlabel="y on the wheel [mm]", ylabel="worn off [mm]")
axis.legend()
plt.show()
flange = profile.wheel_dimensions()
print(f"flange {1e3 * flange.flange_height:.2f} mm high, {1e3 * flange.flange_thickness:.2f} mm thick")

# %% [markdown]
# `examples/wear/wear.py` goes on to 3000 km and writes the profiles, `examples/wear/plot.py` draws them
# ([picture](../wheel-on-rail.md#wear-fatigue-guidance)). Dry steel, as here, wears several times faster than a wheel in
# service, which runs in rain and on grease for part of its mileage.
