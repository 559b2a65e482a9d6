# SPDX-License-Identifier: LGPL-2.1-or-later
"""The certificate: the files of a run, read again, measured and judged."""

from __future__ import annotations

import itertools
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Fault, FileError, SheetMorphError
from ..base.kernel import load_kernel
from ..base.pages import require_pages
from ..base.words import counted, folds
from ..checking import prepare
from ..checking.auto import filled
from ..decks.materials import STEEL
from ..files import FileSet, PartFile
from ..files.deck_file import DeckFile
from ..finding.deck import part_material
from ..joint_files.following import JointSource, joint_sources
from ..recipe.model import ContactEntry, Model, RegionEntry, model_of
from ..recipe.parts import Parts, Source
from ..recipe.reading import named_in, read_json
from .criteria import Criteria
from .measuring import (
    RestContact,
    RestFeature,
    Sheet,
    Written,
    contact_entry,
    digest,
    feature_entry,
    part_entry,
    penetrations,
)
from .page import page_of

# Relative error of a coordinate in a format with binary numbers.
_DIGITS = {"float32": 6e-8, "double": 2e-16}


class NotCertified(SheetMorphError, RuntimeError):
    """The files miss the criteria; ``certificate`` has the details."""

    def __init__(self, certificate: dict[str, Any]):
        failures = certificate["failures"]
        more = f" and {len(failures) - 5} more" if len(failures) > 5 else ""
        faults = [Fault("", text, "", "not certified") for text in failures]
        super().__init__(faults, "not certified: " + "; ".join(failures[:5]) + more)
        self.certificate = certificate


@dataclass(frozen=True)
class Targets:
    """Output files of a certificate, as JSON and as HTML page; None if not wanted."""

    json: Path | None = None
    page: Path | None = None


def certify(
    recipe_path: str | Path,
    out_dir: str | Path,
    criteria: Criteria,
    targets: Targets = Targets(),
    *,
    files: FileSet | None = None,
) -> dict[str, Any]:
    """Certify the files of a run in a folder and return the certificate.

    files is a new FileSet for the targets. Raises RecipeError, FileError, KernelError, OSError, and
    NotCertified after the certificate is written.
    """
    path, folder = Path(recipe_path), Path(out_dir)
    recipe = read_json(path)
    with named_in(path):
        parts = prepare(recipe, path.parent)
        beside = joint_sources(parts, path.parent)
    whole = parts.resolved.recipe
    model = model_of(whole if parts.found is None else filled(whole, parts.found))
    certifier = Certifier(parts, model, criteria, Inputs(path, beside))
    places = {name: at for s in parts.sources for name, at in _places_in(s, folder).items()}
    files = files or FileSet("certify")
    files.reads += [path, *(file for s in parts.sources for file in s.file.files_read)]
    files.reads += [file for s in parts.sources for file in s.file.targets(folder)]
    files.reads += [file for one in beside for file in (one.file.path, *one.targets(folder))]
    for target in (targets.json, targets.page):
        if target is not None:
            files.require_ours(target)
    if targets.page is not None:
        require_pages()
    written = certifier.written(places)
    sizes = {name: motion.size for name, motion in model.pose.items() if motion.size is not None}
    certificate = certifier.certificate(folder, written, sizes)
    _write(certificate, written, targets, files)
    if not certificate["passed"]:
        raise NotCertified(certificate)
    return certificate


@dataclass(frozen=True)
class Inputs:
    """Inputs of a run besides its parts: the recipe, and joint files with welds and bolts."""

    recipe: Path
    joint_files: Sequence[JointSource] = ()


