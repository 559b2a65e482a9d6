# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `flatten`: the blank of a bent sheet, with its bend lines and bend table."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any

from .cli_progress import progress_on
from .errors import Fault, InputError, RecipeError
from .files.atomic import FileSet


def add_flatten_arguments(commands: Any) -> None:
    """Add `flatten` to the commands of a parser."""
    text = "flatten a bent sheet: blank, bend lines, bend table (kinematic, no forming simulation)"
    flatten = commands.add_parser("flatten", help=text)
    flatten.add_argument("file", metavar="FILE", help="mesh of an open sheet or a thin solid")
    text = "folder for DXF, SVG, OBJ and JSON, or one file .dxf, .svg, .obj or .json"
    flatten.add_argument("-o", "--output", metavar="OUT", help=text)
    text = "thickness of an open sheet, which is the mid-surface, mm"
    flatten.add_argument("--thickness", type=_positive, metavar="MM", help=text)
    text = "text file with one R/T ratio and K-factor per line (default: usual values)"
    flatten.add_argument("--k-table", metavar="TABLE", help=text)
    text = "largest stretch allowed in 99 %% of the area, percent (default: 1)"
    flatten.add_argument("--limit", type=_positive, default=1.0, metavar="PERCENT", help=text)
    text = "merge vertices closer than this first, for files that are cut along faces"
    flatten.add_argument("--weld", type=_positive, metavar="MM", help=text)
    flatten.add_argument("--quiet", action="store_true", help="do not print progress to stderr")


def _positive(text: str) -> float:
    value = float(text)
    if not 0.0 < value < math.inf:
        raise argparse.ArgumentTypeError(f"{text} is not a number above 0")
    return value


def run_flatten(wanted: argparse.Namespace, files: FileSet) -> list[str]:
    """Flatten, write the files and return the bend tables.

    Raises RecipeError, FileError, NotFlat.
    """
    # Imported here, so that --help answers at once.
    from .doctor import diagnose_file
    from .files import is_cad, read_part
    from .flat import KTable, flat_patterns
    from .flat.writing import table_of, write_patterns

    table = KTable() if wanted.k_table is None else KTable.read(wanted.k_table)
    output = None if wanted.output is None else Path(wanted.output)
    with progress_on(sys.stderr, wanted.quiet) as progress:
        patterns = flat_patterns(
            wanted.file, thickness=wanted.thickness, table=table, limit=wanted.limit / 100.0,
            weld=wanted.weld,
            progress=progress,
        )  # fmt: skip
    is_mm = is_cad(wanted.file)
    unit = {"guess": "mm"} if is_mm else diagnose_file(read_part(wanted.file))["unit"]
    word = "units" if unit["guess"] == "unknown" else unit["guess"]
    told = [line for pattern in patterns for line in table_of(pattern, word)]
    if word != "mm":
        what = f"lengths are in the unit of the file, which seems to be {word}"
        told.append(f"note: {what} ({unit['reason']}); in the written files, 1 means 1 mm")
    if output is None:
        return told
    try:
        files.reads += [Path(wanted.file), *([Path(wanted.k_table)] if wanted.k_table else [])]
        written = write_patterns(patterns, output, files)
    except InputError as error:
        raise RecipeError([Fault(str(output), error.what, error.todo)]) from error
    return [*told, *(f"wrote {path}" for path in written)]
