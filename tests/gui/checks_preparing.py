# SPDX-License-Identifier: LGPL-2.1-or-later
"""A mesh as CAD exports it is looked at when it is added, and cured when the user says so."""

import os

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
import numpy as np
from checks_propagation import Canceller
from checks_tutorial import answer, menu
from desk import WORK, activate, child, choose_below, enter, import_files, picture, press
from desk import press_tool, settled, tick, until, view
from freecad.sheetmorph import api
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.scene import mesh_preview
from hostile_traces import open_steps
from pivy import coin
from scenes import assembly, labelled, look, new_assembly, part

__all__ = [
    "test_what_cad_exports_is_diagnosed_when_it_is_added_and_cured_with_a_yes",
    "test_of_several_parts_the_one_is_named_and_shown",
    "test_the_view_fits_what_is_imported_from_step",
    "test_cancel_leaves_a_mesh_as_it_came",
    "test_a_preview_that_takes_long_is_cancelled",
    "test_every_unit_that_the_doctor_knows_is_offered",
    "test_a_mesh_in_metres_whose_facets_do_not_quite_meet_is_welded_and_scaled",
]


def write_in_metres(mesh, path: str) -> None:
    """Facets of a mesh in metres as ASCII STL, every second one 1e-7 beside its neighbours."""
    lines = []
    for k, facet in enumerate(mesh.Facets):
        corners = np.array(facet.Points) / 1000.0 + (0.0, 0.0, (k % 2) * 1e-7)
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x:.9f} {y:.9f} {z:.9f}" for x, y, z in corners]
        lines += ["endloop", "endfacet"]
    with open(path, "w") as file:
        file.write("\n".join(["solid plate", *lines, "endsolid plate", ""]))


def coarse_plate():
    """A plate of 160 x 80 x 2 mm with two holes as CAD exports it, made a morph."""
    import MeshPart
    import Part

    yield from activate()
    document = App.newDocument("Coarse")
    shape = Part.makeBox(160, 80, 2)
    for x in (35, 125):
        shape = shape.cut(Part.makeCylinder(10, 2, App.Vector(x, 40, 0)))
    source = document.addObject("Mesh::Feature", "Plate")
    source.Mesh = Mesh.Mesh(MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.05))
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(source)
    yield from settled()
    look()
    yield from press_tool("Create Morph")
    yield from settled()


def test_of_several_parts_the_one_is_named_and_shown():
    yield from new_assembly()
    wanted = labelled("bracket")
    before = view().getCameraNode().height.getValue()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(wanted)
    counts = {p.Label: p.ViewObject.RootNode.getNumChildren() for p in model.parts(assembly())}
    yield from press_tool("Prepare Mesh…")
    yield from until(Gui.Control.activeDialog, "the panel")
    assert wanted.Label in child("findings").text()
    more = {
        p.Label: p.ViewObject.RootNode.getNumChildren() - counts[p.Label]
        for p in model.parts(assembly())
    }
    assert {label for label, count in more.items() if count} == {wanted.Label}, more
    assert view().getCameraNode().height.getValue() < 0.95 * before
    assert all(is_in_view(corner) for corner in corners_of(wanted))
    picture("prepare-one-of-three")
    yield from press("Cancel")
    assert [p.ViewObject.RootNode.getNumChildren() for p in model.parts(assembly())] == list(
        counts.values()
    )


def corners_of(which) -> list:
    """The corners of the box around a part, global mm."""
    box = which.Mesh.BoundBox
    return [tuple(box.getPoint(k)) for k in range(8)]


def all_corners() -> list:
    """Those of all parts of the morph."""
    return [corner for each in model.parts(assembly()) for corner in corners_of(each)]


def is_in_view(point) -> bool:
    """Whether a point is within the 3D view."""
    x, y = view().getPointOnScreen(App.Vector(*point))
    width, height = view().getSize()
    return 0 <= x < width and 0 <= y < height


def write_step(path: str) -> None:
    """Two plates beside each other, far from the origin."""
    import Part

    boxes = [Part.makeBox(60, 40, 2, App.Vector(x, 900, 50)) for x in (1000, 1080)]
    Part.makeCompound(boxes).exportStep(path)


def test_the_view_fits_what_is_imported_from_step():
    path = os.path.join(WORK, "plates.step")
    write_step(path)
    yield from activate()
    App.newDocument("Step")
    view().viewIsometric()
    yield from import_files([path], 8.0, lambda: len(App.ActiveDocument.Objects) > 3)
    yield from until(lambda: all(map(is_in_view, all_corners())), "all of both in the view")
    (one, _), (other, _) = (view().getPointOnScreen(App.Vector(x, 920, 51)) for x in (1000, 1140))
    assert len(all_corners()) == 16
    assert abs(other - one) > 0.3 * view().getSize()[1], (one, other, view().getSize())
    picture("imported-from-step")


