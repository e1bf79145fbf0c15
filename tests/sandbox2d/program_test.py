"""The program `sandbox2d` from outside: its arguments, its pictures, its exports, and what a kill leaves on disk."""

import json
import math
import random
import shutil
import time
import unittest

from support import FIGURES, SCENES, Sandbox2dTest, plane_scenes, wait_for

# The first figure, shown in a window of this size, without panels: where its constraints are.
SIZE = "640x560"


class Arguments(Sandbox2dTest):
    def test_help(self):
        help_text = self.good("--help")
        for option in ("--script", "--screenshot", "--size", "--scale", "--dark", "--plate", "--state"):
            self.assertIn(option, help_text)

    def test_wrong_arguments(self):
        self.script("click \"Undo\n", "quote.script")
        self.script("frames 2\nclick \"No such thing\"\n", "widget.script")
        self.script("jump 3\n", "verb.script")
        for arguments, says in (
            (["--nope"], "--nope"),
            (["one.json", "two.json"], "two.json"),
            (["--scale", "9"], "--scale"),
            (["--scale", "large"], "--scale"),
            (["--size", "10x10"], "--size"),
            (["--size", "800x600zzz"], "--size"),
            (["--size", "999999x800"], "--size"),
            (["--size", "wide"], "--size"),
            (["--script", "none.script"], "none.script"),
            (["--script", "quote.script"], "quote.script:1"),
            (["--script", "widget.script"], "widget.script:2"),
            (["--script", "verb.script"], "jump"),
            (["--screenshot", "none/picture.png"], "none/picture.png"),
        ):
            with self.subTest(arguments=arguments):
                self.refused(*arguments, says=says)

    def test_a_file_that_is_missing_or_broken_opens_the_window_all_the_same(self):
        (self.folder / "broken.json").write_text("{\"seesaw\": 1,")
        self.good("--size", SIZE, "--screenshot", "first.png")
        first = (self.folder / "first.png").read_bytes()
        for name in ("none.json", "broken.json"):
            self.good(name, "--size", SIZE, "--screenshot", name + ".png")
            self.assertNotEqual((self.folder / (name + ".png")).read_bytes(), first, "the message is seen")
        self.assertEqual((self.folder / "broken.json").read_text(), "{\"seesaw\": 1,")


class Pictures(Sandbox2dTest):
    def test_two_runs_give_the_same_bytes(self):
        script = self.script("frames 3\nkey t\nkey w\ndrag \"interior value\" \"interior value\" +30 +0 8\nkey k\n"
                             "key ctrl+shift+n\nkey o\nframes 12\nscreenshot within-@.png\nkey 3\n")
        for run in "ab":
            self.script((self.folder / script).read_text().replace("@", run), run + ".script")
            self.good("--size", "900x600", "--script", run + ".script", "--screenshot", f"end-{run}.png",
                      SCENES / "seesaw.json")
        for name in ("within", "end"):
            pictures = [(self.folder / f"{name}-{run}.png").read_bytes() for run in "ab"]
            self.assertEqual(pictures[0], pictures[1], name)
        self.assertNotEqual(pictures[0], (self.folder / "within-a.png").read_bytes())

    def test_every_2d_figure_is_exported_as_figures_makes_it(self):
        scenes = plane_scenes()
        self.assertGreaterEqual(len(scenes), 10)
        lines = ["frames 2"]
        for scene in scenes:
            lines += [f"drop \"{scene}\"", "frames 2", "key ctrl+shift+e", "frames 3", "key ctrl+a",
                      f"text \"{self.folder / scene.stem}.png\"", "key enter", "frames 2"]
        self.play("\n".join(lines) + "\n", "--size", SIZE)
        for scene in scenes:
            with self.subTest(scene=scene.name):
                self.good("render", scene, "-o", "figure.png", program=FIGURES)
                self.assertEqual((self.folder / (scene.stem + ".png")).read_bytes(),
                                 (self.folder / "figure.png").read_bytes())


def many_constraints(count):
    """A ring, and exterior constraints around it: a document that takes a while to write."""
    constraints = [{"kind": "interior", "at": [0, 0]}]
    for i in range(count):
        angle = 2 * math.pi * i / count
        kind, radius = (("boundary", 1) if i % 4 == 0 else ("exterior", 2 + 0.3 * (i % 3)))
        constraints.append({"kind": kind, "at": [radius * math.cos(angle), radius * math.sin(angle)]})
    return {"seesaw": 1, "dimension": 2, "title": "many", "constraints": constraints}


