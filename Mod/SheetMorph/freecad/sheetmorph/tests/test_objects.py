# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies, parts and regions behave like any other document objects."""

import gc
import unittest

import FreeCAD

from freecad.sheetmorph import api, objects
from freecad.sheetmorph.bridge import recipes, solving, units
from freecad.sheetmorph.objects import model
from freecad.sheetmorph.objects.assembly import together
from freecad.sheetmorph.objects.migrations import VERSION
from freecad.sheetmorph.objects.region import FEATURE, MOTION, motion_of
from freecad.sheetmorph.tests import support

HIDDEN = "Hidden"


class TestCreation(support.DocumentTest):
    def test_an_empty_assembly_says_what_to_do(self):
        assembly = api.create_assembly(self.document, "Mirror")
        self.document.recompute()
        self.assertEqual(assembly.Label, "Mirror")
        self.assertEqual(assembly.Energy, "neumann")
        self.assertEqual(assembly.Status, "Add a part.")
        self.assertEqual(objects.parts(assembly), [])

    def test_a_new_part_shows_its_source_at_rest_and_hides_it(self):
        source = self.add_source()
        assembly = api.create_assembly(self.document)
        part = api.add_part(assembly, source)
        self.assertEqual(part.Label, "Sheet morphed")
        self.assertEqual(assembly.Primary, part)
        self.assertFalse(source.Visibility)
        self.assertEqual(
            support.largest(support.seen_points(part) - support.seen_points(source)), 0
        )
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(
            support.largest(support.seen_points(part) - support.seen_points(source)), 0
        )
        self.assertIn("At rest", assembly.Status)

    def test_kinds_and_owners_are_known(self):
        assembly, part, handle = self.add_morph()
        self.assertEqual(model.kind(assembly), model.ASSEMBLY)
        self.assertEqual(model.kind(part), model.PART)
        self.assertEqual(model.kind(handle), model.REGION)
        self.assertEqual(model.kind(part.Source), "")
        for obj in assembly.Group:
            self.assertEqual(objects.assembly_of(obj), assembly)
        self.assertEqual([r.Label for r in objects.regions(assembly, part)], ["Clamp", "Tip"])

    def test_unsuitable_sources_are_refused_and_nothing_is_added(self):
        assembly, part, _ = self.add_morph()
        empty = self.document.addObject("Mesh::Feature", "Empty")
        other = self.add_source(document=self.new_document())
        count = len(self.document.Objects)
        for source, words in (
            (part.Source, "is already in"),
            (part, "is already in"),
            (empty, "no triangles"),
            (assembly, "not a mesh"),
            (None, "not a mesh"),
            (other, "another document"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                api.add_part(assembly, source)
        self.assertEqual(len(self.document.Objects), count)

    def test_only_an_assembly_takes_parts(self):
        source = self.add_source()
        with self.assertRaisesRegex(ValueError, "not a SheetMorph assembly"):
            api.add_part(source, source)


class TestReading(support.DocumentTest):
    """FreeCAD 0.20 never frees a length, an angle, a vector or a unit that is read as an attribute,
    nor the weak reference that it makes to it."""

    def weak_references(self) -> int:
        gc.collect()
        return sum(type(one).__name__ == "ReferenceType" for one in gc.get_objects())

    def test_what_is_read_again_and_again_does_not_stay(self):
        assembly, part, handle = self.add_morph()
        feature = api.add_feature(assembly, part, [0, 1, 2])
        handle.PivotAtCentroid = False
        assembly.Symmetry = True
        reads = {
            "motion of a handle": lambda: motion_of(handle),
            "motion of a form feature": lambda: motion_of(feature),
            "pivot": lambda: api.pivot(handle),
            "recipe": lambda: solving.read_morph(assembly),
            "pose": lambda: recipes.pose_of(assembly),
            "form feature": lambda: recipes.allowed_of(feature),
            "part": lambda: (recipes.sheet_entry(part), recipes.thin_entry(part)),
            "text": lambda: units.number_in("10 in", "mm"),
        }
        for what, read in reads.items():
            with self.subTest(what):
                read()
                before = self.weak_references()
                for _ in range(20):
                    read()
                self.assertLess(self.weak_references() - before, 10)


class TestProperties(support.DocumentTest):
    def test_a_region_shows_the_properties_of_its_role(self):
        _, _, handle = self.add_morph()
        self.assertNotIn(HIDDEN, handle.getEditorMode("TranslationX"))
        self.assertIn(HIDDEN, handle.getEditorMode("RotationAxis"))
        self.assertIn("ReadOnly", handle.getEditorMode("Pivot"))
        handle.Role = "form feature"
        for row in MOTION:
            self.assertIn(HIDDEN, handle.getEditorMode(row.name))
        self.assertNotIn(HIDDEN, handle.getEditorMode("Rotation"))
        handle.Role = "fixed"
        for row in MOTION + FEATURE:
            self.assertIn(HIDDEN, handle.getEditorMode(row.name))

    def test_a_role_changed_in_the_editor_counts(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 10))
        self.document.recompute()
        handle.Role = "fixed"
        self.document.recompute()
        difference = support.seen_points(part) - support.seen_points(part.Source)
        self.assertEqual(support.largest(difference), 0.0)
        handle.Role = "handle"
        self.document.recompute()
        difference = support.seen_points(part) - support.seen_points(part.Source)
        self.assertGreater(support.largest(difference), 9.9)

    def test_missing_properties_come_back_when_a_document_is_opened(self):
        assembly, part, handle = self.add_morph()
        for obj, name in ((assembly, "Energy"), (part, "FileName"), (handle, "Pivot")):
            obj.removeProperty(name)
        names = [assembly.Name, part.Name, handle.Name]
        opened = self.reopen(self.document)
        assembly, part, handle = (opened.getObject(name) for name in names)
        self.assertEqual(assembly.Energy, "neumann")
        self.assertEqual(part.FileName, "")
        self.assertEqual(tuple(handle.Pivot), (0.0, 0.0, 0.0))
        self.assertEqual(handle.SchemaVersion, VERSION)

    def test_the_energy_is_part_of_the_result(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 30), (0, 1, 0), 20)
        self.document.recompute()
        neumann = support.seen_points(part)
        api.set_energy(assembly, "paper")
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertGreater(support.largest(support.seen_points(part) - neumann), 1e-3)
        paper = support.seen_points(part)
        api.set_energy(assembly, "natural")
        self.document.recompute()
        self.assertGreater(support.largest(support.seen_points(part) - paper), 1e-3)
        with self.assertRaisesRegex(ValueError, "wooden.*natural"):
            api.set_energy(assembly, "wooden")

    def test_the_operator_is_part_of_the_result(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 30), (0, 1, 0), 20)
        api.set_operator(assembly, "intrinsic")
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertEqual(assembly.Operator, "intrinsic")
        with self.assertRaisesRegex(ValueError, "tufted.*intrinsic"):
            api.set_operator(assembly, "tufted")

    def test_a_document_of_an_earlier_version_keeps_its_energy_and_gets_the_new_choice(self):
        assembly, _, _ = self.add_morph()
        assembly.Energy = ["neumann", "paper"]
        assembly.Energy = "paper"
        assembly.removeProperty("Operator")
        name = assembly.Name
        assembly = self.reopen(self.document).getObject(name)
        self.assertEqual((assembly.Energy, assembly.Operator), ("paper", "cotangent"))
        api.set_energy(assembly, "natural")
        self.assertEqual(assembly.Energy, "natural")


