"""`seesaw blend`: the soft union of scenes, in the plane and in space."""

import json
import math
import unittest

from support import BALL, COMPASS, CliTest, boundary, exterior, interior, scene


def ring(x, y, radius=1, n=16, **more):
    """A circle of boundary constraints with normals."""
    directions = [(math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)) for i in range(n)]
    return [boundary(x + radius * c, y + radius * s, normal=[c, s], offset=0.1, **more) for c, s in directions]


class Blend(CliTest):
    def read(self, name):
        return json.loads((self.folder / name).read_text())

    def values(self, name, *points):
        self.write("points.txt", "".join(" ".join(map(repr, p)) + "\n" for p in points))
        return [float(line) for line in self.good("eval", name, "points.txt").splitlines()]

    def test_two_circles(self):
        self.write("a.json", scene(2, ring(-0.7, 0, label="mine"), title="A", kernel="cubic"))
        self.write("b.json", scene(2, ring(0.7, 0), title="B", kernel="cubic"))
        said = self.good("blend", "a.json", "b.json", "-o", "c.json").splitlines()
        self.assertEqual([line.split()[0] for line in said], ["a.json", "b.json", "together"])
        blended = self.read("c.json")
        self.assertEqual((blended["title"], blended["kernel"], blended["dimension"]), ("A + B", "cubic", 2))
        # The paper's rule, with circles for their functions: kept where outside the other.
        kept = [each["at"] for each in blended["constraints"]]
        expected = [each["at"] for x in (-0.7, 0.7) for each in ring(x, 0)
                    if math.dist(each["at"], (-x, 0)) > 1.0001]
        self.assertEqual(kept, expected)
        self.assertTrue(all(each.get("label") == "mine" for each in blended["constraints"] if each["at"][0] < -1))
        # One piece, without the wall between, and no bulge: the waist is filled, but not beyond the circles' tangent.
        values = self.values("c.json", (0, 0), (-0.7, 0), (0.7, 0), (0, 1.02), (1.8, 0), (0, 0.6))
        self.assertEqual([v > 0 for v in values], [True, True, True, False, False, True])

    def test_order_does_not_matter(self):
        for name, x in (("a.json", -0.7), ("b.json", 0.7), ("c.json", 2)):
            self.write(name, scene(2, ring(x, 0)))
        self.good("blend", "a.json", "b.json", "c.json", "-o", "abc.json")
        self.good("blend", "c.json", "a.json", "b.json", "-o", "cab.json")
        points = [(0.37 * i - 2, 0.11 * i - 1) for i in range(15)]
        for one, two in zip(self.values("abc.json", *points), self.values("cab.json", *points)):
            self.assertAlmostEqual(one, two, delta=1e-8)

    def test_in_space(self):
        def ball(x):
            return scene(3, [dict(each, at=[each["at"][0] + x, *each["at"][1:]]) for each in BALL["constraints"]])

        self.write("a.json", ball(0))
        self.write("b.json", ball(1.2))
        said = self.good("blend", "a.json", "b.json", "-o", "c.json", "--kernel", "linear")
        self.assertIn("6 constraints kept, 1 in other objects dropped", said)  # the pole within the other
        self.assertEqual(self.read("c.json")["kernel"], "linear")
        self.good("info", "c.json")

    def test_what_is_refused(self):
        self.write("compass.json", COMPASS)
        self.write("ball.json", BALL)
        self.write("small.json", scene(2, [boundary(0.1, 0), boundary(-0.1, 0), boundary(0, 0.1), interior(0, 0)]))
        self.write("bad.json", scene(2, [boundary(0, 0), interior(0, 0)]))
        before = self.files()
        self.refused("blend", "compass.json", "-o", "x.json", says="at least two scenes")
        self.refused("blend", "compass.json", "ball.json", "-o", "x.json", says=["ball.json: is a scene of 3", "has 2"])
        self.refused("blend", "compass.json", "bad.json", "-o", "x.json", says=["bad.json: ", "constraints[0]"])
        self.refused("blend", "compass.json", "gone.json", "-o", "x.json", says="gone.json")
        self.refused("blend", "compass.json", "compass.json", "-o", "x.json", "--kernel", "gauss", says="--kernel")
        self.refused("blend", "compass.json", "small.json", "-o", "gone/x.json", says="there is no folder gone")
        self.assertEqual(self.files(), before)

    def test_nothing_left(self):
        self.write("a.json", scene(2, ring(0, 0)))
        self.write("b.json", scene(2, ring(0, 0, radius=3) + [exterior(9, 9)]))
        self.write("inner.json", scene(2, [boundary(0.1, 0), boundary(-0.1, 0), boundary(0, 0.1), interior(0, 0)]))
        # The small one disappears in the large one.
        said = self.good("blend", "a.json", "b.json", "-o", "c.json")
        self.assertIn("0 constraints kept", said)


if __name__ == "__main__":
    unittest.main()
