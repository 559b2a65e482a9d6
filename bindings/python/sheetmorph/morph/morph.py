# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in a few lines of Python: open files, mark regions, move handles."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..base.errors import Fault, RecipeError
from ..base.part_mesh import PartMesh
from ..base.words import counted, several
from ..checking import check_entries, check_pose, check_with_meshes
from ..files import unpacked_name
from ..files.atomic import FileSet
from ..pictures import scene_of_answer, scene_of_recipe
from ..pictures.notebook import picture_html
from ..recipe.model import model_of
from ..recipe.parts import Parts, read_parts
from ..recipe.plain import plain
from ..recipe.structure import pose_faults
from ..recipe.writing import recipe_text
from ..selecting.words import Region, Vector
from .running import run
from .session import Result, Session

# A part, or None for the only one, and a region on it.
Side = tuple[str | None, Region]
# "auto", with or without options, or a list of entries.
Section = str | dict[str, Any] | list[dict[str, Any]] | None

_SECTIONS = {
    "fixed": ("fixed region", "fixed regions"),
    "handles": ("handle", "handles"),
    "features": ("form feature", "form features"),
    "contacts": ("contact", "contacts"),
}


def open_files(*files: str | os.PathLike[str] | PartMesh, **keys: Any) -> Morph:
    """Open mesh, deck or CAD files, or meshes in memory, as a morph.

    Parameters
    ----------
    *files : str, path or PartMesh
        The files or meshes of the parts.
    **keys
        Keys for every file, as in a recipe: mesh, thin, weld and others.

    Returns
    -------
    Morph
        A recipe with these parts.

    Raises
    ------
    RecipeError
        If a file cannot be read.
    """
    return Morph(
        [one if isinstance(one, PartMesh) else {"file": os.fspath(one), **keys} for one in files]
    )


