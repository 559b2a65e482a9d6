# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the kernel's benchmarks and prints them as a table; the JSON stays in build/bench.

Called by `./sheetmorph bench`; further arguments go to Google Benchmark.
"""
import argparse
import json
import os
import subprocess
import sys
from pathlib import Path

COLUMNS = ("vertices", "set-up", "live frame", "exact frame", "factor", "peak memory")
PEERS = ("CGAL Surface_mesh_deformation", "libigl biharmonic")


def read_rows(report: dict) -> dict[int, dict[str, float]]:
    """Asked number of vertices -> what was measured at it (times in ms)."""
    rows: dict[int, dict[str, float]] = {}
    for run in report["benchmarks"]:
        if run.get("run_type") == "aggregate" or run.get("error_occurred"):
            continue
        name, size = run["name"].split("/")[:2]
        row = rows.setdefault(int(size), {})
        row[name] = run["real_time"]
        for key in ("vertices", "factor_entries", "peak_memory_mib"):
            if key in run:
                row[key] = run[key]
    return rows


def cell(row: dict[str, float], key: str, unit: str, scale: float = 1.0) -> str:
    """One number with three digits, or a dash where nothing was measured."""
    return f"{row[key] * scale:.3g} {unit}" if key in row else "-"


def table(rows: dict[int, dict[str, float]]) -> str:
    """The measured rows as an aligned table."""
    lines = [COLUMNS]
    for _, row in sorted(rows.items()):
        lines.append(
            (
                f"{row['vertices']:,.0f}",
                cell(row, "set_up", "ms"),
                cell(row, "live_frame", "ms"),
                cell(row, "exact_frame", "ms"),
                cell(row, "factor_entries", "M entries", 1e-6),
                cell(row, "peak_memory_mib", "MiB"),
            )
        )
    widths = [max(len(line[k]) for line in lines) for k in range(len(COLUMNS))]
    text = ["  ".join(word.rjust(w) for word, w in zip(line, widths)) for line in lines]
    return "\n".join(text + [f"{peer}: not measured yet" for peer in PEERS])


def main(arguments: list[str]) -> int:
    """Runs the program of the build; its exit code."""
    parser = argparse.ArgumentParser(prog="./sheetmorph bench", description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    options, passed_on = parser.parse_known_args(arguments)
    output = options.build / "bench" / "surface.json"
    output.parent.mkdir(parents=True, exist_ok=True)
    program = options.build / "tests" / "sheetmorph_benchmarks"
    command = [str(program), f"--benchmark_out={output}", "--benchmark_out_format=json"]
    code = subprocess.run([*command, *passed_on], check=False).returncode
    if code != 0:
        return code
    report = json.loads(output.read_text())
    print(f"\nCurved panels, 20 round holes as form features, one handle, {os.cpu_count()} cores")
    print(table(read_rows(report)))
    print(f"written: {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
