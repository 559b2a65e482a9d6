# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a welded part does: gaps, holes, and parts placed anywhere."""

import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.tests import support


def edge_errors(rest: np.ndarray, moved: np.ndarray) -> float:
    """Return how much the largest distance between any two points changed, mm."""
    before = np.linalg.norm(rest[:, None] - rest[None], axis=2)
    after = np.linalg.norm(moved[:, None] - moved[None], axis=2)
    return support.largest(after - before)


class TestTypes(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.handle, self.contact = self.add_pair()
        self.second = objects.parts(self.assembly)[1]
        api.set_motion(self.handle, (0, 0, 40), (0, 1, 0), -10)

    def gap_change(self, type: str) -> float:
        api.set_contact_type(self.contact, type)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        return self.contact.GapChange.Value

    def test_a_rigid_weld_keeps_its_gap_to_rounding(self):
        # Right beside the weld the sheets bend, which its border sees.
        self.assertLess(self.gap_change("rigid"), 0.005)
        self.assertLess(self.contact.Deviation.Value, 1e-10)

    def test_a_tied_weld_keeps_its_gap_to_a_millionth_of_the_size(self):
        self.assertLess(self.gap_change("tied"), 1e-6 * 350)
        self.assertGreater(self.contact.Deviation.Value, 0.1)

    def test_a_control_mesh_keeps_its_gap_to_half_a_percent_of_the_region(self):
        self.assertLess(self.gap_change("control mesh"), 0.005 * 220)


class TestHoles(support.DocumentTest):
    def test_holes_under_a_contact_stay_round_on_both_sides(self):
        assembly, part, handle = self.add_morph()
        second = self.add_second(assembly, (0.0, 0.0, 1.0))
        rims = api.hole_rims(part)
        holes = [
            api.add_feature(assembly, owner, rim, "Hole")
            for owner in (part, second)
            for rim in rims
        ]
        # Each weld covers a hole and two rings around it, as a washer does.
        wide = [api.hole_rim(part, rim[0], rings=2) for rim in rims]
        for ring in wide:
            api.add_contact(assembly, (part, ring), (second, ring), label="Bolt")
        api.set_motion(handle, (0, 0, 40), (0, 1, 0), -20)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        found = api.deform(assembly)
        for hole in holes:
            rest, _ = api.rest_mesh(hole.Part)
            ids = api.vertices(hole)
            self.assertLess(edge_errors(rest[ids], found[hole.Part.Name][ids]), 1e-9)
        top, bottom = (found[p.Name] for p in (second, part))
        for contact, ring in zip(objects.contacts(assembly), wide):
            gap = np.linalg.norm(top[ring] - bottom[ring], axis=1)
            self.assertLess(support.largest(gap - 1.0), 0.5)
            self.assertLess(contact.GapChange.Value, 0.5)
        self.assertGreater(top[:, 2].max(), 30.0)


class TestPlacements(support.DocumentTest):
    def test_parts_moved_in_a_moved_container_morph_as_where_they_were_made(self):
        assembly, handle, contact = self.add_pair()
        api.set_motion(handle, (0, 0, 40), (0, 1, 0), -10)
        expected = api.deform(assembly)
        part, second = objects.parts(assembly)
        outer = support.placement((500, -40, 70), (1, 2, 3), 75)
        inner = support.placement((0, 10, -300), (3, -1, 0), 40)
        container = self.document.addObject("App::Part", "Container")
        for member in (part, second):
            container.addObject(member.Source)
            member.Source.Placement = inner
        container.Placement = outer
        motion = support.matrix(outer.multiply(inner))
        turn = motion[:3, :3]
        api.set_motion(handle, turn @ (0, 0, 40), turn @ (0, 1, 0), -10)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(list(assembly.Unreached), [])
        self.assertLess(contact.GapChange.Value, 1.0)
        for member in (part, second):
            wanted = expected[member.Name] @ turn.T + motion[:3, 3]
            self.assertLess(support.largest(support.seen_points(member) - wanted), 1e-3)
            self.assertLess(support.largest(api.deform(assembly)[member.Name] - wanted), 1e-4)

    def test_a_part_moved_away_from_its_weld_still_follows_it(self):
        assembly, handle, contact = self.add_pair()
        second = objects.parts(assembly)[1]
        second.Source.Placement = support.placement((0, 0, 25))
        api.set_motion(handle, (0, 0, 40))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        moved = support.seen_points(second) - api.rest_mesh(second)[0]
        self.assertGreater(support.largest(moved), 20.0)
        self.assertEqual(contact.PartB, second)


if __name__ == "__main__":
    unittest.main()
