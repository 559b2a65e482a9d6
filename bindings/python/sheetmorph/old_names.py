# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of modules before they moved into rooms; scripts that import them still work."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Sequence
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

MOVED = {
    "answer": "solving.answer",
    "cautions": "reporting.cautions",
    "certifying.quality": "measuring.quality",
    "doctor": "starting.doctor",
    "errors": "base.errors",
    "file_unit": "base.file_unit",
    "files.polygons": "base.polygons",
    "gaps": "measuring.gaps",
    "kernel": "base.kernel",
    "labels": "base.labels",
    "live": "morph.live",
    "part_mesh": "base.part_mesh",
    "prepared_mesh": "files.prepared_mesh",
    "preprocessed": "solving.preprocessed",
    "report": "reporting.report",
    "results": "solving.results",
    "running": "morph.running",
    "session": "morph.session",
    "showing": "morph.showing",
    "strain": "measuring.strain",
    "words": "base.words",
}
"""Old name of a module in the package -> its present name."""


class OldNames(MetaPathFinder, Loader):
    """Imports the present module under its old name."""

    def __init__(self, package: str):
        self._moved = {f"{package}.{old}": f"{package}.{new}" for old, new in MOVED.items()}

    def find_spec(
        self,
        fullname: str,
        path: Sequence[str] | None = None,
        target: ModuleType | None = None,
    ) -> ModuleSpec | None:
        """Return how to import an old name, None for every other name."""
        return ModuleSpec(fullname, self) if fullname in self._moved else None

    def exec_module(self, module: ModuleType) -> None:
        """Put the present module in the place of an empty one; importlib allows that."""
        sys.modules[module.__name__] = importlib.import_module(self._moved[module.__name__])


def install(package: str) -> None:
    """Make the old names of a package importable, once."""
    if not any(isinstance(finder, OldNames) for finder in sys.meta_path):
        sys.meta_path.append(OldNames(package))