class Morph:
    """A recipe that grows with every call.

    Regions are selectors (face_at, box, ...) or vertex ids. The attribute ``recipe`` is the content
    of the recipe file. Parts are named after their files; a morph with one part does not need the
    name.

    Parameters
    ----------
    parts : sequence of dict or PartMesh
        Part entries, as in a recipe, or meshes in memory.

    Raises
    ------
    RecipeError
        If a file cannot be read.
    """

    def __init__(self, parts: Sequence[dict[str, Any] | PartMesh]):
        meshes = [part for part in parts if isinstance(part, PartMesh)]
        files = [part for part in parts if not isinstance(part, PartMesh)]
        named = [part if part.get("split") else {"name": _stem(part), **part} for part in files]
        self._read: Parts = read_parts(model_of({"parts": named}).parts, ".")
        if self._read.faults:
            raise RecipeError(self._read.faults)
        self._in_memory = [mesh.name or f"part{k}" for k, mesh in enumerate(meshes, start=1)]
        inside = [{"name": name} for name in self._in_memory]
        self.recipe: dict[str, Any] = {"sheetmorph": 1, "parts": [*named, *inside]}
        self._read.entries += model_of({"parts": inside}).parts
        self._read.meshes |= dict(zip(self._in_memory, meshes))
        if len(self.parts) > 1:
            self.recipe["primary"] = self.parts[0]
        self._session: Session | None = None
        self._last: Result | None = None

    @property
    def parts(self) -> list[str]:
        """Names of the parts."""
        return [entry.name for entry in self._read.entries]

    def fix(self, where: Region, part: str | None = None, **keys: Any) -> Morph:
        """Prescribe vertices that stay at rest.

        Parameters
        ----------
        where : selector, sequence of int, or array (n,) of bool
            The region, its vertex ids, or a mask of the vertices of its part.
        part : str, optional
            Its part; not needed if there is only one.
        **keys
            Further keys of the recipe entry.

        Returns
        -------
        Morph
            The same morph, so that calls can be chained.

        Raises
        ------
        RecipeError
            If the part is missing, or if the entry has faults that do not need a search.
        """
        return self._add("fixed", {**self._region(where, part), **keys})

    def handle(self, where: Region, name: str, part: str | None = None, **keys: Any) -> Morph:
        """Add a handle: vertices that move() moves as one rigid body.

        Parameters
        ----------
        where : selector, sequence of int, or array (n,) of bool
            The region, its vertex ids, or a mask of the vertices of its part.
        name : str
            Name of the handle.
        part : str, optional
            Its part; not needed if there is only one.
        **keys
            Further keys of the recipe entry.

        Returns
        -------
        Morph
            The same morph.

        Raises
        ------
        RecipeError
            If the part is missing, or if the entry has faults that do not need a search.
        """
        return self._add("handles", {"name": name, **self._region(where, part), **keys})

    def feature(self, where: Region, part: str | None = None, **keys: Any) -> Morph:
        """Add a form feature: vertices that keep their shape.

        Parameters
        ----------
        where : selector, sequence of int, or array (n,) of bool
            The region, its vertex ids, or a mask of the vertices of its part.
        part : str, optional
            Its part; not needed if there is only one.
        **keys
            name, rotation, motion and size, as in a recipe.

        Returns
        -------
        Morph
            The same morph.

        Raises
        ------
        RecipeError
            If the part is missing, if the entry has faults that do not need a search, or if
            find() already searches for features.
        """
        return self._add("features", {**self._region(where, part), **keys})

    def contact(self, a: Side, b: Side, type: str = "control mesh", **keys: Any) -> Morph:
        """Add a contact that keeps two parts together.

        Parameters
        ----------
        a, b : tuple
            The sides, each as (part, region).
        type : str
            Contact type, as in a recipe.
        **keys
            Further keys of the recipe entry.

        Returns
        -------
        Morph
            The same morph.

        Raises
        ------
        RecipeError
            If a part is missing, if the entry has faults that do not need a search, or if find()
            already searches for contacts.
        """
        sides = {key: self._region(where, part) for key, (part, where) in (("a", a), ("b", b))}
        return self._add("contacts", {"type": type, **sides, **keys})

    def find(self, features: Section = "auto", contacts: Section = "auto") -> Morph:
        """Search for all features and contacts, in place of those added before.

        Parameters
        ----------
        features, contacts : str, dict, list or None
            "auto", options of the search, or a list of entries; None leaves the section unchanged.

        Returns
        -------
        Morph
            The same morph.
        """
        for section, value in (("features", features), ("contacts", contacts)):
            if value is not None:
                self.recipe[section] = value
        return self._changed()

    def move(self, handle: str, translation: Vector | None = None, **keys: Any) -> Morph:
        """Set the motion of a handle.

        Parameters
        ----------
        handle : str
            Name of the handle.
        translation : sequence of float, optional
            Translation (3,), mm.
        **keys
            rotation as in a recipe, or axis (3,) and degrees (or angle, as in the FreeCAD api);
            further keys of the pose entry.

        Returns
        -------
        Morph
            The same morph.

        Raises
        ------
        RecipeError
            If a value does not have its form, or if no handle has this name.
        """
        if "angle" in keys:
            keys["degrees"] = keys.pop("angle")
        if "axis" in keys or "degrees" in keys:
            keys["rotation"] = {
                "axis": keys.pop("axis", None),
                "degrees": keys.pop("degrees", None),
            }
        shift = {} if translation is None else {"translation": translation}
        entry = plain({**shift, **keys})
        self._check_motion({handle: entry})
        self.recipe.setdefault("pose", {})[handle] = entry
        return self

    def set(self, **keys: Any) -> Morph:
        """Set other keys of the recipe: primary, energy, propagation, refine, symmetry.

        Returns
        -------
        Morph
            The same morph.
        """
        self.recipe |= keys
        return self._changed()

    def session(self) -> Session:
        """Return the factorised session; it is built again only after a change of the recipe.

        Returns
        -------
        Session
            The session.

        Raises
        ------
        RecipeError
            If the recipe has faults.
        """
        if self._session is None:
            self._session = Session(self.recipe, self._read.meshes)
        return self._session

    def deform(self) -> Result:
        """Return all parts in the pose of move().

        Returns
        -------
        Result
            Positions (n, 3) of every part, mm, and the report.

        Raises
        ------
        RecipeError
            If the recipe or the pose has faults.
        """
        self._last = self.session().deform(self.recipe.get("pose", {}))
        return self._last

    def save(self, path: str | os.PathLike[str], *, force: bool = False) -> None:
        """Write the recipe, with paths relative to its folder.

        Parameters
        ----------
        path : str or path
            The recipe file, in TOML if it ends in .toml and otherwise in JSON.
        force : bool
            Overwrite a file that SheetMorph did not write.

        Raises
        ------
        FileError
            If the file cannot be written or must not be overwritten.
        """
        target = Path(path)
        with FileSet("recipe", force=force) as files:
            text = recipe_text(self._seen_from(target.parent), target)
            files.temporary_for(target).write_text(text, "utf-8")
            files.commit()

    def write(self, folder: str | os.PathLike[str], *, force: bool = False) -> dict[str, Any]:
        """Write the deformed parts into a folder, as the command `run` does.

        Parameters
        ----------
        folder : str or path
            The output folder.
        force : bool
            Overwrite files that SheetMorph did not write.

        Returns
        -------
        dict
            The report; see ``report.schema.json``.

        Raises
        ------
        RecipeError, FileError, KernelError, CertificateError, OSError
            As run() raises them; no part is written then.
        """
        return run(self._seen_from(None), Path(folder), force=force)

    # The names that the FreeCAD api has for the same acts.
    add_fixed, add_handle, add_feature, add_contact = fix, handle, feature, contact
    set_motion, export_recipe, write_parts = move, save, write

    def _region(self, where: Region, part: str | None) -> dict[str, Any]:
        if part is None and len(self.parts) != 1:
            names = ", ".join(f'"{name}"' for name in self.parts)
            todo = f"pass part=, one of {names}"
            raise RecipeError([Fault("part", "there are several parts", todo)])
        is_ids = not isinstance(where, dict) and all(hasattr(v, "__index__") for v in where)
        is_mask = isinstance(where, np.ndarray) and where.dtype == np.bool_
        key = "vertices" if is_ids or is_mask else "where"
        return {"part": self.parts[0] if part is None else part, key: where}

    def _check_motion(self, pose: dict[str, Any]) -> None:
        """Raise RecipeError if a pose has not its form, or moves what does not exist."""
        handles, features = self.recipe.get("handles"), self.recipe.get("features", [])
        if handles and isinstance(features, list):
            check_pose(model_of(self.recipe), pose)
        elif faults := pose_faults(pose):  # more names can follow
            raise RecipeError(faults)

    def _add(self, section: str, entry: dict[str, Any]) -> Morph:
        entries = self.recipe.get(section)
        if entries is not None and not isinstance(entries, list):
            what, todo = f"{section} are found automatically", f"call find({section}=[]) first"
            raise RecipeError([Fault(section, what, todo)])
        meshes = self._read.meshes
        grown = {**self.recipe, section: [*(entries or []), plain(entry, meshes)]}
        check_entries(grown, section, meshes)
        self.recipe[section] = grown[section]
        return self._changed()

    def _changed(self) -> Morph:
        self._session = self._last = None
        return self

    def _seen_from(self, folder: Path | None) -> dict[str, Any]:
        """Return the recipe with paths relative to a folder, or absolute if it is None."""
        if self._in_memory:
            what = f"the parts {several(self._in_memory)} are in memory"
            todo = "take the positions from deform(), or write the meshes to files and open these"
            raise RecipeError([Fault("parts", what, todo)])
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
        return f"<Morph of {several(self.parts)}: {', '.join(told) or 'nothing marked'}>"

    def _repr_html_(self) -> str:
        """Return a picture for notebooks: the recipe, or the parts in their pose after deform()."""
        try:
            if self._last is not None:
                return picture_html(scene_of_answer(self._last), repr(self))
            model = check_with_meshes(self.recipe, self._read.meshes)
            return picture_html(scene_of_recipe(model, self._read.meshes), repr(self))
        except RecipeError as error:
            return picture_html(None, repr(self), str(error))


def _stem(part: dict[str, Any]) -> str:
    return unpacked_name(part["file"]).stem
