# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of the Nastran cards that SheetMorph reads; all positions are defined here.

A position counts the data fields of a card from 0, after the name, over all lines: eight per line
in small fields, four in large ones.
"""

from __future__ import annotations

FIRST = 8  # column, from 0, of the first field, after the name


def place_of(position: int, width: int) -> tuple[int, int]:
    """Return line and first column, both from 0, of a field of width 8 or 16."""
    line, field = divmod(position, 64 // width)
    return line, FIRST + field * width


# Kind of each element, and positions of its nodes; () if the card determines them.
ELEMENTS: dict[str, tuple[str, tuple[int, ...]]] = {
    **{name: ("shell", (2, 3, 4)) for name in ("CTRIA3", "CTRIAR", "CPLSTN3", "CPLSTS3")},
    **{name: ("shell", (2, 3, 4, 5)) for name in ("CQUAD4", "CQUADR", "CPLSTN4", "CPLSTS4")},
    "CSHEAR": ("shell", (2, 3, 4, 5)),
    **{name: ("shell", tuple(range(2, 8))) for name in ("CTRIA6", "CPLSTN6", "CPLSTS6")},
    **{name: ("shell", tuple(range(2, 10))) for name in ("CQUAD8", "CPLSTN8", "CPLSTS8")},
    "CQUAD": ("shell", tuple(range(2, 11))),
    "CHEXA": ("solid", tuple(range(2, 22))),
    "CPENTA": ("solid", tuple(range(2, 17))),
    "CPYRAM": ("solid", tuple(range(2, 15))),
    "CTETRA": ("solid", tuple(range(2, 12))),
    **{name: ("line", (2, 3)) for name in ("CBAR", "CBEAM", "CBEND", "CROD", "CTUBE", "CVISC")},
    **{name: ("line", (2, 3)) for name in ("CBUSH", "CBUSH1D", "CGAP", "CELAS3", "CDAMP3")},
    **{name: ("line", (2, 3)) for name in ("CDAMP4", "CELAS4", "CMASS3")},
    **{name: ("line", (2, 4)) for name in ("CELAS1", "CELAS2", "CDAMP1", "CDAMP2")},
    "CBEAM3": ("line", (2, 3, 4)),
    "CONROD": ("line", (1, 2)),
    "PLOTEL": ("line", (1, 2)),
    "CMASS1": ("mass", (2, 4)),
    "CMASS2": ("mass", (2, 4)),
    "CONM1": ("mass", (1,)),
    "CONM2": ("mass", (1,)),
    "RBAR": ("rigid", (1, 2)),
    "RROD": ("rigid", (1, 2)),
    "RTRPLT": ("rigid", (1, 2, 3)),
    **{name: ("rigid", ()) for name in ("RBE1", "RBE2")},
    **{name: ("constraint", ()) for name in ("RBE3", "MPC")},
    **{name: ("weld", ()) for name in ("CWELD", "CFAST", "CSEAM")},
    **{f"CORD1{kind}": ("frame", (1, 2, 3)) for kind in "RCS"},
}
# Elements that need all their corners.
CORNERS = {
    "CQUAD4": 4, "CQUADR": 4, "CQUAD8": 4, "CQUAD": 4, "CSHEAR": 4, "CTETRA": 4, "CPYRAM": 5,
    "CPENTA": 6, "CHEXA": 8, "RBAR": 2, "CBAR": 2, "CBEAM": 2, "CROD": 2, "PLOTEL": 2,
}  # fmt: skip
# Fields with coordinates of weld points without a node.
WELD_POINTS = {
    "CWELD": ((16, 17, 18),),
    "CFAST": ((8, 9, 10),),
    "CSEAM": ((16, 17, 18), (19, 20, 21)),
}
# Fields of other cards, and of those with variable layout.
GRID = {"id": 0, "system": 1, "point": 2}  # the last one is the first of three
CARDS: dict[str, dict[str, tuple[int, ...]]] = {
    "GRDSET": {"system": (1,)},
    "PSHELL": {"id": (0,), "material": (1,), "thickness": (2,)},
    "MAT1": {"id": (0,), "young": (1,), "shear": (2,), "poisson": (3,), "density": (4,)},
    "CORD1": {"id": (0, 4), "nodes": (1, 2, 3)},  # two systems per card
    "CORD2": {"id": (0,), "system": (1,), "points": tuple(range(2, 11))},
    "SET1": {"id": (0,), "members": (1,)},  # and following
    "SET3": {"id": (0,), "kind": (1,), "members": (2,)},
    "RBE2": {"id": (0,), "main": (1,), "nodes": (3,)},
    "RBE3": {"id": (0,), "main": (2,), "nodes": (4,)},
    "RBE1": {"id": (0,), "nodes": (1,)},
    "MPC": {"id": (0,), "nodes": (1, 4)},  # repeated in every further line
    "CWELD": {
        # Some programs write the kind one field further.
        "kind": (3, 4), "point": (2,), "grids": (2, 4, 5), "patches": tuple(range(8, 24)),
    },
    "CFAST": {"kind": (2,), "point": (5,), "grids": (5, 6, 7)},
    "CSEAM": {"kind": (3,), "point": (8,), "grids": (8, 9)},
}  # fmt: skip
