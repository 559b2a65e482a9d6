# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are moved, also inside moved containers, are deformed where they are seen."""

import unittest

import numpy as np

from freecad.sheetmorph import api
from freecad.sheetmorph.tests import support

LIFT = np.array([0.0, 0.0, 30.0])
TURNED = ((500.0, -40.0, 70.0), (1.0, 2.0, 3.0), 75.0)
CONTAINER = ((-900.0, 200.0, 10.0), (0.0, 1.0, 1.0), -130.0)


class TestPlacements(support.DocumentTest):
    def check_lifted(self, part, handle) -> np.ndarray:
        """Lift a handle by 30 mm along the global z axis; return global positions, checked."""
        document = part.Document
        api.set_motion(handle, LIFT)
        document.recompute()
        self.assert_up_to_date(document)
        self.check_lift(part)
        return support.seen_points(part)

    def check_lift(self, part) -> None:
        """The clamp is seen where it is seen in the source, the tip 30 mm above, globally."""
        source, seen = support.seen_points(part.Source), support.seen_points(part)
        local = support.local_points(part.Source)
        clamp, tip = support.left_edge(local), support.right_edge(local)
        self.assertLess(support.largest(seen[clamp] - source[clamp]), 1e-3)
        self.assertLess(support.largest(seen[tip] - source[tip] - LIFT), 1e-3)

    def inside_container(self, source):
        container = self.document.addObject("App::Part", "Container")
        container.addObject(source)
        container.Placement = support.placement(*CONTAINER)
        return container

    def test_a_moved_source(self):
        source = self.add_source()
        source.Placement = support.placement(*TURNED)
        _, part, handle = self.add_morph(source)
        self.check_lifted(part, handle)

    def test_a_moved_source_inside_a_moved_container(self):
        source = self.add_source()
        source.Placement = support.placement(*TURNED)
        self.inside_container(source)
        _, part, handle = self.add_morph(source)
        self.check_lifted(part, handle)

    def test_nested_containers(self):
        source = self.add_source()
        source.Placement = support.placement(*TURNED)
        outer = self.document.addObject("App::Part", "Outer")
        outer.addObject(self.inside_container(source))
        outer.Placement = support.placement((3, 4, 5), (1, 0, 0), 45)
        _, part, handle = self.add_morph(source)
        self.check_lifted(part, handle)

    def test_a_link_is_refused_in_words(self):
        source = self.add_source("Door")
        link = self.document.addObject("App::Link", "Link")
        link.Label = "Door right"
        link.LinkedObject = source
        assembly = api.create_assembly(self.document)
        for add in (api.add_part, api.add_shape):
            with self.assertRaisesRegex(
                ValueError, "the link 'Door right'.* choose the object 'Door' "
            ):
                add(assembly, link)
        self.assertEqual(api.add_part(assembly, source).Source, source)

    def test_the_morph_in_another_moved_container(self):
        source = self.add_source()
        self.inside_container(source)
        assembly, part, handle = self.add_morph(source)
        other = self.document.addObject("App::Part", "Other")
        other.addObject(assembly)
        other.Placement = support.placement(*TURNED)
        self.check_lifted(part, handle)

    def test_the_morph_in_the_container_of_its_source(self):
        source = self.add_source()
        container = self.inside_container(source)
        assembly, part, handle = self.add_morph(source)
        container.addObject(assembly)
        self.check_lifted(part, handle)
        container.Placement = support.placement(*TURNED)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.check_lift(part)

    def test_a_part_added_to_a_morph_that_is_in_a_container_already(self):
        source = self.add_source()
        container = self.inside_container(source)
        assembly = api.create_assembly(self.document)
        container.addObject(assembly)
        part = api.add_part(assembly, source)
        rest, _ = api.rest_mesh(part)
        local = support.local_points(source)
        api.add_fixed(assembly, part, support.left_edge(local))
        handle = api.add_handle(assembly, part, support.right_edge(local))
        self.assertLess(support.largest(support.seen_points(part) - rest), 1e-3)
        self.check_lifted(part, handle)

    def test_the_part_follows_when_its_source_is_moved(self):
        _, part, handle = self.add_morph()
        self.check_lifted(part, handle)
        part.Source.Placement = support.placement(*TURNED)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.check_lift(part)

    def test_the_part_follows_when_a_container_is_moved(self):
        source = self.add_source()
        outer = self.document.addObject("App::Part", "Outer")
        container = self.inside_container(source)
        outer.addObject(container)
        _, part, handle = self.add_morph(source)
        self.check_lifted(part, handle)
        for moved in (container, outer):
            moved.Placement = support.placement(*TURNED)
            self.document.recompute()
            self.assert_up_to_date(self.document)
            self.check_lift(part)

    def test_a_part_moved_by_hand_comes_back_to_its_source(self):
        _, part, handle = self.add_morph()
        self.check_lifted(part, handle)
        part.Placement = support.placement(*TURNED)
        self.document.recompute()
        self.check_lift(part)

    def test_moving_everything_moves_the_result(self):
        _, part, handle = self.add_morph()
        api.set_motion(handle, (1, 2, 30), (0, 1, 0), 20)
        self.document.recompute()
        expected = support.local_points(part)
        source = self.add_source("Moved")
        moved = support.placement(*TURNED)
        source.Placement = moved
        _, other, grip = self.add_morph(source)
        rotation = support.matrix(moved)[:3, :3]
        api.set_motion(grip, rotation @ (1, 2, 30), rotation @ (0, 1, 0), 20)
        self.document.recompute()
        self.assertLess(support.largest(support.local_points(other) - expected), 1e-4)

    def test_a_part_at_vehicle_coordinates_is_shown_precisely(self):
        points, triangles = support.strip()
        source = self.add_source(mesh=(points, triangles))
        source.Placement = support.placement((2e5, -1e5, 3e5), (0, 0, 1), 30)
        assembly, part, handle = self.add_morph(source)
        self.check_lifted(part, handle)
        self.assertLess(np.abs(support.local_points(part)).max(), 400.0)
        exact = api.deform(assembly)[part.Name]
        self.assertLess(support.largest(support.seen_points(part) - exact), 1e-4)

    def test_global_frame_maps_what_is_drawn_to_what_is_seen(self):
        source = self.add_source()
        source.Placement = support.placement(*TURNED)
        self.inside_container(source)
        _, part, handle = self.add_morph(source)
        seen = self.check_lifted(part, handle)
        rotation, base = api.global_frame(part)
        found = support.local_points(part) @ rotation.T + base
        self.assertLess(support.largest(found - seen), 1e-9)


if __name__ == "__main__":
    unittest.main()
