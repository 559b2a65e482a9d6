# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part files of a recipe."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Fault, FileError, fault_of
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..decks import is_deck
from ..files import PartFile, is_cad, output_name, unpacked_name
from ..files.cad_writing import CadWriting
from ..files.deck_file import DeckFile
from ..files.prepared_file import PreparedFile
from .found import Found, Resolved
from .model import JointFileEntry, PartEntry
from .placement import Placement
from .reading_ahead import ReadAhead
from .splitting import SplitError, part_of, split_triangles

# Part names that are valid file names on any system.
_NAME_OF_FILE = re.compile(r"\w[\w .+-]*")


@dataclass
class Source:
    """A file with its parts: name to vertex indices (k,) in the file.

    writing is the output of its CAD shapes, or None. split is the way the file is split, or "".
    """

    file: PartFile
    placement: Placement = Placement()
    members: dict[str, Ints] = field(default_factory=dict)
    writing: CadWriting | None = None
    split: str = ""

    def positions(self, of_parts: dict[str, Floats]) -> Floats:
        """Return the positions (n, 3) of all vertices in file coordinates.

        Vertices without a part, and vertices that did not move, keep their positions. A vertex of
        several parts gets the mean of their positions.
        """
        own = self.file.mesh.points
        rest = self.placement.placed(own)
        whole = rest.copy()
        count = np.zeros(len(own), dtype=np.int32)
        for name, vertices in self.members.items():
            is_new = count[vertices] == 0
            count[vertices] += 1
            whole[vertices[is_new]] = of_parts[name][is_new]
            known = vertices[~is_new]
            whole[known] += (of_parts[name][~is_new] - whole[known]) / count[known][:, None]
        moved = (whole != rest).any(axis=1)
        return np.where(moved[:, None], self.placement.taken_back(whole), own)


@dataclass
class Parts:
    """All parts of a recipe; a split file has several entries here.

    joint_files has the entries of files with welds and bolts.
    """

    entries: list[PartEntry] = field(default_factory=list)
    meshes: dict[str, PartMesh] = field(default_factory=dict)
    sources: list[Source] = field(default_factory=list)
    faults: list[Fault] = field(default_factory=list)
    unread: list[str] = field(default_factory=list)
    joint_files: list[JointFileEntry] = field(default_factory=list)
    found: Found | None = None
    resolved: Resolved = field(default_factory=lambda: Resolved({}))

    def add(self, entry: PartEntry, file: PartFile) -> None:
        """Add the part, or the parts, of a file."""
        source = Source(file, entry.placement, writing=entry.write, split=entry.split)
        whole = entry.placement.placed_mesh(file.mesh)
        if not entry.split:
            thickness = file.thickness_of(np.arange(len(whole.triangles)))
            source.members[entry.name] = np.arange(len(whole.points))
            self.meshes[entry.name] = replace(whole, thickness=thickness)
            self.entries.append(entry)
        else:
            for number, rows in split_triangles(file, entry.split).items():
                name = f"{entry.stem}/{number}"
                mesh, source.members[name] = part_of(whole, rows, name)
                self.meshes[name] = replace(mesh, thickness=file.thickness_of(rows))
                self.entries.append(replace(entry, name=name, split=""))
        self.sources.append(source)


def read_parts(
    entries: list[PartEntry], base: str | Path, progress: Progress | None = None
) -> Parts:
    """Read the parts of a recipe, with paths relative to `base`; failures are in `faults`.

    progress(fraction, task) may return False to cancel (RuntimeError).
    """
    parts = Parts()
    stems = _stems(entries, Path(base))
    wanted = {
        entry.where: (Path(base) / entry.file, entry.meshing if is_cad(entry.file) else None)
        for entry in entries
        if entry.file
    }
    with ReadAhead(wanted) as ahead:
        for number, entry in enumerate(entries):
            if progress is not None:
                progress(number / len(entries), f"reading {entry.file}")
            parts.faults += _faults_of(entry)
            if not entry.file:
                parts.entries.append(entry)
                continue
            try:
                file = ahead.read(entry.where)
                parts.faults += _deck_settings(file, entry)
                file = _prepared(file, entry, progress) if entry.wanted else file
                file.stem = stems.get(entry.where, file.stem)
                parts.add(entry, file)
            except (FileError, SplitError) as error:
                parts.faults.append(_fault(entry, error))
                parts.entries += [] if entry.split else [entry]
                parts.unread += [f"{entry.stem}/"] if entry.split else []
    parts.faults += _clashes(entries, stems)
    return parts


