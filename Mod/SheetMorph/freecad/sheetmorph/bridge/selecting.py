# SPDX-License-Identifier: LGPL-2.1-or-later
"""Selectors in documents: what a region says it is, resolved on the mesh its part rests on.

Coordinates are those of the part's file, as in a recipe, so that the part may be moved. What a
figure drawn in a view takes is known here alone.
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
    """Whether somebody gave a selector, or a list of them, rather than vertices."""
    if isinstance(given, dict):
        return True
    return isinstance(given, (list, tuple)) and any(isinstance(one, dict) for one in given)


def select(part, where: Any) -> np.ndarray:
    """Return the vertices (k,) that a selector stands for on a part; ValueError if it is wrong."""
    return chosen_on(shape_of(part), where).vertices


def chosen_on(shape, where: Any):
    """Return what a selector stands for on a shape, a sheetmorph.selecting.Chosen."""
    faults = kernel.load().recipe.where_faults(where)
    if faults:
        raise ValueError(str(faults[0]))
    return kernel.selecting_module().selected(shape, where)


def shape_of(part, kept: Kept | None = None):
    """Return a part as selectors see it, or the mesh that it is about to rest on."""
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
    """Return the vertices (k,) that a figure takes, as the picker takes them: hidden ones not,
    unless it goes through; what is in front are the parts that are shown, at rest."""
    figure = sentences.figure_of(told)
    core = kernel.core()
    mesh = PartMesh(core, (kept.points, kept.triangles), kept.points)
    hiding = None if figure.through else [mesh, *others_in_front(part, kept.frame)]
    camera = Camera.of_pixels(np.array(figure.camera).reshape(-1, 4))
    taken = [mesh.inside(camera, outline, hiding) for outline in outlines(figure)]
    return np.unique(np.concatenate([np.zeros(0, np.int32), *taken]))


def others_in_front(part, frame: Frame) -> list[PartMesh]:
    """Return the other parts of a morph that are shown, in the file coordinates of one."""
    shown = [p for p in model.parts(model.assembly_of(part)) if p != part and p.Visibility]
    found = []
    for other in shown:
        rest = read_rest(other)
        points = frame.to_local(rest.points) + frame.origin
        found.append(PartMesh(kernel.core(), (points, rest.triangles), points))
    return found


def words_of(part, said: Any, length: sentences.Length = sentences.SHOWN) -> Any:
    """Return what a pick said in the coordinates of the part's file, no longer than that."""
    return sentences.simplest(sentences.in_file(said, read_kept(part).frame, length))


def spaces_of(part, where: Any) -> list[tuple[np.ndarray, np.ndarray]]:
    """Return boxes, planes, cylinders and spheres that a selector speaks of: vertices (k, 3),
    global mm, and triangles."""
    kept = read_kept(part)
    found = spaces.shapes_of(where, kept.points)
    return [(kept.frame.to_global(points), triangles) for points, triangles in found]


def sentence_for(part, said: Any, vertices: np.ndarray) -> Any:
    """Return what a pick said, in the coordinates of the part's file and as short as it may be.

    None where it does not give exactly these vertices: then they themselves are what is known.
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
    """Return how a macro line says which vertices: by the first of some sentences of picks that
    gives them, else by their ids."""
    for said in wanted:
        where = sentence_for(part, said, vertices)
        if where is not None:
            return repr(where)
    return repr([int(vertex) for vertex in vertices])


def sentence_of(owner, side: str = "") -> Any:
    """Return what a region, or side "a" or "b" of a contact, says it is; None if only its vertices
    are known."""
    said = getattr(owner, f"Where{side.upper()}")
    return json.loads(said) if said else None


def following_of(part, kept: Kept, scale: float):
    """Return the two states of a part, a sheetmorph.selecting.Following: the mesh that it rests on,
    and the mesh that it is about to rest on, which is `scale` times as large."""
    return kernel.selecting_module().Following(shape_of(part), shape_of(part, kept), scale)


def question_type() -> type[ValueError]:
    """Return the class of the questions that `Following` raises."""
    return kernel.selecting_module().Question


def followed_text(label: str, following, before: Any, followed) -> str:
    """Return a sentence on what became different of a region that was followed; "" if nothing."""
    old = following.old
    area = following.scale**2 * old.area_of(chosen_on(old, before))
    told = told_difference(label, area, following.new.area_of(followed.chosen))
    moved = "; ".join(followed.told)
    return " ".join(text for text in (told, moved and f"'{label}': {moved}.") if text)


LEAST = 0.03
"""Of its area: by how much a region may differ on another mesh without a word."""


def told_difference(label: str, before: float, after: float) -> str:
    """Return a sentence if the area of a region, mm^2, is not what it was."""
    if abs(after - before) <= LEAST * max(before, after):
        return ""
    return f"'{label}' covers {after:.4g} mm2 now, {before:.4g} mm2 before."
