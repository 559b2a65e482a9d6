# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same sheet, held and moved the same way, turned as a whole about z."""
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path


def test_a_turned_sheet_has_the_same_answer(case: Callable[[str], Path]) -> None:
    done = subprocess.run(
        [sys.executable, "repro.py"], cwd=case("29"), capture_output=True, text=True, timeout=600
    )
    assert done.returncode == 0, done.stderr
    differences = [float(found) for found in re.findall(r"deg: (\S+)", done.stdout)]
    assert len(differences) > 50
    assert max(differences) < 1e-9, done.stdout  # of the length
    ratios = {float(found) for found in re.findall(r"energy x (\S+)\)", done.stdout)}
    assert ratios <= {1.0}, done.stdout
