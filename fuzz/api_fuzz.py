"""Calls the Python module with random options, shapes, arrays and values, in range and out of it, in pairs that nobody chose:

    api_fuzz.py [--seed S] [--calls N | --seconds T] [--call I]

Every call gives finite results whose forces keep within friction, or says in its status that it does not, or raises
microslip.Error (TypeError for an argument of a wrong kind). After numbers out of all range it may also give NaN. Calls
run in a separate process, so that a crash is told as well. Each has a seed: `--seed S --call I` makes
call I again and nothing else.
"""

import argparse
import math
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import microslip

PROFILES = Path(__file__).resolve().parents[1] / "examples" / "profiles"
ODD_NUMBERS = (0.0, -1.0, 5e-324, 1e-320, 1e-300, 1e-30, 1e30, 1e300, 1.7e308, math.inf, -math.inf, math.nan)


class Draw(random.Random):
    """Random arguments. A share `odd` of them, drawn for each call, are out of range or of an unusual kind."""

    def __init__(self, seed):
        super().__init__(seed)
        self.odd = self.choice((0.0, 0.0, 0.02, 0.1))
        self.out_of_range = False

    def is_odd(self):
        return self.random() < self.odd

    def odd_number(self):
        self.out_of_range = True
        return self.choice(ODD_NUMBERS)

    def number(self, low, high):
        """Usually between `low` and `high`."""
        return self.odd_number() if self.is_odd() else self.uniform(low, high)

    def scale(self, low, high):
        """A number whose logarithm is evenly distributed."""
        return self.odd_number() if self.is_odd() else math.exp(self.uniform(math.log(low), math.log(high)))

    def count(self, low, high):
        return self.choice((0, -1, 2**31 - 1)) if self.is_odd() else self.randint(low, high)

    def word(self, *words):
        return "no such word" if self.is_odd() else self.choice(words)

    def some(self, **arguments):
        """Each argument or its default."""
        return {name: draw() for name, draw in arguments.items() if self.random() < 0.4}

    def array(self, values):
        """An array of these values, or of some others' shape, of any kind."""
        values = np.asarray(values, dtype=float)
        if self.is_odd():
            shape = self.choice([(0,), (3,), values.shape[::-1], (*values.shape, 1), ()])
            values = np.resize(values, shape)
        if values.size and self.is_odd():
            values = values.copy()
            values.flat[self.randrange(values.size)] = self.odd_number()
        kind = self.choice(("plain", "fortran", "strided", "reversed", "read-only", "float32", "integer", "masked", "list"))
        if kind == "fortran":
            return np.asfortranarray(values)
        if kind == "strided":
            return np.repeat(values, 2, axis=-1)[..., ::2] if values.ndim else values
        if kind == "reversed":
            return values[::-1] if values.ndim else values
        if kind == "read-only":
            values = values.copy()
            values.flags.writeable = False
            return values
        if kind == "float32":
            return values.astype(np.float32)
        if kind == "integer":
            return np.nan_to_num(values, posinf=0, neginf=0).clip(-2**62, 2**62).astype(np.int64)
        if kind == "masked":
            return np.ma.masked_array(values, mask=np.zeros(values.shape, bool) | self.is_odd())
        return values.tolist() if kind == "list" else values


# What problems are made of.


LAWS = next(one["words"] for one in microslip.inputs("bodies") if one["key"] == "law")


def friction_table(draw, count):
    velocities = sorted({draw.scale(1e-4, 10) for _ in range(count + 1)})
    return velocities, [draw.number(0.05, 0.6) for _ in velocities]


