"""`seesaw raytrace`: surfaces as pictures, and the camera as flags."""

import struct
import unittest
import zlib

from support import BALL, COMPASS, CliTest, boundary, interior, scene

QUICK = ["--size", "48x36", "--samples", "1"]


def ball(x, y, z):
    """Nearly a ball of radius 1."""
    return scene(3, [boundary(x + dx, y + dy, z + dz) for dx, dy, dz in
                     [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]] + [interior(x, y, z)])


class Raytrace(CliTest):
    def setUp(self):
        super().setUp()
        self.write("a.json", BALL)
        self.write("b.json", ball(0.8, 0, 0))

    def trace(self, *arguments):
        """The standard output, and the bytes of out.png."""
        return self.good("raytrace", *arguments, "-o", "out.png"), (self.folder / "out.png").read_bytes()

    def pixels(self, png):
        """Rows of RGB triples; PNG as the program writes it (8 bits, RGB, any filter) undone by hand."""
        width, height, depth, kind = struct.unpack(">IIBB", png[16:26])
        self.assertEqual((depth, kind), (8, 2))
        data, at = b"", 8
        while at < len(png):
            length, name = struct.unpack(">I4s", png[at:at + 8])
            data += png[at + 8:at + 8 + length] if name == b"IDAT" else b""
            at += 12 + length
        raw, stride, rows, above = zlib.decompress(data), 3 * width, [], bytes(3 * width)
        for y in range(height):
            kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
            for i in range(stride):
                left, up = line[i - 3] if i >= 3 else 0, above[i]
                corner = above[i - 3] if i >= 3 else 0
                guess = left + up - corner
                paeth = min((left, up, corner), key=lambda value: abs(guess - value))
                line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[kind]) & 255
            rows.append([tuple(line[i:i + 3]) for i in range(0, stride, 3)])
            above = bytes(line)
        return rows

    def covered(self, *arguments):
        """How many pixels show the subject."""
        _, png = self.trace(*arguments, *QUICK, "--floor", "none")
        return sum(pixel != (255, 255, 255) for row in self.pixels(png) for pixel in row)

    def test_a_picture_and_its_camera(self):
        out, png = self.trace("a.json", *QUICK)
        self.assertEqual(struct.unpack(">II", png[16:24]), (48, 36))
        self.assertRegex(out, r"^--eye \S+,\S+,\S+ --target \S+,\S+,\S+ --up 0,1,0 --fov 28\n$")
        middle = self.pixels(png)[18][24]
        self.assertTrue(80 < min(middle) and middle != (255, 255, 255), middle)
        self.assertEqual(self.pixels(png)[0][0], (255, 255, 255))
        # The flags give the same picture again; so does the same call.
        again, same = self.trace("a.json", *QUICK, *out.split())
        self.assertEqual((again, same), (out, png))

    def test_both_methods_agree(self):
        pictures = [self.pixels(self.trace("a.json", *QUICK, "--method", method)[1])
                    for method in ("rigorous", "heuristic")]
        different = sum(max(abs(p - q) for p, q in zip(a, b)) > 1
                        for rows in zip(*pictures) for a, b in zip(*rows))
        self.assertLessEqual(different, 3)

    def test_csg(self):
        camera = ["--eye", "0,0,9", "--target", "0,0,0", "--fov", "28"]
        a, b = self.covered("a.json", *camera), self.covered("b.json", *camera)
        both = self.covered("a.json", "b.json", *camera)
        united = self.covered("a.json", "b.json", "--csg", "0 | 1", *camera)
        shared = self.covered("a.json", "b.json", "--csg", "0&1", *camera)
        less = self.covered("a.json", "b.json", "--csg", "(0 - 1)", *camera)
        self.assertEqual(both, united)
        self.assertLess(abs(united + shared - a - b), 0.06 * (a + b))  # seen from the side, areas nearly add up
        self.assertTrue(0 < shared < a and 0 < less < a, (shared, less, a))

    def test_evaluations(self):
        out, _ = self.trace("a.json", *QUICK, "--evaluations", "heat.png")
        self.assertRegex(out.splitlines()[1], r"^evaluations: \d+ in all, at most \d+ for a pixel$")
        heat = self.pixels((self.folder / "heat.png").read_bytes())
        self.assertGreater(sum(heat[0][0]), sum(heat[18][24]))

    def test_the_documents_own_camera(self):
        own = dict(BALL, camera={"position": [0, 0, 7], "target": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 35})
        self.write("own.json", own)
        self.assertEqual(self.trace("own.json", *QUICK)[0], "--eye 0,0,7 --target 0,0,0 --up 0,1,0 --fov 35\n")
        self.assertIn("--fov 50", self.trace("own.json", *QUICK, "--fov", "50")[0])

    def test_floors_and_mirrors_show(self):
        pictures = {self.trace("a.json", "b.json", *QUICK, *options)[1]
                    for options in ([], ["--floor", "checker"], ["--floor", "none"], ["--mirror", "0.5"])}
        self.assertEqual(len(pictures), 4)

    def test_meshes_beside_scenes(self):
        self.write("tetra.off", "OFF\n4 4 0\n2 0 0\n3 0 0\n2 1 0\n2 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        self.assertGreater(self.covered("tetra.off"), 50)
        self.assertGreater(self.covered("a.json", "tetra.off"), 50)
        self.refused("raytrace", "a.json", "tetra.off", "--csg", "0", "-o", "x.png", says=["tetra.off", "--csg"])

    # What is refused, and before any file is touched.

    def refuses(self, *options, says, name="out.png"):
        before = self.files()
        self.refused("raytrace", "a.json", *options, "-o", name, says=says)
        self.assertEqual(self.files(), before)

    def test_bad_options(self):
        self.refuses(name="out.jpg", says="out.jpg: expected a name that ends in .png")
        self.refuses(name="gone/out.png", says="there is no folder gone")
        self.refuses("--evaluations", "heat.gif", says="heat.gif")
        for size in ["800", "800x", "x600", "0x5", "99999x2", "axb", "8x8x8"]:
            self.refuses("--size", size, says="--size")
        for eye in ["1,2", "1,2,up", "1,2,3,4", "1,2,nan"]:
            self.refuses("--eye", eye, says=["--eye", eye])
        self.refuses("--up", "0,0,0", says="--up")
        for fov in ["0", "180", "wide"]:
            self.refuses("--fov", fov, says="--fov")
        self.refuses("--method", "magic", says="--method")
        self.refuses("--floor", "lava", says="--floor")
        self.refuses("--mirror", "1.5", says="--mirror")
        self.refuses("--samples", "0", says="--samples")
        self.refuses("--eye", "1,1,1", "--target", "1,1,1", says="same point")

    def test_bad_expressions_are_marked(self):
        message = self.refused("raytrace", "a.json", "b.json", "--csg", "0 - (1 | 2)", "-o", "out.png", says="--csg")
        self.assertIn("the numbers are 0 to 1\n    0 - (1 | 2)\n             ^", message)

    def test_bad_scenes(self):
        self.write("flat.json", COMPASS)
        self.refused("raytrace", "flat.json", "-o", "out.png", says="flat.json: is a 2D scene")
        self.refused("raytrace", "none.json", "-o", "out.png", says="none.json")


if __name__ == "__main__":
    unittest.main()
