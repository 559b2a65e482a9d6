# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of a document that a study can vary: handles, form features, spreadsheet cells."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from typing import Any, NamedTuple

import FreeCAD

from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.properties import vector_of
from freecad.sheetmorph.objects.region import FORM_FEATURE, HANDLE, PRESCRIBED
from freecad.sheetmorph.tools.studies import ANGLE, LENGTH, NUMBER

TRANSLATIONS = {"TranslationX": "X", "TranslationY": "Y", "TranslationZ": "Z"}
SIZE, TURN, FEATURE_TURN = "Size", "Angle", "RotationAngle"
UNITS = {"Length": LENGTH, "Angle": ANGLE, "": NUMBER}
SHEET = "Spreadsheet::Sheet"


class Variable(NamedTuple):
    """A variable number: its owner, its property or cell, its label, and its unit."""

    owner: Any
    number: str
    label: str
    unit: str


def variables_of(assembly) -> list[Variable]:
    """Return the numbers that a study can vary, without those that expressions drive."""
    found = []
    for region in model.regions(assembly):
        driven = driven_by_expressions(region)
        found += [one for one in numbers_of(region) if one.number not in driven]
    return found + [one for sheet in sheets_of(assembly) for one in cells_of(sheet)]


def numbers_of(region) -> list[Variable]:
    """Return the numbers of one handle or form feature."""
    label = region.Label
    if region.Part is None:
        return []
    if region.Role == HANDLE:
        turns = () if region.FreeRotation else ((TURN, "angle", ANGLE),)
        shifts = [(name, axis, LENGTH) for name, axis in TRANSLATIONS.items()]
        return [Variable(region, name, f"{label} {word}", u) for name, word, u in (*shifts, *turns)]
    if region.Role != FORM_FEATURE:
        return []
    found = [Variable(region, SIZE, f"{label} size", LENGTH)]
    if region.Rotation == PRESCRIBED:
        found.append(Variable(region, FEATURE_TURN, f"{label} angle", ANGLE))
    return found


def driven_by_expressions(region) -> set[str]:
    """Return the properties of a region that expressions drive."""
    return {path.lstrip(".") for path, _ in region.ExpressionEngine}


def sheets_of(assembly) -> list:
    """Return the unique spreadsheets that drive a region of an assembly."""
    found = {}
    for region in model.regions(assembly):
        if region.ExpressionEngine:
            outs = (other for other in region.OutListRecursive if other.TypeId == SHEET)
            found.update({sheet.Name: sheet for sheet in outs})
    return list(found.values())


def cells_of(sheet) -> list[Variable]:
    """Return the cells of a spreadsheet with a number and without a formula."""
    found = []
    for cell in ET.fromstring(sheet.cells.Content).iter("Cell"):
        unit = unit_in(cell.get("content", ""))
        if unit is not None:
            name = cell.get("alias") or cell.get("address")
            label = f"{sheet.Label} {name}"
            found.append(Variable(sheet, cell.get("address"), label, unit))
    return found


def unit_in(content: str) -> str | None:
    """Return the unit of a cell; None for a formula, text, or another unit."""
    try:
        found = FreeCAD.Units.Quantity(content.lstrip("="))
    except (ValueError, SyntaxError, OSError, ArithmeticError):
        return None
    return UNITS.get(found.Unit.Type) if content.strip("= ") else None


def number_of(owner, number: str) -> float:
    """Return a number of the document, mm or degrees; a size of 0 is that of the mesh."""
    is_cell = owner.TypeId == SHEET
    found = owner.get(number) if is_cell else owner.getPropertyByName(number)
    return float(getattr(found, "Value", found))


def set_number(owner, number: str, value: float) -> None:
    """Set a number of the document, mm or degrees; a cell keeps its kind of unit."""
    if owner.TypeId != SHEET:
        setattr(owner, number, value)
        return
    unit = UNITS.get(getattr(getattr(owner.get(number), "Unit", None), "Type", ""), NUMBER)
    owner.set(number, f"={value!r} {unit}" if unit else repr(value))


def path_of(name: str, number: str) -> str:
    """Return the recipe path of a number of the region with this name."""
    quoted = '"' + re.sub(r'(["\\])', r"\\\1", name) + '"'
    if number in TRANSLATIONS:
        return f"pose.{quoted}.translation[{list(TRANSLATIONS).index(number)}]"
    return f"features.{quoted}.size" if number == SIZE else f"pose.{quoted}.rotation.degrees"


def say_number(recipe: dict, name: str, variable: Variable, value: float) -> None:
    """Add a number of the region with this name to a recipe, if it is missing."""
    region, number = variable.owner, variable.number
    if number == SIZE:
        entry = next(entry for entry in recipe["features"] if entry["name"] == name)
        entry["size"] = value
    elif number in (TURN, FEATURE_TURN):
        axis = vector_of(region, "Axis" if number == TURN else "RotationAxis")
        motion = recipe.setdefault("pose", {}).setdefault(name, {})
        motion["rotation"] = {"axis": list(axis), "degrees": value}