def friction(draw):
    law = microslip.FrictionLaw
    term = lambda: (draw.number(0, 0.3), draw.scale(1e-3, 10))
    arguments = {"coulomb": lambda: (draw.number(0.05, 0.6),),
                 "polach": lambda: (draw.number(0.1, 0.5), draw.number(0, 1), draw.scale(0.01, 1)),
                 "table": lambda: friction_table(draw, draw.count(2, 8))}
    name = draw.choice((None, *LAWS))
    if name is None:
        return draw.number(0.05, 0.6)
    return getattr(law, name)(*arguments.get(name, lambda: (draw.number(0.05, 0.4), term(), *draw.choice(((), (term(),)))))())


def creepage(draw):
    size = draw.scale(1e-5, 0.1)
    return (draw.number(-size, size), draw.number(-size, size), draw.choice((0.0, draw.number(-1, 1))))


def material(draw):
    if draw.random() < 0.5:
        return microslip.CombinedMaterial(draw.scale(1e9, 1e11), draw.number(0, 0.5), draw.choice((0.0, draw.number(0, 0.5))))
    body = lambda: microslip.Material(draw.scale(1e9, 1e11), draw.number(0, 0.5))
    return microslip.combine(body(), body())


def bodies(draw):
    """Bodies for a solver of the exact theory: combined constants, with a layer, viscoelastic."""
    layer = lambda: microslip.InterfaceLayer(draw.scale(1e-16, 1e-12), **draw.some(
        yield_stress=lambda: draw.scale(1e6, 1e9), hardening=lambda: draw.number(-1e12, 1e12)))
    body = lambda: microslip.Material(draw.scale(1e9, 1e11), draw.number(0, 0.5))
    creep = lambda: microslip.MaterialCreep(draw.choice((0.0, draw.number(0, 3))), draw.scale(1e-5, 1e-1))
    return draw.choice((
        lambda: material(draw), lambda: microslip.Bodies(material(draw), layer()),
        lambda: microslip.viscoelastic(body(), creep(), body(), creep(), draw.scale(0.1, 100), **draw.some(layer=layer)),
    ))()


def heat(draw):
    """Two bodies for heat, and what their temperature takes from friction."""
    body = lambda: microslip.ThermalBody(draw.number(-20, 100), draw.scale(1, 100), draw.scale(1e3, 1e4), draw.scale(100, 1e3))
    return draw.some(thermal=lambda: (body(), body()), temperature_effect=lambda: microslip.TemperatureEffect(
        draw.number(-0.2, 0), draw.number(-50, 200), draw.scale(10, 1e3)))


def contact(draw):
    a = draw.scale(1e-4, 1e-2)
    return microslip.EllipticContact(a, a * draw.scale(0.1, 10), draw.scale(1e9, 1e11), draw.number(0, 0.5), draw.scale(1, 1e5),
                                     friction(draw), creepage(draw), draw.scale(0.1, 100))


def grid(draw):
    """Elements about the origin, and the coordinates of their centres along x and y."""
    mx, my = draw.count(4, 14), draw.count(4, 14)
    dx, dy = draw.scale(1e-4, 1e-2), draw.scale(1e-4, 1e-2)
    on = microslip.ElementGrid(mx, my, -0.5 * (mx - 1) * dx, -0.5 * (my - 1) * dy, dx, dy)
    return on, dx * (np.arange(mx) - 0.5 * (mx - 1)), dy * (np.arange(my)[:, None] - 0.5 * (my - 1))


def gap(draw, x, y):
    """A paraboloid, and at times a second one beside it."""
    values = draw.scale(0.1, 10) * x**2 + draw.scale(0.1, 10) * y**2
    if draw.random() < 0.3:
        values = np.minimum(values, (x - x.max())**2 + y**2)
    return draw.array(values)


def forces(draw, load):
    return draw.some(force_longitudinal=lambda: draw.number(-load, load), force_lateral=lambda: draw.number(-load, load))


def load(draw):
    return draw.choice(({"normal_force": draw.scale(1, 1e5)}, {"approach": draw.scale(1e-7, 1e-3)}))


def motion(draw):
    return draw.some(kind=lambda: draw.word("steady", "transient", "shift"), step=lambda: draw.scale(1e-5, 1e-2))


