"""SciPy's RBFInterpolator on the data of bench/data.h.

    scipy_side.py answer                    reads lines "fit|evaluate kernel dim n", answers each with seconds
    scipy_side.py memory kernel dim n       prints by how many bytes a fit raises this process's peak
"""

import os
import sys
import time

import numpy as np
from scipy.interpolate import RBFInterpolator

# As bench/turns.h: on one core processor time, on several wall time.
now = time.process_time if len(os.sched_getaffinity(0)) == 1 else time.perf_counter


def spread_points(dim, n, first=0):
    """As bench/data.h, one point a row."""
    g = 2.0
    for _ in range(60):
        g = (1.0 + g) ** (1.0 / (dim + 1))
    turns = np.outer(np.arange(first + 1, first + n + 1), g ** -np.arange(1.0, dim + 1.0))
    return 2.0 * (turns - np.floor(turns)) - 1.0


def smooth_values(points):
    return np.cos(3.0 * points[:, 0]) * np.sin(2.0 * points[:, -1])


def fit(kernel, dim, n):
    points = spread_points(dim, n)
    values = smooth_values(points)
    start = now()
    # SciPy's thin plate and linear splines have other signs, but the same interpolant.
    interpolant = RBFInterpolator(points, values, kernel=kernel, degree=1)
    return interpolant, now() - start


def evaluate(kernel, dim, n):
    interpolant, _ = fit(kernel, dim, n)
    points = spread_points(dim, 4608, n)
    start = now()
    interpolant(points)
    return (now() - start) / (n * len(points))


def status_bytes(key):
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith(key + ":"))


def answer():
    fit("cubic", 3, 400)  # loads and starts everything
    for line in sys.stdin:
        question, kernel, dim, n = line.split()
        if question == "fit":
            print(fit(kernel, int(dim), int(n))[1], flush=True)
        else:
            print(evaluate(kernel, int(dim), int(n)), flush=True)


def memory(kernel, dim, n):
    before = status_bytes("VmRSS")
    fit(kernel, int(dim), int(n))
    print(status_bytes("VmHWM") - before)


if __name__ == "__main__":
    {"answer": answer, "memory": memory}[sys.argv[1]](*sys.argv[2:])
