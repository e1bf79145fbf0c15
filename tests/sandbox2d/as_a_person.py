"""The program on a real X server, by real mouse and key events: looks at a figure, drags a constraint, saves, goes.

Nothing here knows the program from inside: Xvfb is the screen, xdotool the hand, and what a person sees of the
program's state is the window's title. Skipped where the two are not installed.
"""

import json
import os
import shutil
import subprocess
import sys
import time

if not shutil.which("Xvfb") or not shutil.which("xdotool"):
    print("Xvfb or xdotool is not installed")
    sys.exit(77)

import unittest

from support import PROGRAM, SCENES, Sandbox2dTest, wait_for

# Of the window; the usual size of a first start. Beneath the menu and above the status line is the scene.
WIDTH, HEIGHT, MENU, STATUS = 1280, 800, 24, 30
REACH = 1.75  # of the figure's view, to each side


class AsAPerson(Sandbox2dTest):
    def setUp(self):
        super().setUp()
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x900x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[write], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(self.end, self.server)
        os.close(write)
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()  # it chooses a free one, and says so when it is ready
        self.assertTrue(number, "Xvfb did not start")
        home = self.folder / "home"
        home.mkdir()
        hidden = ("WAYLAND_DISPLAY", "XAUTHORITY", "XDG_STATE_HOME", "SDL_VIDEODRIVER")
        self.environment = {key: value for key, value in os.environ.items() if key not in hidden}
        self.environment.update(DISPLAY=f":{number}", HOME=str(home), SDL_VIDEODRIVER="x11", LIBGL_ALWAYS_SOFTWARE="1")

    @staticmethod
    def end(process):
        if process.poll() is None:
            process.terminate()
        process.wait(timeout=20)

    def hand(self, *arguments):
        """xdotool, one command."""
        done = subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True,
                              encoding="utf-8", timeout=60)
        return done.stdout.strip() if done.returncode == 0 else ""

    def start(self, *arguments):
        self.log = open(self.folder / "log.txt", "w+", encoding="utf-8")
        self.addCleanup(self.log.close)
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], env=self.environment, cwd=self.folder,
                                   stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log)
        self.addCleanup(self.kill, process)

        def window():
            if process.poll() is not None:
                self.log.seek(0)
                self.fail("it ended at once: " + self.log.read())
            return self.hand("search", "--onlyvisible", "--class", "sandbox2d").split("\n")[0]

        self.window = wait_for(window, what="the window")
        return process

    def move(self, x, y):
        """The mouse, to a place in the window: where that stands on the screen is the program's business."""
        self.hand("mousemove", "--window", self.window, x, y)

    def title(self):
        return self.hand("getwindowname", self.window)

    def until(self, act, seen, what):
        """Does `act`, again if need be, until it is seen to have worked: a slow program may have missed it."""
        for _ in range(12):
            act()
            try:
                return wait_for(seen, 4, what)
            except AssertionError:
                pass
        self.fail(f"in vain: {what}; the window is called {self.title()!r}")

    def at(self, x, y):
        """Where a place of the figure is in the window while the panels are hidden."""
        scene = HEIGHT - MENU - STATUS
        pixel = 2 * REACH / scene
        return round(WIDTH / 2 + x / pixel), round(MENU + scene / 2 - y / pixel)

    def drag(self, start, end, steps=12):
        self.move(*start)
        self.hand("mousedown", 1)
        for i in range(1, steps + 1):
            self.move(*(round(a + (b - a) * i / steps) for a, b in zip(start, end)))
            time.sleep(0.01)
        self.hand("mouseup", 1)

    def test_a_first_visit(self):
        process = self.start()
        wait_for(lambda: "Figure 1, left" in self.title(), what="the title")

        # The plus sign in the middle goes to the upper right.
        def move_it():
            self.hand("windowfocus", self.window)  # there is no window manager to give it the keys
            self.hand("key", "Escape")  # the welcome, which offers a tour
            self.hand("key", "F9")  # the scene alone; where a key came too early, the next time
            self.drag(self.at(0, 0), self.at(0.4, 0.3))

        self.until(move_it, lambda: "*" in self.title(), "the drag")
        # A click into emptiness: nothing is selected, nothing happens.
        self.move(*self.at(-1.6, 1.6))
        self.hand("click", 1)

        # Saved under a name that is typed.
        saved = self.folder / "mine.json"

        def save():
            self.hand("key", "Escape")
            self.hand("key", "ctrl+s")
            time.sleep(0.5)
            self.hand("key", "ctrl+a")
            self.hand("type", "--delay", "15", str(saved))
            self.hand("key", "Return")

        self.until(save, saved.exists, "the file")
        wait_for(lambda: "mine.json" in self.title() and "*" not in self.title(), what="the title after saving")
        figure = json.loads((SCENES / "turk2002-fig01-left.json").read_text(encoding="utf-8"))
        mine = json.loads(saved.read_text(encoding="utf-8"))
        self.assertEqual(mine["title"], figure["title"])
        self.assertEqual(mine["constraints"][:4], figure["constraints"][:4])
        x, y = mine["constraints"][4]["at"]
        self.assertAlmostEqual(x, 0.4, delta=0.02)
        self.assertAlmostEqual(y, 0.3, delta=0.02)
        self.assertEqual(mine["constraints"][4]["kind"], "interior")

        # Undone, redone, and unsaved in between.
        self.until(lambda: self.hand("key", "ctrl+z"), lambda: "*" in self.title(), "undo")
        self.until(lambda: self.hand("key", "ctrl+y"), lambda: "*" not in self.title(), "redo")

        # Nothing is unsaved, so it goes without a word; the next start knows the way back.
        self.hand("key", "ctrl+q")
        wait_for(lambda: process.poll() is not None, what="the end")
        self.assertEqual(process.returncode, 0)
        recent = list((self.folder / "home").rglob("sandbox2d.recent"))
        self.assertEqual(len(recent), 1)
        self.assertIn(str(saved), recent[0].read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
