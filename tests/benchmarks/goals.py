# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sets what a run measured beside the goals, and writes both into the benchmark page."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

from assemblies import Times
from real_part import RealPart
from tables import Measured, markdown, ratio, time_text

BEGIN, END = "<!-- measured by ./sheetmorph bench -->", "<!-- end of what is measured -->"

Found = dict[str, dict[int, Measured]]


@dataclass
class Goal:
    """One goal: what is measured, and the bound it has to keep."""

    words: str
    value: float | None  # None: not measured in this run
    bound: float
    is_least: bool = False
    unit: str = "ms"

    def row(self) -> list[str]:
        """A row of the table."""
        if self.value is None:
            return [self.words, self.text(self.bound), "not measured", "-"]
        is_met = self.value >= self.bound if self.is_least else self.value <= self.bound
        return [
            self.words,
            self.text(self.bound),
            "reached" if is_met else "missed",
            self.text(self.value),
        ]

    def text(self, value: float) -> str:
        """The number with its unit."""
        return time_text(value) if self.unit == "ms" else f"{value:.3g} {self.unit}".strip()


def median(found: Found, name: str, size: int) -> float | None:
    """Milliseconds of a benchmark at a size, if it ran."""
    entry = found.get(name, {}).get(size)
    return entry.median if entry else None


def counter(found: Found, name: str, size: int, key: str) -> float | None:
    """A counter of a benchmark at a size, if it ran."""
    entry = found.get(name, {}).get(size)
    return entry.counters.get(key) if entry else None


def exponent(low: tuple[float, float] | None, high: tuple[float, float] | None) -> float | None:
    """Of a power of the number of vertices through two (vertices, value)."""
    if low is None or high is None:
        return None
    return math.log(high[1] / low[1]) / math.log(high[0] / low[0])


def grown(found: Found, size: int) -> tuple[float, float] | None:
    """Vertices and set-up time."""
    time = median(found, "set_up", size)
    return (found["set_up"][size].counters["vertices"], time) if time else None


def held(peaks: dict[int, dict[str, float]], size: int) -> tuple[float, float] | None:
    """Vertices and peak memory of a set-up."""
    return (peaks[size]["vertices"], peaks[size]["peak_memory_mib"]) if size in peaks else None


def frame_goals(found: Found) -> list[Goal]:
    """What frames have to keep."""
    goals = []
    for size, limit, times in ((100000, 0.3, 300), (1000000, 5.0, 350)):
        faster = ratio(found, "cgal_sre_arap_iteration", "live_frame", size) or None
        words = f"{size:,} vertices, frame, one handle turning and moving"
        goals.append(Goal(words, median(found, "live_frame", size), limit))
        goals.append(Goal("the same, times faster than CGAL", faster, times, True, ""))
    for words, name, size, limit in (
        ("50 free features, frame at their minimum", "live_frame_50_free_features", 100000, 3.0),
        ("three handles turning at once, frame", "three_handles_frame", 100000, 5.0),
        ("the same, 1,000,000", "three_handles_frame", 1000000, 40.0),
        ("exact solve on release, 100,000", "exact_frame", 100000, 60.0),
        ("20 parts of 50,000, 30 rigid welds, frame", "assembly_frame_rigid_welds", 50000, 15.0),
        ("the same with control meshes", "assembly_frame_control_meshes", 50000, 15.0),
    ):
        goals.append(Goal(words, median(found, name, size), limit))
    return goals


def set_up_goals(found: Found, peaks: dict[int, dict[str, float]]) -> list[Goal]:
    """What set-ups, their memory and mean value coordinates have to keep."""
    large = held(peaks, 1000000)
    pairs = counter(found, "mean_value_coordinates", 4000, "million_pairs_a_second")
    small_up = ratio(found, "set_up", "cgal_sre_arap_set_up", 100000) or None
    large_up = ratio(found, "set_up", "cgal_sre_arap_set_up", 1000000) or None
    feature = ratio(found, "one_more_feature", "set_up", 100000) or None
    strip = ratio(found, "one_more_fixed_region", "set_up", 100000) or None
    time = exponent(grown(found, 10000), grown(found, 1000000))
    memory = exponent(held(peaks, 10000), large)
    return [
        Goal("set-up of 100,000 against CGAL's", small_up, 1.0, unit="of it"),
        Goal("set-up of 1,000,000 against CGAL's", large_up, 0.25, unit="of it"),
        Goal("one more feature at 100,000 against set-up", feature, 1 / 3, unit="of it"),
        Goal("one more fixed strip at 100,000 against set-up", strip, 1 / 3, unit="of it"),
        Goal("peak memory at 1,000,000", large[1] / 1024.0 if large else None, 3.5, unit="GiB"),
        Goal("mean value coordinates, million pairs a second and core", pairs, 200, True, ""),
        Goal("exponent of set-up time, 1e4 to 1e6", time, 1.25, unit=""),
        Goal("exponent of memory, 1e4 to 1e6", memory, 1.2, unit=""),
    ]


def repair_goals(found: Found) -> list[Goal]:
    """What looking at a dirty mesh and making it anew have to keep."""
    return [
        Goal("diagnosis of 300,000 triangles", median(found, "diagnosis", 300000), 2000.0),
        Goal("remeshing 300,000 triangles", median(found, "remeshing", 300000), 60000.0),
    ]


def paper_goals(frame: Times) -> list[Goal]:
    """What the paper's assembly of 14 parts has to keep."""
    words = f"the paper's {frame.parts} parts, {frame.control_meshes} control meshes"
    return [
        Goal(f"{words}: set-up", 1e3 * frame.set_up, 120.0),
        Goal("the same, frame of a drag", 1e3 * frame.frame, 0.45),
    ]


def real_goals(part: RealPart | None) -> list[Goal]:
    """What a real thin solid with 190 free holes has to keep."""
    words = "a real sheet of 70,000 vertices with 190 free holes"
    times = (part.set_up, part.first_frame, part.frame) if part else (None, None, None)
    set_up, first, frame = (1e3 * time if time is not None else None for time in times)
    return [
        Goal(f"{words}: set-up", set_up, 1500.0),
        Goal("the same, first frame", first, 40.0),
        Goal("the same, frame of a drag", frame, 10.0),
    ]


def goal_table(
    found: Found,
    peaks: dict[int, dict[str, float]],
    paper: list[Times],
    real: RealPart | None = None,
) -> str:
    """The goals as Markdown; paper: the paper's assemblies, that of 14 parts last."""
    goals = frame_goals(found) + set_up_goals(found, peaks) + repair_goals(found)
    goals += paper_goals(paper[-1]) + real_goals(real)
    return markdown(["goal (two cores)", "bound", "", "measured"], [g.row() for g in goals])


def write_page(page: Path, text: str) -> None:
    """Replaces what an earlier run measured; the words around it stay."""
    before, _, rest = page.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    page.write_text(f"{before}{BEGIN}\n\n{text.strip()}\n\n{END}{after}", encoding="utf-8")
