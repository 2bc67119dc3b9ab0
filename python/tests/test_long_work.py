"""Long work frees Python's lock, hears Ctrl-C, and waits its turn when many threads use one solver."""

import signal
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import microslip
from tests.compiled import contact, load_tests_if_compiled, wheel_on_rail

PROFILES = Path(__file__).resolve().parents[2] / "examples" / "profiles"


def s1002_on_60e1():
    """Arguments of wheels on rails and of wheelsets."""
    rail, wheel = (microslip.read_profile(PROFILES / name) for name in ("60e1.prr", "s1002.prw"))
    return {"track": microslip.Track(gauge=1.435, cant=0.025), "rail": rail, "wheelset": microslip.Wheelset(), "wheel": wheel}


class InterruptTest(unittest.TestCase):
    def interrupt(self, work):
        """Sends Ctrl-C during the work; returns the seconds from there to its end."""
        sent = []
        begun = threading.Event()

        def send():
            begun.wait()
            time.sleep(0.2)
            sent.append(time.monotonic())
            signal.raise_signal(signal.SIGINT)

        thread = threading.Thread(target=send)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            begun.set()
            work()
        thread.join()
        return time.monotonic() - sent[0]

    def test_batches_end_early(self):
        # Without the interrupt each would take minutes; the bound is far above what it takes, for busy machines.
        creepages = np.linspace(1e-4, 3e-3, 3_000_000)
        for work in (lambda: microslip.Fastsim2(100, 100).solve_batch(contact(), creepages),
                     lambda: microslip.Fastsim2(1000, 1000).differentiate_batch(contact(), creepages[:10000]),
                     lambda: microslip.Solver(theory="exact", grid=24).solve_batch(contact(), creepages)):
            self.assertLess(self.interrupt(work), 10)

    def test_transient_rolling_ends_early(self):
        solver = microslip.Solver(theory="exact", grid=24)
        self.assertLess(self.interrupt(lambda: solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=1_000_000))), 10)
        self.assertIs(solver.solve(contact()).forces.status, microslip.Status.ok)

    def test_interior_sums_end_early(self):
        grid = microslip.ElementGrid.across_ellipse(1, 1, 100, 100)
        field = microslip.InteriorField(microslip.Material(1, 0.3), 1, grid, pn=np.ones((100, 100)))
        self.assertLess(self.interrupt(lambda: field.at(np.linspace(-1, 1, 1_000_000), 0, 0.5)), 10)
        solution, steel = microslip.Solver(theory="exact", grid=60).solve(contact()), microslip.Material.from_young(210e9, 0.28)
        between = np.linspace(-5e-3, 5e-3, 100)  # no centres of elements, for which there are transforms
        self.assertLess(self.interrupt(lambda: solution.interior_states(steel, steel, between, between, between)), 10)

    def test_conicities_end_early(self):
        displacements = np.linspace(-0.01, 0.01, 201)
        difference = microslip.RollingRadiusDifference(displacements, 0.1 * displacements + 5 * displacements**3)
        amplitudes = np.linspace(1e-3, 9e-3, 3_000_000)
        self.assertLess(self.interrupt(lambda: difference.equivalent_conicity(amplitudes)), 10)
        geometry = microslip.WheelsetGeometry(**s1002_on_60e1())
        self.assertLess(self.interrupt(lambda: geometry.equivalent_conicity(amplitudes)), 10)
        self.assertLess(self.interrupt(lambda: geometry.equivalent_conicity(3e-3, gauge=np.linspace(1.43, 1.44, 10000))), 10)

    def test_who_waits_for_another_thread_ends_early(self):
        solver = microslip.Solver(theory="exact", grid=24)
        begun = threading.Event()

        def roll():
            begun.set()
            solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=1500))

        thread = threading.Thread(target=roll)
        thread.start()
        begun.wait()
        self.interrupt(lambda: [solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=1500)) for _ in range(1000)])
        thread.join()


