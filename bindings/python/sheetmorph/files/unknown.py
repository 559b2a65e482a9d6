# SPDX-License-Identifier: LGPL-2.1-or-later
"""Unsupported formats, and advice on how to convert them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ..base.errors import FileError

_CAD = (
    *(".3dm", ".asm", ".catpart", ".catproduct", ".dgn", ".f3d", ".f3z", ".iam", ".ipt", ".jt"),
    *(".model", ".par", ".prt", ".psm", ".sab", ".sat", ".scad", ".skp", ".sldasm", ".sldprt"),
    *(".x_b", ".x_t"),
)
_MESHES = (
    *(".3ds", ".3mf", ".amf", ".blend", ".ctm", ".dae", ".fbx", ".glb", ".gltf", ".iv", ".lwo"),
    *(".pcd", ".usd", ".usdz", ".wrl", ".x3d", ".xyz"),
)
_DECKS = (*(".ans", ".cas", ".cdb", ".e", ".exo", ".op2", ".unv", ".xdmf"),)
_PACKED = (".7z", ".bz2", ".rar", ".tar", ".tgz", ".xz", ".zip", ".zst")
_DRAWINGS = (".dwg", ".dxf", ".pdf", ".svg")

_WAYS = (
    ((".fcstd", ".fcstd1"), "a document of FreeCAD", "open it in FreeCAD and export STEP"),
    (_CAD, "a file of a CAD program", "open it there and export STEP"),
    (_MESHES, "a mesh of another kind", "convert it to PLY or STL, with MeshLab or Blender"),
    (
        _DECKS,
        "a deck or result of another solver",
        "write Nastran bulk data from its pre-processor, or try `meshio convert FILE part.vtu`",
    ),
    (
        (".med", ".rmed", ".mmed"),
        "a MED file, which SheetMorph cannot write back unchanged",
        "convert it to a Gmsh mesh: `gmsh -0 -format msh22 -o part.msh FILE`",
    ),
    (_PACKED, "an archive", "unpack it first; of packed files only .gz is read"),
    (_DRAWINGS, "a drawing", "make a solid or a sheet from it in CAD and export STEP"),
)


def unknown_format(path: Path, known: Sequence[str]) -> FileError:
    """Return the error for a file that SheetMorph cannot read."""
    if path.is_dir():
        return FileError(path, "it is a folder", "give a file in it")
    suffix = Path(path.stem).suffix if path.suffix.lower() == ".gz" else path.suffix
    for suffixes, what, todo in _WAYS:
        if suffix.lower() in suffixes:
            return FileError(path, f'unknown format "{suffix}", {what}', todo)
    todo = f"use one of {', '.join(known)}; each can be packed as .gz"
    return FileError(path, f'unknown format "{suffix}"', todo)
