#!/usr/bin/python3
"""The benchmarks of `./run bench`: everything beside what it is compared with, and one table of ratios and aims.

    ./run bench              about two minutes
    ./run bench --full       also N = 6000: some seven minutes and 1.5 GB
    ./run bench --quick      a few seconds, only to see that everything runs; too short to judge by

How to read it. A row compares `ours` with `theirs`; the ratio says how many times faster (or slower, or larger) and
the aim what it should be. Contestants take turns, ratios are taken within a round, and the table shows their median
and, where they differ by more than a tenth, the smallest and the largest. Absolute numbers are this machine's and
this minute's; ratios travel better. On one core, times are processor time, so that other programs do not count; on
all cores they are wall time, so let the machine be idle: a row is not judged ("busy") where others took a tenth of it.

How to add a benchmark. In C++: a round in bench/fit.cpp, edit.cpp, live.cpp, evaluate.cpp, extract.cpp, trace.cpp or particles.cpp,
whose contestants each call `turns.take("name", work)` (bench/turns.h), and here a `table.row` that reads that counter
from `rounds`. A contestant in Python is a function in bench/scipy_side.py. What may be compared: the same data, the same
number of threads, the same turn.

    bench/run.py         what is compared with what, and the aims            bench/turns.h    C++ contestants' clock
    bench/contestants.py running the programs, on one core or on all         bench/data.h     everybody's data
    bench/scipy_side.py  SciPy's half, in its own process                    bench/*.cpp      what is measured
    bench/table.py       rows, ratios, verdicts                              bench/machine.py where it was measured
"""

import argparse
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
DEBIANS_PYTHON = "/usr/bin/python3"

try:
    import scipy  # noqa: F401
except ImportError:
    # Another python3 may stand first on PATH; Debian's packages belong to Debian's own.
    if os.path.exists(DEBIANS_PYTHON) and os.path.realpath(sys.executable) != os.path.realpath(DEBIANS_PYTHON):
        os.execv(DEBIANS_PYTHON, [DEBIANS_PYTHON, *sys.argv])
    sys.exit("bench/run.py needs NumPy and SciPy (Debian: python3-scipy); ./run setup installs them")

import contestants  # noqa: E402
import machine  # noqa: E402
from table import Aim, Table, at_least, at_most, median  # noqa: E402

PAPERS = [("cubic", 3), ("thin_plate_spline", 2)]
FORMULA = {"cubic": "r^3", "thin_plate_spline": "r^2 log r", "linear": "r"}


def case(kernel, dim):
    return f"{kernel}_{dim}d"


def words(kernel, dim):
    return f"{FORMULA[kernel]} in {dim}D"


def others_on(cores, rounds):
    """On one core, where the clock is processor time, other programs do not count."""
    return 0.0 if cores.count == 1 else median([r["others"] for r in rounds])


def fit_section(table, cores, sizes, turns):
    """Fit against bare Cholesky and SciPy; returns the rounds, for the breakdown."""
    table.section(f"FIT on {cores.words}", "ours: fit_values(), everything included: merging, condition estimate, "
                  "refinement")
    every = {}
    scipy_side = contestants.SciPySide(cores)
    for kernel, dim in PAPERS:
        for n in sizes:
            rounds, against_scipy, again = [], [], []
            for _ in range(turns(n)):
                these = contestants.rounds("bench_fit", f"fit/{case(kernel, dim)}/{n}", cores, 2 if n < 3000 else 1)
                theirs = [scipy_side.fit(kernel, dim, n) for _ in these]
                against_scipy.append((median([r["fit"] for r in these]), median(theirs)))
                again.append((median([r["fit_again"] for r in these]), median(theirs)))
                rounds += these
            every[kernel, dim, n] = rounds
            aim_cholesky = at_most(1.5) if n == 1600 and cores.count == 1 else None
            aim_scipy = at_least(1.5 if n < 3000 else 2.0) if n >= 1600 else None
            fits = [r["fit"] for r in rounds]
            table.head(f"{words(kernel, dim)}, N = {n}", others_on(cores, rounds))
            table.times("bare Cholesky, warm memory", fits, [r["cholesky_warm"] for r in rounds], aim_cholesky)
            table.times("bare Cholesky, fresh memory", fits, [r["cholesky_fresh"] for r in rounds], aim_cholesky)
            table.speedup("SciPy's fit, a dense LU", *zip(*against_scipy), aim_scipy)
            table.speedup("the same, in memory of a fit before", *zip(*again), None)
    scipy_side.close()
    return every


