"""What the tests of the curve editor's program share: running `sandbox2d` with a written-down hand.

Each test file is run by ctest as `python3 <file> <path of sandbox2d> <path of figures>`.
"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

PROGRAM, FIGURES = [str(pathlib.Path(argument).resolve()) for argument in sys.argv[1:3]]
del sys.argv[1:3]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
SCENES = SOURCE / "figures" / "scenes"


def plane_scenes():
    """The files of all 2D figures."""
    return [path for path in sorted(SCENES.glob("*.json"))
            if json.loads(path.read_text(encoding="utf-8"))["dimension"] == 2]


def wait_for(condition, seconds=60, what="something"):
    """What condition() gives as soon as it is true. A slow machine has as long as it needs, within reason."""
    end = time.monotonic() + seconds
    while True:
        if result := condition():
            return result
        if time.monotonic() > end:
            raise AssertionError(f"waited {seconds} s in vain for {what}")
        time.sleep(0.01)


class Sandbox2dTest(unittest.TestCase):
    """Every test has a folder of its own, in which the program runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="seesaw_sandbox2d_", ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def script(self, text, name="test.script"):
        (self.folder / name).write_text(text, encoding="utf-8")
        return name

    def run_program(self, *arguments, program=PROGRAM):
        return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder,
                              timeout=120, stdin=subprocess.DEVNULL)

    def good(self, *arguments, program=PROGRAM):
        """The standard output of a run that ends well and has nothing to complain about."""
        done = self.run_program(*arguments, program=program)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        return done.stdout

    def play(self, text, *arguments):
        return self.good("--script", self.script(text), *arguments)

    def refused(self, *arguments, says):
        """The run must end with status 2 and say `says`, in words."""
        done = self.run_program(*arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ""), (arguments, done.stderr))
        self.assertIn(says, done.stderr)
        for word in ("terminate", "what()", "Aborted", "assert"):
            self.assertNotIn(word, done.stderr)

    def start(self, *arguments):
        """A program that runs while the test goes on; killed when the test ends."""
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(self.kill, process)
        return process

    def kill(self, process):
        """As the system does when memory is short: without a word."""
        if process.poll() is None:
            os.kill(process.pid, signal.SIGKILL)
        process.wait()

    def read(self, name):
        return json.loads((self.folder / name).read_text(encoding="utf-8"))
