"""`seesaw` itself: help, version, exit status, what it does when its output has nowhere to go."""

import math
import os
import pty
import subprocess
import threading
import time
import unittest

from support import BALL, COMPASS, PROGRAM, CliTest, boundary, exterior, interior, scene

COMMANDS = ["info", "eval", "contour"]


class Program(CliTest):
    def test_no_arguments_print_help(self):
        text = self.good()
        self.assertEqual(text, self.good("--help"))
        self.assertEqual(text, self.good("-h"))
        places = [text.index(f"\n  {command} ") for command in COMMANDS]
        self.assertEqual(places, sorted(places))

    def test_every_command_has_help(self):
        for command in COMMANDS:
            text = self.good(command, "--help")
            self.assertIn(f"Usage: seesaw {command} ", text)
            self.assertIn("SCENE", text)

    def test_version(self):
        self.assertRegex(self.good("--version"), r"\Aseesaw \d+\.\d+\.\d+\n\Z")

    def test_unknown_command_names_the_known(self):
        for word in ["frobnicate", "", "contour.json"]:
            self.refused(word, says=[f'unknown command "{word}"', "info, eval, contour"])

    def test_bad_command_lines(self):
        self.refused("--frobnicate", says=["--frobnicate", "see: seesaw --help"])
        self.refused("info", says=["SCENE", "see: seesaw info --help"])
        self.refused("info", "a.json", "b.json", says="b.json")
        self.refused("info", "a.json", "--frobnicate", says="--frobnicate")
        self.refused("eval", "a.json", says="POINTS")
        self.refused("contour", "a.json", says="--output")
        self.refused("contour", "a.json", "-o", says="--output")


class Scenes(CliTest):
    """What all commands say about a scene that cannot be read or cannot be fitted."""

    def each_command_refuses(self, name, says):
        for arguments in [["info", name], ["info", name, "--json"], ["eval", name, "-"], ["contour", name, "-o", "o.svg"]]:
            self.refused(*arguments, stdin="0 0\n", says=says)
        self.assertNotIn("o.svg", self.files())

    def test_missing(self):
        self.each_command_refuses("nothing.json", "nothing.json: no such file")

    def test_folder(self):
        (self.folder / "there").mkdir()
        self.each_command_refuses("there", "there: is a folder")

    def test_not_json(self):
        self.write("bad.json", '{"seesaw": 1,\n"dimension" 2}')
        self.each_command_refuses("bad.json", "bad.json:2: ")

    def test_wrong_number_of_coordinates(self):
        # The example in core/scene/document_json.h: line 12, constraints[3].
        lines = ["{", '"seesaw": 1,', '"dimension": 2,', '"kernel": "cubic",', '"smoothing": 0,', '"title": "t",',
                 '"description": "d",', '"constraints": [']
        lines += ['{"kind": "boundary", "at": [%d, 1]},' % i for i in range(3)]
        lines += ['{"kind": "boundary", "at": [3, 1, 2]}', "]}"]
        self.write("shape.json", "\n".join(lines))
        self.each_command_refuses("shape.json", "shape.json:12: constraints[3].at: expected 2 numbers, found 3")

    def test_no_constraints(self):
        self.write("empty.json", scene(2, []))
        self.each_command_refuses("empty.json", "empty.json: there are no constraints")

    def test_contradiction_names_indices_and_positions(self):
        self.write("torn.json", scene(2, [boundary(0, 0), boundary(1, 0.1), exterior(5, 5), interior(1, 0.1, value=2.5)]))
        self.each_command_refuses("torn.json", [
            "torn.json: constraints 1, 3 ask for different values",
            "constraints[1]: boundary at (1, 0.1), value 0", "constraints[3]: interior at (1, 0.1), value 2.5"])

    def test_contradiction_in_3d(self):
        self.write("torn.json", scene(3, BALL["constraints"] + [exterior(1, 0, 0)]))
        self.refused("info", "torn.json", says=["constraints[0]: boundary at (1, 0, 0)", "constraints[7]: exterior"])

    def test_many_culprits_are_not_all_listed(self):
        twice = [[boundary(i, i * i), interior(i, i * i)] for i in range(50)]
        self.write("torn.json", scene(2, sum(twice, [])))
        message = self.refused("info", "torn.json", says=["constraints[0]:", "constraints[9]:", "and 90 more"])
        self.assertNotIn("constraints[10]:", message)

    def test_too_close_to_solve(self):
        self.write("near.json", scene(2, [boundary(0, 0), boundary(1, 0), boundary(0, 1), interior(1e-11, 0)]))
        self.each_command_refuses("near.json", ["near.json: ", "constraints[0]:", "constraints[3]: interior at (1e-11, 0)"])


