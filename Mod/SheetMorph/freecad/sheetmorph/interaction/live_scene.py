# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawings of a moving morph: the parts and, on demand, details of the motion."""

from functools import partial

import numpy as np

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.interaction import control_meshes
from freecad.sheetmorph.scene import colours, drawing, preview
from freecad.sheetmorph.scene.feature_marks import FeatureMarks
from freecad.sheetmorph.scene.ghost import Ghost
from freecad.sheetmorph.scene.highlight import Highlight
from freecad.sheetmorph.scene.place_marks import PlaceMarks
from freecad.sheetmorph.scene.wireframe import Wireframe
from freecad.sheetmorph.tools import element_quality, live_values, words

PLACES = "SheetMorphWorstPlaces"
NONE, DISPLACEMENT, QUALITY, GAPS, STRETCH, ELEMENTS = range(6)
"""The meaning of colours; ELEMENTS and above are measures of element_quality.MEASURES."""


class LiveScene:
    """The drawings of one morph in a 3D view until `remove`."""

    def __init__(self, assembly, live, view):
        """Create the scene; `live` is a live_session.LiveSession."""
        self._assembly, self._live, self._view = assembly, live, view
        self._previews, self._ghosts = {}, []
        self._wires = self._marks = self._places = None
        self._flips = Highlight()
        self._are_filled = True

    def show(self, frame, values, legend) -> None:
        """Show a live_session.Frame.

        `values` (n,) by part, or None, become colours in the span of a live_values.Legend, whose
        places are marked.
        """
        if not self._previews:
            self._begin()
        self._fill_regions(values is None)
        for name, shown in self._previews.items():
            shown.show(frame.positions[name], self._live.parts[name].frame)
            if values is None:
                shown.plain()
            else:
                shown.colour(values[name], legend.span)
        self._mark(() if values is None else legend.places)
        self.refresh(frame)

    def refresh(self, frame) -> None:
        """Update the details of the displayed frame, None before the first one."""
        if self._wires is not None:
            self._wires.show(control_meshes.collect(self._assembly, self._live.control_mesh))
        if self._marks is not None and frame is not None and frame.result is not None:
            self._marks.show(frame.result.features)

    def use_original(self, is_on: bool) -> None:
        """Show or hide the parts at rest as ghosts."""
        for ghost in self._ghosts:
            ghost.remove()
        self._ghosts = [Ghost(*drawn) for drawn in self._at_rest()] if is_on else []

    def use_wires(self, is_on: bool) -> None:
        """Show or hide the control meshes as wires."""
        self._wires = self._exchanged(self._wires, Wireframe, is_on)

    def use_marks(self, is_on: bool) -> None:
        """Show or hide the displacements of all form features."""
        self._marks = self._exchanged(self._marks, FeatureMarks, is_on)

    def mark_flips(self, triangles: dict) -> None:
        """Mark the triangles (k,) of parts that flip, by name; none removes the marks."""
        self._flips.clear()
        for name, flipped in triangles.items():
            drawn, part = self._live.parts[name].triangles[flipped], self._part(name)
            if len(drawn) and part is not None:
                self._flips.paint(part.ViewObject, drawn, colours.FAULT, np.unique(drawn))

    def _part(self, name: str):
        return self._assembly.Document.getObject(name)

    def valuer(self, kind: int):
        """Return the measure behind a kind of colours, None for NONE."""
        parts = self._live.parts
        if kind == DISPLACEMENT:
            return live_values.Displacement({name: rest.points for name, rest in parts.items()})
        if kind == QUALITY:
            triangles = {name: rest.triangles for name, rest in parts.items()}
            return live_values.Quality(kernel.core(), triangles)
        if kind == GAPS:
            meshes = {name: (rest.points, rest.triangles) for name, rest in parts.items()}
            return live_values.Gaps(kernel.core(), meshes, self._sides())
        if kind == STRETCH:
            meshes = {name: (rest.points, rest.triangles) for name, rest in parts.items()}
            return live_values.Stretch(kernel.stretches(), meshes, self._regions())
        if kind >= ELEMENTS:
            return self._elements(list(element_quality.MEASURES)[kind - ELEMENTS])
        return None

    def show_shape_alone(self) -> None:
        """Show the parts in their colours without any details."""
        self._show_nothing_besides()
        for shown in self._previews.values():
            shown.plain()

    def remove(self) -> None:
        """Show the meshes of the document again; the document may be closed."""
        self._show_nothing_besides()
        for shown in self._previews.values():
            shown.remove()
        self._previews = {}

    def _show_nothing_besides(self) -> None:
        self.use_original(False)
        self.use_wires(False)
        self.use_marks(False)
        self._flips.clear()
        self._mark(())
        self._fill_regions(True)

    def _elements(self, measure: str):
        """Return the measure of element quality, with triangles for parts without a deck."""
        module, found = kernel.element_measures(), {}
        for name, rest in self._live.parts.items():
            no_corner = np.full((len(rest.triangles), 1), -1)
            is_known = rest.faces is not None
            faces = rest.faces if is_known else np.hstack([rest.triangles, no_corner])
            found[name] = rest.points, faces
        limits = kernel.certifying().read_criteria(None).elements.get(measure, {})

        def measured(positions, faces):
            return module.measured(module.MEASURES[measure], positions, faces)

        return element_quality.ElementQuality(measure, measured, limits, found)

    def _mark(self, places) -> None:
        """Mark live_values.Places with their values in percent."""
        if bool(places) != (self._places is not None):
            kind = partial(PlaceMarks, name=PLACES, colour=colours.MARKS)
            self._places = self._exchanged(self._places, kind, bool(places))
        if self._places is not None:
            self._places.show([(place.point, f" {words.plain(place.value)} %") for place in places])

    def _exchanged(self, drawing, kind, is_on: bool):
        if drawing is not None:
            drawing.remove()
        return kind(self._view) if is_on else None

    def _fill_regions(self, is_on: bool) -> None:
        """Show regions in their colours, or as outlines that leave other colours visible."""
        if is_on == self._are_filled:
            return
        self._are_filled = is_on
        try:
            for region in model.regions(self._assembly):
                region.ViewObject.Proxy.fill(is_on)
        except (ReferenceError, RuntimeError):
            return  # the morph is deleted

    def _begin(self) -> None:
        drawn = zip(model.parts(self._assembly), self._at_rest())
        self._previews = {
            part.Name: preview.Preview(*at_rest, also=shapes_of(part)) for part, at_rest in drawn
        }

    def _at_rest(self) -> list:
        """Return view, drawer and mesh at rest of every part."""
        drawer, found = drawing.drawer(), []
        for part in model.parts(self._assembly):
            rest = self._live.parts[part.Name]
            points = rest.frame.to_local(rest.points)
            found.append((part.ViewObject, drawer, points, rest.triangles))
        return found

    def _regions(self) -> list:
        return [
            live_values.Region(region.Label, region.Part.Name, model.vertices(region))
            for region in model.regions(self._assembly)
            if region.Part is not None and region.Part.Name in self._live.parts
        ]

    def _sides(self) -> list:
        parts, sides = self._live.parts, []
        for contact in model.contacts(self._assembly):
            pair = {"a": contact.PartA, "b": contact.PartB}
            if contact.Active and all(p is not None and p.Name in parts for p in pair.values()):
                for side, other in ("ab", "ba"):
                    vertices = model.contact_vertices(contact, side)
                    sides.append(live_values.Side(pair[side].Name, vertices, pair[other].Name))
        return sides


def shapes_of(part) -> list:
    """Return the view of a part's deformed shape, which would show the previous pose."""
    shape = part.DeformedShape
    return [] if shape is None else [shape.ViewObject]
