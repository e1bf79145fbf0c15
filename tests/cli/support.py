"""What the tests of the command line share: running `seesaw`, and scenes to run it on.

Each test file is run by ctest as `python3 <file> <path of seesaw>`.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve()) if len(sys.argv) > 1 else "seesaw"
SOURCE = pathlib.Path(__file__).resolve().parents[2]


def boundary(*at, **more):
    return {"kind": "boundary", "at": list(at), **more}


def interior(*at, **more):
    return {"kind": "interior", "at": list(at), **more}


def exterior(*at, **more):
    return {"kind": "exterior", "at": list(at), **more}


def scene(dimension, constraints, **more):
    return {"seesaw": 1, "dimension": dimension, "constraints": constraints, **more}


# The example of core/rbf/fit.h. Its symmetry gives the function in closed form: the weight in the middle is
# a = 2 / (3 log 2), the other four are -a / 4, and the polynomial is 1.
COMPASS = scene(2, [boundary(-1, 0), boundary(1, 0), boundary(0, -1), boundary(0, 1), interior(0, 0)], title="Compass")

BALL = scene(
    3,
    [boundary(1, 0, 0), boundary(-1, 0, 0), boundary(0, 1, 0), boundary(0, -1, 0), boundary(0, 0, 1),
     boundary(0, 0, -1), interior(0, 0, 0)])


def example_in(header, first, last):
    """The text of an example in a header's comment, from the line that starts with `first` to the one with `last`."""
    lines = [line[2:].strip() for line in (SOURCE / header).read_text(encoding="utf-8").splitlines()
             if line.startswith("//")]
    start = next(i for i, line in enumerate(lines) if line.startswith(first))
    end = max(i for i, line in enumerate(lines) if line == last)
    return "\n".join(lines[start:end + 1]) + "\n"


class CliTest(unittest.TestCase):
    """Every test has a folder of its own, in which the program runs."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="seesaw_cli_")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write(self, name, content):
        if isinstance(content, dict):
            content = json.dumps(content, indent=1)
        if isinstance(content, str):
            content = content.encode()
        (self.folder / name).write_bytes(content)
        return name

    def seesaw(self, *arguments, stdin=""):
        """What a run did: its returncode, and stdout and stderr as bytes read as UTF-8."""
        done = subprocess.run([PROGRAM, *map(str, arguments)], input=stdin.encode(), capture_output=True,
                              cwd=self.folder, timeout=120)
        done.stdout, done.stderr = done.stdout.decode(), done.stderr.decode()
        return done

    def good(self, *arguments, stdin=""):
        """The standard output of a run that ends well and has nothing to complain about."""
        done = self.seesaw(*arguments, stdin=stdin)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        return done.stdout

    def refused(self, *arguments, stdin="", says):
        """The message of a run that must end with status 2, say each of `says` on stderr, and nothing on stdout."""
        done = self.seesaw(*arguments, stdin=stdin)
        self.assertEqual((done.returncode, done.stdout), (2, ""), (arguments, done.stderr))
        self.assertTrue(done.stderr.startswith("seesaw: "), done.stderr)
        for words in [says] if isinstance(says, str) else says:
            self.assertIn(words, done.stderr)
        self.assertNotIn("terminate", done.stderr)
        return done.stderr

    def files(self):
        return sorted(os.listdir(self.folder))
