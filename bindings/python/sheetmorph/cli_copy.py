# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `copy`: read files and write them again unchanged."""

from __future__ import annotations

import argparse
from typing import Any

from .files.atomic import FileSet


def add_copy_arguments(commands: Any) -> None:
    """Add `copy` to the commands of a parser."""
    copy = commands.add_parser(
        "copy", help="read decks, meshes or joint files and write them unchanged"
    )
    copy.add_argument("files", nargs="+", metavar="FILE", help="deck, mesh or joint file")
    copy.add_argument("-o", "--output", required=True, metavar="DIR", help="folder for the copies")


def run_copy(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Copy the files and return the lines to print."""
    # Imported here, so that --help answers at once.
    from .copying import copy_files

    return copy_files(wanted.files, wanted.output, files)
