# SPDX-License-Identifier: LGPL-2.1-or-later
"""No source imports itself by way of others."""
import re

import draw_workbench
import pytest
from imports import circles, folder_graph, import_graph
from workbench_rooms import MAY_IMPORT, room_faults
from source_tree import PACKAGE, ROOT, WORKBENCH


def graph_of(folder, sources):
    """The import graph of a package made of these texts, by path."""
    for path, text in sources.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)
    return import_graph(folder, "house")


def test_the_package_imports_in_no_circle():
    graph = import_graph(PACKAGE, "sheetmorph")
    assert len(graph) > 50 and graph["morph.session"]
    assert circles(graph) == []


def test_the_workbench_imports_in_no_circle():
    graph = import_graph(WORKBENCH, "freecad.sheetmorph")
    assert len(graph) > 100 and graph["api"]
    assert circles(graph) == []


def rooms_of_the_workbench():
    """What the rooms of the workbench import of each other; its tests know all of them."""
    graph = import_graph(WORKBENCH, "freecad.sheetmorph")
    return folder_graph({name: found for name, found in graph.items() if "tests" not in name})


def test_the_rooms_of_the_workbench_stand_in_no_circle():
    rooms = rooms_of_the_workbench()
    assert len(rooms) > 10 and rooms["api"]
    assert circles(rooms) == []


def test_a_room_that_sees_little_imports_no_more():
    rooms = rooms_of_the_workbench()
    assert set(MAY_IMPORT) <= set(rooms)
    assert [fault for room, found in rooms.items() for fault in room_faults(room, found)] == []


def test_the_manual_lists_rooms_that_exist():
    page = ROOT / "resources" / "docs" / "contributing" / "architecture.md"
    text = page.read_text().split("from the top down:")[1].split("## A new")[0]
    rooms = set(re.findall(r"^- `(\w+)`", text, re.MULTILINE))
    assert len(rooms) > 10 and rooms <= set(rooms_of_the_workbench())
    assert set(re.findall(r"`(\w+)`", text)) <= {path.stem for path in WORKBENCH.rglob("*")}


def test_the_picture_of_the_workbench_shows_every_room_above_what_it_imports():
    graph = {"panels": {"api", "tools"}, "api": {"tools"}, "tools": set()}
    at = draw_workbench.places(graph)
    assert at["panels"][1] < at["api"][1] < at["tools"][1]
    assert draw_workbench.direct(graph, "panels") == ["api"]
    assert all(f">{room}<" in draw_workbench.svg(graph) for room in graph)


def test_an_arrow_the_wrong_way_is_noticed():
    assert room_faults("objects", {"kinds", "bridge"}) == ["objects imports bridge"]
    assert room_faults("panels", {"api", "scene"}) == []


@pytest.mark.parametrize(
    "back",
    [
        "from . import a",
        "from .a import f",
        "import house.a",
        "from house.a import f",
        "def f():\n    from . import a",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from .a import A",
    ],
)
def test_a_circle_is_noticed(tmp_path, back):
    graph = graph_of(tmp_path, {"a.py": "from . import b\n", "b.py": back + "\n", "c.py": ""})
    assert circles(graph) == [["a", "b"]]


def test_a_circle_through_folders_is_noticed(tmp_path):
    graph = graph_of(
        tmp_path,
        {
            "api/__init__.py": "from .files import save\n",
            "api/files.py": "from ..session import solve\n",
            "session.py": "def f():\n    from . import api\n",
        },
    )
    assert circles(graph) == [["api", "api.files", "session"]]
    assert folder_graph(graph) == {"api": {"session"}, "session": {"api"}}


def test_a_package_without_circles_passes(tmp_path):
    graph = graph_of(
        tmp_path,
        {"__init__.py": "from .a import f\n", "a.py": "from .b import g\n", "b.py": "import os\n"},
    )
    assert graph == {"": {"a"}, "a": {"b"}, "b": set()}
    assert circles(graph) == []


def test_the_picture_of_the_workbench_is_that_of_its_imports_of_today():
    drawn = draw_workbench.svg(draw_workbench.rooms())
    assert draw_workbench.PICTURE.read_text("utf-8") == drawn, "run draw_workbench.py"
