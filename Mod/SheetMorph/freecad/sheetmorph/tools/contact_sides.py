# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a contact while the user marks it."""

from __future__ import annotations

from freecad.sheetmorph.tools.part_mesh import nearest_part
from freecad.sheetmorph.tools.picking import REPLACE, RegionPicker

REACH = 2.0  # mm that sheets joined in a model are usually apart, at most
FRACTION = 0.02  # of the size of a part, for parts so small that 2 mm would take all of it
FARTHEST = 0.25  # of the size of a part, where the search for something that touches ends


class ContactSides:
    """A part and picked vertices for side "a" and "b"; meshes are as ``part_mesh.PartMesh``."""

    def __init__(self, meshes: dict):
        """``meshes``: by the name of the part."""
        self._meshes = meshes
        self.parts = {"a": "", "b": ""}
        self.pickers: dict[str, RegionPicker | None] = {"a": None, "b": None}

    @property
    def are_chosen(self) -> bool:
        """Whether both sides have a part."""
        return all(self.parts.values())

    def part_at(self, ray) -> str:
        """The part that a ray meets first, an empty string if none."""
        return nearest_part(self._meshes, ray)

    def triangles(self, part: str):
        """The triangles (m, 3) of a part."""
        return self._meshes[part].triangles

    def take(self, part: str) -> bool:
        """Puts a part that was clicked on the first free side, else on side "b"."""
        if not part or part in self.parts.values():
            return False
        self.put("b" if self.parts["a"] else "a", part)
        return True

    def put(self, side: str, part: str, vertices=()) -> None:
        """Gives a side another part, none for an empty name; it leaves the other side if there."""
        other = "b" if side == "a" else "a"
        if part and self.parts[other] == part:
            self.put(other, "")
        self.parts[side] = part
        # No other part hides what is picked: parts in contact hide each other just there.
        self.pickers[side] = RegionPicker(self._meshes[part], vertices) if part else None

    def pick(self, vertices_a, vertices_b) -> None:
        """Picks these vertices in place of what is picked."""
        for side, vertices in (("a", vertices_a), ("b", vertices_b)):
            self.pickers[side].take(vertices, REPLACE)

    def picked(self, side: str) -> list[int]:
        """The vertices of a side, sorted."""
        picker = self.pickers[side]
        return picker.picked.tolist() if picker else []

    def mesh(self, side: str):
        """The mesh of the part of a side."""
        return self._meshes[self.parts[side]]

    def size(self) -> float:
        """The size of the smaller part, mm."""
        return min(self.mesh(side).size for side in "ab")


def reach_that_touches(touching, size: float) -> float:
    """The first of 2, 4, 8 … mm at which ``touching(mm)`` finds vertices on both sides.

    Smaller for small parts. If nothing touches within a quarter of ``size``, mm, the first one.
    """
    first = min(REACH, float(f"{FRACTION * size:.1g}"))
    reach = first
    while reach <= FARTHEST * size:
        if all(touching(reach)):
            return reach
        reach *= 2.0
    return first
