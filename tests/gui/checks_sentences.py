# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is picked keeps its sentence: on another mesh, in a macro, and typed by hand."""

import json
import os

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
from checks_drawing import ring, start, top
from checks_macro import calls_in, macro_path, replay, start_recording, stop_recording
from checks_picking import start_morph, view_from
from desk import WORK, child, click_point, draw_along, enter, import_files, picture, press
from desk import press_tool, replace_file, settled, until, view, xdotool
from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import selecting
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.qt import QtWidgets
from freecad.sheetmorph.scene.wireframe import NAME
from pivy import coin
from scenes import assembly, new_document, part, regions
from shapes import HOLES

__all__ = [
    "test_a_macro_of_face_brush_rim_and_lasso_picks_is_short_and_replays_to_the_bit",
    "test_a_part_prepared_anew_by_mouse_keeps_every_region",
    "test_a_changed_step_file_keeps_every_region_and_lights_up_what_differs",
    "test_a_hole_that_may_be_another_one_is_asked_for",
    "test_a_selector_is_typed_in_the_panel",
]
LONGEST = 2000  # characters of a macro with a pick of every kind


def pick_in_every_way():
    """Fixed by a face, a handle by the brush, holes by a rim and a lasso."""
    view_from(0.0)
    yield from press_tool("Mark Fixed Region…")
    yield from click_point((0.0, 30, 10))
    yield from press("OK")
    yield from start("Mark Handle…", "brush")
    yield from draw_along([(112, 8, 0), (112, 52, 0)])
    yield from press("OK")
    top()
    yield from press_tool("Mark Form Features…")
    x, y, radius = HOLES[0]
    yield from click_point((x, y + radius + 1.5, 0))
    yield from press("OK")
    yield from start("Mark Form Features…", "lasso")
    yield from draw_along(ring(*HOLES[1][:2], HOLES[1][2] + 5))
    yield from press("OK")


def test_a_macro_of_face_brush_rim_and_lasso_picks_is_short_and_replays_to_the_bit():
    yield from start_recording("said")
    yield from new_document()
    yield from start_morph()
    yield from pick_in_every_way()
    yield from stop_recording("said")
    with open(macro_path("said"), encoding="utf-8") as file:
        text = file.read()
    lines = [line for line in text.splitlines() if ".add_f" in line or ".add_h" in line]
    assert [key for key in ("face_at", "brush", "rim_at", "lasso") if key not in text] == [], text
    assert len(lines) == 4 and calls_in("said").count("add_feature") == 2, calls_in("said")
    assert len(text) < LONGEST, text
    assert all(api.where(region) for region in model.regions(assembly()))
    yield from replay("said")


def areas() -> dict:
    """The area of every region by its label, mm^2, as its sentence means it."""
    shape = selecting.shape_of(part())
    found = {}
    for region in model.regions(assembly()):
        chosen = selecting.chosen_on(shape, api.where(region))
        assert api.vertices(region) == chosen.vertices.tolist(), region.Label
        found[region.Name] = shape.area_of(chosen)
    return found


def prepare_with(edge: float):
    """Prepare Mesh, with edges of a length, and OK."""
    before = part().Source.Name
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(part())
    yield from press_tool("Prepare Mesh…")
    yield from until(Gui.Control.activeDialog, "the panel")
    child("weld").setChecked(False)
    child("remesh").setChecked(True)
    child("thin").setChecked(False)
    yield from enter(child("edge"), str(edge))
    yield from press("OK")
    yield from until(lambda: part().Source.Name != before, "the new mesh")
    yield from settled()


def test_a_part_prepared_anew_by_mouse_keeps_every_region():
    yield from new_document()
    yield from start_morph()
    for x, command in ((0.0, "Mark Fixed Region…"), (120.0, "Mark Handle…")):
        view_from(x)
        yield from press_tool(command)
        yield from click_point((x, 30, 10))
        yield from press("OK")
    top()
    yield from press_tool("Mark Form Features…")
    for (x, y, radius), key in zip(HOLES, ("", "shift")):
        yield from click_point((x, y + radius + 1.5, 0), key)
    yield from press("OK")
    first = areas()
    assert len(first) == 4
    for edge in (8.0, 4.0, 3.0):
        yield from prepare_with(edge)
        now = areas()
        assert now.keys() == first.keys()
        for name, area in first.items():
            assert abs(now[name] - area) <= 0.03 * max(area, 1e-9), (edge, name, area, now[name])
        assert api.preparation_of(part())["told"] == []


def step_file(name: str, width: float, radius: float) -> str:
    """The path of a new STEP file: a plate of 60 mm x a width x 2 mm with a hole."""
    path = os.path.join(WORK, name)
    shape = Part.makeBox(60, width, 2)
    hole = Part.makeCylinder(radius, 4, App.Vector(40, 20, -1))
    shape.cut(hole).exportStep(path)
    return path


