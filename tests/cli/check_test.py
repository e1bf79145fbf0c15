"""`seesaw check`: what a mesh or point cloud is worth, for programs and for people."""

import json
import math
import unittest

from support import CliTest

TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
"""


class Check(CliTest):
    def facts(self, name, content, *more):
        return json.loads(self.good("check", self.write(name, content), "--json", *more))

    def rows(self, name, content, *more):
        """The table, as a dict; rows without a name belong to the one above."""
        rows, last = {}, None
        for line in self.good("check", self.write(name, content), *more).splitlines():
            if line.startswith("  "):
                rows[last] += "\n" + line.strip()
                continue
            last, value = line.split("  ", 1)
            rows[last] = value.strip()
        return rows

    def test_facts_known_in_closed_form(self):
        facts = self.facts("m.obj", TETRAHEDRON, "--intersections")
        self.assertEqual((facts["kind"], facts["vertices"], facts["faces"]), ("mesh", 4, 4))
        self.assertEqual((facts["closed"], facts["manifold"], facts["oriented"]), (True, True, True))
        self.assertEqual((facts["components"], facts["euler_characteristic"], facts["genus"]), (1, 2, 0))
        self.assertEqual((facts["boundary_edges"], facts["boundary_loops"], facts["self_intersections"]), (0, 0, 0))
        self.assertAlmostEqual(facts["volume"], 1 / 6, delta=1e-15)
        self.assertAlmostEqual(facts["area"], (3 + math.sqrt(3)) / 2, delta=1e-14)
        self.assertAlmostEqual(facts["smallest_angle"], 45, delta=1e-12)
        self.assertEqual(facts["box"], {"min": [0, 0, 0], "max": [1, 1, 1]})
        self.assertEqual(set(facts["repairs"].values()), {0})
        self.assertNotIn("self_intersections", self.facts("m.obj", TETRAHEDRON))

    def test_what_does_not_exist_is_null(self):
        facts = self.facts("m.obj", TETRAHEDRON.replace("f 3 1 4\n", ""))
        self.assertEqual((facts["closed"], facts["genus"], facts["volume"]), (False, None, None))
        self.assertEqual((facts["boundary_edges"], facts["boundary_loops"]), (3, 1))
        rows = self.rows("m.obj", TETRAHEDRON.replace("f 3 1 4\n", ""))
        self.assertEqual(rows["closed"], "no: 3 boundary edges in 1 loop")
        self.assertNotIn("volume", rows)
        self.assertNotIn("genus", rows)

    def test_repairs_are_reported(self):
        # Every vertex twice, one face turned, one degenerate, one vertex unused.
        text = TETRAHEDRON.replace("f 3 1 4", "v 0 0 0\nv 0 0 1\nv 7 7 7\nf 5 3 6\nf 1 1 2")
        facts = self.facts("m.obj", text)
        self.assertEqual((facts["closed"], facts["oriented"], facts["genus"]), (True, True, 0))
        found = {name: n for name, n in facts["repairs"].items() if n}
        self.assertEqual(found, {"welded_vertices": 2, "unused_vertices": 1, "degenerate_faces": 1, "turned_faces": 1})
        words = self.rows("m.obj", text)["repairs"].splitlines()
        self.assertEqual(len(words), 4)
        self.assertEqual(words[0], "2 vertices welded to others with equal coordinates")
        self.assertEqual(self.rows("m.obj", TETRAHEDRON)["repairs"], "none")

    def test_inside_out(self):
        text = "\n".join(" ".join([w[0], *reversed(w[1:])]) if w[0] == "f" else " ".join(w)
                         for w in map(str.split, TETRAHEDRON.splitlines()))
        facts = self.facts("m.obj", text)
        self.assertAlmostEqual(facts["volume"], 1 / 6, delta=1e-15)
        self.assertEqual(facts["repairs"]["turned_shells"], 1)

    def test_intersections(self):
        other = "".join(f"v {0.2 + x} {0.2 + y} {z - 0.5}\n" for x, y, z in [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        text = TETRAHEDRON + other + "f 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n"
        self.assertGreater(self.facts("m.obj", text, "--intersections")["self_intersections"], 0)
        self.assertIn("pairs of faces", self.rows("m.obj", text, "--intersections")["self-intersections"])

    def test_point_clouds(self):
        facts = self.facts("c.xyz", "0 0 0 0 0 1\n1 2 3 nan 0 0\n1 0 0 0 0 0\n")
        self.assertEqual((facts["kind"], facts["points"], facts["normals"]), ("point_cloud", 3, 1))
        self.assertEqual(facts["box"], {"min": [0, 0, 0], "max": [1, 2, 3]})
        rows = self.rows("c.csv", "x,y,z\n1,2,3\n4,5,6\n")
        self.assertEqual((rows["points"], rows["normals"]), ("2", "0"))

    def test_refuses(self):
        self.refused("check", "missing.ply", says="missing.ply: no such file")
        self.refused("check", ".", says="is a folder")
        self.refused("check", self.write("a.obj", ""), says="a.obj: is empty")
        self.refused("check", self.write("a.obj", "v 0 0 0\nf 1 2 3\n"), says="a.obj:2: vertex 3 is out of range")
        self.refused("check", self.write("a.ply", "ply\n"), says="a.ply:1: the file ends before end_header")
        self.refused("check", self.write("a.scene", '{"seesaw": 1}'), says="not known here")
        self.refused("check", says="--help")


if __name__ == "__main__":
    unittest.main()
