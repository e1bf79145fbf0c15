"""`seesaw fit`: polygon models and scans become scenes that fit them."""

import json
import math
import pathlib
import random
import unittest

from support import CliTest


def sphere(around=24, rows=12, radii=(1, 1, 1), shift=(0, 0, 0)):
    """Vertices, unit normals (of the unit sphere) and triangles of a closed ellipsoid, outward."""
    vertices = []
    for row in range(1, rows):
        for i in range(around):
            u, v = 2 * math.pi * i / around, math.pi * row / rows
            vertices.append((math.sin(v) * math.cos(u), math.sin(v) * math.sin(u), math.cos(v)))
    vertices += [(0, 0, 1), (0, 0, -1)]
    at = lambda row, i: (row - 1) * around + i % around
    faces = []
    for i in range(around):
        faces.append((len(vertices) - 2, at(1, i), at(1, i + 1)))
        faces.append((len(vertices) - 1, at(rows - 1, i + 1), at(rows - 1, i)))
        for row in range(1, rows - 1):
            faces.append((at(row, i), at(row + 1, i), at(row + 1, i + 1)))
            faces.append((at(row, i), at(row + 1, i + 1), at(row, i + 1)))
    return [tuple(x * r + s for x, r, s in zip(p, radii, shift)) for p in vertices], vertices, faces


def obj(vertices, faces):
    lines = ["v %.17g %.17g %.17g" % v for v in vertices] + ["f %d %d %d" % tuple(i + 1 for i in f) for f in faces]
    return "\n".join(lines) + "\n"


def xyz(points, normals):
    return "".join(" ".join("%.17g" % x for x in p + n) + "\n" for p, n in zip(points, normals))


