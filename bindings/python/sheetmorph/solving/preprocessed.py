# SPDX-License-Identifier: LGPL-2.1-or-later
"""The set-up of a morph: the checked and factorised recipe, with measures that need no pose."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import InputError, Subject
from ..base.kernel import load_kernel
from ..base.part_mesh import PartMesh
from ..base.progress import Progress
from ..checking import check_pose, check_with_meshes
from ..measuring.crossings import crossings
from ..measuring.gaps import ContactGap, Surface
from ..measuring.rigidity import feature_edges
from ..measuring.strain import EdgeChanges
from ..measuring.tears import Cuts
from ..recipe.found import Found
from ..recipe.model import Model, RegionEntry
from ..recipe.plain import plain_pose
from .results import ContactResult, FeatureResult
from .translation import Translator, kernel_faults

if TYPE_CHECKING:
    from .. import _core


@dataclass(frozen=True, eq=False)
class RestShape:
    """All undeformed parts by name: positions (n, 3), and those of their deformed sheets, mm."""

    positions: dict[str, Floats]
    sheets: dict[str, Floats]


class Preprocessed:
    """The pre-processing phase of a recipe whose parts are given as meshes.

    Parameters
    ----------
    recipe : dict
        As in a recipe file; parts need no "file".
    meshes : mapping
        Part name to PartMesh.
    progress : callable, optional
        progress(fraction, task) may return False to cancel (RuntimeError).
    previous : Preprocessed, optional
        Set-up of an earlier state of the recipe; unchanged parts of it are reused.
    found : Found, optional
        Result of a search in the files for "auto" entries; by default the constructor searches.
    told : mapping, optional
        Remarks on selectors that were resolved before.

    Raises
    ------
    RecipeError
        If the recipe has faults.
    KernelError
        If the compiled kernel cannot be loaded.
    """

    def __init__(
        self,
        recipe: dict[str, Any],
        meshes: Mapping[str, PartMesh],
        progress: Progress | None = None,
        previous: Preprocessed | None = None,
        *,
        found: Found | None = None,
        told: Mapping[str, dict[str, Any]] | None = None,
    ):
        model = check_with_meshes(recipe, meshes, found)
        if told is not None:
            model = replace(model, told=dict(told))
        self._recipe_pose = plain_pose(dict(recipe.get("pose", {})))
        self._model = model
        self.meshes = {part.name: meshes[part.name] for part in model.parts}
        self._core = load_kernel()
        self._contacts = {entry.name: entry for entry in model.contacts}
        self._rest_surfaces: dict[str, Surface] = {}
        self._contact_gaps: dict[str, ContactGap] = {}
        self._feature_edges: dict[str, Ints] = {}
        self._edge_changes: dict[str, EdgeChanges] = {}
        self._crossings: dict[str, Ints] = {}
        self._rest_shapes: dict[Any, RestShape] = {}
        self._cuts: dict[str, Cuts] = {}
        with kernel_faults(self._core):
            self._translator = Translator(self._core, model, self.meshes)
            assembly = self._translator.assembly()
            earlier = None if previous is None else previous._kernel
            self._kernel: _core.DeformationSession = self._core.DeformationSession(
                assembly, progress, earlier
            )

    @property
    def model(self) -> Model:
        """The entries of the recipe."""
        return self._model

    @property
    def core(self) -> ModuleType:
        """The kernel module in use."""
        return self._core

    @property
    def parts(self) -> list[str]:
        """Part names in the order of the recipe."""
        return [part.name for part in self._model.parts]

    @property
    def order(self) -> list[str]:
        """Names of the reached parts, in the order of their deformation."""
        return list(self._kernel.order)

    @property
    def levels(self) -> dict[str, int]:
        """Part name to its number of contacts from the primary part; -1 if not reached."""
        return dict(zip(self.parts, self._kernel.levels))

    @property
    def directions(self) -> list[tuple[str, str, str]]:
        """(contact, source part, target part) of every contact in use."""
        names, contacts = self.parts, self._model.contacts
        found = self._kernel.directions
        return [(contacts[c].name, names[source], names[target]) for c, source, target in found]

    @property
    def unreached(self) -> list[str]:
        """Names of the parts that no motion reaches; they stay at rest."""
        return list(self._kernel.unreached)

    @property
    def joined_bodies(self) -> list[list[str]]:
        """Labels such as "feature 'a'" of entries that form one rigid body, one list per body.

        Entries are joined if they share vertices or belong to one group.
        """
        return [list(labels) for labels in self._kernel.joined_bodies]

    @property
    def joined_subjects(self) -> list[set[Subject]]:
        """The entries of each body in `joined_bodies`."""
        return [{Subject(*pair) for pair in body} for body in self._kernel.joined_subjects]

    @property
    def loose_pieces(self) -> dict[str, tuple[int, int]]:
        """Part name to the number of its pieces without prescribed vertices, and of their vertices.

        See the recipe key `unheld`.
        """
        found = self._kernel.loose_pieces
        return {self.parts[part]: (pieces, vertices) for part, pieces, vertices, _ in found}

    @property
    def loose_places(self) -> dict[str, Floats]:
        """Part name to a rest position (3,) on one of its loose pieces, mm."""
        return {self.parts[part]: place for part, _, _, place in self._kernel.loose_pieces}

    def is_held(self, part: str) -> bool:
        """Return whether a fixed region constrains a part, directly or through rigid contacts."""
        return bool(self._kernel.is_held(self.parts.index(part)))

    def region_vertices(self, region: RegionEntry) -> Ints:
        """Return the vertices (k,) of a region, or the triangle corners of a point."""
        return self._translator.indices(region)

    def contact_gap(self, contact: str) -> ContactGap:
        """Return the gap of a contact."""
        if contact not in self._contact_gaps:
            entry = self._contacts[contact]
            rest = self._rest_surface(entry.a.part), self._rest_surface(entry.b.part)
            sides = self._translator.indices(entry.a), self._translator.indices(entry.b)
            self._contact_gaps[contact] = ContactGap(rest, sides)
        return self._contact_gaps[contact]

    def _rest_surface(self, part: str) -> Surface:
        found = self._rest_surfaces.get(part)
        if found is None:
            mesh = self.meshes[part]
            found = self._rest_surfaces[part] = Surface(mesh.points, mesh.triangles)
        return found

    def kept_contacts(
        self, deformed: _core.Deformed, positions: Mapping[str, Floats]
    ) -> list[ContactResult]:
        """Return the fidelity of the contacts at positions (n, 3) by part name."""
        names, found = self.parts, []
        now = {
            name: Surface(places, self.meshes[name].triangles) for name, places in positions.items()
        }
        for told in deformed.contacts:
            entry = self._model.contacts[told.contact]
            change = self.contact_gap(entry.name).change((now[entry.a.part], now[entry.b.part]))
            found.append(
                ContactResult(
                    name=entry.name,
                    type=entry.type,
                    source=names[told.source_part],
                    target=names[told.target_part],
                    deviation=float(told.deviation),
                    gap_change=change.worst,
                    place=None if change.place is None else change.place.tolist(),
                    region_size=float(told.region_size),
                )
            )
        # Their search trees are large, and the session keeps the gaps at rest themselves.
        self._rest_surfaces.clear()
        return found

    def feature_edges(self, name: str) -> Ints:
        """Return the edges (e, 2) of a form feature; see `certificate.feature_edges`."""
        if name not in self._feature_edges:
            mesh = self.meshes[self.parts[self._kernel_features[name].part]]
            self._feature_edges[name] = feature_edges(mesh, self.feature_vertices(name))
        return self._feature_edges[name]

    def edge_changes(self, part: str) -> EdgeChanges:
        """Return the measure for edge length changes of a part."""
        if part not in self._edge_changes:
            mesh = self.meshes[part]
            self._edge_changes[part] = EdgeChanges(mesh.points, mesh.triangles)
        return self._edge_changes[part]

    def rest_crossings(self, part: str) -> Ints:
        """Return the pairs (k, 2) of triangles of a part that intersect at rest."""
        if part not in self._crossings:
            mesh = self.meshes[part]
            self._crossings[part] = crossings(mesh.points, mesh.triangles)
        return self._crossings[part]

    def cuts(self, part: str) -> Cuts:
        """Return the cuts in the mesh of a part."""
        if part not in self._cuts:
            self._cuts[part] = Cuts(self.meshes[part])
        return self._cuts[part]

    @property
    def timings(self) -> dict[str, float]:
        """Duration of each stage of the set-up, s."""
        return {timing.stage: float(timing.seconds) for timing in self._kernel.timings}

    @property
    def size(self) -> float:
        """Diagonal of the box around all parts at rest, mm."""
        low = np.min([mesh.points.min(axis=0) for mesh in self.meshes.values()], axis=0)
        high = np.max([mesh.points.max(axis=0) for mesh in self.meshes.values()], axis=0)
        return float(np.linalg.norm(high - low))

    def thin_solid(self, part: str) -> _core.ThinSolid | None:
        """Return the kernel's ThinSolid of a part, or None if the part is not solved as one."""
        return self._kernel.thin_solid(self.parts.index(part))

    def sheet(self, part: str) -> _core.TriangleMesh:
        """Return the deformed mesh of the kernel: the part, or the mid-surface of a thin solid."""
        return self._kernel.sheet(self.parts.index(part))

    def sheet_thickness(self, part: str) -> float:
        """Return the thickness of a part for the energy `steel`, mm."""
        return float(self._kernel.sheet_thickness(self.parts.index(part)))

    @cached_property
    def lump_count(self) -> int:
        """Number of thick regions in thin solids; each is a form feature after the others."""
        solids = [self.thin_solid(part) for part in self.parts]
        return sum(len(solid.lumps) for solid in solids if solid is not None)

    def rest_shape(
        self, sizes: Mapping[str, float], exact: bool = True, progress: Progress | None = None
    ) -> RestShape:
        """Return the rest shape with the given feature sizes, name to mm.

        A new size moves the vertices around a hole within the sheet. This is another rest shape and
        not a strain. See Session.deform() for `exact` and `progress`.
        """
        key = (exact, *sorted(sizes.items()))
        if key not in self._rest_shapes:
            found = self._resized(sizes, exact, progress)
            self._rest_shapes = {key: found}  # the last one: a study has many
        return self._rest_shapes[key]

    def _resized(
        self, sizes: Mapping[str, float], exact: bool, progress: Progress | None
    ) -> RestShape:
        if sizes:
            own = [e.name for e in self._model.of_kind("feature") if e.name in sizes]
            pose = check_pose(self._model, {name: {"size": sizes[name]} for name in own})
            try:
                deformed = self._kernel.deform(self._translator.pose(pose), exact, progress)
            except self._core.InvalidInput:
                pass  # only the pose makes room for the size
            else:
                names = list(enumerate(self.parts))
                return RestShape(
                    {name: np.asarray(deformed.positions(k)) for k, name in names},
                    {name: np.asarray(deformed.sheet_positions(k)) for k, name in names},
                )
        return RestShape(
            {name: mesh.points for name, mesh in self.meshes.items()},
            {name: np.asarray(self.sheet(name).points) for name in self.parts},
        )

    def moved_features(self, deformed: _core.Deformed) -> list[FeatureResult]:
        """Return the motion of every form feature, thick regions of thin solids last."""
        names = self.parts
        entries = zip(deformed.features, self._kernel.features, self._kernel.shapes)
        return [
            FeatureResult(
                name=feature.name,
                part=names[feature.part],
                rotation=feature.rotation,
                translation=feature.translation,
                centre=feature.centre,
                edge_error=float(feature.edge_error),
                rotation_type=entry.rotation,
                motion=entry.motion,
                kind=None if feature.size is None or shape is None else shape.kind,
                size=feature.size,
                outline_error=None if feature.size is None else float(feature.outline_error),
            )
            for feature, entry, shape in entries
        ]

    def feature_vertices(self, name: str) -> Ints:
        """Return the vertex indices (k,) of a form feature in its part."""
        found: Ints = self._kernel_features[name].vertices
        return found

    @cached_property
    def _kernel_features(self) -> dict[str, _core.FormFeature]:
        """The form features of the kernel by name, including thick regions of thin solids."""
        return {entry.name: entry for entry in self._kernel.features}

    def rest_of(self, part: str, features: list[FeatureResult]) -> Floats:
        """Return the rest positions (n, 3) of a part with its feature sizes, mm."""
        points = self.meshes[part].points
        rest = points.copy()
        for feature, shape in zip(features, self._kernel.shapes):
            if feature.part == part and shape is not None and feature.size is not None:
                vertices = self.feature_vertices(feature.name)
                rest[vertices] = shape.resized(points[vertices], feature.size)
        return rest

    def control_mesh(
        self, contact: str | None, deformed: _core.Deformed
    ) -> tuple[Floats, Ints] | None:
        """Return the control mesh in a pose; see Result.control_mesh()."""
        names = [entry.name for entry in self._model.contacts]
        if contact is not None and contact not in names:
            raise InputError(f'there is no contact "{contact}"', f"names are {', '.join(names)}")
        number = -1 if contact is None else names.index(contact)
        found = self._kernel.control_mesh(number, deformed)
        return cast("tuple[Floats, Ints] | None", found)
