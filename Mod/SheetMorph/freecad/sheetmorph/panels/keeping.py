# SPDX-License-Identifier: LGPL-2.1-or-later
"""The effect of OK in panels that change a morph: a stored step, then the shape."""

from freecad.sheetmorph import actions
from freecad.sheetmorph.bridge import faults
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.interaction.finishing import due_in, finishing
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError


def keep(title: str, *lines: str, document) -> None:
    """Run lines as one undo step called `title`, without waiting for a large morph.

    A small morph is solved at once, and an error undoes the step, as in `actions.run`. The shape of
    a large one, or its error, arrives in the background.
    """
    before, late = faults.faults_in(document), []
    try:
        with transactions.step(document, title), actions.followed(title):
            actions.record(*lines, document=document)
            late = late_in(document)
            if late:
                actions.note(f"{actions.DOCUMENT}.recompute()")
            else:
                actions.do(f"{actions.DOCUMENT}.recompute()", document)
                actions.refuse(faults.new_fault(document, before))
    except MorphError:
        late = late_in(document)  # FreeCAD counts the undone changes as due
        if not late:
            document.recompute()
        raise
    finally:
        for morph in late:
            finishing().finish(morph)


def present_fault(assembly, live) -> str:
    """Return the fault of the pose in a panel, empty without one.

    `live` is the panel's LiveUpdate. Without one, a recompute gives the reason at once.
    """
    if live is not None:
        return live.fault
    with actions.waiting():
        assembly.Document.recompute()
    return model.failure_of(assembly)


def late_in(document) -> list:
    """Return the morphs of a document that are due, if OK cannot wait for all of them."""
    due = due_in(document)
    return [] if all(map(finishing().is_quick, due)) else due


def attempt(title: str, *lines: str, document) -> bool:
    """Run lines as `keep` does; report an error and return False."""
    return actions.has_done(title, lambda: keep(title, *lines, document=document))
