# SPDX-License-Identifier: LGPL-2.1-or-later
"""The region that a selector stands for on a mesh, with remarks for the user."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..base.arrays import Bools, Floats, Ints
from ..base.errors import InputError


class SelectorError(InputError):
    """A selector that cannot be resolved; its fault is at ``path`` in the selector."""

    def __init__(self, what: str, todo: str, path: tuple[str | int, ...] = ()):
        super().__init__(what, todo)
        self.path = path

    def below(self, path: Sequence[str | int]) -> SelectorError:
        """Return the same error in a selector that contains this one at a path."""
        return SelectorError(self.what, self.todo, (*path, *self.path))


@dataclass(frozen=True, eq=False)
class Chosen:
    """A region of a mesh.

    inside (n,) marks the vertices. share (m,) is the selected share of every triangle, 0 to 1.
    matches has one entry for each selector that searches. remarks are sentences for the user.
    """

    inside: Bools
    share: Floats
    matches: list[dict[str, Any]] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)

    @property
    def vertices(self) -> Ints:
        """Vertex indices (k,), ascending."""
        return np.flatnonzero(self.inside)

    def __or__(self, other: Chosen) -> Chosen:
        share = np.maximum(self.share, other.share)
        return Chosen(self.inside | other.inside, share, *self._told(other))

    def __and__(self, other: Chosen) -> Chosen:
        share = np.minimum(self.share, other.share)
        return Chosen(self.inside & other.inside, share, *self._told(other))

    def __sub__(self, other: Chosen) -> Chosen:
        share = np.minimum(self.share, 1.0 - other.share)
        return Chosen(self.inside & ~other.inside, share, *self._told(other))

    def _told(self, other: Chosen) -> Iterator[list[Any]]:
        yield [*self.matches, *other.matches]
        yield [*self.remarks, *other.remarks]
