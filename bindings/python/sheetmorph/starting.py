# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first recipe of some files: what the doctor and the search propose, ready to be edited."""

from __future__ import annotations

import json
import os
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from .doctor import diagnose
from .errors import RecipeError
from .files import is_cad, read_part, unpacked_name
from .finding import FindOptions, find
from .finding.findings import Findings
from .finding.options import USUAL_FEATURES
from .finding.reading import connections_of, find_parts
from .part_mesh import PartMesh
from .progress import Progress
from .recipe.model import model_of
from .recipe.parts import Parts, read_parts
from .words import counted

# Shares of the length: of the two ends that are held and moved, and of the first lift.
_END, _LIFT = 0.05, 0.05


@dataclass(frozen=True)
class Entry:
    """A part of the recipe, and what the person should know about it."""

    keys: dict[str, Any]
    remark: str


def starting_recipe(
    files: Sequence[str | Path], folder: str | Path, progress: Progress | None = None
) -> str:
    """The text of a recipe with comments for mesh, deck or CAD files, to be put into a folder.

    progress(fraction, task) returns whether to go on. Raises FileError, RecipeError, KernelError.
    """
    entries = [_entry(str(file)) for file in files]
    parts = _read([entry.keys for entry in entries], progress)
    found = find(find_parts(parts), FindOptions(), connections_of(parts), progress)
    beside = [_beside(entry, Path(folder)) for entry in entries]
    return _text(beside, parts, found)


def _entry(file: str) -> Entry:
    """The part that the doctor proposes for a file."""
    name = unpacked_name(file).stem
    if is_cad(file):
        return Entry({"file": file, "split": True, "thin": "auto"}, "every solid is a part")
    told = diagnose(read_part(file).mesh)
    keys = {} if "split" in told["part"] else {"name": name}
    cures = [finding["text"] for finding in told["findings"] if finding["cure"]]
    remark = f"{told['triangles']} triangles, {told['size']:.4g} {told['unit']['guess']} large"
    cure = told["part"]
    if "weld" in cure:
        cure = {**cure, "weld": float(f"{cure['weld']:.2g}")}
    return Entry({**keys, "file": file, **cure}, "; ".join([remark, *cures]))


def _read(entries: list[dict[str, Any]], progress: Progress | None) -> Parts:
    parts = read_parts(model_of({"parts": entries}).parts, ".", progress)
    if parts.faults:
        raise RecipeError(parts.faults)
    return parts


def _beside(entry: Entry, folder: Path) -> Entry:
    """The same with the path of the file as seen from the recipe."""
    file = os.path.relpath(Path(entry.keys["file"]).resolve(), folder.resolve())
    return Entry({**entry.keys, "file": file}, entry.remark)


def _text(entries: list[Entry], parts: Parts, found: Findings) -> str:
    primary = next((name for name in found.primary if len(parts.meshes[name].triangles)), None)
    lines = [
        "// What is in the files, as `init` understood it. Look at it with `show`, edit it,",
        "// and `run` it. Lengths in mm, angles in degrees; all keys: resources/docs/recipe.md",
        "{",
        '  "sheetmorph": 1,',
        '  "parts": [',
    ]
    for k, entry in enumerate(entries):
        lines.append(f"    // {' '.join(entry.remark.split())}")
        lines.append(f"    {_json(entry.keys)}{',' if k + 1 < len(entries) else ''}")
    lines.append("  ],")
    if len(parts.meshes) > 1:
        lines.append("  // the part that you drag; this one touches most of the others")
        lines.append(f'  "primary": {_json(primary)},')
    if primary is not None:
        lines += _ends(primary, parts.meshes[primary])
    lines.append(f"  // found: {_counts(found.features, USUAL_FEATURES)}")
    lines.append('  "features": "auto"' + ("," if len(parts.meshes) > 1 else ""))
    if len(parts.meshes) > 1:
        number = counted(len(found.contacts), "place", "places")
        lines.append(f"  // found: {number} where parts touch, up to {found.gap:.3g} mm apart")
        lines.append('  "contacts": "auto"')
    return "\n".join([*lines, "}"]) + "\n"


def _ends(part: str, mesh: PartMesh) -> list[str]:
    """Fixed at one end of the longest axis, moved at the other, across the flattest direction."""
    used = mesh.points[np.unique(mesh.triangles)]
    size = np.ptp(used, axis=0)
    axis = int(size.argmax())
    low, high = float(used[:, axis].min()), float(used[:, axis].max())
    length = high - low
    shift = np.zeros(3)
    shift[min(set(range(3)) - {axis}, key=lambda k: float(size[k]))] = _LIFT * length

    def half_space(place: float, sign: float) -> dict[str, Any]:
        point, normal = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
        point[axis], normal[axis] = _rounded(place), sign
        return {"half_space": {"point": point, "normal": normal}}

    fixed = {"part": part, "where": half_space(low + _END * length, -1.0)}
    handle = {"name": "end", "part": part, "where": half_space(high - _END * length, 1.0)}
    return [
        f"  // the two ends along {'xyz'[axis]}, {length:.4g} mm apart: one stays, one moves",
        f'  "fixed": [{_json(fixed)}],',
        f'  "handles": [{_json(handle)}],',
        f'  "pose": {_json({"end": {"translation": [_rounded(x) for x in shift]}})},',
    ]


def _rounded(value: float) -> float:
    return float(f"{value:.5g}") + 0.0


def _counts(features: list[dict[str, Any]], kinds: Sequence[str]) -> str:
    counts = Counter(entry["kind"] for entry in features)
    told = [counted(counts[kind], kind, f"{kind}s") for kind in kinds if counts[kind]]
    return ", ".join(told) or "no holes"


def _json(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
