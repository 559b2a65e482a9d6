# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small part files made in code, one of each kind a reader has to take."""

from __future__ import annotations

import struct

import numpy as np

OBJ = b"""# a comment, C:\\parts\\
mtllib sheet.mtl
o cover
v 0 0 0
v 1.50 0.0 0 # behind a vertex
v  1.5   1   0.25   1.0
v 0 1e0 0 0.5 0.5 0.5
v -1 0 0
vt 0 0
vt 1 1
vn 0 0 1
g top bottom
usemtl steel
s off
f 1 2 3 4
f 1//1 4//1 \\
 5//1
f -5/1/1 -2/2/1 -1/1/1
l 1 2
"""
OFF = b"""OFF # cube corner
# counts
5 3 0

0 0 0
1.50 0.0 0   255 0 0
1.5 1 0.25
0 1e0 0
-1 0 0
4 0 1 2 3  0.1 0.2 0.3
3 0 3 4
3 4 3 0
"""
COFF = b"""COFF 3 1 0
0 0 0 1 0 0 1
2 0 0 0 1 0 1
0 2 0.5 0 0 1 1
3 0 1 2
"""
PLY = b"""ply
format ascii 1.0
comment made in code
obj_info nothing
element vertex 4
property float x
property float y
property float z
property uchar red
element face 2
property uchar flags
property list uchar int vertex_indices
element edge 1
property int vertex1
property int vertex2
end_header
0 0 0 255
1.50 0.0 0 0
1.5 1 0.25 7
0 1e0 0 9
0 3 0 1 2
1 3 0 2 3
0 1
"""
STL = b"""solid two facets
  facet normal 0 0 1
    outer loop
      vertex 0 0 0
      vertex 1.50 0.0 0
      vertex 1.5 1 0
    endloop
  endfacet
  facet normal 0 0 1
    outer loop
      vertex 0 0 -0.0
      vertex 1.5 1 0
      vertex 0 1e0 0
    endloop
  endfacet
endsolid two facets
"""
NASTRAN = b"""SOL 101
CEND
TITLE = a plate
BEGIN BULK
$ nodes
GRID     10             0.      0.      0.
GRID     20      0      1.5     0.0     .0$ a comment
GRID    30              1.50    1.+0    2.5-1   0
GRID*   40                              0.0             1.0             *G40
*G40    0.0
GRID,50,,-1.0,0.,0.
GRID     99             7.      7.      7.
CQUAD4  1       1       10      20      30      40
CTRIA3  2       1       10      40      50
CTRIA3* 3               1               50              40
*       10
CBUSH   7       9       10      99
PSHELL  1       1       1.2     1
ENDDATA
GRID behind the end is not read
"""


def vtk(is_binary: bool = False) -> bytes:
    """A legacy VTK file with a triangle and a quad, text or binary, double."""
    points = [[0, 0, 0], [1.5, 0, 0], [1.5, 1, 0.25], [0, 1, 0], [-1, 0, 0]]
    kind = b"BINARY" if is_binary else b"ASCII"
    head = b"# vtk DataFile Version 4.2\nmade in code\n" + kind + b"\nDATASET UNSTRUCTURED_GRID\n"
    cells, types = [3, 0, 3, 4, 4, 0, 1, 2, 3], [5, 9]

    def block(numbers: list, code: str) -> bytes:
        if is_binary:
            return struct.pack(f">{len(numbers)}{code}", *numbers) + b"\n"
        return " ".join(map(str, numbers)).encode() + b"\n"

    flat = [float(x) for point in points for x in point]
    return b"".join(
        (
            head,
            b"POINTS 5 double\n" + block(flat, "d"),
            b"CELLS 2 9\n" + block(cells, "i"),
            b"CELL_TYPES 2\n" + block(types, "i"),
        )
    )


def binary_ply(order: str, kind: str = "f4") -> bytes:
    """A binary PLY: order "<" or ">", coordinates of a numpy kind; mixed polygons, extra data."""
    name = {"<": "little", ">": "big"}[order]
    number = {"f4": "float", "f8": "double"}[kind]
    head = f"ply\nformat binary_{name}_endian 1.0\ncomment made in code\nelement vertex 5\n"
    head += "".join(f"property {number} {axis}\n" for axis in "xyz")
    head += "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\n"
    head += "property ushort flags\nend_header\n"
    record = np.dtype([(c, order + kind) for c in "xyz"] + [("red", "u1")])
    rows = [(0, 0, 0, 1), (1.5, 0, 0, 2), (1.5, 1, 0.1, 3), (0, 1, 0, 4), (-1, 0, 0, 5)]
    faces = struct.pack(f"{order}B4iHB3iH", 4, 0, 1, 2, 3, 7, 3, 0, 3, 4, 9)
    return head.encode() + np.array(rows, dtype=record).tobytes() + faces


def binary_stl() -> bytes:
    """A binary STL of three facets whose header begins like a text one."""
    facets = [
        [(0, 0, 0), (1.5, 0, 0), (1.5, 1, 0.1)],
        [(0, 0, 0), (1.5, 1, 0.1), (0, 1, 0)],
        [(0, 0, -0.0), (0, 1, 0), (-1, 0, 0)],
    ]
    record = struct.Struct("<12fH")
    body = [record.pack(0, 0, 1, *(c for p in facet for c in p), 77) for facet in facets]
    return b"solid but binary".ljust(80) + struct.pack("<I", len(facets)) + b"".join(body)


def samples() -> dict[str, bytes]:
    """File name -> content: what every reader must take."""
    return {
        "part.obj": OBJ,
        "crlf.obj": OBJ.replace(b"\n", b"\r\n"),
        "part.off": OFF,
        "crlf.off": OFF.replace(b"\n", b"\r\n"),
        "coloured.off": COFF,
        "part.ply": PLY,
        "crlf.ply": PLY.replace(b"\n", b"\r\n"),
        "little.ply": binary_ply("<"),
        "big.ply": binary_ply(">", "f8"),
        "part.stl": STL,
        "crlf.stl": STL.replace(b"\n", b"\r\n"),
        "binary.stl": binary_stl(),
        "deck.nas": NASTRAN,
        "crlf.bdf": NASTRAN.replace(b"\n", b"\r\n"),
        "part.vtk": vtk(),
        "binary.vtk": vtk(is_binary=True),
    }


def moved(points: np.ndarray, seed: int = 7) -> np.ndarray:
    """(n, 3) positions near `points`, all of them different from rest."""
    return points + np.random.default_rng(seed).uniform(0.1, 1.0, points.shape)