class Killed(Sandbox2dTest):
    def test_in_the_middle_of_saving_the_file_is_whole(self):
        count = 400
        before = many_constraints(count)
        # Saves without end, each different from the last.
        script = self.script("frames 3\n" + "key 6\nkey ctrl+s\n" * 4000)
        chance = random.Random(4)
        for _ in range(10):
            (self.folder / "many.json").write_text(json.dumps(before))
            original = (self.folder / "many.json").read_bytes()
            process = self.start("many.json", "--size", "320x240", "--script", script)
            wait_for(lambda: (self.folder / "many.json").read_bytes() != original, what="the first save")
            time.sleep(chance.uniform(0, 0.15))
            self.assertIsNone(process.poll(), "it is to be at work still")
            self.kill(process)
            document = self.read("many.json")
            self.assertEqual(document["title"], "many")
            places = [constraint["at"] for constraint in document["constraints"]]
            self.assertEqual(places, [constraint["at"] for constraint in before["constraints"]])
        # What is left over beside it hinders nobody.
        self.play("frames 2\nkey 6\nkey ctrl+s\n", "many.json", "--size", "320x240")
        self.assertEqual(len(self.read("many.json")["constraints"]), count + 1)

    def test_in_the_middle_of_a_drag_the_next_start_recovers(self):
        shutil.copy(SCENES / "turk2002-fig01-left.json", self.folder / "mine.json")
        on_disk = (self.folder / "mine.json").read_bytes()
        start = [constraint["at"] for constraint in self.read("mine.json")["constraints"]]
        self.assertEqual(start[4], [0, 0])
        # The panels hidden, the plus sign is in the middle of the scene; it is held, and the clock goes on.
        width, height = map(int, SIZE.split("x"))
        x, y = width // 2, (height + 23 - 30) // 2
        script = self.script(f"key f9\nframes 3\nmove {x} {y}\npress\nmove {x + 10} {y}\nmove {x + 40} {y - 60}\n"
                             "frames 100000\n")
        process = self.start("mine.json", "--size", SIZE, "--state", "state", "--script", script)

        def dragged():
            for copy in (self.folder / "state" / "autosave").glob("*.json"):
                at = json.loads(copy.read_text())["constraints"][4]["at"]
                if at[1] > 0.1:
                    return at
            return None

        self.assertIsNone(process.poll())
        at = wait_for(dragged, what="the autosave")
        self.kill(process)
        self.assertEqual((self.folder / "mine.json").read_bytes(), on_disk, "it was not saved, so it is as it was")

        # Later: it is offered again. Recovered and saved: it is the document that was in hand.
        self.play("frames 4\nclick \"Recovered/Later\"\nframes 3\n", "--size", SIZE, "--state", "state")
        self.assertEqual((self.folder / "mine.json").read_bytes(), on_disk)
        self.play("frames 4\nclick \"Recovered/Recover\"\nframes 3\nkey ctrl+s\nframes 3\n", "--size", SIZE,
                  "--state", "state")
        after = [constraint["at"] for constraint in self.read("mine.json")["constraints"]]
        self.assertEqual(after[4], at)
        self.assertEqual(after[:4], start[:4])
        # Then there is nothing left to offer.
        self.assertEqual(list((self.folder / "state" / "autosave").glob("*.json")), [])
        self.refused("--size", SIZE, "--state", "state", "--script",
                     self.script("frames 4\nclick \"Recovered/Recover\"\n"), says="Recovered/Recover")

    def test_what_is_running_is_not_offered(self):
        shutil.copy(SCENES / "turk2002-fig01-left.json", self.folder / "mine.json")
        script = self.script("frames 3\nkey ctrl+a\nkey up\nframes 100000\n", "busy.script")
        self.start("mine.json", "--size", SIZE, "--state", "state", "--script", script)
        wait_for(lambda: list((self.folder / "state" / "autosave").glob("*.json")), what="the autosave")
        self.refused("--size", SIZE, "--state", "state", "--script",
                     self.script("frames 4\nclick \"Recovered/Recover\"\n"), says="Recovered/Recover")

    def test_closed_on_purpose_leaves_nothing_to_recover(self):
        self.play("frames 3\nkey ctrl+a\nkey up\nframes 400\nquit\nframes 3\nclick \"Don't save\"\nframes 3\n",
                  SCENES / "turk2002-fig01-left.json", "--size", SIZE, "--state", "state")
        self.assertEqual(list((self.folder / "state" / "autosave").glob("*")), [])


if __name__ == "__main__":
    unittest.main()
