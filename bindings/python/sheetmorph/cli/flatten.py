# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command `flatten`: the blank of a bent sheet, with its bend lines and bend table."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from ..base.errors import Fault, InputError, RecipeError
from ..files import is_cad, read_part
from ..files.atomic import FileSet
from ..flat import KTable, flat_patterns
from ..flat.writing import data_of, table_of, write_patterns
from ..starting.doctor import diagnose_file
from .output import Outcome
from .progress import progress_on


def execute(wanted: argparse.Namespace, files: FileSet) -> Outcome:
    """Flatten, write the files and return the bend tables.

    Raises RecipeError, FileError, NotFlat.
    """
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
    lines = [line for pattern in patterns for line in table_of(pattern, word)]
    if word != "mm":
        what = f"lengths are in the unit of the file, which seems to be {word}"
        lines.append(f"note: {what} ({unit['reason']}); in the written files, 1 means 1 mm")
    data = {"unit": word, "blanks": [data_of(pattern) for pattern in patterns]}
    if output is None:
        return Outcome(lines, data)
    try:
        files.reads += [Path(wanted.file), *([Path(wanted.k_table)] if wanted.k_table else [])]
        written = write_patterns(patterns, output, files)
    except InputError as error:
        raise RecipeError([Fault(str(output), error.what, error.todo)]) from error
    return Outcome([*lines, *(f"wrote {path}" for path in written)], data)
