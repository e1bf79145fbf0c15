"""`seesaw polygonize`: a surface as triangles."""

import json
import math
import os
import subprocess
import unittest

from support import BALL, COMPASS, PROGRAM, CliTest, boundary, exterior, interior, scene


def read_obj(path):
    vertices, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            vertices.append(tuple(map(float, words[1:4])))
        if words and words[0] == "f":
            faces.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:]))
    return vertices, faces


def volume(vertices, faces):
    total = 0
    for face in faces:
        (a, b, c), (d, e, f), (g, h, i) = (vertices[v] for v in face)
        total += a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
    return total / 6


class Polygonize(CliTest):
    def setUp(self):
        super().setUp()
        self.write("ball.json", BALL)

    def facts(self, *options, scene_file="ball.json", output="ball.obj"):
        return json.loads(self.good("polygonize", scene_file, "-o", output, "--json", *options))

    def test_the_mesh_is_the_surface(self):
        facts = self.facts("--cells", "30")
        vertices, faces = read_obj(self.folder / "ball.obj")
        self.assertEqual((len(vertices), len(faces)), (facts["vertices"], facts["faces"]))
        edges = {(face[k], face[(k + 1) % 3]) for face in faces for k in range(3)}
        self.assertEqual(len(edges), 3 * len(faces))  # every edge once in each direction: closed and oriented
        self.assertTrue(all((b, a) in edges for a, b in edges))
        self.assertEqual(len(vertices) - len(edges) // 2 + len(faces), 2)
        self.assertAlmostEqual(volume(vertices, faces), facts["volume"], delta=1e-9)
        self.assertGreater(facts["volume"], 0)
        for name, value in (("components", 1), ("genus", 0), ("boundary_edges", 0), ("closed", True),
                            ("manifold", True), ("oriented", True), ("clipped", False)):
            self.assertEqual(facts[name], value, name)
        self.assertEqual(facts["seeds"], {"on_surface": 6, "outside_box": 0, "nowhere": 0, "missed": 0})
        self.write("vertices.csv", "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in vertices))
        values = [float(line) for line in self.good("eval", "ball.json", "vertices.csv").splitlines()]
        self.assertLess(max(map(abs, values)), 5e-11)  # 1e-12 of the box, times the gradient

    def test_check_agrees(self):
        for name in ("ball.ply", "ball.off", "ball.stl", "BALL.OBJ"):
            facts = self.facts("--cells", "12", output=name)
            seen = json.loads(self.good("check", name, "--json"))
            for fact in ("faces", "components", "genus", "boundary_edges", "closed", "manifold", "oriented"):
                self.assertEqual(facts[fact], seen[fact], (name, fact))

    def test_without_json_one_line(self):
        line = self.good("polygonize", "ball.json", "-o", "ball.ply", "--cells", "10")
        self.assertRegex(line, r"^\d+ triangles, 1 component, closed, genus 0, volume \S+, "
                                        r"smallest angle \S+ degrees, \S+ s\n$")

    def test_cells(self):
        coarse, fine = self.facts("--cells", "10"), self.facts("--cells", "20")
        self.assertAlmostEqual(coarse["cell"], 2 * fine["cell"])
        self.assertGreater(fine["faces"], 3 * coarse["faces"])

    def test_a_box_cuts(self):
        done = self.seesaw("polygonize", "ball.json", "-o", "ball.obj", "--json", "--box", "-.5", "-2", "-2", "2", "2", "2")
        self.assertIn("leaves the box", done.stderr)
        facts = json.loads(done.stdout)
        self.assertTrue(facts["clipped"])
        self.assertGreater(facts["boundary_edges"], 10)
        self.assertIsNone(facts["volume"])
        vertices, _ = read_obj(self.folder / "ball.obj")
        self.assertEqual(min(x for x, _, _ in vertices), -0.5)

    def test_improving(self):
        self.assertGreater(self.facts("--cells", "20")["smallest_angle"], 10)
        raw = self.facts("--cells", "20", "--raw")
        self.assertLess(raw["smallest_angle"], 10)

    def test_exhaustive(self):
        # A second ball, whose constraints are all inside or outside of it: no boundary constraint touches it.
        ball = BALL["constraints"] + [interior(6, 0, 0)] + [
            exterior(x, y, z) for x, y, z in ((4, 0, 0), (8, 0, 0), (6, 2, 0), (6, -2, 0), (6, 0, 2), (6, 0, -2),
                                              (-2, 0, 0), (0, 2, 0), (0, -2, 0), (0, 0, 2), (0, 0, -2))]
        self.write("two.json", scene(3, ball))
        box = ("--cells", "48", "--box", "-3", "-3", "-3", "9", "3", "3")
        self.assertEqual(self.facts(*box, scene_file="two.json")["components"], 1)
        self.assertEqual(self.facts(*box, "--exhaustive", scene_file="two.json")["components"], 2)

    def test_no_surface_is_noted(self):
        self.write("none.json", scene(3, [interior(0, 0, 0), interior(1, 0, 0)]))
        result = self.seesaw("polygonize", "none.json", "-o", "none.obj")
        self.assertEqual(result.returncode, 0)
        self.assertIn("no part of the surface was found", result.stderr)

    def test_refusals(self):
        self.write("flat.json", COMPASS)
        for options, words in (
                (("ball.json", "-o", "ball.txt"), ".obj, .ply, .stl or .off"),
                (("ball.json", "-o", "missing/ball.ply"), "missing"),
                (("flat.json", "-o", "flat.ply"), "2D scene"),
                (("ball.json", "-o", "b.ply", "--cells", "0"), "1 to 65536"),
                (("ball.json", "-o", "b.ply", "--box", "0", "0", "0", "1", "1", "x"), "six finite numbers"),
                (("ball.json", "-o", "b.ply", "--box", "0", "0", "0", "1", "0", "1"), "YMIN below YMAX"),
                (("ball.json", "-o", "b.ply", "--cells", "3000", "--memory", "50"), "use fewer cells"),
                (("ball.json", "-o", "b.ply", "--memory", "0"), "megabytes")):
            self.refused("polygonize", *options, says=words)
        self.assertNotIn("b.ply", self.files())

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "this machine has one core")
    def test_the_same_bytes_on_one_core_and_on_all(self):
        lumps = BALL["constraints"] + [
            boundary(1.5 * math.cos(i), 1.5 * math.sin(i), 0.1 * i - 1) for i in range(20)]
        self.write("lumps.json", scene(3, lumps))
        meshes = []
        everywhere = os.sched_getaffinity(0)
        for cores in (everywhere, {min(everywhere)}):
            subprocess.run([PROGRAM, "polygonize", "lumps.json", "-o", "lumps.ply", "--cells", "60"],
                           cwd=self.folder, check=True, capture_output=True,
                           preexec_fn=lambda cores=cores: os.sched_setaffinity(0, cores))
            meshes.append((self.folder / "lumps.ply").read_bytes())
        self.assertGreater(len(meshes[0]), 100000)
        self.assertEqual(*meshes)


if __name__ == "__main__":
    unittest.main()
