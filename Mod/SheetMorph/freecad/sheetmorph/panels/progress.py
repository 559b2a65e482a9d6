# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preparation of a live view, with progress and Cancel."""

from contextlib import closing, suppress

from freecad.sheetmorph import actions, reporting
from freecad.sheetmorph.bridge import live_session
from freecad.sheetmorph.progress_dialog import Progress


def prepare(assembly) -> bool:
    """Prepare a live view, which takes seconds for large parts; return False if cancelled.

    Errors are ignored here, because the later use of the result raises them again.
    """
    progress = Progress("Preparing the morph")
    with suppress(*actions.FAULTS), closing(progress), reporting.told_to(progress):
        live_session.LiveSession(assembly)
    return not progress.is_cancelled
