# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts to search, read from files and split as required."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any


from ..base.errors import Fault, RecipeError
from ..files import is_cad, read_part, unpacked_name
from ..recipe.model import model_of
from ..recipe.parts import Parts, Source, read_parts
from ..recipe.splitting import split_triangles
from .deck import deck_connections, rigid_bodies
from .exact import exact_of
from .findings import FindPart, Findings
from .options import FindOptions
from .search import Connection, find

SPLITS = ("auto", "components", "property", "none")


def find_in_files(
    paths: Sequence[str | Path],
    options: FindOptions = FindOptions(),
    split: str = "auto",
    meshing: Mapping[str, float] | None = None,
) -> dict[str, Any]:
    """Return the search result for mesh files, in the form of find.schema.json.

    split is "components" or "property" for every file, "none", or "auto" for components where a
    file has several. meshing has edge and deflection (mm) and angle (degrees) for CAD files. Raises
    RecipeError for files that cannot be read or split, and ValueError for options.
    """
    parts = parts_of_files(paths, split, meshing)
    found = find_in_parts(parts, options)
    files = [source.file for source in parts.sources]
    return {
        "sheetmorph_find": 1,
        "options": {**options.as_dict(), "gap": found.gap},
        "parts": [_entry(source, meshing) for source in parts.sources],
        "notes": [f"{file.origin}: {text}" for file in files for text in file.missing],
        **vars(found),
    }


def find_in_parts(parts: Parts, options: FindOptions) -> Findings:
    """Search parts that were read from files; decks add thickness and connections."""
    return find(find_parts(parts), options, connections_of(parts))


def find_parts(parts: Parts) -> list[FindPart]:
    """Return the parts with the thickness from decks and the features from CAD files."""
    exact = {name: known for s in parts.sources for name, known in exact_of(s).items()}
    bodies = {
        name: rows for s in parts.sources for name, rows in rigid_bodies(s, parts.meshes).items()
    }
    return [
        FindPart(
            entry.name,
            parts.meshes[entry.name],
            parts.meshes[entry.name].thickness,
            exact.get(entry.name, []),
            bodies.get(entry.name, []),
        )
        for entry in parts.entries
        if entry.name in parts.meshes
    ]


def connections_of(parts: Parts) -> list[Connection]:
    """Return the deck elements that join two parts, with part numbers as in find_parts()."""
    names = [entry.name for entry in parts.entries if entry.name in parts.meshes]
    index = {name: k for k, name in enumerate(names)}
    found: list[Connection] = []
    for source in parts.sources:
        first = 1 + max((joint for *_, joint, _ in found), default=-1)
        found += [
            (index[a], vertex_a, index[b], vertex_b, first + joint, int(is_rigid))
            for a, vertex_a, b, vertex_b, joint, is_rigid in deck_connections(source, parts.meshes)
        ]
    return found


def parts_of_files(
    paths: Sequence[str | Path], split: str = "auto", meshing: Mapping[str, float] | None = None
) -> Parts:
    """Read the parts of files; meshing has mesh sizes for CAD files. Raises RecipeError."""
    if meshing and not any(map(is_cad, paths)):
        todo = "leave out edge, deflection and angle"
        raise RecipeError([Fault("find", "only CAD files are meshed", todo)])
    entries: list[dict[str, Any]] = []
    names: set[str] = set()
    for path in map(str, paths):
        way = _way(path) if split == "auto" else split
        if way == "none":
            name = _free_name(unpacked_name(path).stem, names)
            entries.append({"file": path, "name": name})
        else:
            entries.append({"file": path, "split": way})
        if meshing and is_cad(path):
            entries[-1]["mesh"] = dict(meshing)
    parts = read_parts(model_of({"parts": entries}).parts, ".")
    faults = [fault for fault in parts.faults if "is already used" not in fault.what]
    if faults:
        raise RecipeError(faults)
    return parts


def _way(path: str) -> str:
    """Return the default way to split a file."""
    if is_cad(path):
        return "components"
    try:
        file = read_part(path)
        return "components" if len(split_triangles(file, "components")) > 1 else "none"
    except (OSError, ValueError):
        return "none"  # the next attempt to read it reports the error


def _free_name(name: str, names: set[str]) -> str:
    count = 1
    while name in names:
        count += 1
        name = f"{name.rsplit(' ', 1)[0] if count > 2 else name} {count}"
    names.add(name)
    return name


def _entry(source: Source, meshing: Any) -> dict[str, Any]:
    """Return the recipe entry of a file, with the names of its parts."""
    path, names = source.file.origin, list(source.members)
    entry: dict[str, Any] = {"name": names[0], "file": str(path)}
    if source.split:
        way = True if source.split == "components" else source.split
        entry = {"file": str(path), "split": way}
    if meshing and is_cad(path):
        entry["mesh"] = dict(meshing)
    return {**entry, "parts": names}
