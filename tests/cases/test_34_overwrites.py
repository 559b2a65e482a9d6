# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands whose output is aimed at a file of the user, or at what they read themselves."""
from collections.abc import Callable
from pathlib import Path

import pytest
from conftest import sheetmorph

LINES = (
    "certify r.json out --json r.json",
    "certify r.json out --page r.json",
    "certify r.json out --json out/a.obj",
    "study study.json --evaluate in.json study.json",
    "study study.json --evaluate in.json r.json",
    "study study.json --evaluate in.json in.json",
    "find a.obj -o r.json",
    "find a.obj -o b.obj",
    "flatten a.obj -o r.json",
    "flatten a.obj -o b.obj",
    "run r.json -o out --report study.json",
    "resolve r.json -o study.json",
)


@pytest.mark.parametrize("line", LINES)
def test_it_is_refused_and_every_file_stays(line: str, case: Callable[[str], Path]) -> None:
    folder = case("34")
    assert sheetmorph("run", "r.json", "-o", "out", "--quiet", folder=folder).status == 0
    before = {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}
    done = sheetmorph(*line.split(), folder=folder)
    assert done.status == 2, done.said
    assert line.split()[-1] in done.err, done.err
    assert {file: file.read_bytes() for file in before} == before
