# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report entries on written CAD files, and their failures."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Any


from ..base.arrays import Floats
from ..base.errors import list_ids
from ..base.part_mesh import PartMesh
from ..base.words import folds
from ..files.cad_writing import CadWriting
from ..measuring.crossings import crossings

# Smallest kink to report, degrees; admissible radius error of a kept cylinder, mm.
KINK, RADIUS = 0.1, 1e-9
# Admissible deviation of a shape's thickness beyond that of its mesh, as a share of the thickness.
THINNER = 0.01


@dataclass(frozen=True)
class WrittenShapes:
    """The shapes of one part in a written CAD file.

    bodies is the result of write_shapes(). bytes_read and bytes_written are the sizes of the source
    file and of this file.
    """

    file: str
    bodies: list[dict[str, Any]]
    bytes_read: int
    bytes_written: int

    def of_part(self, name: str) -> WrittenShapes:
        """Return the shapes of a part; in a split file this is one body."""
        own = [body for body in self.bodies if name.endswith(f"/{body['name']}")]
        is_split = len(own) == 1 and name.partition("/")[2] == own[0]["name"]
        return replace(self, bodies=own) if is_split else self


# Measures the thickness on the points of a part's mesh; None if the part is not thin.
Thickness = Callable[[Floats], dict[str, Any] | None]


def shape_report(
    writing: CadWriting,
    crossed: tuple[int, int],
    shapes: WrittenShapes | None,
    thickness: Thickness,
) -> dict[str, Any]:
    """Return the report entry "shape" of a part.

    crossed counts the intersecting pairs of triangles at rest and deformed. shapes is None before
    the file is written. thickness measures the part.
    """
    read = [] if shapes is None else shapes.bodies
    return {
        "format": writing.format,
        "tolerance": writing.tolerance,
        "edge_tolerance": writing.edge_tolerance,
        "self_intersections": dict(zip(("rest", "deformed"), crossed)),
        "file": None if shapes is None else shapes.file,
        "bytes": None if shapes is None else shapes.bytes_written,
        "bytes_before": None if shapes is None else shapes.bytes_read,
        "bodies": [
            {**_body(body), "thickness": thickness(body["points"]) if len(read) == 1 else None}
            for body in read
        ],
    }


def shape_failures(part: str, shape: dict[str, Any], flipped: int) -> Iterator[str]:
    """Yield a sentence for every requirement of the recipe that the shape misses.

    flipped is the number of folded triangles in the mesh.
    """
    crossed = shape["self_intersections"]
    what = _fold(flipped, crossed["rest"], crossed["deformed"])
    if what:
        yield (
            f'"{part}" cannot be written as {shape["format"].upper()}: its mesh '
            f"folds ({what}), so its faces would fold too; turn it less, or mesh it "
            "finer"
        )
        return
    for body in shape["bodies"]:
        lead = f'the {shape["format"].upper()} of "{part}"'
        if body["name"] != part:
            lead += f', "{body["name"]}"'
        yield from (f"{lead}: {text}" for text in _body_failures(body, shape))


def fold_of(core: Any, mesh: PartMesh, positions: Floats) -> str:
    """Describe how a mesh folds at positions (n, 3); return "" if it does not."""
    flipped = int(core.compare_quality(mesh.points, positions, mesh.triangles).flipped)
    rest, deformed = (len(crossings(points, mesh.triangles)) for points in (mesh.points, positions))
    return _fold(flipped, rest, deformed)


def _fold(flipped: int, rest: int, deformed: int) -> str:
    if flipped:
        return folds(flipped)
    return "it penetrates itself" if deformed > rest else ""


def kink_notes(part: str, shape: dict[str, Any]) -> Iterator[str]:
    """Yield sentences about new kinks in smooth faces."""
    for body in shape["bodies"]:
        kink = body["kink"]
        if kink["value"] > KINK:
            yield (
                f'the {shape["format"].upper()} of "{part}" has a kink of {kink["value"]:.2g} '
                f"degrees at {_place(kink)} on face {kink['face']} of \"{body['name']}\", where "
                "it was smooth: give a smaller write_edge_tolerance, or mesh it finer there"
            )


def body_faults(body: dict[str, Any], writing: CadWriting = CadWriting("brep")) -> list[str]:
    """Return a sentence for every fault of one body from write_shapes()."""
    told = {"tolerance": writing.tolerance, "edge_tolerance": writing.edge_tolerance}
    return list(_body_failures(_body(body), told))


def _body_failures(body: dict[str, Any], shape: dict[str, Any]) -> Iterator[str]:
    if body["far_faces"]:
        far, faces = body["distance"], _faces(body["far_faces"])
        yield (
            f"{faces} {_are(body['far_faces'])} up to {far['value']:.2g} mm from the deformed "
            f"mesh, at {_place(far)} (allowed {shape['tolerance']:.3g} mm); mesh the part finer, "
            "or give a larger write_tolerance"
        )
    if body["gap"]["value"] > shape["edge_tolerance"]:
        yield (
            f"face {body['gap']['face']} is {body['gap']['value']:.2g} mm from an edge (allowed "
            f"{shape['edge_tolerance']:.3g} mm); mesh the part finer, or give a larger "
            "write_edge_tolerance"
        )
    if not body["was_valid"]:
        why = "; ".join(body["faults_before"])
        yield (
            f"it was not a valid shape before the deformation ({why}); repair it in "
            "the CAD system"
        )
    elif not body["is_valid"]:
        named = f", {_faces(body['invalid_faces'])}" if body["invalid_faces"] else ""
        yield f"it is not a valid shape{named}; mesh the part finer, or turn it less"
    if body["was_closed"] and not body["is_closed"]:
        yield "it is no longer closed; mesh the part finer, or turn it less"
    thin = body.get("thickness")
    if thin and thin["largest_change"] - thin["in_mesh"] > THINNER * thin["thickness"]:
        yield (
            f"its skins are {thin['least']:.4g} to {thin['most']:.4g} mm apart, more than a "
            f"hundredth of {thin['thickness']:.4g} mm further from one thickness than its mesh; "
            "give a smaller write_tolerance, or mesh the part finer"
        )
    changed = [one for one in body["cylinders"] if not one["error"] <= RADIUS]
    if changed:
        worst = max(changed, key=lambda one: float(one["error"]))
        yield (
            f"the cylinder of face {worst['face']} has a radius of "
            f"{worst['after']:.12g} mm and not {worst['wanted']:.12g} mm; mark it "
            "as a form feature"
        )


def _body(body: dict[str, Any]) -> dict[str, Any]:
    cylinders = [
        {"face": face, "before": before, "wanted": wanted, "after": after,
         "error": abs(after - wanted)}
        for face, before, wanted, after in body["cylinders"]
    ]  # fmt: skip
    places = {key: _worst(body[key]) for key in ("distance", "gap", "kink")}
    fitted = list(body["fitted_faces"])
    rest = {key: value for key, value in body.items() if key not in ("fitted_faces", "points")}
    return {**rest, **places, "fitted": len(fitted), "fitted_faces": fitted, "cylinders": cylinders}


def _worst(entry: dict[str, Any]) -> dict[str, Any]:
    return {**entry, "place": [float(x) for x in entry["place"]]}


def _place(worst: dict[str, Any]) -> str:
    return "({})".format(", ".join(f"{x:.6g}" for x in worst["place"]))


def _faces(faces: list[int]) -> str:
    return f"{'face' if len(faces) == 1 else 'faces'} {list_ids(faces)}"


def _are(faces: list[int]) -> str:
    return "is" if len(faces) == 1 else "are"
