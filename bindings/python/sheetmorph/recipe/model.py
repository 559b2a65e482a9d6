# SPDX-License-Identifier: LGPL-2.1-or-later
"""A recipe as typed entries, defaults filled in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from ..errors import Subject
from ..files import is_cad, unpacked_name
from ..files.cad_writing import CadWriting
from ..prepared_mesh import Wanted
from .feature_entries import (
    RELATIONS,
    FeatureMotion,
    RelationEntry,
    SymmetryEntry,
    Vector,
    feature_motion_of,
    number_of,
    relation_of,
    symmetry_of,
    vector_of,
)
from .placement import Placement
from .pose import Moved, Rotation, pose_of, rotation_of
from .places import driven_in, place_of


@dataclass(frozen=True)
class Sheet:
    """What a part is as `steel`; thickness: mm, 0 if the part itself has to tell."""

    thickness: float = 0.0
    poisson: float = 0.3


@dataclass(frozen=True)
class PartEntry:
    """A part; where: its place in the recipe, for messages; file: "" if none is given.

    mode: 1 to 3 (section 4.1), 0 if left to the part; split: "components" or "property" if the
    entry stands for several parts, "" if it is one; meshing: edge, deflection, angle of a CAD file.
    thin: "auto" if it is solved as a thin solid where it is one, "by default" if it is because it
    comes from CAD, "yes" if it must be one, "" if it is solved as it is; thickness: mm, 0 if it is
    found out; wanted: scale, weld, remesh; placement: from the coordinates of the file, in mm, to
    those of the assembly; sheet: as `steel`; write: how its shapes are written besides, None if
    they are not; deck: `passengers` and `joints`, for parts in decks.
    """

    where: str
    name: str
    file: str
    mode: int = 0
    split: str = ""
    meshing: dict[str, float] | None = None
    thin: str = ""
    thickness: float = 0.0
    wanted: Wanted = Wanted()
    placement: Placement = Placement()
    sheet: Sheet = Sheet()
    write: CadWriting | None = None
    deck: dict[str, Any] = field(default_factory=dict)

    @property
    def subject(self) -> Subject:
        """What a fault names it by."""
        return Subject("part", self.name)

    @property
    def stem(self) -> str:
        """What stands before the "/" in the names of the parts of a split file."""
        return unpacked_name(self.file).stem


@dataclass(frozen=True)
class RegionEntry:
    """Vertices of a part (file ids, each once, in the recipe's order) or a point on a triangle.

    kind: "fixed", "handle", "feature", "point", "follower" or "side" (of a contact); pivot of a
    handle (None: centroid); turning: "free" (the energy's), "interpolated" or "prescribed" of a
    feature, "free" or "prescribed" of a handle; rotation of a prescribed feature or of a point
    (None: free to turn); motion and size (mm) of a feature; target of a point; selector: what says
    which vertices, still to be resolved; is_prepared: the vertices count in the prepared mesh;
    owner: whose it is, if it is no entry of its own.
    """

    where: str
    kind: str
    name: str
    part: str
    vertices: list[int] | None = None
    triangle: int | None = None
    barycentric: Vector | None = None
    pivot: Vector | None = None
    rotation: Rotation | None = None
    target: Vector | None = None
    turning: str = "prescribed"
    motion: FeatureMotion = FeatureMotion()
    size: float | None = None
    selector: Any = None
    is_prepared: bool = False
    owner: Subject | None = None

    @property
    def subject(self) -> Subject:
        """What a fault names it by: the contact of a side, the part of what it drives itself."""
        kind = "fixed region" if self.kind == "fixed" else self.kind
        return self.owner or Subject(kind, self.name)

    @property
    def is_point(self) -> bool:
        """Whether it is a point on a triangle rather than a set of vertices."""
        return self.vertices is None and self.selector is None

    @property
    def on_triangle(self) -> tuple[int, Vector]:
        """The triangle of a point, and where on it."""
        assert self.triangle is not None and self.barycentric is not None
        return self.triangle, self.barycentric


@dataclass(frozen=True)
class ContactEntry:
    """Two sides that stay together; type: "control mesh", "tied" or "rigid"."""

    where: str
    name: str
    type: str
    a: RegionEntry
    b: RegionEntry

    @property
    def subject(self) -> Subject:
        """What a fault names it by."""
        return Subject("contact", self.name)


@dataclass(frozen=True)
class PropagationEntry:
    """How motion reaches the other parts: "local", "single" or "whole", levels, smoothness c of
    (3.3)."""

    type: str = "local"
    levels: int = 3
    smoothness: float = 0.05


@dataclass(frozen=True)
class JointFileEntry:
    """A file of welds and bolts; reach and limit: mm, None for the usual; is_refused: whether a
    broken joint is an error."""

    where: str
    file: str
    reach: float | None = None
    limit: float | None = None
    is_refused: bool = True


@dataclass(frozen=True)
class Model:
    """A whole recipe; pose by the name of handle, feature or point, poses by
    their names; found: what a search put in; told: by place of a region what its selector came to.
    """

    parts: list[PartEntry] = field(default_factory=list)
    primary: str | None = None
    energy: str = "neumann"
    operator: str = "cotangent"
    regions: list[RegionEntry] = field(default_factory=list)
    contacts: list[ContactEntry] = field(default_factory=list)
    relations: list[RelationEntry] = field(default_factory=list)
    symmetry: SymmetryEntry | None = None
    refine: bool = False
    unheld: str = "rest"
    propagation: PropagationEntry = PropagationEntry()
    pose: dict[str, Moved] = field(default_factory=dict)
    poses: dict[str, dict[str, Moved]] = field(default_factory=dict)
    joint_files: list[JointFileEntry] = field(default_factory=list)
    found: dict[str, Any] | None = None
    told: dict[str, dict[str, Any]] = field(default_factory=dict)

    @property
    def all_regions(self) -> list[RegionEntry]:
        """The regions and both sides of every contact."""
        return [*self.regions, *(side for c in self.contacts for side in (c.a, c.b))]

    def with_parts(self, parts: list[PartEntry]) -> Model:
        """The same with other parts; a single one is the primary if none is named."""
        primary = self.primary
        if primary is None and len(parts) == 1:
            primary = parts[0].name
        return replace(self, parts=parts, primary=primary)

    def of_kind(self, kind: str) -> list[RegionEntry]:
        """The fixed regions, handles, features or points."""
        return [region for region in self.regions if region.kind == kind]


_SECTIONS = (
    ("fixed", "fixed"),
    ("handles", "handle"),
    ("features", "feature"),
    ("points", "point"),
    ("regions", "follower"),
)


def model_of(recipe: dict[str, Any]) -> Model:
    """The entries of a recipe of sound form; entries that are None are left out."""
    parts = [_part(where, k, entry) for where, k, entry in _entries(recipe, "parts")]
    contacts = [_contact(where, k, entry) for where, k, entry in _entries(recipe, "contacts")]
    regions = [
        _region(kind, where, k, entry)
        for section, kind in _SECTIONS
        for where, k, entry in _entries(recipe, section)
    ]
    regions += [_driven(recipe, *entry) for entry in driven_in(recipe)]
    return Model(
        parts=parts,
        primary=recipe.get("primary"),
        energy=recipe.get("energy", Model.energy),
        operator=recipe.get("operator", Model.operator),
        regions=regions,
        contacts=contacts,
        relations=[
            relation_of(kind, where, k, entry)
            for section, kind in RELATIONS
            for where, k, entry in _entries(recipe, section)
        ],
        symmetry=symmetry_of(recipe.get("symmetry")),
        refine=bool(recipe.get("refine", False)),
        unheld=recipe.get("unheld", Model.unheld),
        propagation=_propagation(**recipe.get("propagation", {})),
        pose=pose_of(recipe.get("pose", {})),
        poses={name: pose_of(pose) for name, pose in recipe.get("poses", {}).items()},
        joint_files=[_joint_file(*entry) for entry in _entries(recipe, "joint_files")],
    )


def _joint_file(where: str, _number: int, entry: dict[str, Any]) -> JointFileEntry:
    is_refused = entry.get("broken", "refuse") == "refuse"
    reach, limit = (number_of(entry.get(key)) for key in ("reach", "limit"))
    return JointFileEntry(where, entry.get("file", ""), reach, limit, is_refused)


def _propagation(**entry: Any) -> PropagationEntry:
    # JSON Schema takes 3.0 for a whole number, the kernel does not.
    sound = {key: value for key, value in entry.items() if value is not None}
    found = PropagationEntry(**sound)
    return replace(found, levels=int(found.levels), smoothness=float(found.smoothness))


def _part(where: str, k: int, entry: dict[str, Any]) -> PartEntry:
    split = entry.get("split", False)
    split = {True: "components", False: ""}.get(split, split)
    name = entry.get("name", "" if split else f"part{k}")
    file, mode = entry.get("file", ""), int(entry.get("mode", 0))
    return PartEntry(
        where, name, file, mode, split, entry.get("mesh"), *_thin(entry), wanted=_wanted(entry),
        placement=Placement.of_entry(entry.get("placement") or {}),
        sheet=Sheet(float(entry.get("thickness") or 0.0), float(entry.get("poisson", 0.3))),
        write=_write(entry),
        deck={key: entry[key] for key in ("passengers", "joints") if key in entry},
    )  # fmt: skip


def _thin(entry: dict[str, Any]) -> tuple[str, float]:
    """ "auto", "by default", "yes" or "", and the thickness."""
    default = "by default" if is_cad(entry.get("file", "")) else ""
    thin = entry.get("thin", default)
    if isinstance(thin, dict):
        return "yes", float(thin["thickness"])
    return thin or "", 0.0


def _wanted(entry: dict[str, Any]) -> Wanted:
    remesh = entry.get("remesh") or {}
    return Wanted(
        entry.get("weld"),
        remesh.get("edge"),
        remesh.get("rims", "polygon"),
        entry.get("scale", 1.0),
    )


def _write(entry: dict[str, Any]) -> CadWriting | None:
    if "write" not in entry:
        return None
    return CadWriting(
        entry["write"],
        float(entry.get("write_tolerance", CadWriting.tolerance)),
        float(entry.get("write_edge_tolerance", CadWriting.edge_tolerance)),
    )


def _contact(where: str, k: int, entry: dict[str, Any]) -> ContactEntry:
    name = entry.get("name", f"contact{k}")
    sides = [
        replace(
            _region("side", f"{where}.{key}", k, entry[key]),
            name=f"{name}: {key}",
            owner=Subject("contact", name),
        )
        for key in ("a", "b")
    ]
    return ContactEntry(where, name, entry.get("type", "control mesh"), *sides)


def _driven(recipe: dict[str, Any], k: int, part: str, entry: dict[str, Any]) -> RegionEntry:
    where = place_of(recipe, ["parts", k, "driven"])
    found = _region("follower", where, k, {**entry, "part": part, "name": f"{part}: driven"})
    return replace(found, owner=Subject("part", part))


def _entries(recipe: dict[str, Any], section: str) -> Iterator[tuple[str, int, dict[str, Any]]]:
    for k, entry in enumerate(recipe.get(section, [])):
        if entry is not None:
            yield place_of(recipe, [section, k]), k, entry


def _region(kind: str, where: str, k: int, entry: dict[str, Any]) -> RegionEntry:
    vertices = entry.get("vertices")
    triangle = entry.get("triangle")
    return RegionEntry(
        where=where,
        kind=kind,
        name=entry.get("name", f"{kind}{k}"),
        part=entry["part"],
        vertices=None if vertices is None else list(dict.fromkeys(map(int, vertices))),
        triangle=None if triangle is None else int(triangle),
        barycentric=vector_of(entry.get("barycentric")),
        pivot=vector_of(entry.get("pivot")),
        rotation=rotation_of(entry.get("rotation")),
        target=vector_of(entry.get("target")),
        turning=_turning(entry.get("rotation"), "free" if kind == "feature" else "prescribed"),
        motion=feature_motion_of(entry.get("motion", {})),
        size=number_of(entry.get("size")),
        selector=entry.get("where"),
        is_prepared=entry.get("ids") == "prepared",
    )


def _turning(rotation: Any, default: str) -> str:
    if isinstance(rotation, dict):
        return "prescribed"
    found: str = default if rotation is None else rotation
    return found
