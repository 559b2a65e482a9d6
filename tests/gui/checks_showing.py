# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is shown while a handle is dragged: ghost, features, colours with their scale, gaps."""

import contextlib
import gc
import sys

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from checks_dragging import drag_up, grab_up_arrow
from checks_moving import lifted, open_panel
from desk import child, choose_below, colour_at, enter, picture, press, settled, tick, until, view
from desk import xdotool
from freecad.sheetmorph.interaction import live_scene
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import drawing
from pivy import coin
from PySide import QtGui
from scenes import drawn, handle_vertices, largest, new_assembly, new_morph, part, regions, stored

__all__ = [
    "test_a_deformed_shape_is_out_of_sight_while_its_part_moves",
    "test_a_ghost_of_what_has_not_moved_is_never_seen",
    "test_the_original_stays_as_a_ghost_while_the_part_moves",
    "test_a_part_that_is_hidden_while_it_is_moved_is_seen_no_more",
    "test_creases_stay_crisp_while_dragging_and_at_rest",
    "test_without_the_compiled_view_everything_is_drawn_through_pivy",
    "test_features_say_how_far_they_move",
    "test_displacement_has_colours_with_a_scale",
    "test_quality_and_gaps_have_colours_too",
    "test_steel_is_a_preview_first_and_its_stretch_has_colours",
    "test_a_part_at_rest_is_laid_flat_as_a_sketch_and_undone",
]


def found(node_type, root) -> list:
    """All nodes of a type below a root, also where a switch is off."""
    search = coin.SoSearchAction()
    search.setType(node_type.getClassTypeId())
    search.setSearchingAll(True)
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(root)
    paths = search.getPaths()
    return [paths[k].getTail() for k in range(paths.getLength())]


def positions_in(node) -> np.ndarray:
    """The positions (n, 3) in an SoCoordinate3."""
    return np.array([p.getValue() for p in node.point.getValues()]).reshape(-1, 3)


def vertex_colours() -> np.ndarray:
    """The colours (n, 3) of the vertices of the part that is seen."""
    materials = found(coin.SoMaterial, part().ViewObject.RootNode)
    fields = [m.diffuseColor for m in materials if m.diffuseColor.getNum() == len(drawn())]
    assert len(fields) == 1, len(fields)
    return np.array([c.getValue() for c in fields[0].getValues()])


def legend_in_the_view() -> str:
    """What the legend over the 3D view says, empty without one."""
    frames = Gui.getMainWindow().findChildren(QtGui.QFrame, "SheetMorphLegend")
    labels = [w for frame in frames for w in frame.findChildren(QtGui.QLabel)]
    return " ".join(label.text() for label in labels if label.isVisible())


def test_a_deformed_shape_is_out_of_sight_while_its_part_moves():
    """It shows the pose before. Where it alone is shown, the part is drawn in its place."""
    yield from new_morph()
    shape = App.ActiveDocument.addObject("Part::Box", "Shape")
    part().DeformedShape = shape
    App.ActiveDocument.recompute()
    root, switch = shape.ViewObject.RootNode, shape.ViewObject.SwitchNode
    for is_part_shown in (True, False):
        part().ViewObject.Visibility = is_part_shown
        yield from open_panel()
        yield from enter(child("translation_z"), "9")
        yield from settled()
        assert root.findChild(switch) < 0, "the shape is still drawn"
        assert is_preview_seen()
        assert shape.ViewObject.Visibility and part().ViewObject.Visibility == is_part_shown
        shape.ViewObject.Visibility = False
        yield from settled()
        assert is_preview_seen() == is_part_shown, "who hides both sees none"
        shape.ViewObject.Visibility = True
        yield from press("Cancel")
        yield from until(lambda: root.findChild(switch) >= 0, "the shape to be drawn again")


def is_preview_seen() -> bool:
    """Whether the drawing in place of the part is switched on."""
    children = part().ViewObject.RootNode.getChildren()
    kinds = [node for node in children if node.isOfType(coin.SoSwitch.getClassTypeId())]
    return kinds[-1].whichChild.getValue() == coin.SO_SWITCH_ALL


