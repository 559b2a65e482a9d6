# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dragging: positions for the screen without touching the document."""

import gc
import threading
import unittest

import numpy as np

from freecad.sheetmorph import api, reporting
from freecad.sheetmorph.bridge import live_session, solving
from freecad.sheetmorph.interaction.frame_worker import FrameWorker
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.errors import FLIPPED
from freecad.sheetmorph.tests import support
from freecad.sheetmorph.tools.motion import Motion, Moving


class TestLive(support.DocumentTest):
    def setUp(self):
        super().setUp()
        source = self.add_source()
        source.Placement = support.placement((500, -40, 70), (1, 2, 3), 75)
        self.assembly, self.part, self.handle = self.add_morph(source)
        self.document.recompute()
        self.live = live_session.LiveSession(self.assembly)

    def test_positions_are_local_and_become_those_of_the_recompute(self):
        api.set_motion(self.handle, (1, 2, 30), (0, 1, 0), 20)
        dragged = support.live_positions(self.live)[self.part.Name]
        exact = support.live_positions(self.live, exact=True)[self.part.Name]
        self.document.recompute()
        shown = support.local_points(self.part)
        self.assertLess(support.largest(dragged - shown), 1e-3)
        self.assertLess(support.largest(exact - shown), 1e-4)

    def test_overrides_replace_the_pose_of_the_document(self):
        moved = {self.handle.Name: Motion((0.0, 0.0, 30.0))}
        dragged = support.live_positions(self.live, moved)[self.part.Name]
        self.assertEqual(self.handle.TranslationZ.Value, 0.0)
        self.assert_up_to_date(self.document)
        api.set_motion(self.handle, (0, 0, 30))
        # Live frames are within a millionth of the size of the exact shape, however they come.
        again = support.live_positions(self.live)[self.part.Name]
        np.testing.assert_allclose(again, dragged, atol=1e-4)

    def test_a_share_is_a_view_on_the_way_from_rest(self):
        api.set_motion(self.handle, (0, 0, 30), (0, 1, 0), 20)
        self.document.recompute()
        stored, rest = support.local_points(self.part), self.live.parts[self.part.Name].points
        self.live.ask()
        frame = self.live.answer(self.live.ask_share(0.25))
        self.assertLess(support.largest(frame.positions[self.part.Name] - rest), 12.0)
        motion = Motion((0.0, 0.0, 7.5), (0.0, 1.0, 0.0), 5.0)
        quarter = support.live_positions(self.live, {self.handle.Name: motion})
        shown = self.live.parts[self.part.Name].frame.to_local(frame.positions[self.part.Name])
        np.testing.assert_allclose(shown, quarter[self.part.Name], atol=1e-3)
        at_rest = self.live.answer(self.live.ask_share(0.0)).positions[self.part.Name]
        np.testing.assert_allclose(at_rest, rest, atol=1e-3)
        np.testing.assert_array_equal(support.local_points(self.part), stored)
        self.assert_up_to_date(self.document)
        self.assertEqual(self.live.ask().share, 1.0)

    def test_triangles_that_flip_are_a_warning_about_their_part(self):
        api.set_motion(self.handle, (0, 0, 0), (0, 0, 1), 175)
        self.document.recompute()
        warned = [w for w in model.warnings_of(self.assembly) if w.code == FLIPPED]
        self.assertEqual([w.objects for w in warned], [(self.part.Name,)])
        api.set_motion(self.handle, (0, 0, 1), (0, 0, 1), 0)
        self.document.recompute()
        self.assertNotIn(FLIPPED, [w.code for w in model.warnings_of(self.assembly)])

    def test_a_drag_and_its_commit_use_one_session(self):
        cache = solving.cache_of(self.assembly)
        before = cache.session(solving.read_morph(self.assembly))
        api.set_motion(self.handle, (0, 0, 30))
        support.live_positions(self.live)
        self.document.recompute()
        self.assertIs(cache.session(solving.read_morph(self.assembly)), before)

    def test_an_exact_frame_is_what_the_recompute_takes(self):
        api.set_motion(self.handle, (0, 0, 30), (0, 1, 0), 15)
        frame = self.live.answer(self.live.ask([self.handle.Name], exact=True))
        cache = solving.cache_of(self.assembly)
        self.assertIs(cache.result(solving.read_morph(self.assembly)), frame.result)
        quick = self.live.answer(self.live.ask([self.handle.Name]))
        self.assertIs(cache.result(solving.read_morph(self.assembly)), frame.result)
        np.testing.assert_allclose(
            quick.positions[self.part.Name], frame.positions[self.part.Name], atol=1e-3
        )

    def test_a_frame_that_is_held_stays_as_it_is(self):
        held = [self._frame_lifted_by(height) for height in (5.0, 10.0, 15.0)]
        copies = [np.array(frame.positions[self.part.Name]) for frame in held]
        for height in (20.0, 25.0, 30.0):
            self._frame_lifted_by(height)
        for frame, copy in zip(held, copies):
            np.testing.assert_array_equal(frame.positions[self.part.Name], copy)

    def test_a_frame_of_a_refined_morph_is_a_preview_until_it_is_exact(self):
        self.assertFalse(self._frame_lifted_by(10.0).is_preview)
        self.assembly.Refine = True
        self.live = live_session.LiveSession(self.assembly)
        self.assertTrue(self._frame_lifted_by(10.0).is_preview)
        exact = self.live.answer(self.live.ask([self.handle.Name], exact=True))
        self.assertFalse(exact.is_preview)
        self.assertEqual(exact.unsettled, "")
        self.assertEqual(self.live.learning_failure, "")

    def test_a_frame_of_a_motion_needs_no_document(self):
        api.set_free_rotation(self.handle, True)
        moving = Moving(lambda name: tuple(api.pivot(self.handle)))
        moving.choose(self.handle.Name, Motion((0.0, 0.0, 30.0), angle=20.0), is_free=True)
        frame = self.live.answer(self.live.follow(moving))
        self.assertEqual(self.handle.TranslationZ.Value, 0.0)
        api.set_motion(self.handle, (0, 0, 30), (0, 0, 1), 20)
        asked = self.live.ask([self.handle.Name])
        self.assertEqual(repr(asked), repr(frame.question), "the recompute finds the answer")

    def _frame_lifted_by(self, height: float):
        api.set_motion(self.handle, (0, 0, height))
        return self.live.answer(self.live.ask([self.handle.Name]))

    def test_the_rest_is_known_in_global_coordinates(self):
        points, triangles = api.rest_mesh(self.part)
        rest = self.live.parts[self.part.Name]
        np.testing.assert_array_equal(rest.points, points)
        np.testing.assert_array_equal(rest.triangles, triangles)

    def test_a_morph_without_regions_is_at_rest(self):
        assembly = api.create_assembly(self.document)
        part = api.add_part(assembly, self.add_source("Other"))
        found = support.live_positions(live_session.LiveSession(assembly))[part.Name]
        self.assertEqual(support.largest(found - support.local_points(part.Source)), 0.0)

    def test_building_a_session_reports_progress_and_can_be_cancelled(self):
        api.add_fixed(self.assembly, self.part, [150])
        with self.assertRaises(solving.MorphError), reporting.told_to(lambda *_: False):
            live_session.LiveSession(self.assembly)
        seen: list[float] = []

        def follow(fraction: float, _task: str) -> bool:
            seen.append(fraction)
            return True

        with reporting.told_to(follow):
            live_session.LiveSession(self.assembly)
        self.assertGreater(len(seen), 0)
        self.assertTrue(all(0.0 <= fraction <= 1.0 for fraction in seen))

    def test_errors_are_one_sentence(self):
        with self.assertRaises(solving.MorphError) as raised:
            support.live_positions(
                self.live, {self.handle.Name: Motion(axis=(0.0, 0.0, 0.0), angle=9.0)}
            )
        self.assertNotIn("\n", str(raised.exception))
        with self.assertRaisesRegex(solving.MorphError, "not a complete morph"):
            live_session.LiveSession(self.part.Source)


