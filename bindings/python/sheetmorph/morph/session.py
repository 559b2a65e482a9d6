# SPDX-License-Identifier: LGPL-2.1-or-later
"""A morph in memory: checked and factorised once, then deformed for each pose."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arrays import Floats, Ints
from ..base.errors import Caution
from ..base.progress import Progress
from ..base.words import several
from ..checking import check_pose
from ..pictures import scene_of_answer
from ..pictures.notebook import picture_html
from ..recipe.plain import plain_pose
from ..recipe.pose import Pose
from ..reporting.report import make_report, warnings_in
from ..solving.answer import Answer
from ..solving.preprocessed import Preprocessed
from ..solving.translation import kernel_faults

if TYPE_CHECKING:
    from .. import _core


@dataclass(frozen=True, eq=False, repr=False)
class Result(Answer):
    """All parts in one pose, with the report on it.

    Attributes
    ----------
    positions : dict
        Part name to deformed vertices, (n, 3) float64, mm, read-only.
    spread : float
        Largest distance between two targets that contacts give one vertex, mm; 0 if the result is
        not exact.
    pose : dict
        The pose, as in a recipe.
    previews : tuple of str
        Parts that an exact answer refines further, so their positions may still change.
    unsettled : dict
        Part name to a sentence about a solve that did not converge.
    repairs : list of dict
        Element repairs in decks.
    """

    def __repr__(self) -> str:
        moved = max(
            float(np.linalg.norm(shifts, axis=1).max()) for shifts in self.displacements.values()
        )
        return f"<Result of {several(self.positions)}: moved by up to {moved:.4g} mm>"

    def _repr_html_(self) -> str:
        """Return a picture for notebooks, with the parts coloured by displacement."""
        return picture_html(scene_of_answer(self), repr(self))

    def control_mesh(self, contact: str | None = None) -> tuple[Floats, Ints] | None:
        """Return a control mesh in this pose.

        Parameters
        ----------
        contact : str, optional
            Name of the contact; None for the single control mesh.

        Returns
        -------
        tuple of array or None
            Vertices (m, 3), mm, and triangles (t, 3); None if the contact has no control mesh.

        Raises
        ------
        ValueError
            If the name belongs to none of the contacts.
        """
        return self.session.control_mesh(contact, self.deformed)

    def report(self) -> dict[str, Any]:
        """Return the report without entries on files.

        Returns
        -------
        dict
            See ``report.schema.json``.
        """
        return make_report(self)

    def warnings(self) -> list[Caution]:
        """Return the warnings of the report.

        Returns
        -------
        list of Caution
            One sentence each; its ``objects`` are the recipe entries that it is about.
        """
        return warnings_in(self)


class Session(Preprocessed):
    """A morph whose parts are given as meshes.

    deform() computes one pose, always from rest. begin_drag() prepares many poses of the same
    handles.

    Parameters
    ----------
    recipe : dict
        As in a recipe file; parts need no "file". Arrays and tuples may stand for lists, and a mask
        (n,) of bool for the ids of vertices.
    meshes : mapping
        Part name to PartMesh.
    progress : callable, optional
        progress(fraction, task) may return False to cancel (RuntimeError).
    previous : Preprocessed, optional
        Session of an earlier state of the recipe; unchanged parts of it are reused.
    found : Found, optional
        Result of a search in the files for "auto" entries; by default the constructor searches.
    told : mapping, optional
        Remarks on selectors that were resolved before.

    Raises
    ------
    RecipeError
        If the recipe has faults.
    KernelError
        If the compiled kernel cannot be loaded.
    """

    def __repr__(self) -> str:
        return f"<Session of {several(self.parts)}: primary {self.model.primary}>"

    def deform(
        self,
        pose: Pose | None = None,
        exact: bool = True,
        progress: Progress | None = None,
    ) -> Result:
        """Return all parts in a pose, always computed from rest.

        Parameters
        ----------
        pose : dict, optional
            The pose, as in a recipe; by default the recipe's own.
        exact : bool
            False gives a fast answer for dragging, accurate to 1e-6 of the size; for the energy
            `steel` it is the linear shape.
        progress : callable, optional
            progress(fraction, task) may return False to cancel (RuntimeError).

        Returns
        -------
        Result
            Positions (n, 3) of every part, mm, and the report.

        Raises
        ------
        RecipeError
            If the pose has faults.
        """
        wanted = self._recipe_pose if pose is None else plain_pose(pose)
        moved = check_pose(self._model, wanted)
        with kernel_faults(self._core):
            deformed = self._kernel.deform(self._translator.pose(moved), exact, progress)
        return self._result(deformed, wanted)

    def begin_drag(self, handles: list[str], pose: Pose | None = None) -> Drag:
        """Start live frames for handles; the other entries stay as in the pose.

        Parameters
        ----------
        handles : list of str
            Names of the handles that move.
        pose : dict, optional
            The pose at the start; by default the recipe's own.

        Returns
        -------
        Drag
            The live frames.

        Raises
        ------
        RecipeError
            If a name does not belong to a handle.
        """
        wanted = self._recipe_pose if pose is None else plain_pose(pose)
        start = self._translator.pose(check_pose(self._model, wanted))
        with kernel_faults(self._core):
            return Drag(self, self._kernel.begin_drag(handles, start))

    def dragged(self, kernel_drag: _core.LiveDrag, pose: Pose) -> Result:
        """Return the frame of a kernel drag; called by Drag.deform().

        Parameters
        ----------
        kernel_drag : _core.LiveDrag
            The drag in the kernel.
        pose : dict
            The pose, as in a recipe.

        Returns
        -------
        Result
            Positions (n, 3) of every part, mm.

        Raises
        ------
        RecipeError
            If the pose has faults.
        """
        wanted = plain_pose(pose)
        moved = check_pose(self._model, wanted)
        with kernel_faults(self._core):
            return self._result(kernel_drag.frame(self._translator.pose(moved)), wanted)

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
    """Live frames of dragged handles; Session.begin_drag() creates it.

    In the background the kernel computes the response of the parts to the handles. Frames take
    longer until a part is done, and in poses that turn more than two of its handles. Their values
    are the same.
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
        """Error of the background work, or an empty string; frames continue, but slower."""
        return str(self._drag.failure)

    def wait(self) -> None:
        """Wait until the background work is done; raise its error if it failed."""
        self._drag.wait()

    def deform(self, pose: Pose) -> Result:
        """Return all parts in a pose, computed from rest.

        The memory of results without a reference is reused.

        Parameters
        ----------
        pose : dict
            The pose, as in a recipe.

        Returns
        -------
        Result
            Positions (n, 3) of every part, mm.

        Raises
        ------
        RecipeError
            If the pose has faults.
        """
        return self._session.dragged(self._drag, pose)
