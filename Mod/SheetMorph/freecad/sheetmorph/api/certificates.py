# SPDX-License-Identifier: LGPL-2.1-or-later
"""Certificates of written parts."""

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
    """Write every part as `write_parts` does, certify the files and return the certificate.

    The files `certificate.json` and `certificate.html` are written beside the parts. The entries
    `passed` and `failures` give the result.

    Parameters
    ----------
    assembly : object
        The assembly.
    folder : str or path
        Folder for the parts.
    criteria : str
        A set (standard, crash, static) or a JSON file.
    force : bool
        Overwrite files that SheetMorph did not write.

    Raises
    ------
    MorphError, ValueError, OSError
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
