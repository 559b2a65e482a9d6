# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph without FreeCAD: recipes, mesh files, deformation, report.

The first Session loads the compiled kernel ``sheetmorph._core``. Code that only reads or checks
files and recipes works without it.
"""

from .cautions import open_contacts
from .doctor import diagnose
from .errors import (
    Caution,
    Fault,
    FileError,
    InputError,
    KernelError,
    OccupiedError,
    RecipeError,
    Subject,
)
from .files import PartFile, read_part
from .live import LiveFrames
from .morph import Morph, open
from .part_mesh import PartMesh
from .recipe import validate
from .running import CertificateError, check, resolve, run
from .results import ContactResult, FeatureResult
from .selecting.words import (
    Selector,
    border_at,
    borders_longer,
    box,
    cad_edge_at,
    cad_face_at,
    cylinder,
    everything,
    face_at,
    found,
    group,
    grow,
    half_space,
    intersection,
    minus,
    piece_at,
    rim_at,
    shrink,
    slab,
    sphere,
    union,
    vertices,
)
from .session import Drag, Result, Session

__version__ = "0.2.0"

__all__ = [
    "Caution",
    "CertificateError",
    "ContactResult",
    "Drag",
    "Fault",
    "FeatureResult",
    "FileError",
    "InputError",
    "KernelError",
    "LiveFrames",
    "Morph",
    "OccupiedError",
    "PartFile",
    "PartMesh",
    "RecipeError",
    "Result",
    "Selector",
    "Session",
    "Subject",
    "border_at",
    "borders_longer",
    "box",
    "cad_edge_at",
    "cad_face_at",
    "check",
    "cylinder",
    "diagnose",
    "everything",
    "face_at",
    "found",
    "group",
    "grow",
    "half_space",
    "intersection",
    "minus",
    "open",
    "open_contacts",
    "piece_at",
    "read_part",
    "resolve",
    "rim_at",
    "run",
    "shrink",
    "slab",
    "sphere",
    "union",
    "validate",
    "vertices",
]
