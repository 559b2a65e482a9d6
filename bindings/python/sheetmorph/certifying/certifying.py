# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate: what a run wrote, read again, measured, and judged."""

from __future__ import annotations

import itertools
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..decks.materials import STEEL
from ..errors import FileError
from ..files import FileSet
from ..files.deck_file import DeckFile
from ..finding.deck import part_material, part_thickness
from ..kernel import load_kernel
from ..recipe import filled, named_in, prepare, read_json
from ..recipe.model import Model, RegionEntry, model_of
from ..recipe.parts import Parts, Source
from .criteria import Criteria
from .measuring import (
    Written,
    contact_entry,
    digest,
    feature_entry,
    part_entry,
    penetrations,
)
from .page import page_of

# What the last digit of a field of so many characters is worth, over the number.
_DIGITS = {"float32": 6e-8, "double": 2e-16}


class NotCertified(RuntimeError):
    """The files do not hold what is asked for; ``certificate`` tells."""

    def __init__(self, certificate: dict[str, Any]):
        failures = certificate["failures"]
        more = f" and {len(failures) - 5} more" if len(failures) > 5 else ""
        super().__init__("not certified: " + "; ".join(failures[:5]) + more)
        self.certificate = certificate


@dataclass(frozen=True)
class Targets:
    """Where a certificate goes, as JSON and as a page; None if it is not asked for."""

    json: Path | None = None
    page: Path | None = None


def certify(
    recipe_path: str | Path, out_dir: str | Path, criteria: Criteria, targets: Targets = Targets()
) -> dict[str, Any]:
    """Certify what a run of a recipe wrote into a folder; returns the certificate.

    Raises RecipeError, FileError, KernelError, OSError, and NotCertified once the certificate is
    written.
    """
    path, folder = Path(recipe_path), Path(out_dir)
    recipe = read_json(path)
    with named_in(path):
        parts = prepare(recipe, path.parent)
    whole = parts.resolved.recipe
    model = model_of(whole if parts.found is None else filled(whole, parts.found))
    written, decks = _written(parts, folder)
    core = load_kernel()
    entry = {
        "sheetmorph_certificate": 1,
        "criteria": {"name": criteria.name, "elements": criteria.elements},
        "features": _features(core, model, written),
        "contacts": _contacts(core, model, written),
        "parts": [part_entry(core, part, criteria) for part in written.values()],
        "penetrations": _penetrations(core, written),
        "decks": decks,
        "inputs": _digests([path, *(f for s in parts.sources for f in s.file.files_read)]),
        "outputs": _digests([f for s in parts.sources for f in s.file.targets(folder)]),
    }
    failures = _failures(entry, criteria)
    certificate = {**entry, "passed": not failures, "failures": failures}
    _write(certificate, written, targets)
    if failures:
        raise NotCertified(certificate)
    return certificate


def _digests(paths: list[Path]) -> list[dict[str, str]]:
    return [{"file": path.name, "sha256": digest(path)} for path in dict.fromkeys(paths)]


def _write(certificate: dict[str, Any], written: dict[str, Written], targets: Targets) -> None:
    with FileSet() as files:
        if targets.json is not None:
            text = json.dumps(certificate, indent=2, ensure_ascii=False, allow_nan=False)
            files.temporary_for(targets.json).write_text(text + "\n", "utf-8")
        if targets.page is not None:
            text = page_of(certificate, written)
            files.temporary_for(targets.page).write_text(text, "utf-8")
        files.commit()


def _written(parts: Parts, folder: Path) -> tuple[dict[str, Written], list[dict[str, Any]]]:
    """The parts by name, and what decks tell of what hangs on them."""
    thickness = part_thickness(parts.sources)
    materials = part_material(parts.sources)
    entries = {entry.name: entry for entry in parts.entries}
    found: dict[str, Written] = {}
    decks = []
    for source in parts.sources:
        place = folder / source.file.output_name
        if not place.is_file():
            todo = "name the folder that a run of this recipe wrote"
            raise FileError(place, "there is no such file", todo)
        stored = _stored(source, place)
        told = _told_again(source, stored, place)
        decks += [told] if told else []
        faces = _faces(source)
        places = source.placement.placed(stored)
        for name, vertices in source.members.items():
            given = entries[name].sheet.thickness or thickness.get(name, 0.0)
            mesh = parts.meshes[name]
            error = _width_error(source, mesh.points)
            own = _own_faces(faces, vertices, mesh)
            material = materials.get(name, STEEL)
            found[name] = Written(mesh, places[vertices], own, given, error, material)
    return found, decks