def columns(draw, like):
    """Arguments of a batch: numbers, or arrays that may broadcast."""
    shape = draw.choice(((), (1,), (3,), (2, 1), (2, 3)))
    values = lambda low, high: draw.array(np.reshape([draw.number(low, high) for _ in range(math.prod(shape))], shape))
    return draw.some(longitudinal=lambda: values(-0.01, 0.01), lateral=lambda: values(-0.01, 0.01), spin=lambda: values(-1, 1),
                     a=lambda: values(0.5 * like.a, 2 * like.a), b=lambda: values(0.5 * like.b, 2 * like.b),
                     friction=lambda: values(0.1, 0.5), normal_force=lambda: values(1e3, 1e5),
                     rolling_speed=lambda: values(0.1, 50), threads=lambda: draw.count(0, 3))


# What is called. Each returns results to look at.


def method(draw):
    """The exact theory with its options, at times another one."""
    grid = {"grid": draw.choice((draw.count(1, 12), (draw.count(1, 12), draw.count(1, 12))))}
    if draw.random() < 0.1:
        return grid | {"theory": draw.word("fastsim", "fastsim2", "fastrip", "table")}
    return grid | {"theory": "exact"} | draw.some(
        discretisation=lambda: draw.word("second_order", "classical"), elements=lambda: draw.word("constant", "bilinear"),
        coupling=lambda: draw.word("newton", "alternating"), slip_start=lambda: draw.word("below", "above"),
        tolerance=lambda: draw.scale(1e-8, 1e-3))


def beyond_contact(draw):
    """Keywords of a problem beyond those of its contact."""
    return draw.some(
        direction=lambda: draw.word("forward", "backward"), bodies=lambda: bodies(draw),
        memory_distance=lambda: draw.scale(1e-5, 1e-2), memory_speed=lambda: draw.scale(1e-3, 10)) | heat(draw)


def elliptic_contact(draw):
    solver = microslip.Solver(**method(draw))
    case = contact(draw)
    call = draw.choice(("solve", "solve", "deformed_gap", "differentiate", "solve_batch"))
    moves = motion(draw) if call in ("solve", "deformed_gap") else {}
    if call == "solve":
        moves |= forces(draw, case.normal_force) | draw.some(steps=lambda: draw.count(1, 3))
    problem = microslip.RollingProblem(case, **beyond_contact(draw), **moves)
    if call == "solve":
        return within_friction(case, solver.solve(problem))
    return solver.solve_batch(problem, **columns(draw, case)) if call == "solve_batch" else getattr(solver, call)(problem)


def responses(draw):
    """Responses over the wavenumber, and a force element that is fitted to them."""
    case = contact(draw)
    case.friction = draw.number(0.05, 0.6)  # others are refused
    solver = microslip.Solver(theory="exact", grid=(draw.randint(3, 8), draw.randint(3, 8)))
    wavenumber = draw.array(sorted(draw.scale(1, 1e3) for _ in range(draw.randint(1, 9))))
    found = solver.respond(microslip.RollingProblem(case), wavenumber, **draw.some(roughness=lambda: True))
    if draw.random() < 0.5 or not len(found.wavenumber):
        return found
    element = microslip.ForceElement(found, case.normal_force, **draw.some(poles=lambda: draw.count(1, 8)))
    forces = element.step(draw.scale(1e-5, 1), draw.number(-1e-3, 1e-3), draw.number(-1e-3, 1e-3), draw.number(-0.1, 0.1), case.normal_force)
    return forces, microslip.ForceElement.from_text(element.text()).error, microslip.remington_filter(case.a, draw.scale(0.01, 10), draw.scale(1, 1e3))


