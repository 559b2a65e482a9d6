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
from sheetmorph.doctor import diagnose_files, schema
from test_command_line import run_module
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
    assert {"remesh", "scale"} <= cures
    assert ("split" in cures) == (components > 1)
