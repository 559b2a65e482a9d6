# SPDX-License-Identifier: LGPL-2.1-or-later
"""Welds inside decks: how far they are from both sheets that they join, before and after."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from sheetmorph import CertificateError, run
from sheetmorph.cli import main
from sheetmorph.decks import read_deck, sheet_of
from sheetmorph.decks.welds import weld_gaps
from sheetmorph.reporting.report import report_schema

ALONG, ACROSS, APART = 12, 4, 3.0


def plate(first: int, pid: int, z: float) -> list[str]:
    lines = [
        f"GRID,{first + ACROSS * i + j},,{10.0 * i},{10.0 * j},{z}"
        for i in range(ALONG)
        for j in range(ACROSS)
    ]
    for i in range(ALONG - 1):
        for j in range(ACROSS - 1):
            k = first + ACROSS * i + j
            lines.append(f"CQUAD4,{k},{pid},{k},{k + ACROSS},{k + ACROSS + 1},{k + 1}")
    return lines


def deck(folder: Path) -> Path:
    """Two plates with a weld of every kind, one millimetre above the lower one."""
    lines = ["BEGIN BULK", "PSHELL,7,1,1.5", "PSHELL,8,1,1.5", "MAT1,1,210000.,,.3,7.85-9"]
    lines += [*plate(1, 7, 0.0), *plate(101, 8, APART), "GRID,900,,75.,15.,1."]
    lines += ["CWELD,501,9,900,PARTPAT,,,,,+", "+,7,8"]
    lines += ["CFAST,502,9,PROP,7,8,,,,+", "+,85.,15.,1."]
    lines += [f"CWELD,503,9,,ALIGN,{1 + ACROSS * 9 + 1},{101 + ACROSS * 9 + 1}"]
    place = folder / "welded.bdf"
    place.write_text("\n".join([*lines, "ENDDATA", ""]))
    return place


def recipe(folder: Path, is_joined: bool) -> Path:
    deck(folder)
    row = [ACROSS * i + 1 for i in range(ALONG)]
    contact = {
        "type": "tied",
        "a": {"part": "welded/7", "vertices": [1 + k for k in row]},
        "b": {"part": "welded/8", "vertices": [101 + k for k in row]},
    }
    entry = {
        "sheetmorph": 1,
        "primary": "welded/7",
        "parts": [{"file": "welded.bdf", "split": "property"}],
        "fixed": [{"part": "welded/7", "vertices": list(range(1, 2 * ACROSS + 1))}],
        "handles": [
            {
                "name": "end",
                "part": "welded/7",
                "vertices": list(range(1 + ACROSS * (ALONG - 1), 1 + ACROSS * ALONG)),
            }
        ],
        "contacts": [contact] if is_joined else [],
        "pose": {"end": {"translation": [0, 0, 20]}},
    }
    place = folder / "recipe.json"
    place.write_text(json.dumps(entry))
    return place


def test_every_weld_tells_its_gaps_to_both_sheets_in_the_certificate(tmp_path: Path):
    place = recipe(tmp_path, True)
    report = run(place, tmp_path / "out")
    jsonschema.validate(report, report_schema())
    files = ["--json", str(tmp_path / "c.json"), "--page", str(tmp_path / "c.html")]
    asked = ["certify", str(place), str(tmp_path / "out"), "--criteria", "static", *files]
    assert main(asked) == 0
    (told,) = json.loads((tmp_path / "c.json").read_text())["decks"]
    welds = {weld["id"]: weld for weld in told["joints"]["welds"]}
    assert {number: weld["before"] for number, weld in welds.items()} == {
        501: pytest.approx([1.0, 2.0]),
        502: pytest.approx([1.0, 2.0]),
        503: pytest.approx([APART]),
    }
    for weld in welds.values():
        assert weld["after"] == pytest.approx(weld["before"], abs=0.1)
    assert welds[502]["card"] == "CFAST" and welds[502]["line"] > 100
    assert "CFAST 502" in (tmp_path / "c.html").read_text()


def test_a_weld_that_one_sheet_leaves_has_come_apart(tmp_path: Path):
    with pytest.raises(CertificateError, match="CFAST 502 came apart by"):
        run(recipe(tmp_path, False), tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_weld_near_one_sheet_only_tells_one_gap(tmp_path: Path):
    text = deck(tmp_path).read_text().replace("85.,15.,1.", "85.,15.,-29.")
    found = read_deck(Path("one.bdf"), lambda _: text.encode())
    gaps = {g.place.number: g for g in weld_gaps(found, sheet_of(found), found.points)}
    assert gaps[502].before == pytest.approx((29.0,)) and gaps[502].change == 0.0


def test_a_weld_between_nodes_of_the_sheets_tells_their_distance(tmp_path: Path):
    found = read_deck(deck(tmp_path))
    moved = found.points.copy()
    moved[found.find(np.array([1 + ACROSS * 9 + 1]))[0], 2] -= 0.5
    gaps = {g.place.number: g for g in weld_gaps(found, sheet_of(found), moved)}
    assert gaps[503].after == pytest.approx((APART + 0.5,))
