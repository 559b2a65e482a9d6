# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in a few lines of Python: files opened, regions said, handles moved; a recipe grows."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any, cast

from .arrays import Ids
from .errors import Fault, RecipeError
from .files.atomic import FileSet
from .files import unpacked_name
from .notebook import picture_html
from .pictures import scene_of_answer, scene_of_recipe
from .recipe import check_with_meshes
from .recipe.model import model_of
from .recipe.parts import Parts, read_parts
from .running import run
from .selecting.words import Region, Vector
from .session import Result, Session
from .words import counted

# A part, None for the only one, and a region of it.
Side = tuple[str | None, Region]
# "auto" with options or without, or the entries.
Section = str | dict[str, Any] | list[dict[str, Any]] | None

_SECTIONS = {
    "fixed": ("fixed region", "fixed regions"),
    "handles": ("handle", "handles"),
    "features": ("form feature", "form features"),
    "contacts": ("contact", "contacts"),
}


def open(*files: str | os.PathLike[str], **keys: Any) -> Morph:  # noqa: A001
    """A morph of mesh, deck or CAD files; keys of their parts as in a recipe: mesh, thin, weld.

    Raises RecipeError for files that cannot be read.
    """
    return Morph([{"file": os.fspath(file), **keys} for file in files])


class Morph:
    """A recipe that grows call by call; regions are selectors (face_at, box, ...) or vertex ids.

    `recipe` is what a recipe file would hold. Names of parts are those of the files; with one part
    they may be left out.
    """

    def __init__(self, parts: Sequence[dict[str, Any]]):
        named = [part if part.get("split") else {"name": _stem(part), **part} for part in parts]
        self.recipe: dict[str, Any] = {"sheetmorph": 1, "parts": named}
        self._read: Parts = read_parts(model_of({"parts": named}).parts, ".")
        if self._read.faults:
            raise RecipeError(self._read.faults)
        if len(self.parts) > 1:
            self.recipe["primary"] = self.parts[0]
        self._session: Session | None = None
        self._last: Result | None = None

    @property
    def parts(self) -> list[str]:
        """The names of its parts."""
        return [entry.name for entry in self._read.entries]

    def fix(self, where: Region, part: str | None = None, **keys: Any) -> Morph:
        """Vertices that stay; returns the morph itself, as all that add something do."""
        return self._add("fixed", {**self._region(where, part), **keys})

    def handle(self, where: Region, name: str, part: str | None = None, **keys: Any) -> Morph:
        """Vertices that move() moves as one rigid body."""
        return self._add("handles", {"name": name, **self._region(where, part), **keys})

    def feature(self, where: Region, part: str | None = None, **keys: Any) -> Morph:
        """Vertices that keep their form; keys: name, rotation, motion, size."""
        return self._add("features", {**self._region(where, part), **keys})

    def contact(self, a: Side, b: Side, type: str = "control mesh", **keys: Any) -> Morph:
        """Two parts that stay together, each side as (part, where)."""
        sides = {key: self._region(where, part) for key, (part, where) in (("a", a), ("b", b))}
        return self._add("contacts", {"type": type, **sides, **keys})

    def find(self, features: Section = "auto", contacts: Section = "auto") -> Morph:
        """All features and contacts that are found, in place of those listed; None: as they are."""
        for section, value in (("features", features), ("contacts", contacts)):
            if value is not None:
                self.recipe[section] = value
        return self._changed()

    def move(self, handle: str, translation: Vector | None = None, **keys: Any) -> Morph:
        """A handle's motion: translation (mm), rotation as in a recipe, or axis and degrees."""
        if "axis" in keys or "degrees" in keys:
            keys["rotation"] = {"axis": list(keys.pop("axis")), "degrees": keys.pop("degrees")}
        shift = {} if translation is None else {"translation": list(translation)}
        self.recipe.setdefault("pose", {})[handle] = {**shift, **keys}
        return self

    def set(self, **keys: Any) -> Morph:
        """Other keys of the recipe: primary, energy, propagation, refine, symmetry."""
        self.recipe |= keys
        return self._changed()

    def session(self) -> Session:
        """The pre-processing phase, done once until something is added. Raises RecipeError."""
        if self._session is None:
            self._session = Session(self.recipe, self._read.meshes)
        return self._session

    def deform(self) -> Result:
        """All parts in the pose of move(). Raises RecipeError."""
        self._last = self.session().deform(self.recipe.get("pose", {}))
        return self._last

    def save(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Write the recipe; its files are named relative to it. force: over a file that SheetMorph
        did not write, too."""
        target = Path(path)
        with FileSet("recipe", force=force) as files:
            recipe = self._seen_from(target.parent)
            text = json.dumps(recipe, indent=2, ensure_ascii=False, allow_nan=False)
            files.temporary_for(target).write_text(text + "\n", "utf-8")
            files.commit()

    def write(self, folder: str | os.PathLike[str], *, force: bool = False) -> dict[str, Any]:
        """Write the deformed parts into a folder, as the command run does; returns the report.
        force: over files that SheetMorph did not write, too."""
        with tempfile.TemporaryDirectory(prefix="sheetmorph-") as place:
            recipe = Path(place) / "recipe.json"
            recipe.write_text(json.dumps(self._seen_from(None)), "utf-8")
            return run(recipe, Path(folder), force=force)

    def _region(self, where: Region, part: str | None) -> dict[str, Any]:
        if part is None and len(self.parts) != 1:
            names = ", ".join(f'"{name}"' for name in self.parts)
            todo = f"pass part=, one of {names}"
            raise RecipeError([Fault("part", "there are several parts", todo)])
        is_ids = not isinstance(where, dict) and all(hasattr(v, "__index__") for v in where)
        key = "vertices" if is_ids else "where"
        value = list(map(int, cast("Ids", where))) if is_ids else where
        return {"part": self.parts[0] if part is None else part, key: value}

    def _add(self, section: str, entry: dict[str, Any]) -> Morph:
        entries = self.recipe.get(section)
        if entries is not None and not isinstance(entries, list):
            what, todo = f"{section} are found by themselves", f"call find({section}=[]) before"
            raise RecipeError([Fault(section, what, todo)])
        self.recipe[section] = [*(entries or []), entry]
        return self._changed()

    def _changed(self) -> Morph:
        self._session = self._last = None
        return self

    def _seen_from(self, folder: Path | None) -> dict[str, Any]:
        """The recipe with paths relative to a folder, absolute for None."""
        parts = []
        for part in self.recipe["parts"]:
            path = Path(part["file"]).resolve()
            seen = str(path) if folder is None else os.path.relpath(path, folder.resolve())
            parts.append({**part, "file": seen})
        return {**self.recipe, "parts": parts}

    def __repr__(self) -> str:
        told = []
        for section, (one, many) in _SECTIONS.items():
            entries = self.recipe.get(section, [])
            if isinstance(entries, list) and entries:
                told.append(counted(len(entries), one, many))
            elif entries:
                told.append(f"{many} found")
        names = ", ".join(self.parts[:3]) + (", ..." if len(self.parts) > 3 else "")
        return f"<Morph of {names}: {', '.join(told) or 'nothing marked'}>"

    def _repr_html_(self) -> str:
        """What the recipe means, or the parts in their pose once they are deformed."""
        try:
            if self._last is not None:
                return picture_html(scene_of_answer(self._last), repr(self))
            model = check_with_meshes(self.recipe, self._read.meshes)
            return picture_html(scene_of_recipe(model, self._read.meshes), repr(self))
        except RecipeError as error:
            return picture_html(None, repr(self), str(error))


def _stem(part: dict[str, Any]) -> str:
    return unpacked_name(part["file"]).stem
