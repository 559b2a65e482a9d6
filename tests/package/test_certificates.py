# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates: what is measured has analytic answers, what is wrong in the files is found."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from deck_samples import RADIOSS
from sheetmorph import read_part
from sheetmorph.certifying import NotCertified, Targets, certify, read_criteria, shipped
from sheetmorph.measuring.quality import MEASURES, areas, measured, step_length
from sheetmorph.cli import main
from sheetmorph.pictures import drawing
from sheetmorph.base.errors import FileError

CLEAR = Path(__file__).parents[2] / "bindings" / "python" / "sheetmorph"
RING = 16


def values(corners: list[tuple[float, float, float]]) -> dict[str, float]:
    """All measures of one element."""
    points = np.array(corners, dtype=float)
    face = np.array([[*range(len(points)), -1][:4]])
    return {name: float(measured(m, points, face)[0]) for name, m in MEASURES.items()}


def test_a_square_is_perfect():
    found = values([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)])
    expected = {"aspect": 1, "warpage": 0, "skew": 0, "taper": 0, "jacobian": 1, "min_angle": 90,
                "max_angle": 90, "min_length": 2}  # fmt: skip
    assert found == pytest.approx(expected, abs=1e-6)


def test_a_sheared_a_twisted_and_a_narrowing_quad():
    sheared = values([(0, 0, 0), (1, 0, 0), (2, 1, 0), (1, 1, 0)])
    assert sheared["skew"] == pytest.approx(45.0) and sheared["min_angle"] == pytest.approx(45.0)
    assert sheared["jacobian"] == pytest.approx(1.0)
    twisted = values([(0, 0, 0), (1, 0, 0), (1, 1, 1), (0, 1, 0)])
    assert twisted["warpage"] > 50.0
    # Corner triangles of 1 and 0.5 where half the quad is 0.75.
    narrow = values([(0, 0, 0), (2, 0, 0), (1.5, 1, 0), (0.5, 1, 0)])
    assert narrow["taper"] == pytest.approx(1.0 - 0.5 / 0.75)
    arrow = values([(0, 0, 0), (4, 0, 0), (0.5, 0.5, 0), (0, 4, 0)])
    assert arrow["jacobian"] < 0.0


def test_an_equilateral_triangle():
    found = values([(0, 0, 0), (1, 0, 0), (0.5, 3**0.5 / 2, 0)])
    assert found["min_angle"] == pytest.approx(60.0) and found["skew"] == pytest.approx(
        0.0, abs=1e-6
    )
    points = np.array([(0, 0, 0), (3, 0, 0), (0, 4, 0)], dtype=float)
    face = np.array([[0, 1, 2, -1]])
    assert measured(areas, points, face)[0] == pytest.approx(6.0)
    assert measured(step_length, points, face)[0] == pytest.approx(12.0 / 5.0)


def plate() -> str:
    """A plate of 80 x 80 mm with a round hole of 20 mm, quads around it, as LS-DYNA cards."""
    nodes, elements = [], []
    rings = [10.0, 14.0, 20.0, 28.0, 40.0]
    for k, radius in enumerate(rings):
        for j in range(RING):
            angle = 2 * np.pi * j / RING
            x, y = np.cos(angle), np.sin(angle)
            if k == len(rings) - 1:
                x, y = (value / max(abs(x), abs(y)) for value in (x, y))
            nodes.append(f"{1 + k * RING + j:8d}{radius * x:16.9f}{radius * y:16.9f}{0.0:16.9f}")
    for k in range(len(rings) - 1):
        for j in range(RING):
            a, b = 1 + k * RING + j, 1 + k * RING + (j + 1) % RING
            number = len(elements) + 1
            elements.append("".join(f"{n:8d}" for n in (number, 7, a, a + RING, b + RING, b)))
    section = ["*SECTION_SHELL", f"{3:10d}{2:10d}", f"{1.5:10.2f}"]
    part = ["*PART", "plate", f"{7:10d}{3:10d}{1:10d}"]
    cards = ["*KEYWORD", *part, *section, "*NODE", *nodes, "*ELEMENT_SHELL", *elements, "*END"]
    return "\n".join(cards) + "\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "plate.k").write_text(plate())
    outer = [1 + 4 * RING + j for j in range(RING)]
    right = [1 + 4 * RING + j for j in (0, 1, RING - 1)]
    left = [1 + 4 * RING + j for j in (7, 8, 9)]
    assert set(left + right) <= set(outer)
    recipe = {
        "sheetmorph": 1,
        "parts": [{"name": "plate", "file": "plate.k"}],
        "fixed": [{"part": "plate", "vertices": left}],
        "handles": [{"name": "tip", "part": "plate", "vertices": right}],
        "features": [{"name": "hole", "part": "plate", "vertices": list(range(1, 2 * RING + 1))}],
        "pose": {"tip": {"translation": [0, 0, 8.0]}},
    }
    (tmp_path / "recipe.json").write_text(json.dumps(recipe))
    return tmp_path


