# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors in documents, resolved on the rest mesh of a part.

Coordinates are those of the part's file, as in a recipe, so that the part can be moved. Only this
module resolves figures drawn in a view.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.conversion import Frame
from freecad.sheetmorph.bridge.rest import Kept, read_kept, read_rest, version_of
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.tools import sentences, spaces
from freecad.sheetmorph.tools.figures import Camera, outlines
from freecad.sheetmorph.tools.part_mesh import PartMesh
from freecad.sheetmorph.tools.shortening import shortened


def is_selector(given: Any) -> bool:
    """Return whether a value is a selector or a list of selectors, not vertices."""
    if isinstance(given, dict):
        return True
    return isinstance(given, (list, tuple)) and any(isinstance(one, dict) for one in given)


def select(part, where: Any) -> np.ndarray:
    """Return the vertices (k,) of a selector on a part. Raises ValueError if it is invalid."""
    return chosen_on(shape_of(part), where).vertices


def chosen_on(shape, where: Any):
    """Return the region of a selector on a shape, a sheetmorph.selecting.Chosen."""
    faults = kernel.load().recipe.where_faults(where)
    if faults:
        raise ValueError(str(faults[0]))
    return kernel.selecting_module().selected(shape, where)


def shape_of(part, kept: Kept | None = None):
    """Return a part as selectors see it, or its future rest mesh."""
    if kept is not None:
        return made_shape(part, kept)
    kept = read_kept(part)
    key = (part.Label, version_of(part.RestData), kept.frame.key)
    return snapshot_of(part.Source).derived(
        f"selecting {part.Name}", key, lambda: made_shape(part, kept)
    )


def made_shape(part, kept: Kept):
    """Return the shape of a mesh of a part."""
    package = kernel.load()
    mesh = package.PartMesh(kept.points, kept.triangles, name=part.Label, labels=kept.labels)
    shape = kernel.selecting_module().PartShape(mesh, name=part.Label)
    shape.drawn = lambda told: drawn(part, kept, told)
    return shape


def drawn(part, kept: Kept, told: dict) -> np.ndarray:
    """Return the vertices (k,) inside a figure, as the picker does.

    Vertices hidden by visible parts at rest are left out, unless the figure selects through.
    """
    figure = sentences.figure_of(told)
    core = kernel.core()
    mesh = PartMesh(core, (kept.points, kept.triangles), kept.points)
    hiding = None if figure.through else [mesh, *others_in_front(part, kept.frame)]
    camera = Camera.of_view(figure.view, kept.points)
    taken = [mesh.inside(camera, outline, hiding) for outline in outlines(figure)]
    return np.unique(np.concatenate([np.zeros(0, np.int32), *taken]))


def others_in_front(part, frame: Frame) -> list[PartMesh]:
    """Return the other visible parts of a morph, in the file coordinates of one."""
    shown = [p for p in model.parts(model.assembly_of(part)) if p != part and p.Visibility]
    found = []
    for other in shown:
        rest = read_rest(other)
        points = frame.to_local(rest.points) + frame.origin
        found.append(PartMesh(kernel.core(), (points, rest.triangles), points))
    return found


def words_of(part, said: Any, length: sentences.Length = sentences.SHOWN) -> Any:
    """Return the selector of a pick in file coordinates, at a limited length."""
    return sentences.simplest(sentences.in_file(said, read_kept(part).frame, length))


def spaces_of(part, where: Any) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return the volumes in a selector as vertices (k, 3), global mm, and triangles."""
    kept = read_kept(part)
    found = spaces.shapes_of(where, kept.points)
    return [(kept.frame.to_global(points), triangles) for points, triangles in found]


def sentence_for(part, said: Any, vertices: np.ndarray) -> Any:
    """Return the shortest selector of a pick in file coordinates.

    Return None if it does not give exactly these vertices.
    """
    if said is None:
        return None
    shape = shape_of(part)
    for length in sentences.LENGTHS_TRIED:
        where = shortened(words_of(part, said, length), shape.points, length.away)
        try:
            if np.array_equal(chosen_on(shape, where).vertices, vertices):
                return where
        except ValueError:
            continue
    return None


def source_for(part, wanted: list, vertices: np.ndarray) -> str:
    """Return the vertices as source text for a macro line.

    It is the first selector of the picks that gives them, else their ids.
    """
    for said in wanted:
        where = sentence_for(part, said, vertices)
        if where is not None:
            return repr(where)
    return repr([int(vertex) for vertex in vertices])


def sentence_of(owner, side: str = "") -> Any:
    """Return the selector of a region, or of side "a" or "b" of a contact, or None."""
    said = getattr(owner, f"Where{side.upper()}")
    return json.loads(said) if said else None


def following_of(part, kept: Kept, scale: float):
    """Return the current and the future rest mesh as sheetmorph.selecting.Following.

    The future mesh is `scale` times as large.
    """
    return kernel.selecting_module().Following(shape_of(part), shape_of(part, kept), scale)


def question_type() -> type[ValueError]:
    """Return the class of the questions that `Following` raises."""
    return kernel.selecting_module().Question


def followed_text(label: str, following, before: Any, followed) -> str:
    """Return a sentence on the changes of a transferred region, or ""."""
    old = following.old
    area = following.scale**2 * old.area_of(chosen_on(old, before))
    told = told_difference(label, area, following.new.area_of(followed.chosen))
    moved = "; ".join(followed.told)
    return " ".join(text for text in (told, moved and f"'{label}': {moved}.") if text)


LEAST = 0.03
"""Relative change of a region's area that is not reported."""


def told_difference(label: str, before: float, after: float) -> str:
    """Return a sentence if the area of a region, mm^2, changed."""
    if abs(after - before) <= LEAST * max(before, after):
        return ""
    return f"'{label}' covers {after:.4g} mm2 now, {before:.4g} mm2 before."
