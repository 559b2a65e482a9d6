# SPDX-License-Identifier: LGPL-2.1-or-later
"""Builds what a live view needs, with progress and Cancel."""

from contextlib import closing, suppress

from freecad.sheetmorph import actions, reporting
from freecad.sheetmorph.bridge import live_session
from freecad.sheetmorph.progress_dialog import Progress


def prepare(assembly) -> bool:
    """Builds what a live view needs, which takes seconds for large parts; False if cancelled.

    An error is left to whoever needs the result: it will be met again and told there.
    """
    progress = Progress("Preparing the morph")
    with suppress(*actions.FAULTS), closing(progress), reporting.told_to(progress):
        live_session.live(assembly)
    return not progress.is_cancelled