def test_a_ghost_of_what_has_not_moved_is_never_seen():
    """A frame is exact to a millionth of the size: which of the two lay in front changed."""
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("translation_x"), "0.001")  # so that the preview is drawn
    yield from settled()
    gc.collect()  # scenes of tests before
    (scene,) = [one for one in gc.get_objects() if isinstance(one, live_scene.LiveScene)]
    rest, draw = scene._live.parts[part().Name], np.random.default_rng(37)
    noise = 1e-6 * np.linalg.norm(np.ptp(rest.points, axis=0))
    for turn in range(3):
        turned = App.Rotation(App.Vector(0.3, 0.2, 1.0), 7.0 * turn)
        view().setCameraOrientation(turned.multiply(view().getCameraOrientation()).Q)
        shots = []
        for is_shown in (False, True, True):
            child("original").setChecked(is_shown)
            yield from settled()
            moved = rest.points + draw.uniform(-noise, noise, rest.points.shape)
            scene._previews[part().Name].show(moved, rest.frame)
            view().redraw()
            yield from settled()
            shots.append(pixels(picture(f"ghost-{turn}-{len(shots)}")))
        for shot in shots[1:]:
            differing = (np.abs(shots[0] - shot).max(axis=2) > 12).mean()
            assert differing < 2e-3, f"view {turn}: {differing:.2%} of the pixels show the ghost"
    child("original").setChecked(False)
    yield from press("Cancel")


def pixels(path: str) -> np.ndarray:
    """The colours of the 3D view in a picture of the screen, (h, w, 3)."""
    widget = view().graphicsView().viewport()
    corner = widget.mapToGlobal(widget.rect().topLeft())
    image = QtGui.QImage(path).copy(corner.x(), corner.y(), widget.width(), widget.height())
    image = image.convertToFormat(QtGui.QImage.Format_RGB32)
    flat = np.frombuffer(bytes(image.constBits()), np.uint8)
    return flat.reshape(image.height(), image.width(), 4)[:, :, :3].astype(int)


def test_the_original_stays_as_a_ghost_while_the_part_moves():
    yield from new_morph()
    rest = stored()
    yield from open_panel()
    yield from tick(child("original"))
    start = yield from grab_up_arrow()
    yield from drag_up(start, 8)
    picture("ghost")
    yield from until(lambda: lifted(rest, drawn())[0, 2] > 3, "the drag")
    shapes = found(coin.SoCoordinate3, part().ViewObject.RootNode)
    at_rest = [s for s in shapes if s.point.getNum() == len(rest)]
    assert any(np.array_equal(positions_in(s), rest.astype(np.float32)) for s in at_rest)
    yield from xdotool("mouseup", 1)
    yield from press("Cancel")
    assert len(found(coin.SoCoordinate3, part().ViewObject.RootNode)) < len(shapes)


def test_a_part_that_is_hidden_while_it_is_moved_is_seen_no_more():
    yield from new_morph()
    place = (20.5, 12.0, 0.0)
    seen = colour_at(place)
    yield from open_panel()
    yield from enter(child("translation_z"), "9")
    yield from settled()
    moved = colour_at(place)
    Gui.Selection.addSelection(part())
    Gui.runCommand("Std_ToggleVisibility")
    Gui.Selection.clearSelection()
    yield from settled()
    ground = colour_at(place)
    assert differ(seen, ground) > 12 and differ(moved, ground) > 12, (seen, moved, ground)
    yield from press("Cancel")
    assert not part().ViewObject.Visibility and differ(colour_at(place), ground) < 4
    part().ViewObject.Visibility = True
    yield from settled()
    assert differ(colour_at(place), seen) < 4


def differ(one, other) -> int:
    """How far two colours are apart."""
    return max(abs(a - b) for a, b in zip(one, other))


