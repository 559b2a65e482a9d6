# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points of welds and bolts that follow the joined sheets, and checks of the joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.errors import Fault, FileError, RecipeError
from ..base.motion import Motion, on_triangle, turn_at
from ..files import FileSet
from ..recipe.model import JointFileEntry
from ..recipe.parts import Parts
from . import read_joint_file
from .points import Joint, JointFile
from .sheets import Foot, Piece, Sheets

# Largest distance of a point from its sheet, mm, or the median edge length if that is larger.
_REACH = 10.0
# A joint is broken if it opens by more than the largest of these: half its gap, half the thickness
# of its thinnest sheet, and this share of the median edge length of its sheets.
_HALF, _OF_EDGE = 0.5, 0.1
_SHOWN = 20
_MOST_SHEETS = 8


@dataclass(frozen=True)
class Placed:
    """The moved points (n, 3), mm, and directions (d, 3) of a file.

    images has for each point its position according to each sheet. feet has its feet on the sheets
    before and after, (k, 3).
    """

    points: Floats
    directions: Floats
    images: list[Floats]
    feet: list[tuple[Floats, Floats]]


class JointSource:
    """A joint file of a recipe, attached to the sheets at rest."""

    def __init__(self, file: JointFile, settings: JointFileEntry, sheets: Sheets):
        self.file, self.settings, self._sheets = file, settings, sheets
        self._points, self._directions = file.points, file.directions
        self._feet: list[list[Foot]] = [[] for _ in self._points]
        self._limits = np.zeros(len(self._points))
        self._unknown: set[str] = set()
        self.left: list[Joint] = [joint for joint in file.joints if not self._attach(joint)]

    def _attach(self, joint: Joint) -> bool:
        """Find the sheets of a joint; return whether every point has one."""
        pieces = [self._sheets.named(names) for names in joint.parts if names]
        self._unknown |= {
            names[0] for names, found in zip(joint.parts, pieces) if names and not found
        }
        if not joint.parts:
            pieces = [[piece] for piece in self._sheets.all()]
        for row in joint.points:
            near = [self._nearest(found, row) for found in pieces if found]
            chosen = sorted(filter(None, near), key=lambda pair: pair[0].distance)[:_MOST_SHEETS]
            self._feet[row] = [foot for foot, _ in chosen]
            self._limits[row] = _limit(chosen) if chosen else 0.0
        return all(self._feet[row] for row in joint.points)

    def _nearest(self, pieces: list[Piece], row: int) -> tuple[Foot, Piece] | None:
        """Return the nearest foot on some sheets, if it is close enough."""
        found = None
        for piece in pieces:
            foot = piece.foot(self._points[row])
            reach = self.settings.reach
            within = max(_REACH, piece.edge) if reach is None else reach
            if foot is not None and foot.distance <= within:
                if found is None or foot.distance < found[0].distance:
                    found = foot, piece
        return found

    def targets(self, folder: Path) -> list[Path]:
        """Return the files that a run writes."""
        return [folder / self.file.path.name]

    def write_into(self, files: FileSet, path: Path, of_parts: Mapping[str, Floats]) -> None:
        """Write the file for the given part positions; it gets its name when `files` commits."""
        placed = self._placed(self._motions(of_parts))
        temporary = files.temporary_for(path)
        with files.named(temporary), temporary.open("wb") as out:
            self.file.save(placed.points, placed.directions, out)

    def told(self, of_parts: Mapping[str, Floats]) -> dict[str, Any]:
        """Return the report entry: moved and unattached points, and broken joints."""
        placed = self._placed(self._motions(of_parts))
        return self._told(placed, placed.points)

    def told_of(self, path: Path, of_parts: Mapping[str, Floats]) -> dict[str, Any]:
        """Return the report entry of a written file, with the parts at positions (n, 3).

        Raises FileError if it is missing or has other joints.
        """
        again = read_joint_file(path)
        names = [joint.name for joint in self.file.joints]
        if [j.name for j in again.joints] != names or len(again.points) != len(self._points):
            what = f"it has other joints than {self.file.path.name}"
            raise FileError(path, what, "name the folder that a run of this recipe wrote")
        return self._told(self._placed(self._motions(of_parts)), again.points)

    def _motions(self, of_parts: Mapping[str, Floats]) -> list[Motion]:
        return self._sheets.motions(of_parts, [foot for some in self._feet for foot in some])

    def _placed(self, motions: list[Motion]) -> Placed:
        points, directions = self._points.copy(), self._directions.copy()
        images: list[Floats] = []
        places: list[tuple[Floats, Floats]] = []
        for row, feet in enumerate(self._feet):
            places.append(_places(motions, feet))
            images.append(np.array([_image(motions, foot, points[row]) for foot in feet]))
            if len(feet) and (images[row] != points[row]).any():
                points[row] = images[row].mean(axis=0)
        for joint in self.file.joints:
            feet = [foot for row in joint.points for foot in self._feet[row]]
            if not joint.directions or not feet:
                continue
            if all(_stays(motions, foot) for foot in feet):
                continue
            turn = turn_at([(motions[foot.source], foot.triangle) for foot in feet])
            directions[joint.directions] = directions[joint.directions] @ turn.T
        return Placed(points, directions, images, places)

    def _told(self, placed: Placed, points: Floats) -> dict[str, Any]:
        entries = [self._entry(joint, placed, points) for joint in self.file.joints]
        broken = [entry for entry in entries if entry["change"] > entry["limit"]]
        texts = [self._broken_text(entry) for entry in broken[:_SHOWN]]
        if len(broken) > _SHOWN:
            texts.append(f"{self.file.path.name}: {len(broken) - _SHOWN} more joints came apart")
        notes = [f"{self.file.path.name}: {note}" for note in self.file.notes]
        if self._unknown:
            shown = ", ".join(f'"{name}"' for name in sorted(self._unknown)[:_SHOWN])
            notes.append(f"{self.file.path.name}: no part of this recipe is called {shown}")
        if self.left:
            names = ", ".join(joint.name or "?" for joint in self.left[:_SHOWN])
            more = " and more" if len(self.left) > _SHOWN else ""
            what = "joints have no sheet within reach and stay in place"
            notes.append(f"{self.file.path.name}: {len(self.left)} {what}: {names}{more}")
        refused = self.settings.is_refused
        return {
            "file": self.file.path.name,
            "format": self.file.form,
            "points": len(points),
            "moved": int((points != self._points).any(axis=1).sum()),
            "left": [joint.name for joint in self.left],
            "joints": entries,
            "broken": [entry["joint"] for entry in broken],
            "failures": texts if refused else [],
            "notes": notes if refused else [*notes, *texts],
        }

    def _entry(self, joint: Joint, placed: Placed, points: Floats) -> dict[str, Any]:
        """Return the entry of a joint: its gap before and after, and how far it opened."""
        change, limit = 0.0, 0.0
        gaps = [0.0, 0.0]
        for row in joint.points:
            limit = max(limit, float(self._limits[row]))
            if self.settings.limit is not None:
                limit = self.settings.limit
            if not self._feet[row]:
                continue
            before, after = placed.feet[row]
            change = max(change, _widest(placed.images[row], points[row]))
            gaps[0] = max(gaps[0], _widest(before, self._points[row]))
            gaps[1] = max(gaps[1], _widest(after, points[row]))
        return {
            "joint": joint.name,
            "kind": joint.kind,
            "line": joint.line + 1,
            "parts": [names[0] for names in joint.parts if names],
            "gap_before": gaps[0],
            "gap_after": gaps[1],
            "change": change,
            "limit": limit,
        }

    def _broken_text(self, entry: Mapping[str, Any]) -> str:
        shown = " ".join(filter(None, (entry["kind"], entry["joint"]))) or "a joint"
        return (
            f"{self.file.path.name}, line {entry['line']}: {shown} came apart by "
            f"{entry['change']:.3g} mm (allowed {entry['limit']:.3g} mm)"
        )


