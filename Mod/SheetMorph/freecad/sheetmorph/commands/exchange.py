# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands do that exchange parts and recipes with files, or open an example."""

import os

import FreeCAD as App
import FreeCADGui as Gui

from freecad.sheetmorph import actions, api, paths
from freecad.sheetmorph.actions import DOCUMENT, call, name
from freecad.sheetmorph.qt import QtWidgets, translate

RECIPES = "Recipes (*.json *.toml)"
MOST_NAMES = 8
CRITERIA = ["standard", "crash", "static"]


def open_recipe(path: str, document_name: str = "") -> bool:
    """Open a recipe in a new or the active document; return False if that fails."""
    document = None if document_name else App.ActiveDocument
    document = document or actions.new_document(document_name)
    line = call("import_recipe", DOCUMENT, repr(path))
    done = actions.attempt("Import Recipe", line, document=document)
    if done:
        Gui.activeDocument().activeView().viewIsometric()
        Gui.SendMsgToActiveView("ViewFit")
    return done


def example_recipes() -> dict[str, str]:
    """Return recipe files of the examples by title, as `{"Door Mirror": "…/recipe.json"}`."""
    folder = paths.examples()
    found = {}
    for entry in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        recipe = os.path.join(folder, entry, "recipe.json")
        if os.path.isfile(recipe):
            found[entry.replace("_", " ").title()] = recipe
    return found


def asked_to_write(title: str, owner, place: str) -> dict[str, str] | None:
    """Return the keywords of a call that writes to a place.

    If foreign files are in the way and the user wants to keep them, return None.
    """
    found = api.in_the_way(owner, place)
    if not found:
        return {}
    text = translate(
        "SheetMorph_ExportParts",
        "These files already exist, and SheetMorph did not write their current " "content:",
    )
    names = "\n".join(file.name for file in found[:MOST_NAMES])
    names += "\n…" if len(found) > MOST_NAMES else ""
    question = translate("SheetMorph_ExportParts", "Overwrite them?")
    box = QtWidgets.QMessageBox
    answer = box.question(
        Gui.getMainWindow(), title, f"{text}\n\n{names}\n\n{question}", box.Yes | box.No, box.No
    )
    return {"force": "True"} if answer == box.Yes else None


def export_parts(owner) -> None:
    """Let the user choose a folder, and write the parts."""
    window = Gui.getMainWindow()
    title = translate("SheetMorph_ExportParts", "Export Parts")
    folder = QtWidgets.QFileDialog.getExistingDirectory(window, title)
    ways = asked_to_write(title, owner, folder) if folder else None
    if ways is None:
        return
    if actions.wait(title, call("write_parts", name(owner), repr(folder), **ways)):
        App.Console.PrintMessage(f"SheetMorph: parts written to {folder}\n")


def certify(owner) -> None:
    """Let the user choose criteria and a folder, write, and show the certificate."""
    from freecad.sheetmorph.panels import certificate_dialog

    window = Gui.getMainWindow()
    title = translate("SheetMorph_Certify", "Certificate")
    asked = translate("SheetMorph_Certify", "Criteria")
    criteria, is_chosen = QtWidgets.QInputDialog.getItem(window, title, asked, CRITERIA, 0, False)
    if not is_chosen:
        return
    folder = QtWidgets.QFileDialog.getExistingDirectory(window, title)
    ways = asked_to_write(title, owner, folder) if folder else None
    if ways is None:
        return
    line = call("certify", name(owner), repr(folder), repr(criteria), **ways)
    if actions.wait(title, f"certificate = {line}"):
        certificate_dialog.show(folder)


def export_recipe(owner) -> None:
    """Let the user choose a file, and write the recipe."""
    window = Gui.getMainWindow()
    title = translate("SheetMorph_ExportRecipe", "Export Recipe")
    path, _ = QtWidgets.QFileDialog.getSaveFileName(window, title, "recipe.json", RECIPES)
    ways = asked_to_write(title, owner, path) if path else None
    if ways is not None:
        actions.record(call("export_recipe", name(owner), repr(path), **ways))


def import_recipe() -> None:
    """Let the user choose a recipe, and read it."""
    window = Gui.getMainWindow()
    title = translate("SheetMorph_ImportRecipe", "Import Recipe")
    path, _ = QtWidgets.QFileDialog.getOpenFileName(window, title, "", RECIPES)
    if path:
        open_recipe(path)


def open_example() -> None:
    """Let the user choose an example, and open it in a new document."""
    recipes = example_recipes()
    if not recipes:
        raise RuntimeError(f"There are no examples in {paths.examples()}; build the add-on again.")
    title, chosen = QtWidgets.QInputDialog.getItem(
        Gui.getMainWindow(),
        translate("SheetMorph_OpenExample", "Open Example"),
        translate("SheetMorph_OpenExample", "Example"),
        *(list(recipes), 0, False),
    )
    if chosen:
        open_recipe(recipes[title], title.replace(" ", ""))
