#!/usr/bin/env python3
"""Drives the window as a person would, under a display of its own, and checks what its log says.

    session.py PROGRAM FOLDER [SCENE...]      SCENE: hall when none is given

Needs Xvfb, xdotool and ImageMagick's import. Screenshots and the log of each scene go into FOLDER/SCENE. Exit code 0: all checks hold;
1: the first that does not is named; 77: a tool is missing."""

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

WIDTH, HEIGHT = 1280, 720
START_SECONDS = 240       # until the first frame of a large scene is traced on a slow machine
STAGE_SECONDS = 120       # until a change has gone through the stages
SHORT_SECONDS = 30        # until the interface answers


class Failed(Exception):
    """A check that does not hold, in one line."""


class Child:
    """A process in a group of its own, ended with everything that it started."""

    def __init__(self, arguments, **options):
        self.process = subprocess.Popen(arguments, start_new_session=True, stdin=subprocess.DEVNULL, **options)

    def end(self):
        for stop, patience in ((signal.SIGTERM, 5.0), (signal.SIGKILL, 5.0)):
            try:
                os.killpg(self.process.pid, stop)
            except ProcessLookupError:
                pass
            try:
                return self.process.wait(patience)
            except subprocess.TimeoutExpired:
                continue
        return None


class Display:
    """Xvfb on a display number drawn at random: where another server has it, the next draw decides."""

    def __init__(self):
        for _ in range(5):
            self.name = f":{random.randint(100, 9999)}"
            self.child = Child(["Xvfb", self.name, "-screen", "0", "1920x1200x24", "-noreset", "-nolisten", "tcp"],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if self.answers():
                return
            self.child.end()
        raise Failed("Xvfb could not be started five times")

    def answers(self):
        for _ in range(60):
            if self.child.process.poll() is not None:
                return False
            asked = subprocess.run(["xdotool", "getdisplaygeometry"], env=dict(os.environ, DISPLAY=self.name), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=SHORT_SECONDS)
            if asked.returncode == 0:
                return True
            time.sleep(0.25)
        return False

    def end(self):
        self.child.end()


class Log:
    """The lines of a program's standard error, as they come."""

    def __init__(self, stream, path):
        self.lines = []
        self.changed = threading.Condition()
        self.closed = False
        self.stream = stream
        self.file = open(path, "w")
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        for line in self.stream:
            with self.changed:
                self.lines.append(line.rstrip("\n"))
                self.file.write(line)
                self.file.flush()
                self.changed.notify_all()
        with self.changed:
            self.closed = True
            self.changed.notify_all()

    def place(self):
        with self.changed:
            return len(self.lines)

    def wait(self, pattern, since, seconds, what):
        """The match of the first line from `since` on."""
        end = time.monotonic() + seconds
        with self.changed:
            looked = since
            while True:
                for line in self.lines[looked:]:
                    match = re.search(pattern, line)
                    if match:
                        return match
                looked = len(self.lines)
                left = end - time.monotonic()
                if left <= 0 or self.closed:
                    last = self.lines[-1] if self.lines else "nothing"
                    why = "the program ended" if self.closed else f"not within {seconds} s"
                    raise Failed(f"waited for {what} (/{pattern}/): {why}; last line: {last}")
                self.changed.wait(left)

    def last(self, pattern):
        with self.changed:
            for line in reversed(self.lines):
                match = re.search(pattern, line)
                if match:
                    return match
        return None

    def end(self):
        self.thread.join(5.0)
        self.file.close()


class Window:
    """The program under test, with hands and eyes."""

    def __init__(self, program, scene, folder, display):
        self.folder = folder
        self.shots = 0
        self.environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=str(folder / "settings"))
        self.environment.pop("WAYLAND_DISPLAY", None)
        self.child = Child([program, "window", scene, "--validation", "--log", "--size", "320x180"],
                           cwd=folder, env=self.environment, stdout=open(folder / "stdout.txt", "w"), stderr=subprocess.PIPE, text=True,
                           errors="replace")
        self.log = Log(self.child.process.stderr, folder / "log.txt")
        self.id = self.find()
        self.resize(WIDTH, HEIGHT)

    def tool(self, *arguments):
        done = subprocess.run(["xdotool", *arguments], env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL, text=True, timeout=SHORT_SECONDS)
        return done.stdout.strip()

    def find(self):
        end = time.monotonic() + START_SECONDS
        while time.monotonic() < end:
            if self.child.process.poll() is not None:
                time.sleep(0.2)
                raise Failed(f"the program ended at once with {self.child.process.returncode}: {' / '.join(self.log.lines[-3:])}")
            found = self.tool("search", "--onlyvisible", "--name", "Gridscope").split()
            if found:
                self.tool("windowfocus", found[-1])
                return found[-1]
            time.sleep(0.2)
        raise Failed(f"no window appeared within {START_SECONDS} s")

    def keys(self, *names):
        """Each pressed and released, one after the other."""
        self.tool("key", "--delay", "120", *names)
        time.sleep(0.1)

    def type(self, text):
        self.tool("type", "--delay", "60", text)
        time.sleep(0.2)

    def move(self, x, y):
        self.tool("mousemove", "--window", self.id, str(x), str(y))
        time.sleep(0.3)

    def click(self, x, y, button=1):
        self.move(x, y)
        self.tool("mousedown", str(button))
        time.sleep(0.12)
        self.tool("mouseup", str(button))
        time.sleep(0.3)

    def drag(self, from_x, from_y, to_x, to_y, button):
        self.move(from_x, from_y)
        self.tool("mousedown", str(button))
        for part in range(1, 7):
            self.move(from_x + (to_x - from_x) * part // 6, from_y + (to_y - from_y) * part // 6)
        self.tool("mouseup", str(button))
        time.sleep(0.3)

    def resize(self, width, height):
        self.tool("windowsize", self.id, str(width), str(height))
        time.sleep(0.8)

    def shot(self, name):
        """A picture of the whole window, once the interface has settled."""
        time.sleep(0.5)
        self.shots += 1
        path = self.folder / f"{self.shots:02d}_{name}.png"
        subprocess.run(["import", "-window", self.id, str(path)], env=self.environment, stdin=subprocess.DEVNULL, timeout=SHORT_SECONDS,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if not path.exists() or path.stat().st_size < 5000:
            raise Failed(f"{path.name}: no picture of the window")
        return path

    def exit_code(self):
        try:
            return self.child.process.wait(STAGE_SECONDS)
        except subprocess.TimeoutExpired:
            raise Failed(f"the program did not end within {STAGE_SECONDS} s after Ctrl+Q") from None

    def end(self):
        self.child.end()
        self.log.end()
        self.child.process.stderr.close()


def check(holds, text):
    print(("ok    " if holds else "FAILS ") + text, flush=True)
    if not holds:
        raise Failed(text)


def number(text):
    return int(text.replace(",", ""))


GRID = r"Grid: stored ([\d,]+), refused ([\d,]+), saturated ([\d,]+)"
STEP = r"Step (\d+) of (\d+): (.*)"
RECORDED = r"Recorded pixel (\d+),(\d+): (\d+) steps, (.*)"


class Tour:
    """What a person does, stop by stop."""

    def __init__(self, program, window):
        self.program = program
        self.window = window
        self.log = window.log

    def run(self):
        for stop in (self.first_frame, self.choose_view, self.click_pixel, self.step_forward_and_back, self.run_to_saturated, self.orbit_around_the_ray,
                     self.select_cell, self.pick_cell, self.look_at_tables, self.walk_by_keys, self.save_pictures, self.change_capacity, self.compare,
                     self.resize, self.play, self.verdicts, self.light_theme, self.capture, self.quit):
            began = time.monotonic()
            stop()
            print(f"      {stop.__name__}: {time.monotonic() - began:.1f} s", flush=True)

    def first_frame(self):
        self.log.wait(r"Loaded ", 0, START_SECONDS, "the scene")
        self.log.wait(r"Traced frame", 0, START_SECONDS, "the first traced frame")
        self.log.wait(GRID, 0, START_SECONDS, "the grid's totals")
        self.window.move(WIDTH // 2, 300)
        self.window.shot("first_frame")
        check(True, "a scene is loaded, built and traced")

    def choose_view(self):
        since = self.log.place()
        # The list of views stands at the left of the view bar; typing is not needed: the list is a menu.
        self.window.click(*self.place("view list"))
        self.window.shot("view_list")
        self.window.click(*self.place("view entry"))
        match = self.log.wait(r"View (.*)", since, SHORT_SECONDS, "the chosen view")
        self.window.shot("view")
        check(bool(match.group(1)), f"the view {match.group(1)} is chosen from the list")

    def click_pixel(self):
        since = self.log.place()
        self.window.keys("2")
        self.window.click(*self.place("picture"))
        match = self.log.wait(RECORDED, since, STAGE_SECONDS, "the clicked pixel's record")
        self.log.wait(STEP, since, SHORT_SECONDS, "its first step")
        self.window.shot("pixel")
        check("equals the frame's hit" in match.group(4), f"pixel {match.group(1)},{match.group(2)}: the recorded ray ends with the frame's hit")

    def steps_from(self, since, count, what):
        """The texts of the next `count` steps."""
        steps = []
        for _ in range(count):
            match = self.log.wait(STEP, since, SHORT_SECONDS, what)
            with self.log.changed:
                for index in range(since, len(self.log.lines)):
                    if re.search(STEP, self.log.lines[index]):
                        since = index + 1
                        break
            steps.append((int(match.group(1)), match.group(3)))
        return steps

    def ray_with_steps(self, least):
        """Goes to the next rays until one has more steps than `least`."""
        for _ in range(200):
            match = self.log.last(RECORDED)
            if match and int(match.group(3)) > least:
                return
            since = self.log.place()
            self.window.keys("bracketright")
            self.log.wait(RECORDED, since, STAGE_SECONDS, "the next ray's record")
        raise Failed(f"none of 200 rays has more than {least} steps")

    def step_forward_and_back(self):
        self.ray_with_steps(6)
        self.window.keys("Home")
        first = self.log.last(STEP)
        there = [(int(first.group(1)), first.group(3))]
        since = self.log.place()
        for _ in range(5):
            self.window.keys("Right")
        there += self.steps_from(since, 5, "a step forward")
        self.window.shot("five_steps")
        since = self.log.place()
        for _ in range(5):
            self.window.keys("Left")
        back = [there[-1]] + self.steps_from(since, 5, "a step back")
        check([step for step, _ in there] == [0, 1, 2, 3, 4, 5], "Right goes forward a step at a time")
        check(back == there[::-1], "five steps back show the same five steps")

    def run_to_saturated(self):
        # Along the rays of the table; where those meet none, along the rays that end with a wrong voxel hit: their last cell is saturated.
        for way in ["bracketright"] * 40 + ["w"] * 5:
            since = self.log.place()
            self.window.keys("s")
            try:
                match = self.log.wait(STEP, since, 0.8, "the next saturated cell")
            except Failed:
                match = None
            if match and "saturated" in match.group(3):
                break
            since = self.log.place()
            self.window.keys(way)
            self.log.wait(RECORDED, since, STAGE_SECONDS, "the next ray's record")
        else:
            raise Failed("no saturated cell on 45 rays")
        self.window.shot("saturated_step")
        check(True, f"S runs to a saturated cell: step {match.group(1)}, {match.group(3)}")

    def orbit_around_the_ray(self):
        since = self.log.place()
        x, y = self.place("picture")
        self.window.drag(x, y, x + 120, y + 30, 2)
        self.log.wait(r"The ray is held", since, SHORT_SECONDS, "the held ray")
        self.log.wait(r"Traced frame", since, STAGE_SECONDS, "the frame of the moved camera")
        since = self.log.place()
        self.window.keys("Home", "End")
        match = self.log.wait(STEP, since, SHORT_SECONDS, "a step of the held ray")
        self.window.shot("orbit")
        check(bool(match), "the ray is stepped while the camera stands elsewhere")
        since = self.log.place()
        self.window.keys("ctrl+Home")
        self.log.wait(RECORDED, since, STAGE_SECONDS, "the ray of the pixel from the scene's own camera")

    def pick_cell(self):
        since = self.log.place()
        self.window.tool("keydown", "alt")
        self.window.click(*self.place("picture"))
        self.window.tool("keyup", "alt")
        match = self.log.wait(r"Selected cell ([\d,]+)", since, SHORT_SECONDS, "the cell under the mouse")
        self.window.shot("picked_cell")
        check(bool(match), f"Alt and a click select the cell {match.group(1)}")

    def compare(self):
        since = self.log.place()
        self.window.keys("k")
        self.log.wait(r"This frame is kept", since, SHORT_SECONDS, "the kept frame")
        before = self.log.last(GRID)
        since = self.log.place()
        self.window.keys("ctrl+Right")
        self.log.wait(r"Traced frame", since, STAGE_SECONDS, "the frame beside the kept one")
        wiped = self.window.shot("compare").read_bytes()
        self.window.keys("space")
        flipped = self.window.shot("flipped").read_bytes()
        check(bool(before) and wiped != flipped, "Space flips the kept frame and the live one")
        self.window.keys("ctrl+Left", "ctrl+1")

    def select_cell(self):
        since = self.log.place()
        self.window.keys("c")
        match = self.log.wait(r"Selected cell ([\d,]+): stored ([\d,]+), refused ([\d,]+)", since, SHORT_SECONDS, "the fullest cell")
        self.window.shot("cell")
        check(number(match.group(3)) > 0, f"the fullest cell, {match.group(1)}, refused {match.group(3)}")

    def look_at_tables(self):
        for name in ("cells", "instances", "triangles", "rays", "causes", "plots"):
            self.window.click(*self.place("tab " + name))
            time.sleep(1.0)
            self.window.shot("tab_" + name)

    def walk_by_keys(self):
        self.window.keys("alt+5")
        time.sleep(1.5)
        pixels = []
        for _ in range(2):
            since = self.log.place()
            self.window.keys("Down")
            pixels.append(self.log.wait(RECORDED, since, STAGE_SECONDS, "the next row's ray").groups()[:2])
        since = self.log.place()
        self.window.keys("Up")
        back = self.log.wait(RECORDED, since, STAGE_SECONDS, "the row before's ray").groups()[:2]
        self.window.shot("rows_by_keys")
        check(pixels[0] != pixels[1] and back == pixels[0], "Down goes through the rows of the Rays tab, Up goes back")
        since = self.log.place()
        self.window.keys("Next")
        view = self.log.wait(r"View (.*)", since, SHORT_SECONDS, "the next view").group(1)
        self.window.keys("Prior")
        check(bool(view), f"PageDown shows {view}")

    def save_pictures(self):
        files = []
        for _ in range(2):
            since = self.log.place()
            self.window.keys("ctrl+s")
            files.append(self.log.wait(r"Wrote (.*\.png)", since, STAGE_SECONDS, "the picture").group(1))
        check(files[0] != files[1] and all((self.window.folder / file).exists() for file in files), f"{files[0]} stays when {files[1]} is written")

    def change_capacity(self):
        before = self.log.last(GRID)
        since = self.log.place()
        self.window.keys("1")
        x, y = self.place("capacity")
        self.window.move(x, y)
        self.window.tool("keydown", "ctrl")
        self.window.click(x, y)
        self.window.tool("keyup", "ctrl")
        self.window.keys("ctrl+a")
        self.window.type("8")
        self.window.keys("Return")
        after = self.log.wait(GRID, since, STAGE_SECONDS, "the grid with another capacity")
        self.log.wait(r"Traced frame", since, STAGE_SECONDS, "the frame with another capacity")
        self.window.shot("capacity_8")
        check(number(after.group(2)) > number(before.group(2)), f"capacity 8 refuses {after.group(2)} references, before {before.group(2)}")
        since = self.log.place()
        self.window.keys("ctrl+z")
        undone = self.log.wait(GRID, since, STAGE_SECONDS, "the grid after undo")
        self.log.wait(r"Traced frame", since, STAGE_SECONDS, "the frame after undo")
        check(undone.groups() == before.groups(), "Ctrl+Z brings the statistics back")

    def resize(self):
        self.window.resize(1600, 900)
        self.window.shot("large")
        self.window.resize(900, 620)
        self.window.shot("small")
        self.window.resize(WIDTH, HEIGHT)
        self.window.move(WIDTH // 2, 300)
        check(self.window.child.process.poll() is None, "the window is resized to 1600x900, 900x620 and back")

    def play(self):
        since = self.log.place()
        self.window.keys("ctrl+space")
        match = self.log.wait(r"Traced frame ([1-9]\d*)", since, STAGE_SECONDS, "a later frame")
        self.log.wait(r"Traced frame ([2-9]\d*|1\d+)", since, STAGE_SECONDS, "the frame after it")
        self.window.shot("playing")
        self.window.keys("ctrl+space")
        check(int(match.group(1)) > 0, "time plays")

    def verdicts(self):
        since = self.log.place()
        self.window.keys("3")
        match = self.log.wait(r"Truth: ([\d,]+) rays, ([\d,]+) agree, ([\d,]+) wrong, ([\d,]+) voxel right", since, STAGE_SECONDS, "the truth")
        rays, agree, wrong, right = (number(text) for text in match.groups())
        check(agree + wrong + right == rays, f"{rays} rays: {agree} agree, {wrong} are wrong, {right} voxel hits are right")
        self.log.wait(r"Traced frame|Truth", since, STAGE_SECONDS, "the verdicts' views")
        time.sleep(2.0)
        self.window.shot("verdicts")
        self.window.keys("4")
        time.sleep(1.0)
        self.window.shot("tuner")
        self.window.keys("3")

    def light_theme(self):
        self.window.keys("ctrl+l")
        self.window.shot("light")
        self.window.keys("ctrl+l")
        check(self.window.child.process.poll() is None, "the light theme comes and goes")

    def capture(self):
        since = self.log.place()
        self.window.keys("F12")
        time.sleep(0.7)
        self.window.shot("capture_dialog")
        self.window.keys("Return")
        match = self.log.wait(r"Captured (.*)", since, STAGE_SECONDS, "the capture")
        file = self.window.folder / match.group(1)
        check(file.exists(), f"{match.group(1)} is written")
        done = subprocess.run([self.program, "replay", str(file)], cwd=self.window.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=STAGE_SECONDS)
        check(done.returncode == 0, f"{match.group(1)} replays equal" + ("" if done.returncode == 0 else f": {done.stdout.strip()[-300:]}"))

    def quit(self):
        self.window.shot("last")
        self.window.keys("ctrl+q")
        code = self.window.exit_code()
        self.log.thread.join(5.0)
        frames = self.log.last(r"Interface frames: .*")
        print("      " + (frames.group(0) if frames else "no interface frame times"), flush=True)
        messages = self.log.last(r"validation: (\d+) messages")
        check(messages is not None and messages.group(1) == "0", f"no validation message ({messages.group(0) if messages else 'not said'})")
        check(code == 0, f"Ctrl+Q ends with exit code {code}")

    # Where things stand at 1280x720, pixels of the window.
    PLACES = {
        "view list": (375, 83),
        "view entry": (345, 269),
        "picture": (600, 220),
        "capacity": (205, 318),
        "tab cells": (418, 461),
        "tab instances": (486, 461),
        "tab triangles": (567, 461),
        "tab rays": (633, 461),
        "tab causes": (694, 461),
        "tab plots": (756, 461),
    }

    def place(self, name):
        return self.PLACES[name]


def tour(program, folder, scene):
    name = Path(scene).stem
    into = folder / name
    shutil.rmtree(into, ignore_errors=True)
    into.mkdir(parents=True)
    display = Display()
    try:
        window = Window(program, scene, into, display.name)
        try:
            Tour(program, window).run()
        except Failed:
            try:
                window.shot("failed")
            except (Failed, subprocess.SubprocessError):
                pass
            raise
        finally:
            window.end()
    finally:
        display.end()


def main():
    if len(sys.argv) < 3:
        print(__doc__.strip())
        return 2
    program, folder, scenes = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve(), sys.argv[3:] or ["hall"]
    missing = [tool for tool in ("Xvfb", "xdotool", "import") if not shutil.which(tool)]
    if missing:
        print(f"skipped: {', '.join(missing)} not installed")
        return 77
    scenes = [str(Path(scene).resolve()) if Path(scene).exists() else scene for scene in scenes]
    for scene in scenes:
        began = time.monotonic()
        print(f"{scene}:", flush=True)
        try:
            tour(program, folder, scene)
        except (Failed, subprocess.SubprocessError) as failure:
            print(f"FAILED {scene}: {failure}; see {folder / Path(scene).stem}", flush=True)
            return 1
        print(f"{scene}: all checks hold, {time.monotonic() - began:.0f} s", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
