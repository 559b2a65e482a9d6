# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `find`: its arguments and its output."""

from __future__ import annotations

import argparse
import json
from pathlib import Path
from typing import Any

from .errors import Fault, RecipeError
from .files.atomic import FileSet
from .words import counted

# Command-line option, name in FindOptions, type, help.
_NUMBERS = (
    ("--gap", "gap", float, "largest distance of parts in contact, mm (default: proposed)"),
    ("--rings", "rings", int, "rings of vertices around a hole (default: 1)"),
    ("--smallest-radius", "smallest_radius", float, "of holes, mm"),
    ("--largest-radius", "largest_radius", float, "of holes, mm"),
    (
        "--roundness",
        "roundness",
        float,
        "roundness tolerance of a rim, over its radius (default: 0.12)",
    ),
    (
        "--surface",
        "surface",
        float,
        "tolerance of a curved surface, over its radius (default: 0.01)",
    ),
    ("--plane-angle", "plane_angle", float, "largest bend inside a plane, degrees (default: 6)"),
    (
        "--smallest-area",
        "smallest_area",
        float,
        "smallest area of a surface, over the area of its part (default: 0.004)",
    ),
    (
        "--crease-angle",
        "crease_angle",
        float,
        "edge angle: a sharper bend is an edge, degrees (default: 35)",
    ),
    (
        "--scatter",
        "scatter",
        float,
        "standard deviation of measured vertices, mm (default: estimated)",
    ),
    (
        "--facing-angle",
        "facing_angle",
        float,
        "largest angle between surfaces in contact, degrees (default: 35)",
    ),
)
# Mesh sizes for CAD files, as in the key `mesh` of a recipe.
_SIZES = (
    ("--edge", "edge", "maximum edge length for meshing CAD files, mm"),
    ("--deflection", "deflection", "maximum deviation of these meshes from the CAD surfaces, mm"),
    ("--angle", "angle", "maximum bend of these meshes from edge to edge, degrees"),
)


def add_find_arguments(commands: Any) -> None:
    """Add `find` to the commands of a parser."""
    find = commands.add_parser("find", help="print the features and contacts of mesh files as JSON")
    find.add_argument("files", nargs="+", metavar="FILE", help="mesh files of one assembly")
    ways = ("auto", "components", "property", "none")
    find.add_argument(
        "--split", choices=ways, default="auto", help="how to split a file into parts"
    )
    find.add_argument(
        "--kind",
        action="append",
        metavar="KIND",
        help="find this kind of feature only (hole: all holes); can be repeated",
    )
    find.add_argument("--one-per-pair", action="store_true", help="one contact per pair of parts")
    for option, name, kind, text in _NUMBERS:
        find.add_argument(option, dest=name, type=kind, metavar="N", help=text)
    for option, name, text in _SIZES:
        find.add_argument(option, dest=name, type=float, metavar="N", help=text)
    find.add_argument("-o", "--output", metavar="FILE", help="write to FILE instead of printing")


def run_find(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Find features and contacts, and write the JSON or return it. Raises RecipeError."""
    # Imported here, so that --help answers at once.
    from .finding import FindOptions, find_in_files

    given = {name: getattr(wanted, name) for _, name, _, _ in _NUMBERS}
    values = {name: value for name, value in given.items() if value is not None}
    options = FindOptions(one_per_pair=wanted.one_per_pair).changed(values)
    if wanted.kind:
        options = options.changed({"kinds": _known_kinds(wanted.kind)})
    sizes = {name: getattr(wanted, name) for _, name, _ in _SIZES}
    sizes = {name: size for name, size in sizes.items() if size is not None}
    found = find_in_files(wanted.files, _checked(options), wanted.split, sizes)
    text = one_line_each(found)
    if wanted.output is None:
        return [text]
    path = write_text(wanted, text + "\n", files)
    features = counted(len(found["features"]), "feature", "features")
    return [f"{path}: {features}, {counted(len(found['contacts']), 'contact', 'contacts')}"]


def write_text(wanted: argparse.Namespace, text: str, files: FileSet) -> Path:
    """Write a text to the file of `-o` and return its path. Raises FileError."""
    path = Path(wanted.output)
    files.reads += [Path(file) for file in wanted.files]
    with files:
        files.temporary_for(path).write_text(text, "utf-8")
        files.commit()
    return path


def _known_kinds(kinds: list[str]) -> list[str]:
    from .finding.options import HOLES, KINDS, ODD_HOLE

    unknown = [kind for kind in kinds if kind not in (*KINDS, ODD_HOLE)]
    if unknown:
        known = f"use one of {', '.join((*KINDS, ODD_HOLE))}"
        raise RecipeError([Fault("--kind", f'there is no kind "{unknown[0]}"', known)])
    meanings = {"hole": HOLES, ODD_HOLE: ("hole",)}
    return [one for kind in kinds for one in meanings.get(kind, (kind,))]


def _checked(options: Any) -> Any:
    """Return the options. Raises RecipeError if the kernel refuses one."""
    faults = options.faults()
    if faults:
        raise RecipeError([Fault("find", what, todo) for what, todo in faults])
    return options


def one_line_each(found: dict[str, Any]) -> str:
    """Return JSON with one line for every feature and contact, for readability."""
    lines = []
    for key, value in found.items():
        rows = [json.dumps(row, ensure_ascii=False, allow_nan=False) for row in as_list(value)]
        if rows:
            lines.append(f"  {json.dumps(key)}: [\n    " + ",\n    ".join(rows) + "\n  ]")
        else:
            lines.append(f"  {json.dumps(key)}: {json.dumps(value, allow_nan=False)}")
    return "{\n" + ",\n".join(lines) + "\n}"


def as_list(value: Any) -> list[Any]:
    """Return a non-empty list of objects as it is, and an empty list for any other value."""
    return value if isinstance(value, list) and value and isinstance(value[0], dict) else []
