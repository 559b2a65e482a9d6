# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in one pose, without what reports make of it."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar


from .arrays import Floats
from .preprocessed import Preprocessed, RestShape
from .recipe.pose import Pose
from .results import ContactResult, FeatureResult

if TYPE_CHECKING:
    from . import _core


Measured = TypeVar("Measured")


@dataclass(frozen=True, eq=False)
class Answer:
    """All parts in one pose; what Session.deform() returns is one that also reports.

    positions: part name -> (n, 3) float64 mm, read-only; spread: the largest distance between two
    places where contacts want one vertex, mm, 0 if not exact;
    deformed: the kernel's own result; previews: parts that an exact answer refines besides, so that
    it may differ; unsettled: part name -> what was not solved to its end, and how far it got;
    repairs: of parts of decks, whose nodes slid after they were solved.
    """

    session: Preprocessed
    positions: dict[str, Floats]
    spread: float
    pose: Pose
    deformed: _core.Deformed
    previews: tuple[str, ...] = ()
    unsettled: dict[str, str] = field(default_factory=dict)
    repairs: list[dict[str, Any]] = field(default_factory=list)
    # An answer with other positions begins anew.
    _measured: dict[object, Any] = field(default_factory=dict, init=False)

    @cached_property
    def _moved(self) -> list[FeatureResult]:
        return self.session.moved_features(self.deformed)

    @property
    def features(self) -> list[FeatureResult]:
        """How every form feature of the recipe moved; few who drag ask."""
        return self._moved[: len(self._moved) - self.session.lump_count]

    @property
    def lumps(self) -> list[FeatureResult]:
        """Where thin solids are not thin: each moved as a rigid feature."""
        return self._moved[len(self._moved) - self.session.lump_count :]

    @cached_property
    def contacts(self) -> list[ContactResult]:
        """How well every contact was kept; empty if the answer is not exact."""
        return self.session.kept_contacts(self.deformed, self.positions)

    @property
    def sizes(self) -> dict[str, float]:
        """The sizes that form features have in this pose, mm, by name; only those that are set."""
        return {one.name: one.size for one in self.features if one.size is not None}

    @cached_property
    def rest(self) -> RestShape:
        """The shape that strains compare with: at rest, with the sizes of this pose."""
        return self.session.rest_shape(self.sizes)

    def once(self, what: object, measure: Callable[[], Measured]) -> Measured:
        """What is measured when it is first asked for, under a key; each gets a copy."""
        if what not in self._measured:
            self._measured[what] = measure()
        found: Measured = deepcopy(self._measured[what])
        return found