def accurate_contact(draw):
    solver = microslip.Solver(theory="exact", accuracy=draw.choice((0.1, draw.scale(1e-2, 0.1))))
    case = contact(draw)
    if draw.random() < 0.7:
        case.friction = draw.number(0.05, 0.6)  # others are refused
    return solver.solve(microslip.RollingProblem(case, **forces(draw, case.normal_force), **draw.some(
        direction=lambda: draw.word("forward", "backward"), bodies=lambda: bodies(draw))))


def from_solution(draw):
    """Further results of a solution: fields on another grid, stresses inside."""
    solver = draw.choice((microslip.Fastsim2(6, 5).fields, microslip.Solver(theory="exact", grid=(draw.randint(1, 8), draw.randint(1, 8))).solve))
    solution = solver(contact(draw))
    if draw.random() < 0.5:
        return solution.sampled(draw.word("px", "pressure", "sx", "gap", "temperature1"), grid(draw)[0])
    body = lambda: microslip.Material(draw.scale(1e9, 1e11), draw.number(0, 0.5))
    points = lambda: draw.array([draw.number(-0.01, 0.01) for _ in range(draw.randint(1, 3))])
    return solution.interior_states(body(), body(), points(), points(), points())


def simplified(draw):
    kind = draw.choice((microslip.Fastsim, microslip.Fastsim2))
    solver = kind(draw.count(1, 12), draw.count(1, 12), **draw.some(
        bound=lambda: draw.word("parabolic", "elliptic"), flexibility=lambda: draw.word("three", "one", "blended"),
        coefficients=lambda: draw.word("kalker", "computed"), direction=lambda: draw.word("forward", "backward"),
        slope_reduction=lambda: (draw.number(0, 1), draw.number(0, 1), draw.number(0, 5))))
    case = contact(draw)
    call = draw.choice(("solve", "fields", "differentiate", "solve_batch", "differentiate_batch"))
    arguments = columns(draw, case) if "batch" in call else {}
    return getattr(solver, call)(case, **arguments)


def creep_table(draw):
    table = microslip.CreepForceTable(**draw.some(poisson_ratio=lambda: draw.number(0, 0.5),
                                                  direction=lambda: draw.word("forward", "backward")))
    case = contact(draw)
    call = draw.choice(("solve", "differentiate", "solve_batch", "differentiate_batch"))
    return getattr(table, call)(case, **(columns(draw, case) if "batch" in call else {}))


def patch_fields(draw):
    mx, my = draw.count(1, 10), draw.count(1, 10)
    length, width = draw.scale(1e-4, 1e-2), draw.scale(1e-4, 1e-2)
    rows = np.arange(float(max(my, 1) % 1000))
    edge = lambda sign: sign * length * (1 + np.array([draw.random() for _ in rows]))
    pressure = np.full((len(rows), max(mx, 1) % 1000), draw.scale(1e6, 1e10))
    return microslip.Fastsim2(mx, my).patch_fields(
        draw.array(width * rows), draw.array(edge(1)), draw.array(edge(-1)), draw.array(pressure), row_width=width,
        flexibilities=[draw.scale(1e-15, 1e-11) for _ in range(3)], friction=friction(draw), creepage=creepage(draw),
        **draw.some(rolling_speed=lambda: draw.scale(0.1, 100)))


def normal_problem(draw):
    on, x, y = grid(draw)
    return microslip.NormalProblem(material(draw), on).solve(gap(draw, x, y), **load(draw))


def patch_rolling(draw):
    on, x, y = grid(draw)
    xi, eta, phi = creepage(draw)
    problem = microslip.RollingProblem(
        gap=gap(draw, x, y), grid=on, bodies=material(draw), friction=draw.number(0.05, 0.6), rolling_speed=draw.scale(0.1, 100),
        creepage_longitudinal=xi, creepage_lateral=eta, spin=phi, **load(draw), **draw.some(direction=lambda: draw.word("forward", "backward")))
    return microslip.Solver(theory="exact").solve(problem.replace(**forces(draw, 1e4)))


