# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a file calls parts of its mesh: groups, properties, sets, CAD faces with their surfaces."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .arrays import Array, Ints


@dataclass(frozen=True)
class CadFace:
    """A face of a CAD file: number from 1 in its body, kind of surface, name, colour "#rrggbb"."""

    body: str
    number: int
    kind: str
    name: str = ""
    colour: str = ""


@dataclass(frozen=True, eq=False)
class Labels:
    """Names for parts of one mesh.

    groups: rows (k,) of triangles by name, "PID 7", "usemtl steel"; nodes: vertex ids of the file
    by name; face: (m,) index into ``faces`` of every triangle, None where no CAD face is known.
    """

    groups: Mapping[str, Ints] = field(default_factory=dict)
    nodes: Mapping[str, Sequence[int]] = field(default_factory=dict)
    face: Ints | None = None
    faces: tuple[CadFace, ...] = ()

    def with_groups(self, groups: Mapping[str, Ints]) -> Labels:
        """The same with more groups of triangles."""
        return replace(self, groups={**self.groups, **groups})

    def carried(self, triangle_of: Ints) -> Labels:
        """The labels of another mesh each of whose triangles (m,) comes from one of this mesh.

        Groups that have no triangle there are left out.
        """
        count = 1 + max(
            int(triangle_of.max(initial=-1)),
            *(int(rows.max(initial=-1)) for rows in self.groups.values()),
            -1,
        )
        groups = {}
        for name, rows in self.groups.items():
            inside = np.zeros(count, dtype=bool)
            inside[rows] = True
            rows_here = np.flatnonzero(inside[triangle_of])
            if len(rows_here):
                groups[name] = rows_here
        face = None if self.face is None else self.face[triangle_of]
        return replace(self, groups=groups, face=face)

    def arrays(self) -> dict[str, Array]:
        """The labels as arrays, for an .npz."""
        names = {"groups": list(self.groups), "nodes": list(self.nodes)}
        members = [*self.groups.values(), *self.nodes.values()]
        rows = [np.asarray(one, dtype=np.int64) for one in members]
        faces = [[f.body, f.number, f.kind, f.name, f.colour] for f in self.faces]
        return {
            "label_names": np.array(json.dumps({**names, "faces": faces})),
            "label_rows": np.concatenate([np.zeros(0, dtype=np.int64), *rows]),
            "label_ends": np.cumsum([len(one) for one in rows], dtype=np.int64),
            "label_face": np.zeros(0, dtype=np.int64) if self.face is None else self.face,
        }

    @classmethod
    def of_arrays(cls, data: Mapping[str, Array]) -> Labels | None:
        """The labels that arrays() gave; None where there are none."""
        if "label_names" not in data:
            return None
        told = json.loads(str(data["label_names"]))
        groups, nodes = told["groups"], told.get("nodes", [])
        rows = np.split(data["label_rows"], data["label_ends"])
        members = {name: ids.tolist() for name, ids in zip(nodes, rows[len(groups) :])}
        faces = tuple(CadFace(*face) for face in told["faces"])
        face = data["label_face"] if len(data["label_face"]) else None
        return cls(dict(zip(groups, rows)), members, face, faces)

    @property
    def names(self) -> list[str]:
        """Everything a group can be called, for messages."""
        return [*self.groups, *self.nodes]


def by_key(keys: Iterable[str], values: Ints) -> dict[str, Ints]:
    """Rows by name of (m,) values; keys: the name of every value that occurs, ascending."""
    order = np.argsort(values, kind="stable")
    _, first = np.unique(values[order], return_index=True)
    return dict(zip(keys, np.split(order, first[1:])))
