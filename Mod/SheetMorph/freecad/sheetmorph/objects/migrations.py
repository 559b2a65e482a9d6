# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps that turn objects of an older document into those of today.

`SchemaVersion` counts them. A new property or choice needs no step, see `apply_properties`.
"""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD

from freecad.sheetmorph.kinds import ASSEMBLY, kind

ADVANCED = "Advanced"


def put_selectors_under_advanced(obj) -> None:
    """Move the selectors of a region or contact to the end of the property editor."""
    for name in ("Where", "WhereA", "WhereB"):
        if name in obj.PropertiesList:
            obj.setGroupOfProperty(name, ADVANCED)


STEPS: dict[int, Callable] = {1: put_selectors_under_advanced}
"""By version: the step to the next one."""
VERSION = max(STEPS) + 1


def migrate(obj) -> None:
    """Bring an object of an opened document to VERSION; one of a newer program stays as it is."""
    found = getattr(obj, "SchemaVersion", 1)
    for version in range(found, VERSION):
        STEPS[version](obj)
    if found < VERSION and "SchemaVersion" in obj.PropertiesList:
        obj.SchemaVersion = VERSION
    elif found > VERSION and kind(obj) == ASSEMBLY:
        FreeCAD.Console.PrintWarning(
            f"SheetMorph: '{obj.Label}' was saved by a newer version of SheetMorph, which may "
            "have settings that this one ignores. Update SheetMorph.\n"
        )
