# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study as an array job of Slurm, and a following job that repeats lost runs."""

from __future__ import annotations

import shutil
import subprocess

from ...base.errors import Fault, RecipeError
from .scripts import Call, write_script

ARRAY, END = "study.sbatch", "summary.sbatch"


def submit(call: Call, jobs: int) -> list[str]:
    """Write the scripts, submit them and return the lines to print. Raises RecipeError."""
    blocks = call.blocks(jobs)
    folder = call.out.resolve()
    write_script(call.out / ARRAY, _array(call, blocks))
    write_script(call.out / END, _head("summary", folder) + call.command() + "\n")
    if shutil.which("sbatch") is None:
        todo = f"submit it where Slurm is: sbatch {folder / ARRAY}, then sbatch {folder / END}"
        raise RecipeError([Fault("--engine slurm", "there is no sbatch on this machine", todo)])
    array = _sbatch(str(folder / ARRAY))
    end = _sbatch(f"--dependency=afterany:{array}", str(folder / END))
    return [
        f"{call.out}: {call.runs} run(s) in {len(blocks)} job(s) of the array {array}; job {end} "
        "writes summary.csv when they have ended"
    ]


def _array(call: Call, blocks: list[tuple[int, int]]) -> str:
    firsts = " ".join(str(first) for first, _ in blocks)
    lasts = " ".join(str(last) for _, last in blocks)
    return (
        _head("study", call.out.resolve(), f"#SBATCH --array=0-{len(blocks) - 1}\n")
        + f"first=({firsts})\nlast=({lasts})\n"
        + call.command("--runs", '"${first[SLURM_ARRAY_TASK_ID]}-${last[SLURM_ARRAY_TASK_ID]}"')
        + "\n"
    )


def _head(name: str, folder: object, more: str = "") -> str:
    return (
        f"#!/bin/bash\n#SBATCH --job-name=sheetmorph-{name}\n"
        f"#SBATCH --output={folder}/.slurm-%j.log\n#SBATCH --requeue\n{more}"
        'export SHEETMORPH_THREADS="${SLURM_CPUS_PER_TASK:-1}"\n'
    )


def _sbatch(*words: str) -> str:
    """Submit a job and return its number."""
    done = subprocess.run(
        ["sbatch", "--parsable", *words], capture_output=True, text=True, check=False
    )
    if done.returncode:
        what = f"sbatch refuses the job ({' '.join(done.stderr.split())})"
        raise RecipeError([Fault("--engine slurm", what, "correct it and start the study again")])
    return done.stdout.strip().split(";")[0]
