# SPDX-License-Identifier: LGPL-2.1-or-later
"""1,000,000 nodes in every format: read, morphed, written, certified, within time and memory.

SHEETMORPH_DECK_SIDE says how many nodes there are along an edge, 1000 if it is not set.
"""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from million import FORMATS, STEPS, measure

SIDE = int(os.environ.get("SHEETMORPH_DECK_SIDE", "1000"))
# Of a copy: peak memory over the file; what Python needs itself, in MB, where the file is small;
# the processor's seconds for a million nodes.
_OVER_FILE, _PYTHON, _SECONDS = 3.0, 60.0, 60.0


@pytest.mark.parametrize("form", FORMATS)
def test_a_million_nodes(form: str, tmp_path: Path):
    found = measure(form, tmp_path, SIDE)
    print("NOTE", json.dumps(found))
    assert found["same"] and all(found[step]["status"] == 0 for step in STEPS)
    copy, millions = found["copy"], SIDE * SIDE / 1e6
    room = _PYTHON * max(0.0, 1.0 - millions)
    assert copy["peak"] <= _OVER_FILE * found["file"] + room
    assert copy["processor"] <= max(_SECONDS * millions, 10.0)
