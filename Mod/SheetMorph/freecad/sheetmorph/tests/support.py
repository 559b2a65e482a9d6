# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes and documents for the tests."""

from __future__ import annotations

import os
import tempfile
import unittest
from dataclasses import replace

import FreeCAD
import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import conversion
from freecad.sheetmorph.objects import model

LENGTH, WIDTH = 300.0, 100.0
HOLES = ((75.0, 50.0), (150.0, 50.0), (225.0, 50.0))
ORIGIN = np.zeros(3)


def strip(columns: int = 31, rows: int = 11) -> tuple[np.ndarray, np.ndarray]:
    """Return a flat strip of 300 x 100 mm with three holes of about 20 mm: points, triangles."""
    x, y = np.meshgrid(
        np.linspace(0.0, LENGTH, columns), np.linspace(0.0, WIDTH, rows), indexing="ij"
    )
    points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    index = np.arange(x.size).reshape(columns, rows)
    a, b = index[:-1, :-1].ravel(), index[1:, :-1].ravel()
    c, d = index[1:, 1:].ravel(), index[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    centres = points[triangles].mean(axis=1)[:, :2]
    inside = [np.linalg.norm(centres - hole, axis=1) < 14.0 for hole in HOLES]
    return without_unused(points, triangles[~np.any(inside, axis=0)])


def without_unused(points: np.ndarray, triangles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the same triangles over the points they use, renumbered."""
    used, renumbered = np.unique(triangles, return_inverse=True)
    return points[used], renumbered.reshape(-1, 3).astype(np.int32)


def left_edge(points: np.ndarray) -> list[int]:
    """Return the vertices of the strip's first two columns."""
    return np.flatnonzero(points[:, 0] < 15.0).tolist()


def right_edge(points: np.ndarray) -> list[int]:
    """Return the vertices of the strip's last two columns."""
    return np.flatnonzero(points[:, 0] > LENGTH - 15.0).tolist()


def placement(base, axis=(0, 0, 1), degrees: float = 0.0) -> FreeCAD.Placement:
    """Return a placement from plain numbers."""
    rotation = FreeCAD.Rotation(FreeCAD.Vector(*axis), degrees)
    return FreeCAD.Placement(FreeCAD.Vector(*base), rotation)


def matrix(of: FreeCAD.Placement) -> np.ndarray:
    """Return a placement as a matrix (4, 4)."""
    return np.array(of.toMatrix().A).reshape(4, 4)


def local_points(feature) -> np.ndarray:
    """Return the points (n, 3) a mesh object stores, without any placement."""
    return conversion.read_mesh(feature.Mesh)[0].astype(float)


def seen_points(feature) -> np.ndarray:
    """Return the points (n, 3) of a mesh object where a user sees them."""
    return conversion.frame_of(feature, ORIGIN).to_global(local_points(feature))


def largest(difference: np.ndarray) -> float:
    """Return the largest absolute entry."""
    return float(np.abs(difference).max())


def live_positions(live, moved=None, exact: bool = False) -> dict[str, np.ndarray]:
    """Return the local positions (n, 3) of every part by name, in the pose with other motions."""
    asked = live.ask(moved or (), exact)
    changed = {live.names[name]: motion for name, motion in (moved or {}).items()}
    frame = live.answer(replace(asked, pose={**asked.pose, **changed}))
    return {n: rest.frame.to_local(frame.positions[n]) for n, rest in live.parts.items()}


class DocumentTest(unittest.TestCase):
    """A test with a document of its own, undo switched on, and an empty folder."""

    def setUp(self) -> None:
        self.documents: list[str] = []
        self.document = self.new_document()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def tearDown(self) -> None:
        for name in self.documents:
            if name in FreeCAD.listDocuments():
                FreeCAD.closeDocument(name)

    def new_document(self):
        document = FreeCAD.newDocument("SheetMorphTest")
        document.UndoMode = 1
        self.documents.append(document.Name)
        return document

    def reopen(self, document, name: str = "morph.FCStd"):
        """Save, close and open a document; return it."""
        path = os.path.join(self.folder, name)
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        return self.open(path)

    def open(self, path: str):
        opened = FreeCAD.openDocument(path)
        opened.UndoMode = 1
        self.documents.append(opened.Name)
        return opened

    def add_source(self, label: str = "Sheet", document=None, mesh=None):
        """Add a mesh, by default the strip, and return the object."""
        points, triangles = mesh or strip()
        source = (document or self.document).addObject("Mesh::Feature", "Sheet")
        source.Label = label
        source.Mesh = conversion.MeshWriter(triangles).mesh(points)
        return source

    def add_morph(self, source=None):
        """Return assembly, part and handle: fixed at the left, with a handle at the right."""
        source = source or self.add_source()
        assembly = api.create_assembly(source.Document)
        part = api.add_part(assembly, source, "Strip")
        local = local_points(source)
        api.add_fixed(assembly, part, left_edge(local), "Clamp")
        handle = api.add_handle(assembly, part, right_edge(local), "Tip")
        return assembly, part, handle

    def add_second(self, assembly, offset=(0.0, 90.0, 1.0), label: str = "Second"):
        """Add another strip to a morph, `offset` mm away, and return its part.

        By default it lies on the long edge of the first strip, 1 mm above it.
        """
        points, triangles = strip()
        mesh = (points + offset, triangles)
        source = self.add_source(f"{label} sheet", assembly.Document, mesh=mesh)
        return api.add_part(assembly, source, label)

    def add_pair(self, source=None):
        """Return assembly, handle and contact: `add_morph` and a second strip along its edge.

        The weld ends before the clamp and before the tip, so that it may have any type.
        """
        assembly, part, handle = self.add_morph(source)
        second = self.add_second(assembly)
        touching = api.touching_vertices(part, second, 1.5)
        middle = np.flatnonzero(np.abs(strip()[0][:, 0] - 0.5 * LENGTH) < 110.0)
        sides = [
            (side, np.intersect1d(found, middle)) for side, found in zip((part, second), touching)
        ]
        contact = api.add_contact(assembly, *sides, label="Weld")
        return assembly, handle, contact

    def assert_up_to_date(self, document) -> None:
        """Fail if any object of a document has an error or is due."""
        for obj in document.Objects:
            self.assertNotIn("Invalid", obj.State, f"{obj.Label}: {obj.getStatusString()}")
            if model.kind(obj):
                self.assertEqual(obj.State, ["Up-to-date"], obj.Label)


def write_obj(path: str, points: np.ndarray, triangles: np.ndarray) -> None:
    """Write an OBJ file with every digit of the points, a comment and a group."""
    with open(path, "w", encoding="ascii") as file:
        file.write("# drawn by hand\ng sheet\n")
        file.writelines(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist())
        file.writelines(f"f {a} {b} {c}\n" for a, b, c in (triangles + 1).tolist())


def write_deck(path: str, points: np.ndarray, elements: tuple) -> None:
    """Write a Nastran deck in fixed fields; `elements`: triangles (m, 3) and node ids (n,)."""
    triangles, ids = elements
    with open(path, "w", encoding="ascii") as file:
        file.write("BEGIN BULK\n")
        for name, (x, y, z) in zip(ids, points):
            file.write(f"GRID    {name:8d}{'':8}{x:8.3f}{y:8.3f}{z:8.3f}\n")
        for k, corners in enumerate(ids[triangles], 1):
            fields = "".join(f"{value:8d}" for value in (k, 1, *corners))
            file.write(f"CTRIA3  {fields}\n")
        file.write("ENDDATA\n")