def test_a_run_is_certified_with_its_hole_round(folder: Path, capsys):
    jsonschema = pytest.importorskip("jsonschema")
    arguments = [str(folder / "recipe.json"), "-o", str(folder / "out"), "--certify", "--quiet"]
    assert main(["run", *arguments, "--criteria", "static"]) == 0
    assert "certified by static" in capsys.readouterr().out
    found = json.loads((folder / "out" / "certificate.json").read_text())
    schema = (CLEAR / "certifying" / "certificate.schema.json").read_text()
    jsonschema.validate(found, json.loads(schema))
    (hole,) = found["features"]
    (rim,) = hole["rims"]
    assert rim["diameter_before"] == pytest.approx(20.0, abs=1e-6)
    assert rim["diameter_after"] == pytest.approx(20.0, abs=1e-6)
    assert rim["roundness_after"] < 1e-6 and hole["edge_error"] < hole["allowed"] < 1e-6
    (part,) = found["parts"]
    assert part["thickness"] == 1.5 and part["flipped"] == 0
    area = 80.0**2 - RING / 2 * 100 * np.sin(2 * np.pi / RING)
    assert part["material"] == {"name": "steel", "density_t_mm3": 7.85e-9}
    assert part["mass"]["before_t"] == pytest.approx(area * 1.5 * 7.85e-9, rel=1e-9)
    page = (folder / "out" / "certificate.html").read_text()
    assert "passed" in page and page.count("data:image/png;base64,") == 4 and "http" not in page
    step = part["time_step"]["before_ms"]
    shown = [1000.0 * part["mass"]["after_t"], 1000.0 * step, rim["diameter_after"]]
    assert [value for value in shown if f"<td>{value:.4g}</td>" not in page] == []
    assert page.count('<div class="bars">') == len(
        [one for one in part["quality"] if {"min", "max"} & set(one)]
    )


def test_names_of_files_are_text_on_the_page(folder: Path):
    evil = "<script>alert(1)</script>"
    recipe = json.loads((folder / "recipe.json").read_text().replace('"hole"', json.dumps(evil)))
    (folder / "recipe.json").write_text(json.dumps(recipe))
    arguments = [str(folder / "recipe.json"), "-o", str(folder / "out"), "--certify", "--quiet"]
    assert main(["run", *arguments]) == 0
    page = (folder / "out" / "certificate.html").read_text()
    assert "<script" not in page and "&lt;script&gt;alert(1)&lt;/script&gt;" in page


def test_a_page_without_pictures_names_the_package_that_draws_them(folder: Path, monkeypatch):
    monkeypatch.setattr(drawing.shutil, "which", lambda _: None)
    arguments = [str(folder / "recipe.json"), "-o", str(folder / "out"), "--certify", "--quiet"]
    assert main(["run", *arguments, "--criteria", "static"]) == 0
    page = (folder / "out" / "certificate.html").read_text()
    assert "Without pictures: no picture can be drawn; install xvfb." in page
    assert "<img" not in page and "Form features, mm" in page


UNITS = {"t": (2.7e-9, 70000.0), "kg": (2.7e-6, 70.0), "g": (2.7e-3, 70000.0)}


@pytest.mark.parametrize("unit", sorted(UNITS))
def test_mass_and_time_step_are_of_the_material_of_the_deck(folder: Path, unit: str):
    density, young = UNITS[unit]
    card = f"*MAT_ELASTIC_TITLE\naluminium\n{1:10d}{density:10.2e}{young:10.1f}{0.33:10.2f}\n"
    (folder / "plate.k").write_text(plate().replace("*END", card + "*END"))
    recipe, out = folder / "recipe.json", folder / "out"
    assert main(["run", str(recipe), "-o", str(out), "--quiet"]) == 0
    (part,) = certify(recipe, out, read_criteria("static"), Targets())["parts"]
    assert part["material"]["name"] == "*MAT_ELASTIC_TITLE 1"
    assert part["material"]["density_t_mm3"] == pytest.approx(2.7e-9)
    sound = np.sqrt(70e9 / (2700.0 * (1.0 - 0.33**2)))
    assert part["time_step"]["sound_m_s"] == pytest.approx(sound)
    area = 80.0**2 - RING / 2 * 100 * np.sin(2 * np.pi / RING)
    assert part["mass"]["before_t"] == pytest.approx(area * 1.5 * 2.7e-9, rel=1e-9)


