# SPDX-License-Identifier: LGPL-2.1-or-later
"""A recipe as typed entries with all defaults."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from ..base.errors import Subject
from ..files import is_cad, unpacked_name
from ..files.cad_writing import CadWriting
from ..files.prepared_mesh import Wanted
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
from .places import driven_in, place_of
from .pose import Moved, Rotation, pose_of, rotation_of


@dataclass(frozen=True)
class Sheet:
    """Sheet properties for the energy `steel`; thickness is in mm, 0 to use that of the part."""

    thickness: float = 0.0
    poisson: float = 0.3


@dataclass(frozen=True)
class PartEntry:
    """A part of the recipe.

    Attributes
    ----------
    where : str
        Place in the recipe, for messages.
    name, file : str
        Name, and path of the file or "".
    mode : int
        1 to 3 (section 4.1); 0 to choose automatically.
    split : str
        "components" or "property" if the entry stands for several parts, else "".
    meshing : dict or None
        edge, deflection and angle for a CAD file.
    thin : str
        "yes" for a thin solid; "auto" or, for CAD files, "by default" for one if it is recognised;
        "" for none.
    thickness : float
        Thickness of the thin solid, mm; 0 to measure it.
    wanted : Wanted
        Scale, weld and remesh.
    placement : Placement
        Maps file coordinates, mm, to those of the assembly.
    sheet : Sheet
        Properties for the energy `steel`.
    write : CadWriting or None
        Output of the CAD shapes.
    deck : dict
        `passengers` and `joints` of a deck.
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
        """The part as named in a fault."""
        return Subject("part", self.name)

    @property
    def stem(self) -> str:
        """Prefix before "/" in the names of the parts of a split file."""
        return unpacked_name(self.file).stem


@dataclass(frozen=True)
class RegionEntry:
    """A set of vertices of a part, as unique file ids in recipe order, or a point on a triangle.

    Attributes
    ----------
    kind : str
        "fixed", "handle", "feature", "point", "follower" or "side" (of a contact).
    pivot : Vector or None
        Pivot of a handle, mm; None for the centroid.
    turning : str
        "free", "interpolated" or "prescribed" for a feature; "free" or "prescribed" for a handle.
    rotation : Rotation or None
        Rotation of a prescribed feature or of a point; None leaves it free.
    motion : FeatureMotion
        Admissible motion of a feature.
    size : float or None
        Size of a feature, mm.
    target : Vector or None
        Target position of a point, mm.
    selector
        Selector that is not resolved yet.
    is_prepared : bool
        The vertex ids are those of the prepared mesh.
    owner : Subject or None
        The entry that contains the region.
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
        """The region as named in a fault; a contact side or `driven` has its owner."""
        kind = "fixed region" if self.kind == "fixed" else self.kind
        return self.owner or Subject(kind, self.name)

    @property
    def is_point(self) -> bool:
        """Whether the region is a point on a triangle and not a set of vertices."""
        return self.vertices is None and self.selector is None

    @property
    def on_triangle(self) -> tuple[int, Vector]:
        """The triangle of a point, and its barycentric coordinates."""
        assert self.triangle is not None and self.barycentric is not None
        return self.triangle, self.barycentric


@dataclass(frozen=True)
class ContactEntry:
    """Two sides that stay together; type is "control mesh", "tied" or "rigid"."""

    where: str
    name: str
    type: str
    a: RegionEntry
    b: RegionEntry

    @property
    def subject(self) -> Subject:
        """The contact as named in a fault."""
        return Subject("contact", self.name)


@dataclass(frozen=True)
class PropagationEntry:
    """Propagation: type "local", "single" or "whole", levels, smoothness c of (3.3)."""

    type: str = "local"
    levels: int = 3
    smoothness: float = 0.05


@dataclass(frozen=True)
class JointFileEntry:
    """A file of welds and bolts.

    reach and limit are in mm, None for the defaults. is_refused states whether a broken joint is an
    error.
    """

    where: str
    file: str
    reach: float | None = None
    limit: float | None = None
    is_refused: bool = True


@dataclass(frozen=True)
class Model:
    """A whole recipe.

    pose maps names of handles, features and points to motions, and poses maps names to poses. found
    is the search result. The dict `told` maps the place of a region to the result of its selector.
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
        """Return a copy with other parts; a single part becomes the primary."""
        primary = self.primary
        if primary is None and len(parts) == 1:
            primary = parts[0].name
        return replace(self, parts=parts, primary=primary)

    def of_kind(self, kind: str) -> list[RegionEntry]:
        """Return the regions of one kind."""
        return [region for region in self.regions if region.kind == kind]


_SECTIONS = (
    ("fixed", "fixed"),
    ("handles", "handle"),
    ("features", "feature"),
    ("points", "point"),
    ("regions", "follower"),
)


def model_of(recipe: dict[str, Any]) -> Model:
    """Return the model of a recipe with checked form; entries that are None are left out."""
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
    # JSON Schema accepts 3.0 as a whole number, but the kernel needs an int.
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
    """Return "auto", "by default", "yes" or "", and the thickness."""
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
