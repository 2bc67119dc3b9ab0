# %% [markdown]
# # A measured profile to conicity and forces
#
# A wheel's profile from a measuring device, a rail, a track: is the measurement sound, where do wheel and rail touch, how
# does the wheelset steer, and what forces act on the wheel at 6 mm to the side?

# %%
import pathlib
import tempfile

import matplotlib.pyplot as plt
import microslip
import microslip.plot
import numpy as np
from microslip.picture_style import ALONG, INK3, RED, SETTINGS, SIZES, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
new = microslip.read_profile("examples/profiles/s1002.prw")
rail = microslip.read_profile("examples/profiles/60e1.prr")

# %% [markdown]
# ## The file
#
# Whoever has a file of their own writes its path below: MiniProf's `.whl` and `.ban`, Simpack's `.prw` and `.prr` and
# columns of numbers are read by the same call ([formats](../profile-formats.md)). Here the file is made: the new
# wheel, its tread worn hollow by 0.3 mm, with the scatter of 4 micrometres that an instrument leaves.

# %%
hollow = 0.3e-3 * np.exp(-((new.y / 18e-3) ** 2))
scatter = 4e-6 * np.random.default_rng(1).normal(size=new.y.size)
file = pathlib.Path(tempfile.mkdtemp()) / "measured_wheel.csv"
np.savetxt(file, 1e3 * np.column_stack([new.y, new.z + hollow + scatter]), header="y [mm],z [mm]", delimiter=",", comments="")

worn = microslip.read_profile(file, kind="wheel")
print(*worn.report.steps, *worn.report.assumptions, *worn.report.warnings, sep="\n")
flange = worn.wheel_dimensions()
print(f"flange {1e3 * flange.flange_height:.2f} mm high, {1e3 * flange.flange_thickness:.2f} mm thick")

# %% [markdown]
# The report says what was assumed, since a table of numbers does not say it, and what was done: points that scatter are
# smoothed, or the curvature, and with it the size of the contact, would be noise. How far the points moved is there, too.
# `kind`, `unit`, `y_axis`, `z_axis` and `smoothing_length` overrule it ([smoothing](../profile-smoothing.md)).

# %%
figure, (shape, change) = plt.subplots(2, 1, num="The measured wheel, and what it has lost beside the new one", figsize=(7, 5), sharex=True)
shape.plot(1e3 * new.y, 1e3 * new.z, color=INK3, label="new")
shape.plot(1e3 * worn.y, 1e3 * worn.z, color=RED, label="measured")
shape.set(ylabel="z [mm]")
shape.legend()
tread = new.y > -0.03
change.plot(1e3 * new.y[tread], 1e6 * (worn.measured_z - new.z)[tread], ".", markersize=2, color=INK3, label="points of the file")
change.plot(1e3 * new.y[tread], 1e6 * (worn.z - new.z)[tread], color=RED, label="smoothed")
change.set(xlabel="y [mm], to the field side", ylabel="higher than new [µm]")
change.legend()
plt.show()

# %% [markdown]
# ## Where they touch
#
# A track positions the rails, a wheelset the wheels. First without any load: the wheelset as a rigid body that
# touches both rails, displaced sideways. The difference of the rolling radii is what steers it.

# %%
track = microslip.Track(gauge=1.435, cant=1 / 40)
wheelset = microslip.Wheelset(nominal_radius=0.46, flange_back_distance=1.36)
geometries = {name: microslip.WheelsetGeometry(track=track, rail=rail, wheelset=wheelset, wheel=wheel)
              for name, wheel in (("new", new), ("measured", worn))}
lateral = np.linspace(-7e-3, 7e-3, 141)

figure, (above, below) = plt.subplots(2, 1, num="Rolling radius difference, and where the left wheel touches the rail",
                                      figsize=(7, 5.6), sharex=True)
for (name, geometry), colour in zip(geometries.items(), (ALONG, RED)):
    touching = geometry.contact(lateral)
    above.plot(1e3 * lateral, 1e3 * touching.rolling_radius_difference, color=colour, label=name)
    below.plot(1e3 * lateral, 1e3 * touching.left_rail_y, ".", markersize=3, color=colour)
above.set(ylabel="$r_l - r_r$ [mm]")
above.legend()
below.set(xlabel="wheelset to the left [mm]", ylabel="y on the rail [mm]")
plt.show()

