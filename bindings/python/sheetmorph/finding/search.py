# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search: features of each part by the kernel, then contacts between all parts."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.kernel import load_kernel
from ..base.progress import Progress
from .common import common_entry, common_nodes
from .exact import with_exact
from .findings import FindPart, Findings, contact_entry, feature_entry
from .options import FindOptions

if TYPE_CHECKING:
    from .. import _core

# Part, vertex, part, vertex, number of the joint (-1: none), 1 for a rigid body.
Connection = tuple[int, int, int, int, int, int]


def find(
    parts: Sequence[FindPart],
    options: FindOptions = FindOptions(),
    connections: Sequence[Connection] = (),
    progress: Progress | None = None,
    *,
    with_contacts: bool = True,
) -> Findings:
    """Return the features and, unless switched off, the contacts of an assembly.

    connections are elements that join two parts: part, vertex index, part, vertex index, number of
    the weld or bolt (-1: none), 1 for a rigid body and 0 otherwise. progress(fraction, task) may
    return False to cancel (RuntimeError). Raises RuntimeError without a kernel, and ValueError for
    options out of range.
    """
    core = load_kernel()
    begin = time.perf_counter()
    meshes = [core.TriangleMesh(part.mesh.points, part.mesh.triangles) for part in parts]
    features = _features(core, parts, meshes, options, progress)
    middle = time.perf_counter()
    contacts: list[_core.FoundContact] = []
    gap = 0.0
    if with_contacts and len(parts) > 1:
        # The proposed gap depends only on the distance of the meshes, so it ignores the thickness.
        thin = [core.ContactPart(*of_part) for of_part in zip(meshes, [0.0] * len(parts), features)]
        thickness = [float(part.thickness) for part in parts]
        if options.gap is None:
            # The gap already contains the thickness; adding both would count it twice.
            gap = core.proposed_gap(thin, options.contact_tolerances(core))
            options = options.changed({"gap": gap})
            thickness = [max(0.0, thick - gap) for thick in thickness]
        shapes = [core.ContactPart(*of_part) for of_part in zip(meshes, thickness, features)]
        contacts, gap = _contacts(core, shapes, options, connections, progress)
    return Findings(
        features=_feature_entries(parts, features, options),
        contacts=_contact_entries(parts, contacts, options),
        gap=gap,
        primary=_primary_candidates(parts, contacts),
        seconds={"features": middle - begin, "contacts": time.perf_counter() - middle},
    )


def _features(
    core: ModuleType,
    parts: Sequence[FindPart],
    meshes: list[_core.TriangleMesh],
    options: FindOptions,
    progress: Progress | None,
) -> list[list[_core.Feature]]:
    """Return the features of every part, from its cache or from the kernel."""
    first = None if progress is None else lambda share, task: progress(0.5 * share, task)
    key = options.feature_key()
    new = [(part, mesh) for part, mesh in zip(parts, meshes) if key not in part.kept]
    found = core.find_features([mesh for _, mesh in new], options.feature_tolerances(core), first)
    for (part, _), features in zip(new, found):
        part.kept.clear()
        part.kept[key] = features
    return [part.kept[key] for part in parts]


def _contacts(
    core: ModuleType,
    shapes: list[_core.ContactPart],
    options: FindOptions,
    connections: Sequence[Connection],
    progress: Progress | None,
) -> tuple[list[_core.FoundContact], float]:
    """Return the contacts of the kernel, and the gap."""
    tolerances = options.contact_tolerances(core)
    rest = None if progress is None else lambda share, task: progress(0.5 + 0.5 * share, task)
    elements = [tuple(connection) for connection in connections]
    return core.find_contacts(shapes, elements, tolerances, rest), float(tolerances.gap)


def _feature_entries(
    parts: Sequence[FindPart], features: Sequence[Sequence[_core.Feature]], options: FindOptions
) -> list[dict[str, Any]]:
    entries = []
    for part, of_part in zip(parts, features):
        fitted = [feature_entry(part, found) for found in of_part if found.kind in options.kinds]
        counts: Counter[str] = Counter()
        walls = [{**k, "vertices": part.mesh.file_ids(k["vertices"])} for k in part.exact]
        known = [wall for wall in walls if _is_wanted(wall, options)]
        for entry in with_exact(fitted, known, walls):
            counts[entry["kind"]] += 1
            name = f"{part.name}: {entry['kind']} {counts[entry['kind']]}"
            entries.append({"name": name, "part": part.name, **entry})
    return entries


def _is_wanted(known: dict[str, Any], options: FindOptions) -> bool:
    """Return whether the options include a CAD feature."""
    is_hole = known["kind"] == "round hole"
    is_sized = options.smallest_radius <= known.get("radius", 0.0) <= options.largest_radius
    return known["kind"] in options.kinds and (is_sized or not is_hole)


def _contact_entries(
    parts: Sequence[FindPart], contacts: Sequence[_core.FoundContact], options: FindOptions
) -> list[dict[str, Any]]:
    meshes = {part.name: part.mesh for part in parts}
    common = common_nodes(meshes)
    entries = [common_entry(pair, ids, meshes) for pair, ids in common.items()]
    entries = entries if "edge" in options.contact_kinds else []
    shared = {pair: set(ids) for pair, ids in common.items()}
    counts: Counter[str] = Counter()
    for found in contacts:
        ids = shared.get((parts[found.part_a].name, parts[found.part_b].name), set())
        if ids and not ids.isdisjoint(parts[found.part_a].mesh.file_ids(found.a)):
            continue  # common nodes already join this seam
        if found.kind in options.contact_kinds:
            pair = f"{parts[found.part_a].name} - {parts[found.part_b].name}: {found.kind}"
            counts[pair] += 1
            entries.append(contact_entry(parts, found, f"{pair} {counts[pair]}"))
    return entries


def _primary_candidates(
    parts: Sequence[FindPart], contacts: Sequence[_core.FoundContact]
) -> list[str]:
    """Return part names, most contact partners first and then largest, as likely primary parts."""
    touched: list[set[int]] = [set() for _ in parts]
    for found in contacts:
        touched[found.part_a].add(found.part_b)
        touched[found.part_b].add(found.part_a)

    def size(part: FindPart) -> float:
        return (
            float(np.linalg.norm(np.ptp(part.mesh.points, axis=0))) if len(part.mesh.points) else 0
        )

    order = sorted(range(len(parts)), key=lambda k: (-len(touched[k]), -size(parts[k]), k))
    return [parts[k].name for k in order]
