"""Running what is compared: the C++ programs and SciPy's process, on one core or on all.

One core means it: the process may run on that core only, and BLAS is told to start one thread.
"""

import contextlib
import dataclasses
import json
import os
import pathlib
import subprocess
import sys
import time

import machine

HERE = pathlib.Path(__file__).resolve().parent
PROGRAMS = HERE.parent / "build/release/bin"


@dataclasses.dataclass(frozen=True)
class Cores:
    """The processors that a contestant may use."""

    numbers: frozenset

    @property
    def count(self):
        return len(self.numbers)

    @property
    def words(self):
        return "one core" if self.count == 1 else f"all {self.count} cores"

    def start(self, command, **options):
        threads = str(self.count)
        environment = dict(os.environ, OPENBLAS_NUM_THREADS=threads, OMP_NUM_THREADS=threads, MKL_NUM_THREADS=threads)
        return subprocess.Popen([str(word) for word in command], env=environment, text=True,
                                preexec_fn=lambda: os.sched_setaffinity(0, self.numbers), **options)

    def output_of(self, command):
        process = self.start(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        output, complaints = process.communicate()
        if process.returncode != 0:
            sys.exit(f"bench/run.py: {' '.join(map(str, command))} failed:\n{complaints}")
        return output


@contextlib.contextmanager
def watching_others():
    """Yields a list that ends up holding the share of all processors that other programs had meanwhile."""
    share = []
    before, busy, own = time.monotonic(), machine.busy_seconds(), machine.own_seconds()
    yield share
    elapsed = max(1e-9, time.monotonic() - before)
    others = (machine.busy_seconds() - busy) - (machine.own_seconds() - own)
    share.append(max(0.0, others / elapsed / os.cpu_count()))


def all_cores():
    return Cores(frozenset(os.sched_getaffinity(0)))


def one_core():
    return Cores(frozenset([max(os.sched_getaffinity(0))]))


def program(name):
    path = PROGRAMS / name
    if not path.exists():
        sys.exit(f"bench/run.py: {path} is missing; ./run build makes it (Google Benchmark: libbenchmark-dev)")
    return path


def rounds(name, benchmark, cores, repetitions):
    """One dict of counters for each repetition of one benchmark; "others" is what other programs took meanwhile."""
    command = [program(name), f"--benchmark_filter=^{benchmark}/", f"--benchmark_repetitions={repetitions}",
               "--benchmark_format=json"]
    with watching_others() as others:
        output = cores.output_of(command)
    found = [run for run in json.loads(output)["benchmarks"] if run["run_type"] == "iteration"]
    if not found:
        sys.exit(f"bench/run.py: {name} has no benchmark {benchmark}")
    return [dict(run, others=others[0]) for run in found]


def context(name="bench_fit"):
    """What the program says about itself: its BLAS, its loops."""
    command = [program(name), "--benchmark_filter=^fit/cubic_3d/200/", "--benchmark_format=json"]
    return json.loads(one_core().output_of(command))["context"]


def frames(script, scene, cores, repetitions):
    """What the curve editor's frames took while `script` was played, in seconds, once a repetition."""
    found = []
    for _ in range(repetitions):
        with watching_others() as others:
            output = cores.output_of([program("sandbox2d"), HERE / scene, "--script", HERE / f"{script}.script", "--size",
                                      "1280x800", "--times"])
        times = json.loads(output)
        found.append({"median": 1e-3 * times["median_ms"], "p90": 1e-3 * times["p90_ms"], "others": others[0]})
    return found


def peak_memory(what, n, cores):
    return float(cores.output_of([program("bench_memory"), what, n]))


def scipy_peak_memory(kernel, dim, n, cores):
    return float(cores.output_of([sys.executable, HERE / "scipy_side.py", "memory", kernel, dim, n]))


class SciPySide:
    """SciPy in a process of its own, which answers one question at a time and is idle otherwise."""

    def __init__(self, cores):
        self.process = cores.start([sys.executable, HERE / "scipy_side.py", "answer"], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE)

    def ask(self, *question):
        print(*question, file=self.process.stdin, flush=True)
        answer = self.process.stdout.readline()
        if not answer:
            sys.exit(f"bench/run.py: SciPy's process ended at: {question}")
        return float(answer)

    def fit(self, kernel, dim, n):
        """Seconds of one fit."""
        return self.ask("fit", kernel, dim, n)

    def evaluate(self, kernel, dim):
        """Seconds of one kernel evaluation."""
        return self.ask("evaluate", kernel, dim, 2000)

    def close(self):
        self.process.stdin.close()
        self.process.wait()
