# SPDX-License-Identifier: LGPL-2.1-or-later
"""Poses: saved by name, applied, blended, compared, and copied as plain meshes."""

from __future__ import annotations

from dataclasses import replace

import FreeCAD
import numpy as np

from freecad.sheetmorph.bridge import conversion, solving
from freecad.sheetmorph.api.checks import number, require_assembly, require_kind
from freecad.sheetmorph.api.features import shape_of
from freecad.sheetmorph.api.motions import put, rest_centroid
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.pose import PoseProxy, keep_motions, kept_motions, kept_sizes
from freecad.sheetmorph.objects.properties import number_of
from freecad.sheetmorph.objects.region import FORM_FEATURE, HANDLE, PRESCRIBED
from freecad.sheetmorph.objects.region import as_told, motion_of
from freecad.sheetmorph.tools import poses as tools
from freecad.sheetmorph.tools.motion import Motion, motion_from


def save_pose(assembly, label: str = "Pose"):
    """Save the current motions, prescribed rotations and sizes, and return the pose."""
    require_assembly(assembly)
    return add_pose(assembly, label, present(assembly), sizes_of(assembly))


def add_pose(assembly, label: str, motions: tools.Pose, sizes: dict[str, float]):
    """Add a pose of motions and sizes by `region.Name` and return it."""
    pose = assembly.Document.addObject("App::FeaturePython", "Pose")
    PoseProxy(pose)
    pose.Label = label
    keep_motions(pose, motions, sizes)
    assembly.addObject(pose)
    return pose


def poses(assembly) -> list:
    """Return the poses of an assembly in the order of its group."""
    require_assembly(assembly)
    return model.poses(assembly)


def apply_pose(pose) -> None:
    """Restore the motions and sizes of a saved pose; handles added later return to rest."""
    blend_poses(pose, pose, 0.0)


def blend_poses(first, second, weight: float) -> None:
    """Interpolate all handles between two poses of one assembly: the first at 0, the second at 1.

    One of them may be None, for rest with the sizes of the mesh. Translations, pivots and sizes are
    interpolated linearly, rotations by angle. A weight outside 0 .. 1 extrapolates. Raises
    ValueError.
    """
    assembly = assembly_of_poses(first, second)
    share = number(weight, "weight")
    ends = (motions_in(assembly, first), motions_in(assembly, second))
    for name, motion in tools.blended(*alike(assembly, *ends), share).items():
        put(assembly.Document.getObject(name), motion)
    for name, size in blended_sizes(assembly, first, second, share).items():
        feature = assembly.Document.getObject(name)
        if number_of(feature, "Size") != size:
            feature.Size = size


def compare_poses(first, second) -> dict[str, tuple[float, float]]:
    """Return the largest and mean distance between two poses by `part.Name`, mm.

    One of them may be None, for rest. The document does not change. Raises ValueError.
    """
    assembly = assembly_of_poses(first, second)
    one, other = (deform_in(assembly, pose) for pose in (first, second))
    apart = {name: np.linalg.norm(one[name] - other[name], axis=1) for name in one}
    return {name: (float(gap.max()), float(gap.mean())) for name, gap in apart.items()}


def copy_as_meshes(assembly, pose=None, label: str | None = None):
    """Return a new group of plain meshes, one per part, in a pose or in the current state.

    The meshes do not depend on other objects. Raises ValueError.
    """
    require_assembly(assembly)
    if pose is not None and assembly_of_poses(pose, pose) != assembly:
        raise ValueError(
            f"'{pose.Label}' is not a pose of '{assembly.Label}'; pass one of its poses."
        )
    found = solving.deform(assembly) if pose is None else deform_in(assembly, pose)
    document = assembly.Document
    group = document.addObject("App::DocumentObjectGroup", "Meshes")
    group.Label = label or f"{assembly.Label} {pose.Label if pose else 'meshes'}"
    morph = solving.read_morph(assembly)
    for part in model.parts(assembly):
        rest = morph.rests[part.Name]
        mesh = document.addObject("Mesh::Feature", "Mesh")
        mesh.Label = f"{part.Label} {pose.Label if pose else 'mesh'}"
        local = rest.frame.to_local(found[part.Name])
        placement = part.Source.getGlobalPlacement()
        mesh.Mesh = conversion.MeshWriter(rest.triangles).mesh(local, placement)
        group.addObject(mesh)
    return group


def copy_in_pose(pose, label: str | None = None):
    """Copy the assembly of a pose with its content, apply the pose to the copy and return it.

    The original does not change. By default the `label` is that of the assembly and the pose.
    Raises ValueError.
    """
    assembly = assembly_of_poses(pose, pose)
    place = model.poses(assembly).index(pose)
    twin = assembly.Document.copyObject(assembly, True)
    apply_pose(model.poses(twin)[place])
    twin.Label = label or f"{assembly.Label} {pose.Label}"
    return twin


def named_poses(assembly, names: dict[str, str]) -> dict[str, dict]:
    """Return all poses in the form of a recipe; `names` maps object names to recipe names."""
    return {
        pose.Label: {names[name]: moved.entry() for name, moved in told_in(assembly, pose).items()}
        for pose in model.poses(assembly)
    }


