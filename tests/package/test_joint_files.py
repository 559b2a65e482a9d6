# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of welds and bolts beside the parts: their points go with the sheets that they join."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from double_plates import ACROSS, ALONG, node, two_plates
from joint_samples import VIP, XMCF, joint_samples
from sheetmorph import CertificateError, FileError, RecipeError, run
from sheetmorph.certifying import NotCertified, Targets, certify, read_criteria
from sheetmorph.cli import main
from sheetmorph.decks import read_deck
from sheetmorph.joint_files import read_joint_file
from sheetmorph.reporting.report import report_schema

FILES = joint_samples()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "deck.bdf").write_text("\n".join([*two_plates(), "ENDDATA", ""]))
    for name, data in FILES.items():
        (tmp_path / name).write_bytes(data)
    return tmp_path


def recipe(folder: Path, *files: dict, is_tied: bool = True, **more: object) -> Path:
    """The lower plate bent up at its end; the upper one following, or at rest."""
    strip = [node(i, j) for i in range(5, 12) for j in range(ACROSS)]
    ends = [node(ALONG - 1, j) for j in range(ACROSS)]
    held = [node(i, j) for i in (0, 1) for j in range(ACROSS)]
    sides = [[v + 1000 * k for v in strip] for k in (0, 1)]
    a, b = ({"part": f"deck/{k + 1}", "vertices": side} for k, side in enumerate(sides))
    entry = {
        "sheetmorph": 1,
        "parts": [{"file": "deck.bdf", "split": "property"}],
        "primary": "deck/1",
        "fixed": [{"part": "deck/1", "vertices": held}],
        "handles": [{"name": "tip", "part": "deck/1", "vertices": ends}],
        "contacts": [{"type": "rigid", "a": a, "b": b}] if is_tied else [],
        "pose": {"tip": {"translation": [0, 0, 15]}},
        "joint_files": list(files),
        **more,
    }
    path = folder / "recipe.json"
    path.write_text(json.dumps(entry))
    return path


def test_what_files_of_joints_say(folder: Path):
    bolts = read_joint_file(folder / "bolts.xmcf")
    assert [joint.name for joint in bolts.joints] == ["bolt & nut", "glue"]
    assert [joint.kind for joint in bolts.joints] == ["threaded_connection", "adhesive_line"]
    assert bolts.joints[0].parts == [("1",), ("2",)]
    assert bolts.points.tolist() == [[85, 15.5, 1], [72, 12.5, 1], [88, 12.5, 1]]
    assert bolts.directions.tolist() == [[0, 0, 2]]
    (spot,) = read_joint_file(folder / "spots.mcf").joints
    assert (spot.name, spot.kind, spot.parts) == ("100001", "spotweld", [("1",), ("2",)])
    vip = read_joint_file(folder / "spots.vip")
    assert vip.points.tolist() == [[85, 15.5, 1], [75, 22.5, 1]]
    assert vip.joints[1].parts == [("deck/1",), ("deck/2",)] and "1 lines" in vip.notes[0]
    table = read_joint_file(folder / "spots.csv")
    assert np.allclose(table.points, [[85, 15.5, 1], [75, 22.5, 1]])
    assert [joint.name for joint in table.joints] == ["A1", "A2"]
    assert table.joints[1].parts == [("2",), ("1",)] and table.joints[1].line == 4


def test_files_of_joints_are_copied_byte_for_byte(folder: Path, capsys):
    assert main(["copy", *(str(folder / name) for name in FILES), "-o", str(folder / "out")]) == 0
    for name, data in FILES.items():
        assert (folder / "out" / name).read_bytes() == data
    assert "xMCF, 2 joints, 3 points, every byte as it was" in capsys.readouterr().out


def test_points_go_with_the_sheets_that_they_join(folder: Path):
    jsonschema = pytest.importorskip("jsonschema")
    path = recipe(folder, *({"file": name} for name in FILES))
    report = run(path, folder / "out", report=folder / "report.json")
    jsonschema.validate(report, report_schema())
    deck = read_deck(folder / "out" / "deck.bdf")
    rest = read_deck(folder / "deck.bdf").points
    # What is rigid with the strip of both plates moves as that does.
    strip = [node(i, j) for i in range(6, 11) for j in range(ACROSS)]
    rows = deck.find(np.array([*strip, *(v + 1000 for v in strip)]))
    middle, other = rest[rows].mean(axis=0), deck.points[rows].mean(axis=0)
    left, _, right = np.linalg.svd((deck.points[rows] - other).T @ (rest[rows] - middle))
    turn = left @ right
    for name, data in FILES.items():
        before, after = read_joint_file(folder / name), read_joint_file(folder / "out" / name)
        wanted = (before.points - middle) @ turn.T + other
        assert np.abs(after.points - wanted).max() < 1e-4, name
        assert after.points[0][2] - before.points[0][2] > 1.0
        assert np.abs(after.directions - before.directions @ turn.T).max(initial=0.0) < 1e-5
        assert len(data.splitlines()) == len(after.data.splitlines())
    (bolts,) = [told for told in report["joint_files"] if told["format"] == "xMCF"]
    assert bolts["broken"] == [] and bolts["left"] == [] and bolts["moved"] == 3
    assert all(entry["change"] <= entry["limit"] for entry in bolts["joints"])
    assert bolts["joints"][0]["gap_before"] == pytest.approx(2.0)
    assert bolts["joints"][0]["gap_after"] == pytest.approx(2.0, abs=1e-4)
    new = (folder / "out" / "bolts.xmcf").read_bytes()
    for piece in (XMCF[: XMCF.index(b"x='0'")], b'</loc>\t<loc v="1">', b"<appdata>caf\xe9<"):
        assert piece in new


