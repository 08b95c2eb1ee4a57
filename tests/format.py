#!/usr/bin/env python3
"""Checks that every .cpp and .h is as .clang-format says. Versions of clang-format differ in what they make of it: only version 14 judges
(Debian 12's). Elsewhere the check is skipped, by name.

    format.py [SOURCE_FOLDER]        exit code 1: each place that differs is printed; 77: there is no clang-format 14"""

import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent)
FOLDERS = ("app", "core", "shaders", "tests", "views")
VERSION = "14"
BATCH = 32  # files a call


def formatter():
    """The path of a clang-format of that version; None where there is none."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        path = shutil.which(name)
        if path and re.search(rf"version {VERSION}\.", subprocess.run([path, "--version"], capture_output=True, text=True).stdout):
            return path
    return None


def main():
    program = formatter()
    if not program:
        print(f"skipped: there is no clang-format {VERSION} here")
        return 77
    files = sorted(file for folder in FOLDERS for file in (ROOT / folder).rglob("*") if file.suffix in (".cpp", ".h"))

    def check(batch):
        return subprocess.run([program, "--dry-run", "-Werror", *batch], capture_output=True, text=True, cwd=ROOT)

    batches = [files[i : i + BATCH] for i in range(0, len(files), BATCH)]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(check, batches))
    for result in results:
        print(result.stderr, end="")
    failed = any(result.returncode for result in results)
    print(f"{len(files)} files, " + ("some are not as .clang-format says" if failed else "all as .clang-format says"))
    return 1 if failed else 0


sys.exit(main())
