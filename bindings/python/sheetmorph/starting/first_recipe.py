# SPDX-License-Identifier: LGPL-2.1-or-later
"""A first recipe for given files, with the proposals of diagnosis and search, ready to edit."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Ints
from ..base.errors import Fault, RecipeError
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..base.words import counted
from ..decks import is_deck
from ..files import is_cad, read_part, unpacked_name
from ..finding import FindOptions, find
from ..finding.findings import Findings
from ..finding.options import USUAL_FEATURES
from ..finding.reading import connections_of, find_parts
from ..recipe.model import model_of
from ..recipe.parts import Parts, read_parts
from ..recipe.writing import json_value, toml_value
from .advice import missing_findings, unit_word
from .doctor import diagnose_file

# Shares of the part length: the fixed and moved ends (usual and small), and the first lift.
_END, _SMALL_END, _LIFT = 0.05, 0.01, 0.05


@dataclass(frozen=True)
class Entry:
    """A part entry of the recipe, with a remark for the user."""

    keys: dict[str, Any]
    remark: str


@dataclass(frozen=True)
class Key:
    """A recipe key with the comments above it; remarks has one text per list entry, or is empty."""

    comments: list[str]
    name: str
    value: Any
    remarks: list[str] = field(default_factory=list)


def starting_recipe(
    files: Sequence[str | Path],
    folder: str | Path,
    progress: Progress | None = None,
    *,
    is_toml: bool = False,
    unit: str | None = None,
) -> str:
    """Return the text of a commented recipe for mesh, deck or CAD files.

    Parameters
    ----------
    files : sequence of str or path
        The files of the parts.
    folder : str or path
        Folder of the recipe; its paths are relative to this folder.
    progress : callable, optional
        ``progress(fraction, task)`` returns whether to continue.
    is_toml : bool
        Write TOML in place of JSON.
    unit : str, optional
        Unit of mesh files, one of ``file_unit.UNITS``; guessed by default.

    Returns
    -------
    str
        The recipe.

    Raises
    ------
    FileError, RecipeError, KernelError
    """
    entries = [_entry(str(file), unit) for file in files]
    parts = _read([entry.keys for entry in entries], progress)
    found = find(find_parts(parts), FindOptions(), connections_of(parts), progress)
    beside = [_beside(entry, Path(folder)) for entry in entries]
    keys = _keys(beside, parts, found)
    return _toml_text(keys) if is_toml else _json_text(keys)


def _entry(file: str, unit: str | None) -> Entry:
    """Return the part entry that the diagnosis proposes for a file."""
    name = unpacked_name(file).stem
    if is_cad(file):
        return Entry({"file": file, "split": True, "thin": "auto"}, "every solid is a part")
    read = read_part(file)
    told = diagnose_file(read, unit=unit)
    keys = {} if "split" in told["part"] else {"name": name}
    cures = [
        finding["text"]
        for finding in told["findings"]
        if finding["cure"] or finding["finding"] == "unit"
    ]
    remark = f"{told['triangles']} triangles, {told['size']:.4g} {unit_word(told)} large"
    if is_deck(unpacked_name(file)):
        missing = missing_findings(read.missing)
        cures = [finding["text"] for finding in told["findings"] if finding not in missing]
        remark = f"{remark}; a deck stays a deck: only its coordinates change"
        if told["unit"]["guess"] != "mm":
            remark += f"; all lengths below are in the unit of the deck, {unit_word(told)}"
    cure = told["part"]
    if "weld" in cure:
        cure = {**cure, "weld": float(f"{cure['weld']:.2g}")}
    return Entry({**keys, "file": file, **cure}, "; ".join([remark, *read.missing, *cures]))


def _read(entries: list[dict[str, Any]], progress: Progress | None) -> Parts:
    parts = read_parts(model_of({"parts": entries}).parts, ".", progress)
    if parts.faults:
        raise RecipeError(parts.faults)
    return parts


def _beside(entry: Entry, folder: Path) -> Entry:
    """Return the entry with its path relative to the recipe."""
    file = os.path.relpath(Path(entry.keys["file"]).resolve(), folder.resolve())
    return Entry({**entry.keys, "file": file}, entry.remark)


def _keys(entries: list[Entry], parts: Parts, found: Findings) -> list[Key]:
    """Return the keys of the recipe in their order."""
    primary = next((name for name in found.primary if len(parts.meshes[name].triangles)), None)
    heading = [
        "`init` found this in the files. Check it with `show`, edit it,",
        "then `run` it. Lengths in mm, angles in degrees; all keys: resources/docs/recipe.md",
    ]
    remarks = [" ".join(entry.remark.split()) for entry in entries]
    keys = [
        Key(heading, "sheetmorph", 1),
        Key([], "parts", [entry.keys for entry in entries], remarks),
    ]
    is_assembly = len(parts.meshes) > 1
    if is_assembly:
        text = "the part that you move; it touches most of the other parts"
        keys.append(Key([text], "primary", primary))
    if primary is not None:
        keys += _ends(primary, parts, found)
    keys.append(Key([f"found: {_counts(found.features, USUAL_FEATURES)}"], "features", "auto"))
    if is_assembly:
        number = counted(len(found.contacts), "place", "places")
        text = f"found: {number}; the gap is at most {found.gap:.3g} mm"
        keys.append(Key([text], "contacts", "auto"))
    return keys


def _json_text(keys: list[Key]) -> str:
    """Return the recipe as JSON with comments; those of the first key precede the opening brace."""
    lines = [f"// {text}" for text in keys[0].comments] + ["{"]
    for number, key in enumerate(keys):
        lines += [f"  // {text}" for text in key.comments if number]
        lines += _value_lines(key, f'  "{key.name}": ', "//", json_value)
        lines[-1] += "," if number + 1 < len(keys) else ""
    return "\n".join([*lines, "}"]) + "\n"


def _toml_text(keys: list[Key]) -> str:
    """Return the recipe as TOML."""
    lines = []
    for key in keys:
        lines += [f"# {text}" for text in key.comments]
        lines += _value_lines(key, f"{key.name} = ", "#", toml_value)
    return "\n".join(lines) + "\n"


def _value_lines(key: Key, start: str, mark: str, text_of: Callable[[Any], str]) -> list[str]:
    """Return a key with its value, on one line unless the list entries have remarks."""
    if not key.remarks:
        return [f"{start}{text_of(key.value)}"]
    lines = [f"{start}["]
    for number, (remark, value) in enumerate(zip(key.remarks, key.value)):
        lines.append(f"    {mark} {remark}")
        lines.append(f"    {text_of(value)}{',' if number + 1 < len(key.value) else ''}")
    return [*lines, f"{start[: len(start) - len(start.lstrip())]}]"]


def _ends(part: str, parts: Parts, found: Findings) -> list[Key]:
    """Fix one end of the part and move the other, across its flattest direction.

    The ends lie on the longest axis along which no rigid shape connects them. Raises RecipeError if
    there is none.
    """
    mesh = parts.meshes[part]
    size = np.ptp(mesh.points[np.unique(mesh.triangles)], axis=0)
    bodies = _rigid_bodies(part, parts, found)
    axes = sorted(range(3), key=lambda k: -float(size[k]))[:2]
    ends = [_End(mesh, axis, share) for axis in axes for share in (_END, _SMALL_END)]
    good = [end for end in ends if not any(end.tears(body) for body in bodies)]
    if not good:
        what = f'a rigid shape of "{part}", such as a rib, connects both ends'
        todo = "write a recipe by hand, with a fixed region and a handle that no rib connects"
        raise RecipeError([Fault(part, what, todo)])
    end = good[0]
    shift = np.zeros(3)
    flattest = min(set(range(3)) - {end.axis}, key=lambda k: float(size[k]))
    shift[flattest] = _LIFT * end.length
    text = (
        f"the two ends along {'xyz'[end.axis]}, {end.length:.4g} mm apart: one "
        "is fixed, one moves"
    )
    handle = {"name": "end", "part": part, "where": end.half_space(1.0)}
    return [
        Key([text], "fixed", [{"part": part, "where": end.half_space(-1.0)}]),
        Key([], "handles", [handle]),
        Key([], "pose", {"end": {"translation": [_rounded(x) for x in shift]}}),
    ]


class _End:
    """Both ends of a mesh along an axis, each a share of its length."""

    def __init__(self, mesh: PartMesh, axis: int, share: float):
        self.axis, self.places = axis, mesh.points[:, axis]
        used = self.places[np.unique(mesh.triangles)]
        low, self.length = float(used.min()), float(np.ptp(used))
        self.limits = (
            _rounded(low + share * self.length),
            _rounded(low + (1.0 - share) * self.length),
        )

    def tears(self, body: Ints) -> bool:
        """Return whether the vertices of a body reach both ends."""
        places = self.places[body]
        return bool((places <= self.limits[0]).any() and (places >= self.limits[1]).any())

    def half_space(self, sign: float) -> dict[str, Any]:
        """Return the selector of an end: the lower one for a sign of -1."""
        point, normal = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
        point[self.axis], normal[self.axis] = self.limits[int(sign > 0.0)], sign
        return {"half_space": {"point": point, "normal": normal}}


def _rigid_bodies(part: str, parts: Parts, found: Findings) -> list[Ints]:
    """Return the vertices of each rigid body of a thin solid.

    A body is a thick region, joined with the form features that share its vertices.
    """
    mesh = parts.meshes[part]
    entry = next(one for one in parts.entries if one.name == part)
    if not entry.thin:
        return []
    core = load_kernel()
    solid, _ = core.find_thin_solid(core.TriangleMesh(mesh.points, mesh.triangles), entry.thickness)
    bodies = [] if solid is None else [set(lump.tolist()) for lump in map(np.asarray, solid.lumps)]
    for feature in found.features if bodies else []:
        if feature["part"] != part or feature["kind"] not in USUAL_FEATURES:
            continue
        vertices = set(mesh.find(feature["vertices"])[0].tolist())
        touched = [body for body in bodies if body & vertices]
        if touched:
            bodies = [body for body in bodies if not body & vertices]
            bodies.append(vertices.union(*touched))
    return [np.array(sorted(body)) for body in bodies]


def _rounded(value: float) -> float:
    return float(f"{value:.5g}") + 0.0


def _counts(features: list[dict[str, Any]], kinds: Sequence[str]) -> str:
    counts = Counter(entry["kind"] for entry in features)
    told = [counted(counts[kind], kind, f"{kind}s") for kind in kinds if counts[kind]]
    return ", ".join(told) or "no holes"
