# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab's own window, worked by keys and clicks on a screen that nobody sees.

There is no window manager: a click gives a window the keys, and windows come up by themselves.
Positions are those of MeshLab's dialogs, from a corner of their own window.
"""

import contextlib
import os
import subprocess
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SIZE = (1280, 1024)
TIMEOUT = 60


def wait_for(what, condition):
    """The first true value of condition(), within the time-out."""
    end = time.monotonic() + TIMEOUT
    while not (found := condition()):
        assert time.monotonic() < end, f"{what}: not seen within {TIMEOUT} s"
        time.sleep(0.2)
    return found


class Screen:
    """An X server of its own; the programs on it are started with its environment."""

    def __init__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        os.close(writing)
        with os.fdopen(reading) as pipe:
            self.environment = {**os.environ, "DISPLAY": f":{pipe.readline().strip()}"}

    def xdotool(self, *words):
        done = subprocess.run(
            ["xdotool", *map(str, words)], env=self.environment, capture_output=True, text=True
        )
        time.sleep(0.3)  # for the program to take it in
        return done.stdout

    def window(self, title):
        """The newest visible window whose title has these words; waits for it."""
        search = ("search", "--onlyvisible", "--name", title)
        return wait_for(f"window {title}", lambda: self.xdotool(*search).split())[-1]

    def windows(self):
        """All visible windows of MeshLab, with and without a title."""
        return set(self.xdotool("search", "--onlyvisible", "--class", "meshlab").split())

    def geometry(self, window):
        words = self.xdotool("getwindowgeometry", "--shell", window).split()
        return dict(word.split("=") for word in words)

    def click(self, window, x, y):
        """A negative place counts from the window's right or lower edge."""
        geometry = self.geometry(window)
        x = x if x >= 0 else int(geometry["WIDTH"]) + x
        y = y if y >= 0 else int(geometry["HEIGHT"]) + y
        self.xdotool("mousemove", "--window", window, x, y)
        self.xdotool("click", 1)

    def keys(self, *names):
        self.xdotool("key", *names)

    def type(self, text):
        self.xdotool("type", "--delay", 30, text)

    def save_picture(self, path):
        """With few enough colours for a picture in the documents."""
        time.sleep(1)
        subprocess.run(
            ["import", "-window", "root", "+dither", "-colors", "128", f"png8:{path}"],
            env=self.environment, check=True,
        )


class MeshLab:
    """One run of the program: command is started on the screen, and its log is read."""

    def __init__(self, screen, version, command, folder, log, environment=()):
        self.screen = screen
        self.log = Path(log)
        with self.log.open("w") as output:
            self.process = subprocess.Popen(
                [str(word) for word in command], cwd=folder, stdout=output, stderr=output,
                env={**screen.environment, **dict(environment)},
            )
        self.main = screen.window(f"MeshLab {version}")

    def fill_screen(self):
        """For when the program is at rest: while it starts it sets a size itself."""
        wait_for("a window as large as the screen", self._resized)

    def _resized(self):
        self.screen.xdotool("windowmove", self.main, 0, 0)
        self.screen.xdotool("windowsize", self.main, *SIZE)
        geometry = self.screen.geometry(self.main)
        return (int(geometry["WIDTH"]), int(geometry["HEIGHT"])) == SIZE

    def logged(self, text):
        return [line for line in self.log.read_text().splitlines() if text in line]

    def wait_for_log(self, text, count=1):
        return wait_for(f"{text!r} in the log", lambda: len(self.logged(text)) >= count)

    def click_into_view(self):
        self.screen.click(self.main, 400, 450)

    def search_filter(self, words):
        """Types into the search box; the first filter that is found is then the next one."""
        self.click_into_view()
        self.screen.keys("ctrl+f")
        self.screen.type(words)
        time.sleep(1)

    def open_found_filter(self, title):
        self.screen.keys("Down", "Return")
        self.dialog = self.screen.window(title)

    def apply_filter(self):
        self.press_apply()
        self.wait_for_log("Applied filter")

    def press_apply(self):
        self.screen.click(self.dialog, -130, -22)

    def press_apply_and_confirm_message(self):
        before = self.screen.windows()
        self.press_apply()
        box = wait_for("a box with a message", lambda: self.screen.windows() - before).pop()
        self.screen.click(box, -60, -23)

    def hide_layer(self, position):
        """By its eye in the list."""
        self.screen.click(self.main, 876, self.layer_row(position))

    def choose_layer(self, position):
        self.screen.click(self.main, 960, self.layer_row(position))

    def layer_row(self, position):
        return 111 + 31 * position

    def close_dialog(self):
        self.screen.click(self.dialog, 130, -22)

    def save_project_and_all_layers(self, path):
        self.click_into_view()
        self.screen.keys("ctrl+s")
        dialog = self.screen.window("Save Project")
        self.screen.click(dialog, -108, -22)  # Save All Files
        self.screen.click(dialog, 320, -80)  # the file's name
        self.screen.type(path)
        self.screen.keys("Return")
        wait_for("the project's dialog to close", lambda: dialog not in self.screen.windows())

    def save_current_layer(self, path):
        """As a file with the options that MeshLab proposes for its format."""
        self.click_into_view()
        self.screen.keys("ctrl+shift+e")
        self.screen.window('Save ".*" Layer')
        self.screen.keys("ctrl+a")
        self.screen.type(path)
        self.screen.keys("Return")
        self.screen.window("Choose Saving Options")
        self.screen.keys("Return")
        self.wait_for_log("Saved Mesh")


@contextlib.contextmanager
def running(screen, *arguments, **options):
    meshlab = MeshLab(screen, *arguments, **options)
    try:
        yield meshlab
    finally:
        meshlab.process.terminate()
        meshlab.process.wait()


@contextlib.contextmanager
def screen():
    new = Screen()
    try:
        yield new
    finally:
        new.server.terminate()
        new.server.wait()