class SignalTest(unittest.TestCase):
    """Python's signal handlers run during a call: the third signal that is heard ends it. A call that hears none before
    its end hears one at most, for signals do not queue."""

    def expect_heard(self, work):
        heard = []

        def hear(_number, _frame):
            heard.append(None)
            if len(heard) == 3:
                raise KeyboardInterrupt

        before = signal.signal(signal.SIGALRM, hear)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.005, 0.005)
            with self.assertRaises(KeyboardInterrupt):
                work()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def grid(self, elements):
        hertz, pair = wheel_on_rail()
        grid = microslip.ElementGrid.across_ellipse(hertz.a, hertz.b, elements, elements, 4)
        return hertz, pair, grid, microslip.hertzian_gap(hertz.gap, grid)

    def test_hertzian_contacts(self):
        for solver in (microslip.Solver(theory="exact", grid=400),
                       microslip.Solver(theory="exact", grid=300, discretisation="classical")):
            self.expect_heard(lambda: solver.solve(contact()))
            self.expect_heard(lambda: solver.solve(microslip.RollingProblem(contact(), kind="transient", steps=100)))
        solver = microslip.Solver(theory="exact", grid=400)
        self.expect_heard(lambda: solver.differentiate(contact()))

    def test_the_normal_problem(self):
        _, pair, grid, gap = self.grid(500)
        problem = microslip.NormalProblem(pair, grid)
        self.expect_heard(lambda: problem.solve(gap, normal_force=80e3))

    def test_the_tangential_problem(self):
        hertz, pair, grid, _ = self.grid(300)
        problem = microslip.TangentialProblem(pair, grid)
        bound = 0.3 * hertz.pressure(grid.x[None, :], grid.y[:, None])
        self.expect_heard(lambda: problem.solve(bound, (0.0018, 0.0006, 0.4)))

    def test_wheels(self):
        state = {"lateral": 6e-3, "yaw": 2e-3, "forward_velocity": 30.0}
        for shape in ("flat", "conformal"):
            wheel = microslip.WheelRail(**s1002_on_60e1(), theory="exact", shape=shape, grid=240)
            self.expect_heard(lambda: wheel.solve(vertical_force=80e3, **state))
            self.expect_heard(lambda: wheel.differentiate(vertical_force=80e3, **state))
        wheelset = microslip.WheelsetOnTrack(**s1002_on_60e1(), theory="exact", grid=100)
        self.expect_heard(lambda: wheelset.solve(vertical_force=160e3, roll_moment=0.0, **state))

    def test_planes_inside(self):
        ones = np.ones((800, 800))
        grid = microslip.ElementGrid.across_ellipse(1, 1, 800, 800)
        field = microslip.InteriorField(microslip.Material(1, 0.3), 1, grid, px=ones, pn=ones)
        layers = microslip.InteriorLayers(field)
        self.expect_heard(lambda: layers.at_depth(0.5))
        self.expect_heard(lambda: layers.find_largest(np.linspace(0.1, 1, 20)))

    def test_coefficients(self):
        _, pair, grid, _ = self.grid(1800)
        self.expect_heard(lambda: microslip.NormalProblem(pair, grid))

    def test_patches(self):
        _, _, grid, gap = self.grid(500)
        problem = microslip.RollingProblem(contact(), gap=gap, grid=grid)
        self.expect_heard(lambda: microslip.Solver(theory="exact").solve(problem))


class ThreadsTest(unittest.TestCase):
    def test_other_threads_run_during_a_batch(self):
        done = threading.Event()
        counted = []

        def count():
            number = 0
            while not done.is_set():
                number += 1
                time.sleep(0.001)
            counted.append(number)

        thread = threading.Thread(target=count)
        thread.start()
        microslip.Fastsim2(40, 40).solve_batch(contact(), np.linspace(0, 3e-3, 30000), threads=1)
        done.set()
        thread.join()
        self.assertGreater(counted[0], 5)

    def test_one_solver_in_many_threads(self):
        solver = microslip.Solver(theory="exact", grid=8)
        results = [None] * 8

        def solve(i):
            made = contact((2e-4 * (i + 1), 0, 0))
            made.a *= 1 + 0.1 * (i % 2)  # another ellipse: the solver starts anew
            results[i] = solver.solve(made).forces.fx, microslip.Solver(theory="exact", grid=8).solve(made).forces.fx

        threads = [threading.Thread(target=solve, args=(i,)) for i in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for shared, own in results:
            self.assertEqual(shared, own)

    def test_other_objects_in_many_threads(self):
        pair = s1002_on_60e1()
        wheel, wheelset = microslip.WheelRail(**pair), microslip.WheelsetOnTrack(**pair)
        _, material = wheel_on_rail()
        grid = microslip.ElementGrid.across_ellipse(6e-3, 5e-3, 24, 24, 4)
        gap = microslip.hertzian_gap(wheel_on_rail()[0].gap, grid)
        normal = microslip.NormalProblem(material, grid)
        field = microslip.InteriorField(microslip.Material(82e9, 0.28), 1, grid, pn=np.full((32, 32), 1e9))
        layers, simplified = microslip.InteriorLayers(field), microslip.Fastsim2(20, 20)
        run = {"yaw": 1e-3, "forward_velocity": 30.0}
        calls = [lambda i: wheel.solve(lateral=1e-3 * i, vertical_force=80e3, **run).force_y,
                 lambda i: wheelset.solve(lateral=1e-3 * i, vertical_force=160e3, roll_moment=0.0, **run).force_y,
                 lambda i: normal.solve(gap, normal_force=1e4 * (i + 1)).peak_pressure,
                 lambda i: layers.at_depth(1e-3 * (i + 1)).von_mises.max(),
                 lambda i: simplified.solve(contact((2e-4 * (i + 1), 0, 0))).fx,
                 lambda i: simplified.fields(contact((2e-4 * (i + 1), 0, 0))).fx]
        alone = [[call(i) for i in range(6)] for call in calls]
        together = [[None] * 6 for _ in calls]

        def work(i):
            for _ in range(3):
                for k, call in enumerate(calls):
                    together[k][i] = call(i)

        threads = [threading.Thread(target=work, args=(i,)) for i in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for one, many in zip(alone, together):
            np.testing.assert_allclose(many, one, rtol=1e-6)


load_tests = load_tests_if_compiled([InterruptTest, SignalTest, ThreadsTest])
