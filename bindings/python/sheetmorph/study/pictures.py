# SPDX-License-Identifier: LGPL-2.1-or-later
"""A small picture of a variant, with fixed colours of the parts and a fixed view."""

from __future__ import annotations

import struct
import zlib

import numpy as np

from ..base.arrays import Codes, Floats, Ints
from ..solving.answer import Answer

_WIDTH, _HEIGHT = 192, 144
_MARGIN = 8
# Azimuth and elevation of the view, radians.
_AZIMUTH, _ELEVATION = np.radians(-55.0), np.radians(28.0)
_COLOURS = np.array(
    [[110, 150, 190], [205, 140, 90], [120, 170, 120], [180, 120, 160], [150, 150, 110],
     [100, 165, 175], [190, 110, 105], [140, 130, 190]], float,
)  # fmt: skip
# Sample points along a triangle edge; a triangle of 12 px then has no gaps.
_FINE = 14


def picture_of(result: Answer) -> bytes:
    """Return a PNG of all parts of a result, in the frame of their rest shape."""
    session = result.session
    rest = np.concatenate([mesh.points for mesh in session.meshes.values()])
    view = _View(np.concatenate([rest, *result.positions.values()]))
    for k, (name, mesh) in enumerate(session.meshes.items()):
        view.draw(result.positions[name][mesh.triangles], _COLOURS[k % len(_COLOURS)])
    return png(view.pixels)


class _View:
    """A parallel projection that shows all given points (n, 3)."""

    def __init__(self, points: Floats):
        ca, sa, ce, se = *_turn(_AZIMUTH), *_turn(_ELEVATION)
        right = np.array([-sa, ca, 0.0])
        self._towards = np.array([ca * ce, sa * ce, se])
        self._axes = np.stack([right, np.cross(self._towards, right)])
        flat = points @ self._axes.T
        low, high = flat.min(axis=0), flat.max(axis=0)
        room = np.array([_WIDTH - 2 * _MARGIN, _HEIGHT - 2 * _MARGIN])
        self._scale = float((room / np.maximum(high - low, 1e-300)).min())
        self._middle = 0.5 * (low + high)
        self.pixels = np.full((_HEIGHT, _WIDTH, 3), 255, np.uint8)
        self._depth = np.full(_HEIGHT * _WIDTH, -np.inf)

    def draw(self, corners: Floats, colour: Floats) -> None:
        """Draw triangles (m, 3, 3)."""
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        length = np.linalg.norm(normals, axis=1)
        facing = np.abs(normals @ self._towards) / np.where(length > 0.0, length, 1.0)
        shade = ((0.45 + 0.55 * facing)[:, None] * colour).clip(0, 255).astype(np.uint8)
        places = np.einsum("sc,mcd->msd", _places(), corners).reshape(-1, 3)
        flat = (places @ self._axes.T - self._middle) * self._scale
        x = (flat[:, 0] + 0.5 * _WIDTH).astype(int).clip(0, _WIDTH - 1)
        y = (0.5 * _HEIGHT - flat[:, 1]).astype(int).clip(0, _HEIGHT - 1)
        self._put(y * _WIDTH + x, places @ self._towards, np.repeat(shade, len(_places()), axis=0))

    def _put(self, at: Ints, depth: Floats, colours: Codes) -> None:
        order = np.lexsort((depth, at))
        at, depth, colours = at[order], depth[order], colours[order]
        nearest = np.append(at[1:] != at[:-1], True)
        at, depth, colours = at[nearest], depth[nearest], colours[nearest]
        seen = depth > self._depth[at]
        self._depth[at[seen]] = depth[seen]
        self.pixels.reshape(-1, 3)[at[seen]] = colours[seen]


def _places() -> Floats:
    """Return barycentric coordinates (s, 3) of sample points in a triangle."""
    steps = [(i, j) for i in range(_FINE + 1) for j in range(_FINE + 1 - i)]
    inner = np.array([(i, j, _FINE - i - j) for i, j in steps], float)
    return inner / _FINE


def _turn(angle: float) -> tuple[float, float]:
    return float(np.cos(angle)), float(np.sin(angle))


def png(pixels: Codes) -> bytes:
    """Encode pixels (height, width, 3) uint8 as PNG."""
    height, width, _ = pixels.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)], axis=1)
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", zlib.compress(rows.tobytes(), 9)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(_chunk(*chunk) for chunk in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
