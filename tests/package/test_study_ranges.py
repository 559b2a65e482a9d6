# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far parameters may go, against a scan that tries every place."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from sheetmorph.cli import main
from sheetmorph.study.plan import Plan
from sheetmorph.study.ranges import limit_of
from sheetmorph.study.working import Workshop
from study_samples import write_study

PARAMETERS = {
    "along": {"path": "pose.tip.translation[0]", "range": [-20, 20]},
    "lift": {"path": "pose.tip.translation[2]", "range": [-60, 90]},
    "turn": {"path": "pose.tip.rotation.degrees", "range": [-170, 60]},
}
CRITERIA = {"stretch": {"max": 0.45}, "angle": {"min": 12}}


def found_range(folder: Path, **keys) -> dict:
    path = write_study(folder, **keys)
    assert main(["study", str(path), "-o", str(folder / "out"), "--range", "--quiet"]) == 0
    return json.loads((folder / "out" / "range.json").read_text())


def test_the_range_of_three_parameters_is_that_of_a_scan(tmp_path: Path):
    found = found_range(tmp_path, parameters=PARAMETERS, criteria=CRITERIA)
    shop = Workshop(Plan(tmp_path / "study.json"))
    start = found["start"]
    assert start == {"along": 0.0, "lift": 12.0, "turn": -25.0}
    for name, entry in found["parameters"].items():
        low, high = entry["range"]
        for side, end in (("low", low), ("high", high)):
            places = np.linspace(start[name], end, 81)
            whys = [shop.verdict({**start, name: float(at)}, True) for at in places]
            bad = [k for k, why in enumerate(whys) if why]
            step = abs(end - start[name]) / 80
            limit = places[bad[0] - 1] if bad else end
            assert abs(entry[side] - limit) <= step, (name, side)
            assert bool(entry[f"{side}_why"]) == bool(bad)
    assert (
        sum(bool(e[f"{s}_why"]) for e in found["parameters"].values() for s in ("low", "high")) > 2
    )


def test_on_both_sides_of_a_limit_exact_answers_agree(tmp_path: Path):
    found = found_range(tmp_path, parameters=PARAMETERS, criteria=CRITERIA)
    shop = Workshop(Plan(tmp_path / "study.json"))
    assert len(found["directions"]) == 12
    for entry in found["directions"]:
        names = list(entry["towards"])
        at = np.array([entry["limit"][name] for name in names])
        start = np.array([found["start"][name] for name in names])
        end = np.array([entry["towards"][name] for name in names])
        assert shop.verdict({**found["start"], **entry["limit"]}, True) == ""
        if entry["why"]:
            beyond = at + 2e-4 * (end - start)
            there = {**found["start"], **dict(zip(names, beyond.tolist()))}
            assert shop.verdict(there, True)


def test_what_no_criterion_forbids_may_go_to_its_end(tmp_path: Path, capsys):
    parameters = {"lift": {"path": "pose.tip.translation[2]", "range": [10, 14]}}
    found = found_range(tmp_path, parameters=parameters)
    assert found["parameters"]["lift"]["low"] == 10 and found["parameters"]["lift"]["high"] == 14
    assert "lift: 10 to 14, all of its range" in capsys.readouterr().out


def test_a_constraint_is_a_limit(tmp_path: Path):
    parameters = {"lift": {"path": "pose.tip.translation[2]", "range": [0, 40]}}
    found = found_range(tmp_path, parameters=parameters, constraints=["lift <= 20"])
    assert found["parameters"]["lift"]["high"] == pytest.approx(20, abs=0.01)
    assert "lift <= 20" in found["parameters"]["lift"]["high_why"]


def test_a_start_that_breaks_a_criterion_is_told(tmp_path: Path, capsys):
    path = write_study(tmp_path, criteria={"displacement": {"max": 1}})
    assert main(["study", str(path), "-o", str(tmp_path / "out"), "--range"]) == 2
    assert "start from another pose" in capsys.readouterr().err


def test_live_answers_that_are_wrong_are_put_right_by_exact_ones():
    def lying(share: float, exact: bool) -> str:
        return "broken" if share > (0.3 if exact else 0.7) else ""

    def blind(share: float, exact: bool) -> str:
        return "broken" if exact and share > 0.9 else ""

    for verdict, limit in ((lying, 0.3), (blind, 0.9)):
        assert limit_of(verdict).share == pytest.approx(limit, abs=1e-4)
        assert limit_of(verdict).why == "broken"