def _limit(chosen: Sequence[tuple[Foot, Piece]]) -> float:
    gap = sum(sorted(foot.distance for foot, _ in chosen)[-2:])
    known = [piece.thickness for _, piece in chosen if piece.thickness > 0.0]
    edge = min(piece.edge for _, piece in chosen)
    return max(_HALF * gap, _HALF * min(known, default=0.0), _OF_EDGE * edge, 1e-9)


def _stays(motions: list[Motion], foot: Foot) -> bool:
    motion = motions[foot.source]
    return motion.stays(motion.triangles[foot.triangle])


def _image(motions: list[Motion], foot: Foot, point: Floats) -> Floats:
    if _stays(motions, foot):
        return point
    return on_triangle(motions[foot.source], foot.triangle, foot.barycentric, point)


def _places(motions: list[Motion], feet: Sequence[Foot]) -> tuple[Floats, Floats]:
    """Return the positions (k, 3) of feet, before and after."""
    found: tuple[list[Floats], list[Floats]] = ([], [])
    for foot in feet:
        motion = motions[foot.source]
        corners = motion.triangles[foot.triangle]
        for some, points in zip(found, (motion.rest, motion.moved)):
            some.append(foot.barycentric @ points[corners])
    return np.array(found[0]), np.array(found[1])


def _widest(places: Floats, point: Floats) -> float:
    """Return the largest distance among some positions and a point."""
    whole = np.concatenate([places, point[None]])
    return float(np.linalg.norm(whole[:, None] - whole, axis=2).max())


def joint_sources(parts: Parts, base: str | Path) -> list[JointSource]:
    """Read the joint files of a recipe, relative to `base`. Raises RecipeError."""
    if not parts.joint_files:
        return []
    thickness = {
        entry.name: entry.sheet.thickness or parts.meshes[entry.name].thickness
        for entry in parts.entries
        if entry.name in parts.meshes
    }
    sheets = Sheets(parts.sources, thickness)
    found: list[JointSource] = []
    faults: list[Fault] = []
    names = [source.file.output_name for source in parts.sources]
    for entry in parts.joint_files:
        name = Path(entry.file).name
        if name in names:
            what = f'the file name "{name}" is already used'
            faults.append(Fault(f"{entry.where}.file", what, "rename one of the files"))
            continue
        names.append(name)
        try:
            found.append(JointSource(read_joint_file(Path(base) / entry.file), entry, sheets))
        except FileError as error:
            faults.append(error.fault(f"{entry.where}.file"))
    if faults:
        raise RecipeError(faults)
    return found
