"""`seesaw eval`: points in, values and gradients out, a line for a line."""

import math
import random
import unittest

from support import BALL, COMPASS, CliTest, example_in


def compass_value(x, y):
    """The function of COMPASS in closed form."""
    def phi(u, v):
        square = u * u + v * v
        return 0.5 * square * math.log(square) if square > 0 else 0.0
    weight = 2 / (3 * math.log(2))
    around = phi(x - 1, y) + phi(x + 1, y) + phi(x, y - 1) + phi(x, y + 1)
    return weight * (phi(x, y) - around / 4) + 1


def compass_gradient(x, y):
    def part(u, v):
        square = u * u + v * v
        factor = math.log(square) + 1 if square > 0 else 0.0
        return (factor * u, factor * v)
    weight = 2 / (3 * math.log(2))
    parts = [(1, part(x, y)), (-0.25, part(x - 1, y)), (-0.25, part(x + 1, y)), (-0.25, part(x, y - 1)),
             (-0.25, part(x, y + 1))]
    return [weight * sum(share * each[d] for share, each in parts) for d in (0, 1)]


class Eval(CliTest):
    def setUp(self):
        super().setUp()
        self.write("compass.json", COMPASS)
        self.write("ball.json", BALL)

    def numbers(self, text):
        return [[float(word) for word in line.split(" ")] for line in text.splitlines()]

    def test_values(self):
        generator = random.Random(1)
        points = [(generator.uniform(-3, 3), generator.uniform(-3, 3)) for _ in range(300)] + [(0, 0), (1, 0), (0, -1)]
        out = self.good("eval", "compass.json", self.write("points.txt", "".join(f"{x!r} {y!r}\n" for x, y in points)))
        rows = self.numbers(out)
        self.assertEqual(len(rows), len(points))
        for (x, y), row in zip(points, rows):
            self.assertEqual(len(row), 1)
            self.assertAlmostEqual(row[0], compass_value(x, y), delta=1e-12)

    def test_gradients(self):
        generator = random.Random(2)
        points = [(generator.uniform(-3, 3), generator.uniform(-3, 3)) for _ in range(300)] + [(0, 0), (1, 0), (0, -1)]
        self.write("points.txt", "".join(f"{x!r} {y!r}\n" for x, y in points))
        rows = self.numbers(self.good("eval", "compass.json", "points.txt", "--gradient"))
        plain = self.numbers(self.good("eval", "compass.json", "points.txt"))
        for (x, y), row, (value,) in zip(points, rows, plain):
            self.assertEqual(len(row), 3)
            self.assertAlmostEqual(row[0], value, delta=1e-13)
            for found, expected in zip(row[1:], compass_gradient(x, y)):
                self.assertAlmostEqual(found, expected, delta=1e-12)

    def test_3d(self):
        out = self.good("eval", "ball.json", "-", "--gradient", stdin="0 0 0\n1 0 0\n0 0.5 0\n3 3 3\n")
        middle, rim, between, outside = self.numbers(out)
        self.assertAlmostEqual(middle[0], 1, delta=1e-13)
        self.assertAlmostEqual(rim[0], 0, delta=1e-13)
        self.assertTrue(0 < between[0] < 1 and outside[0] < 0)
        self.assertEqual([len(row) for row in (middle, rim, between, outside)], [4] * 4)
        self.assertLess(between[2], -0.1)  # gradients point inward: toward smaller y
        self.assertAlmostEqual(between[1], 0, delta=1e-13)

    def test_seventeen_digits_read_back(self):
        (value,), = self.numbers(self.good("eval", "compass.json", "-", stdin="0.1 0.2\n"))
        self.assertEqual(self.good("eval", "compass.json", "-", stdin="0.1 0.2\n"), "%.17g\n" % value)

    def test_separators(self):
        plain = self.good("eval", "compass.json", "-", stdin="0.25 -1.5\n")
        for line in ["0.25,-1.5", "0.25, -1.5", "0.25 ,-1.5", "0.25\t-1.5", "  0.25   -1.5  ", "\t0.25 \t , \t-1.5",
                     "+0.25 -15e-1", "0.25 -1.5\r", ".25,-1.5 \r"]:
            self.assertEqual(self.good("eval", "compass.json", "-", stdin=line + "\n"), plain, repr(line))
        self.assertEqual(self.good("eval", "compass.json", "-", stdin="0.25 -1.5"), plain, "no newline at the end")
        self.assertEqual(self.good("eval", "compass.json", "-", stdin="\ufeff0.25 -1.5\n"), plain, "a byte order mark")

    def test_remarks_stay_where_they_are(self):
        text = "# x, y\n\n0 0\n  # in between\n1 0\n \t\n\n0 1\n#last"
        lines = self.good("eval", "compass.json", "-", "--gradient", stdin=text).split("\n")
        for number, line in enumerate(text.split("\n")):
            if line.strip() and not line.strip().startswith("#"):
                self.assertEqual(len(lines[number].split()), 3)
            else:
                self.assertEqual(lines[number], line)
        self.assertEqual(len(lines), text.count("\n") + 2)  # the last line ends too
        self.assertEqual(self.good("eval", "compass.json", "-", stdin="# x\r\n\r\n"), "# x\n\n")

    def test_nothing_in_nothing_out(self):
        for gradient in [[], ["--gradient"]]:
            self.assertEqual(self.good("eval", "compass.json", "-", *gradient), "")
            self.assertEqual(self.good("eval", "ball.json", self.write("none.txt", "# none\n"), *gradient), "# none\n")

    def test_example_of_the_header(self):
        text = example_in("cli/points_file.h", "# x, y", "1e-3 -2")
        lines = self.good("eval", "compass.json", "-", stdin=text).splitlines()
        self.assertEqual(lines[0], "# x, y")
        self.assertAlmostEqual(float(lines[1]), compass_value(0.5, 0.25), delta=1e-13)
        self.assertAlmostEqual(float(lines[2]), compass_value(1e-3, -2), delta=1e-13)

    def test_batch_does_not_matter(self):
        generator = random.Random(3)
        lines = [f"{generator.uniform(-2, 2)!r},{generator.uniform(-2, 2)!r}\n" for _ in range(20_000)]
        self.write("many.csv", "".join(lines))
        many = self.good("eval", "compass.json", "many.csv", "--gradient").splitlines()
        self.assertEqual(len(many), len(lines))
        some = range(0, len(lines), 997)
        few = self.good("eval", "compass.json", "-", "--gradient", stdin="".join(lines[i] for i in some)).splitlines()
        self.assertEqual(few, [many[i] for i in some])

    def test_bad_lines_are_named(self):
        for text, line, says in [
                ("0 0\n1\n", 2, "expected 2 columns (x y), found 1"),
                ("0 0 0\n", 1, 'expected 2 columns (x y), found 3: "0 0 0"'),
                ("# x\n\n0 0\n1,,2\n", 4, "found 3"),
                ("0 0\n0 0,\n", 2, "found 3"),
                ("0,\n", 1, "column 2: expected a finite number, found nothing"),
                (",0\n", 1, "column 1: expected a finite number, found nothing"),
                ("x,y\n0,0\n", 1, 'column 1: expected a finite number, found "x"'),
                ("0 0\n0 1.5.2\n", 2, 'column 2: expected a finite number, found "1.5.2"'),
                ("0 0x10\n", 1, '"0x10"'),
                ("0 0\n0 -1e154\n", 2, 'column 2: "-1e154" is beyond 1e100'),
                ("0;0\n", 1, "expected 2 columns"),
                ("0 0\r\nnan 0\r\n", 2, 'column 1: expected a finite number, found "nan"'),
                ("0 inf\n", 1, '"inf"'),
                ("0 -Infinity\n", 1, '"-Infinity"'),
                ("0 1e999\n", 1, '"1e999"'),
                ("0 1 # remark\n", 1, "found 4"),
                ("0 " + "9" * 1000 + "z\n", 1, '9"...'),
                ("0 \x1b[31m\n", 1, '"\\u001b[31m"'),
        ]:
            self.write("points.txt", text)
            message = self.refused("eval", "compass.json", "points.txt", says=[f"points.txt:{line}: ", says])
            self.assertLess(len(message), 200)
            self.refused("eval", "compass.json", "-", stdin=text, says=[f"standard input:{line}: ", says])
        self.refused("eval", "ball.json", "-", stdin="0 0\n", says="expected 3 columns (x y z), found 2")

    def test_bad_files_are_named(self):
        self.refused("eval", "compass.json", "nothing.txt", says="nothing.txt: no such file")
        self.refused("eval", "compass.json", ".", says="is a folder")
        self.write("binary.txt", bytes(range(256)))
        self.refused("eval", "compass.json", "binary.txt", says="binary.txt:1: ")

    def test_to_a_file(self):
        self.write("points.txt", "# p\n0.5 0.5\n")
        expected = self.good("eval", "compass.json", "points.txt", "--gradient")
        for option in ["-o", "--output"]:
            self.assertEqual(self.good("eval", "compass.json", "points.txt", option, "out.txt", "--gradient"), "")
            self.assertEqual((self.folder / "out.txt").read_text(), expected)
        # A file over itself: read whole, then replaced.
        self.good("eval", "compass.json", "points.txt", "-o", "points.txt", "--gradient")
        self.assertEqual((self.folder / "points.txt").read_text(), expected)

    def test_a_failure_leaves_the_old_file(self):
        self.write("out.txt", "precious")
        before = self.files()
        self.refused("eval", "compass.json", "-", "-o", "out.txt", stdin="0 0\n0\n", says="standard input:2: ")
        self.assertEqual(self.files(), before)
        self.assertEqual((self.folder / "out.txt").read_text(), "precious")

    def test_no_place_for_the_file(self):
        self.write("plain", "a file")
        (self.folder / "there").mkdir()
        for path, says in [("gone/out.txt", "gone/out.txt: cannot be written: there is no folder gone"),
                           ("plain/out.txt", "plain is a file, not a folder"), ("there", "there: is a folder")]:
            self.refused("eval", "compass.json", "-", "-o", path, stdin="0 0\n", says=says)


if __name__ == "__main__":
    unittest.main()