def breakdown_section(table, every):
    table.section("WHERE A FIT'S TIME GOES, one core", "theirs: the whole fit; parts are measured again, one by one, "
                  "in the same rounds")
    for (kernel, dim, n), rounds in every.items():
        if n < 1600 and any(size >= 1600 for _, _, size in every):
            continue
        fits = [r["fit"] for r in rounds]
        table.head(f"{words(kernel, dim)}, N = {n}")

        def part(label, seconds):
            table.share(label, [seconds(r) for r in rounds], fits)

        part("Cholesky", lambda r: r["cholesky_warm"])
        part("new memory pages", lambda r: r["pages"])
        part("kernel matrix", lambda r: r["kernel_matrix"])
        part("projection and norm (rest of factorization)", lambda r: r["factorization"] - r["cholesky_warm"]
             - r["pages"] - r["kernel_matrix"])
        part("condition estimate", lambda r: r["condition"])
        part("two solves", lambda r: 2 * r["solve"])
        part("two residuals", lambda r: 2 * r["residual"])
        part("all else", lambda r: r["fit"] - r["factorization"] - r["condition"] - 2 * r["solve"] - 2 * r["residual"])


def edit_section(table, quick):
    """A step of a drag, from constraints to a function, beside a full fit of the same constraints."""
    one_core = contestants.one_core()
    table.section("EDITING on one core", "a step of a drag: constraints in, a function out, by bordering the last full "
                  "fit. Theirs, unless said: fit()")
    for kernel, dim in PAPERS:
        for n in [100] if quick else [100, 1000, 3000]:
            rounds = contestants.rounds("bench_edit", f"edit/{case(kernel, dim)}/{n}", one_core, 1 if quick else 5)
            fits = [r["fit"] for r in rounds]
            large = n == 3000
            table.head(f"{words(kernel, dim)}, N = {n}")
            table.speedup("one row dragged", [r["row"] for r in rounds], fits, at_least(50) if large else None)
            table.times("one row dragged / 8 ms", [r["row"] for r in rounds], [0.008] * len(rounds),
                        at_most(1.0) if large else None)
            table.speedup("a constraint and its normal dragged", [r["pair"] for r in rounds], fits, None)
            table.speedup("a value changed", [r["value"] for r in rounds], fits, None)
            table.speedup("twenty rows dragged", [r["twenty"] for r in rounds], fits, None)
            table.share("one solve / one row dragged", [r["solve"] for r in rounds], [r["row"] for r in rounds])
            # The number that the aim is about is the difference itself; theirs is what fit() misses constraints by.
            table.errors("field values / fit's residual", max(r["difference"] for r in rounds),
                         max(r["residual"] for r in rounds), Aim("<=", 1e-8))


def memory_section(table, n):
    table.section(f"MEMORY at N = {n}", "growth of the process's peak, one process each, in units of N^2 doubles")
    square = 8.0 * n * n
    one_core = contestants.one_core()
    cholesky = contestants.peak_memory("cholesky", n, one_core) / square
    aim = at_most(2.5) if n >= 1600 else None
    for kernel, dim in PAPERS:
        ours = contestants.peak_memory(case(kernel, dim), n, one_core) / square
        theirs = contestants.scipy_peak_memory(kernel, dim, n, one_core) / square
        table.head(words(kernel, dim))
        table.sizes("N^2 doubles", ours, 1.0, aim)
        table.sizes("bare Cholesky", ours, cholesky, None)
        table.sizes("SciPy's fit", ours, theirs, None)


