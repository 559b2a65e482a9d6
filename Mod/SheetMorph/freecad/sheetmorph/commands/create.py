# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands do that create a morph, add parts to it and replace their files."""

import json
import math
from collections.abc import Callable

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, subject
from freecad.sheetmorph.actions import DOCUMENT, call, name
from freecad.sheetmorph.api import following
from freecad.sheetmorph.bridge.units import number_in
from freecad.sheetmorph.qt import QtCore, QtWidgets, translate

DECKS = (".nas", ".bdf", ".dat", ".fem", ".blk", ".bulk", ".pch", ".k", ".key", ".dyn", ".inp")
DECKS += (".rad", ".msh")
MESHES = "*.obj *.off *.ply *.stl *.vtk *.vtu"
CAD = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
FILTER = (
    f"Meshes, decks and CAD ({MESHES} {' '.join('*' + ending for ending in DECKS + CAD)});;"
    "All files (*)"
)

NEW = call("create_assembly", DOCUMENT)


def ensure_document() -> None:
    """Create a document if there is none."""
    if App.ActiveDocument is None:
        App.setActiveDocument(actions.new_document().Name)


def added(function: str, *arguments: str) -> str:
    """Return the line that adds a part, as a thin solid if that fits."""
    return call("propose_thin", call(function, *arguments))


def ask_edge() -> float | None:
    """Return the user's edge length for meshing CAD shapes, mm; 0 for automatic, None to stop.

    The dialog repeats its question until the text is a valid length.
    """
    title = translate("SheetMorph_ImportPart", "Mesh CAD Shapes")
    wanted = translate(
        "SheetMorph_ImportPart", "Maximum edge length (0 = automatic, 1/100 of the size)"
    )
    refused = translate(
        "SheetMorph_ImportPart", "“{0}” is not a length. Enter a length such as 5 mm."
    )
    asked, text, is_given = wanted, "0 mm", True
    while is_given:
        normal = QtWidgets.QLineEdit.Normal
        text, is_given = QtWidgets.QInputDialog.getText(
            Gui.getMainWindow(), title, asked, normal, text
        )
        length = number_in(text, "mm") if is_given else None
        if length is not None and 0.0 <= length < math.inf:
            return length
        asked = f"{refused.format(text)}\n{wanted}"
    return None


def meshed(edge: float) -> dict[str, str]:
    """Return the argument of an API call that meshes CAD shapes."""
    return {"mesh": repr({"edge": edge})} if edge else {}


def source_lines(owner: str, edge: float) -> list[str]:
    """Return the API calls that add the selected meshes and shapes to a morph."""
    chosen = subject.meshes() + subject.links()
    lines = [added("add_part", owner, name(mesh)) for mesh in chosen]
    return lines + [call("add_shape", owner, name(s), **meshed(edge)) for s in subject.shapes()]


def import_lines(owner: str, files: list[str], edge: float) -> list[str]:
    """Return the API calls that import files into a morph.

    Every solid of a CAD file and every property of a deck becomes a part.
    """
    return [import_line(owner, file, edge) for file in files]


def import_line(owner: str, file: str, edge: float) -> str:
    """Return the API call that imports one file."""
    if file.lower().endswith(CAD):
        return call("import_cad", owner, repr(file), **meshed(edge))
    if file.lower().removesuffix(".gz").endswith(DECKS):
        return call("import_deck", owner, repr(file))
    return added("import_part", owner, repr(file))


def look_at_new(before: set) -> None:
    """Offer repairs for new parts (objects not in `before`) if one needs them.

    This happens after the command, because FreeCAD leaves its step open if it ends with a panel.
    """
    from freecad.sheetmorph.panels import prepare_panel

    new = [o for o in App.ActiveDocument.Objects if o not in before]
    parts = [o for o in new if subject.kind(o) == subject.PART]
    QtCore.QTimer.singleShot(0, lambda: prepare_panel.offer(parts))


def create_morph() -> None:
    """Create a morph in one undo step; the first mesh, else shape, is the primary."""
    edge = ask_edge() if subject.shapes() else 0.0
    if edge is None:
        return
    ensure_document()
    before = set(App.ActiveDocument.Objects)
    lines = [f"morph = {NEW}", *source_lines("morph", edge)]
    if actions.attempt("Create Morph", *lines):
        Gui.Selection.clearSelection()
        made = [o for o in App.ActiveDocument.Objects if o not in before]
        Gui.Selection.addSelection(next(o for o in made if subject.kind(o) == subject.ASSEMBLY))
        look_at_new(before)


