# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translation of a checked recipe to kernel objects, the only place where ids become indices."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import RecipeError, fault_of
from ..base.part_mesh import PartMesh
from ..recipe.feature_entries import Vector
from ..recipe.model import ContactEntry, Model, PartEntry, RegionEntry
from ..recipe.pose import Moved, PoseEntry, Rotation

if TYPE_CHECKING:
    from .. import _core

_NO_TURN = (0.0, 0.0, 0.0)
_UPWARDS = (0.0, 0.0, 1.0)
_AS_TOLD = PoseEntry()


class Translator:
    """Builder of kernel objects for one model, with rest positions of pivots and points."""

    def __init__(self, core: ModuleType, model: Model, meshes: Mapping[str, PartMesh]):
        self._core = core
        self._model = model
        self._meshes = meshes
        self._part_index = {part.name: k for k, part in enumerate(model.parts)}
        self._indices = {
            region.where: meshes[region.part].find(region.vertices, region.is_prepared)[0]
            for region in model.all_regions
            if region.vertices is not None
        }
        self._places = {region.name: self._place(region) for region in model.regions}

    def indices(self, region: RegionEntry) -> Ints:
        """Return the vertices (k,) of a region, or the triangle corners of a point."""
        if region.is_point:
            triangle, _ = self._on_mesh(region)
            corners: Ints = self._meshes[region.part].triangles[triangle]
            return corners
        return self._indices[region.where]

    def _place(self, region: RegionEntry) -> Floats:
        """Return the rest position (3,) of a point, or the centroid of a region's vertices; mm."""
        mesh = self._meshes[region.part]
        place: Floats
        if region.is_point:
            triangle, barycentric = self._on_mesh(region)
            place = np.asarray(barycentric) @ mesh.points[mesh.triangles[triangle]]
        else:
            place = mesh.points[self.indices(region)].mean(axis=0)
        return place

    def _on_mesh(self, point: RegionEntry) -> tuple[int, Sequence[float]]:
        """Return the triangle and the barycentric coordinates of a point on the deformed mesh."""
        mesh = self._meshes[point.part]
        return mesh.place_on(self._core, *point.on_triangle)

    def assembly(self) -> _core.Assembly:
        """Return the kernel's Assembly: everything except the pose."""
        core = self._core
        parts = [self._part(part) for part in self._model.parts]
        primary = self._part_index[self._model.primary or self._model.parts[0].name]
        assembly = core.Assembly(parts, primary, self._model.energy, self._model.operator)
        assembly.fixed = [self._region(f) for f in self._model.of_kind("fixed")]
        followers = self._model.of_kind("follower")
        assembly.followers = [self._region(f) for f in followers]
        handles = self._model.of_kind("handle")
        assembly.handles = [self._handle(h) for h in handles if not h.is_point]
        assembly.features = [self._feature(entry) for entry in self._model.of_kind("feature")]
        points = [h for h in handles if h.is_point] + self._model.of_kind("point")
        assembly.points = [self._point(entry) for entry in points]
        assembly.contacts = [self._contact(entry) for entry in self._model.contacts]
        self._relate(assembly)
        if (plane := self._model.symmetry) is not None:
            assembly.symmetry = core.SymmetryPlane(plane.point, plane.normal)
        assembly.is_refined = self._model.refine
        assembly.set_unheld(self._model.unheld)
        way = self._model.propagation
        assembly.propagation = core.Propagation(way.type, way.levels, way.smoothness)
        found: _core.Assembly = assembly
        return found

    def _relate(self, assembly: _core.Assembly) -> None:
        features = [entry.name for entry in self._model.of_kind("feature")]
        for entry in self._model.relations:
            members = [features.index(name) for name in entry.features]
            if entry.type == "group":
                assembly.groups = [*assembly.groups, self._core.FeatureGroup(entry.name, members)]
            else:
                pair = self._core.FeaturePair(entry.name, entry.type, *members)
                assembly.pairs = [*assembly.pairs, pair]

    def _contact(self, entry: ContactEntry) -> _core.Contact:
        sides = [self._region(side) for side in (entry.a, entry.b)]
        found: _core.Contact = self._core.Contact(entry.name, entry.type, *sides)
        return found

    def _part(self, entry: PartEntry) -> _core.Part:
        mesh = self._meshes[entry.name]
        triangles = self._core.TriangleMesh(mesh.points, mesh.triangles)
        ids = None if mesh.ids is None else mesh.ids.astype(np.int32)
        part: _core.Part = self._core.Part(entry.name, triangles, ids, entry.mode)
        if entry.thin:
            part.make_thin(entry.thin == "yes", entry.thickness)
        told = 0.0 if entry.thin else mesh.thickness
        part.sheet_thickness, part.poisson = entry.sheet.thickness or told, entry.sheet.poisson
        return part

    def _region(self, entry: RegionEntry) -> _core.Region:
        found: _core.Region = self._core.Region(
            entry.name, self._part_index[entry.part], self.indices(entry)
        )
        return found

    def _handle(self, entry: RegionEntry) -> _core.Handle:
        place = self._part_index[entry.part], self.indices(entry)
        found: _core.Handle = self._core.Handle(entry.name, *place, entry.turning == "free")
        return found

    def _feature(self, entry: RegionEntry) -> _core.FormFeature:
        place = self._part_index[entry.part], self.indices(entry)
        given = entry.motion
        motion = self._core.FeatureMotion(
            given.type, given.point or _NO_TURN, given.direction or _UPWARDS
        )
        told = entry.turning, motion, entry.size, entry.size is not None
        found: _core.FormFeature = self._core.FormFeature(entry.name, *place, *told)
        return found

    def _point(self, entry: RegionEntry) -> _core.PointConstraint:
        is_free = entry.kind == "handle" and entry.turning == "free"
        turned = not is_free and (entry.kind == "handle" or entry.rotation is not None)
        part = self._part_index[entry.part]
        place = self._on_mesh(entry)
        found: _core.PointConstraint = self._core.PointConstraint(
            entry.name, part, *place, turned, is_free
        )
        return found

    def pose(self, pose: Mapping[str, Moved]) -> _core.Pose:
        """Return the kernel's Pose; missing entries keep the values of the recipe."""
        told: _core.Pose = self._core.Pose()
        for entry in self._model.regions:
            motion = pose.get(entry.name, _AS_TOLD)
            if entry.kind == "handle":
                self._move(entry, motion, told)
            elif entry.kind == "feature":
                if entry.rotation is not None:
                    told.turn_feature(entry.name, self._log(motion.rotation or entry.rotation))
                if motion.size is not None:
                    told.size_feature(entry.name, motion.size)
            elif entry.kind == "point":
                target = motion.target or entry.target
                place = self._places[entry.name] if target is None else np.array(target)
                told.place_point(entry.name, place, self._log(motion.rotation or entry.rotation))
        return told

    def _move(self, entry: RegionEntry, motion: Moved, told: _core.Pose) -> None:
        """Add the motion of a handle, which may be a single point, to the pose."""
        place = self._places[entry.name]
        pivot = motion.pivot or entry.pivot or tuple(place)
        translation, log = motion.translation or _NO_TURN, self._log(motion.rotation)
        rigid = self._core.RigidMotion(translation, log, pivot)
        if entry.is_point:
            told.place_point(entry.name, rigid.apply(place[None, :])[0], rigid.rotation_log)
        else:
            told.move_handle(entry.name, rigid)

    def _log(self, rotation: Rotation | None) -> Vector | Floats:
        if rotation is None:
            return _NO_TURN
        found: Vector | Floats = self._core.rotation_log(rotation.axis, rotation.radians)
        return found


@contextmanager
def kernel_faults(core: ModuleType) -> Iterator[None]:
    """Convert InvalidInput of the kernel to a RecipeError with one fault."""
    try:
        yield
    except core.InvalidInput as error:
        raise RecipeError([fault_of(error, "change it in the recipe")]) from error
