# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph without FreeCAD: recipes, mesh files, deformation, report.

The first Session loads the compiled kernel ``sheetmorph._core``. Code that only reads or checks
files and recipes works without it.
"""

import importlib
from typing import Any

from . import old_names
from .base import version
from .base.errors import (
    Caution,
    Fault,
    FileError,
    InputError,
    KernelError,
    OccupiedError,
    RecipeError,
    SheetMorphError,
    Subject,
)
from .base.part_mesh import PartMesh
from .checking import validate
from .files import PartFile, read_part
from .morph.live import LiveFrames
from .morph.morph import Morph, open_files
from .morph.running import CertificateError, check, resolve, run
from .morph.session import Drag, Result, Session
from .reporting.cautions import open_contacts
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
from .solving.results import ContactResult, FeatureResult
from .starting import diagnose

__version__ = version.__version__

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
    "SheetMorphError",
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
    "open_contacts",
    "open_files",
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

old_names.install(__name__)


def __dir__() -> list[str]:
    """Return the public names, for completion."""
    return sorted([*__all__, "__version__"])


def __getattr__(name: str) -> Any:
    """Return a module under its old name, such as ``sheetmorph.errors``, or open_files as open."""
    if name == "open":  # no name of this module, because it would hide the builtin
        return open_files
    if name in old_names.MOVED:
        return importlib.import_module(f"{__name__}.{name}")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
