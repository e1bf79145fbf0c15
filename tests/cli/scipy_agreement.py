"""Our digits against SciPy's: `seesaw eval` and scipy.interpolate.RBFInterpolator must give the same function.

Same kernel, same degree (1), same smoothing; SciPy's "linear" is -r, which changes the sign of the weights alone.
Any data can be said as a scene: value 0 is a boundary constraint, above it interior, below it exterior.

The bound is 1e-9 of the range of SciPy's values over the points, and it is a bound on two programs' rounding. For
centers q apart, the smallest eigenvalue of the system falls like q^b with phi ~ r^b, so digits are lost like q^-b, in
SciPy's LU as in our Cholesky. Clusters are therefore as tight as q^-b = 1e6 allows for r^3 (q = 1e-2) and r^2 log r
(q = 1e-3), and 1e-4 for r. Values on them are those of a smooth function, as measurements are: random values q apart
ask for slopes of 1 / q, and lose as many digits again.

Where SciPy itself has not nine digits left (tighter clusters; random values at a thousand random points), a third
solution judges: the same system refined with residuals in 80-bit arithmetic. There we may be wrong by 1e-9 of the
range, or by ten times as much as SciPy is.

Run by ctest as `python3 scipy_agreement.py <path of seesaw>`. 77 means that there is no SciPy to ask.
"""

import sys
import unittest

from support import CliTest, boundary, exterior, interior, scene

try:
    import numpy as np
    import scipy.linalg
    from scipy.interpolate import RBFInterpolator
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

GROWTH = {"thin_plate_spline": 2, "cubic": 3, "linear": 1}
TIGHTNESS = {"thin_plate_spline": 1e-3, "cubic": 1e-2, "linear": 1e-4}
SMOOTHINGS = [1e-3, 0.5]
AGREEMENT = 1e-9


def smooth_values(centers):
    return np.sin(3 * centers[:, 0]) + centers[:, 1] ** 2 - 0.4 * centers[:, -1] - 0.2


def scattered(random, n, dimension):
    """Points uniform in a box, and values with nothing to do with them; every seventh is 0."""
    values = random.normal(size=n)
    values[::7] = 0
    return random.uniform(-1, 1, (n, dimension)), values


def measured(random, n, dimension):
    """Points uniform in a box, and values of a smooth function."""
    centers = random.uniform(-1, 1, (n, dimension))
    return centers, smooth_values(centers)


def clustered(random, n, dimension, apart):
    """Clusters of five points, no two nearer than `apart`, and values of a smooth function."""
    middles = []
    while 5 * len(middles) < n:
        middle = random.uniform(-1, 1, dimension)
        if all(np.linalg.norm(middle - other) > 0.06 for other in middles):
            middles.append(middle)
    places = np.stack(np.meshgrid(*[[-1.5, 0, 1.5]] * dimension), axis=-1).reshape(-1, dimension)
    clusters = [middle + apart * random.permutation(places)[:5] for middle in middles]
    centers = np.vstack(clusters)[:n] + apart * random.uniform(-0.15, 0.15, (n, dimension))
    return centers, smooth_values(centers)


def scipy_values(kernel, smoothing, centers, values, points):
    return RBFInterpolator(centers, values, kernel=kernel, degree=1, smoothing=smoothing)(points)


def refined_values(kernel, centers, values, points):
    """SciPy's system without smoothing, refined with 80-bit residuals until they are rounding."""
    long = np.longdouble
    middle = centers.mean(axis=0)
    centers, points, values = [np.asarray(a, dtype=long) for a in (centers - middle, points - middle, values)]

    def phi(a, b):
        square = ((a[:, None, :] - b[None, :, :]) ** 2).sum(axis=2)
        if kernel == "thin_plate_spline":
            return square * np.log(np.where(square > 0, square, 1)) / 2
        return -np.sqrt(square) if kernel == "linear" else square * np.sqrt(square)

    def linear(a):
        return np.hstack([np.ones((len(a), 1), dtype=long), a])

    n, m = len(centers), centers.shape[1] + 1
    matrix = np.zeros((n + m, n + m), dtype=long)
    matrix[:n, :n] = phi(centers, centers)
    matrix[:n, n:] = linear(centers)
    matrix[n:, :n] = linear(centers).T
    wanted = np.concatenate([values, np.zeros(m, dtype=long)])
    factors = scipy.linalg.lu_factor(matrix.astype(float))
    solution = np.zeros(n + m, dtype=long)
    for _ in range(10):
        solution += scipy.linalg.lu_solve(factors, (wanted - matrix @ solution).astype(float))
    missed = np.abs(wanted - matrix @ solution).max()
    assert missed < 1e-9 * np.abs(values).max(), f"the refined solution misses by {missed}"
    return phi(points, centers) @ solution[:n] + linear(points) @ solution[n:]