def test_the_certificate_measures_the_joints_on_the_files(folder: Path):
    pose = {"tip": {"translation": [0, 0, 4]}}
    path = recipe(folder, {"file": "spots.vip"}, pose=pose)
    run(path, folder / "out")
    targets = Targets(folder / "c.json", folder / "c.html")
    proof = certify(path, folder / "out", read_criteria(None), targets)
    (told,) = proof["joint_files"]
    assert len(told["joints"]) == 2 and told["broken"] == []
    assert "spots.vip" in {entry["file"] for entry in proof["outputs"]}
    assert "VIP spots.vip: 2 joints" in (folder / "c.html").read_text()
    out = folder / "out" / "spots.vip"
    out.write_bytes(VIP)  # as if nobody had moved them
    with pytest.raises(NotCertified, match="spots.vip, line 2: WSPOT 1 came apart by"):
        certify(path, folder / "out", read_criteria(None))
    out.write_bytes(VIP.replace(b"WSPOT,1", b"WSPOT,3"))
    with pytest.raises(FileError, match="it has other joints than spots.vip"):
        certify(path, folder / "out", read_criteria(None))


def test_joints_of_sheets_that_part_are_an_error_with_their_line(folder: Path):
    with pytest.raises(CertificateError, match=r"spots.csv, line 3: A1 came apart by \d"):
        run(recipe(folder, {"file": "spots.csv"}, is_tied=False), folder / "out")
    assert not (folder / "out").exists()
    path = recipe(folder, {"file": "spots.csv", "broken": "tell"}, is_tied=False)
    report = run(path, folder / "out")
    assert report["joint_files"][0]["broken"] == ["A1", "A2"]
    assert any("A1 came apart" in note for note in report["notes"])
    assert run(recipe(folder, {"file": "spots.csv", "limit": 50}, is_tied=False), folder / "out")


def test_what_no_sheet_is_near_stays_and_is_told(folder: Path):
    table = "no,x,y,z,pid\n1,85,15.5,1,\n2,85,15.5,100,1\n3,75,15,0,77\n"
    (folder / "points.csv").write_text(table)
    report = run(recipe(folder, {"file": "points.csv"}), folder / "out")
    (told,) = report["joint_files"]
    assert told["left"] == ["2", "3"] and told["moved"] == 1
    text = " ".join(report["notes"])
    assert (
        'no part of this recipe is called "77"' in text
        and "2 joints have no sheet within reach" in text
    )
    written = (folder / "out" / "points.csv").read_text().splitlines()
    assert written[2:] == table.splitlines()[2:]
    report = run(recipe(folder, {"file": "points.csv", "reach": 120}), folder / "out")
    assert report["joint_files"][0]["left"] == ["3"]


FAULTS = {
    "a.xmcf": (b"<xmcf><loc>", "not XML"),
    "b.xmcf": (b"<html/>", "<html> is neither MCF nor xMCF"),
    "c.xmcf": (XMCF.replace(b"85.0 15.5 1.0", b"85.0 15.5"), "<loc> needs three numbers"),
    "d.xmcf": (XMCF.replace(b"15.5", b"nan"), '"nan" is not a number'),
    "e.xmcf": (XMCF.replace(b'"mm"', b'"ly"'), 'the unit of length "ly" is not known'),
    "f.xml": (b'<!DOCTYPE xmcf [<!ENTITY a "b">]><xmcf/>', "it declares entities"),
    "g.xml": (b"<xmcf>" + b"<a>" * 300, "200 deep"),
    "h.xml": (XMCF.replace(b' y="0.0"', b""), "<normal_direction> has no y"),
    "a.vip": (b"SPOT,1,2\n", "no line begins with WSPOT"),
    "b.vip": (b"WSPOT,1,2,3\n", "three coordinates"),
    "a.csv": (b"1,2,3\n", "does not name columns x, y and z"),
    "b.csv": (b"x,y,z\n1,2\n", "2 columns, the first line has 3"),
    "c.csv": (b"x,y,z\n1,2,1e999\n", '"1e999" is not a number'),
    "d.csv": (b"\n", "it is empty"),
    "e.csv": (b"x [mm],y [m],z [mm]\n", "columns in m, mm"),
    "a.txt": (b"", "it is not a joint file"),
}


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_what_is_wrong_is_said_in_words(tmp_path: Path, name: str):
    data, what = FAULTS[name]
    (tmp_path / name).write_bytes(data)
    with pytest.raises(FileError) as told:
        read_joint_file(tmp_path / name)
    assert what in str(told.value)


def test_recipes_with_faults_in_their_joint_files(folder: Path):
    with pytest.raises(RecipeError, match=r"joint_files\[0\].*there is no such|cannot be read"):
        run(recipe(folder, {"file": "none.csv"}), folder / "out")
    with pytest.raises(RecipeError, match="spots.vip.* is already used"):
        run(recipe(folder, {"file": "spots.vip"}, {"file": "spots.vip"}), folder / "out")
    with pytest.raises(RecipeError, match='unknown key "reech"; did you mean "reach"'):
        run(recipe(folder, {"file": "spots.vip", "reech": 1}), folder / "out")
