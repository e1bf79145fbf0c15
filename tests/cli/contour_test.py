"""`seesaw contour`: a curve as a picture in three formats, and as numbers."""

import json
import math
import struct
import unittest
import xml.etree.ElementTree

from support import BALL, COMPASS, CliTest, boundary, exterior, interior, scene


class Contour(CliTest):
    def setUp(self):
        super().setUp()
        self.write("compass.json", COMPASS)

    def draw(self, name, *options, scene_file="compass.json"):
        """The bytes of the file."""
        self.assertEqual(self.good("contour", scene_file, "-o", name, *options), "")
        return (self.folder / name).read_bytes()

    def polylines(self, *options, scene_file="compass.json"):
        """[(closed, [(x, y), ...]), ...] of a .csv."""
        lines = self.draw("curve.csv", *options, scene_file=scene_file).decode().splitlines()
        self.assertEqual(lines[0], "polyline,closed,x,y")
        result = []
        for line in lines[1:]:
            index, closed, x, y = line.split(",")
            if int(index) == len(result):
                result.append((closed == "1", []))
            self.assertEqual(int(index), len(result) - 1)
            result[-1][1].append((float(x), float(y)))
        return result

    def svg_size(self, data):
        root = xml.etree.ElementTree.fromstring(data)
        self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
        return [float(number) for number in root.get("viewBox").split()[2:]]

    def png_size(self, data):
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        return list(struct.unpack(">II", data[16:24]))

    # Numbers.

    def test_csv_is_the_curve(self):
        (closed, vertices), = self.polylines()
        self.assertTrue(closed)
        for at in [(1, 0), (-1, 0), (0, 1), (0, -1)]:
            self.assertIn(at, vertices)  # exactly
        self.write("vertices.csv", "".join(f"{x!r},{y!r}\n" for x, y in vertices))
        values = [float(line) for line in self.good("eval", "compass.json", "vertices.csv").splitlines()]
        self.assertEqual(len(values), len(vertices))
        self.assertLess(max(map(abs, values)), 1e-11)

    def test_csv_agrees_with_info(self):
        (_, vertices), = self.polylines()
        pairs = list(zip(vertices, vertices[1:] + vertices[:1]))
        facts = json.loads(self.good("info", "compass.json", "--json"))
        area = sum(a[0] * b[1] - b[0] * a[1] for a, b in pairs) / 2
        self.assertAlmostEqual(area, facts["area"], delta=1e-12)  # positive: the inside is on the left
        self.assertAlmostEqual(sum(math.dist(a, b) for a, b in pairs), facts["length"], delta=1e-12)

    def test_cells(self):
        self.assertLess(len(self.polylines("--cells", "8")[0][1]), len(self.polylines("--cells", "300")[0][1]))

    def test_box(self):
        (closed, vertices), = self.polylines("--box", "-.25", "-2", "2.5e0", "2")
        self.assertFalse(closed)
        self.assertEqual(min(x for x, _ in vertices), -0.25)
        self.assertEqual((vertices[0][0], vertices[-1][0]), (-0.25, -0.25))

    def test_two_components(self):
        both = [boundary(x + dx, dy) for x in (-3, 3) for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))]
        self.write("two.json", scene(2, both + [interior(-3, 0), interior(3, 0), exterior(0, 0), exterior(0, 4),
                                                exterior(0, -4), exterior(7, 0), exterior(-7, 0)]))
        self.assertEqual([closed for closed, _ in self.polylines(scene_file="two.json")], [True, True])

    def test_no_curve_in_the_box_is_noted(self):
        for name in ["none.csv", "none.svg"]:
            done = self.seesaw("contour", "compass.json", "-o", name, "--box", "-0.1", "-0.1", "0.1", "0.1")
            self.assertEqual((done.returncode, done.stdout), (0, ""))
            self.assertEqual(done.stderr, "seesaw: note: no part of the curve lies in the view box\n")
        self.assertEqual((self.folder / "none.csv").read_text(), "polyline,closed,x,y\n")

    # Pictures.

    def test_svg_png_pdf(self):
        self.assertEqual(self.svg_size(self.draw("curve.svg")), [400, 400])
        self.assertEqual(self.png_size(self.draw("curve.png")), [800, 800])
        self.assertEqual(self.draw("curve.pdf")[:5], b"%PDF-")
        self.assertEqual(self.draw("CURVE.SVG"), self.draw("again.svg"))  # by the ending, whatever its case

    def test_same_scene_same_bytes(self):
        for ending in ["svg", "png", "pdf", "csv"]:
            self.assertEqual(self.draw(f"one.{ending}"), self.draw(f"two.{ending}"), ending)

    def test_size_and_proportions(self):
        self.assertEqual(self.png_size(self.draw("c.png", "--size", "100")), [200, 200])
        self.assertEqual(self.svg_size(self.draw("c.svg", "--size", "300", "--box", "-3", "-1", "3", "1")), [300, 100])
        self.assertEqual(self.svg_size(self.draw("c.svg", "--size", "300", "--box", "-1", "-2", "1", "2")), [150, 300])
        # A sliver of a box still gives a picture.
        self.assertEqual(self.svg_size(self.draw("c.svg", "--box", "-3", "-1e-9", "3", "1e-9")), [400, 80])

    def test_field_and_isolines_show(self):
        pictures = [self.draw("c.svg", *options)
                    for options in ([], ["--field"], ["--isolines"], ["--field", "--isolines"])]
        self.assertEqual(len(set(pictures)), 4)
        self.write("shown.json", dict(COMPASS, display={"field": True, "isolines": True}))
        self.assertEqual(self.draw("c.svg", scene_file="shown.json"), pictures[3])

    def test_the_scenes_own_view(self):
        view = {"view": {"min": [-2, -1], "max": [2, 1]}}
        self.write("viewed.json", dict(COMPASS, display=view))
        viewed = self.draw("c.svg", scene_file="viewed.json")
        self.assertEqual(self.svg_size(viewed), [400, 200])
        self.assertEqual(viewed, self.draw("d.svg", "--box", "-2", "-1", "2", "1"))

    def test_the_scene_is_left_alone(self):
        before = (self.folder / "compass.json").read_bytes()
        self.draw("c.svg", "--field", "--box", "-2", "-2", "2", "2")
        self.assertEqual((self.folder / "compass.json").read_bytes(), before)
        self.assertEqual(self.files(), ["c.svg", "compass.json"])

    # What is refused, and before any file is touched.

    def refuses(self, *options, says, name="c.svg"):
        self.refused("contour", "compass.json", "-o", name, *options, says=says)
        self.assertEqual(self.files(), ["compass.json"])

    def test_other_endings(self):
        for name in ["curve.txt", "curve", "curve.svg.gz", ".svg", "svg"]:
            self.refuses(name=name, says=[f"{name}: expected a name that ends in", ".svg, .png, .pdf or .csv"])

    def test_bad_options(self):
        self.refuses("--box", "0", "0", "1", says="--box")
        self.refuses("--box", "0", "0", "1", "up", says=["--box", '"up"'])
        self.refuses("--box", "0", "0", "1", "inf", says=["--box", '"inf"'])
        self.refuses("--box", "0", "0", "0", "1", says=["--box", "XMIN below XMAX"])
        self.refuses("--box", "0", "2", "1", "1", says=["--box", "YMIN below YMAX"])
        self.refuses("--box", "-1e308", "0", "1e308", "1", says=["--box", "sides"])
        for size in ["9", "10001", "-5", "nan", "inf", "wide"]:
            self.refuses("--size", size, says="--size")
        for cells in ["0", "-1", "8193", "1.5", "many"]:
            self.refuses("--cells", cells, name="c.csv", says="--cells")
        self.refuses("--cells", "64", says=["--cells", ".csv"])

    def test_3d(self):
        self.write("ball.json", BALL)
        message = self.refused("contour", "ball.json", "-o", "c.svg", says="ball.json: is a 3D scene")
        self.assertIn("needs a 2D scene", message)

    def test_no_place_for_the_file(self):
        self.refuses(name="gone/c.svg", says="gone/c.svg: cannot be written: there is no folder gone")
        (self.folder / "c.svg").mkdir()
        self.refused("contour", "compass.json", "-o", "c.svg", says="c.svg: is a folder")


if __name__ == "__main__":
    unittest.main()
