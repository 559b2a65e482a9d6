# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in memory: checked and factorised once, then deformed pose by pose."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from .kernel import load_kernel
from .live import Drag
from .part_mesh import PartMesh
from .recipe import check_pose, check_with_meshes
from .recipe.found import Found
from .recipe.model import Model
from .report import make_report
from .translation import Translator, kernel_faults

Progress = Callable[[float, str], bool]


@dataclass(frozen=True)
class FeatureResult:
    """How a form feature moved: p = centre + translation + rotation (p_hat - centre).

    rotation: (3, 3); translation, centre: (3,), mm; edge_error: worst |p_i - p_j - R (p_hat_i -
    p_hat_j)| over its edges, mm (2.4); rotation_type: "free", "interpolated" or "prescribed";
    motion: its type; size: mm, None unless it is set, then kind is "hole" (diameter), "slot"
    (length) or "cylinder" (radius), p_hat has that size, and outline_error is the worst distance of
    its rim from the exact outline, mm.
    """

    name: str
    part: str
    rotation: np.ndarray
    translation: np.ndarray
    centre: np.ndarray
    edge_error: float
    rotation_type: str = "free"
    motion: str = "free"
    kind: str | None = None
    size: float | None = None
    outline_error: float | None = None


@dataclass(frozen=True)
class ContactResult:
    """How well a contact between two reached parts was kept, mm.

    deviation: farthest a driven vertex of `target` is from the best rigid motion of the side on
    `source`; gap_change: worst change of a driven vertex's distance to that side; region_size:
    diagonal of both sides at rest, to compare with.
    """

    name: str
    type: str
    source: str
    target: str
    deviation: float
    gap_change: float
    region_size: float


@dataclass(frozen=True, eq=False)
class Result:
    """All parts in one pose.

    positions: part name -> (n, 3) float64 mm, read-only; contacts: empty if not exact; spread: the
    largest distance between two places where contacts want one vertex, mm, 0 if not exact;
    deformed: the kernel's own result; lumps: where thin solids are not thin, each a rigid feature.
    """

    session: Session
    positions: dict[str, np.ndarray]
    features: list[FeatureResult]
    contacts: list[ContactResult]
    spread: float
    pose: dict[str, Any]
    deformed: Any
    lumps: list[FeatureResult] = field(default_factory=list)
    crossings: dict[str, tuple[int, ...]] = field(default_factory=dict)  # counted when asked for

    def control_mesh(self, contact: str | None = None) -> tuple[np.ndarray, np.ndarray] | None:
        """Vertices (m, 3) mm and triangles (t, 3) of a contact's control mesh in this pose.

        contact None: the single one. None if there is no such control mesh; ValueError for an
        unknown contact.
        """
        return self.session.control_mesh(contact, self.deformed)

    def report(self) -> dict[str, Any]:
        """The report (report.schema.json) without what concerns files."""
        return make_report(self)


