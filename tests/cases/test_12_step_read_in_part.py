# SPDX-License-Identifier: LGPL-2.1-or-later
"""A STEP file whose exponents are small letters."""
import json
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph


def test_exponents_in_small_letters_are_read(case: Callable[[str], Path]) -> None:
    folder = case("12")
    text = (folder / "small_e2.step").read_bytes()
    found = []
    for name, data in (("small.step", text), ("large.step", text.replace(b"e-", b"E-"))):
        (folder / name).write_bytes(data)
        (one,) = json.loads(sheetmorph("doctor", name, folder=folder).out)["files"]
        found.append({key: one[key] for key in ("vertices", "kind", "thickness", "components")})
    assert found[0] == found[1]
    assert found[0]["kind"] == "thin solid" and found[0]["thickness"] == pytest.approx(2.0)


def test_other_syntax_errors_are_refused_with_their_count(case: Callable[[str], Path]) -> None:
    folder = case("12")
    text = (folder / "small_e2.step").read_bytes()
    (folder / "bad.step").write_bytes(text.replace(b"e-", b"x-"))
    done = sheetmorph("doctor", "bad.step", folder=folder)
    assert done.status == 2 and "17 syntax errors" in done.err
