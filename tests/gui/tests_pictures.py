# SPDX-License-Identifier: LGPL-2.1-or-later
"""Takes the pictures of panels in the user guide, doing what it says: `./sheetmorph test pictures`.

They go to the folder that SHEETMORPH_PICTURES names, else beside the other pictures of a run.
"""

import os
import subprocess

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
from checks_dragging import drag_up, grab_up_arrow
from checks_finding import bare_frame, cell_place
from checks_flow import bring_beside_the_panel, drag_arrow_up, loop_round, select, stroke_along
from checks_measuring import close_sections, measure_ends, show_section
from checks_moving import open_panel
from checks_preparing import coarse_plate, is_previewed
from checks_propagation import click_row
from checks_snapping import marked
from checks_solids import bracket, drag_and_type, import_step, keep_the_holes, mark_the_ends
from checks_steel import choose_property
from checks_reach import is_marked
from checks_study import mirror_study
from checks_thickness import is_drawn, thin_plate
from checks_tutorial import mark, menu, near_edge
from desk import WORK, activate, child, choose_below, click_widget, draw_along, enter, on_screen
from desk import panel, picture, press, press_tool, settled, show_docks, tick, until, view, xdotool
from freecad.sheetmorph import api, paths
from freecad.sheetmorph.api.features import shape_of
from freecad.sheetmorph.commands import exchange
from hostile_panels import is_shown
from PySide import QtCore, QtGui
from scenes import assembly, contacts, look, new_assembly, new_morph, part, regions

FOLDER = os.environ.get("SHEETMORPH_PICTURES", WORK)
WIDTH = 1100  # px
COLOURS = 128
FRAMES = 16  # of the animation, on the way up; the way back shows them again
LIFT, TURN = 70.0, 12.0  # mm, degrees
MOVIE = ["-resize", "720x", "-fuzz", "2%", "+dither", "-colors", "64", "-layers", "optimize"]


def taken(name: str, with_panel: bool = True):
    """The task view, if wanted, and the 3D view as they are now, as a picture of the guide."""
    yield from settled()  # what the last click has asked for is drawn
    docks = Gui.getMainWindow().findChildren(QtGui.QDockWidget) if with_panel else []
    docks = [dock for dock in docks if dock.isAncestorOf(panel())]
    crop = crop_of(*docks, Gui.getMainWindow().findChild(QtGui.QMdiArea))
    command = ["convert", picture(f"whole-{name}"), *crop, "-resize", f"{WIDTH}>"]
    path = os.path.join(FOLDER, f"{name}.png")
    subprocess.run([*command, "-colors", str(COLOURS), "-strip", f"PNG8:{path}"], check=True)
    assert os.path.getsize(path) > 10_000


def crop_of(*widgets) -> list[str]:
    """The words for ImageMagick that cut widgets out of a picture of the screen."""
    box = QtCore.QRect()
    for widget in widgets:
        box |= QtCore.QRect(widget.mapToGlobal(QtCore.QPoint(0, 0)), widget.size())
    return ["-crop", f"{box.width()}x{box.height()}+{box.x()}+{box.y()}", "+repage"]


def large_view():
    """Nothing below the 3D view; the mouse is away from it."""
    yield from activate()
    for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
        if dock.objectName() in ("Report view", "Python console"):
            dock.hide()
    yield from settled()


def cover():
    """The cover of the door mirror, seen from the front."""
    yield from large_view()
    document = App.newDocument("Mirror")
    morph = api.create_assembly(document)
    api.import_part(morph, os.path.join(paths.examples(), "door_mirror", "cover.obj"))
    document.recompute()
    view().viewFront()
    Gui.SendMsgToActiveView("ViewFit")
    yield from settled()


