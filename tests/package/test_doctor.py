# SPDX-License-Identifier: LGPL-2.1-or-later
"""The doctor: what it finds, what it prints, and that it changes nothing."""

from __future__ import annotations

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest

from plates import plate, write_plate
from sheetmorph import PartMesh, diagnose
from sheetmorph.starting.doctor import diagnose_files, schema
from sheetmorph.base.file_unit import UNITS
from test_command_line import copied_package, run_module
from test_real_files import real_file

SUMMIT = "05-robotnik-summit-stl"


def findings(diagnosis: dict) -> dict[str, dict]:
    return {entry["finding"]: entry for entry in diagnosis["findings"]}


def test_a_clean_open_plate_needs_no_cure():
    part = plate()
    found = diagnose(PartMesh(part.points, part.triangles))
    assert found["kind"] == "open shell"
    assert found["thickness"] is None
    assert not any(entry["cure"] in ("weld", "orient") for entry in found["findings"])


def test_every_defect_is_told_with_its_cure():
    points = np.array([[0, 0, 0], [40, 0, 0], [40, 40, 0], [0, 40, 0], [40 + 1e-7, 0, 0]], float)
    mesh = PartMesh(points, np.array([[0, 1, 2], [0, 3, 2], [4, 1, 2]]))
    found = findings(diagnose(mesh))
    assert found["near-duplicate vertices"]["cure"] == "weld"
    assert found["near-duplicate vertices"]["recipe"]["weld"] == pytest.approx(5.7e-5, rel=0.1)
    assert found["flipped triangles"]["cure"] == "orient"
    assert found["degenerate triangles"]["count"] == 1
    assert found["long edges"]["recipe"]["remesh"]["edge"] > 0.0


def test_the_command_prints_what_the_schema_says_and_changes_nothing(tmp_path: Path):
    file = write_plate(plate(), tmp_path / "plate.obj", "obj")
    before = file.read_bytes()
    done = run_module("doctor", str(file), str(file))
    assert done.returncode == 0, done.stderr
    printed = json.loads(done.stdout)
    jsonschema.validate(printed, schema())
    assert [entry["file"] for entry in printed["files"]] == [str(file), str(file)]
    assert file.read_bytes() == before


def test_without_a_file_the_installation_is_checked(tmp_path: Path, monkeypatch):
    place = tmp_path / "FreeCAD" / "Mod" / "SheetMorph"
    place.mkdir(parents=True)
    (place / "package.xml").write_text("<version>0.0.9</version>")
    (tmp_path / "freecad").touch(mode=0o755)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.delenv("FREECAD_USER_HOME", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    done = run_module("doctor")
    assert done.returncode == 0 and done.stderr == ""
    lines = dict(line.split(": ", 1) for line in done.stdout.splitlines())
    assert lines["numpy"] == np.__version__ and "kernel_api" in lines["kernel"]
    assert lines["CAD worker"].endswith("sheetmorph-cad")
    assert lines["Xvfb"] == "missing, needed for pictures; install xvfb"
    assert lines["FreeCAD add-on"].startswith("0.0.9") and "./sheetmorph install" in done.stdout


def test_an_installation_without_a_kernel_is_an_error(tmp_path: Path):
    found = run_module("doctor", path=copied_package(tmp_path, None))
    assert found.returncode == 2 and found.stderr == ""
    assert "./sheetmorph build" in found.stdout


@pytest.mark.parametrize("arguments", [["nowhere.stl"], ["--tolerance", "-1", "x.stl"]])
def test_bad_input_is_refused(arguments: list[str]):
    done = run_module("doctor", *arguments)
    assert done.returncode == 2
    assert done.stdout == ""


def test_the_plate_of_the_summit_is_found_as_its_readme_says():
    file = real_file(f"{SUMMIT}/summit_xls_chapas_inox_tapas.stl")
    found = diagnose_files([file])["files"][0]
    counts = found["counts"]
    assert found["triangles"] == 4434
    assert found["unit"]["guess"] == "m"
    assert counts["open_edges"] == 1312
    assert counts["near_duplicate_vertices"] == 693
    assert counts["t_junctions"] == 4
    assert counts["slivers"] == 1181
    assert (counts["open_edges_welded"], counts["non_manifold_edges_welded"]) == (0, 10)
    assert findings(found)["non-manifold edges"]["cure"] == "weld"  # two plates share a wall
    # It says 2 mm; every skin of the file has its other side 1.5 mm away.
    assert found["kind"] == "thin solid"
    assert found["thickness"] == pytest.approx(0.0015, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "components", "slivers"),
    [
        ("structure_chair", 28, 3460),
        ("summit_xl_covers", 10, 337),
        ("summit_xl_chassis", 1, 430),
    ],
)
def test_the_other_sets_are_found_as_their_readme_says(name: str, components: int, slivers: int):
    found = diagnose_files([real_file(f"{SUMMIT}/{name}.stl")])["files"][0]
    assert len(found["components"]) == components
    assert found["counts"]["slivers"] == slivers
    assert found["counts"]["open_edges"] == 0
    cures = {entry["cure"] for entry in found["findings"]}
    assert "remesh" in cures
    assert ("split" in cures) == (components > 1)
    # Only the covers have a thickness that is a usual gauge in one unit, 1.5 mm in metres.
    assert ("scale" in cures) == (name == "summit_xl_covers")
    assert found["unit"]["guess"] == ("m" if name == "summit_xl_covers" else "unknown")
    assert "m" in found["unit"]["plausible"] and "unit" in findings(found)