class Agreement(CliTest):
    def our_values(self, kernel, smoothing, centers, values, points):
        constraints = [
            boundary(*at) if value == 0 else interior(*at, value=value) if value > 0 else exterior(*at, value=value)
            for at, value in zip(centers.tolist(), values.tolist())]
        self.write("scene.json", scene(centers.shape[1], constraints, kernel=kernel, smoothing=smoothing))
        self.write("points.txt", "".join(" ".join(map(repr, point)) + "\n" for point in points.tolist()))
        return np.array(self.good("eval", "scene.json", "points.txt").split(), dtype=float)

    def points_around(self, random, centers):
        """In and around the box of the centers, and some at the centers and very near them."""
        low, high = centers.min(axis=0), centers.max(axis=0)
        room = max(0.3 * (high - low).max(), 0.1)
        around = random.uniform(low - room, high + room, (400, centers.shape[1]))
        some = centers[random.integers(len(centers), size=50)]
        return np.vstack([around, some, some + 1e-3 * random.normal(size=some.shape)])

    def agree(self, random, kernel, smoothing, centers, values):
        points = self.points_around(random, centers)
        theirs = scipy_values(kernel, smoothing, centers, values, points)
        ours = self.our_values(kernel, smoothing, centers, values, points)
        worst = np.abs(ours - theirs).max() / (theirs.max() - theirs.min())
        self.assertLessEqual(worst, AGREEMENT)

    def each(self):
        """Every kernel in every dimension, with a generator of its own."""
        for dimension in (2, 3):
            for kernel in GROWTH:
                yield dimension, kernel, np.random.default_rng([dimension, GROWTH[kernel]])

    def test_scattered(self):
        for dimension, kernel, random in self.each():
            for data, n in [(scattered, dimension + 1), (scattered, 10), (scattered, 100), (measured, 100),
                            (measured, 300), (measured, 1000)]:
                with self.subTest(dimension=dimension, kernel=kernel, data=data.__name__, n=n):
                    self.agree(random, kernel, 0.0, *data(random, n, dimension))

    def test_clustered(self):
        for dimension, kernel, random in self.each():
            for n in (10, 100, 300, 1000):
                with self.subTest(dimension=dimension, kernel=kernel, n=n):
                    self.agree(random, kernel, 0.0, *clustered(random, n, dimension, TIGHTNESS[kernel]))

    def test_smoothing(self):
        for dimension, kernel, random in self.each():
            for n in (dimension + 1, 10, 100, 300):
                for smoothing in SMOOTHINGS:
                    with self.subTest(dimension=dimension, kernel=kernel, n=n, smoothing=smoothing):
                        self.agree(random, kernel, smoothing, *scattered(random, n, dimension))
                        self.agree(random, kernel, smoothing, *clustered(random, n, dimension, 1e-4))

    def test_any_unit_and_any_origin(self):
        """Millimeters, or meters on a map: the same function in other coordinates."""
        for dimension, kernel, random in self.each():
            for size, offset in [(1e-3, 0.0), (1e4, 0.0), (1.0, 1e3)]:
                with self.subTest(dimension=dimension, kernel=kernel, size=size, offset=offset):
                    centers, values = scattered(random, 100, dimension)
                    points = self.points_around(random, centers)
                    # Coordinates are rounded after they are moved, so that both programs see the same ones.
                    moved, asked = size * centers + offset, size * points + offset
                    # SciPy works at the origin, where it has all its digits; the differences are exact to rounding.
                    theirs = scipy_values(kernel, 0.0, (moved - offset) / size, values, (asked - offset) / size)
                    ours = self.our_values(kernel, 0.0, moved, values, asked)
                    self.assertLessEqual(np.abs(ours - theirs).max() / np.ptp(theirs), AGREEMENT)

    def test_fewer_centers_than_scipy_takes(self):
        """One center: a constant. Two: linear along their line and level across it (core/rbf/solve.h)."""
        for dimension, kernel, random in self.each():
            with self.subTest(dimension=dimension, kernel=kernel):
                centers, values = random.uniform(-1, 1, (2, dimension)), np.array([1.5, -0.5])
                points = random.uniform(-2, 2, (100, dimension))
                ours = self.our_values(kernel, 0.0, centers[:1], values[:1], points)
                self.assertLessEqual(np.abs(ours - 1.5).max(), AGREEMENT)
                along = (centers[1] - centers[0]) / np.sum((centers[1] - centers[0]) ** 2)
                expected = 1.5 - 2 * (points - centers[0]) @ along
                ours = self.our_values(kernel, 0.0, centers, values, points)
                self.assertLessEqual(np.abs(ours - expected).max() / np.ptp(expected), AGREEMENT)

    @unittest.skipUnless(np.finfo(np.longdouble).eps < 1e-18, "long double is no longer than double here")
    def test_hard_systems_are_judged_by_a_third(self):
        for dimension, kernel, random in self.each():
            for what, data in [
                    ("clusters of 1e-3, 100", clustered(random, 100, dimension, 1e-3)),
                    ("clusters of 1e-3, 300", clustered(random, 300, dimension, 1e-3)),
                    ("clusters of 1e-4, 100", clustered(random, 100, dimension, 1e-4)),
                    ("scattered, 300", scattered(random, 300, dimension)),
                    ("scattered, 1000", scattered(random, 1000, dimension))]:
                with self.subTest(dimension=dimension, kernel=kernel, data=what):
                    points = self.points_around(random, data[0])
                    truth = refined_values(kernel, *data, points)
                    theirs = scipy_values(kernel, 0.0, *data, points)
                    ours = self.our_values(kernel, 0.0, *data, points)
                    error = np.abs(ours - truth).max()
                    self.assertLessEqual(error, max(AGREEMENT * np.ptp(truth), 10 * np.abs(theirs - truth).max()))


if __name__ == "__main__":
    unittest.main()