class Fit(CliTest):
    def fit(self, *arguments, says=()):
        """The scene, and what was printed as {name: [what was said, ...]}; `says` must be on stderr, or nothing."""
        done = self.seesaw("fit", *arguments, "-o", "scene.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        if not says:
            self.assertEqual(done.stderr, "")
        for words in says:
            self.assertIn("seesaw: note: ", done.stderr)
            self.assertIn(words, done.stderr)
        table = {}
        name = ""
        for line in done.stdout.splitlines():
            name = line.split("  ")[0] or name
            table.setdefault(name, []).append(line[len(line.split("  ")[0]):].strip())
        return json.loads((self.folder / "scene.json").read_text()), table

    def values(self, *points):
        self.write("points.txt", "".join("%.17g %.17g %.17g\n" % p for p in points))
        return [float(line) for line in self.good("eval", "scene.json", "points.txt").splitlines()]

    def check_mesh(self, components=1, genus=0):
        self.assertEqual(self.seesaw("polygonize", "scene.json", "-o", "mesh.ply").returncode, 0)
        facts = json.loads(self.good("check", "mesh.ply", "--json"))
        self.assertEqual([facts[name] for name in ("closed", "manifold", "oriented", "components", "genus")],
                         [True, True, True, components, genus])
        return facts

    def test_a_small_mesh_is_taken_whole(self):
        vertices, _, faces = sphere()
        self.write("ball.obj", obj(vertices, faces))
        scene, said = self.fit("ball.obj")
        self.assertEqual(len(scene["constraints"]), len(vertices))
        self.assertEqual((scene["dimension"], scene["kernel"], scene["title"]), (3, "cubic", "ball"))
        for each, vertex in zip(scene["constraints"], vertices):
            self.assertEqual(each["kind"], "boundary")
            self.assertEqual(tuple(each["at"]), vertex)
            # One hundredth of the longest side, inward.
            self.assertAlmostEqual(each["offset"], 0.02, delta=1e-12)
            self.assertGreater(sum(a * b for a, b in zip(each["normal"], vertex)), 0.9)
        self.assertEqual(said["model"], ["266 vertices, 528 faces, closed"])
        self.assertEqual(said["vertices"], ["266, all"])
        self.assertLess(float(said["largest error"][0].split()[0]), 1e-12)
        inside, outside = self.values((0, 0, 0), (1.3, 0, 0))
        self.assertGreater(inside, 0)
        self.assertLess(outside, 0)
        facts = self.check_mesh()
        self.assertAlmostEqual(facts["volume"], 4 / 3 * math.pi, delta=0.02)

    def test_options(self):
        vertices, _, faces = sphere()
        self.write("ball.obj", obj(vertices, faces))
        scene, said = self.fit("ball.obj", "--vertices", "100", "--offset", "0.03", "--kernel", "linear")
        self.assertEqual((len(scene["constraints"]), scene["kernel"]), (100, "linear"))
        self.assertAlmostEqual(scene["constraints"][0]["offset"], 0.06, delta=1e-3)
        scene, said = self.fit("ball.obj", "--vertices", "100", "--simplify")
        self.assertEqual((len(scene["constraints"]), said["vertices"]), (100, ["100, simplified from 266"]))
        scene, _ = self.fit("ball.obj", "--unit-cube", "--side", "outside")
        self.assertAlmostEqual(max(each["at"][0] for each in scene["constraints"]), 0.5, delta=1e-12)
        self.assertEqual((scene["constraints"][0]["offset"], scene["constraints"][0]["value"]), (-0.01, -1))
        scene, _ = self.fit("ball.obj", "--side", "both")
        self.assertEqual(sum(each["kind"] == "exterior" for each in scene["constraints"]), len(vertices))

    def test_tolerance(self):
        draw = random.Random(1)
        vertices, _, faces = sphere(60, 40)
        bumpy = [tuple(x * (1 + 0.05 * math.sin(6 * v[0]) * math.sin(5 * v[1] + 1)) for x in v) for v in vertices]
        self.write("bumpy.obj", obj(bumpy, faces))
        scene, said = self.fit("bumpy.obj", "--vertices", "60", "--tolerance", "0.001")
        self.assertGreater(len(said["round"]), 1)
        self.assertTrue(said["round"][0].startswith("60 vertices: largest error "), said)
        self.assertLessEqual(float(said["largest error"][0].split()[0]), 0.001)
        # Every point of the model is where it says: f changes sign within the tolerance of it.
        some = draw.sample(bumpy, 100)
        reach = 0.0011 * 2.1
        scale = lambda p, s: tuple(x * s for x in p)
        values = self.values(*[scale(p, 1 + side * reach / math.dist(p, (0, 0, 0))) for p in some for side in (-1.2, 1.2)])
        self.assertTrue(all(values[2 * i] > 0 > values[2 * i + 1] for i in range(100)))
        _, said = self.fit("bumpy.obj", "--vertices", "60", "--most", "70", "--tolerance", "1e-5",
                           says=["the tolerance was not met with 70 vertices"])

    def test_a_cloud_with_all_its_faults(self):
        draw = random.Random(2)
        points, normals = [], []
        for _ in range(2500):
            n = [draw.gauss(0, 1) for _ in range(3)]
            size = math.hypot(*n)
            n = tuple(x / size for x in n)
            points.append(tuple(1e-3 * x + 50 for x in n))
            normals.append(n)
        normals[7] = (0, 0, 0)
        points[8], normals[8] = points[9], (1, 0, 0)
        self.write("scan.xyz", xyz(points, normals))
        scene, said = self.fit("scan.xyz", says=["a dense solver cannot take all 2500 vertices: 1200 stand for them"])
        self.assertEqual(said["model"], ["2500 points"])
        # A cloud may be open: a box of exterior constraints stands around it.
        kinds = [each["kind"] for each in scene["constraints"]]
        self.assertEqual(kinds.count("exterior"), 26)
        self.assertLessEqual(kinds.count("boundary"), 1200)
        facts = self.check_mesh()
        self.assertAlmostEqual(facts["volume"] / (4 / 3 * math.pi * 1e-9), 1, delta=0.02)
        # The other way round: normals that lead in are turned, unless they are wanted.
        self.write("inward.xyz", xyz(points, [tuple(-x for x in n) for n in normals]))
        self.fit("inward.xyz", "--vertices", "200", says=["they were turned"])
        self.assertAlmostEqual(self.check_mesh()["volume"] / facts["volume"], 1, delta=0.05)
        self.fit("inward.xyz", "--vertices", "200", "--keep-normals")
        self.assertLess(self.values((50, 50, 50))[0], 0)

    def test_strays_and_flipped_normals(self):
        draw = random.Random(3)
        vertices, normals, _ = sphere(40, 30)
        normals = [tuple(-x for x in n) if draw.random() < 0.05 else n for n in normals]
        strays = [tuple(draw.uniform(1.5, 3) * x for x in draw.choice(vertices)) for _ in range(10)]
        self.write("scan.xyz", xyz(vertices + strays, normals + [(0, 0, 1)] * 10))
        _, said = self.fit("scan.xyz")
        self.assertIn("10 points astray", said["left out"])
        self.assertTrue(any("against all neighbors" in words for words in said["left out"]), said)
        self.assertAlmostEqual(self.check_mesh()["volume"], 4 / 3 * math.pi, delta=0.05)
        _, said = self.fit("scan.xyz", "--keep-strays")
        self.assertNotIn("10 points astray", said.get("left out", []))

    def test_a_scan_with_a_hole(self):
        vertices, _, faces = sphere(30, 20)
        cut = [f for f in faces if max(vertices[i][2] for i in f) < 0.8]
        self.write("bowl.obj", obj(vertices, cut))
        _, said = self.fit("bowl.obj")
        self.assertEqual(said["model"], ["%d vertices, %d faces, open: 1 hole with 30 edges" %
                                         (len({i for f in cut for i in f}), len(cut))])
        self.assertEqual(said["cage"], ["26 exterior constraints around, since the model is open"])
        facts = self.check_mesh()  # smoothly closed
        self.assertAlmostEqual(facts["volume"], 4 / 3 * math.pi, delta=0.3)

    def test_an_open_sheet_becomes_a_slab(self):
        n = 20
        sheet = [(x / n, y / n, 0.05 * math.sin(7 * x / n)) for y in range(n) for x in range(n)]
        faces = [t for y in range(n - 1) for x in range(n - 1) for i in [y * n + x]
                 for t in [(i, i + 1, i + n + 1), (i, i + n + 1, i + n)]]
        self.write("terrain.obj", obj(sheet, faces))
        self.fit("terrain.obj")
        self.check_mesh()
        scene, _ = self.fit("terrain.obj", "--no-cage")
        self.assertEqual(len(scene["constraints"]), n * n)

    def test_a_thin_blade(self):
        vertices, _, faces = sphere(26, 20, radii=(0.5, 0.3, 0.0075))
        self.write("blade.obj", obj(vertices, faces))
        scene, said = self.fit("blade.obj")
        self.assertTrue(any("shrunk at" in words for words in said["offset"]), said)
        self.assertLess(min(each["offset"] for each in scene["constraints"] if "offset" in each), 0.004)
        scene, said = self.fit("blade.obj", "--fixed-offset")
        self.assertEqual(len(said["offset"]), 1)

    def test_what_is_refused(self):
        vertices, normals, faces = sphere(8, 6)
        self.write("ball.obj", obj(vertices, faces))
        self.write("bare.xyz", xyz(vertices, [(0, 0, 0)] * len(vertices)))
        self.write("empty.obj", "")

        def refuses(*arguments, says):
            before = self.files()
            self.refused("fit", *arguments, says=says)
            self.assertEqual(self.files(), before)

        refuses("bare.xyz", "-o", "s.json", says=["bare.xyz: ", "no usable normals"])
        refuses("empty.obj", "-o", "s.json", says="empty.obj")
        refuses("gone.obj", "-o", "s.json", says="gone.obj")
        refuses("ball.obj", "-o", "gone/s.json", says="there is no folder gone")
        for option, values in {"--vertices": ["3", "20001", "x"], "--offset": ["0", "-1", "0.6", "nan"],
                               "--tolerance": ["0", "-1", "2", "nan"], "--most": ["1"], "--kernel": ["gauss"],
                               "--side": ["left"]}.items():
            for value in values:
                refuses("ball.obj", "-o", "s.json", option, value, says=option)
        self.refused("fit", "ball.obj", says="--output")

    def test_same_model_same_scene(self):
        vertices, _, faces = sphere(60, 40)
        self.write("ball.obj", obj(vertices, faces))
        scenes = []
        for _ in range(2):
            self.fit("ball.obj", says=["a dense solver"])
            scenes.append((self.folder / "scene.json").read_bytes())
        self.assertEqual(scenes[0], scenes[1])

    def test_the_bunny(self):
        bunny = pathlib.Path("/usr/share/glmark2/models/bunny.obj")
        if not bunny.exists():
            self.skipTest("the package glmark2-data is not installed")
        scene, said = self.fit(bunny, "--vertices", "800")
        self.assertEqual(len(scene["constraints"]), 800)
        self.assertLess(float(said["rms error"][0].split()[0]), 0.004)
        self.check_mesh()


if __name__ == "__main__":
    unittest.main()
