# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in memory: checked and factorised once, then deformed pose by pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .answer import Answer
from .arrays import Floats, Ints
from .errors import Caution
from .notebook import picture_html
from .pictures import scene_of_answer
from .preprocessed import Preprocessed
from .progress import Progress
from .recipe import check_pose
from .recipe.pose import Pose
from .report import make_report, warnings_in
from .translation import kernel_faults

if TYPE_CHECKING:
    from . import _core


@dataclass(frozen=True, eq=False, repr=False)
class Result(Answer):
    """All parts in one pose, with the report about it."""

    def __repr__(self) -> str:
        moved = max(
            float(np.linalg.norm(positions - self.session.meshes[name].points, axis=1).max())
            for name, positions in self.positions.items()
        )
        return f"<Result of {', '.join(self.positions)}: moved by up to {moved:.4g} mm>"

    def _repr_html_(self) -> str:
        """The parts, coloured by how far each place moved, for notebooks."""
        return picture_html(scene_of_answer(self), repr(self))

    def control_mesh(self, contact: str | None = None) -> tuple[Floats, Ints] | None:
        """Vertices (m, 3) mm and triangles (t, 3) of a contact's control mesh in this pose.

        contact None: the single one. None if there is no such control mesh; ValueError for an
        unknown contact.
        """
        return self.session.control_mesh(contact, self.deformed)

    def report(self) -> dict[str, Any]:
        """The report (report.schema.json) without what concerns files."""
        return make_report(self)

    def warnings(self) -> list[Caution]:
        """The report's warnings, one sentence each, which knows its `objects`."""
        return warnings_in(self)


class Session(Preprocessed):
    """A morph whose parts are given as meshes; its arguments are those of `Preprocessed`.

    deform() answers a pose, always from rest; begin_drag() many poses of the same handles.
    """

    def __repr__(self) -> str:
        return f"<Session of {', '.join(self.parts)}: primary {self.model.primary}>"

    def deform(
        self,
        pose: Pose | None = None,
        exact: bool = True,
        progress: Progress | None = None,
    ) -> Result:
        """All parts in a pose, always from rest; None: the recipe's pose.

        exact=False is the fast way while dragging, 1e-6 of the size, for `steel` the linear shape.
        progress(fraction, task) may return False to cancel (RuntimeError). Raises RecipeError.
        """
        wanted = self._recipe_pose if pose is None else pose
        moved = check_pose(self._model, wanted)
        with kernel_faults(self._core):
            deformed = self._kernel.deform(self._translator.pose(moved), exact, progress)
        return self._result(deformed, wanted)

    def begin_drag(self, handles: list[str], pose: Pose | None = None) -> Drag:
        """Live frames while the named handles move, the others staying as in `pose`.

        Raises RecipeError for a name that is no handle.
        """
        wanted = self._recipe_pose if pose is None else pose
        start = self._translator.pose(check_pose(self._model, wanted))
        with kernel_faults(self._core):
            return Drag(self, self._kernel.begin_drag(handles, start))

    def dragged(self, kernel_drag: _core.LiveDrag, pose: Pose) -> Result:
        """What Drag.deform() answers."""
        moved = check_pose(self._model, pose)
        with kernel_faults(self._core):
            return self._result(kernel_drag.frame(self._translator.pose(moved)), pose)

    def _result(self, deformed: _core.Deformed, wanted: Pose) -> Result:
        return Result(
            session=self,
            positions={name: deformed.positions(k) for k, name in enumerate(self.parts)},
            spread=float(deformed.spread),
            pose=dict(wanted),
            deformed=deformed,
            previews=tuple(self.parts[part] for part in deformed.previews),
            unsettled={self.parts[part]: text for part, text in deformed.unsettled},
        )


class Drag:
    """Live frames of handles that are dragged, begun by Session.begin_drag().

    In the background the kernel works out how the parts answer to the handles; until a part is
    done, and in poses that turn more than two of its handles, frames take longer, not other values.
    """

    def __init__(self, session: Session, kernel_drag: _core.LiveDrag):
        self._session = session
        self._drag = kernel_drag

    @property
    def is_ready(self) -> bool:
        """Whether the background work is done."""
        return bool(self._drag.is_ready)

    @property
    def failure(self) -> str:
        """What the background work has failed with, empty if it has not; frames go on, slower."""
        return str(self._drag.failure)

    def wait(self) -> None:
        """Return when the background work is done; raises what it failed with."""
        self._drag.wait()

    def deform(self, pose: Pose) -> Result:
        """All parts in a pose, from rest. Raises RecipeError.

        Memory of results that nobody holds any more is used again.
        """
        return self._session.dragged(self._drag, pose)
