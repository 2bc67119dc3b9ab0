#!/usr/bin/env python3
"""Campaigns: are results those of an undisturbed run whatever is killed, what do ranks and checkpoints cost, and what is
to be expected of a thousand cores. docs/campaigns.md shows what it prints.

PYTHONPATH=build/release/share/microslip/python bench/campaigns.py kills build/release/bin/microslip [--kills 20] [--seed 1]
PYTHONPATH=build/release/share/microslip/python bench/campaigns.py cost build/release/bin/microslip
PYTHONPATH=build/release/share/microslip/python bench/campaigns.py projection
"""

import argparse
import heapq
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

import h5py

CASES, CHUNK = 1600, 4
LARGE = 64 << 20  # bytes of a file system that does not fill up

BODIES = """
[case.body1]
rolling_radius = 0.46
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[case.body2]
rolling_radius = inf
transverse_radius = 0.3
young_modulus = 210e9
poisson_ratio = 0.28
[case.load]
normal_force = 80e3
[case.friction]
coefficient = 0.3
[case.motion]
rolling_speed = 30.0
"""


def specification(count, chunk, theory, grid=24):
    """Random contacts: ellipses from narrow to wide, creepages from adhesion to full sliding, some out of range."""
    return f"""
chunk = {chunk}
[sample]
count = {count}
seed = 1
body2.transverse_radius = {{ from = 0.03, to = 3, scale = "logarithmic" }}
load.normal_force = {{ from = -1e3, to = 120e3 }}
motion.creepage_longitudinal = {{ from = -0.004, to = 0.004 }}
motion.creepage_lateral = {{ from = -0.004, to = 0.004 }}
motion.spin = {{ from = -1, to = 1 }}
{BODIES}
[case.solution]
theory = "{theory}"
grid = [{grid}, {grid}]
"""


def contents(path):
    """All datasets of a result file."""
    found = {}
    with h5py.File(path) as file:
        file.visititems(lambda name, part: found.update({name: part[()].tolist() if part.dtype == object else part[()].tobytes()})
                        if isinstance(part, h5py.Dataset) else None)
    return found


def chunks_of(journal):
    """Numbers of the chunks that a journal has whole, in their order."""
    numbers = []
    data = journal.read_bytes()
    if len(data) < 56:
        return numbers
    count, width, chunk = struct.unpack_from("=3Q", data, 24)
    offset = 56
    while offset + 24 <= len(data):
        _, reasons, number = struct.unpack_from("=IIQ", data, offset)
        offset += 24 + min(chunk, count - number * chunk) * width * 8 + reasons + 8
        if offset <= len(data):
            numbers.append(number)
    return numbers


