"""`seesaw info`: the facts of a scene, for programs and for people."""

import json
import math
import unittest

from support import BALL, COMPASS, CliTest, boundary, example_in, exterior, interior, scene


class Info(CliTest):
    def facts(self, document):
        return json.loads(self.good("info", self.write("scene.json", document), "--json"))

    def rows(self, document):
        """The table, as a dict; every value starts in one column."""
        lines = self.good("info", self.write("scene.json", document)).splitlines()
        width = max(len(line.split("  ")[0]) for line in lines) + 2
        for line in lines:
            self.assertEqual(line[width - 1], " ", line)
            self.assertNotEqual(line[width], " ", line)
        return {line[:width].strip(): line[width:] for line in lines}

    def test_facts_of_a_shape_known_in_closed_form(self):
        facts = self.facts(COMPASS)
        weight = 2 / (3 * math.log(2))
        self.assertEqual(facts["title"], "Compass")
        self.assertEqual(facts["dimension"], 2)
        self.assertEqual(facts["kernel"], "thin_plate_spline")
        self.assertEqual(facts["smoothing"], 0)
        self.assertEqual(facts["constraints"], {"boundary": 4, "interior": 1, "exterior": 0, "normal": 0, "total": 5})
        self.assertEqual((facts["rows"], facts["merged"]), (5, 0))
        self.assertEqual((facts["polynomial_rank"], facts["degenerate"]), (3, False))
        self.assertLess(facts["max_residual"], 1e-14)
        self.assertGreater(facts["reciprocal_condition"], 1e-3)
        self.assertLessEqual(facts["reciprocal_condition"], 1)
        self.assertAlmostEqual(facts["energy"], 8 * math.pi * weight, delta=1e-12)  # 8 pi w'h, and h = 1 in the middle
        self.assertEqual(facts["energy_order"], 2)
        self.assertAlmostEqual(facts["weights_sum_abs"], 2 * weight, delta=1e-13)
        self.assertGreater(facts["fit_seconds"], 0)
        self.assertEqual((facts["components"], facts["closed"], facts["complete"]), (1, 1, True))
        # Through the four points runs something rounder than their square and flatter than their circle's square.
        self.assertTrue(2 < facts["area"] < 4, facts["area"])
        self.assertTrue(4 * math.sqrt(2) < facts["length"] < 8, facts["length"])
        for key in ["min", "max"]:
            self.assertEqual(len(facts["view"][key]), 2)

    def test_counts_kinds(self):
        facts = self.facts(scene(2, [
            boundary(0, 1, normal=[0, 1]), boundary(1, 0, normal=[2, 0]), boundary(-1, 0),
            interior(0, 0), exterior(3, 3), exterior(-3, 3), exterior(3, -3)]))
        self.assertEqual(facts["constraints"], {"boundary": 3, "interior": 1, "exterior": 3, "normal": 2, "total": 9})
        self.assertEqual(facts["rows"], 9)

    def test_merged(self):
        document = scene(2, COMPASS["constraints"] + [boundary(1, 0), boundary(1, 0), interior(0, 0)])
        facts = self.facts(document)
        self.assertEqual((facts["constraints"]["total"], facts["rows"], facts["merged"]), (8, 5, 3))
        self.assertIn("5, after merging 3", self.rows(document)["centers"])

    def test_view_box_is_the_scenes_own(self):
        facts = self.facts(dict(COMPASS, display={"view": {"min": [0, -2], "max": [2, 2]}}))
        self.assertEqual(facts["view"], {"min": [0, -2], "max": [2, 2]})
        self.assertEqual((facts["components"], facts["closed"]), (1, 0))
        whole = self.facts(COMPASS)
        # Half of a symmetric shape: the vertices are not mirror images, so equal only as far as chords are arcs.
        self.assertAlmostEqual(facts["area"], whole["area"] / 2, delta=2e-3 * whole["area"])
        self.assertAlmostEqual(facts["length"], whole["length"] / 2, delta=2e-3 * whole["length"])

    def test_3d(self):
        facts = self.facts(BALL)
        self.assertEqual((facts["dimension"], facts["kernel"], facts["energy_order"]), (3, "cubic", 3))
        for key in ["view", "components", "area", "length"]:
            self.assertNotIn(key, facts)
        self.assertLess(facts["max_residual"], 1e-13)
        rows = self.rows(BALL)
        self.assertEqual(rows["dimension"], "3")
        self.assertIn("derivatives of order 3", rows["energy"])
        self.assertNotIn("length", rows)

    def test_energy_is_named(self):
        for dimension, kernel, order in [(2, "thin_plate_spline", 2), (2, "cubic", 2.5), (2, "linear", 1.5),
                                         (3, "thin_plate_spline", 2.5), (3, "cubic", 3), (3, "linear", 2)]:
            document = dict(COMPASS if dimension == 2 else BALL, kernel=kernel)
            self.assertEqual(self.facts(document)["energy_order"], order)
            words = self.rows(document)["energy"]
            self.assertIn(f"order {order}", words)
            self.assertEqual("eq. 3" in words, order == 2)
            self.assertEqual("semi-norm" in words, order != int(order))

    def test_smoothing(self):
        facts = self.facts(dict(COMPASS, smoothing=0.5))
        self.assertEqual(facts["smoothing"], 0.5)
        self.assertGreater(facts["max_residual"], 1e-2)
        self.assertEqual(self.rows(dict(COMPASS, smoothing=0.5))["smoothing"], "0.5")

    def test_degenerate_in_words(self):
        for document, rank, words in [
                (scene(2, [interior(1, 2)]), 1, "one point"),
                (scene(2, [boundary(0, 0), interior(1, 1), exterior(-2, -2)]), 2, "one line"),
                (scene(3, [boundary(0, 0, 0), interior(1, 1, 1)]), 2, "one line"),
                (scene(3, [boundary(0, 0, 1), boundary(1, 0, 1), boundary(0, 1, 1), interior(1, 3, 1)]), 3, "one plane")]:
            facts = self.facts(document)
            self.assertEqual((facts["polynomial_rank"], facts["degenerate"]), (rank, True))
            self.assertIn(words, self.rows(document)["degenerate"])
        self.assertNotIn("degenerate", self.rows(COMPASS))

    def test_table(self):
        rows = self.rows(COMPASS)
        self.assertEqual(rows["title"], "Compass")
        self.assertEqual(rows["kernel"], "thin_plate_spline")
        self.assertEqual(rows["smoothing"], "0 (interpolates)")
        self.assertEqual(rows["constraints"], "5: 4 boundary, 1 interior, 0 exterior, 0 normal")
        self.assertTrue(rows["energy"].startswith("24.1"), rows["energy"])
        self.assertTrue(rows["fit"].endswith(" s"))
        self.assertEqual(rows["curve in it"], "1 component, 1 closed")
        for key in ["max residual", "reciprocal condition", "view box", "area inside", "length"]:
            self.assertIn(key, rows)
        self.assertNotIn("title", self.rows(scene(2, COMPASS["constraints"])))

    def test_titles_are_text(self):
        for title in ["Möbius’ „Schlinge“", 'quotes " and \\', "two\nlines"]:
            self.assertEqual(self.facts(dict(COMPASS, title=title))["title"], title)
            self.good("info", "scene.json")

    def test_example_of_the_format(self):
        example = example_in("core/scene/document_json.h", "{", "}")
        facts = json.loads(self.good("info", self.write("example.json", example), "--json"))
        self.assertEqual(facts["constraints"], {"boundary": 1, "interior": 1, "exterior": 1, "normal": 1, "total": 4})


if __name__ == "__main__":
    unittest.main()
