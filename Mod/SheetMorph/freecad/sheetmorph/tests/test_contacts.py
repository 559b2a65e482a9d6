# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts as document objects: made, changed, refused, undone, saved."""

import unittest

import numpy as np

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.tests import support

ABOVE = (0.0, 90.0, 1.0)


class TestTouching(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.part, _ = self.add_morph()

    def test_the_vertices_of_the_overlap_are_found_on_both_sides(self):
        second = self.add_second(self.assembly)
        points, _ = support.strip()
        of_part, of_second = api.touching_vertices(self.part, second, 1.5)
        self.assertEqual(of_part, np.flatnonzero(points[:, 1] >= 90).tolist())
        self.assertEqual(of_second, np.flatnonzero(points[:, 1] <= 10).tolist())

    def test_the_distance_is_to_the_surface_not_to_vertices(self):
        second = self.add_second(self.assembly, (5.0, 95.0, 1.0))
        of_part, of_second = api.touching_vertices(self.part, second, 1.01)
        points, _ = support.strip()
        # The outermost vertices are above the sheet, but 7 mm from any of its vertices.
        self.assertEqual(
            of_second, np.flatnonzero((points[:, 1] < 5) & (points[:, 0] < 296)).tolist()
        )
        self.assertTrue(all(points[v, 1] == 100 for v in of_part))

    def test_placements_count_and_far_parts_do_not_touch(self):
        second = self.add_second(self.assembly)
        expected = api.touching_vertices(self.part, second, 1.5)
        turned = support.placement((500, -40, 70), (1, 2, 3), 75)
        self.part.Source.Placement = turned
        self.assertEqual(api.touching_vertices(self.part, second, 1.5), ([], []))
        second.Source.Placement = turned
        self.assertEqual(api.touching_vertices(self.part, second, 1.5), expected)

    def test_nonsense_is_refused(self):
        second = self.add_second(self.assembly)
        for a, b, distance, words in (
            (self.part, self.part, 1.0, "two parts"),
            (self.part, second, -1.0, "zero or more"),
            (self.part, second, float("nan"), "finite"),
            (self.part.Source, second, 1.0, "not a SheetMorph part"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.touching_vertices(a, b, distance)


class TestContact(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.handle, self.contact = self.add_pair()
        self.part, self.second = objects.parts(self.assembly)

    def test_it_knows_its_sides_and_lies_in_the_morph(self):
        self.assertEqual(objects.contacts(self.assembly), [self.contact])
        self.assertEqual(objects.contacts(self.assembly, self.second), [self.contact])
        self.assertEqual(objects.kind(self.contact), "SheetMorph::Contact")
        self.assertEqual(objects.assembly_of(self.contact), self.assembly)
        self.assertNotIn(self.contact, objects.regions(self.assembly))
        self.assertEqual((self.contact.PartA, self.contact.PartB), (self.part, self.second))
        self.assertEqual((self.contact.Type, self.contact.Active), ("control mesh", True))
        touching = api.touching_vertices(self.part, self.second, 1.5)
        for side, vertices in zip("ab", touching):
            found = api.contact_vertices(self.contact, side)
            self.assertEqual(found, sorted(set(found) & set(vertices)))
            self.assertEqual(len(found), 42)

    def test_type_activity_and_vertices_change(self):
        api.set_contact_type(self.contact, "tied")
        api.set_active(self.contact, False)
        api.set_contact_vertices(self.contact, "b", [5, 3, 5])
        self.assertEqual((self.contact.Type, self.contact.Active), ("tied", False))
        self.assertEqual(api.contact_vertices(self.contact, "b"), [3, 5])

    def test_nonsense_is_refused_and_changes_nothing(self):
        one, other = (self.part, [1]), (self.second, [2])
        stranger = api.create_assembly(self.document, "Other")
        before = [obj.Name for obj in self.document.Objects]
        for words, call in (
            ("sides of two parts", lambda: api.add_contact(self.assembly, one, one)),
            ("glued", lambda: api.add_contact(self.assembly, one, other, type="glued")),
            ("at least one", lambda: api.add_contact(self.assembly, one, (self.second, []))),
            ("no vertex 9999", lambda: api.add_contact(self.assembly, one, (self.second, [9999]))),
            ("not in the morph", lambda: api.add_contact(stranger, one, other)),
            ("glued", lambda: api.set_contact_type(self.contact, "glued")),
            ("not a SheetMorph contact", lambda: api.set_active(self.handle, False)),
            ("no side 'c'", lambda: api.contact_vertices(self.contact, "c")),
            ("no vertex -1", lambda: api.set_contact_vertices(self.contact, "a", [-1])),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                call()
        self.assertEqual([obj.Name for obj in self.document.Objects], before)
        self.assertEqual(self.contact.Type, "control mesh")

    def test_every_property_a_designer_sees_is_explained(self):
        for obj in (self.contact, self.part, self.assembly):
            for name in ("Type", "Active", "Kept", "Mode", "Propagation", "Smoothness"):
                if name in obj.PropertiesList:
                    self.assertGreater(len(obj.getDocumentationOfProperty(name)), 40, name)

    def test_the_fidelity_is_shown_and_cannot_be_edited(self):
        api.set_motion(self.handle, (0, 0, 40))
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertIn("ReadOnly", self.contact.getEditorMode("Kept"))
        self.assertRegex(self.contact.Kept, r"^gap [0-9.]+ mm, deviation [0-9.]+ mm$")
        for name in ("GapChange", "Deviation"):  # FreeCAD would show them in nm and µm
            self.assertIn("Hidden", self.contact.getEditorMode(name))
        self.assertGreater(self.contact.Deviation.Value, 0.0)
        self.assertLess(self.contact.GapChange.Value, 1.0)
        api.reset_motion(self.handle)
        self.document.recompute()
        self.assertLess(self.contact.Deviation.Value, 1e-6)

    def test_a_removed_contact_or_part_leaves_nothing_behind(self):
        api.remove(self.second)
        self.assertEqual(objects.contacts(self.assembly), [])
        third = self.add_second(self.assembly)
        contact = api.add_contact(self.assembly, (self.part, [1, 2, 3]), (third, [4, 5, 6]))
        api.remove(contact)
        self.assertEqual(objects.contacts(self.assembly), [])
        self.document.recompute()
        self.assert_up_to_date(self.document)

    def test_a_contact_whose_part_was_deleted_by_hand_is_ignored(self):
        self.document.removeObject(self.second.Name)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertIn("Weld", self.assembly.Status)
        with self.assertRaisesRegex(ValueError, "lost a part"):
            api.set_contact_vertices(self.contact, "b", [1])

    def test_lost_vertices_are_told_with_the_name_of_the_contact(self):
        objects.set_contact_vertices(self.contact, "b", [99999])
        self.document.recompute()
        self.assertRegex(self.assembly.Status, "Contact 'Weld'.*99999")


class TestUndoAndFiles(support.DocumentTest):
    def setUp(self):
        super().setUp()
        self.assembly, self.handle, self.contact = self.add_pair()
        api.set_motion(self.handle, (0, 0, 40))
        self.document.recompute()
        self.second = objects.parts(self.assembly)[1]
        self.shown = support.seen_points(self.second)

    def in_one_step(self, call, *arguments) -> None:
        self.document.openTransaction("step")
        call(*arguments)
        self.document.recompute()
        self.document.commitTransaction()

    def test_every_change_is_undone_and_redone(self):
        for call, arguments in (
            (api.set_active, (self.contact, False)),
            (api.set_contact_type, (self.contact, "rigid")),
            (api.set_contact_vertices, (self.contact, "b", [1, 2, 3, 12])),
            (api.set_mode, (self.second, 3)),
            (api.set_propagation, (self.assembly, "single")),
            (api.set_energy, (self.assembly, "paper")),
        ):
            with self.subTest(call.__name__):
                self.in_one_step(call, *arguments)
                changed = support.seen_points(self.second)
                self.assertGreater(support.largest(changed - self.shown), 1e-4)
                self.document.undo()
                np.testing.assert_array_equal(support.seen_points(self.second), self.shown)
                self.document.redo()
                np.testing.assert_array_equal(support.seen_points(self.second), changed)
                self.document.undo()
                self.document.recompute()
                np.testing.assert_array_equal(support.seen_points(self.second), self.shown)

    def test_a_removed_contact_comes_back_with_undo(self):
        self.in_one_step(api.remove, self.contact)
        self.assertEqual(list(self.assembly.Unreached), ["Second"])
        self.document.undo()
        self.document.recompute()
        self.assertEqual(len(objects.contacts(self.assembly)), 1)
        self.assertEqual(list(self.assembly.Unreached), [])
        np.testing.assert_array_equal(support.seen_points(self.second), self.shown)

    def test_a_document_reopens_with_contacts_modes_and_propagation(self):
        api.set_contact_type(self.contact, "tied")
        api.set_mode(self.second, 2)
        api.set_propagation(self.assembly, "local", levels=2, smoothness=0.1)
        other = api.add_contact(
            self.assembly, (self.assembly.Primary, [4]), (self.second, [5]), label="Open weld"
        )
        api.set_active(other, False)
        self.document.recompute()
        shown = support.seen_points(self.second)
        gap = self.contact.GapChange.Value
        document = self.reopen(self.document)
        assembly = document.getObjectsByLabel("Morph")[0]
        contact, other = objects.contacts(assembly)
        self.assertEqual((contact.Type, other.Active), ("tied", False))
        self.assertAlmostEqual(contact.GapChange.Value, gap)
        self.assertEqual(api.contact_vertices(other, "b"), [5])
        second = objects.parts(assembly)[1]
        self.assertEqual(second.Mode, "2 regions")
        self.assertEqual((assembly.Levels, assembly.Smoothness), (2, 0.1))
        for obj in document.Objects:
            obj.touch()
        document.recompute()
        self.assert_up_to_date(document)
        np.testing.assert_array_equal(support.seen_points(second), shown)

    def test_a_copy_has_contacts_of_its_own(self):
        assembly = self.document.copyObject(self.assembly, True)
        (contact,) = objects.contacts(assembly)
        self.assertNotEqual(contact, self.contact)
        self.assertEqual([contact.PartA, contact.PartB], objects.parts(assembly))
        api.set_active(contact, False)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        np.testing.assert_array_equal(support.seen_points(self.second), self.shown)
        self.assertEqual(len(assembly.Unreached), 1)

    def test_a_document_from_before_contacts_gets_what_it_lacks(self):
        api.remove(self.contact)
        for obj, names in (
            (self.assembly, ("Propagation", "Levels", "Smoothness", "Order", "Unreached")),
            (self.second, ("Mode",)),
            (objects.deformation_of(self.assembly), ("Contacts",)),
        ):
            for name in names:
                obj.removeProperty(name)
        document = self.reopen(self.document)
        assembly = document.getObjectsByLabel("Morph")[0]
        part, second = objects.parts(assembly)
        self.assertEqual((second.Mode, assembly.Propagation), ("automatic", "local"))
        self.assertEqual((assembly.Levels, assembly.Smoothness), (3, 0.05))
        touching = zip((part, second), api.touching_vertices(part, second, 1.5))
        contact = api.add_contact(assembly, *touching)
        document.recompute()
        self.assert_up_to_date(document)
        self.assertGreater(len(api.contact_vertices(contact, "a")), 40)
        self.assertEqual(list(assembly.Unreached), [])


if __name__ == "__main__":
    unittest.main()