def tangential_problem(draw):
    on, x, y = grid(draw)
    problem = microslip.TangentialProblem(material(draw), on)
    bound = draw.array(draw.scale(1e5, 1e9) * np.outer(np.hanning(y.size), np.hanning(x.size)))
    solution = None
    for _ in range(draw.randint(1, 3)):
        solution = problem.solve(bound, creepage(draw), previous=solution, **motion(draw), **forces(draw, 1e4),
                                 **draw.some(direction=lambda: draw.word("forward", "backward"),
                                             rolling_speed=lambda: draw.scale(0.1, 100)))
    return solution


def interior(draw):
    on, x, y = grid(draw)
    traction = lambda: draw.array(np.full((y.size, x.size), draw.scale(1e5, 1e9)))
    field = microslip.InteriorField(microslip.Material(draw.scale(1e9, 1e11), draw.number(0, 0.5)), draw.count(1, 2), on,
                                    **draw.some(px=traction, py=traction, pn=traction))
    points = lambda low, high: draw.array([draw.number(low, high) for _ in range(3)])
    return field.at(points(-0.01, 0.01), points(-0.01, 0.01), points(0, 0.01))


def hertz(draw):
    radius = lambda: draw.choice((math.inf, draw.number(-2, 2), draw.scale(0.1, 10)))
    return microslip.hertz_from_load(microslip.gap_curvatures(*(radius() for _ in range(4))), material(draw), draw.scale(1, 1e6))


def profile(draw):
    """An arc with errors, as a rail or a wheel, and what is asked of it."""
    angle, radius = np.linspace(-1.2, 1.2, draw.randint(5, 300)), draw.scale(1e-2, 1)
    noise = draw.choice((0.0, draw.scale(1e-7, 1e-4)))
    coordinate = lambda values: draw.array(radius * values + [draw.gauss(0, noise) for _ in values])
    kind = draw.word("rail", "wheel")
    made = microslip.Profile(coordinate(np.sin(angle)), coordinate(np.cos(angle)), kind,
                             **draw.some(smoothing_length=lambda: draw.scale(1e-4, 1e-2),
                                         trim=lambda: (draw.number(-0.1, 0), draw.number(0, 0.1))))
    s = draw.array(np.linspace(0, made.length, 7))
    asked = made.gauge_point(draw.scale(1e-3, 0.1)) if kind == "rail" else made.wheel_dimensions(draw.number(-0.1, 0.1))
    return made, asked, made.report, made.point(s), made.angle(s), made.curvature(s)


def wheel_rail(draw):
    """S1002 on 60E1 anywhere near the track, on either side and with both theories."""
    rail, wheel = (microslip.read_profile(PROFILES / name) for name in ("60e1.prr", "s1002.prw"))
    pair = microslip.WheelRail(
        track=microslip.Track(gauge=draw.number(1.43, 1.45), cant=draw.number(0, 0.06)), rail=rail,
        wheelset=microslip.Wheelset(nominal_radius=draw.number(0.3, 0.6)), wheel=wheel, **draw.some(
            side=lambda: draw.word("left", "right"), theory=lambda: draw.word("fastsim2", "exact"),
            shape=lambda: draw.word("flat", "curved", "conformal"), grid=lambda: draw.count(6, 12), friction=lambda: draw.number(0, 0.6),
            tolerance=lambda: draw.scale(1e-8, 1e-3), fields=lambda: draw.random() < 0.5,
            strength=lambda: microslip.SurfaceStrength(hardness=draw.scale(1e8, 1e10), shear_yield_strength=draw.scale(1e7, 1e9))))
    state = {"vertical_force": draw.scale(100, 2e5), "forward_velocity": draw.number(-80, 80)}
    state.update(draw.some(lateral=lambda: draw.number(-0.015, 0.015), yaw=lambda: draw.number(-0.05, 0.05),
                           roll=lambda: draw.number(-0.02, 0.02), pitch_velocity=lambda: draw.number(-200, 200),
                           lateral_velocity=lambda: draw.number(-1, 1), yaw_velocity=lambda: draw.number(-1, 1),
                           curvature=lambda: draw.number(-0.01, 0.01), deflection_lateral=lambda: draw.number(-1e-3, 1e-3),
                           deviation_vertical=lambda: draw.number(-1e-3, 1e-3)))
    if draw.random() < 0.7:
        return draw.choice((pair.solve, pair.differentiate))(**state)
    state["lateral"] = draw.array(np.array([draw.number(-0.01, 0.01) for _ in range(3)]))
    many = pair.differentiate_batch(**state, threads=draw.count(0, 2))
    return None if np.any(many.solution.status) else (many.solution.force_x, many.solution.force_y, many.jacobian)