def _faults_of(entry: PartEntry) -> list[Fault]:
    """What is wrong with an entry before its file is read."""
    if not entry.file:
        what = 'the key "file" is missing'
        return [Fault(entry.where, what, "add the path of its mesh file")]
    faults = _write_faults(entry)
    if entry.meshing and not is_cad(entry.file):
        what = "only CAD files are meshed"
        faults.insert(0, Fault(f"{entry.where}.mesh", what, "leave it out"))
    return faults


def _stems(entries: list[PartEntry], base: Path) -> dict[str, str]:
    """Return output stems for parts that use the same file, by the place of their entries.

    Each is written under its own name. Decks are left out, because they can consist of several
    files.
    """
    placed: dict[Path, list[PartEntry]] = {}
    for entry in entries:
        if entry.file and not entry.split and not is_deck(unpacked_name(entry.file)):
            placed.setdefault((base / entry.file).resolve(), []).append(entry)
    return {
        entry.where: entry.name
        for own in placed.values()
        if len(own) > 1 and all(_NAME_OF_FILE.fullmatch(entry.name) for entry in own)
        for entry in own
    }


def _write_faults(entry: PartEntry) -> list[Fault]:
    """Return faults of the key `write`: CAD shapes need a CAD file and its own mesh."""
    if entry.write is None:
        return []
    where = f"{entry.where}.write"
    if not is_cad(entry.file):
        what = f'"{entry.file}" is not a CAD file, so it has no CAD shape to write'
        return [Fault(where, what, "leave it out, or use the CAD file of the part")]
    if entry.wanted:
        what = "scale, weld and remesh give the part another mesh than that of its shape"
        return [Fault(where, what, 'leave those out; "mesh" says how finely a shape is meshed')]
    return []


def _deck_settings(file: PartFile, entry: PartEntry) -> list[Fault]:
    """Pass the deck keys of the entry to the deck; return a fault for any other file."""
    if entry.deck and (not isinstance(file, DeckFile) or entry.wanted):
        key = next(iter(entry.deck))
        what = "only a deck that is not prepared has passengers and joints"
        return [Fault(f"{entry.where}.{key}", what, "leave it out")]
    if isinstance(file, DeckFile):
        file.settings = entry.deck
    return []


def _prepared(file: PartFile, entry: PartEntry, progress: Progress | None) -> PartFile:
    """Return the file after scaling, merging and remeshing. Raises FileError."""
    try:
        return PreparedFile(file, entry.wanted, progress)
    except ValueError as error:
        fault = fault_of(error, "run `doctor` on it to see why", "")
        what = f"{fault.where}: {fault.what}" if fault.where else fault.what
        raise FileError(file.path, f"it cannot be prepared: {what}", fault.todo) from error


def parts_of_meshes(entries: list[PartEntry], meshes: Mapping[str, PartMesh]) -> list[PartEntry]:
    """Replace the entries of split files by one entry for each of their meshes."""
    found = []
    for entry in entries:
        names = [name for name in meshes if name.startswith(f"{entry.stem}/")]
        split = [replace(entry, name=name, split="") for name in names]
        found += split if entry.split else [entry]
    return found


def _fault(entry: PartEntry, error: FileError | SplitError) -> Fault:
    if isinstance(error, FileError):
        return error.fault(f"{entry.where}.file").about(entry.subject)
    return Fault(f"{entry.where}.split", error.what, error.todo).about(entry.subject)


def _clashes(entries: list[PartEntry], stems: Mapping[str, str]) -> list[Fault]:
    """Return faults for equal output names, because all parts are written into one folder."""
    faults = []
    seen: dict[str, str] = {}
    for entry in entries:
        name = output_name(entry.file) if entry.file else ""
        name = f"{entry.stem}.obj" if name and entry.wanted else name
        name = f"{stems[entry.where]}{Path(name).suffix}" if entry.where in stems else name
        if name and name in seen:
            what = f'the file name "{name}" is already used by {seen[name]}'
            todo = "rename one of the files; results are written into one folder"
            faults.append(Fault(f"{entry.where}.file", what, todo))
        elif name:
            seen[name] = entry.where
        if entry.split and entry.name:
            what = f'parts of a split file are called "{entry.stem}/..."'
            faults.append(Fault(f"{entry.where}.name", what, "leave the name out"))
    return faults