def test_a_changed_step_file_keeps_every_region_and_lights_up_what_differs():
    yield from new_document()
    first = step_file("plate.step", 40.0, 5.0)
    yield from import_files([first], 5.0, lambda: [o for o in found_parts() if o.ShapeData])
    (plate,) = [o for o in found_parts() if o.ShapeData]
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(plate)
    for x, command in ((0.0, "Mark Fixed Region…"), (60.0, "Mark Handle…")):
        view_from(x)
        yield from press_tool(command)
        yield from click_point((x, 20, 1))
        yield from press("OK")
    top()
    yield from press_tool("Mark Form Features…")
    yield from click_point((40, 26.5, 2))
    yield from press("OK")
    marked = [r for r in model.regions(assembly()) if r.Part == plate]
    said = [api.where(region) for region in marked]
    assert len(marked) == 3 and all(said)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(plate)
    yield from replace_file(step_file("changed.step", 50.0, 5.5), 5.0)
    points = api.rest_mesh(plate)[0]
    assert abs(np.ptp(points[:, 1]) - 50.0) < 1e-6
    assert [api.where(region) for region in marked] == said
    for region in marked:
        assert api.vertices(region) == api.select(plate, api.where(region)), region.Label
    ends = [points[api.vertices(region), 0] for region in marked[:2]]
    assert ends[0].max() < 1e-6 and ends[1].min() > 60.0 - 1e-6
    hole = points[api.vertices(marked[2])]
    assert abs(np.hypot(hole[:, 0] - 40.0, hole[:, 1] - 20.0) - 5.5).max() < 0.2
    lit = {obj.Name for obj in Gui.Selection.getSelection()}
    assert lit == {region.Name for region in marked}, lit  # longer sides and a larger hole
    picture("replaced")
    assert App.ActiveDocument.UndoNames[0] == "Replace File"
    App.ActiveDocument.undo()
    App.ActiveDocument.recompute()
    assert abs(np.ptp(api.rest_mesh(plate)[0][:, 1]) - 40.0) < 1e-6
    assert [api.where(region) for region in marked] == said


def drilled(*places: float):
    """A plate of 160 x 40 x 2 mm with holes of 9 mm along x."""
    shape = Part.makeBox(160, 40, 2)
    for x in places:
        shape = shape.cut(Part.makeCylinder(4.5, 4, App.Vector(x, 20, -1)))
    return shape


def test_a_hole_that_may_be_another_one_is_asked_for():
    yield from new_document()
    document = App.ActiveDocument
    source = document.addObject("Part::Feature", "Drilled")
    source.Shape = drilled(20, 50, 80, 110)
    (plate,) = api.add_shape(api.create_assembly(document), source, "plate", {"edge": 8.0})
    where = {"rim_at": [50, 20, 2], "rings": 1}
    hole = api.add_feature(model.assembly_of(plate), plate, where, "second hole")
    document.recompute()
    source.Shape = drilled(20, 66, 80, 110)
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(plate)
    asked, usual = [], QtWidgets.QInputDialog.getItem

    def answer(_parent, title, label, texts, *_):
        asked.append((title, label, texts))
        return texts[0], True

    QtWidgets.QInputDialog.getItem = answer
    try:
        Gui.runCommand("SheetMorph_FollowShape")
        yield from until(lambda: not plate.SourceChanged, "the part to follow")
    finally:
        QtWidgets.QInputDialog.getItem = usual
    ((title, label, texts),) = asked
    assert title == "Follow Shape" and "“second hole” was the round hole of 9 mm" in label, label
    assert "at (66, 20" in texts[0] and len(texts) == 2, texts
    along = api.rest_mesh(plate)[0][api.vertices(hole), 0]
    assert abs(0.5 * (along.min() + along.max()) - 66.0) < 1.0
    assert document.UndoNames[0] == "Follow Shape"


def found_parts() -> list:
    """All parts of the document."""
    morphs = [o for o in App.ActiveDocument.Objects if model.kind(o) == model.ASSEMBLY]
    return [found for morph in morphs for found in model.parts(morph)]


def wires_in_view() -> np.ndarray:
    """The places that are drawn as wires, global mm."""
    search = coin.SoSearchAction()
    search.setName(NAME)
    search.apply(view().getSceneGraph())
    node = search.getPath().getTail()
    kinds = coin.SoSearchAction()
    kinds.setType(coin.SoCoordinate3.getClassTypeId())
    kinds.apply(node)
    values = kinds.getPath().getTail().point.getValues()
    return np.array([value.getValue() for value in values])


def test_a_selector_is_typed_in_the_panel():
    yield from new_document()
    yield from start_morph()
    yield from press_tool("Mark Fixed Region…")
    where = {"half_space": {"point": [10, 0, 0], "normal": [-1, 0, 0]}}
    child("fold_advanced").setChecked(True)
    yield from settled()
    field = child("where")
    field.setFocus()
    yield from xdotool("type", "--delay", 15, json.dumps({**where, "holes": 9}))
    yield from xdotool("key", "Return")
    yield from settled()
    assert "9 holes expected" in child("message").text() or Gui.Control.activeDialog()
    assert not regions("fixed")
    field.clear()
    field.setFocus()
    yield from xdotool("type", "--delay", 15, json.dumps(where))
    yield from xdotool("key", "Return")
    yield from until(lambda: "vertices" in child("count").text(), "the pick")
    assert json.loads(field.text()) == where
    plane = wires_in_view()
    assert len(plane) == 4 and abs(plane[:, 0] - 10.0).max() < 1e-3
    yield from press("OK")
    region = regions("fixed")[-1]
    assert api.where(region) == where
    points = api.rest_mesh(part())[0]
    assert points[api.vertices(region), 0].max() <= 10.0
    assert App.ActiveDocument.UndoCount >= 1
