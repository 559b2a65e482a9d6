# SPDX-License-Identifier: LGPL-2.1-or-later
"""A study that is killed with -9 at ten random moments ends as one that nothing disturbed."""

from __future__ import annotations

import random
import subprocess
import sys
import time
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "package"))

from study_samples import contents, rows_of, write_study  # noqa: E402

COUNT = 150
KILLS = 10


@pytest.mark.parametrize("engine", ["local", "processes"])
def test_ten_kills_at_random_moments_change_no_byte(tmp_path: Path, engine: str):
    path = write_study(tmp_path, sampling={"method": "halton", "count": COUNT, "seed": 4})
    line = [sys.executable, "-m", "sheetmorph", "study", str(path), "--quiet"]
    line += ["--engine", engine, "--workers", "2"]
    subprocess.run([*line, "-o", str(tmp_path / "whole")], check=True)
    out = tmp_path / "out"
    chance = random.Random(20)
    killed = 0
    for done in sorted(chance.sample(range(COUNT - 30), KILLS)):
        with subprocess.Popen([*line, "-o", str(out)]) as running:
            while len(list(out.glob("0*"))) < done and running.poll() is None:
                time.sleep(0.002)
            # Somewhere within the next variant: while it is solved, written, read or renamed.
            time.sleep(chance.uniform(0.0, 0.05))
            killed += running.poll() is None
            running.kill()
    assert killed == KILLS
    assert subprocess.run([*line, "-o", str(out)], check=False).returncode == 0
    assert contents(out) == contents(tmp_path / "whole")
    assert [row["run"] for row in rows_of(out)] == [str(run) for run in range(COUNT)]