def _stored(source: Source, place: Path) -> np.ndarray:
    stored = source.file.stored_positions(place)
    if stored.shape != source.file.mesh.points.shape:
        what = f"it has {len(stored)} vertices, the part {len(source.file.mesh.points)}"
        raise FileError(place, what, "name the folder that a run of this recipe wrote")
    return stored


def _told_again(source: Source, stored: np.ndarray, place: Path) -> dict[str, Any] | None:
    if not isinstance(source.file, DeckFile):
        return None
    return source.file.told_of(source.file.stored_deck(place).points)


def _faces(source: Source) -> np.ndarray:
    """(m, 4) corners of the elements of a file, -1 in the last one of triangles."""
    if isinstance(source.file, DeckFile):
        return source.file.corner_faces
    triangles = source.file.mesh.triangles
    return np.concatenate([triangles, np.full((len(triangles), 1), -1)], axis=1)


def _own_faces(faces: np.ndarray, vertices: np.ndarray, mesh: Any) -> np.ndarray:
    row = np.full(int(max(faces.max(initial=0), vertices.max(initial=0))) + 2, -1)
    row[vertices] = np.arange(len(vertices))
    inside = row[faces[:, 0]] >= 0
    return np.where(faces[inside] >= 0, row[faces[inside]], -1)


def _width_error(source: Source, points: np.ndarray) -> float:
    """What a coordinate in the file is good for, mm: half its last digit."""
    size = float(np.abs(points).max(initial=1.0))
    precision = source.file.precision
    if precision in _DIGITS:
        return _DIGITS[precision] * size
    width = int(precision.split()[0])
    # A sign, a point, and what stands before it.
    decimals = width - 2 - len(str(int(size)))
    return 0.5 * 10.0 ** -min(decimals, 15)


def _features(core: Any, model: Model, written: dict[str, Written]) -> list[dict[str, Any]]:
    sized = {name for name, motion in model.pose.items() if motion.size is not None}
    found = []
    for region in model.of_kind("feature"):
        part = written.get(region.part)
        if part is None:
            continue
        entry = feature_entry(core, part, region.name, _vertices(region, part))
        is_sized = region.size is not None or region.name in sized
        found.append({**entry, "allowed": None} if is_sized else entry)
    return found


def _vertices(region: RegionEntry, part: Written) -> np.ndarray:
    rows, _ = part.mesh.find(region.vertices or [])
    return rows


def _contacts(core: Any, model: Model, written: dict[str, Written]) -> list[dict[str, Any]]:
    found = []
    for contact in model.contacts:
        if contact.a.part in written and contact.b.part in written:
            parts = [written[side.part] for side in (contact.a, contact.b)]
            rows = [_vertices(side, part) for side, part in zip((contact.a, contact.b), parts)]
            found.append(contact_entry(core, contact.name, tuple(zip(parts, rows))))
    return found


def _penetrations(core: Any, written: dict[str, Written]) -> list[dict[str, Any]]:
    pairs = itertools.permutations(written.values(), 2)
    found = (penetrations(core, one, other) for one, other in pairs)
    return [entry for entry in found if entry is not None]


def _failures(entry: dict[str, Any], criteria: Criteria) -> list[str]:
    """A sentence for everything that does not hold."""
    found = [
        f"{one['name']} on {one['part']} lost its form by {one['edge_error']:.3g} mm, "
        f"{one['allowed']:.3g} mm is what its file may cost"
        for one in entry["features"]
        if one["allowed"] is not None and one["edge_error"] > one["allowed"]
    ]
    for part in entry["parts"]:
        if part["flipped"]:
            found.append(f"{part['flipped']} triangles of {part['name']} fold over")
        if part["newly_failing"] > criteria.allowed:
            count = part["newly_failing"]
            found.append(f"{count} elements of {part['name']} newly fail the criteria")
    for one in entry["penetrations"]:
        found.append(
            f"{one['part']} newly stands {one['depth']:.3g} mm in {one['into']} "
            f"({one['vertices']} vertices)"
        )
    for one in entry["contacts"]:
        if criteria.gap_change is not None and one["worst_change"] > criteria.gap_change:
            found.append(f"the gap of {one['name']} changed by {one['worst_change']:.3g} mm")
    return found + [text for deck in entry["decks"] for text in deck["failures"]]
