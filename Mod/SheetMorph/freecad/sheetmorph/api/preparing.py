# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preparation of CAD exports: repaired and remeshed, with the picked regions transferred."""

from __future__ import annotations

import json
import os
import shutil
from dataclasses import replace

import numpy as np

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import conversion, kernel
from freecad.sheetmorph.api import following
from freecad.sheetmorph.api.assemblies import remove, set_primary
from freecad.sheetmorph.api.checks import number, require_kind
from freecad.sheetmorph.api.files import add_mesh
from freecad.sheetmorph.objects import assembly_of, model
from freecad.sheetmorph.objects.assembly import follow_group
from freecad.sheetmorph.bridge.snapshots import snapshot_of
from freecad.sheetmorph.bridge.rest import Kept, read_kept, read_original, write_rest_data

MOST_PIECES = 500


def prepare(part, bindings: dict | None = None, **cures) -> dict:
    """Repair and remesh a part, and return a summary.

    Preparation always starts from the mesh that was added or imported, which stays unchanged.
    Regions, contacts and features move to the new vertices at their positions. Regions with a
    selector are resolved on the new mesh. If an error is raised, nothing has changed.

    Parameters
    ----------
    part : object
        The part.
    bindings : dict, optional
        Answers to questions, as for `replace_file`.
    weld : float
        Merge vertices closer than this, mm.
    edge : float
        Edge length on flats, mm; edges at rims and bends are shorter.
    rims : str
        Round rims stay a "polygon" or move to their "circle".
    scale : float
        mm in the unit of the mesh; applied first.

    Returns
    -------
    dict
        scale, weld, welded, removed, split and turned. `remesh` has edge, rims, rims_on_circles,
        flats, deviation and flat_deviation (mm, from the old facets). `unsettled` names a step that
        did not converge, or is None. The entry `told` has a sentence for each region whose area
        changed by more than 3 %, and `different` their names.

    Raises
    ------
    ValueError
    """
    original = read_original(checked(part))
    made = preparation(part, **cures)
    scale = made.preparation["scale"]
    before = read_kept(part)
    old_scale = scale_of(part)
    if part.Original is not None:
        core = kernel.core()
        old = package_mesh(before.points * (scale / old_scale), before.triangles)
        placed = prepared_module().placed_on(core, made, old)
    else:
        placed = made
    told: dict[str, str] = {}
    change = following.Change(placed, made, scale / old_scale, bindings or {})
    moved = following.moved_vertices(part, change, told)
    features = moved_features(before.features, placed, scale / old_scale)
    extras = moved_extras(part, placed)
    exchange(part, original, made, (scale, features))
    following.keep_moved(moved)
    if extras is not None:
        assembly_of(part).Extras = extras
    done = {**made.preparation, "told": list(told.values()), "different": list(told)}
    part.Preparation = json.dumps(done)
    return done


def preparation(part, **cures):
    """Return the mesh, a sheetmorph.PreparedMesh, that `prepare` would give a part.

    Its points are file coordinates times the scale; the document does not change.
    """
    original = read_original(checked(part))
    wanted = wanted_of(cures)
    mesh = kernel.load().PartMesh(
        original.points, original.triangles, name=part.Label, labels=original.labels
    )
    core, prepared_mesh = kernel.core(), prepared_module().prepared_mesh
    return reporting.waited_for(lambda told: prepared_mesh(core, mesh, wanted, told))[0]


def wanted_of(cures: dict):
    """Return the cures as a sheetmorph.files.prepared_mesh.Wanted, or raise ValueError."""
    module = prepared_module()
    unknown = sorted(set(cures) - {"weld", "edge", "rims", "scale"})
    if unknown:
        raise ValueError(f"Unknown repair '{unknown[0]}'; use weld, edge, rims or scale.")
    rims = cures.get("rims", "polygon")
    if rims not in module.RIMS:
        raise ValueError(f"Rims cannot become '{rims}'; use {' or '.join(map(repr, module.RIMS))}.")
    weld, edge = cures.get("weld"), cures.get("edge")
    return module.Wanted(
        None if weld is None else positive(weld, "weld tolerance", least=0.0),
        None if edge is None else positive(edge, "edge length"),
        rims,
        positive(cures.get("scale", 1.0), "scale"),
    )


def split_part(part) -> list:
    """Replace a part by one part per connected piece, and return them.

    They are named after the part with a number, and inherit its thin solid property. The source
    mesh stays. The largest piece becomes the primary if the part was. A part in one piece does not
    change. Raises ValueError if the part has regions or contacts, or has too many pieces; then
    nothing has changed.
    """
    assembly = assembly_of(checked(part))
    if marked := model.regions(assembly, part) + model.contacts(assembly, part):
        raise ValueError(
            f"'{marked[0].Label}' is marked on '{part.Label}': split the part "
            "first, then mark its pieces."
        )
    kept = read_kept(part)
    whole = package_mesh(kept.frame.to_global(kept.points), kept.triangles)
    splitting = splitting_module()
    pieces = splitting.pieces_of(whole)
    if len(pieces) > MOST_PIECES:
        raise ValueError(f"'{part.Label}' is in {len(pieces)} pieces: weld it first.")
    if len(pieces) < 2:
        return [part]
    label, thin, was_primary = part.Label, part.Thin, assembly.Primary == part
    sources = [source.Name for source in (part.Source, part.Original) if source is not None]
    remove(part)
    for source in map(assembly.Document.getObject, sources):
        if source is not None:
            source.Visibility = False
    made = []
    for number_of, rows in pieces.items():
        mesh, _ = splitting.part_of(whole, rows, f"{label} {number_of}")
        made.append(add_mesh(assembly, replace(mesh, ids=None), mesh.name))
        made[-1].Thin = thin
    if was_primary:
        set_primary(assembly, made[int(np.argmax([len(rows) for rows in pieces.values()]))])
    return made


