# SPDX-License-Identifier: LGPL-2.1-or-later
"""The handles of one morph during a motion, and the equivalent macro lines."""

from freecad.sheetmorph import api
from freecad.sheetmorph.actions import call, name
from freecad.sheetmorph.api.motions import put, rest_centroid
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.region import motion_of
from freecad.sheetmorph.tools.motion import Motion


class MovedHandles:
    """All handles, including those that moved or were created by grabbing a point."""

    def __init__(self, assembly, pending):
        """Start with the present handles; all changes go through `pending`, a Pending."""
        self.assembly, self._pending = assembly, pending
        self._centres = {}
        self.begin()

    def begin(self) -> None:
        """Count moved and created handles from the present state."""
        self._before = {handle.Name: motion_of(handle) for handle in self.all}

    @property
    def all(self) -> list:
        """The present handles."""
        return [r for r in model.regions(self.assembly) if r.Role == "handle"]

    def move(self, handle, motion: Motion) -> None:
        """Set the motion of a handle."""
        self._pending.change()
        put(handle, motion)

    def centroid(self, name: str) -> tuple:
        """Return the centroid of a handle at rest, (3,) mm, cached until `look_again`."""
        if name not in self._centres:
            handle = self.assembly.Document.getObject(name)
            self._centres[name] = tuple(rest_centroid(handle))
        return self._centres[name]

    def place(self, handle) -> tuple:
        """Return the moved pivot of a handle, (3,) mm."""
        motion = motion_of(handle)
        return motion.place(motion.pivot or self.centroid(handle.Name))

    def look_again(self) -> None:
        """Clear the cache after a change of a mesh or placement."""
        self._centres = {}

    def at(self, grabbed):
        """Return the handle that contains a grabbed vertex, None without one."""
        for handle in self.all:
            is_here = handle.Part is not None and handle.Part.Name == grabbed.part
            if is_here and grabbed.vertex in model.vertices(handle):
                return handle
        return None

    def make(self, grabbed):
        """Create a handle of one vertex with free rotation."""
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
        """Remove a handle that was created here."""
        self._pending.forget_made(handle.Name)
        api.remove(handle)

    def unmake_unmoved(self) -> None:
        """Remove the created handles that have not moved."""
        for handle in self._made():
            if motion_of(handle).is_rest():
                self.unmake(handle)

    def _made(self) -> list:
        return [handle for handle in self.all if handle.Name not in self._before]

    def lines(self) -> list[str]:
        """Return the API calls that create and move the handles."""
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
    """Return the API calls that create a handle of one vertex, named `point`."""
    vertex = repr(model.vertices(handle).tolist())
    arguments = (name(assembly), name(handle.Part), vertex, repr(handle.Label))
    return [
        f"point = {call('add_handle', *arguments)}",
        call("set_free_rotation", "point", "True"),
    ]


def label_on(part) -> str:
    """Return the label of a grabbed point."""
    return f"Point on {part.Label}"
