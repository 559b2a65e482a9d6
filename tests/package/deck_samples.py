# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small decks in every format, with what makes each of them awkward."""

from __future__ import annotations

import struct

NASTRAN = b"""SOL 101
CEND
BEGIN BULK
$ a system by nodes, one by points in it, nodes in both
CORD1R  5       1       2       3
CORD2C*                6               5              0.              0.*
*                     0.              0.              0.             10.*
*                     1.              0.              0.
GRID    1               0.      0.      0.
GRID    2               0.      0.      1.
GRID    3               1.      0.      0.
GRID    4       5       0.      1.      0.$ a comment
GRID    5       6       2.      90.     1.
GRID,6,,2.0,1.0
GRID*                  7                           1.500             1.0+*A
*A                  .25
grid\t8\t\t2.5\t1.5\t0.5
CQUAD4  1       1       1       3       6       4
CTRIA3,2,1,3,6,7
+ this line is the end of it
CTRIA6  3       1       1       3       7       4       6       5
RBE2    9       8       123     1       3
RBE3    10              8       123     1.      123     1       3       +
+       4       6
CONM2   11      8               1.5
CFAST   12      1       PROP    1       1
        1.      .5      0.
ENDDATA
"""
DYNA = b"""*KEYWORD
*PARAMETER
R  depth     2.5
$ a comment
*NODE
$#   nid               x               y               z      tc      rc
       1             0.0             0.0             0.0       0       0
       2-1234567.8901234             0.0
       3,1.0,1.0,0.5
       4             0.0             1.0          &depth
*NODE %
         51.0000000000000002.0000000000000003.000000000000000
*NODE+
                   6                 1.0                 2.0                 3.0
*AIRBAG_REFERENCE_GEOMETRY
       1             0.0             0.0             9.0
*ELEMENT_SHELL_THICKNESS
       1       7       1       2       3       4
             1.5             1.5             1.5             1.5
*ELEMENT_SHELL
       2       7       1       2       3       3
*ELEMENT_SOLID
       3       8
       1       2       3       4       5       6       6       6       0       0
*SET_NODE_LIST_TITLE
a set
         4
         1         2
*CONSTRAINED_NODAL_RIGID_BODY
         9         0         4
*CONSTRAINED_SPOTWELD
         5         6
*PART
a part
         7         3         1
*SECTION_SHELL
         3         2
       1.2
*DEFINE_COORDINATE_SYSTEM
         1       0.0       0.0       0.0       1.0       0.0       0.0
       0.0       1.0       0.0
*END
"""
ABAQUS = b"""** in two parts
*Part, name=plate
*Node, nset=all
 1,  0.0, 0.0
 2, 10., 0., 0.
 3, 10., 10. , 1.5e0
 4,,5.
*System
 0., 0., 100., 0., 1., 100.
*Node
 5, 1., 0., 0.
*Element, type=S4R,
 elset=skin
 1, 1, 2,
 3, 4
*Shell Section, elset=skin, material=steel
 1.25, 5
*End Part
*Assembly, name=a
*Instance, name=one, part=plate
 10., 0., 0.
 0., 0., 0., 0., 0., 1., 90.
*End Instance
*End Assembly
*Orientation, name=o
 1., 0., 0., 0., 1., 0.
"""
CALCULIX = b"""*NODE,NSET=N
1,0,0,0
2,1,0,0
3,1,1,0
2,1.5,0,0
*ELEMENT,TYPE=S3,ELSET=E
1,1,2,3
*NGEN
1,3,1
*RIGID BODY,NSET=N,REF NODE=3
*MPC
BEAM,1,2
*EQUATION
2
1,1,1.,2,1,-1.
"""
RADIOSS = b"""#RADIOSS STARTER
/BEGIN
plate
      2022         0
/NODE
#       id                   x                   y                   z
         1                   0                   0                   0
         2                  10                   0-1.23456789012345678
         3                  10                  10
         4                   0                  10                   0
/SHELL/5
         1         1         2         3         4                                         0
/SH3N/6
         2         1         2         3
/PART/5
a part
         7         1
/PROP/SHELL/7
a property
         1
#
                   0
         0         0                 1.3
/SPRING/8
         9         1         3
/GRNOD/NODE/4
nodes
         1         2
/RBODY/1
body
         3         0         0         0                   0         4
/SKEW/FIX/2
skew
                   0                   0                   0
/END
"""
GMSH = b"""$MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
4
1 0 0 0
2 1 0 0
7 1 1 0.10000000000000001
9 0 1 0
$EndNodes
$Elements
3
1 15 2 0 1 1
2 3 2 5 1 1 2 7 9
3 2 2 5 2 1 2 7
$EndElements
"""
GMSH_4 = b"""$MeshFormat
4.1 0 8
$EndMeshFormat
$Entities
0 0 0 0
$EndEntities
$Nodes
2 4 1 9
0 1 0 1
1
0 0 0
2 1 1 3
2
7
9
1 0 0 0.5 0.5
1 1 0 0.1 0.2
0 1 0 0.3 0.4
$EndNodes
$Elements
1 1 1 1
2 1 3 1
1 1 2 7 9
$EndElements
"""


def binary_gmsh() -> bytes:
    """The mesh of GMSH in binary, version 2.2."""
    nodes = [(1, 0, 0, 0), (2, 1, 0, 0), (7, 1, 1, 0.1), (9, 0, 1, 0)]
    body = b"".join(struct.pack("<i3d", *node) for node in nodes)
    elements = struct.pack("<3i", 3, 1, 2) + struct.pack("<7i", 2, 5, 1, 1, 2, 7, 9)
    return (
        b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Nodes\n4\n" + body
        + b"\n$EndNodes\n$Elements\n1\n" + elements + b"\n$EndElements\n"
    )  # fmt: skip


def deck_samples() -> dict[str, bytes]:
    """File name -> content."""
    plain = {
        "deck.bdf": NASTRAN,
        "deck.k": DYNA,
        "deck.inp": ABAQUS,
        "ccx.inp": CALCULIX,
        "deck_0000.rad": RADIOSS,
        "two.msh": GMSH,
        "four.msh": GMSH_4,
    }
    crlf = {f"crlf_{name}": data.replace(b"\n", b"\r\n") for name, data in plain.items()}
    return {**plain, **crlf, "binary.msh": binary_gmsh()}
