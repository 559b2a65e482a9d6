# SPDX-License-Identifier: LGPL-2.1-or-later
"""Detection of a deck's format from its content, for files with a wrong suffix."""

from __future__ import annotations

import re
from pathlib import Path

from ..base.errors import FileError

# For each format its usual name, a file suffix, and lines that no other format has.
_FLAGS = re.IGNORECASE | re.MULTILINE
_FORMS = {
    "Nastran": (
        "Nastran bulk data",
        ".bdf",
        rb"^[ \t]*(?:BEGIN[ \t]+(?:BULK|SUPER|AUXMODEL|=)|BEGIN[ \t]*$|ENDDATA\b|CEND\b"
        rb"|INCLUDE[ \t]*['\"=]|INCLUDE[ \t]+\S+[ \t]*$|SOL[ \t]+\d)|^(?:GRID|CORD[12][RCS]|GRDSET"
        rb"|C(?:QUAD|TRIA|HEXA|TETRA|PENTA|BAR|BEAM|ROD|BUSH|ELAS[1-4]|ONM2|WELD|FAST)"
        rb"\w{0,2}|RBE[123]|RBAR|PSHELL|PSOLID|PARAM|MAT1|SPC1?|FORCE|MPC)"
        rb"(?:\*?[ \t]|\*?,|\*?[ \d]\d)",
    ),
    "LS-DYNA": (
        "an LS-DYNA keyword file",
        ".k",
        rb"^\*[ \t]*(?:KEYWORD|END[ \t\r]*$|(?:ELEMENT|SECTION|CONTROL|DATABASE|MAT|DEFINE|SET|LOAD"
        rb"|CONSTRAINED|BOUNDARY|CONTACT|INITIAL|INCLUDE|PARAMETER|PART|NODE|RIGIDWALL)_\w"
        rb"|(?:NODE|PART|INCLUDE)[ \t]*[%+-]?[ \t]*\r?$"
        rb"(?!(?:\r?\n\*\*[^\n]*)*\r?\n[ \t]*\d+[ \t]*,))",
    ),
    "Abaqus": (
        "an input file of Abaqus or CalculiX",
        ".inp",
        rb"^[ \t]*\*[ \t]*(?:HEADING|(?:NODE|ELEMENT|NSET|ELSET|INCLUDE|PART|INSTANCE|ASSEMBLY"
        rb"|MATERIAL|STEP|SOLID SECTION|SHELL SECTION|BEAM SECTION|SURFACE)[ \t]*,"
        rb"|END STEP|STATIC|ELASTIC|DENSITY|BOUNDARY|CLOAD|DLOAD|STEP|EL PRINT|NODE PRINT|NODE FILE"
        rb"|NODE[ \t]*\r?$(?:\r?\n\*\*[^\n]*)*\r?\n[ \t]*\d+[ \t]*,)",
    ),
    "Radioss": (
        "a Radioss starter file",
        "_0000.rad",
        rb"^(?:#RADIOSS|/BEGIN\b|/(?:NODE|END)[ \t]*\r?$"
        rb"|/(?:SHELL|SH3N|BRICK|PART|PROP|MAT|GRNOD)/)",
    ),
    "Gmsh": ("a mesh of Gmsh", ".msh", rb"^\$MeshFormat\b"),
}
_CHECKED = 1 << 20


def require_form(path: Path, data: bytes, form: str) -> None:
    """Check that a file can have the format of its suffix.

    Raises FileError if it has no line of that format but lines of another one.
    """
    own = re.compile(_FORMS[form][2], _FLAGS)
    if not data.strip() or own.search(data[:_CHECKED]) or own.search(data):
        return
    for other, (called, ending, pattern) in _FORMS.items():
        if other != form and re.search(pattern, data, _FLAGS):
            what = f"this is {called}, but its name says {_FORMS[form][0]}"
            raise FileError(path, what, f'give it the ending "{ending}"')