class Certifier:
    """The certification of runs of one recipe, whose rest state is measured once.

    Every region of the model has a vertex list.
    """

    def __init__(self, parts: Parts, model: Model, criteria: Criteria, inputs: Inputs):
        self._core = load_kernel()
        self._sources, self._criteria = parts.sources, criteria
        self._sheets, self._joint_files = _sheets(parts), inputs.joint_files
        regions = [region for region in model.of_kind("feature") if region.part in self._sheets]
        self._features = [self._rest_feature(region) for region in regions]
        self._sizes = {region.name: region.size for region in regions if region.size is not None}
        self._contacts = [
            self._rest_contact(contact)
            for contact in model.contacts
            if contact.a.part in self._sheets and contact.b.part in self._sheets
        ]
        read = [path for source in self._sources for path in source.file.files_read]
        beside = [one.file.path for one in inputs.joint_files]
        self._inputs = _digests([inputs.recipe, *read, *beside])

    def written(self, places: Mapping[str, Floats]) -> dict[str, Written]:
        """Return the parts by name with their positions (n, 3) as stored in the files."""
        return {name: Written(sheet, places[name]) for name, sheet in self._sheets.items()}

    def certificate(
        self, folder: Path, written: dict[str, Written], sizes: Mapping[str, float] = {}
    ) -> dict[str, Any]:
        """Return the certificate of the files in a folder; sizes, mm, are those of the pose."""
        core, criteria = self._core, self._criteria
        files: list[PartFile | JointSource] = [source.file for source in self._sources]
        files += self._joint_files
        entry = {
            "sheetmorph_certificate": 1,
            "criteria": {"name": criteria.name, "elements": criteria.elements},
            "features": [self._feature(one, written, sizes) for one in self._features],
            "contacts": [
                contact_entry(one, (written[one.parts[0]], written[one.parts[1]]))
                for one in self._contacts
            ],
            "parts": [part_entry(core, part, criteria) for part in written.values()],
            "penetrations": _penetrations(written),
            "decks": [told for source in self._sources for told in _told_again(source, folder)],
            "joint_files": self._told_of_joints(folder, written),
            "inputs": self._inputs,
            "outputs": _digests([place for file in files for place in file.targets(folder)]),
        }
        failures = _failures(entry, criteria)
        return {**entry, "passed": not failures, "failures": failures}

    def _told_of_joints(self, folder: Path, written: dict[str, Written]) -> list[dict[str, Any]]:
        places = {name: part.places for name, part in written.items()}
        return [one.told_of(one.targets(folder)[0], places) for one in self._joint_files]

    def _rest_feature(self, region: RegionEntry) -> RestFeature:
        sheet = self._sheets[region.part]
        return RestFeature(self._core, sheet, region.name, _vertices(region, sheet))

    def _rest_contact(self, contact: ContactEntry) -> RestContact:
        one, two = (self._sheets[side.part] for side in (contact.a, contact.b))
        rows = _vertices(contact.a, one), _vertices(contact.b, two)
        return RestContact(contact.name, (one, two), rows)

    def _feature(
        self, feature: RestFeature, written: dict[str, Written], sizes: Mapping[str, float]
    ) -> dict[str, Any]:
        size = sizes.get(feature.name, self._sizes.get(feature.name))
        entry = feature_entry(self._core, written[feature.part], feature, size)
        return entry if size is None else {**entry, "allowed": None}


def _digests(paths: list[Path]) -> list[dict[str, str]]:
    return [{"file": path.name, "sha256": digest(path)} for path in dict.fromkeys(paths)]


def _write(
    certificate: dict[str, Any], written: dict[str, Written], targets: Targets, files: FileSet
) -> None:
    with files:
        if targets.json is not None:
            text = json.dumps(certificate, indent=2, ensure_ascii=False, allow_nan=False)
            files.temporary_for(targets.json).write_text(text + "\n", "utf-8")
        if targets.page is not None:
            text = page_of(certificate, written)
            files.temporary_for(targets.page).write_text(text, "utf-8")
        files.commit()


def _sheets(parts: Parts) -> dict[str, Sheet]:
    """Return the parts at rest, by name."""
    materials = part_material(parts.sources)
    entries = {entry.name: entry for entry in parts.entries}
    found: dict[str, Sheet] = {}
    for source in parts.sources:
        faces = _faces(source)
        for name, vertices in source.members.items():
            mesh = parts.meshes[name]
            given = entries[name].sheet.thickness or mesh.thickness
            own = _own_faces(faces, vertices)
            error = _width_error(source, mesh.points)
            found[name] = Sheet(name, mesh, own, given, error, materials.get(name, STEEL))
    return found


