# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays in files that a document includes, with fast compression.

FreeCAD copies and compresses such a file byte by byte at every save, and blocks meanwhile.
"""

from __future__ import annotations

import os
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

_LEVEL = 1  # compression level; higher ones take three times as long and save 3 %


def write(path: str, **arrays: np.ndarray) -> None:
    """Write arrays by name as an .npz that `numpy.load` reads."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=_LEVEL) as archive:
        for name, array in arrays.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
                np.lib.format.write_array(file, np.asanyarray(array), allow_pickle=False)


@contextmanager
def opened(path: str) -> Iterator[Any]:
    """Provide the arrays of a file by name. Raises ValueError with a sentence if it is damaged."""
    name = os.path.basename(path)
    damaged = ValueError(f"The file '{name}' in this document is damaged; add the part again.")
    try:
        data = np.load(path, allow_pickle=False)
    except (ValueError, EOFError, zipfile.BadZipFile) as error:
        raise damaged from error
    with data:
        try:
            yield data
        except (KeyError, EOFError, zipfile.BadZipFile, zlib.error) as error:
            raise damaged from error


def of_text(text: str) -> np.ndarray:
    """Return a text as an array of bytes, a quarter of the size of a text array."""
    return np.frombuffer(text.encode(), np.uint8)


def text_in(array: np.ndarray) -> str:
    """Return the text of an array from `of_text`, or of a numpy text array."""
    return array.tobytes().decode() if array.dtype == np.uint8 else str(array)
