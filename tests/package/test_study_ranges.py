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
from study_samples import rows_of, write_study

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
    assert "lift: 10 to 14, its full range" in capsys.readouterr().out


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


def rows_after_a_range(folder: Path, **keys) -> list[dict]:
    """The table of a study that is computed after its range was found."""
    found_range(folder, parameters=PARAMETERS, criteria=CRITERIA)
    path = write_study(folder, **{"parameters": PARAMETERS, "criteria": CRITERIA, **keys})
    assert main(["study", str(path), "-o", str(folder / "out"), "--quiet"]) == 0
    return rows_of(folder / "out")


SAMPLING = {"method": "sobol", "count": 24, "seed": 3}


def test_what_lies_beyond_a_range_is_refused_and_costs_nothing(tmp_path: Path):
    rows = rows_after_a_range(tmp_path, sampling=SAMPLING)
    limits = json.loads((tmp_path / "out" / "range.json").read_text())["parameters"]
    refused = [row for row in rows if row["status"] == "refused"]
    assert 0 < len(refused) < 24
    for row in refused:
        assert "of range.json: " in row["why"]
        assert sorted(p.name for p in (tmp_path / "out" / f"{int(row['run']):06d}").iterdir()) == [
            "parameters.json"
        ]
    for row in rows:
        lift, entry = float(row["lift"]), limits["lift"]
        if not entry["low"] <= lift <= entry["high"]:
            assert row["status"] == "refused" and " is outside " in row["why"]
    costs = json.loads((tmp_path / "out" / "costs.json").read_text())
    assert costs["computed"] == 24 - len(refused)


def test_without_its_range_the_same_samples_are_computed(tmp_path: Path):
    before = rows_after_a_range(tmp_path, sampling=SAMPLING)
    (tmp_path / "out" / "range.json").unlink()
    assert (
        main(["study", str(tmp_path / "study.json"), "-o", str(tmp_path / "out"), "--quiet"]) == 0
    )
    after = rows_of(tmp_path / "out")
    assert {row["status"] for row in after} == {"passed", "failed"}
    costs = json.loads((tmp_path / "out" / "costs.json").read_text())
    assert costs["computed"] == sum(row["status"] == "refused" for row in before)
    kept = [row for row in before if row["status"] != "refused"]
    assert kept == [row for row in after if row["run"] in {k["run"] for k in kept}]


def test_the_range_of_another_study_refuses_nothing(tmp_path: Path):
    looser = {"stretch": {"max": 0.5}, "angle": {"min": 12}}
    rows = rows_after_a_range(tmp_path, sampling=SAMPLING, criteria=looser)
    assert all(row["status"] != "refused" for row in rows)


@pytest.mark.parametrize("text", ["", "[1]", "{", '{"hash": 3}'])
def test_a_range_that_cannot_be_read_refuses_nothing(tmp_path: Path, text: str):
    path = write_study(tmp_path)
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "range.json").write_text(text)
    assert main(["study", str(path), "-o", str(tmp_path / "out"), "--quiet"]) == 0
    assert {row["status"] for row in rows_of(tmp_path / "out")} == {"passed"}
