# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the kernel's benchmarks and those of its peers on the same meshes in one run.

Called by `./sheetmorph bench`. Tables are printed and kept with the JSON and a plot in
build/bench; arguments this program does not know go to Google Benchmark.
"""
import argparse
import datetime
import json
import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

import assemblies
import real_part
from goals import goal_table, write_page
from plots import draw
from tables import Measured, measured, memory_table, other_table, panel_table, remeshing_table

SIZES = (1000, 10000, 100000)
LARGE = 1000000
DOCS = Path(__file__).resolve().parents[2] / "resources" / "docs"


def machine() -> str:
    """Date, processor, cores and system in one line."""
    info = Path("/proc/cpuinfo").read_text(encoding="ascii", errors="replace")
    names = re.findall(r"model name\s*:\s*(.*)", info)
    name = names[0] if names else platform.machine()
    load = os.getloadavg()[0]
    day = datetime.date.today().isoformat()
    system = f"{platform.system()} {platform.release().partition('-')[0]}"
    return f"{day}, {name}, {os.cpu_count()} cores, {system}, load {load:.1f} at the start"


def run(program: Path, arguments: list[str], output: Path, is_large: bool) -> dict:
    """Google Benchmark's report; ends the program with its exit code if it fails."""
    environment = dict(os.environ)
    if is_large:
        environment["SHEETMORPH_BENCH_LARGE"] = "1"
    command = [str(program), f"--benchmark_out={output}", "--benchmark_out_format=json"]
    code = subprocess.run([*command, *arguments], check=False, env=environment).returncode
    if code != 0:
        sys.exit(code)
    return json.loads(output.read_text(encoding="utf-8"))


def peaks(program: Path, folder: Path, is_large: bool) -> dict[int, dict[str, float]]:
    """Peak memory of one set-up, every size in a process of its own."""
    found = {}
    for size in SIZES + ((LARGE,) if is_large else ()):
        arguments = [f"--benchmark_filter=^set_up/{size}/", "--benchmark_min_time=0.001"]
        report = run(program, arguments, folder / f"memory-{size}.json", is_large)
        found[size] = measured(report, "real_time")["set_up"][size].counters
    return found


def whole_run(
    found: dict[str, dict[int, Measured]], program: Path, folder: Path, is_large: bool
) -> list[str]:
    """What only a run of everything measures: goals, memory, the paper's assemblies."""
    peak = peaks(program, folder, is_large)
    sys.path.insert(0, str(folder.parent / "Mod" / "SheetMorph"))
    paper = [assemblies.timed(name) for name in assemblies.NAMES]
    real = real_part.timed()
    return [
        goal_table(found, peak, paper, real),
        memory_table(peak),
        assemblies.time_table(paper),
        real_part.table(real),
    ]


def main(arguments: list[str]) -> int:
    """Runs the program of the build; its exit code."""
    parser = argparse.ArgumentParser(prog="./sheetmorph bench", description=__doc__)
    parser.add_argument("--build", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--large", action="store_true", help="panels of 1,000,000 vertices too")
    parser.add_argument(
        "--processor-time",
        action="store_true",
        help="tables of processor time, which other work on the machine changes less",
    )
    parser.add_argument(
        "--write-page",
        action="store_true",
        help="put tables and plot into resources/docs/benchmarks.md",
    )
    options, passed_on = parser.parse_known_args(arguments)
    folder = options.build / "bench"
    folder.mkdir(parents=True, exist_ok=True)
    program = options.build / "tests" / "sheetmorph_benchmarks"
    head = machine()
    report = run(program, passed_on, folder / "benchmarks.json", options.large)
    found = measured(report, "cpu_time" if options.processor_time else "real_time")
    is_whole = not any(word.startswith("--benchmark_filter") for word in passed_on)
    more = whole_run(found, program, folder, options.large) if is_whole else []
    parts = [part for part in (head, panel_table(found), *more, remeshing_table(found)) if part]
    text = "\n\n".join([*parts, other_table(found)]) + "\n"
    (folder / "tables.md").write_text(text, encoding="utf-8")
    draw(found, folder / "benchmarks.png")
    if options.write_page:
        write_page(DOCS / "benchmarks.md", "\n\n".join(parts))
        shutil.copy(folder / "benchmarks.png", DOCS / "pictures" / "benchmarks.png")
    print(f"\n{text}\nwritten: {folder}/benchmarks.json, tables.md, benchmarks.png")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
