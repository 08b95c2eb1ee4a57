#!/usr/bin/env python3
"""Measures what compiling costs: configures a fresh build folder with the flags of ./run, builds what ./test builds, without ccache, and adds
up the user and system time of every call of the compiler. Shaders, linking and discovering tests don't count.

    compile_time.py [--no-pch] [--jobs N] [--keep] [--source FOLDER]    prints the sum and the ten dearest files; exit code 1: it does not build"""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

LOG = "GRIDSCOPE_COMPILE_TIMES"
TARGETS = ("gridscope", "unit_tests", "gpu_tests", "program_tests")


def launch(command):
    """As the compiler's launcher: runs it and notes its time and its source."""
    code = subprocess.call(command)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    source = next((word for word in reversed(command) if word.endswith((".cpp", ".hxx", ".S"))), "?")
    with open(os.environ[LOG], "a", encoding="utf-8") as log:
        log.write(f"{used.ru_utime + used.ru_stime:.3f} {source}\n")
    return code


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--no-pch", action="store_true", help="without precompiled headers")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--keep", action="store_true", help="keep the build folder, and say where it is")
    parser.add_argument("--source", type=Path, default=Path(__file__).resolve().parent.parent, help="another checkout to measure")
    given = parser.parse_args()

    folder = tempfile.mkdtemp(prefix="gridscope_compile_")
    log = Path(folder) / "times"
    environment = {name: value for name, value in os.environ.items() if name != "CI"} | {LOG: str(log)}
    configure = ["cmake", "-S", str(given.source), "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCCACHE="]
    for language in ("C", "CXX", "ASM"):
        configure.append(f"-DCMAKE_{language}_COMPILER_LAUNCHER={sys.executable};{Path(__file__).resolve()};--launch")
    configure.append(f"-DCMAKE_DISABLE_PRECOMPILE_HEADERS={'ON' if given.no_pch else 'OFF'}")
    try:
        subprocess.run(configure, check=True, env=environment, stdout=subprocess.DEVNULL)
        log.unlink(missing_ok=True)  # of CMake's own tries
        built = subprocess.run(["ninja", "-C", folder, "-j", str(given.jobs), *TARGETS], env=environment, check=False).returncode == 0
        lines = [line.split(" ", 1) for line in log.read_text(encoding="utf-8").splitlines()]
        times = sorted(((float(seconds), source) for seconds, source in lines), reverse=True)
        for seconds, source in times[:10]:
            print(f"{seconds:7.2f} s  {source.removeprefix(str(given.source) + '/')}")
        print(f"{sum(seconds for seconds, _ in times):7.0f} s  {len(times)} calls of the compiler{', without precompiled headers' if given.no_pch else ''}")
        return 0 if built else 1
    finally:
        if given.keep:
            print(folder)
        else:
            subprocess.run(["cmake", "-E", "rm", "-rf", folder], check=False)


sys.exit(launch(sys.argv[2:]) if sys.argv[1:2] == ["--launch"] else main())