class Widget:
    """One of a cycle, as panels leave them; tells in which thread it is destroyed."""

    def __init__(self, destroyed: list):
        self._me, self._destroyed = self, destroyed

    def __del__(self):
        self._destroyed.append(threading.current_thread())


class Listener:
    """Keeps the answers."""

    def __init__(self):
        self.answers: list = []

    def on_answer(self, answer) -> None:
        self.answers.append(answer)


class TestFrameWorker(unittest.TestCase):
    def test_of_what_is_asked_meanwhile_only_the_last_counts(self):
        listener, begun = Listener(), []
        worker = FrameWorker(begun.append, listener)
        self.addCleanup(worker.stop)
        for question in "abc":
            worker.ask(question)
        self.assertFalse(worker.is_free or worker.is_idle)
        worker._deliver("answer to a", "")
        self.assertTrue(worker.is_free and not worker.is_idle)
        worker._deliver("answer to c", "")
        self.assertTrue(worker.is_idle)
        worker._thread.shutdown(wait=True)
        self.assertEqual(begun, ["a", "c"])
        self.assertEqual(listener.answers, ["answer to a", "answer to c"])

    def test_what_a_panel_left_is_never_destroyed_in_another_thread(self):
        destroyed: list = []
        worker = FrameWorker(lambda _question: [[] for _ in range(200_000)], None)
        for _ in range(50):
            Widget(destroyed)
        worker.ask("a question that makes much garbage")
        worker.stop()
        for thread in threading.enumerate():
            if thread is not threading.main_thread():
                thread.join()
        gc.collect()
        self.assertEqual(destroyed, 50 * [threading.main_thread()])

    def test_garbage_is_collected_again_when_the_last_thread_has_ended(self):
        workers = [FrameWorker(lambda question: question, None) for _ in range(2)]
        self.assertFalse(gc.isenabled())
        workers[0].stop()
        workers[0].stop()
        self.assertFalse(gc.isenabled())
        workers[1].stop()
        self.assertTrue(gc.isenabled())


if __name__ == "__main__":
    unittest.main()