def wheelset_geometry(draw):
    """S1002 on 60E1 at any lateral displacement, and its conicity."""
    rail = microslip.read_profile(PROFILES / "60e1.prr")
    wheel = microslip.read_profile("S1002", **draw.some(flange_thickness=lambda: draw.number(0.0285, 0.0325)))
    geometry = microslip.WheelsetGeometry(track=microslip.Track(cant=draw.number(0, 0.06)), rail=rail,
                                          wheelset=microslip.Wheelset(nominal_radius=draw.number(0.3, 0.6)), wheel=wheel,
                                          contact_distance=draw.number(1, 2))
    roll = {"roll": draw.word("equilibrium", "none")}
    if draw.random() < 0.7:
        found = geometry.contact(draw.array(np.array([draw.number(-0.01, 0.01) for _ in range(3)])), draw.number(-0.01, 0.01),
                                 **roll, threads=draw.count(0, 2))
        return None if np.any(found.status) else (found.rolling_radius_difference, found.left_rail_y, found.right_contact_angle)
    return geometry.equivalent_conicity(draw.number(1e-4, 5e-3), **draw.some(gauge=lambda: draw.number(1.43, 1.44)), **roll)


def wheelset_on_track(draw):
    """Both wheels of S1002 on 60E1, in equilibrium or at a position."""
    rail, wheel = (microslip.read_profile(PROFILES / name) for name in ("60e1.prr", "s1002.prw"))
    pair = microslip.WheelsetOnTrack(
        track=microslip.Track(gauge=draw.number(1.43, 1.45), cant=draw.number(0, 0.06)), rail=rail,
        wheelset=microslip.Wheelset(nominal_radius=draw.number(0.3, 0.6)), wheel=wheel, **draw.some(
            shape=lambda: draw.word("flat", "curved", "conformal"), friction=lambda: draw.number(0, 0.6),
            tolerance=lambda: draw.scale(1e-9, 1e-3)))
    state = {"lateral": draw.number(-0.012, 0.012), "forward_velocity": draw.number(-80, 80)}
    state.update(draw.some(yaw=lambda: draw.number(-0.03, 0.03), lateral_velocity=lambda: draw.number(-1, 1),
                           curvature=lambda: draw.number(-0.01, 0.01), right_deviation_vertical=lambda: draw.number(-1e-3, 1e-3),
                           axle_torque=lambda: draw.number(-2e4, 2e4)))
    if draw.random() < 0.3:
        return pair.solve(**state, vertical=draw.number(-1e-3, 1e-3), roll=draw.number(-1e-3, 1e-3))
    state["vertical_force"] = draw.scale(1e3, 4e5)
    state.update(draw.some(roll_moment=lambda: draw.number(-0.5, 0.5) * state["vertical_force"]))
    found = pair.solve(**state) if draw.random() < 0.7 else pair.differentiate(**state).solution
    if found.status == microslip.Status.ok:
        assert abs(found.force_z / state["vertical_force"] - 1) < 2e-3, f"{found.force_z} N instead of {state['vertical_force']} N"
    return found


