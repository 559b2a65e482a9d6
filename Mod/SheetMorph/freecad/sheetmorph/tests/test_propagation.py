# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the motion reaches the other parts: order, modes, control meshes, live and rebuilt."""

import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import live_session, solving
from freecad.sheetmorph.tests import support


class ChainTest(support.DocumentTest):
    """Three strips edge to edge: the first is the primary, each welded to the one before."""

    def setUp(self):
        super().setUp()
        self.assembly, self.handle, self.first = self.add_pair()
        self.third = self.add_second(self.assembly, (0.0, 180.0, 2.0), "Third")
        self.part, self.second, _ = objects.parts(self.assembly)
        sides = (self.second, self.third)
        touching = zip(sides, api.touching_vertices(*sides, 1.5))
        self.last = api.add_contact(self.assembly, *touching, label="Last weld")
        api.set_motion(self.handle, (0, 0, 40))

    def positions(self, part) -> np.ndarray:
        return api.deform(self.assembly)[part.Name]

    def moved(self, part) -> float:
        return support.largest(self.positions(part) - api.rest_mesh(part)[0])


class TestWarnings(ChainTest):
    def test_a_contact_that_opens_too_far_says_so_until_it_does_not(self):
        api.set_motion(self.handle, (0, 0, 5))
        self.assembly.Document.recompute()
        self.assertEqual(self.first.Warning + self.last.Warning, "")
        api.set_motion(self.handle, (0, 0, 400))
        self.assembly.Document.recompute()
        self.assertTrue(self.first.Warning or self.last.Warning, "a control mesh opens")
        opened = self.first if self.first.Warning else self.last
        self.assertIn("make it tied or rigid", opened.Warning)
        self.assertIn(opened.Label, opened.Warning)
        for contact in (self.first, self.last):
            api.set_contact_type(contact, "rigid")
        self.assembly.Document.recompute()
        self.assertEqual(self.first.Warning + self.last.Warning, "")


class TestOrder(ChainTest):
    def test_every_part_follows_and_the_rows_say_along_what(self):
        for part in (self.part, self.second, self.third):
            self.assertGreater(self.moved(part), 20.0, part.Label)
        rows = [tuple(step) for step in api.propagation(self.assembly)]
        self.assertEqual(
            rows, [(self.part, 0, []), (self.second, 1, [self.first]), (self.third, 2, [self.last])]
        )
        self.document.recompute()
        self.assertEqual(list(self.assembly.Order), ["Strip", "Second", "Third"])
        self.assertEqual(list(self.assembly.Unreached), [])
        self.assertEqual(self.assembly.Status, "Up to date.")

    def test_a_suppressed_contact_leaves_all_behind_it_at_rest_and_lists_them(self):
        api.set_motion(self.handle, (0, 0, 40))
        self.document.recompute()
        self.assertGreater(self.first.Deviation.Value, 0.0)
        api.set_active(self.first, False)
        self.document.recompute()
        self.assertEqual(list(self.assembly.Order), ["Strip"])
        self.assertEqual(sorted(self.assembly.Unreached), ["Second", "Third"])
        self.assertIn("Second, Third", self.assembly.Status)
        self.assertEqual((self.first.Deviation.Value, self.last.Deviation.Value), (0.0, 0.0))
        self.assertEqual((self.moved(self.second), self.moved(self.third)), (0.0, 0.0))
        rows = [tuple(step) for step in api.propagation(self.assembly)]
        self.assertEqual(rows[1:], [(self.second, -1, []), (self.third, -1, [])])

    def test_another_primary_turns_the_order_round(self):
        for region in objects.regions(self.assembly, self.part):
            api.remove(region)
        points, _ = support.strip()
        api.add_fixed(self.assembly, self.third, support.left_edge(points))
        handle = api.add_handle(self.assembly, self.third, support.right_edge(points))
        api.set_motion(handle, (0, 0, 40))
        api.set_primary(self.assembly, self.third)
        rows = api.propagation(self.assembly)
        self.assertEqual([row.part for row in rows], [self.third, self.second, self.part])
        self.assertGreater(self.moved(self.part), 10.0)

    def test_a_ring_uses_every_contact(self):
        fourth = self.add_second(self.assembly, (0.0, 90.0, 3.0), "Fourth")
        welds = []
        for part, reach in ((self.part, 3.5), (self.third, 1.5)):
            sides = (part, fourth)
            touching = zip(sides, api.touching_vertices(*sides, reach))
            welds.append(api.add_contact(self.assembly, *touching))
        rows = {row.part.Name: row for row in api.propagation(self.assembly)}
        driving = [contact for row in rows.values() for contact in row.contacts]
        self.assertEqual(len(driving), 4)
        self.assertEqual(set(driving), {self.first, self.last, *welds})

    def test_nothing_propagates_before_something_is_held(self):
        assembly = api.create_assembly(self.document, "Empty")
        api.add_part(assembly, self.add_source("Other"))
        self.assertEqual(api.propagation(assembly), [])
        self.assertIsNone(api.control_mesh(assembly))


