# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a contact while the user marks it."""

from __future__ import annotations

from freecad.sheetmorph.tools.part_mesh import nearest_part
from freecad.sheetmorph.tools.picking import REPLACE, RegionPicker

REACH = 2.0  # mm: the usual largest gap between joined sheets of a model
FRACTION = 0.02  # of the size of a part so small that 2 mm would cover all of it
FARTHEST = 0.25  # of the size of a part: where the search for touching vertices ends


class ContactSides:
    """The part and the picked vertices of side "a" and of side "b"."""

    def __init__(self, meshes: dict):
        """Create empty sides; `meshes` maps part names to objects like `part_mesh.PartMesh`."""
        self._meshes = meshes
        self.parts = {"a": "", "b": ""}
        self.pickers: dict[str, RegionPicker | None] = {"a": None, "b": None}

    @property
    def are_chosen(self) -> bool:
        """Whether both sides have a part."""
        return all(self.parts.values())

    def part_at(self, ray) -> str:
        """Return the name of the part that a ray meets first, empty if it meets none."""
        return nearest_part(self._meshes, ray)

    def triangles(self, part: str):
        """Return the triangles (m, 3) of a part."""
        return self._meshes[part].triangles

    def take(self, part: str) -> bool:
        """Put a clicked part on the first free side, else on "b"; return False if refused."""
        if not part or part in self.parts.values():
            return False
        self.put("b" if self.parts["a"] else "a", part)
        return True

    def put(self, side: str, part: str, vertices=()) -> None:
        """Give a side another part and picked vertices; an empty name clears the side.

        A part on the other side leaves that side.
        """
        other = "b" if side == "a" else "a"
        if part and self.parts[other] == part:
            self.put(other, "")
        self.parts[side] = part
        # Other parts hide nothing here, since parts in contact hide each other just where they
        # touch.
        self.pickers[side] = RegionPicker(self._meshes[part], vertices) if part else None

    def pick(self, vertices_a, vertices_b) -> None:
        """Replace the picked vertices of both sides."""
        for side, vertices in (("a", vertices_a), ("b", vertices_b)):
            self.pickers[side].take(vertices, REPLACE)

    def picked(self, side: str) -> list[int]:
        """Return the sorted vertices of a side."""
        picker = self.pickers[side]
        return picker.picked.tolist() if picker else []

    def mesh(self, side: str):
        """Return the mesh of the part on a side."""
        return self._meshes[self.parts[side]]

    def size(self) -> float:
        """Return the size of the smaller part, mm."""
        return min(self.mesh(side).size for side in "ab")


def reach_that_touches(touching, size: float) -> float:
    """Return the first of 2, 4, 8, … mm at which `touching(mm)` finds vertices on both sides.

    The search starts lower for small parts. If it finds nothing within a quarter of `size` (mm), it
    returns the first length.
    """
    first = min(REACH, float(f"{FRACTION * size:.1g}"))
    reach = first
    while reach <= FARTHEST * size:
        if all(touching(reach)):
            return reach
        reach *= 2.0
    return first
