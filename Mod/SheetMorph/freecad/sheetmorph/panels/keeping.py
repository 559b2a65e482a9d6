# SPDX-License-Identifier: LGPL-2.1-or-later
"""What OK does in the panels that change a morph: the step is kept, the shape follows."""

from freecad.sheetmorph import actions
from freecad.sheetmorph.bridge import faults
from freecad.sheetmorph.editing import transactions
from freecad.sheetmorph.interaction.finishing import due_in, finishing
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import MorphError


def keep(title: str, *lines: str, document) -> None:
    """Runs lines as one undo step called ``title``, without waiting for the shape.

    A small morph is solved at once, and an error takes the step back, as in `actions.run`. The
    shape of a large one comes in the background, and so does what is wrong with it.
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
        late = late_in(document)  # FreeCAD counts as due what was taken back
        if not late:
            document.recompute()
        raise
    finally:
        for morph in late:
            finishing().finish(morph)


def present_fault(assembly, live) -> str:
    """What is wrong with the pose that a panel shows, empty for nothing. ``live``: its LiveUpdate;
    without one a recompute says at once why there is none."""
    if live is not None:
        return live.fault
    with actions.waiting():
        assembly.Document.recompute()
    return model.failure_of(assembly)


def late_in(document) -> list:
    """The morphs of a document whose parts are due, if OK may not wait for all of them."""
    due = due_in(document)
    return [] if all(map(finishing().is_quick, due)) else due


def attempt(title: str, *lines: str, document) -> bool:
    """As :func:`keep`; reports an error, and returns False then."""
    return actions.has_done(title, lambda: keep(title, *lines, document=document))
