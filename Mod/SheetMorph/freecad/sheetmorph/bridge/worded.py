# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors in written recipes, where they give the same vertices in the written files."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import kernel, selecting
from freecad.sheetmorph.bridge.recipes import KEYS
from freecad.sheetmorph.bridge.solving import Morph
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools import sentences


def worded(assembly, recipe: dict, written: Written) -> dict:
    """Return a recipe with `where` in place of `vertices` for regions with a valid selector."""
    morph = written.morph
    lists = {key: list(recipe.get(key, [])) for key in (*KEYS.values(), "contacts")}
    places = {entry["name"]: (key, k) for key in KEYS.values() for k, entry in named(lists[key])}
    for region in model.regions(assembly):
        if morph.names[region.Name] in places:
            key, k = places[morph.names[region.Name]]
            lists[key][k] = written.entry(lists[key][k], (region, "", region.Part))
    contacts = {morph.names[contact.Name]: contact for contact in model.contacts(assembly)}
    for k, entry in named(lists["contacts"]):
        contact = contacts[entry["name"]]
        sides = (("a", contact.PartA), ("b", contact.PartB))
        said = {side: written.entry(entry[side], (contact, side, part)) for side, part in sides}
        lists["contacts"][k] = {**entry, **said}
    return {**recipe, **{key: entries for key, entries in lists.items() if entries}}


def named(entries: list) -> list[tuple[int, dict]]:
    """Return the entries with a name, and their indices."""
    return [(k, entry) for k, entry in enumerate(entries) if "name" in entry]


class Written:
    """The written parts of a recipe as selectors see them."""

    def __init__(self, morph: Morph, meshes: dict, own: Container[str]):
        """Store the written parts; `own` has the names of those in file coordinates."""
        self.morph, self._meshes, self._own = morph, meshes, own
        self._shapes: dict[str, Any] = {}

    def entry(self, entry: dict, picked: tuple) -> dict:
        """Return an entry with its selector in place of ids, if both give the same vertices.

        `picked` is a region, or a contact with a side, and the part.
        """
        owner, side, part = picked
        said = selecting.sentence_of(owner, side)
        if said is None:
            return entry
        rest = self.morph.rests[part.Name]
        vertices = model.contact_vertices(owner, side) if side else model.vertices(owner)
        try:
            where = said if part.Name in self._own else sentences.placed(said, rest.frame)
            found = selecting.chosen_on(self._shape(part), where).vertices
        except ValueError:
            return entry
        if not np.array_equal(vertices, found):
            return entry
        where = sentences.with_moved_ids(where, lambda ids: rest.file_ids()[ids].tolist())
        return {**{key: v for key, v in entry.items() if key != "vertices"}, "where": where}

    def _shape(self, part):
        if part.Name not in self._shapes:
            mesh = self._meshes[part.Name]()
            self._shapes[part.Name] = kernel.selecting_module().PartShape(mesh, name=part.Label)
        return self._shapes[part.Name]
