# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element types of Abaqus and CalculiX: what they are and how many nodes they have."""

from __future__ import annotations

import re

_EXACT = {
    "MASS": ("mass", 1), "ROTARYI": ("mass", 1), "SPRING1": ("mass", 1), "DASHPOT1": ("mass", 1),
    "DCOUP3D": ("mass", 1), "SPRINGA": ("line", 2), "SPRING2": ("line", 2), "D": ("line", 3),
    "DASHPOTA": ("line", 2), "DASHPOT2": ("line", 2), "GAPUNI": ("line", 2), "GAPCYL": ("line", 2),
    "STRI3": ("shell", 3), "STRI65": ("shell", 6), "DS3": ("shell", 3), "DS4": ("shell", 4),
    "CONN3D2": ("line", 2), "CONN2D2": ("line", 2), "RB3D2": ("line", 2), "B32": ("line", 3),
    "B32R": ("line", 3), "B32OS": ("line", 3), "T3D3": ("line", 3), "PIPE32": ("line", 3),
    "ELBOW32": ("line", 3), "B33": ("line", 2), "S8R5": ("shell", 8), "S9R5": ("shell", 9),
    "DS6": ("shell", 6), "DS8": ("shell", 8),
}  # fmt: skip
_RULES = (
    (re.compile(r"(?:S|R3D|M3D|SFM3D)(\d)(?:R|RS|RSW|S|T|RT|R5|RHT)?"), "shell"),
    (re.compile(r"(?:SC|CSS)(\d)\w*"), "solid"),
    (re.compile(r"(?:C3D|DC3D|AC3D|F3D|CCL|COH3D|Q3D|DCC3D)(\d+)\D*"), "solid"),
    (re.compile(r"(?:CPS|CPE|CAX|CGAX|DC2D|DCAX|CPEG|AC2D|CPS\w|CPE\w)(\d)\D*"), "solid"),
    (re.compile(r"(?:B|PIPE|T|DC1D|F)\d?D?[12]?(\d)?\w*"), "line"),
)


def element_type(name: str) -> tuple[str, int]:
    """Kind, and number of nodes, 0 if it is not known: then each line is one element."""
    if name in _EXACT:
        return _EXACT[name]
    for rule, kind in _RULES:
        found = rule.fullmatch(name)
        if found:
            count = int(found.group(1)) if found.group(1) and kind != "line" else 0
            return kind, (2 if kind == "line" else count)
    return "line", 0
