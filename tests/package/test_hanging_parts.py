# SPDX-License-Identifier: LGPL-2.1-or-later
"""What hangs on the sheet of a deck follows it, joints hold or are named, the rest is told."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from double_plates import ACROSS, ALONG, STEP, grid, node, two_plates
from sheetmorph import CertificateError, RecipeError, run
from sheetmorph.decks import read_deck
from sheetmorph.files import read_part
from sheetmorph.reporting.report import report_schema

SHARED = Path(__file__).parents[3] / "shared" / "data"


def hanging() -> list[str]:
    """A mass over three nodes, a spring of no length with a mass, a beam between the plates, a
    fastener, a solid nugget that nothing ties, a bracket far away."""
    spider = [node(10, 1), node(10, 2), node(11, 1)]
    cards = [grid(5001, 103.0, 13.0, 30.0), "CONM2,901,5001,,2.5"]
    cards.append("RBE2,902,5001,123456," + ",".join(map(str, spider)))
    cards += [grid(5002, 9 * STEP, 3 * STEP, 0.0), f"CELAS2,903,10.,5002,1,{node(9, 3)},1"]
    cards.append("CONM2,904,5002,,1.0")
    cards += [f"CBEAM,905,3,{node(8, 2)},{node(8, 2, 1)},0.,1.,0."]
    cards.append("CFAST,906,4,PROP,1,2,,,,75.,15.,1.")
    for k, (x, y) in enumerate([(52, 22), (55, 22), (55, 25), (52, 25)]):
        cards += [grid(5010 + k, x, y, 0.5), grid(5014 + k, x, y, 1.5)]
    cards.append("CHEXA,907,5,5010,5011,5012,5013,5014,5015\n,5016,5017")
    cards += [grid(5020, 0.0, 0.0, 400.0), grid(5021, 9.0, 0.0, 400.0), "CROD,908,6,5020,5021"]
    cards.append("CORD2R,7,,0.,0.,0.,0.,0.,1.,\n,1.,0.,0.")
    return cards


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "deck.bdf").write_text("\n".join([*two_plates(), *hanging(), "ENDDATA", ""]))
    return tmp_path


def recipe(folder: Path, **part: object) -> Path:
    """The lower plate bent up at its end, the upper one following."""
    ends = [node(ALONG - 1, j) for j in range(ACROSS)]
    strip = [node(i, j) for i in range(5, 12) for j in range(ACROSS)]
    path = folder / "recipe.json"
    path.write_text(
        json.dumps(
            {
                "sheetmorph": 1,
                "parts": [{"file": "deck.bdf", "split": "property", **part}],
                "primary": "deck/1",
                "fixed": [{"part": "deck/1", "vertices": [node(i, j) for i in (0, 1)
                                                          for j in range(ACROSS)]}],
                "handles": [{"name": "tip", "part": "deck/1", "vertices": ends}],
                "features": [{"part": "deck/1",
                              "vertices": [node(10, 1), node(10, 2), node(11, 1)]}],
                "contacts": [{"type": "tied", "a": {"part": "deck/1", "vertices": strip},
                              "b": {"part": "deck/2", "vertices": [v + 1000 for v in strip]}}],
                "pose": {"tip": {"translation": [0, 0, 15]}},
            }
        )
    )  # fmt: skip
    return path


def places(path: Path) -> dict[int, np.ndarray]:
    deck = read_deck(path)
    return dict(zip(deck.ids.tolist(), deck.points))


def test_what_hangs_on_the_sheet_goes_along(folder: Path):
    jsonschema = pytest.importorskip("jsonschema")
    report = run(recipe(folder), folder / "out")
    jsonschema.validate(report, report_schema())
    before, after = places(folder / "deck.bdf"), places(folder / "out" / "deck.bdf")
    # The master of the spider keeps its distances from the feature it hangs on.
    for slave in (node(10, 1), node(10, 2), node(11, 1)):
        rest = np.linalg.norm(before[5001] - before[slave])
        assert np.linalg.norm(after[5001] - after[slave]) == pytest.approx(rest, abs=1e-5)
    assert after[5001][2] - before[5001][2] > 3.0
    # What has no length has none, and the beam keeps its own.
    assert np.allclose(after[5002], after[node(9, 3)], atol=1e-6)
    # The nugget stays the body it was.
    for k in range(1, 8):
        rest = np.linalg.norm(before[5010 + k] - before[5010])
        assert np.linalg.norm(after[5010 + k] - after[5010]) == pytest.approx(rest, abs=1e-5)
    (weld,) = [number for number in before if number < 0]
    assert after[weld][2] - before[weld][2] > 1.0
    (told,) = report["decks"]
    assert sorted(told["left"]) == [5020, 5021]
    assert np.array_equal(after[5020], before[5020])
    assert told["passengers"] == {"blend": 1, "rigid": 1, "nearest": 9, "stay": 2}
    assert told["joints"]["broken"] == [] and told["joints"]["count"] >= 4
    stale = [(one["card"], one["ids"]) for one in told["stale"]]
    # The orientation of the beam is a vector, which turns with nothing.
    assert stale == [("CBEAM", [905]), ("CORD2R", [7])]


def test_a_joint_that_comes_apart_is_an_error_with_its_line(folder: Path):
    deck = folder / "deck.bdf"
    # A spring from the moving end to what stays.
    far = f"CROD,950,6,{node(ALONG - 1, 0)},5022\n" + grid(5022, 119.0, 0.0, 0.5) + "\nENDDATA"
    deck.write_text(deck.read_text().replace("ENDDATA", far))
    stays = {"rules": [{"nodes": [5022], "rule": "stay"}]}
    with pytest.raises(CertificateError, match=r"deck.bdf, line \d+: CROD 950 came apart by 1"):
        run(recipe(folder, passengers=stays), folder / "out")
    assert not (folder / "out").exists()
    told = run(recipe(folder, passengers=stays, joints={"broken": "tell"}), folder / "out")
    (broken,) = told["decks"][0]["joints"]["broken"]
    assert broken["card"] == "CROD" and broken["id"] == 950 and broken["change"] > broken["limit"]
    assert any("came apart" in note for note in told["notes"])
    assert run(recipe(folder, passengers=stays, joints={"limit": 50.0}), folder / "out2")


def test_passengers_are_for_decks(folder: Path):
    (folder / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    path = recipe(folder)
    wanted = json.loads(path.read_text())
    wanted["parts"].append({"name": "a", "file": "a.obj", "joints": {"limit": 1}})
    path.write_text(json.dumps(wanted))
    with pytest.raises(RecipeError, match=r"joints: only a deck"):
        run(path, folder / "out")


def test_includes_come_out_of_a_run(folder: Path):
    lines = [*two_plates(), *hanging(), "ENDDATA", ""]
    nodes = [line for line in lines if line.startswith("GRID")]
    (folder / "mesh").mkdir()
    (folder / "mesh" / "nodes.inc").write_text("\n".join(nodes) + "\n")
    rest = [line for line in lines if not line.startswith("GRID")]
    (folder / "deck.bdf").write_text("\n".join(["INCLUDE 'mesh/nodes.inc'", *rest]))
    run(recipe(folder), folder / "out")
    moved = places(folder / "out" / "deck.bdf")
    assert moved[node(ALONG - 1, 0)].tolist() == [120.0, 0.0, 15.0]


def test_wide_fields_keep_twice_the_digits(folder: Path):
    lines = []
    for line in (folder / "deck.bdf").read_text().splitlines():
        fields = line.split(",")
        small = fields[0] == "GRID"
        lines.append("".join(f"{f:<8}" for f in fields) + "$ note" if small else line)
    (folder / "deck.bdf").write_text("\n".join(lines) + "\n")
    narrow = run(recipe(folder), folder / "out")
    wide = run(recipe(folder), folder / "wide", wide=True)
    errors = [[part["file"]["error"] for part in one["parts"]] for one in (narrow, wide)]
    assert min(errors[0]) > 1e-6 and max(errors[1]) < 1e-11
    before, after = places(folder / "deck.bdf"), places(folder / "wide" / "deck.bdf")
    assert list(before) == list(after)
    text = (folder / "wide" / "deck.bdf").read_text()
    assert "GRID*" in text and text.count("$ note") == len(before) - 1
    assert wide["parts"][0]["file"]["precision"] == "16 characters"


def masked(deck) -> list[bytes]:
    """The files of a deck without the numbers of its nodes, blanks and commas."""
    found = []
    for number, text in enumerate(deck.texts):
        keep = (text.codes != ord(" ")) & (text.codes != ord(","))
        for block in deck.raw.blocks if len(text) else ():
            if block.file == number:
                for begin, width in zip(block.begins.ravel(), block.widths.ravel()):
                    keep[begin : begin + width] = False
        found.append(bytes(text.codes[keep]))
    return found


def bend_recipe(path: Path, file) -> dict:
    """Its largest component bent by 5 % of its size: the one end fixed, the other lifted."""
    from sheetmorph.recipe.splitting import split_triangles

    pieces = split_triangles(file, "components")
    largest = max(pieces, key=lambda name: len(pieces[name]))
    vertices = np.unique(file.mesh.triangles[pieces[largest]])
    points = file.mesh.points[vertices]
    size = np.ptp(points, axis=0)
    along = (points[:, size.argmax()] - points[:, size.argmax()].min()) / size.max()
    shift = [0.0, 0.0, 0.0]
    shift[int(size.argmin())] = 0.05 * float(np.linalg.norm(size))
    name = f"{path.stem}/{largest}"
    return {
        "sheetmorph": 1,
        "parts": [{"file": str(path), "split": True, "joints": {"broken": "tell"}}],
        "primary": name,
        "features": "auto",
        "contacts": "auto",
        "fixed": [{"part": name, "vertices": file.mesh.file_ids(vertices[along <= 0.1])}],
        "handles": [
            {"name": "tip", "part": name, "vertices": file.mesh.file_ids(vertices[along >= 0.9])}
        ],
        "pose": {"tip": {"translation": shift}},
    }


@pytest.mark.parametrize("form", ["ls-dyna", "nastran", "radioss"])
def test_public_decks_bend_and_nothing_but_numbers_of_nodes_changes(form: str, tmp_path: Path):
    folder = SHARED / "09-decks" / form
    if not folder.is_dir():
        pytest.skip("shared/data/09-decks is not here")
    count = 0
    for path in sorted(folder.iterdir()):
        try:
            file = read_part(path)
        except ValueError:
            continue  # refused in words, or without shells: test_public_decks counts them
        wanted = tmp_path / "bend.json"
        wanted.write_text(json.dumps(bend_recipe(path, file)))
        report = run(wanted, tmp_path / "out")
        again = read_deck(tmp_path / "out" / path.name)
        assert masked(again) == masked(file.deck), path.name
        assert report["certificate"]["passed"] and report["decks"][0]["moved"] > 0
        count += 1
    assert count == {"ls-dyna": 11, "nastran": 62, "radioss": 1}[form]
