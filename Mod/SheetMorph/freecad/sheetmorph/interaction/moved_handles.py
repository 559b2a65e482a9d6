# SPDX-License-Identifier: LGPL-2.1-or-later
"""The handles of one morph while they are moved, and the macro lines that do the same."""

from freecad.sheetmorph import api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.api.motions import put
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.properties import vector_of
from freecad.sheetmorph.objects.region import motion_of
from freecad.sheetmorph.tools.motion import Motion


class MovedHandles:
    """Which handles there are, which were moved, which were made by grabbing a point."""

    def __init__(self, assembly, pending):
        """``pending``: the editing.pending.Pending that all changes go through."""
        self.assembly, self._pending = assembly, pending
        self._centres = {}
        self.begin()

    def begin(self) -> None:
        """Counts what is moved and made from here."""
        self._before = {handle.Name: motion_of(handle) for handle in self.all}

    @property
    def all(self) -> list:
        """The handles there are now."""
        return [r for r in model.regions(self.assembly) if r.Role == "handle"]

    def move(self, handle, motion: Motion) -> None:
        """Sets the motion of a handle."""
        self._pending.change()
        put(handle, motion)

    def pivot(self, handle) -> tuple:
        """Where a handle turns about at rest, (3,) mm; kept until ``look_again``."""
        if not handle.PivotAtCentroid:
            return vector_of(handle, "Pivot")
        if handle.Name not in self._centres:
            self._centres[handle.Name] = tuple(api.pivot(handle))
        return self._centres[handle.Name]

    def look_again(self) -> None:
        """A mesh may be another one, or elsewhere."""
        self._centres = {}

    def at(self, grabbed):
        """The handle that has a grabbed vertex, None if none."""
        for handle in self.all:
            is_here = handle.Part is not None and handle.Part.Name == grabbed.part
            if is_here and grabbed.vertex in model.vertices(handle):
                return handle
        return None

    def make(self, grabbed):
        """A handle of one vertex that the sheet turns as it likes."""
        self._pending.change()
        handle = self._new(grabbed)
        self._pending.remember_made(handle.Name, lambda: self._new(grabbed))
        return handle

    def _new(self, grabbed):
        part = self.assembly.Document.getObject(grabbed.part)
        handle = api.add_handle(self.assembly, part, [grabbed.vertex], label_on(part))
        api.set_free_rotation(handle, True)
        self._centres.pop(handle.Name, None)
        return handle

    def unmake(self, handle) -> None:
        """Takes a handle back that was made."""
        self._pending.forget_made(handle.Name)
        api.remove(handle)

    def unmake_unmoved(self) -> None:
        """Takes back what was grabbed but not moved."""
        for handle in self._made():
            if motion_of(handle).is_rest():
                self.unmake(handle)

    def _made(self) -> list:
        return [handle for handle in self.all if handle.Name not in self._before]

    def lines(self) -> list[str]:
        """The calls of the API that make and move what was made and moved."""
        lines = []
        for handle in self.all:
            if motion_of(handle) == self._before.get(handle.Name):
                continue
            target = name(handle)
            if handle.Name not in self._before:
                target = "point"
                lines += made(self.assembly, handle)
            lines.append(call("set_motion", target, **motion_of(handle).keywords()))
        return lines


def made(assembly, handle) -> list[str]:
    """The calls that make a handle of one vertex, named ``point``."""
    vertex = repr(model.vertices(handle).tolist())
    arguments = (name(assembly), name(handle.Part), vertex, repr(handle.Label))
    return [
        f"point = {call('add_handle', *arguments)}",
        call("set_free_rotation", "point", "True"),
    ]


def label_on(part) -> str:
    """What a grabbed point is called."""
    return f"Point on {part.Label}"