def evaluation_section(table, repetitions, quick):
    one_core = contestants.one_core()
    table.section("EVALUATION on one core", "billions of kernel evaluations a second; 2000 centers, 4608 points. "
                  "Ceiling: a loop written by hand for that case")
    scipy_side = contestants.SciPySide(one_core)
    best = None
    for kernel, dim in [(k, d) for k in FORMULA for d in (2, 3)]:
        if quick and (kernel, dim) not in PAPERS:
            continue
        rounds = contestants.rounds("bench_evaluate", f"evaluate/{case(kernel, dim)}", one_core, repetitions)
        sets = [name for name in ("avx512", "avx2", "portable") if f"{name}_values" in rounds[0]]
        best = sets[0]
        ours = [r[f"{best}_values"] for r in rounds]
        table.head(f"{words(kernel, dim)}, values")
        for name in sets:
            if f"{name}_ceiling" in rounds[0]:
                table.rates(f"{name} / {name} ceiling", [r[f"{name}_values"] for r in rounds],
                            [r[f"{name}_ceiling"] for r in rounds], at_least(0.8))
        for name in sets:
            table.rates(f"{name} / plain scalar loop", [r[f"{name}_values"] for r in rounds],
                        [r["plain"] for r in rounds], None)
        theirs = [scipy_side.evaluate(kernel, dim) for _ in range(max(1, repetitions // 2))]
        table.rates(f"{best} / SciPy", [median(ours)] * len(theirs), theirs, None)
        table.rates(f"Interpolant / bare {best} loop", [r["interpolant_values"] for r in rounds], ours, None)
        table.head(f"{words(kernel, dim)}, values and gradients")
        for name in sets:
            table.rates(f"{name} / its values alone", [r[f"{name}_gradients"] for r in rounds],
                        [r[f"{name}_values"] for r in rounds], None)
    scipy_side.close()


def error_section(table, quick):
    table.section("ERROR OF A SUM", "largest error over sum |w phi|, 20000 centers, exact sums in long double; theirs: "
                  "the plain loop's")
    for kernel, dim in PAPERS[:1] if quick else [(k, d) for k in FORMULA for d in (2, 3)]:
        error = contestants.rounds("bench_evaluate", f"error/{case(kernel, dim)}", contestants.one_core(), 1)[0]
        table.head(words(kernel, dim))
        for name in ("avx512", "avx2", "portable"):
            if name in error:
                # The number that the aim is about is the error itself, not the ratio.
                table.errors(name, error[name], error["plain"], Aim("<=", 1.5e-16))


def threads_section(table, repetitions):
    everything = contestants.all_cores()
    table.section("THREADS", "one evaluation of an Interpolant, 2000 centers, 32768 points; wall time, then processor "
                  "time: all threads together")
    for kernel, dim in PAPERS:
        rounds = contestants.rounds("bench_evaluate", f"threads/{case(kernel, dim)}", everything, repetitions)
        alone = [r["1"] for r in rounds]
        table.head(words(kernel, dim), others_on(everything, rounds))
        for count in sorted(int(key) for key in rounds[0] if key.isdigit() and key != "1"):
            table.speedup(f"{count} threads, theirs: one", [r[str(count)] for r in rounds], alone,
                          at_least(0.8 * count))
            table.times(f"{count} threads, processor time", [r[f"{count}_work"] for r in rounds],
                        [r["1_work"] for r in rounds], at_most(1.2))


BUNNY = pathlib.Path("/usr/share/glmark2/models/bunny.obj")


def extraction_section(table, repetitions):
    """The paper's bunny: its fit and its polygons, beside the paper's own times and the bare cost of the field."""
    if not BUNNY.exists():
        print(f"\nEXTRACTION\n  left out: {BUNNY} is missing (Debian: glmark2-data)")
        return
    one, everything = contestants.one_core(), contestants.all_cores()
    for cores in [one] + ([everything] if everything.count > 1 else []):
        table.section(f"EXTRACTION on {cores.words}", "the bunny of 800 boundary and 800 normal constraints, 100 cubes "
                      "across. Bare: as many values and gradients, in one batch each")
        rounds = contestants.rounds("bench_extract", "extract/bunny", cores, repetitions)
        fits, extractions = [r["fit"] for r in rounds], [r["extraction"] for r in rounds]
        both = [a + b for a, b in zip(fits, extractions)]
        table.head(f"{rounds[0]['faces']:.0f} triangles, smallest angle {rounds[0]['smallest_angle']:.0f} degrees",
                   others_on(cores, rounds))
        table.times("extraction / bare evaluations", extractions, [r["bare"] for r in rounds], at_most(1.5))
        table.times("fit and extraction / one second", both, [1.0] * len(both),
                    at_most(1.0) if cores.count == 2 else None)
        table.speedup("fit / the paper's, 103 s", fits, [103.0] * len(fits), None)
        table.speedup("extraction / the paper's, 463 s", extractions, [463.0] * len(fits), None)
        # The steps' own clocks are wall clocks.
        for step in ("lattice", "assemble", "seeds", "improve", "polish") if cores.count > 1 else ():
            table.share(f"{step} / extraction", [r[step] for r in rounds], extractions)
    if everything.count > 1:
        rounds = contestants.rounds("bench_extract", "threads/bunny", everything, repetitions)
        table.head("threads", others_on(everything, rounds))
        alone = [r["1"] for r in rounds]
        for count in sorted(int(key) for key in rounds[0] if key.isdigit() and key != "1"):
            table.speedup(f"{count} threads, theirs: one", [r[str(count)] for r in rounds], alone, None)
            table.times(f"{count} threads, processor time", [r[f"{count}_work"] for r in rounds],
                        [r["1_work"] for r in rounds], at_most(1.2))


def tracing_section(table, quick):
    """The bunny's picture: what a ray pays for the promise that it cannot miss."""
    if not BUNNY.exists():
        print(f"\nRAY TRACING\n  left out: {BUNNY} is missing (Debian: glmark2-data)")
        return
    pixels = 16 if quick else 512
    cores = contestants.all_cores()
    table.section(f"RAY TRACING on {cores.words}", f"the same bunny, {pixels} x {pixels} pixels, with shadows. Ours: "
                  "by proven bounds; theirs: by the paper's 2,000 samples")
    rounds = contestants.rounds("bench_trace", f"trace/bunny/{pixels}", cores, 1)
    table.head(f"{rounds[0]['bounds']:.0f} boxes asked for a bound", others_on(cores, rounds))
    table.times("picture", [r["rigorous"] for r in rounds], [r["heuristic"] for r in rounds], None)
    table.sizes("evaluations a camera ray", median([r["rigorous_evaluations"] for r in rounds]),
                median([r["heuristic_evaluations"] for r in rounds]), None)


def particles_section(table, quick):
    """A step of floaters: linear in their number, and the paper's way beside it in the same rounds."""
    counts = [100] if quick else [100, 300, 1000, 3000, 5000, 10000, 20000]
    one, everything = contestants.one_core(), contestants.all_cores()
    for cores in [one] + ([everything] if everything.count > 1 and not quick else []):
        table.section(f"FLOATERS on {cores.words}", "a step on an interpolating surface of 100 constraints. Theirs, "
                      "unless said: the same step with Witkin & Heckbert's O(r^2) repulsion")
        every = {}
        for count in counts:
            rounds = every[count] = contestants.rounds("bench_particles", f"floaters/{count}", cores, 1 if quick else 3)
            table.head(f"{rounds[0]['floaters']:.0f} floaters", others_on(cores, rounds))
            steps = [r["step"] for r in rounds]
            table.speedup("step / with all pairs", steps,
                          [r["step"] - r["repulsion"] + r["all_pairs"] for r in rounds], None)
            if count == 5000:
                table.times("step / 16 ms", steps, [0.016] * len(steps), at_most(1.0) if cores.count == 2 else None)
            table.share("repulsion / step", [r["repulsion"] for r in rounds], steps)
        if len(every) > 1:
            per_floater = {count: [r["step"] / r["floaters"] for r in rounds] for count, rounds in every.items()}
            table.head("linear: a floater's share of a step", others_on(cores, every[20000]))
            table.times("among 20,000 / among 1,000", per_floater[20000], per_floater[1000], at_most(1.5))
        rounds = contestants.rounds("bench_particles", "drag/150", cores, 1 if quick else 3)
        table.head(f"{rounds[0]['floaters']:.0f} floaters on two blobby spheres that are dragged",
                   others_on(cores, rounds))
        table.speedup("step / the paper's 150 at 10 Hz", [r["step"] for r in rounds], [0.1] * len(rounds), None)


def live_section(table, quick):
    """What editing large documents costs the thread that a window waits for; full fits go on beside it."""
    cores = contestants.all_cores()
    table.section(f"LARGE DOCUMENTS on {cores.words}", "the longest of 180 steps at 60 Hz (poll, edit, ask for the shape) "
                  "on the window's thread, against a frame at 30 Hz; r^2 log r in 2D")
    for n in [1000] if quick else [1000, 3000, 5000]:
        rounds = contestants.rounds("bench_live", f"live/{n}", cores, 1 if quick else 3)
        table.head(f"N = {n}", others_on(cores, rounds))
        for words, way in (("one and its normal dragged", "one"), ("another moved every step", "each"),
                           ("sixty of them dragged", "sixty"), ("kernel changed amid a drag", "kernel")):
            table.times(f"{words}: {median([r[way + '_answers'] for r in rounds]):.0f} shapes/s",
                        [r[way + "_longest"] for r in rounds], [0.033] * len(rounds),
                        at_most(1.0) if cores.count == 2 and way != "kernel" else None)
        table.times("quitting amid a full fit", [r["quit"] for r in rounds], [0.033] * len(rounds),
                    at_most(1.0) if cores.count == 2 else None)


def frame_section(table, quick):
    """The curve editor's frames while a constraint is dragged, from the event to the pixels, without a graphics card."""
    if not (contestants.PROGRAMS / "sandbox2d").exists():
        print("\nFRAMES\n  sandbox2d was not built: SDL2, OpenGL or Dear ImGui are not installed")
        return
    cores = contestants.all_cores()
    table.section(f"FRAMES on {cores.words}", "sandbox2d, 1280 x 800: the median frame of a drag, against the time of a "
                  "frame at 30 Hz")
    every = {}
    for words, script in (("everything shown, 60 constraints", "drag_all"), ("the curve alone", "drag_curve")):
        rounds = every[script] = contestants.frames(script, "sixty.json", cores, 1 if quick else 5)
        table.head(words, others_on(cores, rounds))
        table.times("frame / 33 ms", [r["median"] for r in rounds], [0.033] * len(rounds),
                    at_most(1.0) if cores.count == 2 and script == "drag_all" else None)
        table.times("slowest tenth / 33 ms", [r["p90"] for r in rounds], [0.033] * len(rounds), None)


def main():
    parser = argparse.ArgumentParser(description="Seesaw's benchmarks, as a table with ratios and aims")
    parser.add_argument("--quick", action="store_true", help="a few seconds: only to see that everything runs")
    parser.add_argument("--full", action="store_true", help="also N = 6000")
    parser.add_argument("--programs", default=HERE.parent / "build/release/bin", type=pathlib.Path,
                        help="where bench_fit, bench_edit, bench_evaluate, bench_extract, bench_trace, bench_particles, "
                        "bench_live, bench_memory and sandbox2d are")
    options = parser.parse_args()
    contestants.PROGRAMS = options.programs

    sizes = [400] if options.quick else [400, 1600, 3000] + ([6000] if options.full else [])
    # A median, also of the largest: the first fit after a while may pay for memory that a virtual machine has given back.
    turns = (lambda n: 1) if options.quick else (lambda n: 3)
    table = Table(judge=not options.quick)
    table.facts(machine.facts(contestants.context()))
    every = fit_section(table, contestants.one_core(), sizes, turns)
    if contestants.all_cores().count > 1:
        fit_section(table, contestants.all_cores(), sizes, turns)
    breakdown_section(table, every)
    edit_section(table, options.quick)
    memory_section(table, 400 if options.quick else 3000)
    evaluation_section(table, 1 if options.quick else 7, options.quick)
    error_section(table, options.quick)
    if contestants.all_cores().count > 1:
        threads_section(table, 1 if options.quick else 5)
    extraction_section(table, 1 if options.quick else 5)
    tracing_section(table, options.quick)
    particles_section(table, options.quick)
    live_section(table, options.quick)
    frame_section(table, options.quick)
    table.summary(machine.load())


if __name__ == "__main__":
    main()
