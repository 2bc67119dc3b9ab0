# %% [markdown]
# # From a test to a friction law
#
# A twin disc or a locomotive has been measured: adhesion coefficients over creepage, at one or more speeds. A model of
# it needs a coefficient of friction, how friction falls with slip, and why the curve is flatter than theory at small
# creepages. This tutorial finds the numbers, says how certain they are, and uses them.

# %%
import csv
import pathlib
import tempfile

import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import INK3, SERIES, SETTINGS

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
with open("examples/creep_curve.csv", newline="") as file:
    rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
runs = {}
for row in rows:
    runs.setdefault(row["run"], []).append((float(row["creepage_longitudinal [%]"]), -float(row["force [kN]"]) / 100))
runs = {name: np.array(points).T for name, points in runs.items()}
print({name: points.shape[1] for name, points in runs.items()}, "points, creepages to", max(points[0].max() for points in runs.values()), "%")

# %% [markdown]
# Columns have their units in brackets; a column `run` separates days, discs or states of the surfaces, and columns for
# speed and load belong to each point. The case file has the bodies and the theory.
#
# ## Which law?
#
# `fit_creep_curve` fits every model that the theory knows, from Coulomb's law to reduced slopes with falling friction,
# and compares them by what they leave of the points and by how many numbers they need for it.

# %%
fitted = microslip.fit_creep_curve("examples/creep_curve.csv", "examples/creep_curve.toml")
least = min(model["aicc"] for model in fitted["models"] if model["solved"])
for model in fitted["models"]:
    if model["solved"]:
        print(f"{model['model']:24} {model['free_parameters']} parameters   rms {model['rms']:.4f}   AICc above the best {model['aicc'] - least:6.1f}")
print(f"taken: {fitted['model']}, rms {fitted['rms']:.4f}")

# %% [markdown]
# **How to read it.** Coulomb's law misses the points by more than twice what the best models leave, which is the scatter
# of the measurement. A model within 2 of the best AICc is as good; of these the one with the fewest numbers is taken.
#
# ## How certain are the numbers?

# %%
for name, found in fitted["parameters"].items():
    low, high = found["interval"]
    certain = "held" if found["held"] else f"95 %: {low:.4g} to {high:.4g}" + ("" if found["identified"] else ", not identified")
    print(f"{name:40} {found['value']:8.4g} {found['unit']:4} {certain}")
more = fitted["further_measurement"]
print(f"{more['points']} points more at {100 * more['creepage'][0]:.2g} to {100 * more['creepage'][1]:.2g} % creepage and "
      f"{more['rolling_speed']} m/s would narrow the interval of {more['parameter']} to {more['relative_width']:.2f} of it")

# %% [markdown]
# An interval that is as wide as the number itself means that the test does not tell it. What is held is not told by these
# points: the ratio needs speeds that differ more. Friction of each run has a number of its own, all else is shared.
#
# ## Use it
#
# `case` is the text of a case file with the fitted numbers, and with the friction of the first run. From it the curve at a
# speed that was not measured:

# %%
case = microslip.parse_case(fitted["case"], "fitted case")
creepages = np.geomspace(5e-4, 0.15, 60)
solver = microslip.Solver(case.method)
forces = solver.solve_batch(case.problem, creepages, 0, 0).forces.fx
figure, axes = plt.subplots(num="Measured points, and the fitted case at 10 m/s", figsize=(6.5, 4))
for (name, (creepage, coefficient)), colour in zip(runs.items(), SERIES[3:]):
    axes.plot(creepage, coefficient, ".", color=colour, label=name)
axes.plot(100 * creepages, -forces / case.contact.normal_force, color=INK3, label="fitted, 10 m/s")
axes.set(xscale="log", xlabel="creepage [%]", ylabel="adhesion coefficient [-]", ylim=(0, None))
axes.legend()
plt.show()

# %% [markdown]
# ## Points of one's own
#
# Two discs in place of wheel and rail are another case file, `examples/twin_disc.toml`: radii, material, load, speed. The
# points are a table with two columns. Here it is made, nine creepages, each three times, as discs with a coefficient of
# 0.42 give them and with a scatter of 0.01; whoever has measured writes the path of their file below.

# %%
folder = pathlib.Path(tempfile.mkdtemp())
discs = pathlib.Path("examples/twin_disc.toml").read_text().replace('theory = "exact"\ngrid = 40', 'theory = "fastsim2"')
(folder / "discs.toml").write_text(discs)

case = microslip.read_case(folder / "discs.toml")
creepages = np.repeat([0.001, 0.002, 0.003, 0.005, 0.0075, 0.01, 0.02, 0.03, 0.05], 3)
surfaces = case.problem.replace(friction=microslip.FrictionLaw.coulomb(0.42))
forces = microslip.Solver(case.method).solve_batch(surfaces, creepages, 0, 0).forces.fx
coefficients = -forces / case.contact.normal_force + 0.01 * np.random.default_rng(2).normal(size=creepages.size)
np.savetxt(folder / "points.csv", np.column_stack([creepages, coefficients]), header="creepage_longitudinal,adhesion_coefficient",
           delimiter=",", comments="")

fitted = microslip.fit_creep_curve(folder / "points.csv", folder / "discs.toml")
found = fitted["parameters"]["friction.static_coefficient"]
print(f"{fitted['model']}: {found['value']:.3f}, 95 %: {found['interval'][0]:.3f} to {found['interval'][1]:.3f}")

# %% [markdown]
# Coulomb's law is enough. Whether friction falls at higher slip this test cannot tell: 5 % of 1 m/s are 50 mm/s. For that
# discs have to run faster, at two speeds or more, with a column `rolling_speed`.
#
# The same without Python: `microslip fit POINTS.csv --case CASE.toml -o FOLDER` prints all of this, draws the curves with
# their bands and writes the case file ([fits of measured creep curves](../creep-curve-fits.md)).
