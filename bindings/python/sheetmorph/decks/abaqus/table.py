# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element types and data fields of Abaqus and CalculiX that SheetMorph reads."""

from __future__ import annotations

import re

# Shell sections, which all have the thickness in the same field.
SECTIONS = ("SHELL SECTION", "SHELL GENERAL SECTION", "MEMBRANE SECTION")
# For each keyword the data line from 0, the first field and the end of the fields, counted between
# commas. Lines of nodes and elements start with the id.
FIELDS: dict[str, dict[str, tuple[int, int, int]]] = {
    "SHELL SECTION": {"thickness": (0, 0, 1)},
    "ELASTIC": {"young": (0, 0, 1), "poisson": (0, 1, 2)},
    "DENSITY": {"density": (0, 0, 1)},
    "INSTANCE": {"shift": (0, 0, 3), "axis": (1, 0, 7)},
    "KINEMATIC COUPLING": {"node": (0, 0, 1)},  # in every line
    "MPC": {"nodes": (0, 1, 16)},  # in every line
    "EQUATION": {"term": (1, 0, 3)},  # node, direction, factor; repeated
}

_EXACT = {
    "MASS": ("mass", 1), "ROTARYI": ("mass", 1), "SPRING1": ("mass", 1), "DASHPOT1": ("mass", 1),
    "DCOUP3D": ("mass", 1), "SPRINGA": ("line", 2), "SPRING2": ("line", 2), "D": ("line", 3),
    "DASHPOTA": ("line", 2), "DASHPOT2": ("line", 2), "GAPUNI": ("line", 2), "GAPCYL": ("line", 2),
    "STRI3": ("shell", 3), "STRI65": ("shell", 6), "DS3": ("shell", 3), "DS4": ("shell", 4),
    "CONN3D2": ("line", 2), "CONN2D2": ("line", 2), "RB3D2": ("line", 2), "ELBOW32": ("line", 3),
    "S8R5": ("shell", 8), "S9R5": ("shell", 9), "DS6": ("shell", 6), "DS8": ("shell", 8),
}  # fmt: skip
_RULES = (
    # Elements of order 2 have three nodes; those of order 1 and 3 have two.
    (re.compile(r"(?:B|PIPE)[23]2\w*|T[23]D3\w*|SAX2\w*"), "line of three"),
    (re.compile(r"(?:S|R3D|M3D|SFM3D)(\d)(?:R|RS|RSW|S|T|RT|R5|RHT)?"), "shell"),
    (re.compile(r"(?:SC|CSS)(\d)\w*"), "solid"),
    (re.compile(r"(?:C3D|DC3D|AC3D|F3D|CCL|COH3D|Q3D|DCC3D)(\d+)\D*"), "solid"),
    (re.compile(r"(?:CPS|CPE|CAX|CGAX|DC2D|DCAX|CPEG|AC2D|CPS\w|CPE\w)(\d)\D*"), "solid"),
    (re.compile(r"(?:B|PIPE|T|DC1D|F)\d?D?[12]?(\d)?\w*"), "line"),
)


def element_type(name: str) -> tuple[str, int]:
    """Return kind and number of nodes; with 0 nodes each line is one element."""
    if name in _EXACT:
        return _EXACT[name]
    for rule, kind in _RULES:
        found = rule.fullmatch(name)
        if found and kind == "line of three":
            return "line", 3
        if found:
            count = int(found.group(1)) if found.group(1) and kind != "line" else 0
            return kind, (2 if kind == "line" else count)
    return "line", 0
