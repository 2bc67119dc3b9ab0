# %% [markdown]
# # A rubber-covered roller
#
# Rollers with rubber covers press, print, coat and pull. Whoever runs one asks: how wide is the nip, how much does the
# cover give way, how much faster does the other roller turn, what does it cost in power? This tutorial answers from the
# hardness of the rubber.

# %%
import matplotlib.pyplot as plt
import microslip
import numpy as np
from microslip.picture_style import ALONG, RED, SETTINGS, SLIDES

plt.rcParams.update({**SETTINGS, "figure.constrained_layout.use": True})
steel = microslip.Material.from_young(210e9, 0.28)
radius1, radius2, speed = 0.1, 0.15, 5.0


def covered(hardness, thickness, relaxation=((0.15, 0.5e-3), (0.1, 20e-3))):
    """A steel roller on one whose cover has a Shore A hardness and a thickness [m]; the shares of its modulus relax."""
    young = microslip.young_modulus_of_shore_a(hardness)
    rubber = microslip.ViscoelasticMaterial(microslip.Material.from_young(young, 0.499), list(relaxation), [])
    cover = microslip.LayeredBody(steel, [microslip.BodyLayer(thickness, rubber)])
    return microslip.LayeredBodies(microslip.LayeredBody(steel), cover, speed)


# %% [markdown]
# Rubber hardly changes its volume: Poisson's ratio is 0.499, and 0.5 is allowed, too. Gent's relation makes a modulus
# of the hardness; two readings of one rubber easily differ by 5 Shore A, so the results are as good as that.
#
# ## The nip
#
# Cylinders with parallel axes have no curvature across: `GapCurvatures(A, 0)`. Loads and forces are those of a metre
# along the axes. Body 1 is the steel roller, on which forces act.

# %%
problem = microslip.RollingProblem(
    bodies=covered(60, 15e-3), gap=microslip.GapCurvatures(0.5 * (1 / radius1 + 1 / radius2), 0), normal_force=10e3,
    friction=0.6, force_longitudinal=0, rolling_speed=speed)
solver = microslip.Solver(theory="exact", grid=80)
solution = solver.solve(problem)
nip = microslip.nip_of(problem, solution, radius1, radius2)
print(f"nip {1e3 * nip.width:.1f} mm, peak pressure {1e-6 * nip.peak_pressure:.2f} MPa, indentation "
      f"{1e3 * nip.indentation:.2f} mm: {100 * nip.body2.strain:.0f} % of the cover")
print(f"hysteresis {nip.hysteresis_power:.0f} W, slip {nip.slip_power:.1f} W, rolling resistance "
      f"{nip.rolling_resistance:.0f} N")

# %% [markdown]
# `force_longitudinal=0` lets the steel roller run free. The creepage that is found says how much faster it turns than
# the radii tell: the cover is stretched where it is pressed, and carries the roller along with the stretched surface.

# %%
xi = solution.creepage.longitudinal
print(f"creepage {100 * xi:.2f} %: the steel roller turns {100 * ((1 - xi / 2) / (1 + xi / 2) - 1):.2f} % faster")

# %% [markdown]
# ## How hard, how thick?
#
# A harder cover has a narrower nip; a thinner one is stiffer than its hardness says, since rubber that is pressed
# between two surfaces can only flow out at the sides.

# %%
hardnesses, thicknesses = np.arange(35, 86, 10), (5e-3, 10e-3, 20e-3)
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8),
                                     num="Width of the nip, and how much faster the free roller turns, over hardness")
for thickness, colour in zip(thicknesses, (ALONG, RED, SLIDES)):
    widths, faster = [], []
    for hardness in hardnesses:
        one = problem.replace(bodies=covered(hardness, thickness))
        found = solver.solve(one)
        xi = found.creepage.longitudinal
        widths.append(1e3 * microslip.nip_of(one, found, radius1, radius2).width)
        faster.append(-100 * xi)
    label = f"cover of {1e3 * thickness:.0f} mm"
    left.plot(hardnesses, widths, "o-", color=colour, label=label)
    right.plot(hardnesses, faster, "o-", color=colour, label=label)
left.set(xlabel="hardness [Shore A]", ylabel="width of the nip [mm]")
right.set(xlabel="hardness [Shore A]", ylabel="overdrive, -creepage [%]")
right.legend()
plt.show()

# %% [markdown]
# **How to read it.** Left: from the softest to the hardest cover the nip shrinks to half and less. Right: the softer the
# cover, the more it is stretched; what drives the free roller is the strain of the cover, not its thickness.
#
# ## How fast?
#
# Rubber is soft when it has time and stiff when it has not. In between, where the passage through the nip takes as long
# as the rubber needs to relax, most power is lost.

# %%
speeds = np.geomspace(0.02, 500, 14)
resistance, indentations = [], []
for v in speeds:
    bodies = covered(60, 15e-3)
    one = problem.replace(bodies=microslip.LayeredBodies(bodies.body1, bodies.body2, v), rolling_speed=v)
    nip = microslip.nip_of(one, solver.solve(one), radius1, radius2)
    resistance.append(nip.rolling_resistance)
    indentations.append(1e3 * nip.indentation)
figure, (left, right) = plt.subplots(1, 2, figsize=(10, 3.8), num="Rolling resistance and indentation over the speed")
left.semilogx(speeds, resistance, "o-", color=RED)
left.set(xlabel="speed [m/s]", ylabel="rolling resistance [N per m]")
right.semilogx(speeds, indentations, "o-", color=ALONG)
right.set(xlabel="speed [m/s]", ylabel="indentation [mm]")
plt.show()

# %% [markdown]
# **How to read it.** The two humps belong to the two relaxation times: most is lost where the rubber relaxes while it
# passes from the entry to the middle of the nip, some 10 mm. 10 m/s times 0.5 ms are 5 mm, 0.4 m/s times 20 ms 8 mm. At
# low and at high speeds the cover is elastic, soft and stiff, and nothing is lost.
#
# ## What the cover carries
#
# `layered_peaks` finds the largest stresses of the layers, and shear and tension of the bond, by which covers come off.

# %%
peaks = microslip.layered_peaks(problem.bodies, solution)
for peak in peaks.layers:
    what = "cover" if (peak.body, peak.layer) == (2, 0) else f"body {peak.body}"
    print(f"{what}: von Mises {1e-6 * peak.von_mises:.2f} MPa, {1e3 * peak.place[2]:.1f} mm deep")
bond = peaks.interfaces[0]
print(f"bond: shear {1e-6 * bond.shear:.2f} MPa at x = {1e3 * bond.shear_place[0]:.0f} mm, tension {1e-6 * bond.tension:.3f} MPa")

# %% [markdown]
# The same case as a file for `microslip solve` is `examples/rubber_roller.toml`; formulas, signs and what limits them
# are in [Rollers with covers](../rollers.md).
