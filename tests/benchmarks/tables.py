# SPDX-License-Identifier: LGPL-2.1-or-later
"""Turns Google Benchmark's JSON into the tables that a person reads."""

from __future__ import annotations

import statistics
from dataclasses import dataclass, field

# What stands in a row of the table of panels: benchmark -> words.
PANEL_ROWS = {
    "set_up": "set-up",
    "one_more_feature": "one more feature, after a set-up",
    "one_more_fixed_region": "one more fixed strip, after a set-up",
    "cgal_sre_arap_set_up": "CGAL SRE_ARAP preprocess()",
    "cgal_arap_set_up": "CGAL ORIGINAL_ARAP preprocess()",
    "cholmod_factorisation": "CHOLMOD, one factor of the same matrix",
    "response_set_up": "response fields, in the background of a drag",
    "live_frame": "live frame, one handle turning and moving",
    "live_frame_50_free_features": "the same with 50 free features",
    "three_handles_frame": "frame of three handles turning at once",
    "cgal_sre_arap_iteration": "CGAL SRE_ARAP, one iteration",
    "cgal_arap_iteration": "CGAL ORIGINAL_ARAP, one iteration",
    "substituted_frame": "frame by substitution, any pose",
    "cholmod_substitution": "CHOLMOD back-substitution",
    "exact_frame": "exact frame, refined",
    "reading_once": "reading a live frame's data once, one core",
}
REMESHING_ROWS = {
    "sheet_remeshing": "SheetMorph",
    "cgal_sheet_remeshing": "CGAL isotropic_remeshing(), 10 iterations",
}
RATIOS = (
    ("CGAL SRE_ARAP preprocess() / set-up", "cgal_sre_arap_set_up", "set_up"),
    ("CHOLMOD's one factor / set-up", "cholmod_factorisation", "set_up"),
    ("CGAL SRE_ARAP iteration / live frame", "cgal_sre_arap_iteration", "live_frame"),
    ("CGAL ORIGINAL_ARAP iteration / live frame", "cgal_arap_iteration", "live_frame"),
    ("CHOLMOD back-substitution / live frame", "cholmod_substitution", "live_frame"),
    ("live frame / reading its data once", "live_frame", "reading_once"),
)


@dataclass
class Measured:
    """Every run of one benchmark at one size."""

    milliseconds: list[float] = field(default_factory=list)
    counters: dict[str, float] = field(default_factory=dict)

    @property
    def median(self) -> float:
        """Median over the repetitions, ms."""
        return statistics.median(self.milliseconds)


def measured(report: dict, clock: str) -> dict[str, dict[int, Measured]]:
    """benchmark -> size -> what was measured; clock is "real_time" or "cpu_time"."""
    known = {"name", "family_index", "repetitions", "repetition_index", "threads", "iterations"}
    to_ms = {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}
    found: dict[str, dict[int, Measured]] = {}
    for run in report["benchmarks"]:
        if run.get("run_type") == "aggregate" or run.get("error_occurred"):
            continue
        words = run["name"].split("/")
        size = int(words[1]) if len(words) > 1 and words[1].isdigit() else 0
        entry = found.setdefault(words[0], {}).setdefault(size, Measured())
        entry.milliseconds.append(run[clock] * to_ms[run["time_unit"]])
        entry.counters.update(
            {k: v for k, v in run.items() if isinstance(v, (int, float)) and k not in known}
        )
    return found


def time_text(milliseconds: float) -> str:
    """Three digits with a unit."""
    if milliseconds >= 1000.0:
        return f"{milliseconds / 1000.0:.3g} s"
    return f"{milliseconds:.3g} ms"


def markdown(head: list[str], rows: list[list[str]]) -> str:
    """A table that is aligned as text and is Markdown too."""
    lines = [head, ["---"] * len(head), *rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(head))]
    return "\n".join(
        "| " + " | ".join(word.ljust(w) for word, w in zip(line, widths)) + " |" for line in lines
    )


def panel_table(found: dict[str, dict[int, Measured]]) -> str:
    """Times and ratios of the curved panels, one column a size."""
    sizes = sorted({size for name in PANEL_ROWS for size in found.get(name, {})})
    head = ["vertices"]
    for size in sizes:
        runs = [found[name][size] for name in PANEL_ROWS if size in found.get(name, {})]
        head.append(f"{runs[0].counters.get('vertices', size):,.0f}")
    rows = []
    for name, words in PANEL_ROWS.items():
        cells = [found.get(name, {}).get(size) for size in sizes]
        if any(cells):
            rows.append([words] + [time_text(cell.median) if cell else "-" for cell in cells])
    for words, above, below in RATIOS:
        cells = [ratio(found, above, below, size) for size in sizes]
        if any(cells):
            rows.append([words] + [f"{cell:.3g}" if cell else "-" for cell in cells])
    return markdown(head, rows)


def remeshing_table(found: dict[str, dict[int, Measured]]) -> str:
    """The same sheet remeshed by both, what was made of it in columns."""
    rows = []
    for name, words in REMESHING_ROWS.items():
        entry = found.get(name, {}).get(0)
        if entry is None:
            continue
        angles = ("worst_degrees", "hundredth_degrees", "median_degrees")
        rows.append(
            [words, time_text(entry.median), f"{entry.counters['triangles_made']:,.0f}"]
            + [f"{entry.counters[angle]:.2g}" for angle in angles]
            + [f"{entry.counters['deviation_um']:.1f} um"]
        )
    head = ["remeshing a sheet of slivers", "time", "triangles", "smallest angle, degrees"]
    head += ["of all but a hundredth", "of half of them", "farthest from the sheet"]
    return markdown(head, rows) if rows else ""


def ratio(found: dict[str, dict[int, Measured]], above: str, below: str, size: int) -> float:
    """One median over another, 0 where either is missing."""
    if size not in found.get(above, {}) or size not in found.get(below, {}):
        return 0.0
    return found[above][size].median / found[below][size].median


def other_table(found: dict[str, dict[int, Measured]]) -> str:
    """Everything that is no row of another table."""
    rows = []
    for name in sorted(set(found) - set(PANEL_ROWS) - set(REMESHING_ROWS)):
        for size, entry in sorted(found[name].items()):
            notes = [
                f"{key.replace('_', ' ')} {value:,.4g}"
                for key, value in entry.counters.items()
                if key not in ("real_time", "cpu_time", "per_family_instance_index")
            ]
            words = name.replace("_", " ") + (f", {size:,}" if size else "")
            rows.append([words, time_text(entry.median), "; ".join(notes)])
    return markdown(["measured", "median", "notes"], rows) if rows else ""


def memory_table(peaks: dict[int, dict[str, float]]) -> str:
    """Peak memory of a set-up, each size in a process of its own."""
    rows = []
    for _, counters in sorted(peaks.items()):
        vertices, mib = counters["vertices"], counters["peak_memory_mib"]
        rows.append(
            [
                f"{vertices:,.0f}",
                f"{counters['factor_entries'] / vertices:.0f}",
                f"{mib:,.0f} MiB",
                f"{1024.0 * mib / vertices:.2f} KiB",
            ]
        )
    head = ["vertices", "factor entries a vertex", "peak memory", "a vertex"]
    return markdown(head, rows) if rows else ""
