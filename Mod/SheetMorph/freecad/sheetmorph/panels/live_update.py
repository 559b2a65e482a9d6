# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps the 3D view and the result objects up with a motion that is being changed."""

import time

from freecad.sheetmorph import session
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.panels import control_meshes
from freecad.sheetmorph.scene import preview, wireframe


class LiveUpdate:
    """Previews of all parts of a morph, and commits of its document; ``end`` takes them away."""

    def __init__(self, assembly, updating):
        """Raises session.MorphError if the morph cannot be computed."""
        self._assembly = assembly
        self._updating = updating
        self._live = session.live(assembly)
        self._previews = {}
        self._wires = None
        self.milliseconds = 0.0

    def show(self) -> None:
        """Shows the present motions in the view; raises session.MorphError."""
        start = time.perf_counter()
        self._recompute_regions()
        positions = self._live.deform()
        if not self._previews:
            self._begin()
        for name, shown in self._previews.items():
            shown.show(positions[name])
        self._show_wires()
        self.milliseconds = 1000.0 * (time.perf_counter() - start)

    def commit(self) -> str:
        """Recomputes the document; returns what went wrong in words, or an empty string."""
        start = time.perf_counter()
        self._assembly.Document.recompute()
        self._updating.took(time.perf_counter() - start)
        faulty = [p for p in model.parts(self._assembly) if "Invalid" in p.State]
        return faulty[0].getStatusString() if faulty else ""

    def use_wires(self, view) -> None:
        """Shows the control meshes in a 3D view as well; None: no longer."""
        if self._wires is not None:
            self._wires.remove()
        self._wires = None if view is None else wireframe.Wireframe(view)
        self._show_wires()

    def end(self) -> None:
        """Shows the meshes as the document has them."""
        self.use_wires(None)
        for shown in self._previews.values():
            shown.end()
        self._previews = {}

    def _begin(self) -> None:
        module = preview.module()
        for part in model.parts(self._assembly):
            rest = self._live.parts[part.Name]
            points = rest.frame.to_local(rest.points)
            self._previews[part.Name] = preview.Preview(
                part.ViewObject, module, points, rest.triangles
            )

    def _show_wires(self) -> None:
        """In the pose that was shown last."""
        if self._wires is not None:
            meshes = control_meshes.collect(self._assembly, self._live.control_mesh)
            self._wires.show(meshes)

    def _recompute_regions(self) -> None:
        """Lets expressions between handles follow; cheap, the parts are not among them."""
        regions = model.regions(self._assembly)
        if any(region.ExpressionEngine for region in regions):
            self._assembly.Document.recompute(regions)
