# SPDX-License-Identifier: LGPL-2.1-or-later
"""SheetMorph without FreeCAD: recipes, mesh files, deformation, report.

The compiled kernel ``sheetmorph._core`` is loaded by the first Session, so files and recipes can be
read and checked without it.
"""

from .doctor import diagnose
from .errors import Fault, FileError, KernelError, RecipeError
from .files import PartFile, read_part
from .live import LiveFrames
from .part_mesh import PartMesh
from .recipe import validate
from .running import CertificateError, check, resolve, run
from .results import ContactResult, FeatureResult
from .session import Drag, Result, Session

__version__ = "0.1.0"

__all__ = [
    "CertificateError",
    "ContactResult",
    "Drag",
    "Fault",
    "FeatureResult",
    "FileError",
    "KernelError",
    "LiveFrames",
    "PartFile",
    "PartMesh",
    "RecipeError",
    "Result",
    "Session",
    "check",
    "diagnose",
    "read_part",
    "resolve",
    "run",
    "validate",
]
