"""The program `figures` from outside: what it lists, what it writes, its exit status.

Run by ctest as `python3 program_test.py <path of figures>`.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "figures"


class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="seesaw_figures_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def figures(self, *arguments, program=PROGRAM):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, cwd=self.folder, timeout=120,
                              encoding="utf-8")

    def test_list_names_every_figure(self):
        done = self.figures("list")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(sorted(names), sorted(path.stem for path in (SOURCE / "reference").glob("*.png")))
        for line in done.stdout.splitlines():
            self.assertGreater(len(line.split()), 3, "and says what it is")

    def test_an_unknown_figure_is_refused_before_any_is_made(self):
        for ids in (["turk2002-fig99"], ["turk2002-fig01", "turk2002-fig99"], [""]):
            with self.subTest(ids=ids):
                done = self.figures("make", *ids, "--out", "made")
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertEqual(done.stderr, f"figures: there is no figure {ids[-1]}; 'figures list' names them all\n")
        self.assertEqual(os.listdir(self.folder), [])

    def test_wrong_arguments(self):
        for arguments in (["draw"], ["make", "--scale", "0"], ["render"], ["render", "none.json", "-o", "a.png"]):
            with self.subTest(arguments=arguments):
                done = self.figures(*arguments)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertNotEqual(done.stderr, "")
        self.assertEqual(os.listdir(self.folder), [])

    def test_a_scene_without_a_function_names_file_and_places(self):
        scene = {"seesaw": 1, "dimension": 2, "constraints": [
            {"kind": "boundary", "at": [0.5, 1]}, {"kind": "interior", "at": [0.5, 1], "value": 1}]}
        (self.folder / "two.json").write_text(json.dumps(scene), encoding="utf-8")
        done = self.figures("render", "two.json", "-o", "two.png")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        for words in ("two.json: constraints 0, 1 ask for different values at one position",
                      "constraints[0]: boundary at (0.5, 1)", "constraints[1]: interior at (0.5, 1), value 1"):
            self.assertIn(words, done.stderr)
        self.assertEqual(os.listdir(self.folder), ["two.json"])

    def test_a_figure_is_made(self):
        done = self.figures("make", "energy", "--out", "made/here", "--scale", "0.5")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotIn("FAILS", done.stdout)
        made = self.folder / "made" / "here"
        description = json.loads((made / "energy.json").read_text(encoding="utf-8"))
        self.assertTrue(description["holds"])
        for name in ["energy.png"] + [panel["png"] for panel in description["panels"]]:
            self.assertEqual((made / name).read_bytes()[:4], b"\x89PNG")

    def test_a_check_that_fails_is_exit_status_1(self):
        # An installed copy of it, whose scene is not the figure's.
        program = self.folder / "bin" / "figures"
        scenes = self.folder / "share" / "seesaw" / "scenes"
        program.parent.mkdir()
        shutil.copy2(PROGRAM, program)
        shutil.copytree(SOURCE / "scenes", scenes)
        scene = json.loads((scenes / "turk2002-fig01-left.json").read_text(encoding="utf-8"))
        self.assertEqual(scene["constraints"][4], {"kind": "interior", "at": [0, 0], "value": 1})
        scene["constraints"][4]["value"] = 2
        (scenes / "turk2002-fig01-left.json").write_text(json.dumps(scene), encoding="utf-8")
        done = self.figures("make", "turk2002-fig01", "energy", "--out", "made", "--scale", "0.5", program=program)
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("FAILS: left: |f(plus) - 1|: 1, bound", done.stdout)
        self.assertEqual(done.stdout.count("FAILS"), 1)
        for name, holds in (("turk2002-fig01", False), ("energy", True)):
            description = json.loads((self.folder / "made" / (name + ".json")).read_text(encoding="utf-8"))
            self.assertEqual(description["holds"], holds, "both are made all the same")


if __name__ == "__main__":
    unittest.main()