def _places_in(source: Source, folder: Path) -> dict[str, Floats]:
    """Return the positions (n, 3) of the parts in a written file, by part name."""
    place = folder / source.file.output_name
    if not place.is_file():
        todo = "name the folder that a run of this recipe wrote"
        raise FileError(place, "the file does not exist", todo)
    stored = source.file.stored_positions(place)
    if stored.shape != source.file.mesh.points.shape:
        what = f"it has {len(stored)} vertices, but the part has {len(source.file.mesh.points)}"
        raise FileError(place, what, "name the folder that a run of this recipe wrote")
    places = source.placement.placed(stored)
    return {name: places[vertices] for name, vertices in source.members.items()}


def _told_again(source: Source, folder: Path) -> list[dict[str, Any]]:
    """Return the report entry of a written deck, or nothing for other files."""
    if not isinstance(source.file, DeckFile):
        return []
    told = source.file.told_of(source.file.stored_nodes(folder / source.file.output_name))
    return [told] if told else []


def _faces(source: Source) -> Ints:
    """Return the element corners (m, 4) of a file; the last one is -1 for triangles."""
    if isinstance(source.file, DeckFile):
        return source.file.corner_faces
    triangles = source.file.mesh.triangles
    return np.concatenate([triangles, np.full((len(triangles), 1), -1)], axis=1)


def _own_faces(faces: Ints, vertices: Ints) -> Ints:
    row = np.full(int(max(faces.max(initial=0), vertices.max(initial=0))) + 2, -1)
    row[vertices] = np.arange(len(vertices))
    inside = row[faces[:, 0]] >= 0
    return np.where(faces[inside] >= 0, row[faces[inside]], -1)


def _width_error(source: Source, points: Floats) -> float:
    """Return the rounding error of a coordinate in the file, mm: half its last digit."""
    size = float(np.abs(points).max(initial=1.0))
    precision = source.file.precision
    if precision in _DIGITS:
        return _DIGITS[precision] * size
    width = int(precision.split()[0])
    # The field also has a sign, a decimal point and the integer digits.
    decimals = width - 2 - len(str(int(size)))
    return 0.5 * 10.0 ** -min(decimals, 15)


def _vertices(region: RegionEntry, sheet: Sheet) -> Ints:
    rows, _ = sheet.mesh.find(region.vertices or [], region.is_prepared)
    return rows


def _penetrations(written: dict[str, Written]) -> list[dict[str, Any]]:
    pairs = itertools.permutations(written.values(), 2)
    found = (penetrations(one, other) for one, other in pairs)
    return [entry for entry in found if entry is not None]


def _failures(entry: dict[str, Any], criteria: Criteria) -> list[str]:
    """Return a sentence for every criterion that the run misses."""
    found = [
        f"{one['name']} on {one['part']} lost its shape by "
        f"{one['edge_error']:.3g} mm (allowed by the file format: "
        f"{one['allowed']:.3g} mm)"
        for one in entry["features"]
        if one["allowed"] is not None and one["edge_error"] > one["allowed"]
    ]
    for part in entry["parts"]:
        if part["flipped"] and criteria.flipped:
            found.append(folds(part["flipped"], f" of {part['name']}"))
        if part["newly_failing"] > criteria.allowed:
            count = part["newly_failing"]
            where, fails = f" of {part['name']} newly", ("fails", "fail")[count != 1]
            failing = [
                f"{one['measure']}: {one['failing_after']} fail, {one['failing_before']} before"
                for one in part["quality"]
                if one["failing_after"] > one["failing_before"]
            ]
            what = f" ({'; '.join(failing)})" if failing else ""
            elements = counted(count, "element", "elements")
            found.append(f"{elements}{where} {fails} the criteria {criteria.name}{what}")
    for one in entry["penetrations"]:
        found.append(
            f"{one['part']} newly penetrates {one['into']} by {one['depth']:.3g} mm "
            f"({counted(one['vertices'], 'vertex', 'vertices')})"
        )
    for one in entry["contacts"]:
        if criteria.gap_change is not None and one["worst_change"] > criteria.gap_change:
            found.append(f"the gap of {one['name']} changed by {one['worst_change']:.3g} mm")
    beside = [*entry["decks"], *entry["joint_files"]]
    return found + [text for file in beside for text in file["failures"]]