class Session:
    """The pre-processing phase of a recipe whose parts are given as meshes.

    recipe: as in a recipe file ("file" of a part is not needed); meshes: PartMesh by part name;
    progress(fraction, task) may return False to cancel (RuntimeError); previous: a session of an
    earlier state of the recipe, from which what did not change is taken over; found: what a search
    in the files has put in place of "auto", else it is searched for here.
    Raises RecipeError, KernelError.
    """

    def __init__(
        self,
        recipe: dict[str, Any],
        meshes: Mapping[str, PartMesh],
        progress: Progress | None = None,
        previous: Session | None = None,
        *,
        found: Found | None = None,
    ):
        model = check_with_meshes(recipe, meshes, found)
        self._recipe_pose = dict(recipe.get("pose", {}))
        self._model = model
        self.meshes = {part.name: meshes[part.name] for part in model.parts}
        self._core = load_kernel()
        with kernel_faults(self._core):
            self._translator = Translator(self._core, model, self.meshes)
            assembly = self._translator.assembly()
            earlier = None if previous is None else previous._kernel
            self._kernel = self._core.DeformationSession(assembly, progress, earlier)

    @property
    def model(self) -> Model:
        """The recipe's entries."""
        return self._model

    @property
    def core(self) -> Any:
        """The kernel module in use."""
        return self._core

    @property
    def parts(self) -> list[str]:
        """Part names in the recipe's order."""
        return [part.name for part in self._model.parts]

    @property
    def order(self) -> list[str]:
        """Names of the parts that are reached, in the order in which they are deformed."""
        return list(self._kernel.order)

    @property
    def levels(self) -> dict[str, int]:
        """By part: how many contacts it is away from the primary, -1 if not reached."""
        return dict(zip(self.parts, self._kernel.levels))

    @property
    def directions(self) -> list[tuple[str, str, str]]:
        """(contact, source part, target part) of every contact in use."""
        names, contacts = self.parts, self._model.contacts
        found = self._kernel.directions
        return [(contacts[c].name, names[source], names[target]) for c, source, target in found]

    @property
    def unreached(self) -> list[str]:
        """Parts that nothing moves; they stay where they are."""
        return list(self._kernel.unreached)

    @property
    def timings(self) -> dict[str, float]:
        """Seconds of pre-processing, stage by stage."""
        return {timing.stage: float(timing.seconds) for timing in self._kernel.timings}

    @property
    def size(self) -> float:
        """Diagonal of the box around all parts at rest, mm."""
        low = np.min([mesh.points.min(axis=0) for mesh in self.meshes.values()], axis=0)
        high = np.max([mesh.points.max(axis=0) for mesh in self.meshes.values()], axis=0)
        return float(np.linalg.norm(high - low))

    def thin_solid(self, part: str) -> Any:
        """The kernel's ThinSolid a part is solved as; None for one that is solved as it is."""
        return self._kernel.thin_solid(self.parts.index(part))

    def feature_vertices(self, name: str) -> np.ndarray:
        """Indices (k,) of a form feature's vertices in its part."""
        return next(entry.vertices for entry in self._kernel.features if entry.name == name)

    def rest_of(self, part: str, features: list[FeatureResult]) -> np.ndarray:
        """Positions (n, 3) of a part at rest, with the sizes its form features have; mm."""
        points = self.meshes[part].points
        rest = points.copy()
        for feature, shape in zip(features, self._kernel.shapes):
            if feature.part == part and feature.size is not None:
                vertices = self.feature_vertices(feature.name)
                rest[vertices] = shape.resized(points[vertices], feature.size)
        return rest

    def deform(self, pose: dict[str, Any] | None = None, exact: bool = True) -> Result:
        """All parts in a pose, always from rest; None: the recipe's pose.

        exact=False is the fast way while dragging, 1e-6 of the size. Raises RecipeError.
        """
        wanted = self._recipe_pose if pose is None else pose
        motions = check_pose(self._model, wanted)
        with kernel_faults(self._core):
            deformed = self._kernel.deform(self._translator.pose(motions), exact)
        return self._result(deformed, wanted)

    def begin_drag(self, handles: list[str], pose: dict[str, Any] | None = None) -> Drag:
        """Live frames while the named handles move, the others staying as in `pose`.

        Raises RecipeError for a name that is no handle.
        """
        wanted = self._recipe_pose if pose is None else pose
        start = self._translator.pose(check_pose(self._model, wanted))
        with kernel_faults(self._core):
            return Drag(self, self._kernel.begin_drag(handles, start))

    def dragged(self, kernel_drag: Any, pose: dict[str, Any]) -> Result:
        """What Drag.deform() answers."""
        motions = check_pose(self._model, pose)
        with kernel_faults(self._core):
            return self._result(kernel_drag.frame(self._translator.pose(motions)), pose)

    def _result(self, deformed: Any, wanted: dict[str, Any]) -> Result:
        features = self._features(deformed.features)
        solids = [self.thin_solid(part) for part in self.parts]
        lumps = sum(len(solid.lumps) for solid in solids if solid is not None)
        return Result(
            session=self,
            positions={name: deformed.positions(k) for k, name in enumerate(self.parts)},
            features=features[: len(features) - lumps],
            lumps=features[len(features) - lumps :],
            contacts=[self._contact(found) for found in deformed.contacts],
            spread=float(deformed.spread),
            pose=dict(wanted),
            deformed=deformed,
        )

    def control_mesh(self, contact: str | None, deformed: Any) -> Any:
        """What Result.control_mesh() answers."""
        names = [entry.name for entry in self._model.contacts]
        if contact is not None and contact not in names:
            raise ValueError(f'there is no contact "{contact}"; names are {", ".join(names)}')
        return self._kernel.control_mesh(-1 if contact is None else names.index(contact), deformed)

    def _features(self, found: list[Any]) -> list[FeatureResult]:
        entries = zip(found, self._kernel.features, self._kernel.shapes)
        return [
            FeatureResult(
                name=feature.name,
                part=self.parts[feature.part],
                rotation=feature.rotation,
                translation=feature.translation,
                centre=feature.centre,
                edge_error=float(feature.edge_error),
                rotation_type=entry.rotation,
                motion=entry.motion,
                kind=None if feature.size is None else shape.kind,
                size=feature.size,
                outline_error=None if feature.size is None else float(feature.outline_error),
            )
            for feature, entry, shape in entries
        ]

    def _contact(self, found: Any) -> ContactResult:
        entry = self._model.contacts[found.contact]
        return ContactResult(
            name=entry.name,
            type=entry.type,
            source=self.parts[found.source_part],
            target=self.parts[found.target_part],
            deviation=float(found.deviation),
            gap_change=float(found.gap_change),
            region_size=float(found.region_size),
        )