def test_a_file_that_was_changed_afterwards_fails(folder: Path, capsys):
    arguments = [str(folder / "recipe.json"), "-o", str(folder / "out"), "--quiet"]
    assert main(["run", *arguments]) == 0
    written = folder / "out" / "plate.k"
    text = written.read_text()
    line = next(one for one in text.splitlines() if one.startswith(f"{3:8d}") and len(one) > 50)
    moved = line[:8] + f"{float(line[8:24]) + 0.5:16.9f}" + line[24:]
    written.write_text(text.replace(line, moved))
    command = ["certify", str(folder / "recipe.json"), str(folder / "out")]
    assert main([*command, "--json", str(folder / "c.json"), "--page", str(folder / "c.html")]) == 3
    assert "hole on plate lost its shape by" in capsys.readouterr().err
    found = json.loads((folder / "c.json").read_text())
    assert not found["passed"] and "hole on plate" in found["failures"][0]
    assert found["features"][0]["rims"][0]["roundness_after"] > 0.1
    assert "failed" in (folder / "c.html").read_text()


def test_elements_that_newly_fail_are_counted(folder: Path):
    (folder / "hard.json").write_text(
        '{"elements": {"skew": {"max": 40}, "min_length": {"min": 1}}}'
    )
    recipe, out = folder / "recipe.json", folder / "out"
    changed = json.loads(recipe.read_text())
    changed["pose"]["tip"]["translation"] = [30, 0, 30]
    recipe.write_text(json.dumps(changed))
    assert main(["run", str(recipe), "-o", str(out), "--quiet"]) == 0
    with pytest.raises(NotCertified, match="newly fail the criteria"):
        certify(recipe, out, read_criteria(folder / "hard.json"), Targets())


def test_what_is_not_there_or_another_deck_is_told(folder: Path, capsys):
    command = ["certify", str(folder / "recipe.json"), str(folder / "nothing")]
    assert main(command) == 2
    assert "the file does not exist; name the folder that a run" in capsys.readouterr().err
    (folder / "nothing").mkdir()
    (folder / "nothing" / "plate.k").write_text(plate().replace(f"{80:8d}", f"{99:8d}"))
    assert main(command) == 2
    assert "it has other nodes than plate.k" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("[1]", "criteria must be an object"),
        ('{"elements": {"beauty": {"max": 1}}}', 'no measure "beauty"'),
        ('{"elements": {"skew": {"most": 1}}}', '"skew" needs numbers'),
        ('{"set": "none"}', 'no set "none"'),
        ('{"limits": {}}', 'unknown key "limits"'),
        ('{"time_step": {"target_ms": "fast"}}', "is not a number"),
        ("{", "it is not JSON"),
    ],
)
def test_criteria_that_make_no_sense_are_refused(text: str, what: str, tmp_path: Path):
    (tmp_path / "c.json").write_text(text)
    with pytest.raises(FileError, match=what):
        read_criteria(tmp_path / "c.json")


def test_every_shipped_set_is_sound_and_can_be_built_upon(tmp_path: Path):
    for name in shipped():
        assert read_criteria(name).elements
    (tmp_path / "c.json").write_text('{"set": "crash", "elements": {"aspect": {"max": 3}}}')
    found = read_criteria(tmp_path / "c.json")
    assert found.elements["aspect"] == {"max": 3} and found.target == 0.0005
    assert found.elements["skew"] == {"max": 60}


def test_a_written_deck_is_read_again_once_and_anew_when_it_changes(tmp_path, monkeypatch):
    path = tmp_path / "deck_0000.rad"
    path.write_bytes(RADIOSS)
    file = read_part(path)
    reads = []
    kept = file.stored_deck
    monkeypatch.setattr(file, "stored_deck", lambda place: reads.append(place) or kept(place))
    target = tmp_path / "out" / "deck_0000.rad"
    target.parent.mkdir()
    for shift in (0.25, 0.5):
        file.write(target, file.mesh.points + shift)
        for _ in range(2):
            assert np.allclose(file.stored_positions(target), file.mesh.points + shift)
    assert reads == [target, target]
    target.write_bytes(RADIOSS + b"#\n")
    assert np.array_equal(file.stored_positions(target), file.mesh.points)
