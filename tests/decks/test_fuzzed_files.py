# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every reader on mutated files: no crash, no hang, no memory without bound.

SHEETMORPH_FUZZ_SECONDS says how many seconds of the processor each reader is tried, 600 if it is
not set.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from fuzzing import READERS

SECONDS = float(os.environ.get("SHEETMORPH_FUZZ_SECONDS", "600"))


@pytest.mark.parametrize("reader", sorted(READERS))
def test_a_reader_survives_mutated_files(reader: str, tmp_path: Path):
    script = Path(__file__).with_name("fuzzing.py")
    command = [sys.executable, str(script), reader, str(SECONDS), str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True)
    print("NOTE", done.stdout.strip())
    assert done.returncode == 0, done.stdout + done.stderr
