# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in a file for regions of its mesh: groups, properties, sets and CAD faces."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .arrays import Array, Ints


@dataclass(frozen=True)
class CadFace:
    """A face of a CAD file: number from 1 in its body, surface kind, name, colour "#rrggbb"."""

    body: str
    number: int
    kind: str
    name: str = ""
    colour: str = ""


@dataclass(frozen=True, eq=False)
class Labels:
    """Names for regions of one mesh.

    groups maps a name, such as "PID 7" or "usemtl steel", to triangle rows (k,). nodes maps a name
    to vertex ids of the file. face (m,) gives for every triangle an index into ``faces``; it is
    None without CAD faces.
    """

    groups: Mapping[str, Ints] = field(default_factory=dict)
    nodes: Mapping[str, Sequence[int]] = field(default_factory=dict)
    face: Ints | None = None
    faces: tuple[CadFace, ...] = ()

    def with_groups(self, groups: Mapping[str, Ints]) -> Labels:
        """Return a copy with more groups of triangles."""
        return replace(self, groups={**self.groups, **groups})

    def carried(self, triangle_of: Ints) -> Labels:
        """Return the labels of a new mesh, whose triangles (m,) come from triangles of this mesh.

        Groups without a triangle in the new mesh are left out.
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
        """Return the labels as arrays, for an .npz file."""
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
        """Return the labels from the arrays of arrays(), or None if there are none."""
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
        """All names of groups and node sets, for messages."""
        return [*self.groups, *self.nodes]


def by_key(keys: Iterable[str], values: Ints) -> dict[str, Ints]:
    """Group the rows of values (m,) by value; keys names the distinct values in ascending order."""
    order = np.argsort(values, kind="stable")
    _, first = np.unique(values[order], return_index=True)
    return dict(zip(keys, np.split(order, first[1:])))