class TestDeletion(support.DocumentTest):
    def test_a_deleted_region_no_longer_acts(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 10))
        self.document.recompute()
        api.remove(handle)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        difference = support.seen_points(part) - support.seen_points(part.Source)
        self.assertEqual(support.largest(difference), 0.0)

    def test_removing_a_part_takes_its_regions_and_shows_its_source(self):
        assembly, part, _ = self.add_morph()
        source = part.Source
        other = api.add_part(assembly, self.add_source("Other"), "Second")
        api.remove(part)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertTrue(source.Visibility)
        self.assertEqual(objects.regions(assembly), [])
        self.assertEqual(assembly.Primary, other)

    def test_regions_whose_part_was_deleted_by_hand_are_ignored_and_named(self):
        assembly, part, _ = self.add_morph()
        second = self.add_source("Other")
        other = api.add_part(assembly, second, "Second")
        api.add_fixed(assembly, other, [0, 1, 2], "Hold")
        self.document.removeObject(part.Name)
        self.document.recompute()
        self.assert_up_to_date(self.document)
        self.assertIn("Clamp, Tip", assembly.Status)

    def test_a_deleted_source_is_named_and_the_mesh_stays(self):
        assembly, part, handle = self.add_morph()
        api.set_motion(handle, (0, 0, 10))
        self.document.recompute()
        before = support.local_points(part)
        self.document.removeObject(part.Source.Name)
        self.document.recompute()
        self.assertIn("Part 'Strip' has lost its source mesh", model.failure_of(assembly))
        self.assertEqual(support.largest(support.local_points(part) - before), 0.0)

    def test_removing_an_assembly_leaves_the_sources_alone(self):
        assembly, part, _ = self.add_morph()
        source = part.Source
        api.remove(assembly)
        self.assertEqual([obj.Name for obj in self.document.Objects], [source.Name])
        self.assertTrue(source.Visibility)
        with self.assertRaisesRegex(ValueError, "not an assembly, part, region or contact"):
            api.remove(source)

    def test_a_group_deleted_by_hand_leaves_parts_that_say_so(self):
        assembly, part, _ = self.add_morph()
        self.document.removeObject(assembly.Name)
        part.touch()
        self.document.recompute()
        self.assertIn("morph of this part was deleted", part.Deformation.getStatusString())
        for obj in [obj for obj in self.document.Objects if model.kind(obj) == model.REGION]:
            api.remove(obj)
        api.remove(part)
        self.assertEqual([obj.Label for obj in self.document.Objects], ["Sheet"])

    def test_a_source_in_two_morphs_stays_hidden_until_both_are_gone(self):
        first, part, _ = self.add_morph()
        source = part.Source
        second, _, _ = self.add_morph(source)
        api.remove(first)
        self.assertFalse(source.Visibility)
        api.remove(second)
        self.assertTrue(source.Visibility)

    def test_a_mesh_that_depends_on_a_morph_is_refused_as_its_source(self):
        assembly, part, _ = self.add_morph()
        other, further, _ = self.add_morph(part)
        with self.assertRaisesRegex(ValueError, "depends on the morph"):
            api.add_part(assembly, further)

    def test_a_part_dragged_out_of_its_group_says_so(self):
        assembly, part, _ = self.add_morph()
        self.document.recompute()
        assembly.removeObject(part)
        part.touch()
        self.document.recompute()
        self.assertIn("Part 'Strip'", part.getStatusString())
        assembly.addObject(part)
        self.document.recompute()
        self.assert_up_to_date(self.document)