class TestModes(ChainTest):
    def test_modes_by_number_and_by_name(self):
        for mode, name in (
            (0, "automatic"),
            (1, "1 all by control mesh"),
            (2, "2 regions"),
            (3, "3 boundaries"),
        ):
            api.set_mode(self.third, mode)
            self.assertEqual(self.third.Mode, name)
            api.set_mode(self.second, name)
            self.assertEqual(self.second.Mode, name)
        for nonsense in (4, -1, "2", 1.5, None):
            with self.subTest(nonsense), self.assertRaisesRegex(ValueError, "1, 2, 3, or 0"):
                api.set_mode(self.third, nonsense)

    def test_a_change_of_mode_changes_the_mesh(self):
        self.document.recompute()
        shown = {}
        for mode in (1, 2, 3):
            api.set_mode(self.third, mode)
            self.document.recompute()
            self.assert_up_to_date(self.document)
            shown[mode] = support.seen_points(self.third)
        self.assertGreater(support.largest(shown[1] - shown[2]), 1e-3)
        self.assertGreater(support.largest(shown[3] - shown[2]), 1e-3)

    def test_a_follower_goes_with_the_control_mesh(self):
        points, _ = support.strip()
        far = np.flatnonzero(points[:, 1] > 95)
        before = self.positions(self.third)
        follower = api.add_follower(self.assembly, self.third, far, "Rim")
        self.assertEqual((follower.Role, follower.Label), ("follower", "Rim"))
        after = self.positions(self.third)
        api.set_mode(self.third, 1)
        all_by_mesh = self.positions(self.third)[far]
        off_before = support.largest(before[far] - all_by_mesh)
        off_after = support.largest(after[far] - all_by_mesh)
        self.assertLess(off_after, 0.01 * off_before)

    def test_settings_of_the_propagation(self):
        before = self.positions(self.third)
        api.set_propagation(self.assembly, "local", levels=2, smoothness=0.5)
        self.assertEqual((self.assembly.Levels, self.assembly.Smoothness), (2, 0.5))
        self.assertGreater(support.largest(self.positions(self.third) - before), 1e-6)
        api.set_propagation(self.assembly, "local")
        self.assertEqual((self.assembly.Levels, self.assembly.Smoothness), (2, 0.5))
        for words, arguments, keywords in (
            ("round", ("round",), {}),
            ("1 to 5", ("local",), {"levels": 0}),
            ("1 to 5", ("local",), {"levels": 2.5}),
            ("above 0", ("local",), {"smoothness": 0}),
            ("finite", ("local",), {"smoothness": float("nan")}),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.set_propagation(self.assembly, *arguments, **keywords)
        self.assertEqual((self.assembly.Levels, self.assembly.Smoothness), (2, 0.5))


class TestWhole(ChainTest):
    def test_all_parts_in_one_solve_are_held_by_what_is_held_on_any(self):
        rest = api.rest_mesh(self.third)[0]
        far = np.flatnonzero(rest[:, 1] > rest[:, 1].max() - 1.0)
        api.add_fixed(self.assembly, self.third, far)
        api.set_propagation(self.assembly, "whole")
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertLess(support.largest(self.positions(self.third)[far] - rest[far]), 1e-9)
        self.assertGreater(self.moved(self.second), 5.0)
        for contact in (self.first, self.last):
            self.assertLess(contact.GapChange.Value, 0.5)
        self.assertIsNone(api.control_mesh(self.assembly, self.first))
        live = live_session.LiveSession(self.assembly)
        shown = support.live_positions(live, {self.handle.Name: {"translation": [0.0, 0.0, 40.0]}})
        off = shown[self.second.Name] - self.positions(self.second)
        self.assertLess(support.largest(off), 1e-3)


class TestControlMesh(ChainTest):
    def assert_closed(self, mesh) -> None:
        vertices, triangles = mesh
        self.assertEqual((vertices.shape[1], triangles.shape[1]), (3, 3))
        edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        self.assertEqual({(b, a) for a, b in edges.tolist()}, set(map(tuple, edges.tolist())))

    def test_each_contact_has_one_that_goes_with_the_pose(self):
        moved = api.control_mesh(self.assembly, self.first)
        self.assert_closed(moved)
        api.reset_motion(self.handle)
        rest = api.control_mesh(self.assembly, self.first)
        self.assertGreater(support.largest(moved[0] - rest[0]), 5.0)
        side = api.rest_mesh(self.part)[0][api.contact_vertices(self.first, "a")]
        self.assertTrue(np.all(side.min(axis=0) >= rest[0].min(axis=0)))
        self.assertTrue(np.all(side.max(axis=0) <= rest[0].max(axis=0)))

    def test_other_contacts_have_none(self):
        api.set_contact_type(self.first, "tied")
        self.assertIsNone(api.control_mesh(self.assembly, self.first))
        api.set_active(self.last, False)
        self.assertIsNone(api.control_mesh(self.assembly, self.last))
        self.assertIsNone(api.control_mesh(self.assembly))
        other = api.create_assembly(self.document, "Other")
        with self.assertRaisesRegex(ValueError, "not in 'Other'"):
            api.control_mesh(other, self.last)

    def test_the_single_one_is_around_everything(self):
        api.set_propagation(self.assembly, "single")
        api.reset_motion(self.handle)
        mesh = api.control_mesh(self.assembly)
        self.assert_closed(mesh)
        for part in objects.parts(self.assembly):
            points, _ = api.rest_mesh(part)
            self.assertTrue(np.all(points.min(axis=0) >= mesh[0].min(axis=0) - 1e-9))
            self.assertTrue(np.all(points.max(axis=0) <= mesh[0].max(axis=0) + 1e-9))
        self.assertIsNone(api.control_mesh(self.assembly, self.first))

    def test_it_follows_a_drag(self):
        live = live_session.LiveSession(self.assembly)
        at_start = live.control_mesh(self.last)[0] - api.control_mesh(self.assembly, self.last)[0]
        self.assertLess(support.largest(at_start), 1e-3)
        support.live_positions(
            live, {self.handle.Name: {"translation": [0.0, 0.0, 80.0]}}, exact=True
        )
        dragged = live.control_mesh(self.last)
        api.set_motion(self.handle, (0, 0, 80))
        expected = api.control_mesh(self.assembly, self.last)
        self.assertLess(support.largest(dragged[0] - expected[0]), 1e-6)
        api.set_active(self.last, False)
        self.assertIsNone(live_session.LiveSession(self.assembly).control_mesh(self.last))


class TestRebuild(ChainTest):
    def stages(self) -> list[str]:
        """Return what the latest session computed and did not take over."""
        cache = solving.cache_of(self.assembly)
        return list(cache.session(solving.read_morph(self.assembly)).timings)

    def test_a_change_of_one_contact_rebuilds_only_what_depends_on_it(self):
        api.deform(self.assembly)
        everything = self.stages()
        api.set_contact_vertices(self.last, "b", api.contact_vertices(self.last, "b")[2:])
        found = self.positions(self.third)
        self.assertLess(len(self.stages()), len(everything))
        self.assertFalse([stage for stage in self.stages() if "Strip" in stage])
        solving.cache_of(self.assembly).__init__()
        np.testing.assert_array_equal(self.positions(self.third), found)
        self.assertEqual(len(self.stages()), len(everything))

    def test_a_session_taken_over_gives_the_same_as_a_new_one(self):
        for change in (
            lambda: api.set_mode(self.third, 1),
            lambda: api.set_contact_type(self.first, "tied"),
            lambda: api.set_active(self.last, False),
            lambda: api.set_active(self.last, True),
            lambda: api.set_propagation(self.assembly, "single"),
            lambda: api.set_propagation(self.assembly, "local", levels=2),
            lambda: api.set_energy(self.assembly, "paper"),
        ):
            change()
            found = api.deform(self.assembly)
            solving.cache_of(self.assembly).__init__()
            for name, expected in api.deform(self.assembly).items():
                np.testing.assert_array_equal(found[name], expected)


if __name__ == "__main__":
    unittest.main()
