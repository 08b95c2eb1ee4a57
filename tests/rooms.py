#!/usr/bin/env python3
"""Checks every include line against the rooms: what a room may include stands after NEEDS in the CMakeLists.txt files (add_room), and what those
rooms need is allowed too. The shared shader headers have the same rooms; whoever may include core/grid may include shaders/shared/grid.

    rooms.py [SOURCE_FOLDER]        exit code 1: each line that breaks a rule is printed"""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent)
SOURCES = {".cpp", ".h", ".inc", ".comp", ".glsl", ".vert", ".geom", ".frag"}
APP_SEES = ["core", "views"]  # every app room, all of these


def needs_of_rooms():
    """Room -> rooms after its NEEDS, over all CMakeLists.txt files."""
    needs = {}
    for file in ("core", "views", "app"):
        text = (ROOT / file / "CMakeLists.txt").read_text()
        for room, listed in re.findall(r"add_room\((\S+)(?:\s+NEEDS\s+([^)]*?))?\s+SOURCES", text):
            needs[room] = listed.split()
    return needs


def closure(room, needs):
    seen, left = set(), [room]
    while left:
        one = left.pop()
        if one not in seen:
            seen.add(one)
            left += needs.get(one, [])
    return seen


def room_of(path, needs):
    """The room of a file or an included path: its folder; None for the tests and what lies outside."""
    folder = path.rsplit("/", 1)[0]
    if folder.startswith("shaders/shared/"):
        return folder
    if folder.startswith("shaders/"):
        return folder
    if folder.startswith("core/") and folder.count("/") == 2:
        folder = folder.rsplit("/", 1)[0]  # a room's own folder for one subject, as core/gpu/grid
    return folder if folder in needs or folder.split("/")[0] in ("app", "core", "views") else None


def allowed_rooms(room, needs):
    if room.startswith("shaders/"):
        name = room.split("/")[-1]
        twin = "views" if name in ("views", "window") else "core/" + name
        rooms = closure(twin, needs)
        names = {r.split("/")[-1] for r in rooms}
        shared = {"shaders/shared/" + n for n in names}
        if room.startswith("shaders/shared/"):
            return shared
        # Every pass exchanges its buffers with core/gpu.
        shared |= {"shaders/shared/" + r.split("/")[-1] for r in closure("core/gpu", needs)}
        return shared | {"shaders/" + n for n in names} | {"shaders/gpu", room} | ({"views"} if name == "views" else set())
    if room == "app":
        rooms = set(needs)
    else:
        rooms = closure(room, needs)
    return rooms | {"shaders/shared/" + r.split("/")[-1] for r in rooms}


def main():
    needs = needs_of_rooms()
    faults = []
    files = [f for top in ("app", "core", "views", "shaders") for f in sorted((ROOT / top).rglob("*")) if f.suffix in SOURCES]
    for file in files:
        name = file.relative_to(ROOT).as_posix()
        room = room_of(name, needs)
        allowed = allowed_rooms(room, needs)
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = re.match(r'\s*#include "([^"]+)"', line)
            if not found:
                continue
            target = room_of(found[1], needs) if "/" in found[1] else None
            if target and target not in allowed:
                faults.append(f"{name}:{number}: {room} may not include {found[1]}")
            elif "/" not in found[1] and "@" not in found[1]:
                faults.append(f"{name}:{number}: {found[1]}: included by another path than from the source folder")
            elif not (ROOT / found[1]).exists() and "@" not in found[1]:
                faults.append(f"{name}:{number}: {found[1]} does not exist")
    for fault in faults:
        print(fault)
    print(f"{len(files)} files, {len(faults)} include lines break a rule", file=sys.stderr)
    return 1 if faults else 0


sys.exit(main())
