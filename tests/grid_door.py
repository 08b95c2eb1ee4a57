#!/usr/bin/env python3
"""Checks that nobody outside the grid's rooms knows how a grid is stored: words of its layout may stand in core/grid, core/gpu/grid, shaders/grid,
shaders/shared/grid and in tests alone. Everybody else goes through core/grid/grid.h and shaders/shared/grid/cell.h.

    grid_door.py [SOURCE_FOLDER]        exit code 1: each line that breaks the rule is printed"""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent)
SOURCES = {".cpp", ".h", ".comp", ".glsl", ".vert", ".geom", ".frag"}
ROOMS = ("core/grid/", "core/gpu/grid/", "shaders/grid/", "shaders/shared/grid/")
WORDS = re.compile(r"\bgridTexel\w*|\bgridRefusedTexel\b|\bslot(Load|Store|Min|Swap)\b|\.(stride|reserved|stretchAxis)\b|\bkBlank\b|\bgridImage\b")

faults = 0
for top in ("app", "core", "views", "shaders"):
    for file in sorted((ROOT / top).rglob("*")):
        name = file.relative_to(ROOT).as_posix()
        if file.suffix not in SOURCES or name.startswith(ROOMS):
            continue
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            found = WORDS.search(line.split("//")[0])
            if found:
                print(f"{name}:{number}: {found[0]}: a word of the grid's layout")
                faults += 1
sys.exit(1 if faults else 0)
