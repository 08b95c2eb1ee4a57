#!/usr/bin/env python3
"""Fills the tables of core/truth/TRUTH.md: runs `gridscope explain --verify` over scenes and settings and prints what it found as markdown.

    tests/truth/tables.py PROGRAM SCENE_FOLDER [--out FOLDER] [--size 640x360] [--scenes sponza,sibenik] [-- OPTION...]

Each run leaves FOLDER/SCENE_CELLS_CAPACITY_TRAVERSAL.json; a run whose file is there already is not repeated. What follows -- goes to
every run (--device cpu, say). Exit 1 when a run fails or a promise of the page does not hold."""
import argparse
import itertools
import json
import pathlib
import subprocess
import sys

SCENES = "sponza,sibenik,country_kitchen,conference"
VERDICTS = {"hole": "hole", "voxelRight": "voxel right", "voxelWrong": "voxel wrong", "far": "too far", "near": "too near"}
CAUSES = {"refused": "refused", "steppedOver": "stepped over", "revisit": "revisit", "segmentEnd": "segment end",
          "acceptedEarly": "accepted early", "gate": "gate", "filledEarly": "filled early", "alpha": "alpha", "selfHit": "self-hit",
          "outside": "outside", "leftOut": "left out", "stale": "stale", "notInserted": "not inserted", "segmentLimit": "segment limit",
          "numeric": "numeric"}


def percent(part, whole):
    """Three digits; 0 only for nothing."""
    return "0" if part == 0 else f"{100 * part / whole:.3g}"


def explain(arguments, scene, cells, capacity, traversal):
    """The JSON of one setting, from its file where there is one."""
    path = arguments.out / f"{scene}_{cells}_{capacity}_{traversal}.json"
    if not path.exists():
        command = [arguments.program, "explain", f"{arguments.scenes_folder}/{scene}.glb", "--size", arguments.size, "--cells", cells, "--capacity",
                   capacity, "--traversal", traversal, "--teapots", "3", "--verify", "--worst", "0", "--json", str(path), *arguments.options]
        ended = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if ended.returncode != 0:
            print(f"{' '.join(map(str, command))}: exit {ended.returncode}: {ended.stderr.strip()}", file=sys.stderr)
            return None
    return json.loads(path.read_text())


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] * 4 + ["--:"] * (len(head) - 4)) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def broken_promises(name, result):
    """What must hold in every run, and does not in this one."""
    rays, differ = result["rays"], sum(result["causes"].values())
    confirmed = sum(alone + chain for alone, chain, _ in result["confirmed"].values())
    agree = sum(result["agree"].values())
    if agree + sum(result["verdicts"].values()) != rays: yield f"{name}: agree and verdicts do not add up to the rays"
    if differ != sum(result["verdicts"].values()): yield f"{name}: the causes do not add up to the verdicts"
    if result["causes"]["notInserted"] != 0: yield f"{name}: {result['causes']['notInserted']} rays not inserted"
    if result["causes"]["numeric"] >= 0.001 * rays: yield f"{name}: {result['causes']['numeric']} rays numeric"
    if differ and confirmed < 0.99 * differ: yield f"{name}: {percent(confirmed, differ)} % confirmed"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("scenes_folder")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("truth"))
    parser.add_argument("--size", default="640x360")
    parser.add_argument("--scenes", default=SCENES)
    parser.add_argument("options", nargs="*")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)

    verdict_rows, cause_rows, faults = [], [], []
    seen = set()
    for scene, cells, capacity, traversal in itertools.product(arguments.scenes.split(","), (64, 128), (16, 32), ("segment", "dda")):
        result = explain(arguments, scene, cells, capacity, traversal)
        setting = [scene, str(cells), str(capacity), traversal]
        if result is None:
            faults.append(" ".join(setting) + ": the run failed")
            continue
        faults += broken_promises(" ".join(setting), result)
        rays, differ = result["rays"], sum(result["causes"].values())
        seen |= {cause for cause, count in result["causes"].items() if count}
        verdict_rows.append(setting + [percent(result["agree"]["hit"], rays), percent(result["agree"]["miss"], rays)] +
                            [percent(result["verdicts"][key], rays) for key in VERDICTS] + [percent(result["wrong"], rays)])
        alone, chain = (sum(counts[i] for counts in result["confirmed"].values()) for i in (0, 1))
        cause_rows.append((setting, result["causes"], rays, [f"{differ}", percent(alone, differ or 1), percent(chain, differ or 1), str(differ - alone - chain),
                                                             str(result["mostLinks"]), *(percent(result[key]["confirmed"], result[key]["total"] or 1) for key in ("control", "controlChain"))]))

    # Causes that no ray of any run has are named below the table instead of a column of zeros.
    shown = [key for key in CAUSES if key in seen]
    print(f"Verdicts, percent of the rays ({arguments.size}, 3 teapots):\n")
    print(table(["scene", "cells", "capacity", "traversal", "agree, hit", "agree, miss", *VERDICTS.values(), "wrong"], verdict_rows))
    print("Causes, percent of the rays; proofs and controls, percent of the rays that differ:\n")
    print(table(["scene", "cells", "capacity", "traversal", *(CAUSES[key] for key in shown), "rays that differ", "confirmed alone", "as a chain",
                 "not confirmed (rays)", "longest chain (links)", "control alone", "control alone or as a chain"],
                [setting + [percent(causes[key], rays) for key in shown] + proof for setting, causes, rays, proof in cause_rows]))
    print("No ray of any run: " + ", ".join(CAUSES[key] for key in CAUSES if key not in seen) + ".")
    for fault in faults: print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