# %% [markdown]
# **How to read it.** The upper curve is flat in the middle, where the wheelset is steered little, and steep from 6 mm
# on. Where it steps, the point of contact in the lower curve jumps over a part of the rail that is never touched: there
# a wheel touches at two points for a moment, and forces must be shared between them. The hollow wheel touches at both
# shoulders of its hollow, 20 mm apart, in the middle of the track.
#
# ## Conicity
#
# A wheelset that rolls along the track swings from side to side. Its equivalent conicity is that of conical wheels which
# would swing with the same wavelength; it depends on the amplitude. Wheelsets of high conicity hunt at lower speeds. What
# is printed is the value at 3 mm, by which tracks and wheels are judged.

# %%
amplitudes = np.linspace(0.5e-3, 7e-3, 66)
figure, axis = plt.subplots(num="Equivalent conicity over the amplitude (EN 15302)", figsize=(7, 3.8))
for (name, geometry), colour in zip(geometries.items(), (ALONG, RED)):
    axis.plot(1e3 * amplitudes, geometry.equivalent_conicity(amplitudes), color=colour, label=name)
    print(f"{name}: {geometry.equivalent_conicity(3e-3):.3f} at 3 mm, {geometry.wavelength(3e-3):.1f} m long waves")
axis.set(xlabel="amplitude [mm]", ylabel="equivalent conicity [-]", ylim=(0, None))
axis.legend()
plt.show()

# %% [markdown]
# **How to read it.** The hollow tread has the higher conicity at all amplitudes, since the point of contact jumps over the
# hollow and so finds a larger difference of radii. That is worst at small amplitudes. Beyond 6 mm both wheels run up
# the root of the flange.
#
# ## Forces
#
# Now with 80 kN on the measured wheel, on the left, which runs 6 mm to the left with an angle of attack of 2 mrad. The solver finds all
# patches, shares the load between them and solves friction in each. At this level a state takes a tenth of a
# millisecond:

# %%
setup = dict(track=track, rail=rail, wheelset=wheelset, wheel=worn, side="left", friction=0.3)
state = dict(lateral=6e-3, yaw=2e-3, vertical_force=80e3, forward_velocity=30.0)
fast = microslip.WheelRail(**setup).solve(**state)
exact = microslip.WheelRail(**setup, theory="exact", grid=48).solve(**state)
print("                       fastsim2       exact")
for name in ("force_x", "force_y", "force_z", "t_gamma"):
    print(f"{name:12} [N]   {getattr(fast, name):12.1f} {getattr(exact, name):12.1f}")
for k, (one, other) in enumerate(zip(fast.patches, exact.patches), 1):
    print(f"patch {k}: {1e3 * one.rail_y:.2f}, {1e3 * other.rail_y:.2f} mm on the rail, "
          f"{1e-3 * one.normal_force:.2f}, {1e-3 * other.normal_force:.2f} kN")

# %% [markdown]
# ## Tractions
#
# The exact theory's patches hold their fields, x along the track, y along the rail's surface:

# %%
figure, axes = plt.subplots(len(exact.fields), 1, num="Size of the tractions in each patch, exact theory", squeeze=False,
                            figsize=(6.5, 2.4 * len(exact.fields)))
for k, (axis, patch) in enumerate(zip(axes[:, 0], exact.fields), 1):
    cells = microslip.plot.cells_of(patch.fields)
    size = np.hypot(cells.px, cells.py)
    left, right, low, high = cells.outline.limits()
    axis.set(xlabel="x [mm], rolling to the right", ylabel="y [mm]", title=f"patch {k}", aspect="equal",
             xlim=(left - 1, right + 1), ylim=(low - 1, high + 1))
    cells.draw(axis, size, cmap=SIZES, vmin=0, vmax=size.max())
    cells.draw_outline(axis)
    figure.colorbar(axis.images[0], ax=axis, label="traction [MPa]")
plt.show()

# %% [markdown]
# ## The whole range
#
# Arrays of states broadcast. Where forces bend, the flange has begun to carry: the steep surface there pushes the wheel
# back with more and more of its load.

# %%
positions = np.linspace(-6e-3, 6.4e-3, 125)
many = microslip.WheelRail(**setup).solve_batch(lateral=positions, yaw=2e-3, vertical_force=80e3, forward_velocity=30.0)
figure, axis = plt.subplots(num="Forces on the left wheel over its lateral position, yaw 2 mrad", figsize=(7, 3.8))
axis.plot(1e3 * positions, 1e-3 * many.force_x, color=ALONG, label="longitudinal")
axis.plot(1e3 * positions, 1e-3 * many.force_y, color=SLIDES, label="lateral, to the left")
axis.axhline(0, color=INK3, linewidth=0.8)
axis.set(xlabel="wheelset to the left [mm]", ylabel="force on the wheel [kN]")
axis.legend()
plt.show()
print(f"{(many.status == microslip.Status.ok).sum()} of {len(positions)} states solved")