class Output(CliTest):
    def test_reader_leaves_early(self):
        self.write("compass.json", COMPASS)
        self.write("points.txt", "0.25 0.5\n" * 200_000)  # far more than a pipe holds
        process = subprocess.Popen([PROGRAM, "eval", "compass.json", "points.txt"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        process.stdout.readline()
        process.stdout.close()
        complaint = process.stderr.read()
        process.stderr.close()
        self.assertEqual((process.wait(60), complaint), (0, b""))

    @unittest.skipUnless(os.path.exists("/dev/full"), "this system has no /dev/full")
    def test_full_disk(self):
        self.write("compass.json", COMPASS)
        for arguments in [[], ["--help"], ["info", "compass.json"], ["info", "compass.json", "--json"]]:
            with open("/dev/full", "wb") as full:
                done = subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdout=full, stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, 2)
            self.assertIn(b"standard output: cannot be written: ", done.stderr)

    def test_long_work_says_how_far_it_is_to_a_person(self):
        # What is solved before 0.3 s are over says nothing; then a larger one.
        for count in [2500, 5000, 10000]:
            angles = [2 * math.pi * i / count for i in range(count)]
            self.write("ring.json", scene(2, [boundary(math.cos(a), math.sin(a), normal=[math.cos(a), math.sin(a)])
                                              for a in angles]))
            heard, _ = self.heard_by_a_person("ring.json")
            if heard:
                break
        said = heard.decode().split("\r")
        self.assertRegex(said[1], rf"^solving {count} constraints \d+ %$")
        percents = [int(line.split()[-2]) for line in said if line.strip()]
        self.assertEqual(percents, sorted(percents))
        self.assertEqual(said[-1].strip(), "", "the line is wiped")
        self.write("compass.json", COMPASS)
        heard, seconds = self.heard_by_a_person("compass.json")
        self.assertTrue(heard == b"" or seconds > 0.3, "what is quick says nothing")

    def heard_by_a_person(self, name):
        """What `eval` says on a terminal, and how many seconds it takes."""
        start = time.monotonic()
        terminal, program_side = pty.openpty()
        process = subprocess.Popen([PROGRAM, "eval", name, "-"], cwd=self.folder, stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=program_side)
        os.close(program_side)
        heard = {name: b""}
        reader = threading.Thread(target=self.read_all, args=(terminal, heard, name))
        reader.start()
        values = process.communicate(b"0 0\n", 300)[0]
        reader.join()
        os.close(terminal)
        self.assertEqual(process.returncode, 0)
        self.assertGreater(float(values), 0)
        return heard[name], time.monotonic() - start

    @staticmethod
    def read_all(terminal, heard, name):
        try:
            while block := os.read(terminal, 4096):
                heard[name] += block
        except OSError:  # the other side is closed
            pass

    def test_standard_output_closed(self):
        self.write("compass.json", COMPASS)
        command = f'exec "{PROGRAM}" info compass.json >&-'
        done = subprocess.run(["sh", "-c", command], cwd=self.folder, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"standard output: cannot be written: ", done.stderr)


if __name__ == "__main__":
    unittest.main()