CALLS = (wheel_rail, wheel_rail, wheelset_on_track, wheelset_geometry, elliptic_contact, elliptic_contact, elliptic_contact, responses, accurate_contact, from_solution, simplified, creep_table, patch_fields,
         normal_problem, patch_rolling, tangential_problem, interior, hertz, profile)


# What is asked of the results.


def within_friction(case, solution):
    """Coulomb's friction bounds the force, to the solver's tolerance."""
    found = solution.forces
    if found.status == microslip.Status.ok and case.friction.kind == "coulomb":
        bound = case.friction.static_coefficient * case.normal_force
        assert math.hypot(found.fx, found.fy) <= 1.01 * bound, f"a force of {math.hypot(found.fx, found.fy)} N above {bound} N"
    return solution


def values(result, name="result"):
    """All numbers of a result with their names, those of its members too."""
    if isinstance(result, np.ndarray):
        yield name, result
    elif isinstance(result, (float, int)):
        yield name, np.asarray(result)
    elif isinstance(result, (list, tuple)):
        for i, member in enumerate(result):
            yield from values(member, f"{name}[{i}]")
    elif type(result).__module__.startswith("microslip"):
        for member in (m for m in dir(result) if not m.startswith("_")):
            value = getattr(result, member)
            if not callable(value):
                yield from values(value, f"{name}.{member}")


def look_at(result):
    found = dict(values(result))
    if any(np.any(array) for name, array in found.items() if name.endswith("status")):
        return
    for name, array in found.items():
        assert array.dtype.kind in "iub" or np.all(np.isfinite(array)), f"{name} is not finite"


LONGEST = 2.0  # s that a call may take; what does not converge is ended as by Ctrl-C


class TooLong(Exception):
    """A call that is ended."""


def end_call(*_):
    raise TooLong


def run(seed, calls, seconds, said):
    """Makes calls, as many as these seconds allow; `said` tells before each one which it is, in case that it
    never comes back."""
    signal.signal(signal.SIGALRM, end_call)
    end = time.monotonic() + seconds
    for i in calls:
        if time.monotonic() > end:
            return
        draw = Draw(f"{seed}/{i}")
        call = draw.choice(CALLS)
        said.write_text(f"call {i}, {call.__name__}")
        signal.setitimer(signal.ITIMER_REAL, LONGEST)
        try:
            result = call(draw)
            signal.setitimer(signal.ITIMER_REAL, 0)
            if not draw.out_of_range or call in (simplified, creep_table):  # whose status says it whatever the numbers
                look_at(result)
        except (microslip.Error, TypeError, TooLong):
            pass
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--seed", default="1", help="any text")
    parser.add_argument("--calls", type=int, help="how many; 3000, or what there is time for")
    parser.add_argument("--seconds", type=float, default=math.inf, help="end after this time")
    parser.add_argument("--call", type=int, help="only this one")
    parser.add_argument("--said", type=Path, help=argparse.SUPPRESS)  # in the process that calls
    options = parser.parse_args()
    most = options.calls or (3000 if math.isinf(options.seconds) else sys.maxsize)
    calls = range(most) if options.call is None else [options.call]
    if options.said:
        run(options.seed, calls, options.seconds, options.said)
        return 0
    with tempfile.TemporaryDirectory() as folder:
        said = Path(folder) / "said"
        outcome = subprocess.run([sys.executable, __file__, *sys.argv[1:], "--said", said], check=False)
        if outcome.returncode == 0:
            last = said.read_text() if said.exists() else "none"
            print(f"calls with seed {options.seed} up to {last}: no fault found")
            return 0
        last = said.read_text() if said.exists() else "no call was made"
    print(f"exit code {outcome.returncode} after {last}; again: {Path(__file__).name} --seed {options.seed} "
          f"--call {last.split(',')[0].removeprefix('call ')}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
