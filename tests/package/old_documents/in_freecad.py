# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run an old scripting page and old macros in FreeCAD; print one JSON line with what differs.

Called by test_old_documents.py: freecadcmd in_freecad.py, with the page and the macros, one path
per line, in the file that OLD_DOCUMENTS names.
"""

import json
import os
import sys
import traceback
from pathlib import Path

import FreeCAD

from freecad.sheetmorph.tests.test_scripting import BLOCK, run_example


def run_page(path: Path) -> tuple[int, list[str]]:
    """Run the blocks of a page; return the number of claims, and those that do not hold."""
    namespace: dict = {"__name__": "example"}
    blocks = BLOCK.findall(path.read_text("utf-8"))
    found = [one for block in blocks for one in run_example(block, namespace)]
    return len(found), [f"{line}, found {value}" for line, claim, value in found if claim != value]


def run_macro(path: Path) -> list[str]:
    """Run a macro and return the objects of its document that have an error."""
    code = compile(path.read_text("utf-8"), str(path), "exec")
    exec(code, {"__name__": "__main__", "__file__": str(path)})
    objects = FreeCAD.ActiveDocument.Objects
    faults = [f"{path.name}: {one.Label}" for one in objects if "Invalid" in one.State]
    return faults or ([] if len(objects) > 5 else [f"{path.name}: {len(objects)} objects"])


def main() -> None:
    """Run everything and print the result."""
    target, page, *macros = Path(os.environ["OLD_DOCUMENTS"]).read_text("utf-8").splitlines()
    claims, differences = run_page(Path(page))
    for macro in macros:
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        differences += run_macro(Path(macro))
    Path(target).write_text(json.dumps({"claims": claims, "differences": differences}), "utf-8")


try:
    main()
except Exception:
    traceback.print_exc()
finally:
    sys.stderr.flush()
    os._exit(0)
