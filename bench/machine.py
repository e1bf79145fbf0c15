"""Where the numbers come from: processor, memory, libraries, and who else was at work."""

import os
import platform
import resource

import numpy
import scipy


def processor():
    try:
        with open("/proc/cpuinfo", encoding="ascii", errors="replace") as info:
            return next(line.split(":", 1)[1].strip() for line in info if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


def load():
    cores = len(os.sched_getaffinity(0))
    one_minute = os.getloadavg()[0]
    words = f"{one_minute:.1f} programs at work in the last minute (this one included), on {cores} cores"
    return words + ("" if one_minute < cores else '; rows on all cores say "busy" where that mattered')


def busy_seconds():
    """Processor seconds that anyone has worked on this machine since it started; 0 where nobody keeps the count."""
    try:
        with open("/proc/stat", encoding="ascii") as stat:
            user, nice, system, _idle, _wait, irq, softirq, steal = map(int, stat.readline().split()[1:9])
    except (OSError, ValueError):
        return 0.0
    return (user + nice + system + irq + softirq + steal) / os.sysconf("SC_CLK_TCK")


def own_seconds():
    """Processor seconds of this program and of those it started that have ended."""
    mine, children = resource.getrusage(resource.RUSAGE_SELF), resource.getrusage(resource.RUSAGE_CHILDREN)
    return mine.ru_utime + mine.ru_stime + children.ru_utime + children.ru_stime


def facts(context):
    """`context` is what bench_fit says about itself."""
    flags = [f"{name}={os.environ[name]}" for name in ("OPENBLAS_CORETYPE", "MKL_DEBUG_CPU_TYPE") if name in os.environ]
    return {
        "processor": f"{processor()}, {len(os.sched_getaffinity(0))} of {os.cpu_count()} cores",
        "loops": f"{context.get('loops', '?')}, chosen when the program started",
        "BLAS": context.get("blas", "?") + (f" (the environment says {', '.join(flags)})" if flags else ""),
        "against": f"SciPy {scipy.__version__}, NumPy {numpy.__version__}, Python {platform.python_version()}",
        "load": load(),
    }
