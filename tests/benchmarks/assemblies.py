# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures the example assemblies: pre-processing, time per frame, gaps of their contacts.

    /usr/bin/python3 tests/benchmarks/assemblies.py <staged add-on>

Prints times and the table of gaps in resources/docs/benchmarks.md; times are a table of
`./sheetmorph bench`, too. They are medians of 7; run it when nothing else does.
"""

from __future__ import annotations

import json
import os
import platform
import statistics
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from tables import markdown

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


@dataclass
class Times:
    """What one example took, seconds; stages are summed over the threads."""

    name: str
    vertices: int
    parts: int
    control_meshes: int
    meshing: float
    solving: float
    set_up: float
    frame: float
    exact: float

    def cells(self) -> list[str]:
        """A row of the table of times."""
        cells = [self.name, f"{self.vertices:,}", str(self.parts), str(self.control_meshes)]
        cells += [f"{1e3 * t:.3g} ms" for t in (self.meshing, self.solving, self.set_up)]
        return cells + [f"{1e3 * t:.3g} ms" for t in (self.frame, self.exact)]


def timed(name: str) -> Times:
    """The kernel alone, as the paper measures: no file, no check of the recipe.

    Frames are those of a drag whose background work is done.
    """
    from sheetmorph import Session
    from sheetmorph.checking import check_pose
    from sheetmorph.solving.translation import Translator

    recipe, meshes = load(name)
    session = Session(recipe, meshes)
    translator = Translator(session.core, session.model, session.meshes)
    assembly = translator.assembly()
    kernel = session.core.DeformationSession(assembly, None, None)
    pose = translator.pose(check_pose(session.model, recipe["pose"]))
    drag = kernel.begin_drag([entry.name for entry in session.model.of_kind("handle")], pose)
    drag.wait()
    set_up = median(lambda: session.core.DeformationSession(assembly, None, None))
    frame = median(lambda: [drag.frame(pose) for _ in range(FRAMES)]) / FRAMES
    exact = median(lambda: [kernel.deform(pose, True) for _ in range(FRAMES)]) / FRAMES
    meshing, solving = stages(lambda: session.core.DeformationSession(assembly, None, None))
    is_single = session.model.propagation.type == "single"
    return Times(
        name=name.replace("_", " "),
        vertices=sum(len(mesh.points) for mesh in meshes.values()),
        parts=len(meshes),
        control_meshes=1 if is_single else len(session.directions),
        meshing=meshing,
        solving=solving,
        set_up=set_up,
        frame=frame,
        exact=exact,
    )


def time_table(times: list[Times]) -> str:
    """All examples as Markdown."""
    head = ["assembly", "vertices", "parts", "control meshes", "they and their weights"]
    head += ["parts solved", "pre-processing, wall time", "frame of a drag", "exact frame"]
    return markdown(head, [one.cells() for one in times])


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
    print(time_table([timed(name) for name in NAMES]))
    print(row(["example", "contacts", "largest gap change", "of the region's size"]))
    for name in NAMES:
        print("\n".join(gaps(name)))


if __name__ == "__main__":
    main(sys.argv[1])
