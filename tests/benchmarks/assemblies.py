# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures the example assemblies: pre-processing, time per frame, gaps of their contacts.

    /usr/bin/python3 tests/benchmarks/assemblies.py <staged add-on>

Prints the tables of resources/docs/benchmarks.md. Times are medians of 7; run it when nothing
else does.
"""

from __future__ import annotations

import json
import os
import platform
import statistics
import sys
import time
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "resources" / "examples"
NAMES = ("door_mirror", "body_panels", "welded_frame")
KINDS = ("rigid", "tied", "control mesh")
RUNS = 7
FRAMES = 20


def load(name: str) -> tuple[dict, dict]:
    """The recipe of an example and its meshes by part name."""
    from sheetmorph import read_part

    folder = EXAMPLES / name
    recipe = json.loads((folder / "recipe.json").read_text(encoding="utf-8"))
    return recipe, {e["name"]: read_part(folder / e["file"]).mesh for e in recipe["parts"]}


def seconds(work) -> float:
    """Wall time of a call."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def median(work, runs: int = RUNS) -> float:
    """Median wall time of several calls, after one that does not count."""
    work()
    return statistics.median(seconds(work) for _ in range(runs))


def timed(name: str) -> str:
    """A row of the table of times."""
    from sheetmorph import Session
    from sheetmorph.recipe import check_pose
    from sheetmorph.translation import Translator

    recipe, meshes = load(name)
    session = Session(recipe, meshes)
    # The kernel alone, as the paper measures: no file, no check of the recipe.
    translator = Translator(session.core, session.model, session.meshes)
    assembly = translator.assembly()
    kernel = session.core.DeformationSession(assembly, None, None)
    pose = translator.pose(check_pose(session.model, recipe["pose"]))
    set_up = median(lambda: session.core.DeformationSession(assembly, None, None))
    live = median(lambda: [kernel.deform(pose, False) for _ in range(FRAMES)]) / FRAMES
    exact = median(lambda: [kernel.deform(pose, True) for _ in range(FRAMES)]) / FRAMES
    meshing, solving = stages(lambda: session.core.DeformationSession(assembly, None, None))
    vertices = sum(len(mesh.points) for mesh in meshes.values())
    used = "1" if session.model.propagation.type == "single" else str(len(session.directions))
    cells = [name, f"{vertices:,}", f"{len(meshes)}", used]
    cells += [f"{1e3 * t:.0f} ms" for t in (meshing, solving, set_up)]
    cells += [f"{1e3 * t:.2f} ms" for t in (live, exact)]
    return row(cells)


def stages(make) -> tuple[float, float]:
    """Median seconds of all control meshes with their weights, and of all parts.

    Each is summed over what several threads do at once: more than the wall time together.
    """
    runs = [make().timings for _ in range(RUNS)]
    sums = [
        [sum(t.seconds for t in run if t.stage.startswith(word)) for run in runs]
        for word in ("contact", "part")
    ]
    return statistics.median(sums[0]), statistics.median(sums[1])


def gaps(name: str) -> list[str]:
    """Rows of the table of gaps: all contacts of one type, local propagation."""
    from sheetmorph import Session

    recipe, meshes = load(name)
    rows = []
    for kind in KINDS:
        changed = {**recipe, "propagation": {"type": "local"}}
        changed["contacts"] = [{**entry, "type": kind} for entry in recipe["contacts"]]
        try:
            contacts = Session(changed, meshes).deform().contacts
        except ValueError as error:
            rows.append(row([name, kind, "refused", str(error)[:300]]))
            continue
        worst = max(contact.gap_change for contact in contacts)
        share = max(contact.gap_change / contact.region_size for contact in contacts)
        rows.append(row([name, kind, f"{worst:.2g} mm", f"{100.0 * share:.2g} %"]))
    return rows


def row(cells: list[str]) -> str:
    """A row of a Markdown table."""
    return "| " + " | ".join(cells) + " |"


def main(staged: str) -> None:
    """Prints both tables."""
    sys.path.insert(0, staged)
    print(f"{platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    head = ["example", "vertices", "parts", "control meshes", "they and their weights"]
    print(row([*head, "parts solved", "pre-processing", "frame", "exact frame"]))
    for name in NAMES:
        print(timed(name))
    print(row(["example", "contacts", "largest gap change", "of the region's size"]))
    for name in NAMES:
        print("\n".join(gaps(name)))


if __name__ == "__main__":
    main(sys.argv[1])
