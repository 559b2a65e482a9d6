# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imported decks with their parts and names."""

from __future__ import annotations

import json
import os
from pathlib import Path

import numpy as np

from freecad.sheetmorph import reporting
from freecad.sheetmorph.api.checks import require_assembly
from freecad.sheetmorph.api.meshes import add_mesh
from freecad.sheetmorph.bridge import decks, kernel
from freecad.sheetmorph.bridge.reading import read_file
from freecad.sheetmorph.objects import assembly_of
from freecad.sheetmorph.objects.deck import DeckProxy, ShellsProxy, told_thickness


def import_deck(
    assembly, path: str | os.PathLike, split: str | None = None, *, settings: dict | None = None
) -> list:
    """Read a deck into an assembly and return its parts, one per property.

    If properties share nodes, there is one part per component. The properties with name, number and
    thickness are below each part. The document stores the deck with all its includes. `write_parts`
    writes it again with moved nodes.

    Parameters
    ----------
    assembly : object
        The assembly.
    path : str or path
        The deck.
    split : str, optional
        "property", "components", or "" for a single part.
    settings : dict, optional
        `passengers` and `joints`, as in a recipe.

    Raises
    ------
    ValueError, OSError
        If the deck cannot be read.
    """
    require_assembly(assembly)
    file = read_file(path)
    if file.properties is None:
        raise ValueError(f"{Path(path).name} is not a deck; use import_part.")
    splitting = kernel.splitting()
    way = splitting.usual_split(file) if split is None else split
    rows = splitting.split_triangles(file, way) if way else {"": np.arange(len(file.properties))}
    deck = _add_deck(assembly, file, way, settings)
    names = reporting.one_by_one(list(rows), "adding the parts")
    return [_add_part(deck, file, name, rows[name]) for name in names]


def _add_deck(assembly, file, split: str, settings: dict | None):
    deck = assembly.Document.addObject("App::FeaturePython", "Deck")
    DeckProxy(deck)
    deck.Label = deck.FileName = file.output_name
    deck.Format, deck.Nodes = file.deck.form, len(file.deck.ids)
    deck.Elements = sum(len(block.ids) for block in file.deck.elements)
    deck.Split, deck.Settings = split, json.dumps(settings or {})
    decks.keep_file(deck, file)
    assembly.addObject(deck)
    return deck


def _add_part(deck, file, name: str, rows: np.ndarray):
    """Add the part of a deck with some of its triangles (k,)."""
    mesh, vertices = kernel.splitting().part_of(file.mesh, rows, name)
    found = file.shells_of(rows)
    whole = f"{Path(deck.FileName).stem} {name}".strip()
    label = (found[0].name or f"PID {found[0].number}") if len(found) == 1 else whole
    of_deck = {"rows": vertices, "faces": file.faces_among(vertices)}
    label = _label(deck.Document, label, whole)
    part = add_mesh(assembly_of(deck), mesh, label, of_deck=of_deck)
    part.Deck, part.DeckPart = deck, name
    part.Shells = [_add_shells(part, shells, whole) for shells in found]
    part.SheetThickness = told_thickness(part)
    return part


def _add_shells(part, shells, where: str):
    added = part.Document.addObject("App::FeaturePython", "Shells")
    ShellsProxy(added)
    added.Label = _label(part.Document, shells.title, where)
    added.Number, added.Title, added.Material = shells.number, shells.name, shells.material
    added.Thickness, added.Elements, added.Part = shells.thickness, shells.elements, part
    return added


def _label(document, wanted: str, where: str) -> str:
    """Return a label that is unique through its location.

    FreeCAD would otherwise increment the number in it, "PID 15" to "PID 016".
    """
    return f"{wanted} ({where})" if document.getObjectsByLabel(wanted) else wanted
