# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sessions of the kernel, cached between recomputes and found by their content.

A session is rebuilt only if meshes, regions, contacts or the energy change. It reuses the unchanged
data of the previous session. A new pose needs no rebuild. An undo to an earlier state finds its
session and its result again.
"""

from __future__ import annotations

import hashlib
import threading
from collections import OrderedDict
from concurrent.futures import Future, wait
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from freecad.sheetmorph import reporting
from freecad.sheetmorph.bridge import conversion, faults, kernel, recipes
from freecad.sheetmorph.bridge.faults import FAILURES
from freecad.sheetmorph.bridge.findings import Findings, Step, findings_of, show, steps_of
from freecad.sheetmorph.objects import assembly_of, deformation_of
from freecad.sheetmorph.objects.errors import Fault, MorphError
from freecad.sheetmorph.objects.model import Members, set_where_new
from freecad.sheetmorph.bridge.rest import RestPart, read_rest
from freecad.sheetmorph.tools.poses import Pose

ControlMesh = tuple[np.ndarray, np.ndarray]
"""Vertices (m, 3) float64, global, mm, and triangles (t, 3) int32."""
LOOK = 0.05  # seconds between two checks of another thread
ORPHANED = "The morph of this part was deleted: undo that, or delete the part too."

__all__ = ["MorphError", "Outcome", "SessionCache", "cache_of", "read_morph"]


@dataclass(frozen=True, eq=False)
class Morph:
    """All data of an assembly that determine the result, read from the document."""

    recipe: dict  # without pose
    pose: dict
    rests: dict[str, RestPart]  # by document object name
    names: dict[str, str]  # document object name to recipe name
    objects: dict[tuple[str, str], str]  # recipe list and name to object name
    ignored: tuple[str, ...] = ()  # labels of regions and contacts that have lost their part

    @cached_property
    def key(self) -> str:
        """A fingerprint of everything except the pose."""
        state = hashlib.blake2b(repr(self.recipe).encode(), digest_size=16)
        for rest in self.rests.values():
            state.update(rest.digest.encode())
        return state.hexdigest()

    @property
    def answer_key(self) -> tuple:
        """Cache key of an answer: fingerprint, pose, and object names."""
        return self.key, repr(self.pose), tuple(self.names.items())

    @property
    def contacts(self) -> dict[str, str]:
        """Document object names of the contacts by recipe name."""
        return {name: found for (of, name), found in self.objects.items() if of == "contact"}

    def is_held(self) -> bool:
        """Return whether any vertex is prescribed, so that there is something to solve."""
        return any(self.recipe.get(kind) for kind in ("fixed", "handles", "points"))


@dataclass(frozen=True, eq=False)
class Outcome:
    """The result of a recompute: positions of all parts, or the reason for their absence."""

    failure: Fault = Fault("")
    status: str = ""
    morph: Morph | None = None
    positions: dict[str, np.ndarray] = field(default_factory=dict)  # global, by object name
    findings: Findings = Findings()


def read_morph(assembly) -> Morph:
    """Read an assembly from its document. Raises MorphError if a part has no usable mesh."""
    members = Members(assembly)
    rests = {part.Name: read_rest(part) for part in members.parts}
    ids = {name: rest.file_ids() for name, rest in rests.items()}
    names = recipes.names_of(members)
    recipe, pose = recipes.recipe_of(members, ids), recipes.pose_of(members, names)
    objects = recipes.objects_of(members)
    return Morph(recipe, pose, rests, names, objects, ignored_in(members))


def ignored_in(members: Members) -> tuple[str, ...]:
    """Return the labels of the regions and contacts that have lost a part."""
    regions = [region.Label for region in members.regions if region.Part is None]
    contacts = [
        contact.Label
        for contact in members.contacts
        if not recipes.has_both_parts(contact, members.parts)
    ]
    return tuple(regions + contacts)


class SessionCache:
    """The latest sessions and answers of one assembly, found by content.

    It is thread-safe. Sessions are built and poses are solved outside of the lock.
    """

    KEPT = 2

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._outcomes: OrderedDict[tuple, Outcome] = OrderedDict()
        self._coming: dict[tuple, Future] = {}  # computed in a background thread
        self._sessions: OrderedDict[str, Any] = OrderedDict()
        self._results: OrderedDict[tuple, Any] = OrderedDict()
        self._refused: OrderedDict[str, ValueError] = OrderedDict()
        self._writers: dict[str, conversion.MeshWriter] = {}

    def session(self, morph: Morph):
        """Return the sheetmorph.Session of `morph` from the cache, or build it.

        Errors are cached too, because a large morph takes as long to fail as to succeed.
        """
        with faults.named(morph.objects):
            return self._found(morph)

    def _found(self, morph: Morph):
        key = morph.key
        with self._lock:
            if key in self._refused:
                raise self._refused[key].with_traceback(None)
            if key in self._sessions:
                self._sessions.move_to_end(key)
                return self._sessions[key]
        try:
            built = self._built(morph)
        except ValueError as error:
            self._keep(self._refused, key, error)
            raise
        self._keep(self._sessions, key, built)
        return built

    def _built(self, morph: Morph):
        package = kernel.load()
        meshes = {
            morph.names[name]: package.PartMesh(
                rest.points, rest.triangles, ids=rest.ids, name=rest.label
            )
            for name, rest in morph.rests.items()
        }
        recipe = {**morph.recipe, "pose": {}}
        with self._lock:
            previous = next(reversed(self._sessions.values()), None)
        return reporting.waited_for(
            lambda told: package.Session(recipe, meshes, told, previous=previous)
        )

    def result(self, morph: Morph, exact: bool = True):
        """Return the sheetmorph.Result of `morph` in its pose from the cache, or solve it."""
        key = (morph.key, repr(morph.pose), exact)
        with self._lock:
            if key in self._results:
                self._results.move_to_end(key)
                return self._results[key]
        solve = self.session(morph).deform
        with faults.named(morph.objects):
            found = reporting.waited_for(lambda told: solve(morph.pose, exact, told))
        self._keep(self._results, key, found)
        return found

    def remember(self, morph: Morph, pose: dict, result: Any) -> None:
        """Cache an exact sheetmorph.Result in another pose, with all data for a recompute in it."""
        posed = replace(morph, pose=pose)
        self._keep(self._results, (morph.key, repr(pose), True), result)
        self._solved(posed)

    def positions(self, morph: Morph, exact: bool = True) -> dict[str, np.ndarray]:
        """Return global positions (n, 3) by object name; those at rest without prescribed ones."""
        if not morph.is_held():
            return {name: rest.points for name, rest in morph.rests.items()}
        found = self.result(morph, exact).positions
        return {name: found[morph.names[name]] for name in morph.rests}

    def recomputed(self, assembly) -> Outcome:
        """Solve `assembly`, None for an orphaned deformation, and show the findings."""
        if assembly is None:
            return Outcome(failure=Fault(ORPHANED))
        outcome = self.solve(assembly)
        show(assembly, outcome)
        return outcome

    def solve(self, assembly) -> Outcome:
        """Read and solve `assembly`; the outcome contains errors."""
        try:
            morph = read_morph(assembly)
        except FAILURES as error:
            return failed(error)
        return self.outcome(morph)

    def is_known(self, morph: Morph) -> bool:
        """Return whether the answer of `morph` is cached, so that a recompute need not solve."""
        with self._lock:
            return morph.answer_key in self._outcomes

    def outcome(self, morph: Morph) -> Outcome:
        """Return the answer of `morph`: cached, from a running thread, or solved now."""
        with self._lock:
            kept = self._outcomes.get(morph.answer_key)
            coming = self._coming.get(morph.answer_key)
        if kept is None and coming is not None:
            kept = reporting.waited_for(lambda progress: awaited(coming, progress))
        if kept is None:
            return self._solved(morph)
        if kept.failure:
            return kept
        status = status_of(morph, kept.findings)
        return replace(kept, morph=morph, status=status)

    def compute(self, morph: Morph, goes_on: reporting.Progress) -> Outcome:
        """Compute an outcome in a background thread; other callers wait for it.

        Raises Cancelled of the kernel when `goes_on(fraction, task)` returns False.
        """
        coming: Future = Future()
        with self._lock:
            self._coming[morph.answer_key] = coming
        found = None
        try:
            with reporting.told_to(goes_on):
                found = self._solved(morph)
        finally:
            with self._lock:
                del self._coming[morph.answer_key]
            coming.set_result(found)
        return found

    def _solved(self, morph: Morph) -> Outcome:
        try:
            positions, found = self.positions(morph), self.findings(morph)
        except FAILURES as error:
            if kernel.is_available() and isinstance(error, kernel.core().Cancelled):
                if threading.current_thread() is not threading.main_thread():
                    raise
                return failed(error)
            outcome = failed(error)
        else:
            outcome = Outcome(Fault(""), status_of(morph, found), morph, positions, found)
        self._keep(self._outcomes, morph.answer_key, outcome)
        return outcome

    def findings(self, morph: Morph) -> Findings:
        """Return the findings of a recompute; empty if no vertex is prescribed."""
        if not morph.is_held():
            return Findings()
        session, result = self.session(morph), self.result(morph)
        found = reporting.waited_for(lambda _told: findings_of(session, result, morph.objects))
        return replace(found, unsettled=unsettled_words(result))

    def steps(self, morph: Morph) -> list[Step]:
        """Return the parts in the order of propagation; empty if no vertex is prescribed."""
        if not morph.is_held():
            return []
        parts = {morph.names[name]: name for name in morph.rests}
        return steps_of(self.session(morph), parts, morph.contacts)

    def control_mesh(self, morph: Morph, contact: str | None) -> ControlMesh | None:
        """Return the control mesh of a contact, by object name, in the pose of `morph`."""
        if not morph.is_held():
            return None
        return shown_control_mesh(self.result(morph), morph, contact)

    def mesh(self, outcome: Outcome, part):
        """Return the FreeCAD mesh of `part` in an outcome. Raises MorphError if it failed."""
        if outcome.failure:
            raise MorphError(outcome.failure)
        rest = outcome.morph.rests.get(part.Name)
        if rest is None:
            raise MorphError(
                f"Part '{part.Label}' is not in a morph: drag it back into its group.", part
            )
        kept = self._writers.get(part.Name)
        if kept is None or not np.array_equal(kept.triangles, rest.triangles):
            kept = self._writers[part.Name] = conversion.MeshWriter(rest.triangles)
        local = rest.frame.to_local(outcome.positions[part.Name])
        return kept.mesh(local, conversion.result_placement(part))

    def _keep(self, store: OrderedDict, key, value) -> None:
        with self._lock:
            store[key] = value
            store.move_to_end(key)
            while len(store) > self.KEPT:
                store.popitem(last=False)


def awaited(coming: Future, progress: reporting.Progress | None) -> Outcome | None:
    """Return the result of another thread, or None if it was cancelled."""
    while not wait([coming], timeout=LOOK).done:
        if progress is not None and not progress(0.0, ""):
            raise kernel.core().Cancelled("Cancelled while another thread computes this shape.")
    return coming.result()


def failed(error: Exception) -> Outcome:
    """Return the outcome of a morph that cannot be solved."""
    fault = faults.fault_of(error)
    return Outcome(failure=fault, status=str(fault))


def status_of(morph: Morph, found: Findings) -> str:
    """Return the status of a solved morph in one or two sentences."""
    if not morph.rests:
        return "Add a part."
    if not morph.is_held():
        return "At rest: mark a fixed region and a handle."
    notes = []
    if morph.ignored:
        notes.append(f"Ignored, because they have no part: {', '.join(morph.ignored)}.")
    if found.unreached:
        notes.append(
            "No contact reaches these parts, so they stay at rest: "
            f"{', '.join(found.unreached)}."
        )
    if found.unsettled:
        notes.append(f"Not converged: {found.unsettled} Turn the handles less.")
    return " ".join(notes) or "Up to date."


def tell_status(assembly, status: str) -> None:
    """Show a status for a morph whose parts have no final shape yet."""
    set_where_new(assembly, "Status", status)


def make_due(assembly) -> None:
    """Touch the deformation, so that the next recompute updates the parts."""
    deformation_of(assembly).touch()


@faults.as_morph_errors()
def deform(assembly, exact: bool = True) -> dict[str, np.ndarray]:
    """Return global positions (n, 3), mm, of every part by object name. Raises MorphError."""
    found = cache_of(assembly).positions(read_morph(assembly), exact)
    return {name: np.array(points) for name, points in found.items()}


@faults.as_morph_errors()
def deform_in(assembly, moved: Pose) -> dict[str, np.ndarray]:
    """Return positions as `deform` does, with other motions of some regions. Raises MorphError."""
    cache, morph = cache_of(assembly), read_morph(assembly)
    pose = {**morph.pose, **{morph.names[name]: motion for name, motion in moved.items()}}
    found = cache.positions(replace(morph, pose=pose))
    return {name: np.array(points) for name, points in found.items()}


def unsettled_words(result) -> str:
    """Return sentences on solves of a sheetmorph.Result that did not converge."""
    return " ".join(f"'{part}': {text}." for part, text in result.unsettled.items())


def shown_control_mesh(result, morph: Morph, contact: str | None) -> ControlMesh | None:
    """Return a contact's control mesh in a sheetmorph.Result, by object name, or the single one."""
    if contact is None:
        return result.control_mesh(None)
    used = {entry["name"] for entry in morph.recipe["contacts"]}
    name = morph.names.get(contact)
    return result.control_mesh(name) if name in used else None


@faults.as_morph_errors()
def steps(assembly) -> list[Step]:
    """Return the parts in the order of propagation. Raises MorphError."""
    return cache_of(assembly).steps(read_morph(assembly))


@faults.as_morph_errors()
def control_mesh(assembly, contact=None) -> ControlMesh | None:
    """Return the control mesh of a contact in the document's pose, global. Raises MorphError."""
    name = None if contact is None else contact.Name
    return cache_of(assembly).control_mesh(read_morph(assembly), name)


def cache_of(obj) -> SessionCache:
    """Return the cache of the assembly that is or contains `obj`. Raises MorphError."""
    assembly = assembly_of(obj)
    deformation = deformation_of(assembly) if assembly is not None else None
    if deformation is None:
        raise MorphError(
            f"'{obj.Label}' is not a complete morph: pass another one, or undo a deletion in it."
        )
    return deformation.Proxy.cache()