def sheet(size: tuple[float, float], thickness: float) -> PartMesh:
    """A closed plate with two skins, 12 x 12 squares each."""
    grid = np.linspace(0.0, 1.0, 13)
    x, y = (a.ravel() for a in np.meshgrid(size[0] * grid, size[1] * grid, indexing="ij"))
    low = np.array(
        [[13 * i + j, 13 * i + j + 14, 13 * i + j + 13] for i in range(12) for j in range(12)]
    )
    low = np.concatenate([low, low[:, [0, 1, 1]] + [0, -13, 0]])
    rim = [13 * i for i in range(13)] + [156 + j for j in range(1, 13)]
    rim += [13 * i + 12 for i in range(11, -1, -1)] + list(range(11, 0, -1))
    walls = [(a, b, b + 169, a, b + 169, a + 169) for a, b in zip(rim, rim[1:] + rim[:1])]
    points = np.column_stack([np.tile(x, 2), np.tile(y, 2), np.repeat([0.0, thickness], 169)])
    return PartMesh(points, np.concatenate([low, low[:, ::-1] + 169, np.reshape(walls, (-1, 3))]))


def test_the_true_unit_is_named_and_no_wrong_scale_is_written_in_silence():
    noise = np.random.default_rng(8)
    wrong = 0
    for unit, scale in UNITS.items():
        for _ in range(25):
            thickness = noise.choice(
                [0.5, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, noise.uniform(0.5, 6)]
            )
            long = np.exp(noise.uniform(np.log(max(20.0, 12 * thickness)), np.log(2000.0)))
            part = sheet((long / scale, noise.uniform(0.5, 1.0) * long / scale), thickness / scale)
            found = diagnose(part)
            assert found["kind"] == "thin solid"
            assert unit in found["unit"]["plausible"], (unit, thickness, long)
            written = found["part"].get("scale", 1.0)
            if written != scale:
                (text,) = [f["text"] for f in found["findings"] if f["finding"] == "unit"]
                assert unit in text
                wrong += written != 1.0
    assert wrong <= 3  # by a thickness that is a usual gauge in another unit, by chance


def test_the_unit_of_a_usual_part_in_mm_is_no_question():
    for thickness in (0.8, 1.0, 2.0, 3.0):
        found = diagnose(sheet((300.0, 200.0), thickness))
        assert found["unit"]["is_certain"] and found["unit"]["guess"] == "mm"
        assert "unit" not in findings(found)


def test_what_a_file_lacks_is_the_first_finding(tmp_path: Path):
    file = write_plate(plate(), tmp_path / "plate.obj", "obj")
    file.write_bytes(file.read_bytes()[:-1])
    (found,) = diagnose_files([file])["files"]
    assert found["findings"][0]["finding"] == "not read whole"
    jsonschema.validate(diagnose_files([file]), schema())


@pytest.mark.parametrize("exponent", range(-12, 16))
def test_every_size_gets_a_unit(exponent: int):
    """The largest and the smallest parts, too, for which no unit is usual."""
    from sheetmorph.base.file_unit import UNITS, unit_of

    for thickness in (None, 1e-6, 0.1, 1.0, 2.0, 50.0, 1e6):
        found = unit_of(3.0 * 10.0**exponent, thickness)
        assert found["guess"] in (*UNITS, "unknown") and found["reason"]
        assert found["scale"] == UNITS.get(found["guess"], 1.0)
