"""The same result, to the bit, on one core and on all of them: no sum may depend on who adds it up."""

import math
import os
import random
import subprocess
import unittest

from support import PROGRAM, CliTest, exterior, interior, scene


@unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "this machine has one core")
class Threads(CliTest):
    def outputs(self, document, points):
        self.write("scene.json", document)
        (self.folder / "points.txt").write_text(points)
        everywhere = os.sched_getaffinity(0)
        for cores, blas in ((everywhere, None), ({min(everywhere)}, None), (everywhere, "1")):
            environment = dict(os.environ)
            if blas:
                environment["OPENBLAS_NUM_THREADS"] = blas
            result = subprocess.run(
                [PROGRAM, "eval", "scene.json", "points.txt", "--gradient"], cwd=self.folder, env=environment,
                preexec_fn=lambda cores=cores: os.sched_setaffinity(0, cores), capture_output=True, check=True)
            yield result.stdout

    def test_a_fit_and_its_values(self):
        for dimension, kernel in ((2, "thin_plate_spline"), (3, "cubic"), (3, "linear")):
            draw = random.Random(4)
            constraints = []
            for _ in range(700):
                at = [draw.uniform(-1, 1) for _ in range(dimension)]
                value = math.sin(3 * at[0]) + at[1]
                constraints.append((interior if value > 0 else exterior)(*at, value=value))
            points = "".join(" ".join(repr(draw.uniform(-2, 2)) for _ in range(dimension)) + "\n" for _ in range(3000))
            first, *others = self.outputs(scene(dimension, constraints, kernel=kernel), points)
            self.assertEqual(first.count(b"\n"), 3000)
            for other in others:
                self.assertEqual(first, other)


if __name__ == "__main__":
    unittest.main()
