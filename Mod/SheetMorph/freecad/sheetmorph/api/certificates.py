# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is written, read again, measured and judged."""

from __future__ import annotations

import os
from pathlib import Path

from freecad.sheetmorph.api.files import write_parts, write_recipe
from freecad.sheetmorph.bridge import kernel
from freecad.sheetmorph.bridge.conversion import temporary_folder
from freecad.sheetmorph.bridge.written import CERTIFICATE


def certify(
    assembly, folder: str | os.PathLike, criteria: str = "standard", *, force: bool = False
) -> dict:
    """Write every part as `write_parts` does and certify what was written; return the certificate.

    `criteria`: a set (standard, crash, static) or a JSON file. `certificate.json` and a page,
    `certificate.html`, lie beside the parts; `passed` and `failures` tell whether all holds.
    Files that SheetMorph did not write stay, unless `force`. Raises MorphError, ValueError,
    OSError.
    """
    certifying, folder = kernel.certifying(), Path(folder)
    limits = certifying.read_criteria(criteria)
    with temporary_folder() as rest:
        recipe = write_recipe(assembly, Path(rest) / "recipe.json", is_placed=False)
        write_parts(assembly, folder, force=force)
        targets = certifying.Targets(*(folder / name for name in CERTIFICATE))
        files = kernel.load().files.atomic.FileSet("certify", force=force)
        try:
            return certifying.certify(recipe, folder, limits, targets, files=files)
        except certifying.NotCertified as error:
            return error.certificate
