# SPDX-License-Identifier: LGPL-2.1-or-later
"""CAD files, read, meshed, carried and written by the program ``sheetmorph-cad``.

OpenCASCADE runs in processes of that program, one a model, and never in this process. If it
crashes, that costs one file, and InvalidInput says so in one sentence.
"""

from __future__ import annotations

import os
import struct
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..base.arrays import Floats
from ..base.progress import Progress
from .model import CadFeature, CadModel, CadPart, CadSurface

__all__ = [
    "CadFeature",
    "CadModel",
    "CadPart",
    "CadSurface",
    "kept_model",
    "read_brep",
    "read_cad",
    "write_cad",
]
_SIZES = {"edge": 0.0, "deflection": 0.0, "angle": 0.35}


def read_cad(
    path: str, sizes: Mapping[str, float] | None = None, progress: Progress | None = None
) -> CadModel:
    """Return the parts of a STEP, IGES or BREP file.

    Parameters
    ----------
    path
        The file.
    sizes
        ``edge`` mm, that no edge is longer than (1/100 of the diagonal); ``deflection`` mm, that
        none is farther from its surface (edge / 50); ``angle`` radians, that the surface turns by
        at most along it (0.35).
    progress
        ``progress(fraction, task)`` returns False to stop.

    Raises
    ------
    InvalidInput, Cancelled, KernelError, OSError
    """
    request = [b"read_cad", os.fsencode(path), _packed(sizes)]
    return CadModel("read the file", request, progress, Path(path))


def read_brep(text: str, name: str, sizes: Mapping[str, float] | None = None) -> CadModel:
    """Return the same for the text of a BREP file; its parts are called name, or name.1, name.2,
    ..."""
    request = [b"read_brep", text.encode(), _text(name), _packed(sizes)]
    return CadModel(f"meshed '{name}'", request)


def kept_model(brep: str, mesh: bytes, name: str) -> CadModel:
    """Return a model of one part of another, of its brep() and its kept_mesh(), not meshed again.

    Raises InvalidInput.
    """
    return CadModel(f"read '{name}'", [b"kept_model", brep.encode(), mesh, _text(name)])


def write_cad(
    model: CadModel,
    positions: Sequence[Floats],
    path: str,
    writing: Mapping[str, Any],
    *,
    progress: Progress | None = None,
) -> list[dict[str, Any]]:
    """Write the file that a model was read of with its parts at other positions.

    Parameters
    ----------
    positions
        (n, 3) of each part, mm.
    writing
        ``format`` step, iges or brep; ``tolerance`` and ``edge_tolerance`` in mm.

    Returns
    -------
    What the file holds, read again: a dict a part.

    Raises
    ------
    InvalidInput, SolverError, Cancelled
    """
    tolerances = struct.pack("=2d", writing["tolerance"], writing["edge_tolerance"])
    arrays = [np.ascontiguousarray(one, dtype=np.float64).tobytes() for one in positions]
    request = [b"write_cad", os.fsencode(path), writing["format"].encode(), tolerances, *arrays]
    return model.write(request, progress)


def _packed(sizes: Mapping[str, float] | None) -> bytes:
    unknown = [key for key in sizes or {} if key not in _SIZES]
    if unknown:
        raise KeyError(f"sizes are edge, deflection and angle, not {unknown[0]}")
    return struct.pack("=3d", *{**_SIZES, **(sizes or {})}.values())


def _text(name: str) -> bytes:
    return name.encode("utf-8", "replace")