def test_the_menu_and_the_tree():
    """A submenu, the toolbars, and the regions and contacts below their parts."""
    yield from large_view()
    yield from new_assembly(is_joined=True)
    show_docks()
    for tree in Gui.getMainWindow().findChildren(QtGui.QTreeWidget):
        tree.expandAll()
    yield from menu("SheetMorph", "Motion")
    path = os.path.join(FOLDER, "menu.png")
    crop = ["-crop", "760x470+0+20", "+repage", "-colors", str(COLOURS), "-strip"]
    subprocess.run(["convert", picture("whole-menu"), *crop, f"PNG8:{path}"], check=True)
    yield from xdotool("key", "Escape", "key", "Escape")
    assert os.path.getsize(path) > 10_000


def test_the_first_five_minutes():
    yield from cover()
    yield from mark("Mark Fixed Region…", near_edge(-1.0))
    yield from press("OK")
    yield from menu("SheetMorph", "Guide")
    yield from until(is_shown, "the guide")
    yield from taken("guide")
    yield from press("Close")
    yield from mark("Mark Handle…", near_edge(1.0))
    yield from press("OK")
    yield from menu("SheetMorph", "Mark Form Features…")
    yield from enter(child("rings"), "1")
    yield from click_widget(child("holes"))
    yield from taken("picking")
    yield from press("OK")
    yield from menu("SheetMorph", "Move Handle…")
    yield from until(is_shown, "the panel")
    yield from enter(child("translation_z"), "30 mm")
    yield from enter(child("angle"), "-15")
    yield from click_widget(child("along_y"))
    yield from settled()
    yield from taken("panel")
    yield from choose_below(child("colours"), 1)
    yield from until(child("scale").isVisible, "the scale")
    yield from taken("dragging")
    yield from press("OK")
    yield from feature_settings()


def feature_settings():
    """The largest hole slides in a plane and gets another size."""
    hole = max(regions("form feature"), key=lambda one: shape_of(one).size)
    select(hole)
    yield from settled()
    yield from press_tool("Form Feature Settings…")
    yield from choose_below(child("motion"), 3)
    yield from tick(child("has_size"))
    yield from enter(child("feature_size"), "30 mm")
    yield from settled()
    yield from taken("feature")
    yield from press("Cancel")


def test_figures():
    yield from cover()
    points = api.rest_mesh(part())[0]
    share = (points[:, 0] - points[:, 0].min()) / np.ptp(points[:, 0])
    lasso = loop_round(points[share < 0.12], (0, 2), 4.0)
    for tool, figure in (("lasso", lasso), ("brush", stroke_along(points[share > 0.9], 2))):
        select(part())
        yield from press_tool("Mark Fixed Region…")
        yield from click_widget(child(tool))
        yield from tick(child("through"))
        yield from draw_along(figure)
        yield from taken(f"picking-{tool}")
        yield from press("Cancel")


def test_other_parts_follow():
    yield from large_view()
    assert exchange.open_recipe(exchange.example_recipes()["Welded Frame"], "Frame")
    look()
    yield from settled()
    (old,) = [c for c in contacts() if c.Label == "stringer right - seat plate"]
    sides = (old.PartA, old.PartB)
    App.ActiveDocument.removeObject(old.Name)
    App.ActiveDocument.recompute()
    Gui.Selection.clearSelection()
    for each in sides:
        Gui.Selection.addSelection(each)
    yield from press_tool("Mark Contact…")
    yield from until(is_shown, "the panel")
    yield from taken("contact")
    yield from press("OK")
    yield from until(lambda: not Gui.Control.activeDialog(), "the panel to close")
    yield from press_tool("Propagation…")
    yield from until(is_shown, "the panel")
    yield from tick(child("meshes"))
    yield from click_row(contacts()[-1].Label)
    yield from taken("propagation")
    yield from press("Close")
    yield from open_panel()
    yield from click_widget(child("reset"))  # the example comes moved
    yield from settled()
    yield from drag_arrow_up(40)
    yield from taken("frame-dragged")
    yield from press("Cancel")


