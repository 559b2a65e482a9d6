# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays in files that a document includes: as small as can be had at once.

FreeCAD copies such a file byte by byte and compresses it, whenever the document is saved; nobody
can do anything else meanwhile.
"""

from __future__ import annotations

import zipfile

import numpy as np

_LEVEL = 1  # of compression: more takes three times as long and gains a thirtieth


def write(path: str, **arrays: np.ndarray) -> None:
    """Write arrays by name as an .npz that `numpy.load` reads."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=_LEVEL) as archive:
        for name, array in arrays.items():
            with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
                np.lib.format.write_array(file, np.asanyarray(array), allow_pickle=False)


def of_text(text: str) -> np.ndarray:
    """Return a text as an array of bytes; as an array of text it would have four a character."""
    return np.frombuffer(text.encode(), np.uint8)


def text_in(array: np.ndarray) -> str:
    """Return the text of an array that `of_text` made, or that numpy made of a text."""
    return array.tobytes().decode() if array.dtype == np.uint8 else str(array)
