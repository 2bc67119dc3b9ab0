"""A wheel on a rail: Hertz, FASTSIM2, the exact theory, and a creep curve in one call."""

import math

import microslip

steel = microslip.Material.from_young(210e9, 0.28)
pair = microslip.combine(steel, steel)
gap = microslip.gap_curvatures(rolling1=0.46, rolling2=math.inf, transverse1=math.inf, transverse2=0.3)
hertz = microslip.hertz_from_load(gap, pair, normal_force=80e3)
print(f"a = {1e3 * hertz.a:.3f} mm, b = {1e3 * hertz.b:.3f} mm, p0 = {1e-6 * hertz.peak_pressure:.0f} MPa")

contact = microslip.EllipticContact(hertz.a, hertz.b, pair.shear_modulus, pair.poisson_ratio, normal_force=80e3,
                                    friction=0.3, creepage=(0.0018, 0.0006, 0.4))
fastsim2 = microslip.Fastsim2()  # 10 x 10 cells; all its memory is taken here
derivatives = fastsim2.differentiate(contact)
forces = derivatives.forces
print(f"Fx = {forces.fx:.1f} N, Fy = {forces.fy:.1f} N, Mz = {forces.mz:.2f} N m, "
      f"dFx/dxi = {derivatives.jacobian[0, 0]:.3g} N")

exact = microslip.Solver(theory="exact", grid=24).solve(contact)
print(f"exact theory: Fx = {exact.forces.fx:.1f} N, Fy = {exact.forces.fy:.1f} N, Mz = {exact.forces.mz:.2f} N m")

creepages = [0.0005, 0.001, 0.002, 0.004]
curve = fastsim2.solve_batch(contact, creepages, lateral=0, spin=[[0.0], [0.4]])  # two spins, four creepages each
for spin, row in zip((0.0, 0.4), curve.fx):
    print(f"spin {spin} 1/m: Fx = " + ", ".join(f"{force:.0f}" for force in row) + " N")