class Follower:
    """Document observer that counts how often a deformation gets other links, by their name."""

    def __init__(self, deformation):
        self.deformation, self.counts = deformation.Name, {}

    def slotChangedObject(self, obj, name: str) -> None:
        if obj.Name == self.deformation and name in ("Sources", "Regions", "Contacts"):
            self.counts[name] = self.counts.get(name, 0) + 1


class TestTogether(support.DocumentTest):
    """What comes in many at a time is followed once, whatever goes wrong."""

    def setUp(self) -> None:
        super().setUp()
        self.assembly, self.handle, self.contact = self.add_pair()
        self.follower = Follower(objects.deformation_of(self.assembly))
        FreeCAD.addDocumentObserver(self.follower)
        self.addCleanup(FreeCAD.removeDocumentObserver, self.follower)

    def assert_followed(self) -> None:
        """Fail unless the deformation depends on what is in the group."""
        deformation = objects.deformation_of(self.assembly)
        self.assertEqual(deformation.Regions, objects.regions(self.assembly))
        self.assertEqual(deformation.Contacts, objects.contacts(self.assembly))

    def test_features_and_contacts_that_were_found(self):
        holes = api.find_features(self.assembly, kinds=None)
        self.assertGreater(len(api.add_found_features(self.assembly, holes)), 4)
        self.assertEqual(self.follower.counts, {"Regions": 1})
        api.remove(self.contact)
        self.follower.counts.clear()
        added = api.add_found_contacts(self.assembly, api.find_contacts(self.assembly))
        self.assertEqual((len(added), self.follower.counts), (1, {"Contacts": 1}))
        self.assert_followed()

    def test_an_error_midway_leaves_what_was_there(self):
        part = objects.parts(self.assembly)[0]
        with self.assertRaises(ValueError), together():
            api.add_follower(self.assembly, part, [70])
            with together():
                api.add_follower(self.assembly, part, [71])
            self.assertEqual(self.follower.counts, {})
            api.add_follower(self.assembly, part, [])
        self.assertEqual(self.follower.counts, {"Regions": 1})
        self.assert_followed()

    def test_a_morph_that_is_gone_at_the_end_is_followed_by_nothing(self):
        with together():
            api.remove(self.handle)
            api.remove(self.assembly)
            other = api.create_assembly(self.new_document())
            api.add_part(other, self.add_source(document=other.Document))
            FreeCAD.closeDocument(self.documents.pop())
        self.assertEqual([o.Name for o in self.document.Objects if model.kind(o)], [])


if __name__ == "__main__":
    unittest.main()
