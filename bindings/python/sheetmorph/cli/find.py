# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `find`: the features and contacts of mesh files."""

from __future__ import annotations

import argparse

from ..base.errors import Fault, RecipeError
from ..base.words import counted
from ..files.atomic import FileSet
from ..finding import FindOptions, find_in_files
from ..finding.options import HOLES, KINDS, ODD_HOLE
from ..recipe.writing import recipe_text
from .arguments import MESH_SIZES, SEARCH_NUMBERS
from .output import Outcome, write_text


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Find features and contacts, and write them or return them. Raises RecipeError."""
    given = {name: getattr(wanted, name) for _, name, _, _ in SEARCH_NUMBERS}
    values = {name: value for name, value in given.items() if value is not None}
    options = FindOptions(one_per_pair=wanted.one_per_pair).changed(values)
    if wanted.kind:
        options = options.changed({"kinds": _known_kinds(wanted.kind)})
    sizes = {name: getattr(wanted, name) for _, name, _ in MESH_SIZES}
    sizes = {name: size for name, size in sizes.items() if size is not None}
    found = find_in_files(wanted.files, _checked(options), wanted.split, sizes)
    if wanted.output is None:
        return Outcome([recipe_text(found).rstrip("\n")], found)
    path = write_text(wanted, recipe_text(found, wanted.output), files)
    features = counted(len(found["features"]), "feature", "features")
    contacts = counted(len(found["contacts"]), "contact", "contacts")
    return Outcome([f"{path}: {features}, {contacts}"], found)


def _known_kinds(kinds: list[str]) -> list[str]:
    unknown = [kind for kind in kinds if kind not in (*KINDS, ODD_HOLE)]
    if unknown:
        known = f"use one of {', '.join((*KINDS, ODD_HOLE))}"
        raise RecipeError([Fault("--kind", f'there is no kind "{unknown[0]}"', known)])
    meanings = {"hole": HOLES, ODD_HOLE: ("hole",)}
    return [one for kind in kinds for one in meanings.get(kind, (kind,))]


def _checked(options: FindOptions) -> FindOptions:
    """Return the options. Raises RecipeError if the kernel refuses one."""
    faults = options.faults()
    if faults:
        raise RecipeError([Fault("find", what, todo) for what, todo in faults])
    return options
