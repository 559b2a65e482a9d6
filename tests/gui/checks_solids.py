# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a STEP file to a STEP file by menus, mouse and keyboard, and what Cancel leaves of it."""

import os

import FreeCAD as App
import numpy as np
import Part
from checks_enclosure import is_quiet
from checks_finding import rows_shown
from checks_flow import draw_region, drag_arrow_up, look, loop_round, select
from checks_propagation import dialog
from checks_tutorial import answer, choose, menu
from desk import (
    WORK,
    activate,
    child,
    click_widget,
    enter,
    picture,
    press,
    report_view,
    settled,
    until,
)
from freecad.sheetmorph import api
from hostile_panels import is_shown
from hostile_traces import open_steps
from PySide import QtGui
from scenes import assembly, part, regions

__all__ = [
    "test_the_edge_of_a_cad_file_takes_units_and_is_asked_for_again",
    "test_a_step_file_is_bent_and_written_as_step",
    "test_cancel_while_a_shape_is_made_leaves_nothing",
]

Vector = App.Vector
RADII = (4.0, 5.0, 5.0)


def bracket() -> Part.Shape:
    """A sheet of 2 mm, 50 mm wide, its end bent up with an inner radius of 3 mm; three holes."""
    ends = [(0, 2), (90, 2), (93, 5), (93, 40), (95, 40), (95, 5), (90, 0), (0, 0)]
    ends = [Vector(x, 0, z) for x, z in ends]
    sides = [Part.LineSegment(ends[k], ends[(k + 1) % 8]) for k in (0, 2, 3, 4, 6, 7)]
    slant = 0.5**0.5
    for radius, k in ((3, 1), (5, 5)):
        middle = Vector(90 + radius * slant, 0, 5 - radius * slant)
        sides.append(Part.Arc(ends[k], middle, ends[k + 1]))
    edges = Part.__sortEdges__([side.toShape() for side in sides])
    shape = Part.Face(Part.Wire(edges)).extrude(Vector(0, 50, 0))
    for x in (30, 65):
        shape = shape.cut(Part.makeCylinder(5, 4, Vector(x, 25, -1)))
    return shape.cut(Part.makeCylinder(4, 4, Vector(92, 25, 25), Vector(1, 0, 0)))


def import_step(path: str, edge: str):
    """Import Part…: the file, then how long the edges of its mesh may be."""
    yield from menu("SheetMorph", "Import Part…")
    yield from choose(path)
    asked = lambda: isinstance(  # noqa: E731
        QtGui.QApplication.activeModalWidget(), QtGui.QInputDialog
    )
    yield from until(asked, "the question for the edges")
    yield from answer(edge)


def question() -> str:
    """What an input dialog asks that waits, empty without one."""
    box = QtGui.QApplication.activeModalWidget()
    return box.labelText() if isinstance(box, QtGui.QInputDialog) else ""


def test_the_edge_of_a_cad_file_takes_units_and_is_asked_for_again():
    path = os.path.join(WORK, "edges.step")
    Part.makeBox(60, 40, 2).exportStep(path)
    yield from activate()
    yield from menu("File", "Std_New")
    yield from menu("SheetMorph", "Import Part…")
    yield from choose(path)
    for typed in ("soon", "-3 mm", "2 kg"):
        yield from until(question, "the question")
        yield from choose(typed)
        yield from until(lambda told=typed: told in question(), "the question again")
    yield from answer("0.8 cm")
    yield from until(lambda: len(App.ActiveDocument.Objects) > 2, "the part")
    points, triangles = api.rest_mesh(part())
    edges = np.linalg.norm(points[triangles] - points[np.roll(triangles, 1, axis=1)], axis=2)
    assert 4.0 < edges.max() < 12.0, edges.max()


def mark_the_ends():
    """The left edge stays, the upper edge of the end that is bent up is the handle."""
    points = api.rest_mesh(part())[0]
    yield from look("Front")
    held, pulled = points[points[:, 0] < 1e-6], points[points[:, 2] > 40 - 1e-6]
    for command, chosen in (("Mark Fixed Region…", held), ("Mark Handle…", pulled)):
        figure = [loop_round(chosen, (0, 2), 1.5)[k] for k in (0, 2)]
        yield from draw_region(part(), command, "rectangle", figure)
    yield from look("Isometric")


def keep_the_holes():
    """Find Features…, and all that is found."""
    yield from menu("SheetMorph", "Find Features…")
    yield from until(is_shown, "the panel")
    yield from until(lambda: rows_shown() > 0, "what is found")


