# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheet as steel in documents: the energy, its thickness, previews, and blanks."""

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.bridge import live_session
from freecad.sheetmorph.tests.support import DocumentTest, left_edge, right_edge, strip


class TestSteel(DocumentTest):
    def setUp(self) -> None:
        super().setUp()
        self.points, self.triangles = strip()
        self.assembly = api.create_assembly(self.document)
        source = self.add_source(mesh=(self.points, self.triangles))
        self.part = api.add_part(self.assembly, source)
        api.add_fixed(self.assembly, self.part, left_edge(self.points))
        self.handle = api.add_handle(self.assembly, self.part, right_edge(self.points))
        api.set_energy(self.assembly, "steel")
        self.length = float(np.ptp(self.points[:, 0]))
        self.turn = np.pi / 3.0
        radius = self.length / self.turn
        shift = (radius * np.sin(self.turn) - self.length, 0, radius * (1 - np.cos(self.turn)))
        api.set_motion(self.handle, shift, axis=(0, -1, 0), angle=60)
        self.document.recompute()

    def stretch(self, positions: np.ndarray) -> float:
        sides = np.vstack([self.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
        before = np.linalg.norm(self.points[sides[:, 0]] - self.points[sides[:, 1]], axis=1)
        after = np.linalg.norm(positions[sides[:, 0]] - positions[sides[:, 1]], axis=1)
        return float(np.abs(after / before - 1.0).max())

    def test_a_strip_is_bent_without_stretch(self):
        self.assertLess(self.stretch(api.deform(self.assembly)[self.part.Name]), 0.01)

    def test_its_thickness_is_part_of_the_recipe(self):
        api.set_sheet(self.part, 1.5, 0.25)
        recipe = live_session.read_morph(self.assembly).recipe
        self.assertEqual(recipe["parts"][0]["thickness"], 1.5)
        self.assertEqual(recipe["parts"][0]["poisson"], 0.25)
        with self.assertRaises(ValueError):
            api.set_sheet(self.part, -1.0)
        with self.assertRaises(ValueError):
            api.set_sheet(self.part, 1.0, 0.7)

    def test_live_frames_are_previews_and_an_exact_one_gives_way_to_a_drag(self):
        live = live_session.LiveSession(self.assembly)
        self.assertTrue(live.answer(live.ask()).is_preview)
        exact = live.answer(live.ask(exact=True))
        self.assertFalse(exact.is_preview)
        given_up = live.answer(live.ask(exact=True), lambda _fraction, _task: False)
        self.assertTrue(given_up.is_preview)
        self.assertFalse(given_up.question.is_exact)

    def test_a_bent_strip_comes_back_to_its_blank(self):
        (sketch,) = api.flatten(self.part)
        self.document.recompute()
        box = sketch.Shape.BoundBox
        width = float(np.ptp(self.points[:, 1]))
        self.assertAlmostEqual(box.XLength, self.length, delta=2e-3 * self.length)
        self.assertAlmostEqual(box.YLength, width, delta=5e-3 * width)