def test_the_animation_of_the_readme():
    """The frame while its front end is lifted and turned, and comes back."""
    yield from large_view()
    assert exchange.open_recipe(exchange.example_recipes()["Welded Frame"], "Frame")
    look()
    yield from settled()
    yield from open_panel()
    yield from click_widget(child("reset"))  # the example comes moved
    yield from bring_beside_the_panel()
    yield from click_widget(child("along_y"))
    shots = []
    for share in np.linspace(0.0, 1.0, FRAMES):
        child("translation_z").setValue(LIFT * share)
        child("angle").setValue(-TURN * share)
        yield from settled()
        shots.append(picture(f"frame-{len(shots):02}"))
    handle = regions("handle")[0]
    assert (handle.TranslationZ.Value, handle.Angle.Value) == (LIFT, -TURN)
    crop = crop_of(view().graphicsView().viewport())
    path = os.path.join(FOLDER, "frame-lifted.gif")
    begin, way, end = shots[0], shots[1:-1], shots[-1]
    words = ["-delay", "60", begin, "-delay", "6", *way, "-delay", "90", end]
    words += ["-delay", "6", *reversed(way), *crop, *MOVIE, "-loop", "0", path]
    subprocess.run(["convert", *words], check=True)
    assert os.path.getsize(path) > 50_000
    yield from press("Cancel")


def test_proposals():
    yield from large_view()
    bare_frame()
    Gui.Selection.clearSelection()
    yield from press_tool("Find Contacts…")
    yield from until(is_shown, "the panel")
    yield from xdotool("mousemove", *cell_place(2))
    yield from taken("find-contacts")
    yield from press("Cancel")


def test_sheets_with_a_thickness():
    yield from large_view()
    yield from thin_plate()
    view().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    yield from press_tool("Thickness…")
    assert is_drawn()
    yield from taken("thickness")
    yield from press("Close")


def test_the_sheet_as_steel():
    yield from large_view()
    yield from new_morph()
    yield from choose_property(assembly(), "Energy", 3)
    select(regions("handle")[0])
    yield from open_panel()
    yield from enter(child("translation_z"), "18")
    yield from until(lambda: "Final steel shape" in child("status").text(), "the steel")
    yield from choose_below(child("colours"), 4)
    yield from until(lambda: "stretch" in child("scale_text").text(), "the stretch")
    yield from taken("stretch")
    yield from press("OK")
    select(part())
    yield from menu("SheetMorph", "Flatten")
    yield from until(lambda: App.ActiveDocument.getObject("Blank003"), "the blanks")
    Gui.Selection.clearSelection()
    Gui.SendMsgToActiveView("ViewFit")
    yield from taken("blanks", with_panel=False)


def test_preparing():
    yield from large_view()
    yield from coarse_plate()
    yield from until(is_shown, "the panel")
    yield from enter(child("edge"), "4 mm")
    yield from press("Preview")
    yield from until(is_previewed, "the preview")
    yield from taken("prepare")
    yield from press("Cancel")


def test_a_study():
    yield from large_view()
    yield from mirror_study()
    yield from taken("study")
    yield from press("Cancel")


def test_how_far_a_value_may_go():
    yield from cover()
    yield from mark("Mark Fixed Region…", near_edge(-1.0))
    yield from press("OK")
    yield from mark("Mark Handle…", near_edge(1.0))
    yield from press("OK")
    yield from menu("SheetMorph", "Move Handle…")
    yield from until(is_shown, "the panel")
    yield from enter(child("translation_x"), "-40 mm")
    yield from until(is_marked, "the scale")
    yield from taken("reach")
    yield from press("Cancel")