class Trial:
    """A sweep that is killed again and again until it is complete."""

    def __init__(self, program, folder, reference, seconds, dice):
        self.program, self.reference, self.seconds, self.dice = program, reference, seconds, dice
        self.folder = pathlib.Path(folder)
        self.output = self.folder / "disk" / "out.h5"
        self.output.parent.mkdir()
        self.resize(LARGE)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if os.path.ismount(self.output.parent):
            subprocess.run(["umount", str(self.output.parent)], check=True)

    def command(self, ranks):
        sweep = [self.program, "sweep", "s.toml", "-o", str(self.output), "--json", "--threads", "2" if ranks == 1 else "1"]
        return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), *sweep] if ranks > 1 else sweep

    def start(self, ranks, before=None):
        return subprocess.Popen(self.command(ranks), cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                preexec_fn=before, start_new_session=True)

    def ranks_of(self, process):
        """Process numbers of mpirun's children, once they are there."""
        children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
        try:
            return [int(word) for word in children.read_text().split()
                    if "sweep" in pathlib.Path(f"/proc/{word}/cmdline").read_text()]
        except OSError:
            return []

    def wait_for_some(self, process):
        """Waits for the first chunks and then a random while."""
        end = time.monotonic() + 60
        while process.poll() is None and not any(self.checkpoint().glob("rank-*")) and time.monotonic() < end:
            time.sleep(0.002)
        time.sleep(self.dice.random() * self.seconds)

    def checkpoint(self):
        return pathlib.Path(str(self.output) + ".checkpoint")

    def kill(self, process, victims):
        for victim in victims:
            try:
                os.kill(victim, signal.SIGKILL)
            except ProcessLookupError:
                pass
        process.communicate()
        for victim in victims:
            while pathlib.Path(f"/proc/{victim}").exists():
                time.sleep(0.002)

    def one_rank(self):
        process = self.start(3)
        self.wait_for_some(process)
        ranks = self.ranks_of(process)
        victims = [self.dice.choice(ranks)] if ranks else []
        self.kill(process, victims)
        while any(pathlib.Path(f"/proc/{rank}").exists() for rank in ranks):
            time.sleep(0.002)

    def all_ranks(self):
        process = self.start(2)
        self.wait_for_some(process)
        self.kill(process, [process.pid, *self.ranks_of(process)])

    def one_process(self):
        process = self.start(1)
        self.wait_for_some(process)
        self.kill(process, [process.pid])

    def while_it_writes(self):
        """The system ends a process whose file passes a limit, within the write: a chunk is cut off."""
        self.limited(signal.SIG_DFL)

    def full_disk(self):
        """A disk that fills up: a file system in memory or, where that is not allowed, a limit on the size of files."""
        ranks = self.dice.choice([1, 2])
        is_small = self.resize(self.used() + self.dice.randrange(8_000, 200_000))
        error = self.start(ranks).communicate()[1] if is_small else self.limited(signal.SIG_IGN)
        said = (b"No space left on device", b"File too large", b"HDF5 cannot write")
        assert any(text in error for text in said) or self.output.exists(), error
        self.resize(LARGE)

    def limited(self, action):
        """Behaviour of a process whose files are limited; its action is what it does at the limit."""
        limit = max([journal.stat().st_size for journal in self.checkpoint().glob("rank-*")], default=0) + self.dice.randrange(60, 60_000)

        def before():
            signal.signal(signal.SIGXFSZ, action)
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

        return self.start(1, before).communicate()[1]

    def used(self):
        """Bytes in the checkpoint."""
        return sum(file.stat().st_size + 4096 for file in self.checkpoint().glob("*"))

    def resize(self, size):
        """Returns whether the file system of the output has this size [bytes] now; only root can change it."""
        how = f"remount,size={size}" if os.path.ismount(self.output.parent) else f"size={size}"
        return subprocess.run(["mount", "-t", "tmpfs", "-o", how, "tmpfs", str(self.output.parent)], capture_output=True,
                              check=False).returncode == 0

    def run(self, methods):
        """Returns what was kept after each of the kills."""
        (self.folder / "s.toml").write_text(specification(CASES, CHUNK, "exact", 16))
        kept = [0]
        for method in methods:
            method(self)
            chunks = [number for journal in self.checkpoint().glob("rank-*") for number in chunks_of(journal)]
            assert len(chunks) == len(set(chunks)), "a chunk was computed twice"
            if self.output.exists():  # it was faster
                break
            assert len(chunks) >= kept[-1], "a chunk was lost"
            kept.append(len(chunks))
        else:
            done = subprocess.run(self.command(self.dice.choice([1, 2])), cwd=self.folder, capture_output=True, check=False)
            assert done.returncode == 1, done.stderr
            document = json.loads(done.stdout)
            assert document["cases_from_checkpoint"] == kept[-1] * CHUNK, (document, kept)
        assert contents(self.output) == self.reference, "results differ"
        assert not self.checkpoint().exists()
        return kept[1:]


METHODS = {"one rank of three": Trial.one_rank, "mpirun and all ranks": Trial.all_ranks, "a process with threads": Trial.one_process,
        "a process while it writes": Trial.while_it_writes, "the disk is full": Trial.full_disk}


def kills(arguments):
    """Each trial: one or two kills, then a run to the end."""
    dice = random.Random(arguments.seed)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        (path / "s.toml").write_text(specification(CASES, CHUNK, "exact", 16))
        begin = time.monotonic()
        subprocess.run([arguments.program, "sweep", "s.toml", "-o", "reference.h5", "--threads", "1"], cwd=path,
                       capture_output=True, check=False)
        seconds = (time.monotonic() - begin) / 2
        reference = contents(path / "reference.h5")
    print(f"{CASES} cases in chunks of {CHUNK}; after each kill the chunks that are kept, then the run to the end\n")
    print(f"{'killed':26} {'chunks kept':>14}  results")
    names = [name for name in METHODS if shutil.which("mpirun") or "rank" not in name]
    for number in range(arguments.kills):
        name = names[number % len(names)]
        with tempfile.TemporaryDirectory() as folder, Trial(arguments.program, folder, reference, seconds, dice) as trial:
            kept = trial.run([METHODS[name]] * dice.choice([1, 2]))
        print(f"{name:26} {', '.join(map(str, kept)):>14}  identical, none lost, none twice")