def add_part(owner) -> None:
    """Add the selected meshes and shapes to a morph in one undo step."""
    shapes = subject.shapes()
    if not (shapes or subject.meshes() or subject.links()):
        raise ValueError(
            translate(
                "SheetMorph_AddPart",
                "The selected objects have no faces. Select meshes or shapes.",
            )
        )
    edge = ask_edge() if shapes else 0.0
    before = set(App.ActiveDocument.Objects)
    if edge is not None and actions.attempt("Add Part", *source_lines(name(owner), edge)):
        look_at_new(before)


def replace_file(part) -> None:
    """Let the user choose another version of a part's file, and read it in one undo step."""
    title = translate("SheetMorph_ReplaceFile", "Replace File")
    file, _ = QtWidgets.QFileDialog.getOpenFileName(Gui.getMainWindow(), title, "", FILTER)
    edge = ask_edge() if file.lower().endswith(CAD) else 0.0
    if not file or edge is None:
        return

    def line(answers: dict[str, str]) -> str:
        return call("replace_file", name(part), repr(file), **meshed(edge), **answers)

    if attempt_bound("Replace File", part, line):
        tell_differences(part)


def follow_shape(part) -> None:
    """Update a part from its source shape in one undo step."""
    if attempt_bound(
        "Follow Shape", part, lambda answers: call("follow_shape", name(part), **answers)
    ):
        tell_differences(part)


def attempt_bound(title: str, part, line: Callable[[dict[str, str]], str]) -> bool:
    """Run a line that changes the shape of a part; return False if nothing changed.

    Where it is uncertain which hole or face a region refers to, the user decides.
    """
    bindings: dict[str, list[float]] = {}
    while True:
        answers = {"bindings": repr(bindings)} if bindings else {}
        following.forget()
        try:
            actions.run(title, line(answers), document=part.Document)
        except actions.Cancelled:
            return False
        except actions.FAULTS as error:
            asked = {k: v for k, v in following.asked().items() if k not in bindings}
            if not asked or not all(one["candidates"] for one in asked.values()):
                actions.tell(title, error)
                return False
            given = ask_bindings(title, asked)
            if given is None:
                return False
            bindings |= given
        else:
            return True


def ask_bindings(title: str, asked: dict[str, dict]) -> dict[str, list[float]] | None:
    """Let the user choose the hole or face of each uncertain region; None to stop."""
    wanted = translate("SheetMorph_FollowShape", "“{0}” was {1}. Which one is it now?")
    found = {}
    for key, one in asked.items():
        texts = [candidate["text"] for candidate in one["candidates"]]
        label = wanted.format(one["label"], one["was"])
        text, is_given = QtWidgets.QInputDialog.getItem(
            Gui.getMainWindow(), title, label, texts, 0, False
        )
        if not is_given:
            return None
        found[key] = one["candidates"][texts.index(text)]["place"]
    return found


def tell_differences(part) -> None:
    """Report the differences on the new mesh of a part."""
    from freecad.sheetmorph.panels import differences

    differences.tell(part.Document, json.loads(part.Differences))


def import_part(_is_clear: bool) -> None:
    """Let the user choose files, and import them in one undo step.

    Without a morph, it creates one.
    """
    window = Gui.getMainWindow()
    title = translate("SheetMorph_ImportPart", "Import Part")
    files, _ = QtWidgets.QFileDialog.getOpenFileNames(window, title, "", FILTER)
    has_cad = any(file.lower().endswith(CAD) for file in files)
    edge = ask_edge() if has_cad else 0.0
    if not files or edge is None:
        return
    ensure_document()
    owner = subject.assembly()
    lines = [] if owner else [f"morph = {NEW}"]
    lines += import_lines(name(owner) if owner else "morph", files, edge)
    before = set(App.ActiveDocument.Objects)
    if actions.attempt("Import Part", *lines):
        look_at_new(before)
        # Later, because a panel that opens makes the view smaller.
        QtCore.QTimer.singleShot(0, lambda: Gui.SendMsgToActiveView("ViewFit"))