def preparation_of(part) -> dict:
    """Return the summary of the last `prepare` of a part; empty if there was none."""
    return json.loads(checked(part).Preparation) if part.Preparation else {}


def diagnose_original(part, scale: float = 1.0) -> dict:
    """Return the diagnosis of the mesh from which `prepare` starts, times a scale."""
    original, package = read_original(checked(part)), kernel.load()

    def found() -> dict:
        mesh = package_mesh(scale * original.points, original.triangles)
        return reporting.waited_for(lambda _told: package.diagnose(mesh))

    kept = snapshot_of(part.Original or part.Source)
    return kept.derived("diagnosis", (scale, original.frame.key, original.is_exact), found)


def places_of(part, made) -> np.ndarray:
    """Return the vertices (n, 3) of a mesh from `preparation`, global, mm."""
    scale = made.preparation["scale"]
    return scale * read_original(part).frame.to_global(made.points / scale)


def checked(part):
    """Return a part in an assembly, or raise ValueError."""
    require_kind(part, model.PART, "part")
    if assembly_of(part) is None:
        raise ValueError(f"'{part.Label}' is not in a morph: drag it back into its group.")
    return part


def positive(value, word: str, least: float | None = None) -> float:
    """Return a number above 0, or at least `least`, or raise ValueError."""
    found = number(value, word)
    if found < 0.0 or (found == 0.0 and least is None):
        raise ValueError(f"The {word} is {found}; pass one above 0.")
    return found


def splitting_module():
    """Return the splitting module of the package."""
    kernel.load()
    from sheetmorph.recipe import splitting

    return splitting


def prepared_module():
    """Return the preparation module of the package."""
    kernel.load()
    from sheetmorph.files import prepared_mesh

    return prepared_mesh


def package_mesh(points: np.ndarray, triangles: np.ndarray):
    """Return a sheetmorph.PartMesh with vertex indices as ids."""
    return kernel.load().PartMesh(points, triangles)


def scale_of(part) -> float:
    """Return the scale in the preparation of a part, 1 without one."""
    return json.loads(part.Preparation)["scale"] if part.Preparation else 1.0


def moved_features(features: list[dict], placed, scale: float) -> list[dict]:
    """Return the exact features of a part on its new mesh."""
    lengths = ("radius", "length", "residual")
    return [
        {
            **feature,
            "vertices": placed.find(feature["vertices"])[0].tolist(),
            "center": (scale * np.array(feature["center"])).tolist(),
            **{key: scale * feature[key] for key in lengths if feature.get(key) is not None},
        }
        for feature in features
    ]


def moved_extras(part, placed) -> str | None:
    """Return the extras of the assembly with points on triangles of the new mesh, or None."""
    assembly = assembly_of(part)
    if not assembly.Extras:
        return None
    extras = json.loads(assembly.Extras)
    for entries in extras.get("recipe", {}).values():
        for entry in entries:
            if entry.get("part") == part.Name and "triangle" in entry:
                place = placed.place_on(kernel.core(), entry["triangle"], entry["barycentric"])
                entry["triangle"] = int(place[0])
                entry["barycentric"] = [float(weight) for weight in place[1]]
    return json.dumps(extras)


def exchange(part, original: Kept, made, known: tuple[float, list[dict]]) -> None:
    """Replace the rest mesh of a part; `known` has its scale and its features."""
    scale, features = known
    document, before = part.Document, part.Source
    first = part.Original is None
    origin = conversion.near_origin(made.points)
    source = document.addObject("Mesh::Feature", "Prepared")
    placement = conversion.scaled_placement(original.frame, scale, origin)
    source.Mesh = conversion.MeshWriter(made.triangles).mesh(made.points - origin, placement)
    source.Visibility = False
    with conversion.temporary_folder() as folder:
        if first and part.RestData:
            kept = os.path.join(folder, "original.npz")
            shutil.copyfile(part.RestData, kept)
            part.OriginalData = kept
        stored = os.path.join(folder, "rest.npz")
        write_rest_data(stored, made.with_indices(), origin, features)
        part.RestData = stored
    if first:
        part.Original = before
    part.Source = source
    part.Preparation = json.dumps(made.preparation)
    if not first:
        document.removeObject(before.Name)
    source.Label = f"{part.Label} prepared"
    part.Mesh = conversion.copy_at(source.Mesh, conversion.result_placement(part))
    follow_group(assembly_of(part))
