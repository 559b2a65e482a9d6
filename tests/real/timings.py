# SPDX-License-Identifier: LGPL-2.1-or-later
"""Times and fidelity of the assemblies of thin solids that come as STEP files.

    PYTHONPATH=build/Mod/SheetMorph /usr/bin/python3 tests/real/timings.py [name ...]

Prints the rows of the table in resources/docs/assemblies.md, one a recipe of recipes.py; run it
when nothing else does.
"""

from __future__ import annotations

import os
import statistics
import sys
import time
from collections.abc import Callable
from typing import Any

import recipes
import selection
from sheetmorph import Session, diagnose
from sheetmorph.finding import FindPart
from sheetmorph.checking.auto import filled, search

NAMES = ("box", "enclosure")
FRAMES = 25
AUTO = {"features": "auto", "contacts": "auto"}  # what is timed as finding


def timed(work: Callable[[], Any]) -> tuple[float, Any]:
    """Seconds, and what the work returns."""
    begin = time.perf_counter()
    result = work()
    return time.perf_counter() - begin, result


def frame_seconds(session: Session, pose: dict[str, Any]) -> float:
    """The median of frames while all handles are dragged."""
    drag = session.begin_drag(sorted(pose), pose)
    drag.wait()
    return statistics.median(timed(lambda: drag.deform(pose))[0] for _ in range(FRAMES))


def worst(entries: list[Any], key: str) -> float:
    """The largest value of a key."""
    return max((entry[key] for entry in entries), default=0.0)


def measured(name: str) -> dict[str, str]:
    """The columns of one assembly."""
    folder = recipes.data_folder()
    recipe = recipes.make(name)
    plain = [{k: entry[k] for k in ("file", "split")} for entry in recipe["parts"]]
    selection.read_once.cache_clear()
    importing, raw = timed(lambda: selection.read_meshes(plain, folder))
    diagnosis, _ = timed(lambda: [diagnose(mesh) for mesh in raw.values()])
    reading, meshes = timed(lambda: selection.read_meshes(recipe["parts"], folder))
    asked = {key: word for key, word in AUTO.items() if isinstance(recipe[key], list)}
    finding, found = timed(
        lambda: search({**recipe, **asked}, [FindPart(part, mesh) for part, mesh in meshes.items()])
    )
    recipe = filled(recipe, found)  # lists of its own stay
    set_up, session = timed(lambda: Session(recipe, meshes))
    solve, result = timed(lambda: session.deform())
    report = result.report()
    thin = [part["thin"] for part in report["parts"] if part["thin"]]
    crossings = [part["self_intersections"] for part in thin]
    new = sum(c["deformed"] > 0 and c["rest"] == 0 for c in crossings)
    return {
        "parts (thin)": f"{len(meshes)} ({len(thin)})",
        "facets imported": f"{sum(len(mesh.triangles) for mesh in raw.values()):,}",
        "facets prepared": f"{sum(len(mesh.triangles) for mesh in meshes.values()):,}",
        "features, contacts": f"{len(report['features'])}, {len(report['contacts'])}",
        "import": f"{importing:.1f} s",
        "diagnosis": f"{diagnosis:.2f} s",
        "preparation, with the import": f"{reading:.1f} s",
        "finding": f"{finding:.1f} s",
        "set-up": f"{set_up:.2f} s",
        "frame": f"{1e3 * frame_seconds(session, recipe['pose']):.1f} ms",
        "exact solve": f"{1e3 * solve:.0f} ms",
        "largest change of thickness": f"{100 * worst(thin, 'largest_change'):.2f} %",
        "the same at walls": f"{100 * worst(thin, 'largest_change_at_walls'):.2f} %",
        "largest change of a gap": f"{worst(report['contacts'], 'gap_change'):.2f} mm",
        "flipped triangles": str(sum(part["quality"]["flipped"] for part in report["parts"])),
        "parts that newly meet themselves": str(new),
    }


def main(names: list[str]) -> None:
    """Prints the table of the recipes with these names."""
    if recipes.data_folder() is None:
        print(f"Nothing measured: {recipes.ABSENT}.")
        return
    columns = {name: measured(name) for name in names or NAMES}
    print(f"load {os.getloadavg()[0]:.1f}")
    print("| | " + " | ".join(columns) + " |")
    print("|---|" + "---|" * len(columns))
    for row in next(iter(columns.values())):
        print(f"| {row} | " + " | ".join(column[row] for column in columns.values()) + " |")


if __name__ == "__main__":
    main(sys.argv[1:])