def drag_and_type():
    """Move Handle…: drags the arrow that points up, then types."""
    select(regions("handle")[0])
    yield from menu("SheetMorph", "Move Handle…")
    yield from until(is_shown, "the panel")
    yield from drag_arrow_up()
    yield from enter(child("translation_z"), "10 mm")
    yield from enter(child("translation_x"), "6 mm")
    yield from settled()


def radii(shape) -> list[float]:
    """The radii of the round holes of a shape, ascending; bends have none."""
    walls = [face for face in shape.Faces if isinstance(face.Surface, Part.Cylinder)]
    holes = [face for face in walls if any(edge.isClosed() for edge in face.Edges)]
    return sorted(face.Surface.Radius for face in holes)


def test_a_step_file_is_bent_and_written_as_step():
    path = os.path.join(WORK, "bracket.step")
    bracket().exportStep(path)
    yield from activate()
    yield from menu("File", "Std_New")
    yield from import_step(path, "3")
    yield from mark_the_ends()
    yield from keep_the_holes()
    picture("solid-found")
    yield from press("OK")
    yield from until(lambda: len(regions("form feature")) == 3, "three holes")
    yield from drag_and_type()
    picture("solid-moved")
    yield from press("OK")
    select(part())
    yield from menu("SheetMorph", "Deformed Shape")
    yield from until(lambda: part().DeformedShape and is_quiet(), "the shape")
    shape = part().DeformedShape.Shape
    assert shape.isValid() and shape.isClosed()
    assert np.allclose(radii(shape), RADII, rtol=0.0, atol=1e-12), radii(shape)
    picture("solid-shape")
    folder = os.path.join(WORK, "written")
    os.makedirs(folder, exist_ok=True)
    yield from menu("SheetMorph", "Export Parts…")
    yield from answer(folder)
    yield from until(lambda: "parts written" in report_view(), "the files")
    (step,) = [name for name in os.listdir(folder) if name.endswith(".step")]
    read = Part.read(os.path.join(folder, step))
    assert read.isValid() and len(read.Solids) == 1 and len(read.Faces) == len(shape.Faces)
    assert np.allclose(radii(read), RADII, rtol=0.0, atol=1e-12), radii(read)
    assert read.BoundBox.ZMax > 49.0, read.BoundBox


def bent_sieve():
    """A plate with 150 holes, bent: long enough to be waited for."""
    shape = Part.makeBox(300, 200, 2)
    for x in range(15):
        for y in range(10):
            place = Vector(10 + 20 * x, 10 + 20 * y, -1)
            shape = shape.cut(Part.makeCylinder(3, 4, place))
    document = App.newDocument("Sieve")
    source = document.addObject("Part::Feature", "Sieve")
    source.Shape = shape
    morph = api.create_assembly(document)
    (made,) = api.add_shape(morph, source, "sieve", {"edge": 8.0})
    points = api.rest_mesh(made)[0]
    api.add_fixed(morph, made, np.flatnonzero(points[:, 0] < 1e-6))
    tip = np.flatnonzero(points[:, 0] > 300 - 1e-6)
    api.set_motion(api.add_handle(morph, made, tip), (0, 0, 60))
    document.recompute()
    document.clearUndos()
    yield from look("Isometric")


def progress():
    """Waits for the progress of what was asked for."""
    yield from until(lambda: dialog() is not None and dialog().isVisible(), "the progress")


def cancel(name: str):
    """Waits for the progress and presses its Cancel with the mouse."""
    yield from progress()
    picture(name)
    (button,) = dialog().findChildren(QtGui.QPushButton)
    yield from click_widget(button)
    yield from until(is_quiet, "the end")
    yield from settled()


def test_cancel_while_a_shape_is_made_leaves_nothing():
    yield from activate()
    yield from bent_sieve()
    before = [obj.Name for obj in App.ActiveDocument.Objects]
    select(part())
    yield from menu("SheetMorph", "Deformed Shape", waits=progress)
    yield from cancel("shape-cancelled")
    assert part().DeformedShape is None
    assert [obj.Name for obj in App.ActiveDocument.Objects] == before
    assert App.ActiveDocument.UndoCount == 0 and not open_steps()
    # A shape that is there already is made again by Export Parts, and that is cancelled, too.
    shape = App.ActiveDocument.addObject("Part::Feature", "Shape")
    part().DeformedShape = shape
    folder = os.path.join(WORK, "cancelled")
    os.makedirs(folder, exist_ok=True)
    yield from menu("SheetMorph", "Export Parts…")
    yield from choose(folder)
    yield from cancel("export-cancelled")
    assert os.listdir(folder) == []
    assert shape.Shape.isNull() and assembly() is not None
