# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `certify`, and the option `--certify` of `run` and `check`."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from ..base.words import counted
from ..certifying import Targets, certify, read_criteria
from ..files.atomic import FileSet
from .output import Outcome, json_target

NAMES = ("certificate.json", "certificate.html")


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Certify and return the certificate. Raises NotCertified."""
    targets = Targets(json_target(wanted), None if wanted.page is None else Path(wanted.page))
    found = _certificate(wanted, Path(wanted.folder), targets, files)
    return Outcome(_summary(found, wanted.folder), found)


def _certificate(
    wanted: argparse.Namespace, folder: Path, targets: Targets, files: FileSet
) -> dict[str, Any]:
    """Certify a folder, write the certificate to the targets and return it. Raises NotCertified."""
    files.reads += [] if wanted.criteria is None else [Path(wanted.criteria)]
    criteria = read_criteria(wanted.criteria)
    return certify(wanted.recipe, folder, criteria, targets, files=files)


def _summary(found: dict[str, Any], folder: str) -> list[str]:
    joints = sum(deck["joints"]["count"] for deck in found["decks"])
    counts = (
        (len(found["parts"]), "part", "parts"),
        (len(found["features"]), "form feature", "form features"),
        (len(found["contacts"]), "contact", "contacts"),
        (joints, "joint", "joints"),
    )
    contents = [counted(*count) for count in counts if count[0]]
    return [f"{folder}: certified by {found['criteria']['name']}: {', '.join(contents)}"]


def require_criteria(wanted: argparse.Namespace) -> None:
    """Read the criteria of `--certify` before the run writes anything. Raises FileError."""
    if wanted.certify:
        read_criteria(wanted.criteria)


def judged_run(wanted: argparse.Namespace, folder: Path) -> None:
    """Certify the folder of a trial run for `check --certify`. Raises NotCertified."""
    _certificate(wanted, folder, Targets(), FileSet())


def certified_run(wanted: argparse.Namespace) -> list[str]:
    """Certify the written parts for `run --certify` and return the lines to print."""
    folder = Path(wanted.output)
    targets = Targets(*(folder / name for name in NAMES))
    found = _certificate(wanted, folder, targets, FileSet("certify", force=wanted.force))
    return _summary(found, wanted.output)