def is_previewed() -> bool:
    """Whether another mesh is drawn in place of the part."""
    return coin.SoNode.getByName(mesh_preview.NAME) is not None


def test_what_cad_exports_is_diagnosed_when_it_is_added_and_cured_with_a_yes():
    yield from coarse_plate()
    yield from until(Gui.Control.activeDialog, "the panel")
    assert not open_steps() and App.ActiveDocument.UndoNames == ["Create Morph"]
    found = child("findings").text()
    assert "slivers" in found and "2 mm thick" in found, found
    assert child("remesh").isChecked() and child("thin").isChecked()
    facets = part().Source.Mesh.CountFacets
    source = part().Source
    holes = api.add_through_holes(assembly(), part())
    App.ActiveDocument.recompute()
    App.ActiveDocument.clearUndos()
    yield from enter(child("edge"), "4 mm")
    yield from choose_below(child("rims"), 1)
    yield from press("Preview")
    yield from until(is_previewed, "the preview")
    assert "rims fitted to their circles" in child("message").text()
    assert part().Source.Mesh.CountFacets == facets
    picture("prepare")
    yield from press("OK")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel closed")
    assert not is_previewed()
    assert part().Original == source and source.Mesh.CountFacets == facets
    assert part().Source.Mesh.CountFacets > 2 * facets
    found, _ = api.thin_solid(part())
    picked = sorted(api.vertices(hole) for hole in holes)
    assert picked == sorted(hole.vertices.tolist() for hole in found.holes)
    assert App.ActiveDocument.UndoCount == 1
    App.ActiveDocument.undo()
    assert part().Source == source and part().Original is None


def test_cancel_leaves_a_mesh_as_it_came():
    yield from coarse_plate()
    before = [obj.Name for obj in App.ActiveDocument.Objects]
    undos = App.ActiveDocument.UndoCount
    yield from press("Preview")
    yield from until(is_previewed, "the preview")
    yield from tick(child("thin"))
    yield from press("Cancel")
    assert not is_previewed()
    assert [obj.Name for obj in App.ActiveDocument.Objects] == before
    assert App.ActiveDocument.UndoCount == undos
    yield from press_tool("Prepare Mesh…")
    assert child("remesh").isChecked()
    yield from press("Cancel")


def test_a_preview_that_takes_long_is_cancelled():
    yield from coarse_plate()
    with Canceller():
        yield from press("Preview")
        yield from until(lambda: "Cancelled" in child("message").text(), "the panel to say so")
    assert not is_previewed()
    yield from press("Cancel")


def test_every_unit_that_the_doctor_knows_is_offered():
    """The right one is proposed where it is certain; the user may choose another one."""
    from sheetmorph.base.file_unit import UNITS

    yield from coarse_plate()
    offered = [child("unit").itemText(k) for k in range(child("unit").count())]
    assert offered == [name for name in UNITS if name != "mm"], offered
    for unit in offered:
        yield from until(lambda: child("scale").isVisible(), "the panel")
        child("scale").setChecked(True)
        child("unit").setCurrentText(unit)
        child("unit").activated.emit(child("unit").currentIndex())
        child("remesh").setChecked(False)
        before = np.ptp(api.rest_mesh(part())[0], axis=0) / api.preparing.scale_of(part())
        yield from press("OK")
        yield from until(lambda: not Gui.Control.activeDialog(), "the panel closed")
        now = np.ptp(api.rest_mesh(part())[0], axis=0)
        assert np.allclose(now, UNITS[unit] * before, rtol=1e-6), (unit, now, before)
        assert api.preparation_of(part())["scale"] == UNITS[unit]
        App.ActiveDocument.undo()
        yield from settled()
        yield from press_tool("Prepare Mesh…")
    yield from press("Cancel")


def test_a_mesh_in_metres_whose_facets_do_not_quite_meet_is_welded_and_scaled():
    yield from coarse_plate()
    yield from press("Cancel")
    path = os.path.join(WORK, "metres.stl")
    write_in_metres(part().Source.Mesh, path)
    yield from menu("SheetMorph", "Import Part…")
    yield from answer(path)
    yield from settled()
    assert child("scale").isChecked() and child("weld").isChecked()
    assert child("unit").currentText() == "m"
    found = child("findings").text()
    assert "unit seems to be m" in found and "nearly the same place" in found, found
    assert child("tolerance").text() == "0.0002 mm", child("tolerance").text()
    yield from enter(child("tolerance"), "soon")
    yield from press("Preview")
    assert "Enter a distance for merging vertices" in child("message").text()
    yield from enter(child("tolerance"), "0.0002 mm")
    assert "2 mm thick" in found and child("edge").text().endswith("mm"), found
    picture("prepare-metres")
    yield from press("OK")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel closed")
    points, triangles = api.rest_mesh(model.parts(assembly())[1])
    assert abs(np.ptp(points, axis=0) - (160, 80, 2)).max() < 1e-3
    edges = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()