def add_named_poses(assembly, recipe: dict, regions: dict) -> None:
    """Add the poses of a recipe; `regions` are by their recipe names.

    A pose object has no targets of points, so they are omitted with a warning.
    """
    for label, entries in recipe.get("poses", {}).items():
        known = {regions[name]: entry for name, entry in entries.items() if name in regions}
        motions = {region.Name: motion_told(region, entry) for region, entry in known.items()}
        sizes = {r.Name: float(entry["size"]) for r, entry in known.items() if "size" in entry}
        still = {r.Name: motion_of(r) for r in moving(assembly)}
        kept = {name: motion for name, motion in motions.items() if name in still}
        add_pose(assembly, label, still | kept, sizes_of(assembly) | sizes)
        if len(known) < len(entries):
            FreeCAD.Console.PrintWarning(
                f"SheetMorph: pose '{label}' was saved without the targets of points.\n"
            )


def motion_told(region, entry: dict) -> Motion:
    """Return a recipe entry as a motion; without a pivot it keeps the current one."""
    motion = motion_from(entry)
    return motion if "pivot" in entry else replace(motion, pivot=motion_of(region).pivot)


def assembly_of_poses(first, second):
    """Return the assembly of two poses, one of which may be None. Raises ValueError."""
    given = [pose for pose in (first, second) if pose is not None]
    if not given:
        raise ValueError("Both poses are None; pass one pose at least.")
    for pose in given:
        require_kind(pose, model.POSE, "pose")
    owners = {model.assembly_of(pose) for pose in given}
    if len(owners) > 1 or None in owners:
        raise ValueError("The poses belong to different assemblies; pass two of one assembly.")
    return owners.pop()


def moving(assembly) -> list:
    """Return the regions in a pose: handles and prescribed rotations."""
    return [
        region
        for region in model.regions(assembly)
        if region.Part is not None
        and (
            region.Role == HANDLE or (region.Role == FORM_FEATURE and region.Rotation == PRESCRIBED)
        )
    ]


def present(assembly) -> tools.Pose:
    """Return the current motions of the document."""
    return {region.Name: motion_of(region) for region in moving(assembly)}


def snapshot(assembly) -> tools.Snapshot:
    """Return the current motions and sizes of the document."""
    return tools.Snapshot(present(assembly), sizes_of(assembly))


def restore(assembly, wanted: tools.Snapshot) -> None:
    """Restore a snapshot for all regions that still exist."""
    now, document = snapshot(assembly), assembly.Document
    for name, motion in wanted.motions.items():
        if now.motions.get(name, motion) != motion:
            put(document.getObject(name), motion)
    for name, size in wanted.sizes.items():
        if now.sizes.get(name, size) != size:
            document.getObject(name).Size = size


def motions_in(assembly, pose) -> tools.Pose:
    """Return the motion of every moving region in a pose, or at rest for None."""
    kept = kept_motions(pose) if pose is not None else {}
    return {region.Name: kept.get(region.Name, Motion()) for region in moving(assembly)}


def sizes_of(assembly) -> dict[str, float]:
    """Return the size of every form feature by `region.Name`, mm; 0 for that of the mesh."""
    features = [r for r in model.regions(assembly) if r.Role == FORM_FEATURE and r.Part is not None]
    return {feature.Name: number_of(feature, "Size") for feature in features}


def blended_sizes(assembly, first, second, weight: float) -> dict[str, float]:
    """Return the sizes between two poses, None for rest; features without a size are omitted."""
    known = sizes_of(assembly)
    one, other = (
        dict.fromkeys(known, 0.0) if p is None else kept_sizes(p) for p in (first, second)
    )
    found = {}
    for name in known.keys() & one.keys() & other.keys():
        ends = (one[name], other[name])
        if ends[0] == ends[1] or weight in (0.0, 1.0):
            found[name] = ends[int(weight == 1.0)]
        else:
            ends = [size or size_at_rest(assembly, name) for size in ends]
            found[name] = (1.0 - weight) * ends[0] + weight * ends[1]
    return found


def size_at_rest(assembly, name: str) -> float:
    """Return the size of a form feature in the mesh, mm."""
    return shape_of(assembly.Document.getObject(name)).size


def told_in(assembly, pose) -> tools.Pose:
    """Return the kernel input for a pose, None for rest, by `region.Name`.

    A size is included if it differs from the one in the document.
    """
    document, present_sizes = assembly.Document, sizes_of(assembly)
    motions = motions_in(assembly, pose)
    moved = {name: as_told(document.getObject(name), motion) for name, motion in motions.items()}
    for name, size in blended_sizes(assembly, pose, pose, 0.0).items():
        if size != present_sizes[name]:
            told = size or size_at_rest(assembly, name)
            moved[name] = replace(moved.get(name, Motion(None, None)), size=told)
    return moved


def alike(assembly, first: tools.Pose, second: tools.Pose) -> tuple:
    """Return both poses with pivots of the same kind.

    If one pivot is the centroid and the other a point, the centroid becomes a point.
    """
    for name in first:
        if (first[name].pivot is None) != (second[name].pivot is None):
            centre = tuple(rest_centroid(assembly.Document.getObject(name)))
            for pose in (first, second):
                if pose[name].pivot is None:
                    pose[name] = replace(pose[name], pivot=centre)
    return first, second


def deform_in(assembly, pose) -> dict[str, np.ndarray]:
    """Return the positions (n, 3) of all parts in a pose by `part.Name`; the document stays."""
    return solving.deform_in(assembly, told_in(assembly, pose))
