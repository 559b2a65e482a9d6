# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in one pose, without the figures of the report."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar


from ..base.arrays import Floats
from ..recipe.pose import Pose
from .preprocessed import Preprocessed, RestShape
from .results import ContactResult, FeatureResult

if TYPE_CHECKING:
    from .. import _core


Measured = TypeVar("Measured")


@dataclass(frozen=True, eq=False)
class Answer:
    """All parts in one pose; the base of the Result of Session.deform(), which adds the report.

    Attributes
    ----------
    positions : dict
        Part name to deformed vertices, (n, 3) float64, mm, read-only.
    spread : float
        Largest distance between two targets that contacts give one vertex, mm; 0 if the answer is
        not exact.
    deformed : _core.Deformed
        Result of the kernel.
    previews : tuple of str
        Parts that an exact answer refines further, so their positions may still change.
    unsettled : dict
        Part name to a sentence about a solve that did not converge.
    repairs : list of dict
        Element repairs in decks: nodes that slid in the sheet after the solve.
    """

    session: Preprocessed
    positions: dict[str, Floats]
    spread: float
    pose: Pose
    deformed: _core.Deformed
    previews: tuple[str, ...] = ()
    unsettled: dict[str, str] = field(default_factory=dict)
    repairs: list[dict[str, Any]] = field(default_factory=list)
    # Not an argument: dataclasses.replace() must start with an empty cache for new positions.
    _measured: dict[object, Any] = field(default_factory=dict, init=False)

    @property
    def displacements(self) -> dict[str, Floats]:
        """Part name to the displacements (n, 3) of its vertices from rest, mm."""
        meshes = self.session.meshes
        return {name: now - meshes[name].points for name, now in self.positions.items()}

    @cached_property
    def _moved(self) -> list[FeatureResult]:
        return self.session.moved_features(self.deformed)

    @property
    def features(self) -> list[FeatureResult]:
        """Motion of every form feature of the recipe, computed on demand."""
        return self._moved[: len(self._moved) - self.session.lump_count]

    @property
    def lumps(self) -> list[FeatureResult]:
        """Motion of the thick regions of thin solids, which move as rigid features."""
        return self._moved[len(self._moved) - self.session.lump_count :]

    @cached_property
    def contacts(self) -> list[ContactResult]:
        """Fidelity of every contact; empty if the answer is not exact."""
        return self.session.kept_contacts(self.deformed, self.positions)

    @property
    def sizes(self) -> dict[str, float]:
        """Feature name to its size in this pose, mm; only features with a prescribed size."""
        return {one.name: one.size for one in self.features if one.size is not None}

    @cached_property
    def rest(self) -> RestShape:
        """Reference shape for strains: the rest shape with the feature sizes of this pose."""
        return self.session.rest_shape(self.sizes)

    def once(self, what: object, measure: Callable[[], Measured]) -> Measured:
        """Return a copy of a measured value; measure it at the first call for its key."""
        if what not in self._measured:
            self._measured[what] = measure()
        found: Measured = deepcopy(self._measured[what])
        return found
