# SPDX-License-Identifier: LGPL-2.1-or-later
"""What decks call parts of their mesh: sets, parts, physical groups, each a group of a recipe."""

from __future__ import annotations

from pathlib import Path

import pytest

import sheetmorph
from sheetmorph.selecting import PartShape, selected


def ids_of(path: Path) -> tuple[PartShape, dict[str, list[int]]]:
    """The shape of a deck and the node ids of everything it has a name for."""
    mesh = sheetmorph.read_part(path).mesh
    shape = PartShape(mesh)
    named = {name: selected(shape, {"group": name}).vertices for name in shape.labels.names}
    return shape, {name: mesh.file_ids(rows) for name, rows in named.items()}


INPUT = """*Node, Nset=Whole
1, 0., 0., 0.
2, 1., 0., 0.
3, 2., 0., 0.
4, 0., 1., 0.
5, 1., 1., 0.
6, 2., 1., 0.
*Element, type=S4, elset=Left
1, 1, 2, 5, 4
*Element, type=S4, elset=Right
2, 2, 3, 6, 5
*Elset, elset=Second, generate
2, 2, 1
*Elset, elset=Both
Left, Second
*Nset, nset=Low
1, 2, 3
*Nset, nset=More
Low, 6
"""


def test_names_of_an_input_file_are_groups(tmp_path: Path):
    (tmp_path / "a.inp").write_text(INPUT)
    shape, ids = ids_of(tmp_path / "a.inp")
    assert ids["ELSET LEFT"] == [1, 2, 4, 5] and ids["ELSET SECOND"] == [2, 3, 5, 6]
    assert ids["ELSET RIGHT"] == [2, 3, 5, 6]
    assert ids["ELSET BOTH"] == ids["NSET WHOLE"] == [1, 2, 3, 4, 5, 6]
    assert ids["NSET LOW"] == [1, 2, 3] and ids["NSET MORE"] == [1, 2, 3, 6]
    assert selected(shape, {"group": "Left"}).vertices.tolist() == [0, 1, 3, 4]


PART = """*Part, name={name}
*Node
1, 0., {y}., 0.
2, 1., {y}., 0.
3, 1., {top}., 0.
*Element, type=S3, elset=Skin
1, 1, 2, 3
*Nset, nset=Corner{name}
3
*Elset, elset=Only{name}
1
*End Part
"""


def test_sets_of_the_parts_of_an_input_file_are_on_their_parts(tmp_path: Path):
    parts = PART.format(name="A", y=0, top=1) + PART.format(name="B", y=5, top=6)
    placed = "".join(f"*Instance, name={p}-1, part={p}\n*End Instance\n" for p in "AB")
    upper = "*Nset, nset=Upper, instance=B-1\n1, 2\n"
    (tmp_path / "a.inp").write_text(f"{parts}*Assembly, name=all\n{placed}{upper}*End Assembly\n")
    shape, _ = ids_of(tmp_path / "a.inp")

    def heights(name: str) -> list[float]:
        return shape.points[selected(shape, {"group": name}).vertices, 1].tolist()

    assert heights("CornerA") == [1] and heights("CornerB") == [6] and heights("Upper") == [5, 5]
    assert heights("OnlyA") == [0, 0, 1] and heights("OnlyB") == [5, 5, 6]
    assert heights("Skin") == [0, 0, 1, 5, 5, 6]


KEYWORDS = """*KEYWORD
*NODE
       1             0.0             0.0             0.0
       2             1.0             0.0             0.0
       3             2.0             0.0             0.0
       4             0.0             1.0             0.0
       5             1.0             1.0             0.0
       6             2.0             1.0             0.0
*ELEMENT_SHELL
       1       7       1       2       5       4
       2       8       2       3       6       5
*PART
front rail
         7         1         1
*SET_PART_LIST_TITLE
both sides
         3
         7         8
*SET_NODE_LIST
         4
         1         4
*SET_SHELL_LIST_GENERATE
         5
         2         9
*END
"""


def test_parts_and_sets_of_ls_dyna_are_groups(tmp_path: Path):
    (tmp_path / "a.k").write_text(KEYWORDS)
    shape, ids = ids_of(tmp_path / "a.k")
    assert ids["PART front rail"] == ids["PID 7"] == [1, 2, 4, 5]
    assert ids["SET_PART 3"] == ids["SET_PART both sides"] == [1, 2, 3, 4, 5, 6]
    assert ids["SET_NODE 4"] == [1, 4] and ids["SET_SHELL 5"] == [2, 3, 5, 6]
    assert selected(shape, {"group": "front rail"}).vertices.tolist() == [0, 1, 3, 4]


NAMES = '$PhysicalNames\n3\n1 1 "clamp"\n2 2 "lid"\n2 9 "nothing"\n$EndPhysicalNames\n'
NODES = """$Nodes
6
1 0 0 0
2 1 0 0
3 2 0 0
4 0 1 0
5 1 1 0
6 2 1 0
$EndNodes
"""
OLD = f"""$MeshFormat
2.2 0 8
$EndMeshFormat
{NAMES}{NODES}$Elements
3
1 1 2 1 11 1 4
2 3 2 0 21 1 2 5 4
3 3 2 2 22 2 3 6 5
$EndElements
"""
NEW = f"""$MeshFormat
4.1 0 8
$EndMeshFormat
{NAMES}$Entities
1 1 2 0
1 0 0 0 0
11 0 0 0 0 1 0 1 1 1 1
21 0 0 0 1 1 0 0 1 11
22 1 0 0 2 1 0 1 2 0
$EndEntities
$Nodes
1 6 1 6
2 21 0 6
1
2
3
4
5
6
0 0 0
1 0 0
2 0 0
0 1 0
1 1 0
2 1 0
$EndNodes
$Elements
3 3 1 3
1 11 1 1
1 1 4
2 21 3 1
2 1 2 5 4
2 22 3 1
3 2 3 6 5
$EndElements
"""


@pytest.mark.parametrize("text", [OLD, NEW])
def test_physical_groups_of_gmsh_are_groups(tmp_path: Path, text: str):
    (tmp_path / "a.msh").write_text(text)
    _, ids = ids_of(tmp_path / "a.msh")
    assert ids["physical clamp"] == [1, 4] and ids["physical lid"] == [2, 3, 5, 6]
    assert "physical nothing" not in ids
