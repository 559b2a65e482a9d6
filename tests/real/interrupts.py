# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long every command takes to end after Ctrl-C, at many moments, on large inputs.

    PYTHONPATH=build/Mod/SheetMorph python3 tests/real/interrupts.py [MOMENTS [COMMAND ...]]

Prints a table, one row a command: the longest answer on the clock and in seconds of processor, and
the moment of it. On a busy machine the processor says more. Ends with 1 where an answer takes more
than a second on both, or where a command ends otherwise than by one sentence.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import recipes

LONGEST = 1.0  # seconds
SIDE = 382  # vertices along each side of the sheet: 145,924
STEP = "03-laser4diy-enclosure/Enclosure_v3_v9.step"
TICKS = os.sysconf("SC_CLK_TCK")


@dataclass(frozen=True)
class Answer:
    """How a command ended after the signal: seconds, and what is wrong with it, if anything."""

    moment: float
    clock: float
    processor: float
    fault: str


def sheet(path: Path, side: int) -> None:
    """A wavy sheet of squares, cut into triangles, 2 mm apart."""
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    points = np.stack([2.0 * x, 2.0 * y, 6.0 * np.sin(x / 15.0) * np.cos(y / 20.0)], axis=1)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    below = np.stack([corner, corner + side, corner + side + 1], axis=1)
    above = np.stack([corner, corner + side + 1, corner + 1], axis=1)
    lines = [f"v {a:.6g} {b:.6g} {c:.6g}" for a, b, c in points]
    lines += [f"f {a} {b} {c}" for a, b, c in np.concatenate([below, above]) + 1]
    path.write_text("\n".join(lines) + "\n", "ascii")


def recipe(energy: str, **part: object) -> dict:
    """One end stays, the other one is lifted; two patches keep their shape."""
    end = 2.0 * (SIDE - 1)
    boxes = {
        "root": ([-1, -1, -99], [1, 9999, 99]),
        "tip": ([end - 1, -1, -99], [end + 1, 9999, 99]),
        "one": ([200, 200, -99], [240, 240, 99]),
        "two": ([400, 500, -99], [430, 540, 99]),
    }
    at = {name: {"where": {"box": box}} for name, box in boxes.items()}
    return {
        "sheetmorph": 1,
        "energy": energy,
        "parts": [{"name": "sheet", "file": "sheet.obj", **part}],
        "fixed": [{"name": "root", "part": "sheet", **at["root"]}],
        "handles": [{"name": "tip", "part": "sheet", **at["tip"]}],
        "features": [{"name": name, "part": "sheet", **at[name]} for name in ("one", "two")],
        "pose": {"tip": {"translation": [0, 0, 120]}},
    }


def write_inputs(folder: Path) -> None:
    """The sheets, recipes and the study that commands() names."""
    sheet(folder / "sheet.obj", SIDE)
    sheet(folder / "small.obj", 120)
    for energy in ("steel", "natural", "paper"):
        (folder / f"{energy}.json").write_text(json.dumps(recipe(energy)), "utf-8")
    remeshed = recipe("paper", remesh={"edge": 3.0})
    (folder / "remeshed.json").write_text(json.dumps(remeshed), "utf-8")
    study = {
        "sheetmorph_study": 1,
        "recipe": "paper.json",
        "parameters": {"lift": {"path": "pose.tip.translation[2]", "range": [0, 120]}},
        "sampling": {"method": "latin hypercube", "count": 40, "seed": 1},
        "measure": {"tip": {"position": "tip"}},
    }
    (folder / "study.json").write_text(json.dumps(study), "utf-8")


def commands(folder: Path, wanted: list[str]) -> dict[str, list[str]]:
    """The inputs of every command in a folder, and its words; of the wanted ones alone, if any."""
    write_inputs(folder)
    out = ["-o", "out", "--force"]
    found = {
        "run steel": ["run", "steel.json", *out],
        "run natural": ["run", "natural.json", *out],
        "run remeshed": ["run", "remeshed.json", *out],
        "check paper": ["check", "paper.json"],
        "resolve": ["resolve", "paper.json"],
        "doctor": ["doctor", "sheet.obj"],
        "find": ["find", "sheet.obj"],
        "flatten": ["flatten", "small.obj", *out],
        "copy": ["copy", "sheet.obj", *out],
        "init": ["init", "sheet.obj", "-o", "first.json", "--force"],
        "show": ["show", "paper.json", *out],
        "study": ["study", "study.json", "-o", "variants"],
    }
    data = recipes.data_folder()
    if (data / STEP).is_file():
        step = str(data / STEP)
        found |= {
            "doctor of STEP": ["doctor", step],
            "find of STEP": ["find", step],
            "run of STEP": ["run", "enclosure.json", *out],
            "copy of STEP": ["copy", step, *out],
        }
    if "run of STEP" in found and (not wanted or "run of STEP" in wanted):
        (folder / "enclosure.json").write_text(json.dumps(recipes.make("enclosure")), "utf-8")
    return {name: words for name, words in found.items() if not wanted or name in wanted}


def processor(process: int) -> float:
    """Seconds of processor that a process has used."""
    with open(f"/proc/{process}/stat", encoding="ascii", errors="replace") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def answered(words: list[str], folder: Path, moment: float) -> Answer | None:
    """Interrupt a command at a moment, seconds; None if it has ended before."""
    with open(folder / "stderr.txt", "w+b") as said:
        started = time.monotonic()
        running = subprocess.Popen(
            [sys.executable, "-m", "sheetmorph", *words], cwd=folder, stdout=subprocess.DEVNULL,
            stderr=said, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler)
        )  # fmt: skip
        time.sleep(moment)
        if running.poll() is not None:
            return None
        moment, before = time.monotonic() - started, processor(running.pid)
        running.send_signal(signal.SIGINT)
        sent = time.monotonic()
        _, status, usage = os.wait4(running.pid, 0)
        clock = time.monotonic() - sent
        running.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read().decode("utf-8", "replace")
    is_right = running.returncode in (0, 130) and "Traceback" not in text
    fault = "" if is_right else f"ended with {running.returncode}: {text[-300:]}"
    return Answer(moment, clock, usage.ru_utime + usage.ru_stime - before, fault)


def answers(words: list[str], folder: Path, moments: int) -> list[Answer]:
    """Whole command first, whose time the moments divide."""
    started = time.monotonic()
    subprocess.run(
        [sys.executable, "-m", "sheetmorph", *words], cwd=folder, stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL, check=False
    )  # fmt: skip
    whole = time.monotonic() - started
    tried = (answered(words, folder, whole * (k + 0.5) / moments) for k in range(moments))
    return [one for one in tried if one is not None]


def main() -> int:
    moments = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    is_right = True
    print("| command | answers | longest, clock | longest, processor | at |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for command, words in commands(folder, sys.argv[2:]).items():
            found = answers(words, folder, moments)
            if not found:
                print(f"| {command} | 0 | | | |", flush=True)
                continue
            longest = max(found, key=lambda one: one.clock)
            worst = max(one.processor for one in found)
            at = f"{longest.moment:.1f} s"
            row = f"{len(found)} | {longest.clock:.2f} s | {worst:.2f} s | {at}"
            print(f"| {command} | {row} |", flush=True)
            for one in found:
                if one.fault or min(one.clock, one.processor) > LONGEST:
                    what = one.fault or f"{one.clock:.2f} s, {one.processor:.2f} s of processor"
                    print(f"    at {one.moment:.2f} s: {what}", flush=True)
                    is_right = False
    return 0 if is_right else 1


if __name__ == "__main__":
    sys.exit(main())