def test_tools_of_move_handle():
    yield from new_morph()
    yield from open_panel()
    start = yield from grab_up_arrow()
    yield from xdotool("keydown", "shift")
    yield from drag_up(start, 1)
    x, y = on_screen((0.0, 60.0, 20.0))
    yield from xdotool("mousemove", x, y + 3, "mousemove", x, y)
    yield from until(marked, "the mark")
    yield from taken("snap")
    yield from xdotool("mouseup", 1, "keyup", "shift")
    yield from measure_ends()
    yield from enter(child("translation_z"), "25")
    yield from taken("measure")
    yield from click_widget(child("measure"))
    yield from show_section("clipY", 30.0)
    yield from taken("section")
    close_sections()
    yield from press("Cancel")


def test_a_step_file_comes_back():
    path = os.path.join(WORK, "bracket.step")
    bracket().exportStep(path)
    yield from large_view()
    yield from menu("File", "Std_New")
    yield from import_step(path, "3 mm")
    yield from mark_the_ends()
    yield from keep_the_holes()
    yield from press("OK")
    yield from until(lambda: len(regions("form feature")) == 3, "three holes")
    yield from drag_and_type()
    yield from taken("solid-dragged")
    yield from press("OK")
    select(part())
    yield from menu("SheetMorph", "Deformed Shape")
    yield from until(lambda: part().DeformedShape, "the shape")
    part().ViewObject.Visibility = False
    select(part().DeformedShape)
    yield from taken("solid-shape", with_panel=False)
    shape = part().DeformedShape
    yield from drawn_along_a_hole(shape, 5.0)


def drawn_along_a_hole(shape, radius: float):
    """A page of TechDraw that looks along a hole of a shape: it is a circle of its radius there."""
    surfaces = [face.Surface for face in shape.Shape.Faces]
    holes = [one for one in surfaces if isinstance(one, Part.Cylinder)]
    hole = next(one for one in holes if abs(one.Radius - radius) < 1e-9)
    document = shape.Document
    page = document.addObject("TechDraw::DrawPage", "Page")
    template = document.addObject("TechDraw::DrawSVGTemplate", "Template")
    folder = os.path.join(App.getResourceDir(), "Mod", "TechDraw", "Templates")
    template.Template = os.path.join(folder, "A4_LandscapeTD.svg")
    page.Template = template
    drawing = document.addObject("TechDraw::DrawViewPart", "View")
    page.addView(drawing)
    drawing.Source, drawing.Direction = [shape], hole.Axis
    drawing.ScaleType, drawing.Scale, drawing.X, drawing.Y = "Custom", 1.4, 90, 110
    document.recompute()
    yield from until(drawing.getVisibleEdges, "the drawing")
    curves = [edge.Curve for edge in drawing.getVisibleEdges()]
    radii = [one.Radius / drawing.Scale for one in curves if isinstance(one, Part.Circle)]
    assert any(abs(one - radius) < 1e-6 for one in radii), radii
    page.ViewObject.show()
    yield from settled()
    Gui.SendMsgToActiveView("ViewFit")
    yield from taken("solid-drawing", with_panel=False)


def test_an_edited_body_is_followed():
    yield from large_view()
    yield from menu("File", "Std_New")
    document = App.ActiveDocument
    plate = document.addObject("Part::Box", "Plate")
    plate.Length, plate.Width, plate.Height = 80, 50, 4
    document.recompute()
    morph = api.create_assembly(document)
    (made,) = api.add_shape(morph, plate, "plate mesh", {"edge": 6.0})
    api.add_fixed(morph, made, {"face_at": [0, 25, 2]}, "Clamp")
    plate.ViewObject.Visibility = False
    plate.Length = 100
    document.recompute()
    yield from until(lambda: made.SourceChanged, "what is to be followed")
    Gui.activeDocument().activeView().viewIsometric()
    Gui.activeDocument().activeView().fitAll()
    yield from press_tool("Guide")
    yield from taken("follow-shape")
    select(made)
    yield from menu("SheetMorph", "Follow Shape")
    yield from until(lambda: not made.SourceChanged, "the part to follow")
    assert np.ptp(api.rest_mesh(made)[0][:, 0]) > 99.9
