# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of a deck by property, with common nodes and with names."""
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from conftest import sheetmorph


def test_parts_by_property_share_the_nodes_of_their_common_line(
    case: Callable[[str], Path],
) -> None:
    folder = case("09")
    found = json.loads(sheetmorph("find", "main.k", "--split", "property", folder=folder).out)
    assert found["parts"] == [
        {"file": "main.k", "split": "property", "parts": ["main/1", "main/2"]}
    ]
    (contact,) = found["contacts"]
    assert contact["type"] == "tied" and contact["distance"] == 0.0
    assert contact["a"]["vertices"] == contact["b"]["vertices"] == list(range(57, 64))


@pytest.mark.parametrize("contacts", [[], "auto"])
def test_common_nodes_stay_together_whatever_the_recipe_says_of_contacts(
    case: Callable[[str], Path], contacts: object
) -> None:
    from sheetmorph import Session
    from sheetmorph.checking import prepare, with_ids

    folder = case("09")
    recipe = {
        "sheetmorph": 1,
        "parts": [{"file": "main.k", "split": "property"}],
        "primary": "main/1",
        "fixed": [{"part": "main/1", "vertices": list(range(1, 15))}],
        "handles": [{"name": "end", "part": "main/1", "vertices": list(range(50, 57))}],
        "contacts": contacts,
        "pose": {"end": {"translation": [0, 0, 8]}},
    }
    (folder / "r.json").write_text(json.dumps(recipe))
    ended = sheetmorph("run", "r.json", "-o", "out", folder=folder)
    assert ended.status == 0, ended.said
    parts = prepare(recipe, folder)
    answer = Session(with_ids(parts), parts.meshes).deform()
    places = []
    for name in ("main/1", "main/2"):
        rows, _ = parts.meshes[name].find(list(range(57, 64)))
        places.append(answer.positions[name][rows])
        assert np.abs(places[-1] - parts.meshes[name].points[rows]).max() > 1.0
    assert np.abs(places[0] - places[1]).max() < 1e-9


def test_parts_of_an_input_file_have_the_names_and_thickness_of_their_sections(
    case: Callable[[str], Path],
) -> None:
    from sheetmorph.finding.reading import parts_of_files

    folder = case("09")
    found = json.loads(sheetmorph("find", "bracket.inp", "--split", "property", folder=folder).out)
    assert found["parts"][0]["parts"] == ["bracket/eBracket", "bracket/ePlate"]
    assert found["parts"][0]["split"] == "property"
    (contact,) = found["contacts"]
    assert contact["distance"] == pytest.approx(1.5)
    parts = parts_of_files([folder / "bracket.inp"], "property")
    assert {name: mesh.thickness for name, mesh in parts.meshes.items()} == {
        "bracket/eBracket": 1.5,
        "bracket/ePlate": 2.0,
    }
