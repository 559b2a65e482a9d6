# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a variant of the welded frame costs against the number of workers; 100 of them simulated.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/benchmarks/studies.py [variants]

Prints tables of resources/docs/benchmarks.md. Processor time is what counts: it hardly depends
on what else the machine does.
"""

from __future__ import annotations

import heapq
import json
import os
import resource
import shutil
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from sheetmorph.study import Ways, run_study
from sheetmorph.study.plan import Plan
from sheetmorph.study.working import Workshop

FRAME = Path(__file__).resolve().parents[2] / "resources" / "examples" / "welded_frame"
SIZES = {"mount left: tow": 26.0, "seat plate: access": 50.0}
HANDLE = "pose.front end"
PARAMETERS = {
    "x": {"path": f"{HANDLE}.translation[0]", "range": [-20, 20]},
    "y": {"path": f"{HANDLE}.translation[1]", "range": [-20, 20]},
    "z": {"path": f"{HANDLE}.translation[2]", "range": [0, 60]},
    "turn": {"path": f"{HANDLE}.rotation.degrees", "range": [-9, 9]},
    "tow": {"path": "features.mount left: tow.size", "range": [22, 28]},
    "access": {"path": "features.seat plate: access.size", "range": [40, 60]},
}
WORKERS = (1, 2, 10, 100, 1000)


@dataclass(frozen=True)
class Costs:
    """Processor seconds: until workers begin, once for all of them, of a variant in one, of a
    variant in the process that hands out; bytes of a variant on the disk."""

    begin: float
    variant: float
    handing: float
    size: float


def write_study(folder: Path, count: int) -> Path:
    """The frame with two holes of set sizes, and a study of six parameters."""
    shutil.copytree(FRAME, folder / "frame")
    recipe = json.loads((folder / "frame" / "recipe.json").read_text("utf-8"))
    for feature in recipe["features"]:
        if feature["name"] in SIZES:
            feature["size"] = SIZES[feature["name"]]
    (folder / "frame" / "recipe.json").write_text(json.dumps(recipe))
    study = {
        "sheetmorph_study": 1,
        "recipe": "frame/recipe.json",
        "parameters": PARAMETERS,
        "sampling": {"method": "sobol", "count": count, "seed": 1},
        "measure": {"tip": {"position": "front end"}, "stretch": {"worst": "stretch"}},
    }
    (folder / "study.json").write_text(json.dumps(study))
    return folder / "study.json"


def computed(study: Path, workers: int) -> tuple[dict, float]:
    """What a call tells of its costs, and the processor seconds of the one who hands out."""
    out = study.parent / f"out{workers}"
    before = resource.getrusage(resource.RUSAGE_SELF)
    run_study(study, out, Ways("processes", workers))
    after = resource.getrusage(resource.RUSAGE_SELF)
    own = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return json.loads((out / "costs.json").read_text()), own


def begin_cost(study: Path) -> float:
    """Processor seconds before the first variant, once for all workers: reading, pre-processing."""
    start = time.process_time()
    Workshop(Plan(study)).begin(0)
    return time.process_time() - start


def simulated(workers: int, variants: int, costs: Costs) -> float:
    """Seconds until all variants are done: workers of a core each, one who takes them in."""
    free = [costs.begin] * workers
    heapq.heapify(free)
    taken_in = 0.0
    for _ in range(variants):
        done = heapq.heappop(free) + costs.variant
        heapq.heappush(free, done)
        taken_in = max(taken_in, done) + costs.handing
    return taken_in


def main(variants: int) -> None:
    with tempfile.TemporaryDirectory(prefix="sheetmorph-studies-") as name:
        study = write_study(Path(name), variants)
        begin = begin_cost(study)
        measured = {workers: computed(study, workers) for workers in (1, 2)}
        files = [path for path in (study.parent / "out1").rglob("*") if path.is_file()]
        size = sum(path.stat().st_size for path in files) / variants
    print(f"{variants} variants, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}\n")
    print("| workers | seconds | variants a second | processor s a variant | of them the kernel |")
    print("|---|---|---|---|---|")
    for workers, (told, _) in measured.items():
        cpu = told["cpu_seconds_of_workers"] / variants
        share = told["cpu_seconds_of_kernel"] / told["cpu_seconds_of_workers"]
        rate = told["variants_a_second"]
        print(
            f"| {workers} | {told['seconds']:.1f} | {rate:.2f} | {cpu:.3f} | {100 * share:.0f} % |"
        )
    one, own = measured[1]
    variant = one["cpu_seconds_of_workers"] / variants
    costs = Costs(begin, variant, (own - begin) / variants, size)
    print(f"\nbegin {begin:.2f} s, variant {variant:.3f} s, handing out {costs.handing:.4f} s, ")
    print(f"{size / 1e6:.2f} MB a variant\n")
    print("| workers | 10,000 variants, s | variants a second | of the workers' time used | MB/s |")
    print("|---|---|---|---|---|")
    for workers in WORKERS:
        seconds = simulated(workers, 10_000, costs)
        used = 10_000 * variant / (workers * seconds)
        rate = 10_000 / seconds
        print(
            f"| {workers} | {seconds:.0f} | {rate:.1f} | {100 * used:.0f} % | "
            f"{rate * size / 1e6:.0f} |"
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
