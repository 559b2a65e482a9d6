# SPDX-License-Identifier: LGPL-2.1-or-later
"""Decks as part files: the mesh is the sheet, and the output is the deck with its includes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import FileError, list_ids
from ..base.labels import Labels
from ..base.part_mesh import PartMesh
from ..decks import Deck, output_places, read_bytes, read_deck, sheet_of, suffixes
from ..decks.contents import Shells, shells_of, thickness_of
from ..decks.joints import Joint, joints_of
from ..decks.model import NamedSet
from ..decks.model import Place
from ..decks.passengers import Carried, Passengers, rules_of
from ..decks.placing import require_places
from ..decks.stale import stale_report
from .atomic import FileSet
from .part_file import PartFile

SUFFIXES = suffixes()
_SHOWN = 20
_KEEP = ", which rounding explains: mark its nodes as a form feature, which keeps them rigid"


class DeckFile(PartFile):
    """A deck as a part; vertices are the nodes of its shells in file order, ids are node ids.

    deck has the whole content and sheet the shells. settings are `passengers` and `joints` of the
    part entry in the recipe.
    """

    def __init__(self, path: Path):
        self.deck: Deck = read_deck(path)
        require_places(self.deck)
        self.sheet = sheet_of(self.deck)
        if not len(self.sheet.triangles):
            todo = "choose a deck with shell elements"
            raise FileError(path, "no shell elements were found", todo)
        nodes = self.sheet.nodes
        points, ids = self.deck.points[nodes], self.deck.ids[nodes]
        mesh = PartMesh(points, self.sheet.triangles, ids, path.stem, self._labels(ids))
        super().__init__(path, mesh, _precision(self.deck.width_of(nodes)))
        self.properties = self.sheet.properties
        if self.deck.form == "Abaqus":
            self.property_names = self.deck.raw.names
        self.notes += self.deck.raw.notes
        self.missing += self.deck.raw.cut
        self.settings: Mapping[str, Any] = {}
        self._passengers: Passengers | None = None
        self._last: tuple[Floats, Carried] | None = None
        self._stored: tuple[list[tuple[int, ...]], Floats] | None = None

    @property
    def files_read(self) -> list[Path]:
        return [self.origin, *(text.path for text in self.deck.texts[1:])]

    def targets(self, folder: Path) -> list[Path]:
        return output_places(self.deck.texts, folder / self.output_name)

    def _labels(self, ids: Ints) -> Labels:
        """Return the sets as groups.

        A set is named "SET 3", or "SET 3 nodes" and "SET 3 elements" if both are possible.
        """
        groups: dict[str, Ints] = {}
        nodes: dict[str, list[int]] = {}
        raw = self.deck.raw
        parts = [NamedSet(f"PART {name}", "properties", [k]) for k, name in raw.names.items()]
        for one in [*raw.sets, *(parts if raw.form == "LS-DYNA" else [])]:
            triangles, members = self._rows_of(one), np.empty(0, dtype=np.int64)
            if one.kind not in ("elements", "properties"):
                members = np.asarray(one.ids, dtype=np.int64)
                members = members[np.isin(members, ids)]
            count = len(np.unique(self.sheet.elements[triangles]))
            for name in ([one.name] if count >= len(members) else []) + [f"{one.name} elements"]:
                if count:
                    groups[name] = np.union1d(groups.get(name, triangles), triangles)
            for name in ([one.name] if len(members) > count else []) + [f"{one.name} nodes"]:
                if len(members):
                    nodes[name] = [*nodes.get(name, []), *members.tolist()]
        return Labels(groups, nodes)

    def _rows_of(self, one: NamedSet) -> Ints:
        """Return the triangles of a set of elements or properties."""
        if one.kind == "nodes":
            return np.empty(0, dtype=np.int64)
        of = self.sheet.properties if one.kind == "properties" else self.sheet.elements
        inside = np.isin(of, one.ids)
        if one.blocks:
            inside &= np.isin(self.sheet.blocks, one.blocks)
        return np.flatnonzero(inside)

    def save(self, path: Path, positions: Floats) -> None:
        with path.open("wb") as out:
            self.deck.save(self._all(positions), 0, out)

    def write_into(self, files: FileSet, path: Path, positions: Floats) -> Path:
        self._stored = None
        checked = self._all(self._checked(positions))
        self._require_free(checked)
        if self.is_wide and self.deck.form == "Nastran" and self.precision == "8 characters":
            self.precision = "16 characters"
        written = []
        for number, place in enumerate(output_places(self.deck.texts, path)):
            place.parent.mkdir(parents=True, exist_ok=True)
            temporary = files.temporary_for(place)
            with files.named(temporary), temporary.open("wb") as out:
                self.deck.save(checked, number, out, is_wide=self.is_wide)
            self._written[self.deck.texts[number].path] = temporary
            written.append(temporary)
        return written[0]

    def _require_free(self, positions: Floats) -> None:
        stuck = self.deck.unwritten(positions)
        if len(stuck):
            file, line = self.deck.place_of(int(stuck[0]))
            ids = self.deck.ids[stuck]
            what = f"the moved nodes {list_ids(ids.tolist())} cannot be written: "
            what += self.deck.raw.locked[int(ids[0])]
            todo = "write their coordinates as numbers, or do not move them"
            raise self.deck.texts[file].error(line, what, todo)

    @property
    def _written(self) -> dict[Path, Path]:
        found: dict[Path, Path] = self.__dict__.setdefault("_written_files", {})
        return found

    def _all(self, positions: Floats) -> Floats:
        """Return the positions (n, 3) of all nodes of the deck."""
        return self._carried(positions).positions

    @property
    def passengers(self) -> Passengers:
        """Everything attached to the sheet."""
        if self._passengers is None:
            rules = rules_of(self.settings.get("passengers"))
            self._passengers = Passengers(self.deck, self.sheet, rules)
        return self._passengers

    def _carried(self, positions: Floats) -> Carried:
        if self._last is None or not np.array_equal(self._last[0], positions):
            self._last = positions.copy(), self.passengers.carried(positions)
        return self._last[1]

    @property
    def corner_faces(self) -> Ints:
        """Vertex indices (m, 4) at the shell corners; the last one is -1 for triangles."""
        return self.sheet.faces

    def faces_among(self, vertices: Ints) -> Ints:
        """Return the corner faces (e, 4) of shells among vertices (k,), as indices into these."""
        row = np.full(len(self.mesh.points) + 1, -1, dtype=np.int32)  # the last entry maps -1 to -1
        row[vertices] = np.arange(len(vertices))
        faces = row[self.sheet.faces]
        found: Ints = faces[(faces[:, :3] >= 0).all(axis=1)]
        return found

    def shells_of(self, rows: Ints) -> list[Shells]:
        """Return the shell properties of some triangles (k,)."""
        return shells_of(self.deck, self.sheet, rows)

    def thickness_of(self, rows: Ints) -> float:
        return thickness_of(self.deck, self.sheet, rows)

    def told(self, positions: Floats) -> dict[str, Any]:
        """Return the report entry: attached nodes, joints, and data that the motion makes stale."""
        return self._told(self._carried(self._checked(positions)))

    def told_of(self, nodes: Floats) -> dict[str, Any]:
        """Return the report entry of a written deck with all nodes at positions (n, 3)."""
        rules = self._carried(nodes[self.sheet.nodes])
        return self._told(Carried(nodes, rules.counts, rules.left))

    def stored_deck(self, path: Path) -> Deck:
        """Return the written deck. Raises FileError if it has other nodes."""
        found = self._read_again(path)
        if not np.array_equal(found.ids, self.deck.ids):
            what = f"it has other nodes than {self.path.name}"
            raise FileError(path, what, "name the folder that a run of this recipe wrote")
        return found

    def _told(self, carried: Carried) -> dict[str, Any]:
        wanted = self.settings.get("joints") or {}
        joints = joints_of(self.deck, self.sheet, carried.positions, wanted.get("limit"))
        moved = (carried.positions != self.deck.points).any(axis=1)
        broken = [self._joint(joint) for joint in joints.broken]
        texts = [
            _broken_text(told) + (_KEEP if joint.is_rigid else "")
            for told, joint in zip(broken[:_SHOWN], joints.broken)
        ]
        if len(broken) > _SHOWN:
            texts.append(f"{len(broken) - _SHOWN} more joints came apart")
        is_refused = wanted.get("broken", "refuse") == "refuse"
        left = self.deck.ids[carried.left]
        return {
            "file": self.output_name,
            "format": self.deck.form,
            "moved": int(moved.sum()),
            "passengers": carried.counts,
            "left": left[left > 0].tolist(),
            "joints": {
                "count": joints.count,
                "worst": None if joints.worst is None else self._joint(joints.worst),
                "broken": broken,
                "welds": [
                    {**self._at(weld.place), "before": [*weld.before], "after": [*weld.after]}
                    for weld in joints.welds
                ],
            },
            "stale": stale_report(self.deck) if moved.any() else [],
            "failures": texts if is_refused else [],
            "notes": [] if is_refused else texts,
        }

    def _joint(self, joint: Joint) -> dict[str, Any]:
        return {**self._at(joint.place), "change": joint.change, "limit": joint.limit}

    def _at(self, place: Place) -> dict[str, Any]:
        name = self.deck.texts[place.file].name
        return {"card": place.card, "id": place.number, "file": name, "line": place.line + 1}

    def stored_positions(self, path: Path) -> Floats:
        return self.stored_nodes(path)[self.sheet.nodes]

    def stored_nodes(self, path: Path) -> Floats:
        """Return all node positions (n, 3) of the written deck; an unchanged file is read once."""
        state = _state_of(self._written_at(path).values())
        if self._stored is None or not state or self._stored[0] != state:
            self._stored = state, self.stored_deck(path).points
        return self._stored[1]

    def _read_again(self, path: Path) -> Deck:
        """Read the written deck at `path`."""
        written = self._written_at(path)
        return read_deck(self.path, lambda asked: read_bytes(written.get(asked, asked)))

    def _written_at(self, path: Path) -> dict[Path, Path]:
        """Return the paths of the written files, which may still be temporary."""
        texts = self.deck.texts
        places = dict(zip((text.path for text in texts), output_places(texts, path)))
        return {**places, **self._written} if self._is_unnamed(path) else places

    def _is_unnamed(self, path: Path) -> bool:
        return self._written.get(self.path) == path


def _state_of(places: Iterable[Path]) -> list[tuple[int, ...]]:
    """Return data that identify file versions; an empty list if a file is missing."""
    try:
        found = [place.stat() for place in places]
    except OSError:
        return []
    return [(one.st_dev, one.st_ino, one.st_mtime_ns, one.st_size) for one in found]


def _broken_text(joint: Mapping[str, Any]) -> str:
    name = f"{joint['card']} {joint['id']}" if joint["id"] else joint["card"]
    return (
        f"{joint['file']}, line {joint['line']}: {name} came apart by "
        f"{joint['change']:.3g} mm (allowed {joint['limit']:.3g} mm)"
    )


def _precision(width: int) -> str:
    return "double" if width >= 22 or not width else f"{width} characters"