def timed(command, folder):
    """Wall and processor time [s] of a command."""
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, cwd=folder, capture_output=True, check=False)
    wall, after = time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def cost(arguments):
    """Gain of a second rank, and overhead of a chunk beyond its cases."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)

        def sweep(count, chunk, theory, ranks, grid=24):
            (path / "s.toml").write_text(specification(count, chunk, theory, grid))
            command = [arguments.program, "sweep", "s.toml", "-o", "out.h5", "--threads", "1"]
            launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)]
            return timed([*launcher, *command], path)

        rounds, count = 5, 2000
        wall = {1: float("inf"), 2: float("inf")}
        used = float("inf")
        for _ in range(rounds):
            for ranks in wall:
                empty, work = sweep(1, 1, "exact", ranks), sweep(count, CHUNK, "exact", ranks)
                wall[ranks] = min(wall[ranks], work[0] - empty[0])
                used = min(used, (work[1] - empty[1]) / count)
        print(f"{count} cases of the exact theory on 24 x 24 elements, best of {rounds}, less the launch: {wall[1]:.2f} s on 1 rank,\n"
              f"{wall[2]:.2f} s on 2: efficiency {wall[1] / wall[2] / 2:.2f}")
        count = 40000
        chunks = {chunk: min(sweep(count, chunk, "fastsim2", 1, 4)[1] for _ in range(3)) for chunk in (1, 64)}
        each = (chunks[1] - chunks[64]) / (count - count / 64)
        print(f"A chunk in the checkpoint, with its share of the common count: {1e6 * each:.1f} microseconds of processor time; at "
              f"{CHUNK}\ncases of {1e6 * used:.0f} microseconds {100 * each / CHUNK / used:.2f} %")


def makespan(times, workers, latency, service):
    """When the last of the tasks is done: workers ask one after another for the next one; a question takes a while to travel
    and a while at the number that all ask."""
    free_at, end = 0.0, 0.0
    asking = [(latency / 2, 0)] * workers
    heapq.heapify(asking)
    for task in times:
        asked, _ = heapq.heappop(asking)
        free_at = max(asked, free_at) + service
        done = free_at + latency / 2 + task
        end = max(end, done)
        heapq.heappush(asking, (done + latency / 2, 0))
    return end


def projection(arguments):
    """Chunks of measured processor times on up to a thousand cores."""
    from microslip import _core
    dice = random.Random(1)
    latency, service, write = 20e-6, 1e-6, 20e-6
    print(f"Simulated: a question for the next chunk travels {1e6 * latency:.0f} microseconds there and back and takes "
          f"{1e6 * service:.0f} where the count is;\na chunk in the checkpoint takes {1e6 * write:.0f} microseconds\n")
    print(f"{'cases':>9} {'of':>9} {'chunk':>6} {'mean':>9} {'longest':>9} {'efficiency on 100':>18} {'1,000':>7} {'10,000 cores':>13}")
    for theory, grid, sample in (("exact", 24, 1500), ("fastsim2", 10, 4000)):
        name = os.path.abspath("s.toml")
        solver = _core._ChunkSolver(specification(sample, 1, theory, grid), name)
        times = []
        for number in range(sample):
            begin = time.thread_time()
            solver.solve(number)
            times.append(time.thread_time() - begin)
        for count, chunk in ((100_000, 1), (1_000_000, 1), (1_000_000, 16), (1_000_000, 64)):
            tasks = [sum(dice.choices(times, k=chunk)) + write for _ in range(count // chunk)]
            work = sum(tasks) - write * len(tasks)
            shares = [work / cores / makespan(tasks, cores, latency, service) for cores in (100, 1000, 10000)]
            print(f"{count:9,} {theory:>9} {chunk:6} {1e6 * sum(times) / sample:6.0f} us {1e6 * max(times):6.0f} us "
                  f"{shares[0]:18.3f} {shares[1]:7.3f} {shares[2]:13.3f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    commands = parser.add_subparsers(required=True)
    for work in (kills, cost, projection):
        command = commands.add_parser(work.__name__)
        command.set_defaults(work=work)
        if work is not projection:
            command.add_argument("program", type=os.path.abspath)
    commands.choices["kills"].add_argument("--kills", type=int, default=20)
    commands.choices["kills"].add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    arguments.work(arguments)
    return 0


if __name__ == "__main__":
    sys.exit(main())