def indices_in(field) -> np.ndarray:
    """The triangles (m, 3) of an index field, each closed by -1."""
    return np.array(field.getValues()).reshape(-1, 4)[:, :3]


def corner_faults() -> np.ndarray:
    """How far the normals (m, 3) that are drawn turn from those of their triangles, degrees."""
    root = part().ViewObject.RootNode
    (normals,) = [n for n in found(coin.SoNormal, root) if n.vector.getNum() > len(drawn()) // 2]
    faces = [f for f in found(coin.SoIndexedFaceSet, root) if f.normalIndex.getNum() > 1]
    faces = [f for f in faces if f.normalIndex.getNum() == f.coordIndex.getNum()]
    triangles, corners = (
        indices_in(field) for field in (faces[-1].coordIndex, faces[-1].normalIndex)
    )
    a, b, c = (drawn()[triangles[:, k]] for k in range(3))
    flat = np.cross(b - a, c - a)
    flat /= np.linalg.norm(flat, axis=1)[:, None]
    shown = np.array([v.getValue() for v in normals.vector.getValues()])[corners]
    return np.degrees(np.arccos(np.clip(np.einsum("mkx,mx->mk", shown, flat), -1.0, 1.0)))


def test_creases_stay_crisp_while_dragging_and_at_rest():
    yield from new_morph()
    rest = stored()
    at_rest = [
        h.creaseAngle.getValue() for h in found(coin.SoShapeHints, part().ViewObject.RootNode)
    ]
    assert at_rest and max(at_rest) < 1.0, "the folds of a right angle are edges"
    yield from open_panel()
    start = yield from grab_up_arrow()
    yield from drag_up(start, 8)
    yield from until(lambda: largest(drawn() - rest) > 3, "the drag")
    assert corner_faults().max() < 30.0, "at the folds normals would be 45 degrees off"
    picture("creases")
    yield from xdotool("mouseup", 1)
    yield from press("Cancel")


@contextlib.contextmanager
def without_compiled_view():
    """As if the module `_coin` had been left out of the build, or were for another Coin."""
    had = sys.modules.get("sheetmorph._coin")
    sys.modules["sheetmorph._coin"] = None
    drawing.chosen.cache_clear()
    try:
        yield
    finally:
        del sys.modules["sheetmorph._coin"]
        if had is not None:
            sys.modules["sheetmorph._coin"] = had
        drawing.chosen.cache_clear()


def test_without_the_compiled_view_everything_is_drawn_through_pivy():
    with without_compiled_view():
        yield from new_morph()
        rest = stored()
        yield from open_panel()
        start = yield from grab_up_arrow()
        yield from drag_up(start, 8)
        yield from until(lambda: largest(drawn() - rest) > 3, "the drag")
        yield from xdotool("mouseup", 1)
        assert drawing.drawer() is drawing.ThroughPivy
        assert corner_faults().max() < 30.0
        yield from tick(child("original"))
        yield from choose_below(child("colours"), 1)
        yield from until(child("scale").isVisible, "the scale")
        assert len(np.unique(vertex_colours(), axis=0)) > 9
        picture("through_pivy")
        seen = drawn()
        yield from press("OK")
    assert largest(stored() - seen) < 1e-3


def test_features_say_how_far_they_move():
    yield from new_morph()
    yield from open_panel()
    yield from tick(child("feature_motions"))
    yield from enter(child("translation_z"), "20")
    yield from settled()
    picture("features")
    texts = found(coin.SoText2, view().getSceneGraph())
    words = [text.string.getValues()[0] for text in texts]
    said = [word for word in words if "mm" in word and "°" in word]
    assert len(said) == 2 and all(5.0 < float(word.split()[0]) < 20.0 for word in said), words
    yield from press("OK")
    left = found(coin.SoText2, view().getSceneGraph())
    assert len(left) == len(texts) - 2


def test_displacement_has_colours_with_a_scale():
    yield from new_morph()
    yield from open_panel()
    yield from enter(child("translation_z"), "18")
    yield from choose_below(child("colours"), 1)
    yield from until(child("scale").isVisible, "the scale")
    assert child("scale_text").text() == "0–20 mm; largest displacement 18 mm on sheet morphed"
    seen = vertex_colours()
    moved, fixed = seen[handle_vertices()], seen[np.flatnonzero(stored()[:, 0] == 0.0)]
    assert np.ptp(moved, axis=0).max() < 0.01 and moved[0, 0] > 0.7  # yellow
    assert np.ptp(fixed, axis=0).max() < 0.01 and fixed[0, 2] > fixed[0, 1]  # blue
    assert "largest displacement 18 mm" in legend_in_the_view()

    def shows_values() -> bool:
        red, green, _ = colour_at((120.0, 8.0, 33.0))
        return green > 0.75 * red

    yield from until(shows_values, "values on the handle in place of its colour")
    picture("displacement")
    yield from choose_below(child("colours"), -1)
    assert not child("scale").isVisible() and "mm" not in legend_in_the_view()
    yield from press("Cancel")
    assert legend_in_the_view() == ""


def test_quality_and_gaps_have_colours_too():
    yield from new_assembly(is_joined=True)
    yield from open_panel()
    yield from enter(child("translation_z"), "25")
    yield from choose_below(child("colours"), 2)
    yield from until(lambda: "smallest corner" in child("scale_text").text(), "the quality")
    assert child("scale_text").text().startswith("0–60 °; ")
    yield from choose_below(child("colours"), 1)
    yield from until(lambda: "largest change" in child("scale_text").text(), "the gaps")
    picture("gaps")
    change = float(child("scale_text").text().split("largest change ")[1].split()[0])
    assert 0.0 < change < 1.0
    yield from press("OK")
    assert largest(drawn() - stored()) == 0.0


def marks_of_places() -> int:
    """How many worst places are marked in the view."""
    root = Gui.ActiveDocument.ActiveView.getSceneGraph()
    marks = [n for n in found(coin.SoAnnotation, root) if n.getName() == live_scene.PLACES]
    return sum(n.numPoints.getValue() for mark in marks for n in found(coin.SoPointSet, mark))


def test_steel_is_a_preview_first_and_its_stretch_has_colours():
    yield from new_morph()
    model.assembly_of(regions("handle")[0]).Energy = "steel"
    App.ActiveDocument.recompute()
    yield from open_panel()
    yield from enter(child("translation_z"), "18")
    previews = "Linear preview", "Computing steel shape"
    yield from until(lambda: child("status").text().startswith(previews), "the preview")
    yield from until(lambda: "Final steel shape" in child("status").text(), "the steel")
    yield from choose_below(child("colours"), 4)
    yield from until(lambda: "stretch" in child("scale_text").text(), "the stretch")
    assert ", near " in child("scale_text").text(), child("scale_text").text()
    assert "Final steel shape" in child("status").text(), child("status").text()
    assert marks_of_places() > 0
    picture("stretch")
    yield from choose_below(child("colours"), -4)
    yield from until(lambda: not child("scale_text").isVisible(), "the colours gone")
    assert marks_of_places() == 0
    yield from press("OK")
    assert largest(drawn() - stored()) == 0.0


def test_a_part_at_rest_is_laid_flat_as_a_sketch_and_undone():
    yield from new_morph()
    before = {entry.Name for entry in App.ActiveDocument.Objects}
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(part())
    Gui.runCommand("SheetMorph_Flatten")
    yield from settled()
    made = [entry for entry in App.ActiveDocument.Objects if entry.Name not in before]
    sketches = [entry for entry in made if entry.isDerivedFrom("Sketcher::SketchObject")]
    assert len(sketches) == 2, [entry.Label for entry in made]  # and its bend lines
    assert sketches[0].Shape.BoundBox.XMin > part().Mesh.BoundBox.XMax, "the part hides the blank"
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()
    picture("flattened")
    App.ActiveDocument.undo()
    assert {entry.Name for entry in App.ActiveDocument.Objects} == before
