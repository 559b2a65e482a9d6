# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `certify`, and the option `--certify` of `run` and `check`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .cli_copy import add_copy_arguments
from .cli_values import STDOUT, as_json, json_file
from .files.atomic import FileSet
from .words import counted

NAMES = ("certificate.json", "certificate.html")


def add_certify_arguments(commands: Any, runs: Sequence[argparse.ArgumentParser]) -> None:
    """Add `certify` and `copy` to a parser, and the related options to `run` and `check`."""
    text = "a set (standard, crash, static) or a JSON file with criteria (default: standard)"
    add_copy_arguments(commands)
    for run in runs:
        run.add_argument(
            "--wide", action="store_true", help="write GRID cards of moved nodes in large fields"
        )
        run.add_argument(
            "--repair", metavar="FILE", nargs="?", const="standard",
            help=f"repair deck elements by sliding nodes until they meet criteria, {text}",
        )  # fmt: skip
        run.add_argument("--certify", action="store_true", help="certify the written parts")
        run.add_argument("--criteria", metavar="FILE", help=f"for --certify, {text}")
    command = commands.add_parser("certify", help="certify the folder that a run wrote")
    command.add_argument("recipe", help="the recipe of the run")
    command.add_argument("folder", metavar="DIR", help="the folder that the run wrote")
    command.add_argument("--criteria", metavar="FILE", help=text)
    command.add_argument(
        "--page", metavar="FILE", help="where to write the certificate as an HTML page"
    )
    for one in (*runs, command, commands.choices["copy"]):
        text = "read LS-DYNA decks as if *KEYWORD had this option"
        one.add_argument("--keyword", choices=("long=y", "i10=y"), help=text)


def run_certify(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Certify and return the lines to print. Raises NotCertified."""
    from .certifying import Targets

    targets = Targets(json_file(wanted), None if wanted.page is None else Path(wanted.page))
    found = _certificate(wanted, Path(wanted.folder), targets, files)
    return as_json(found) if wanted.json == STDOUT else _summary(found, wanted.folder)


def _certificate(
    wanted: argparse.Namespace, folder: Path, targets: Any, files: FileSet
) -> dict[str, Any]:
    """Certify a folder, write the certificate to the targets and return it. Raises NotCertified."""
    from .certifying import certify, read_criteria

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
    told = [counted(*count) for count in counts if count[0]]
    return [f"{folder}: certified by {found['criteria']['name']}: {', '.join(told)}"]


def require_criteria(wanted: argparse.Namespace) -> None:
    """Read the criteria of `--certify` before the run writes anything. Raises FileError."""
    from .certifying import read_criteria

    if wanted.certify:
        read_criteria(wanted.criteria)


def judged_run(wanted: argparse.Namespace, folder: Path) -> None:
    """Certify the folder of a trial run for `check --certify`. Raises NotCertified."""
    from .certifying import Targets

    _certificate(wanted, folder, Targets(), FileSet())


def certified_run(wanted: argparse.Namespace) -> list[str]:
    """Certify the written parts for `run --certify` and return the lines to print."""
    from .certifying import Targets

    folder = Path(wanted.output)
    targets = Targets(*(folder / name for name in NAMES))
    found = _certificate(wanted, folder, targets, FileSet("certify", force=wanted.force))
    return _summary(found, wanted.output)
